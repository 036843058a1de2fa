// The knots of the current curve on a line: knots and u are dragged here.
#include "player/panels/mouse.hpp"
#include "player/ui/panel.hpp"
#include "player/ui/studio_fields.hpp"

namespace blossom {
namespace {

constexpr double left = 10, right = 14, line_height = 60;

const Curve<Exact>* curve_of(const Player& player) {
  const SceneObject* object = player.studio()->object();
  return object != nullptr ? std::get_if<Curve<Exact>>(&object->geometry) : nullptr;
}

// What a drag has hold of, from the press to the release.
struct Hold {
  std::optional<std::size_t> knot;  // the first of the equal ones; nothing: u
  bool active = false;
};

void handle_mouse(Ui& ui, const Mouse& mouse, const std::vector<Spot>& spots, const Curve<Exact>& curve, double width) {
  static Hold hold;
  const double first = curve.knots.front().to_double(), last = curve.knots.back().to_double();
  const KnotAxis axis{first, last, left, left + width};
  if (!ImGui::IsMouseDown(0)) {
    if (hold.active) send_studio(ui, [](Studio& s) { s.end_gesture(); });
    hold = {};
  }
  const Spot* spot = mouse.over() ? spot_at(spots, mouse.now()) : nullptr;
  if (spot != nullptr) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (mouse.over() && ImGui::IsMouseClicked(0)) {
    hold.active = true;
    hold.knot.reset();
    if (spot != nullptr && spot->link.kind == Link::Kind::knot) hold.knot = spot->link.id;
  }
  if (!hold.active || !mouse.owns(0)) return;
  const double unit = (last - first) / std::max(width, 1.0), at = axis.parameter(mouse.now().x);
  if (!hold.knot) {
    send_studio(ui, [at](Studio& s) { s.look_at(at, s.v()); });
    return;
  }
  if (!mouse.dragged(0)) return;
  const bool all = ImGui::GetIO().KeyShift;
  send_studio(ui, [=, knot = *hold.knot](Studio& s) {
    if (!s.current()) return;
    const auto* now = std::get_if<Curve<Exact>>(&s.object()->geometry);
    if (now == nullptr || knot >= now->knots.size()) return;
    std::size_t end = knot;
    while (end + 1 < now->knots.size() && now->knots[end + 1] == now->knots[knot]) ++end;
    const std::size_t low = knot > 0 ? knot - 1 : knot, high = std::min(end + 1, now->knots.size() - 1);
    const double least = knot > 0 ? now->knots[low].to_double() : at;
    const double most = end + 1 < now->knots.size() ? now->knots[high].to_double() : at;
    const Exact to = snapped(std::clamp(at, least, most), unit);
    const std::size_t index = to < now->knots[knot] ? knot : end;
    s.edit(edit::change(
               s.workspace(), *s.current(),
               [=](Curve<Exact> c) {
                 return all ? edit::set_equal_knots(std::move(c), knot, to) : edit::set_knot(std::move(c), index, to);
               },
               true),
           "knot " + std::to_string(index), "knot " + std::to_string(knot));
  });
}

void draw(Ui& ui) {
  const Studio& studio = *ui.player().studio();
  const Curve<Exact>* curve = curve_of(ui.player());
  if (curve == nullptr) return;
  const ImVec2 origin = ImGui::GetCursorScreenPos(), room = ImGui::GetContentRegionAvail();
  const double width = ui.units(room.x), height = ui.units(room.y);
  const double line = width - left - right;
  if (line < 60) return;
  Sheet sheet;
  add_object_knots(sheet, convert<double>(*curve), studio.u(), left, 0, line);
  const std::vector<Spot> spots = sheet.spots;
  ui.sheet("knots", std::move(sheet), width, height, {.clickable = false});
  handle_mouse(ui, {ui, origin, {width, height}}, spots, *curve, line);
}

bool relevant(const Player& player) { return curve_of(player) != nullptr; }
double wanted(const Ui&, double) { return line_height; }

}  // namespace

const Panel& panel_studio_knots() {
  static const Panel panel{"knots-of-thing", "Knots", Slot::strip, 0, draw, relevant, wanted, line_height, false, true};
  return panel;
}

}  // namespace blossom
