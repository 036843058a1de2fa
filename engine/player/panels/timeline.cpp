// Where one is and how to move.
#include "player/ui/panel.hpp"
#include "player/ui/ui.hpp"

namespace blossom {
namespace {

void draw(Ui& ui) {
  const Session& session = *ui.player().session();
  ui.icon_button("step.first", "first");
  ImGui::SameLine();
  ui.icon_button("step.back", "back");
  ImGui::SameLine();
  ui.icon_button("step.play", session.timeline().playing() ? "pause" : "play");
  ImGui::SameLine();
  ui.icon_button("step.forward", "forward");
  ImGui::SameLine();
  ui.icon_button("step.last", "last");
  ImGui::SameLine();
  ImGui::Text("%u / %u", session.step(), session.last());
}

double wanted(const Ui&, double) { return 72; }

}  // namespace

const Panel& panel_timeline() {
  static const Panel panel{"timeline", "Timeline", Slot::foot, 20, draw, nullptr, wanted};
  return panel;
}

}  // namespace blossom
