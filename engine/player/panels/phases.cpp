// The parts of an algorithm that has parts, as a tree.
#include <algorithm>

#include "player/ui/panel.hpp"
#include "player/ui/ui.hpp"

namespace blossom {
namespace {

void draw(Ui& ui) {
  const Session& session = *ui.player().session();
  ImGui::BeginChild("tree", {0, 0}, false, ImGuiWindowFlags_NoNavInputs);
  const double width = ui.units(ImGui::GetContentRegionAvail().x);
  Sheet sheet;
  const double height =
      add_phase_tree(sheet, session.recording().source(), session.step(), ui.player().open_phases, 2, 2, width - 4);
  const Spot* over = ui.sheet("phases", std::move(sheet), width, height, {.clickable = false});
  if (over != nullptr && over->link.kind == Link::Kind::phase) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (ImGui::IsMouseClicked(0))
      ui.send(
          [phase = over->link.id](Player& p) { p.seek(p.session()->recording().graph().phases()[phase].first_step); });
  }
  ImGui::EndChild();
}

bool relevant(const Player& player) {
  return player.session() != nullptr && !player.session()->recording().graph().phases().empty();
}

}  // namespace

const Panel& panel_phases() {
  static const Panel panel{"phases", "Phases", Slot::tabs, 30, draw, relevant};
  return panel;
}

}  // namespace blossom
