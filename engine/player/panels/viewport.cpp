// The picture: looked at by dragging and turning the wheel, edited by dragging control points, clicked to predict.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "algorithms/typeset.hpp"
#include "player/panels/mouse.hpp"
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"
#include "scene/beat_look.hpp"

namespace blossom {
namespace {

constexpr double margin = 8;           // of what stands in the corners
constexpr double wheel_factor = 1.15;  // a notch

// ---- what one predicts ----------------------------------------------------------------------------------------------

void add_guess(View& view, const glm::dvec3& at, Role role, RichText words) {
  view.markers.push_back({at, role, Marker::Shape::ring, 1.3});
  view.markers.push_back({at, role, Marker::Shape::cross, 1});
  Label label;
  label.anchor = at;
  label.text = std::move(words);
  label.role = role;
  label.placement = Label::Placement::around;
  label.priority = 60;
  view.labels.push_back(std::move(label));
}

// What is typed or clicked as the answer to a lesson's question.
void add_reply(View& view, const Player& player) {
  if (!player.checkpoint_asks_place()) return;
  const auto& reply = player.checkpoints().reply();
  if (reply.numbers.size() < reply.size || reply.size > 3) return;
  glm::dvec3 place{0, 0, 0};
  for (std::size_t i = 0; i < reply.size; ++i) {
    const auto number = typed_number(reply.numbers[i]);
    if (!number || !std::isfinite(number->to_double())) return;
    place[static_cast<int>(i)] = number->to_double();
  }
  add_guess(view, place, Role::highlight, {{"?"}});
}

void add_guesses(View& view, const Player& player) {
  const Session& session = *player.session();
  add_reply(view, player);
  const Prediction* prediction = session.prediction();
  if (prediction == nullptr) return;
  if (player.asks_place()) {
    const auto question = player.asked();
    if (const auto at = player.said_place(*question)) {
      const AskedValue& asks = prediction->questions()[*question];
      const Algorithm& algorithm = session.recording().source().algorithm_at(asks.step);
      const std::string name = session.recording().source().own_name(asks.value);
      add_guess(view, *at, Role::highlight, typeset_text(name + " ?", algorithm));
    }
  }
  if (prediction->veiled(session.step())) return;
  for (std::size_t q = 0; q < prediction->questions().size(); ++q) {
    const AskedValue& question = prediction->questions()[q];
    if (question.step != session.step()) continue;
    const auto at = player.said_place(q);
    const auto mark = prediction->mark(q);
    if (!at || !mark) continue;
    const bool right = mark->verdict == Verdict::correct || mark->verdict == Verdict::carried;
    const auto& place = session.recording().source().points[question.value];
    if (!right && place) {
      Polyline line;
      line.points = {*at, *place};
      line.role = Role::mistake;
      line.dashed = true;
      view.polylines.push_back(std::move(line));
    }
    add_guess(view, *at, right ? Role::right : Role::mistake, {{right ? "✓" : "✗"}});
  }
}

// Where a click means in the world: in the plane through the operands that faces the view.
std::optional<glm::dvec3> clicked_place(const Player& player, ViewSize size, glm::dvec2 at) {
  const Session& session = *player.session();
  const StepSource& source = session.recording().source();
  const AskedValue& question = session.prediction()->questions()[*player.asked()];
  glm::dvec3 sum{0, 0, 0};
  double count = 0;
  for (const ValueId v : source.graph->operands(question.value))
    if (source.points[v]) sum += *source.points[v], count += 1;
  return to_world(player.shown_camera(), size, at, count > 0 ? sum / count : player.shown_camera().centre);
}

// Likewise for what a lesson asks.
std::optional<glm::dvec3> asked_place(const Player& player, ViewSize size, glm::dvec2 at) {
  const StepSource& source = player.session()->recording().source();
  const auto value = source.graph->find(player.checkpoints().item(*player.checkpoint()).checkpoint.value);
  glm::dvec3 sum{0, 0, 0};
  double count = 0;
  if (value)
    for (const ValueId v : source.graph->operands(*value))
      if (source.points[v]) sum += *source.points[v], count += 1;
  return to_world(player.shown_camera(), size, at, count > 0 ? sum / count : player.shown_camera().centre);
}

// ---- looking and dragging -------------------------------------------------------------------------------------------

// The line along which a point is held.
void add_axis_of_drag(View& view, const Player& player) {
  const auto* grip = player.held() != nullptr ? std::get_if<PointGrip>(player.held()) : nullptr;
  if (grip == nullptr || !player.held_keys().along) return;
  const auto axis = grip->axis(player.held_at());
  const Session& session = *player.session();
  const auto v = value_of(session.recording().graph(), session.inputs(), grip->address());
  const auto at = v ? session.recording().source().points[*v] : std::nullopt;
  if (!axis || !at) return;
  Polyline line;
  glm::dvec3 reach{0, 0, 0};
  reach[*axis] = view.camera.height;
  line.points = {*at - reach, *at, *at + reach};
  line.role = Role::highlight;
  line.width_scale = 0.6;
  line.dashed = true;
  view.polylines.push_back(std::move(line));
}

bool holds_parameter(const Player& player) {  // which is not of this panel
  return player.held() != nullptr &&
         (std::holds_alternative<KnotGrip>(*player.held()) || std::holds_alternative<ParameterGrip>(*player.held()));
}

void handle_mouse(Ui& ui, const Mouse& mouse, const std::vector<Spot>& spots) {
  const Player& player = ui.player();
  const Session& session = *player.session();
  const ImGuiIO& io = ImGui::GetIO();
  if (player.holding()) {
    // The button is let go wherever the mouse is then, and whatever it holds.
    if (!ImGui::IsMouseDown(0) && !ImGui::IsMouseDown(2)) {
      ui.send([](Player& p) { p.let_go(); });
      return;
    }
    if (player.held() != nullptr && !holds_parameter(player)) send_drag(ui, mouse.now(), grip_keys(player));
    return;
  }
  const Camera camera = player.shown_camera();
  const bool spatial = camera.kind == Camera::Kind::orbit;
  for (const int button : {0, 2}) {
    if (!mouse.owns(button) || !mouse.dragged(button)) continue;
    const glm::dvec2 at = mouse.pressed(button);
    const Spot* spot = button == 0 ? spot_at(spots, at) : nullptr;
    Grip grip = LookGrip{camera, mouse.size, at, spatial && button == 0 && !io.KeyShift};
    if (spot != nullptr) grip = grip_of_value(session, spot->link.id, camera, mouse.size, at);
    ui.send([grip, now = mouse.now(), keys = grip_keys(player)](Player& p) {
      if (p.take(grip)) p.drag(now, keys);
    });
    return;
  }
  if (!mouse.over()) return;
  const Spot* spot = spot_at(spots, mouse.now());
  if (io.MouseWheel != 0) {
    const Camera closer = zoomed(camera, mouse.size, mouse.now(), std::pow(wheel_factor, io.MouseWheel));
    ui.send([closer](Player& p) { p.set_camera(closer); });
  }
  if (spot != nullptr && address_of(session.recording().graph(), session.inputs(), spot->link.id))
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (player.checkpoint_asks_place()) {
    if (ImGui::IsMouseReleased(0) && !mouse.dragged(0) && mouse.inside(mouse.pressed(0))) {
      const auto& points = session.recording().source().points;
      const auto place = spot != nullptr && points[spot->link.id] ? points[spot->link.id]
                                                                  : asked_place(player, mouse.size, mouse.now());
      if (place) ui.send([place](Player& p) { p.checkpoint_click(*place); });
    }
  } else if (player.asks_place()) {
    if (ImGui::IsMouseReleased(0) && !mouse.dragged(0) && mouse.inside(mouse.pressed(0))) {
      // On a point one means that point.
      const auto& points = session.recording().source().points;
      const auto place = spot != nullptr && points[spot->link.id] ? points[spot->link.id]
                                                                  : clicked_place(player, mouse.size, mouse.now());
      if (place) ui.send([place](Player& p) { p.predict_click(*place); });
    }
  } else if (spot == nullptr && ImGui::IsMouseDoubleClicked(0)) {
    ui.act("view.fit");
  }
}

// What keys do to what is held.
std::string hint(const Player& player) {
  const GripKeys keys = player.held_keys();
  const bool point = std::holds_alternative<PointGrip>(*player.held());
  std::string words;
  if (point) words += keys.along ? "Along an axis" : "Shift: along an axis";
  if (std::holds_alternative<KnotGrip>(*player.held()))
    words += keys.along ? "All equal knots" : "Shift: all equal knots";
  const std::string where = point ? "on the grid" : "simple fractions";
  words += (words.empty() ? "" : "   ·   ") + (keys.snap ? "snaps: " : std::string("Ctrl: ")) + where;
  return words + "   ·   Esc: put it back";
}

// What is held, in words beside it.
void draw_held(Ui& ui, const Mouse& mouse, ImVec2 low, ImVec2 high) {
  const Player& player = ui.player();
  const Session& session = *player.session();
  if (player.held() == nullptr || std::holds_alternative<LookGrip>(*player.held())) return;
  const StepSource& source = session.recording().source();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto beside = [&](glm::dvec2 at) {
    return ImVec2{mouse.origin.x + ui.px(at.x + 14), mouse.origin.y + ui.px(at.y + 14)};
  };
  if (const auto* stuck = std::get_if<StuckGrip>(player.held())) {  // a notice says why
    if (const auto v = source.graph->find(stuck->name)) ui.light({Link::Kind::value, *v});
    return;
  }
  // In the very corner, where the fitted picture leaves room.
  const ImVec2 corner{mouse.origin.x + ui.px(2), mouse.origin.y + ui.px(mouse.size.height - 2)};
  draw_tag(ui, list, {corner.x, corner.y}, hint(player), Role::text_quiet, {corner.x, low.y}, {high.x, corner.y});
  const auto* point = std::get_if<PointGrip>(player.held());
  if (point == nullptr) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const auto v = value_of(*source.graph, session.inputs(), point->address());
  const auto at =
      v && source.points[*v] ? to_page(player.shown_camera(), mouse.size, *source.points[*v]) : std::nullopt;
  if (!at) return;
  ui.light({Link::Kind::value, *v});
  const bool refused = !session.rejected().empty();
  draw_tag(ui, list, beside(*at),
           refused ? session.rejected()[0].message
                   : plain_name(source.graph->value(*v).name, source.algorithm_at(0)) + " = " + source.value_text(*v),
           refused ? Role::mistake : Role::text, low, high);
}

// ---- corners --------------------------------------------------------------------------------------------------------

struct Tool {
  std::string_view action;
  const char* label;
};
constexpr std::array<Tool, 3> plane_tools = {{{"view.fit", "Fit"}, {"view.grid", "Grid"}, {"edit.snap", "Snap"}}};
constexpr std::array<Tool, 4> space_tools = {
    {{"view.perspective", "Perspective"}, {"view.xy", "xy"}, {"view.xz", "xz"}, {"view.yz", "yz"}}};

constexpr double tools_height = 25;  // of the strip above the picture, where no point can be under them

// From the right; those that do not fit are in the menus. Where they begin.
float draw_tools(Ui& ui, bool spatial, ImVec2 at, float room) {
  std::vector<Tool> tools(plane_tools.begin(), plane_tools.end());
  if (spatial) tools.insert(tools.begin(), space_tools.begin(), space_tools.end());
  const float pad = ui.px(6), gap = ui.px(3);
  const auto width_of = [&](const Tool& tool) { return ImGui::CalcTextSize(tool.label).x + 2 * pad; };
  float width = -gap;
  for (const Tool& tool : tools) width += width_of(tool) + gap;
  while (!tools.empty() && width > room) width -= width_of(tools.front()) + gap, tools.erase(tools.begin());
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {pad, ui.px(2)});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  ImGui::SetCursorScreenPos({at.x + room - width, at.y});
  for (std::size_t i = 0; i < tools.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    ui.action_button(tools[i].action, tools[i].label);
  }
  ImGui::PopStyleVar(2);
  return at.x + room - width;
}

// That one may answer here, in the strip, where it covers nothing.
void draw_question(Ui& ui, ImVec2 at, float right) {
  const Player& player = ui.player();
  std::string words = "Click your answer in the picture.";
  if (player.asks_place()) {
    const Session& session = *player.session();
    const AskedValue& asked = session.prediction()->questions()[*player.asked()];
    const StepSource& source = session.recording().source();
    const std::string name = unicode_text(typeset_text(source.own_name(asked.value), source.algorithm_at(asked.step)));
    words = "Where will " + name + " be? Click there.";
  } else if (!player.checkpoint_asks_place()) {
    return;
  }
  const std::string shown = shortened(words, right - at.x);
  ImGui::GetWindowDrawList()->AddText(at, ui.ink(Role::text_current), shown.c_str());
  const ImVec2 size = ImGui::CalcTextSize(shown.c_str());
  ui.thing("viewport question", at, {at.x + size.x, at.y + size.y});
}

// The three axes as the camera sees them.
void draw_triad(const Ui& ui, const Camera& camera, ImVec2 low, ImVec2 high) {
  const ViewAxes axes = axes_of(camera);
  const float reach = ui.px(24);
  const ImVec2 middle{high.x - reach - ui.px(12), high.y - reach - ui.px(12)};
  if (middle.x < low.x + 2 * reach || middle.y < low.y + 4 * reach) return;
  std::array<int, 3> order = {0, 1, 2};  // what points away is drawn first
  std::ranges::sort(order, {}, [&](int axis) { return axes.toward[axis]; });
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImFont* font = ui.small();
  for (const int axis : order) {
    const glm::dvec2 seen{axes.right[axis], -axes.up[axis]};
    const double length = glm::length(seen);
    const ImVec2 end{middle.x + static_cast<float>(seen.x) * reach, middle.y + static_cast<float>(seen.y) * reach};
    if (length > 0.05) list.AddLine(middle, end, ui.color(Role::text_quiet), ui.px(2));
    const char name[] = {"xyz"[axis], 0};
    const ImVec2 room = font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, name);
    // An axis that runs toward the viewer has its letter beside the middle.
    const glm::dvec2 way = length > 0.05 ? seen / length : glm::dvec2{-1, 1};
    const ImVec2 at{end.x + static_cast<float>(way.x) * ui.px(8), end.y + static_cast<float>(way.y) * ui.px(8)};
    list.AddText(font, font->FontSize, {at.x - room.x / 2, at.y - room.y / 2}, ui.ink(Role::text), name);
  }
}

