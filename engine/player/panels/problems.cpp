// What is wrong with a file, as a list over the picture.
#include <algorithm>

#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

// The picture's place, or the page's.
PixelRect room_of(const Ui& ui) {
  for (const char* name : {"panel viewport", "panel start"})
    if (const auto found = ui.things().find(name); found != ui.things().end()) return found->second;
  return {0, 0, static_cast<double>(ImGui::GetIO().DisplaySize.x), static_cast<double>(ImGui::GetIO().DisplaySize.y)};
}

std::string place_of(const Diagnostic& wrong) {
  std::string text = printable(std::filesystem::path(wrong.file).filename().string());
  if (wrong.line > 0) text += ":" + std::to_string(wrong.line);
  if (wrong.line > 0 && wrong.column > 0) text += ":" + std::to_string(wrong.column);
  return text;
}

void sign(Ui& ui) {
  const float side = ImGui::GetFrameHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddTriangleFilled({at.x + side / 2, at.y + ui.px(1)}, {at.x + side, at.y + side - ui.px(2)},
                         {at.x, at.y + side - ui.px(2)}, ui.color(Role::mistake));
  ImGui::PushFont(ui.bold());
  const ImVec2 text = ImGui::CalcTextSize("!");
  list.AddText({at.x + (side - text.x) / 2, at.y + (side - text.y) / 2 + ui.px(2)},
               ImGui::GetColorU32(ImGuiCol_WindowBg), "!");
  ImGui::PopFont();
  ImGui::Dummy({side, side});
}

void draw_list(Ui& ui, const Diagnostics& list) {
  for (const Diagnostic& wrong : list) {
    if (const std::string place = place_of(wrong); !place.empty()) {
      ImGui::PushFont(ui.mono());
      ImGui::PushStyleColor(ImGuiCol_Text, ui.ink(Role::text_quiet));
      ImGui::TextUnformatted(shortened(place, ImGui::GetContentRegionAvail().x).c_str());
      ImGui::PopStyleColor();
      ImGui::PopFont();
    }
    ImGui::PushTextWrapPos(0);
    const std::string path = wrong.path.empty() ? "" : printable(wrong.path) + ": ";
    ImGui::TextUnformatted((path + printable(wrong.message)).c_str());
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, ui.px(1)});
  }
}

void draw(Ui& ui) {
  const Player::Problems& problems = ui.player().problems();
  const PixelRect room = room_of(ui);
  const float margin = ui.px(10);
  const float width = std::min(static_cast<float>(room.width) - 2 * margin, ui.px(760));
  const float most = ImGui::GetIO().DisplaySize.y / 3;
  ImGui::SetNextWindowPos({std::round(static_cast<float>(room.x + room.width / 2) - width / 2),
                           std::round(static_cast<float>(room.y) + margin)});
  ImGui::SetNextWindowSize({width, 0});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, most});
  ImGui::PushStyleColor(ImGuiCol_Border, ui.color(Role::mistake));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.color(Role::panel));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, ui.px(2));
  const bool shown = ImGui::Begin("problems", nullptr,
                                  ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor(2);
  if (shown) {
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ui.thing("panel problems", low, {low.x + size.x, low.y + size.y});
    const float button = ImGui::CalcTextSize("Dismiss").x + 2 * ImGui::GetStyle().FramePadding.x;
    const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
    sign(ui);
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(ui.bold());
    ImGui::PushStyleColor(ImGuiCol_Text, ui.ink(Role::mistake));
    ImGui::PushTextWrapPos(right - button - margin);
    ImGui::TextUnformatted(problems.what.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
    const float next = ImGui::GetCursorPosY();
    ImGui::SetCursorPos({right - button, ImGui::GetCursorStartPos().y});
    if (ui.button("Dismiss", "problems dismiss", true, "Escape"))
      ui.send([](Player& player) { player.dismiss_problems(); });
    ImGui::SetCursorPosY(std::max(next, ImGui::GetCursorPosY()));
    draw_list(ui, problems.list);
  }
  ImGui::End();
}

bool is_relevant(const Player& player) { return !player.problems().what.empty() || !player.problems().list.empty(); }

}  // namespace

const Panel& panel_problems() {
  static const Panel panel{.id = "problems",
                           .title = "Problems",
                           .slot = Slot::float_,
                           .order = 10,
                           .draw = draw,
                           .relevant = is_relevant,
                           .widgets = true};
  return panel;
}

}  // namespace blossom
