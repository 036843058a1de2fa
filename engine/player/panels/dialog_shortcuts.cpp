// Every key and every gesture on one sheet.
#include <algorithm>

#include "player/action.hpp"
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

struct Line {
  std::vector<std::string> keys;  // any of them
  std::string text;
};

struct Section {
  std::string title;
  std::vector<Line> lines;
};

std::vector<Section> all_sections(const Player& player) {
  std::vector<Section> sections;
  for (const ActionGroup* group : ordered_action_groups()) {
    Section section{std::string(group->title), {}};
    for (const Action* here : actions_here(player, *group)) {
      const Action& action = *here;
      if (action.keys.empty()) continue;
      Line line{{}, std::string(action.title)};
      for (const std::string_view key : action.keys) line.keys.emplace_back(key);
      section.lines.push_back(std::move(line));
    }
    if (!section.lines.empty()) sections.push_back(std::move(section));
  }
  sections.push_back({"Without a mouse",
                      {{{"F6"}, "To the next panel"},
                       {{"Shift+F6"}, "To the panel before"},
                       {{"Ctrl+Tab"}, "To the next tab"},
                       {{"F10"}, "To the menus"},
                       {{"Alt+\u2190 \u2191 \u2192 \u2193"}, "From value to value in a panel"},
                       {{"Escape"}, "Close, or let go of all"}}});
  if (player.in_studio())
    sections.push_back({"With the mouse",
                        {{{"Click"}, "Choose a thing or a point; Shift: also"},
                         {{"Drag a point"}, "Move it; Shift: along an axis"},
                         {{"Ctrl+Drag"}, "On the grid"},
                         {{"Drag a curve"}, "Move u, where its point is shown"},
                         {{"Drag beside"}, "Turn the view in space, or shift it"},
                         {{"Shift+Drag beside"}, "Choose the points in a box"},
                         {{"Right-drag"}, "Shift the view"},
                         {{"Right-click"}, "What can be done with it"},
                         {{"Wheel"}, "Closer and farther"}}});
  else
    sections.push_back({"With the mouse",
                        {{{"Point"}, "Light up a value everywhere"},
                         {{"Click"}, "Pin it; click again to let go"},
                         {{"Double-click"}, "Go to the step that makes it"},
                         {{"Right-click"}, "Why this value? Copy it"},
                         {{"Drag"}, "Move a control point, a knot or u"},
                         {{"Drag beside"}, "Shift the picture, or turn it in 3D"},
                         {{"Wheel"}, "Closer and farther"}}});
  return sections;
}

// Arrows as arrows: "Ctrl+Up" is "Ctrl+\u2191".
std::string spelled(const std::string& key) {
  constexpr std::pair<std::string_view, std::string_view> arrows[] = {
      {"Left", "\u2190"}, {"Right", "\u2192"}, {"Up", "\u2191"}, {"Down", "\u2193"}};
  const std::size_t plus = key.size() > 1 ? key.rfind('+', key.size() - 2) : std::string::npos;
  const std::size_t from = plus == std::string::npos ? 0 : plus + 1;
  for (const auto& [name, arrow] : arrows)
    if (key.substr(from) == name) return key.substr(0, from) + std::string(arrow);
  return key;
}

float cap_width(const Ui& ui, const std::string& key) { return ImGui::CalcTextSize(key.c_str()).x + ui.px(12); }

float draw_cap(const Ui& ui, ImVec2 at, const std::string& key) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float height = ImGui::GetFontSize() + ui.px(5);
  const ImVec2 high{at.x + cap_width(ui, key), at.y + height};
  list.AddRectFilled(at, {high.x, high.y + ui.px(1.5)}, ui.color(Role::rule_line), ui.px(4));
  list.AddRectFilled(at, high, ui.color(Role::panel), ui.px(4));
  list.AddRect(at, high, ui.color(Role::rule_line), ui.px(4), 0, ui.px(1));
  list.AddText({at.x + ui.px(6), at.y + ui.px(2)}, ui.ink(Role::text), key.c_str());
  return high.x - at.x;
}

float row_height(const Ui& ui) { return ImGui::GetFontSize() + ui.px(12); }
float heading_height(const Ui& ui) { return ImGui::GetFontSize() + ui.px(12); }
float height_of(const Ui& ui, const Section& section) {
  return heading_height(ui) + static_cast<float>(section.lines.size()) * row_height(ui) + ui.px(10);
}

