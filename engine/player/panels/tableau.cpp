// The triangular computing scheme, scrolled along with the steps.
#include <algorithm>

#include "player/ui/panel.hpp"
#include "player/ui/ui.hpp"

namespace blossom {
namespace {

// A scheme that is a little too large is made smaller; a much too large one is scrolled.
constexpr double smallest = 0.72;

double zoom_for(const StepSource& source, std::uint32_t step, double width, double height) {
  TableauOptions nothing_visible;
  nothing_visible.fit = false;
  nothing_visible.visible_to = -1;
  Sheet unseen;
  const TableauSize size = add_tableau(unseen, source, step, {}, 0, 0, nothing_visible);
  if (size.width <= 0) return 1;
  const double zoom = std::min({1.0, width / size.width, height / size.height});
  if (zoom >= smallest) return zoom;
  return width / size.width >= smallest ? std::min(width / size.width, 1.0) : 1;
}

void draw(Ui& ui) {
  const Session& session = *ui.player().session();
  if (ui.player().hides("k")) {
    ImGui::TextWrapped("Which points the scheme begins with follows from the span k, which is still asked.");
    return;
  }
  ImGui::BeginChild("scheme", {0, 0}, false, ImGuiWindowFlags_HorizontalScrollbar | ImGuiWindowFlags_NoNavInputs);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const StepSource& source = session.recording().source();
  const double zoom = zoom_for(source, session.step(), ui.units(room.x), ui.units(room.y));
  TableauOptions options;
  options.fit = false;
  options.width = ui.units(room.x) / zoom;
  options.height = ui.units(room.y) / zoom;
  options.visible_from = ui.units(ImGui::GetScrollY()) / zoom;
  options.visible_to = options.visible_from + options.height;
  Sheet sheet;
  const Emphasis& lit = ui.player().emphasis();
  const Emphasis emphasis = lit.quiet ? Emphasis{} : lit;
  TableauSize size = add_tableau(sheet, source, session.step(), emphasis, 0, 0, options);
  if (size.width <= 0) {
    size = add_value_table(sheet, source, session.step(), emphasis, 0, 0, options.width - 14);
    size.current_x = size.width / 2;
  }
  if (size.width <= 0) {
    ImGui::TextDisabled("Nothing has been computed yet.");
  } else {
    // It follows the step, and otherwise stays where one has scrolled it.
    if (ui.step_is_new_to("tableau")) {
      const auto follow = [&](double middle, double seen_from, double seen, auto&& scroll_to) {
        if (middle < seen_from + 30 || middle > seen_from + seen - 30) scroll_to(std::max(middle - seen / 2, 0.0));
      };
      follow(size.current_y, options.visible_from, options.height,
             [&](double y) { ImGui::SetScrollY(ui.px(y * zoom)), ui.redraw(); });
      follow(size.current_x, ui.units(ImGui::GetScrollX()) / zoom, options.width,
             [&](double x) { ImGui::SetScrollX(ui.px(x * zoom)), ui.redraw(); });
    }
    ui.sheet("tableau", std::move(sheet), size.width, size.height, {.zoom = zoom});
  }
  ImGui::EndChild();
}

}  // namespace

const Panel& panel_tableau() {
  static const Panel panel{"tableau", "Scheme", Slot::tabs, 10, draw};
  return panel;
}

}  // namespace blossom