void draw(Ui& ui) {
  const Player& player = ui.player();
  const Session& session = *player.session();
  ImVec2 room = ImGui::GetContentRegionAvail(), origin = ImGui::GetCursorScreenPos();
  // In a small picture there is no room for them; keys and menus have them all.
  if (ui.units(room.x) >= 240 && ui.units(room.y) >= 180) {
    ImGui::PushFont(ui.small());
    const float tools = draw_tools(ui, player.shown_camera().kind == Camera::Kind::orbit,
                                   {origin.x + ui.px(4), origin.y + ui.px(3)}, room.x - ui.px(8));
    draw_question(ui, {origin.x + ui.px(8), origin.y + ui.px(5)}, tools - ui.px(8));
    ImGui::PopFont();
    const float strip = std::round(ui.px(tools_height));
    origin.y += strip;
    room.y -= strip;
    ImGui::GetWindowDrawList()->AddLine({origin.x, origin.y - 1}, {origin.x + room.x, origin.y - 1},
                                        ui.color(Role::rule_line));
    ImGui::SetCursorScreenPos(origin);
  }
  const ViewSize size{ui.units(room.x), ui.units(room.y)};
  if (size.width < 1 || size.height < 1) return;
  if (size.width != player.view_size().width || size.height != player.view_size().height)
    ui.send([size](Player& p) { p.set_view_size(size); });
  ViewportOptions options;
  options.camera = player.shown_camera();
  options.emphasis = player.emphasis();
  options.motion = player.motion();
  options.hulls = hulls_in_force(session.beats(), session.recording().source(), session.step());
  options.grid = player.settings.grid;
  Sheet sheet = session.recording().scenes().viewport(session.step(), size.width, size.height, options);
  add_guesses(sheet.view, player);
  add_axis_of_drag(sheet.view, player);
  const std::vector<Spot> spots = sheet.spots;

  const ImVec2 low{origin.x + ui.px(margin), origin.y + ui.px(margin)};
  const ImVec2 high{origin.x + room.x - ui.px(margin), origin.y + room.y - ui.px(margin)};
  const bool asks = player.asks_place() || player.checkpoint_asks_place();
  const Spot* found = ui.sheet("viewport", std::move(sheet), size.width, size.height, {.clickable = !asks});
  if (asks && found != nullptr && ImGui::IsMouseClicked(1)) ui.open_menu(found->link);

  if (size.width >= 300 && size.height >= 200 && options.camera->kind == Camera::Kind::orbit)
    draw_triad(ui, *options.camera, low, high);

  const Mouse mouse{ui, origin, size};
  handle_mouse(ui, mouse, spots);
  draw_held(ui, mouse, low, high);
}

}  // namespace

const Panel& panel_viewport() {
  static const Panel panel{"viewport", "Picture", Slot::main, 0, draw};
  return panel;
}

}  // namespace blossom
