// How far an export is, and the way to stop it, in the bar: the lesson goes on meanwhile.
#include <algorithm>
#include <cmath>
#include <optional>

#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

// Between the menus and the buttons of the bar, over the title: it covers nothing one works with. Nothing where there
// is too little room for that.
std::optional<PixelRect> place_in_bar(const Ui& ui) {
  const auto title = ui.things().find("menu title");
  const auto bar = ui.things().find("panel menu");
  if (title == ui.things().end() || bar == ui.things().end()) return std::nullopt;
  const PixelRect& all = bar->second;
  const double middle = title->second.x + title->second.width / 2, gap = static_cast<double>(ui.px(12));
  double left = all.x, right = all.right();
  for (const auto& [name, rect] : ui.things()) {
    if (rect.bottom() > all.bottom() || name == "panel menu" || name == "panel exporting") continue;
    if (rect.right() < middle && rect.x < title->second.x) left = std::max(left, rect.right());
    if (rect.x > middle && rect.right() > title->second.right()) right = std::min(right, rect.x);
  }
  left += gap, right -= gap;
  const double width = std::min(right - left, static_cast<double>(ui.px(560)));
  if (width < static_cast<double>(ui.px(320))) return std::nullopt;
  const double x = std::clamp(middle - width / 2, left, right - width), edge = static_cast<double>(ui.px(2));
  return PixelRect{std::round(x), all.y + edge, std::round(width), all.height - 2 * edge};
}

void draw(Ui& ui) {
  const ExportJob& job = *ui.player().exporting();
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const auto in_bar = place_in_bar(ui);
  if (in_bar) {
    ImGui::SetNextWindowPos({static_cast<float>(in_bar->x), static_cast<float>(in_bar->y)});
    ImGui::SetNextWindowSize({static_cast<float>(in_bar->width), static_cast<float>(in_bar->height)});
  } else {
    ImGui::SetNextWindowPos({std::round(window.x / 2), ui.px(52)}, ImGuiCond_Always, {0.5f, 0});
    ImGui::SetNextWindowSize({std::min(ui.px(420), window.x - ui.px(20)), 0});
  }
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.color(Role::panel));
  ImGui::PushStyleColor(ImGuiCol_Border, ui.color(Role::current));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, ui.px(1.5));
  const bool shown = ImGui::Begin("exporting", nullptr,
                                  ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoSavedSettings |
                                      ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  if (shown) {
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ui.thing("panel exporting", low, {low.x + size.x, low.y + size.y});
    const float button = ImGui::CalcTextSize("Cancel").x + 2 * ImGui::GetStyle().FramePadding.x + ui.px(8);
    const std::string name = "Exporting " + printable(job.out().filename().string());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(shortened(name, ImGui::GetContentRegionAvail().x * (in_bar ? 0.45f : 1)).c_str());
    if (in_bar) ImGui::SameLine();
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
