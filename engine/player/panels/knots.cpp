// The knot line: knots and u are dragged here.
#include "player/panels/mouse.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

// As high as its run ever needs it: the panels stay where they are when a second knot vector comes.
double wanted(const Ui& ui, double) {
  const StepSource& source = ui.player().session()->recording().source();
  const std::uint32_t last = source.graph->step_count() - 1;
  return (resulting_knots(source, last) == absent ? knot_line_height : knot_lines_height) + 2;
}

std::size_t curve_of(const Player& player) {
  const std::size_t count = player.session()->recording().source().curves.size();
  return count > 0 ? std::min(player.curve, count - 1) : 0;
}

// The functions of the panel above stand exactly above the line.
constexpr double left = 8;
double line_width(double width) { return width - left - basis_bar_room; }

// The span a lesson asks for: the one that is clicked.
void pick_span(Ui& ui, const Mouse& mouse, const KnotAxis& axis) {
  const auto& curve = ui.player().session()->recording().source().curves[curve_of(ui.player())];
  const double u = axis.parameter(mouse.now().x);
  for (int i = curve.degree; i <= curve.n(); ++i) {
    const double a = curve.knots[static_cast<std::size_t>(i)], b = curve.knots[static_cast<std::size_t>(i) + 1];
    if (!(a < b) || u < a || u >= b) continue;
    const ImVec2 low{mouse.origin.x + ui.px(axis.place(a)), mouse.origin.y + ui.px(knot_line_at - 6)};
    const ImVec2 high{mouse.origin.x + ui.px(axis.place(b)), mouse.origin.y + ui.px(knot_line_at + 6)};
    ImGui::GetWindowDrawList()->AddRectFilled(low, high, ui.color(Role::highlight, 0.3), ui.px(3));
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (ImGui::IsMouseReleased(0))
      ui.send([i](Player& p) {
        p.checkpoints().type({std::to_string(i)});
        p.submit_checkpoint();
      });
    return;
  }
}

void handle_mouse(Ui& ui, const Mouse& mouse, const std::vector<Spot>& spots, const KnotAxis& axis) {
  const Player& player = ui.player();
  const Session& session = *player.session();
  if (player.holding()) {
    if (player.held() != nullptr &&
        (std::holds_alternative<KnotGrip>(*player.held()) || std::holds_alternative<ParameterGrip>(*player.held()))) {
      ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
      send_drag(ui, mouse.now(), grip_keys(player));
    }
    return;
  }
  const bool has_u = session.recording().source().parameter.has_value() && curves_of(session.inputs()).size() == 1;
  const auto take = [&](Grip grip) {
    ui.send([grip = std::move(grip), now = mouse.now(), keys = grip_keys(player)](Player& p) {
      if (p.take(grip)) p.drag(now, keys);
    });
  };
  if (mouse.over()) {
    if (player.checkpoint_asks(Checkpoint::Kind::span)) return pick_span(ui, mouse, axis);
    const Spot* spot = spot_at(spots, mouse.now());
    const bool on_axis = mouse.now().x > axis.left - 8 && mouse.now().x < axis.right + 8;
    if (spot != nullptr) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (spot == nullptr && has_u && on_axis && ImGui::IsMouseClicked(0))
      return take(ParameterGrip(session, axis, mouse.now().x, true));
  }
  if (!mouse.owns(0) || !mouse.dragged(0)) return;
  const double x = mouse.pressed(0).x;
  const Spot* spot = spot_at(spots, mouse.pressed(0));
  if (spot == nullptr) return;
  if (spot->link.kind == Link::Kind::parameter) return take(ParameterGrip(session, axis, x, false));
  if (spot->link.kind == Link::Kind::knot)
    take(KnotGrip(session, curves_of(session.inputs())[curve_of(player)], spot->link.id, axis, x));
}

// Where it was tried to put something, and why it cannot be there.
void draw_refusal(Ui& ui, View& view, const KnotAxis& axis, ImVec2 origin) {
  const Player& player = ui.player();
  const Diagnostics& rejected = player.session()->rejected();
  if (player.held() == nullptr || rejected.empty()) return;
  std::optional<Exact> tried;
  const double x = player.held_at().x;
  if (const auto* knot = std::get_if<KnotGrip>(player.held())) tried = knot->value(x, player.held_keys());
  if (const auto* u = std::get_if<ParameterGrip>(player.held())) tried = u->value(x, player.held_keys());
  if (!tried) return;
  const double at = std::clamp(axis.place(tried->to_double()), axis.left - 30, axis.right + 30);
  view.markers.push_back({{at, knot_line_at, 0}, Role::mistake, Marker::Shape::ring, 1.2});
  const Diagnostic& why = rejected.front();
  const std::string path = why.path.substr(why.path.find_last_of('.') + 1);
  const ImVec2 low{origin.x + ui.px(8), ui.px(8)};
  const ImVec2 high{origin.x + ImGui::GetContentRegionAvail().x - ui.px(8), origin.y - ui.px(2)};
  draw_tag(ui, *ImGui::GetForegroundDrawList(), {origin.x + ui.px(at - 40), high.y}, path + ": " + why.message,
           Role::mistake, low, high);
  ui.thing("knots refused", {origin.x, origin.y}, {origin.x + 1, origin.y + 1});
}

void draw(Ui& ui) {
  const Player& player = ui.player();
  const Session& session = *player.session();
  const ImVec2 origin = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const double width = ui.units(room.x), height = ui.units(room.y);
  const StepSource& source = session.recording().source();
  const std::size_t curve = curve_of(player);
  const auto axis = knot_axis(source, curve, left, line_width(width));
  if (!axis) return;
  Sheet sheet;
  add_knot_line(sheet, source, session.step(), player.emphasis(), left, 0, line_width(width), curve, true, true);
  if (source.curves.size() > 1) {
    Label which;
    which.anchor = {width - basis_bar_room, knot_line_at + 4, 0};
    which.text = {{"curve " + std::to_string(curve)}};
    which.role = Role::text_quiet;
    which.size_scale = 0.85;
    sheet.view.labels.push_back(std::move(which));
  }
  for (Spot& spot : sheet.spots) spot.height = std::min(spot.height, height - spot.y);
  draw_refusal(ui, sheet.view, *axis, origin);
  const std::vector<Spot> spots = sheet.spots;
  ui.sheet("knots", std::move(sheet), width, height);
  handle_mouse(ui, {ui, origin, {width, height}}, spots, *axis);
}

bool relevant(const Player& player) {
  return knot_axis(player.session()->recording().source(), curve_of(player), 0, 100).has_value();
}

}  // namespace

const Panel& panel_knots() {
  static const Panel panel{"knots", "Knots", Slot::strip, 0, draw, relevant, wanted, knot_line_height + 2};
  return panel;
}

}  // namespace blossom
