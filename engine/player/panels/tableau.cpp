// The triangular computing scheme, scrolled along with the steps.
#include "player/ui/panel.hpp"
#include "player/ui/ui.hpp"

namespace blossom {
namespace {

void draw(Ui& ui) {
  const Session& session = *ui.player().session();
  ImGui::BeginChild("scheme", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoNavInputs);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  TableauOptions options;
  options.fit = false;
  options.width = ui.units(room.x);
  options.height = ui.units(room.y);
  options.visible_from = ui.units(ImGui::GetScrollY());
  options.visible_to = ui.units(ImGui::GetScrollY() + room.y);
  Sheet sheet;
  const TableauSize size =
      add_tableau(sheet, session.recording().source(), session.step(), ui.player().emphasis(), 0, 0, options);
  if (size.width <= 0) {
    ImGui::TextDisabled("This step has no triangular scheme.");
  } else {
    // It follows the step, and otherwise stays where one has scrolled it.
    static std::uint64_t version = 0;
    static std::uint32_t step = absent;
    if (version != session.version() || step != session.step()) {
      version = session.version();
      step = session.step();
      const auto follow = [&](double middle, double seen_from, double seen, auto&& scroll_to) {
        if (middle < seen_from + 30 || middle > seen_from + seen - 30) scroll_to(std::max(middle - seen / 2, 0.0));
      };
      follow(size.current_y, options.visible_from, options.height,
             [&](double y) { ImGui::SetScrollY(ui.px(y)), ui.redraw(); });
      follow(size.current_x, ui.units(ImGui::GetScrollX()), options.width,
             [&](double x) { ImGui::SetScrollX(ui.px(x)), ui.redraw(); });
    }
    ui.sheet("tableau", std::move(sheet), size.width, size.height);
  }
  ImGui::EndChild();
}

}  // namespace

const Panel& panel_tableau() {
  static const Panel panel{"tableau", "Scheme", Slot::tabs, 10, draw};
  return panel;
}

}  // namespace blossom
