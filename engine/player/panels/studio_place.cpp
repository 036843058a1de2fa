// Moving, turning and scaling by numbers: what is chosen, or the instances that a made thing is made from.
#include <algorithm>

#include "player/ui/panel.hpp"
#include "player/ui/studio_fields.hpp"

namespace blossom {
namespace {

const StudioModel model("place");

// What is typed until it is applied.
struct Pending {
  Placement place;
  bool about_origin = false;
};
Pending& pending() {
  static Pending state;
  return state;
}

constexpr std::array<const char*, 3> axes = {"x", "y", "z"};

// Both tables stand below each other, so their columns do as well.
struct Columns {
  float left = 0, width = 0, step = 0;
};

Columns columns_for(const Ui& ui, float room) {
  Columns columns;
  columns.left = ImGui::GetCursorPosX() +
                 std::max(ImGui::CalcTextSize("Scale by").x, ImGui::CalcTextSize("Turn by \u00b0").x) + ui.px(12);
  columns.width = std::clamp((room - columns.left) / 3 - ui.px(4), ui.px(44), ui.px(90));
  columns.step = columns.width + ui.px(4);
  return columns;
}

// The names of the axes above their columns, on the line of what was written last.
void draw_axes(const Ui& ui, const Columns& columns) {
  ImGui::PushStyleColor(ImGuiCol_Text, ui.ink(Role::text_quiet));
  for (int axis = 0; axis < 3; ++axis) {
    ImGui::SameLine(columns.left + static_cast<float>(axis) * columns.step + ImGui::GetStyle().FramePadding.x, 0);
    ImGui::TextUnformatted(axes[static_cast<std::size_t>(axis)]);
  }
  ImGui::PopStyleColor();
}

// A row of three number fields that are only kept here.
void draw_pending(Ui& ui, const char* label, const std::string& name, Point<Exact>& value, const Columns& columns) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(label);
  for (int axis = 0; axis < 3; ++axis) {
    ImGui::SameLine(columns.left + static_cast<float>(axis) * columns.step, 0);
    std::array<char, 128> buffer{};
    number_text(value[axis], NumberStyle::coordinate).copy(buffer.data(), buffer.size() - 1);
    ImGui::SetNextItemWidth(columns.width);
    ImGui::PushID((name + axes[static_cast<std::size_t>(axis)]).c_str());
    ImGui::InputText("##field", buffer.data(), buffer.size(), ImGuiInputTextFlags_AutoSelectAll);
    const std::string thing = "place " + name + " " + axes[static_cast<std::size_t>(axis)];
    ui.thing(thing);
    if (ImGui::IsItemDeactivatedAfterEdit())
      if (const auto x = typed_number(buffer.data())) value[axis] = *x;
    ImGui::PopID();
  }
}

bool apply(Studio& studio, const Placement& place, bool about_origin) {
  const Point<Exact> origin{Exact(0), Exact(0), Exact(0)};
  const Point<Exact> centre = about_origin ? origin : studio.centre().value_or(origin);
  const Workspace& scene = studio.workspace();
  return studio.edit(studio.selected().empty() ? edit::place(scene, studio.chosen(), place, centre)
                                               : edit::place(scene, studio.selected(), place, centre),
                     "placed");
}

void draw_chosen(Ui& ui, const Studio& studio, float room) {
  Pending& state = pending();
  const std::size_t points = studio.selected().size();
  ui.heading(points > 0 ? (std::to_string(points) + (points == 1 ? " point" : " points")).c_str()
                        : (studio.chosen().size() > 1 ? (std::to_string(studio.chosen().size()) + " things").c_str()
                                                      : studio.object()->name.c_str()));
  const Columns columns = columns_for(ui, room);
  ImGui::NewLine();
  draw_axes(ui, columns);
  draw_pending(ui, "Move by", "move", state.place.move, columns);
  draw_pending(ui, "Turn by \u00b0", "turn", state.place.turn, columns);
  draw_pending(ui, "Scale by", "scale", state.place.scale, columns);
  ImGui::Checkbox("About the origin, not its middle", &state.about_origin);
  ui.thing("place about-origin");
  if (ui.button("Apply", "place apply", !state.place.is_identity()))
    send_studio(ui, [place = state.place, origin = state.about_origin](Studio& s) { apply(s, place, origin); });
  ImGui::SameLine();
  if (ui.button("Reset", "place reset")) state.place = {};
  ImGui::SameLine();
  const auto quarter = [&](const char* label, int axis) {
    if (ui.button(label, std::string("place quarter ") + axes[static_cast<std::size_t>(axis)], true,
                  "A quarter turn about this axis"))
      send_studio(ui, [axis, origin = state.about_origin](Studio& s) {
        Placement place;
        place.turn[axis] = Exact(90);
        apply(s, place, origin);
      });
    ImGui::SameLine();
  };
  quarter("90\u00b0 x", 0);
  quarter("y", 1);
  quarter("z", 2);
  ImGui::NewLine();
  bool smooth = studio.keep_smooth;
  if (ImGui::Checkbox("Keep shared borders smooth (C1)", &smooth)) ui.act("studio.smooth");
  ui.thing("place smooth");
  if (ImGui::IsItemHovered())
    ImGui::SetTooltip(
        "Where two curves or surfaces meet with one tangent, such as the parts of one that was cut,\n"
        "they go on doing so while a point of either is moved   K");
}

// One instance of what the current thing is made from.
void draw_instance(Ui& ui, StudioFields& fields, std::size_t object, const std::string& input, std::size_t which,
                   const Reference& reference, float room) {
  const std::string path = "objects[" + std::to_string(object) + "].made." + input + "[" + std::to_string(which) + "]";
  ImGui::PushID(path.c_str());
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted((std::to_string(which + 1) + ".  " + reference.object).c_str());
  const Columns columns = columns_for(ui, room);
  const auto row = [&](const char* label, const char* title, Point<Exact> Placement::*part) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", title);
    for (int axis = 0; axis < 3; ++axis) {
      ImGui::SameLine(columns.left + static_cast<float>(axis) * columns.step, 0);
      const std::string name = std::to_string(which + 1) + " " + label + " " + axes[static_cast<std::size_t>(axis)];
      fields.number({path + "." + label + "[" + std::to_string(axis) + "]", name, (reference.place.*part)[axis],
                     NumberStyle::coordinate, columns.width},
                    [=](const Workspace& w, const Exact& x) -> Worked {
                      const auto* recipe =
                          object < w.objects.size() && w.objects[object].recipe ? &*w.objects[object].recipe : nullptr;
                      if (recipe == nullptr) return Diagnostics{{"", 0, 0, path, "is not made any more"}};
                      const auto found = recipe->inputs.find(input);
                      const auto* all =
                          found != recipe->inputs.end() ? std::get_if<std::vector<Reference>>(&found->second) : nullptr;
                      if (all == nullptr || which >= all->size())
                        return Diagnostics{{"", 0, 0, path, "is not there any more"}};
                      Placement place = (*all)[which].place;
                      (place.*part)[axis] = x;
                      return edit::place_instance(w, object, input, which, place);
                    });
    }
    fields.say();
  };
  row("move", "Move by", &Placement::move);
  row("turn", "Turn by \u00b0", &Placement::turn);
  row("scale", "Scale by", &Placement::scale);
  ImGui::PopID();
}

void draw(Ui& ui) {
  const Studio& studio = *ui.player().studio();
  if (studio.object() == nullptr) return ImGui::TextDisabled("Choose what is to be moved, turned or scaled.");
  ImGui::BeginChild("place form", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  const float room = ImGui::GetContentRegionAvail().x;
  draw_chosen(ui, studio, room);
  if (const auto& recipe = studio.object()->recipe) {
    StudioFields fields(ui, model);
    fields.set_wrap(room);
    for (const auto& [input, ingredient] : recipe->inputs)
      if (const auto* references = std::get_if<std::vector<Reference>>(&ingredient)) {
        ImGui::Dummy({0, ui.px(4)});
        std::string title = input;
        std::ranges::replace(title, '_', ' ');
        ui.heading(("Placed as " + title).c_str());
        for (std::size_t i = 0; i < references->size(); ++i)
          draw_instance(ui, fields, *studio.current(), input, i, (*references)[i], room);
      }
  }
  ImGui::EndChild();
}

}  // namespace

const Panel& panel_studio_place() {
  static const Panel panel{"place", "Place", Slot::tabs, 30, draw, nullptr, nullptr, 0, true, true};
  return panel;
}

}  // namespace blossom
