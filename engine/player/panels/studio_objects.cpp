// The things of the scene: which there are, which one works on, what is hidden, and new ones.
#include <algorithm>

#include "algorithms/typeset.hpp"
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"
#include "player/ui/studio_fields.hpp"

namespace blossom {
namespace {

// "cubic NURBS, 7 points"; of a made thing also how.
std::string detail_of(const SceneObject& object) {
  std::string text;
  if (const auto* curve = std::get_if<Curve<Exact>>(&object.geometry))
    text = "degree " + std::to_string(curve->degree) + ", " + std::to_string(curve->points.size()) + " points";
  if (const auto* surface = std::get_if<Surface<Exact>>(&object.geometry))
    text = std::to_string(surface->rows) + " \u00d7 " + std::to_string(surface->columns) + " net";
  if (const auto* row = std::get_if<PointRow<Exact>>(&object.geometry))
    text = std::to_string(row->points.size()) + (row->points.size() == 1 ? " point" : " points");
  if (const auto* net = std::get_if<PointNet<Exact>>(&object.geometry))
    text = std::to_string(net->rows) + " \u00d7 " + std::to_string(net->columns) + " points";
  if (object.recipe) text += ", " + std::string(object.recipe->algorithm->title);
  return text;
}

// An eye, open or shut.
bool eye(Ui& ui, const SceneObject& object, float side) {
  const bool pressed = ImGui::InvisibleButton("eye", {side, side});
  ui.thing("objects show " + object.name);
  const ImVec2 low = ImGui::GetItemRectMin();
  const ImVec2 c{low.x + side / 2, low.y + side / 2};
  const float r = side * 0.3f;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const bool lit = ImGui::IsItemHovered() || (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible);
  const ImU32 ink = ui.ink(object.hidden && !lit ? Role::text_quiet : Role::text);
  list.PathArcTo({c.x, c.y + r * 0.75f}, r * 1.25f, 3.79f, 5.63f, 12);
  list.PathArcTo({c.x, c.y - r * 0.75f}, r * 1.25f, 0.65f, 2.49f, 12);
  list.PathStroke(ink, ImDrawFlags_Closed, ui.px(1.4));
  if (object.hidden)
    list.AddLine({c.x - r, c.y + r}, {c.x + r, c.y - r}, ink, ui.px(1.6));
  else
    list.AddCircleFilled(c, r * 0.4f, ink);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip(object.hidden ? "Hidden: show it   H" : "Shown: hide it   H");
  return pressed;
}

struct Renaming {
  std::size_t object = SIZE_MAX;
  std::string text;
  bool begun = false;
};
Renaming& renaming() {
  static Renaming state;
  return state;
}

void draw_name_field(Ui& ui, std::size_t i, float width) {
  Renaming& state = renaming();
  std::array<char, 256> buffer{};
  state.text.copy(buffer.data(), buffer.size() - 1);
  ImGui::SetNextItemWidth(width);
  if (!state.begun) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputText("##rename", buffer.data(), buffer.size(),
                                        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ui.thing("objects rename");
  state.text = buffer.data();
  const bool escaped = ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false);
  if (entered || (state.begun && ImGui::IsItemDeactivated() && !escaped))
    send_studio(ui, [i, name = state.text](Studio& studio) {
      if (i < studio.workspace().objects.size() && studio.workspace().objects[i].name != name)
        studio.edit(edit::rename(studio.workspace(), i, name), "name " + name);
    });
  if (entered || (state.begun && ImGui::IsItemDeactivated())) state = {};
  if (state.object == i) state.begun = true;
}

void draw_row(Ui& ui, const Studio& studio, std::size_t i) {
  const SceneObject& object = studio.workspace().objects[i];
  const bool current = studio.current() == i;
  const bool chosen = std::ranges::find(studio.chosen(), i) != studio.chosen().end();
  ImGui::PushID(static_cast<int>(i));
  const float side = ImGui::GetFrameHeight();
  if (eye(ui, object, side))
    send_studio(ui, [i, hidden = !object.hidden](Studio& s) {
      if (i < s.workspace().objects.size())
        s.edit(edit::set_hidden(s.workspace(), {i}, hidden), hidden ? "hide" : "show");
    });
  ImGui::SameLine(0, ui.px(2));
  color_chip(ui, object.color, ui.px(12));
  ImGui::SameLine(0, ui.px(6));
  if (renaming().object == i) {
    draw_name_field(ui, i, ImGui::GetContentRegionAvail().x);
    ImGui::PopID();
    return;
  }
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  if (ImGui::Selectable("##row", chosen, ImGuiSelectableFlags_AllowDoubleClick, {room, side})) {
    if (ImGui::IsMouseDoubleClicked(0))
      renaming() = {i, object.name, false};
    else
      send_studio(ui, [i, also = ImGui::GetIO().KeyShift || ImGui::GetIO().KeyCtrl](Studio& s) { s.choose(i, also); });
  }
  ui.thing("objects " + object.name);
  if (current) {  // the list follows what is made current elsewhere
    static std::string followed;
    const std::string now = studio.title() + "/" + object.name;
    if (followed != now && !ImGui::IsItemVisible()) ImGui::SetScrollHereY();
    followed = now;
  }
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float y = at.y + (side - ImGui::GetTextLineHeight()) / 2;
  if (current) list.AddRectFilled({at.x - ui.px(3), at.y}, {at.x - ui.px(1), at.y + side}, ui.color(Role::current));
  ImFont* font = current ? ui.bold() : ui.regular();
  ImGui::PushFont(font);
  const std::string name = shortened(object.name, room * 0.6f);
  const float name_width = ImGui::CalcTextSize(name.c_str()).x;
  list.AddText({at.x + ui.px(2), y}, ui.ink(object.hidden ? Role::text_quiet : Role::text), name.c_str());
  ImGui::PopFont();
  ImGui::PushFont(ui.small());
  const std::string detail = shortened(detail_of(object), room - name_width - ui.px(16));
  const float width = ImGui::CalcTextSize(detail.c_str()).x;
  list.AddText({at.x + room - width - ui.px(4), at.y + (side - ImGui::GetTextLineHeight()) / 2},
               ui.ink(object.problem.empty() ? Role::text_quiet : Role::mistake),
               object.problem.empty() ? detail.c_str() : "cannot be made");
  ImGui::PopFont();
  if (hovered)
    ImGui::SetTooltip("%s\n%s%s%s", object.name.c_str(), detail_of(object).c_str(), object.problem.empty() ? "" : "\n",
                      object.problem.c_str());
  ImGui::PopID();
}

// What a new thing is.
void draw_new(Ui& ui) {
  if (ui.button("+ New", "objects new", true, "A new curve or surface")) ImGui::OpenPopup("new thing");
  if (!ImGui::BeginPopup("new thing")) return;
  const auto item = [&](const char* title, const std::string& name, auto what) {
    if (ImGui::MenuItem(title)) send_studio(ui, what);
    ui.thing("objects new " + name);
  };
  const auto drawn = [](CurveKind kind, CurveForm form) {
    return [=](Studio& studio) {
      studio.finish_drawing();
      studio.choose(std::nullopt);
      studio.new_kind = kind;
      studio.new_form = form;
      studio.set_tool(Tool::draw);
    };
  };
  ImGui::TextDisabled("Curves, by clicking their points");
  item("B\u00e9zier curve", "bezier", drawn(CurveKind::bezier, CurveForm::clamped));
  item("Rational B\u00e9zier curve", "rational-bezier", drawn(CurveKind::rational_bezier, CurveForm::clamped));
  item("B-spline curve, clamped", "bspline", drawn(CurveKind::bspline, CurveForm::clamped));
  item("B-spline curve, open", "bspline-open", drawn(CurveKind::bspline, CurveForm::open));
  item("B-spline curve, closed", "bspline-closed", drawn(CurveKind::bspline, CurveForm::closed));
  item("NURBS curve", "nurbs", drawn(CurveKind::nurbs, CurveForm::clamped));
  ImGui::Separator();
  ImGui::TextDisabled("Surfaces, from a flat net");
  const auto flat = [](CurveKind kind) {
    return [=](Studio& studio) {
      const int n = kind == CurveKind::bezier || kind == CurveKind::rational_bezier ? 4 : 5;
      studio.add_surface(kind, n, n, 3, 3);
    };
  };
  item("B\u00e9zier surface", "bezier-surface", flat(CurveKind::bezier));
  item("Rational B\u00e9zier surface", "rational-bezier-surface", flat(CurveKind::rational_bezier));
  item("B-spline surface", "bspline-surface", flat(CurveKind::bspline));
  item("NURBS surface", "nurbs-surface", flat(CurveKind::nurbs));
  ImGui::EndPopup();
}

void draw(Ui& ui) {
  const Studio& studio = *ui.player().studio();
  draw_new(ui);
  ImGui::SameLine();
  const bool any = studio.current().has_value();
  if (ui.button("Duplicate", "objects duplicate", any, "Ctrl+D")) send_studio(ui, [](Studio& s) { s.duplicate(); });
  ImGui::SameLine();
  if (ui.button("Delete", "objects delete", any, "Delete"))
    send_studio(ui, [](Studio& s) {
      s.select({});
      s.remove();
    });
  ImGui::SameLine();
  const auto move = [&](const char* label, const char* name, int by, const char* tooltip) {
    const std::size_t count = studio.workspace().objects.size();
    const bool can = any && (by < 0 ? *studio.current() > 0 : *studio.current() + 1 < count);
    if (ui.button(label, name, can, tooltip))
      send_studio(ui, [by](Studio& s) {
        if (!s.current()) return;
        const std::size_t to = *s.current() + static_cast<std::size_t>(by);
        if (s.edit(edit::move_to(s.workspace(), *s.current(), to), "order")) s.choose(to);
      });
  };
  move("\u2191", "objects up", -1, "Earlier: before what it does not need");
  ImGui::SameLine(0, ui.px(2));
  move("\u2193", "objects down", 1, "Later");
  ImGui::BeginChild("objects list", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  if (studio.workspace().objects.empty()) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextDisabled("Nothing yet. \u201c+ New\u201d begins a curve: click its points in the picture.");
    ImGui::PopTextWrapPos();
  }
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, ui.px(1)});
  for (std::size_t i = 0; i < studio.workspace().objects.size(); ++i) draw_row(ui, studio, i);
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

double wanted(const Ui& ui, double) {
  const auto rows = static_cast<double>(ui.player().studio()->workspace().objects.size());
  return 56 + 26 * std::clamp(rows, 2.0, 9.0);
}

}  // namespace

const Panel& panel_studio_objects() {
  static const Panel panel{"objects", "Things", Slot::side, 0, draw, nullptr, wanted, 110, true, true};
  return panel;
}

}  // namespace blossom
