// The algorithm's pseudo-code with the line of the step.
#include <algorithm>
#include <utility>

#include "player/ui/panel.hpp"
#include "player/ui/ui.hpp"

namespace blossom {
namespace {

void draw(Ui& ui) {
  const Session& session = *ui.player().session();
  const double width = ui.units(ImGui::GetContentRegionAvail().x);
  Sheet sheet;
  const double height =
      add_pseudo_code(sheet, session.recording().source(), session.step(), ui.player().emphasis(), 6, 4, width - 12);
  // Another lesson's code begins at its beginning.
  static std::string seen;
  const Document& document = session.document();
  if (const std::string now = document.file.string() + " " + document.id(); std::exchange(seen, now) != now)
    ImGui::SetScrollY(0);
  // Where not all of it has room, the line of the step is kept in sight.
  float& seen_room = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("room"));
  const bool other_room = std::exchange(seen_room, ImGui::GetWindowHeight()) != ImGui::GetWindowHeight();
  if (ui.step_is_new_to("code") || other_room) {
    const std::string line = "line " + std::to_string(session.recording().source().line(session.step()));
    for (const Spot& spot : sheet.spots)
      if (spot.name == line) {
        const float top = ui.px(spot.y), bottom = ui.px(spot.y + spot.height), room = ImGui::GetWindowHeight();
        if (top < ImGui::GetScrollY() || bottom + ui.px(24) > ImGui::GetScrollY() + room) {
          ImGui::SetScrollY(std::max(0.0f, top - room / 2));
          ui.redraw();
        }
      }
  }
  const bool asks = ui.player().checkpoint_asks(Checkpoint::Kind::line);
  const Spot* found = ui.sheet("code", std::move(sheet), width, height, {.clickable = !asks});
  if (!asks || found == nullptr || found->link.kind != Link::Kind::line) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (ImGui::IsMouseReleased(0))
    ui.send([line = static_cast<int>(found->link.id)](Player& p) { p.submit_checkpoint_line(line); });
}

double wanted(const Ui& ui, double width) {
  const Session& session = *ui.player().session();
  Sheet measured;
  return add_pseudo_code(measured, session.recording().source(), session.step(), {}, 6, 4, width - 34) + 30;
}

}  // namespace

const Panel& panel_pseudo_code() {
  static const Panel panel{"code", "Code", Slot::side, 10, draw, nullptr, wanted};
  return panel;
}

}  // namespace blossom
