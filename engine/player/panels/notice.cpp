// A line that says what was done, for a while.
#include <algorithm>
#include <cmath>

#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

// Above what stands at the bottom edge.
float lower_edge(const Ui& ui) {
  const float whole = ImGui::GetIO().DisplaySize.y;
  double edge = static_cast<double>(whole);
  for (const Panel* panel : panels())
    if (panel->slot == Slot::foot)
      if (const auto found = ui.things().find("panel " + std::string(panel->id)); found != ui.things().end())
        edge = std::min(edge, found->second.y);
  return edge < static_cast<double>(whole) * 0.3 ? whole : static_cast<float>(edge);
}

void draw(Ui& ui) {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float most = std::min(screen.x - ui.px(40), ui.px(720));
  const auto lines = wrapped(ui.player().notice(), most - ui.px(28), 3);
  ImGui::SetNextWindowPos({std::round(screen.x / 2), std::round(lower_edge(ui) - ui.px(12))}, ImGuiCond_Always,
                          {0.5f, 1});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(14), ui.px(8)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ui.px(16));
  // The other way round than the page, so that it is seen on everything.
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.ink(Role::text));
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetColorU32(ImGuiCol_PopupBg));
  const bool shown = ImGui::Begin("notice", nullptr,
                                  ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav |
                                      ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_AlwaysAutoResize);
  if (shown) {
    for (const std::string& line : lines) ImGui::TextUnformatted(line.c_str());
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ui.thing("notice", low, {low.x + size.x, low.y + size.y});
  }
  ImGui::End();
  ImGui::PopStyleColor(2);
  ImGui::PopStyleVar(2);
}

bool is_relevant(const Player& player) { return !player.notice().empty(); }

}  // namespace

const Panel& panel_notice() {
  static const Panel panel{"notice", "Notice", Slot::float_, 20, draw, is_relevant};
  return panel;
}

}  // namespace blossom