void draw_section(Ui& ui, const Section& section, ImVec2 at, float width) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushFont(ui.bold());
  list.AddText(at, ui.ink(Role::text_quiet), section.title.c_str());
  ImGui::PopFont();
  at.y += heading_height(ui);
  for (const Line& line : section.lines) {
    float used = 0;
    ImGui::PushFont(ui.small());
    // From the right; the first one is the one that menus show, and stands leftmost.
    std::vector<std::string> keys;
    float text_width = 0;
    ImGui::PushFont(ui.regular());
    text_width = std::min(ImGui::CalcTextSize(line.text.c_str()).x, width * 0.62f);
    ImGui::PopFont();
    for (const std::string& key : line.keys) {
      const float more = cap_width(ui, spelled(key)) + ui.px(4);
      if (!keys.empty() && used + more + text_width + ui.px(8) > width) break;
      keys.push_back(spelled(key));
      used += more;
    }
    float x = at.x + width - used + ui.px(4);
    for (const std::string& key : keys) x += draw_cap(ui, {x, at.y}, key) + ui.px(4);
    ImGui::PopFont();
    list.AddText({at.x, at.y + ui.px(1)}, ui.ink(Role::text), shortened(line.text, width - used - ui.px(4)).c_str());
    at.y += row_height(ui);
  }
}

void draw(Ui& ui) {
  const double wide = std::min(ui.width() - 24, 1120.0);
  if (!begin_dialog(ui, "Keys and gestures", wide)) return;
  const auto sections = all_sections(ui.player());
  const int columns = std::clamp(static_cast<int>(wide / 330), 1, 3);
  // In their order, each column filled up to its share of the whole.
  float total = 0;
  for (const Section& section : sections) total += height_of(ui, section);
  std::vector<std::vector<const Section*>> by_column(static_cast<std::size_t>(columns));
  std::vector<float> heights(by_column.size(), 0);
  std::size_t column = 0;
  const float share = total / static_cast<float>(columns);
  for (const Section& section : sections) {
    const float height = height_of(ui, section);
    if (heights[column] > 0 && heights[column] + height / 2 > share && column + 1 < by_column.size()) ++column;
    by_column[column].push_back(&section);
    heights[column] += height;
  }
  const float highest = *std::ranges::max_element(heights);
  const float below = ImGui::GetFrameHeightWithSpacing() + ui.px(12);
  ImGui::BeginChild("sheet", {0, std::min(highest, dialog_room(ui, below))}, false);
  const float between = ui.px(28), room = ImGui::GetContentRegionAvail().x - ui.px(4);
  const float width = (room - static_cast<float>(columns - 1) * between) / static_cast<float>(columns);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  for (std::size_t c = 0; c < by_column.size(); ++c) {
    ImVec2 at{origin.x + static_cast<float>(c) * (width + between), origin.y};
    for (const Section* section : by_column[c]) {
      draw_section(ui, *section, at, width);
      at.y += height_of(ui, *section);
    }
  }
  ImGui::Dummy({room, highest - ui.px(4)});
  // The keyboard scrolls.
  const float line = row_height(ui) * 2;
  const auto scroll = [&](ImGuiKey key, float by) {
    if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(key))) ImGui::SetScrollY(ImGui::GetScrollY() + by), ui.redraw();
  };
  scroll(ImGuiKey_DownArrow, line);
  scroll(ImGuiKey_UpArrow, -line);
  scroll(ImGuiKey_PageDown, ImGui::GetWindowHeight() * 0.9f);
  scroll(ImGuiKey_PageUp, -ImGui::GetWindowHeight() * 0.9f);
  ImGui::EndChild();
  const auto& typed = ImGui::GetIO().InputQueueCharacters;
  const bool asked_again = std::find(typed.begin(), typed.end(), static_cast<ImWchar>('?')) != typed.end();
  if (dialog_buttons(ui, "Close", true, nullptr) || (asked_again && !dialog_opens())) close_dialog(ui);
  end_dialog();
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::shortcuts; }

}  // namespace

const Panel& panel_dialog_shortcuts() {
  static const Panel panel{"shortcuts", "Keys and gestures", Slot::float_, 58, draw, is_relevant};
  return panel;
}

}  // namespace blossom
