// The basis functions over the knot line, and how their values at u add up to 1.
#include <algorithm>

#include "player/ui/panel.hpp"
#include "player/ui/ui.hpp"

namespace blossom {
namespace {

constexpr double left = 8;  // as of the knot line
constexpr double wanted_height = 150, least_height = 112;

std::size_t curve_of(const Player& player) {
  const std::size_t count = player.session()->recording().source().curves.size();
  return count > 0 ? std::min(player.curve, count - 1) : 0;
}

void draw(Ui& ui) {
  const Player& player = ui.player();
  const Session& session = *player.session();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const double width = ui.units(room.x), height = ui.units(room.y);
  Sheet sheet;
  add_basis(sheet, session.recording().source(), session.step(),
            player.emphasis().quiet ? Emphasis{} : player.emphasis(), left, 0, width - left, height, curve_of(player),
            !player.hides("k"));
  ui.sheet("basis", std::move(sheet), width, height);
}

// Of several profiles, those of one would say little beside the surface.
bool relevant(const Player& player) {
  if (player.session()->recording().source().curves.size() != 1) return false;
  return knot_axis(player.session()->recording().source(), curve_of(player), 0, 100).has_value();
}

}  // namespace

const Panel& panel_basis() {
  static const Panel panel{
      "basis",     "Basis functions", Slot::strip, 1, draw, relevant, [](const Ui&, double) { return wanted_height; },
      least_height};
  return panel;
}

}  // namespace blossom
