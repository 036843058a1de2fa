// How far an export is, and the way to stop it; over the picture, which goes on.
#include <algorithm>

#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

void draw(Ui& ui) {
  const ExportJob& job = *ui.player().exporting();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float width = std::min(ui.px(420), window.x - ui.px(20));
  ImGui::SetNextWindowPos({std::round(window.x / 2), ui.px(52)}, ImGuiCond_Always, {0.5f, 0});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.color(Role::panel));
  ImGui::PushStyleColor(ImGuiCol_Border, ui.color(Role::current));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, ui.px(1.5));
  const bool shown = ImGui::Begin("exporting", nullptr,
                                  ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  if (shown) {
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ui.thing("panel exporting", low, {low.x + size.x, low.y + size.y});
    const float button = ImGui::CalcTextSize("Cancel").x + 2 * ImGui::GetStyle().FramePadding.x + ui.px(8);
    const std::string name = "Exporting " + printable(job.out().filename().string());
    ImGui::TextUnformatted(shortened(name, ImGui::GetContentRegionAvail().x).c_str());
    const double share = job.of() > 0 ? static_cast<double>(job.done()) / static_cast<double>(job.of()) : 0;
    const std::string words =
        job.of() > 0 ? std::to_string(static_cast<int>(100 * share)) + " %" : std::string("getting ready");
    ImGui::ProgressBar(static_cast<float>(share), {ImGui::GetContentRegionAvail().x - button, 0}, words.c_str());
    ui.thing("exporting progress");
    ImGui::SameLine();
    if (ui.button("Cancel", "exporting cancel")) ui.send([](Player& p) { p.cancel_export(); });
  }
  ImGui::End();
}

bool is_relevant(const Player& player) { return player.exporting() != nullptr; }

}  // namespace

const Panel& panel_exporting() {
  static const Panel panel{.id = "exporting",
                           .title = "Exporting",
                           .slot = Slot::float_,
                           .order = 12,
                           .draw = draw,
                           .relevant = is_relevant,
                           .widgets = true};
  return panel;
}

}  // namespace blossom
