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

void copy(Ui& ui, const Diagnostics& list) {
  ui.send([text = to_string(list), count = list.size()](Player& player) {
    player.desk().set_clipboard(text);
    player.notice(count == 1 ? "Copied." : "Copied: " + std::to_string(count) + " mistakes.");
  });
}

// Where and what, one below the other; a click copies it, as "file:line:column: what".
void draw_mistake(Ui& ui, const Diagnostic& wrong, std::size_t number) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, pad = ui.px(4);
  const std::string place = place_of(wrong);
  const std::string text = (wrong.path.empty() ? "" : printable(wrong.path) + ": ") + printable(wrong.message);
  const float place_height = place.empty() ? 0 : ui.mono()->FontSize + ui.px(2);
  const float text_width = width - 2 * pad;
  const float height = place_height + ImGui::CalcTextSize(text.c_str(), nullptr, false, text_width).y + 2 * pad;
  ImGui::PushID(static_cast<int>(number));
  if (ImGui::InvisibleButton("mistake", {width, height})) copy(ui, {wrong});
  ImGui::PopID();
  ui.thing("problems row " + std::to_string(number + 1));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered() || (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible)) {
    list.AddRectFilled(at, {at.x + width, at.y + height}, ui.color(Role::rule_line, 0.5), ui.px(4));
    ImGui::SetTooltip("Click to copy");
  }
  ImGui::PushFont(ui.mono());
  if (!place.empty())
    list.AddText({at.x + pad, at.y + pad}, ui.ink(Role::text_quiet), shortened(place, text_width).c_str());
  ImGui::PopFont();
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x + pad, at.y + pad + place_height}, ui.ink(Role::text),
               text.c_str(), nullptr, text_width);
}

void draw_list(Ui& ui, const Diagnostics& list) {
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, ui.px(2)});
  for (std::size_t i = 0; i < list.size(); ++i) draw_mistake(ui, list[i], i);
  ImGui::PopStyleVar();
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
    const float padding = 2 * ImGui::GetStyle().FramePadding.x, gap = ImGui::GetStyle().ItemSpacing.x;
    const float button = ImGui::CalcTextSize("Dismiss").x + padding + gap + ImGui::CalcTextSize("Copy all").x + padding;
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
    if (ui.button("Copy all", "problems copy", true, "All of them, a line for each")) copy(ui, problems.list);
    ImGui::SameLine();
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
