// How Blossom looks and moves; what is changed is seen at once.
#include <algorithm>
#include <cmath>
#include <map>

#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

ImU32 to_imgui(Color c) { return IM_COL32(c.r, c.g, c.b, 255); }

// Three themes by their colours: a page with a line of text and the two that are loudest.
void theme_sample(const Ui& ui, const Theme& theme, ImVec2 at) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 high{at.x + ui.px(58), at.y + ImGui::GetFrameHeight()};
  list.AddRectFilled(at, high, to_imgui(theme.background), ui.px(4));
  list.AddRect(at, high, ui.color(Role::rule_line), ui.px(4), 0, ui.px(1));
  const float y = (at.y + high.y) / 2;
  list.AddRectFilled({at.x + ui.px(7), y - ui.px(1.5)}, {at.x + ui.px(25), y + ui.px(1.5)},
                     to_imgui(theme[Role::text].ink));
  list.AddCircleFilled({at.x + ui.px(35), y}, ui.px(4.5), to_imgui(theme[Role::level_a].color));
  list.AddCircleFilled({at.x + ui.px(48), y}, ui.px(4.5), to_imgui(theme[Role::current].color));
}

void themes(Ui& ui) {
  ui.heading("Colours");
  for (const auto& [name, title] : theme_list) {
    const auto theme = find_theme(name);
    if (!theme) continue;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    theme_sample(ui, **theme, at);
    ImGui::SetCursorScreenPos({at.x + ui.px(68), at.y});
    if (radio(ui, std::string(title), "settings " + std::string(name), ui.player().settings.theme == name))
      ui.send([theme_name = std::string(name)](Player& player) { player.settings.theme = theme_name; });
  }
}

// As its speakers call it.
std::string name_of_language(const std::string& language) {
  static const std::map<std::string, const char*> names{
      {"cs", "Čeština"}, {"da", "Dansk"},     {"de", "Deutsch"},   {"en", "English"},  {"es", "Español"},
      {"fi", "Suomi"},   {"fr", "Français"},  {"hu", "Magyar"},    {"it", "Italiano"}, {"nl", "Nederlands"},
      {"nb", "Norsk"},   {"pl", "Polski"},    {"pt", "Português"}, {"ro", "Română"},   {"sv", "Svenska"},
      {"tr", "Türkçe"},  {"uk", "Українська"}};
  const auto found = names.find(language);
  return found != names.end() ? found->second : language;
}

// Of the lesson that is open, if it has several; a lesson without the language one reads is shown in its own.
void languages(Ui& ui) {
  const auto all = ui.player().languages();
  if (all.size() < 2) return;
  ui.heading("Language of lessons");
  const bool known = std::ranges::find(all, ui.player().language()) != all.end();
  for (const std::string& each : all) {
    if (each != all.front()) ImGui::SameLine();
    const bool on = known ? ui.player().language() == each : each == all.front();
    if (radio(ui, name_of_language(each), "settings language " + each, on))
      ui.send([each](Player& player) { player.settings.language = each; });
  }
  ImGui::Dummy({0, ui.px(2)});
}

// Its value stands beside it: on it, the knob would cover the words.
float slider_width(const Ui& ui, const char* value) {
  const float beside = ImGui::CalcTextSize(value).x + ImGui::GetStyle().ItemSpacing.x;
  return std::clamp(ImGui::GetContentRegionAvail().x - beside, ui.px(60), ui.px(280));
}

void text_size(Ui& ui) {
  // Dragged, it takes effect in the end: the slider would move away under the mouse.
  static int percent = 100;
  ui.heading("Size of the text");
  ImGui::SetNextItemWidth(slider_width(ui, "300 %"));
  ImGui::SliderInt("##size", &percent, 75, 300, "", ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput);
  ui.thing("settings text size");
  const auto take = [&ui](int wanted) {
    ui.send([wanted](Player& player) { player.settings.text_scale = wanted / 100.0; });
  };
  if (ImGui::IsItemDeactivatedAfterEdit()) take(percent);
  if (!ImGui::IsItemActive()) percent = static_cast<int>(std::lround(100 * ui.player().settings.text_scale));
  ImGui::SameLine();
  ImGui::Text("%d %%", percent);
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  for (const int preset : {75, 100, 125, 150, 200, 300}) {
    const std::string label = std::to_string(preset) + " %";
    if (preset != 75) {
      ImGui::SameLine();
      if (ImGui::GetCursorScreenPos().x + ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x >
          right)
        ImGui::NewLine();
    }
    if (ui.button(label.c_str(), "settings " + std::to_string(preset))) take(preset);
  }
}

void check(Ui& ui, const char* label, const char* name, const char* action, bool on) {
  if (ImGui::Checkbox(label, &on)) ui.act(action);
  ui.thing(name);
}

void draw(Ui& ui) {
  if (!begin_dialog(ui, "Settings", 470)) return;
  const Settings& settings = ui.player().settings;
  // With large text they scroll above the button.
  static float content = 0;
  const float below = ImGui::GetFrameHeightWithSpacing() + ui.px(12);
  ImGui::BeginChild("settings", {0, std::min(std::max(content, ui.px(60)), dialog_room(ui, below))}, false,
                    ImGuiWindowFlags_NavFlattened);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, std::max(1.0f, ui.px(1)));  // what is off is to be seen, too
  themes(ui);
  ImGui::Dummy({0, ui.px(2)});
  languages(ui);
  text_size(ui);
  ImGui::Dummy({0, ui.px(2)});
  ui.heading("Steps");
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Speed");
  ImGui::SameLine();
  auto speed = static_cast<float>(settings.speed);
  ImGui::SetNextItemWidth(slider_width(ui, "10.0 steps a second"));
  if (ImGui::SliderFloat("##speed", &speed, 0.1f, 10.0f, "",
                         ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoInput |
                             ImGuiSliderFlags_NoRoundToFormat))
    ui.send([speed](Player& player) { player.settings.speed = std::round(10.0 * static_cast<double>(speed)) / 10; });
  ui.thing("settings speed");
  ImGui::SameLine();
  ImGui::Text("%.1f steps a second", settings.speed);
  check(ui, "Reduced motion: steps are shown without moving", "settings motion", "view.motion",
        settings.reduced_motion);
  check(ui, "Numbers as exact fractions", "settings exact", "view.exact", settings.exact);
  ImGui::Dummy({0, ui.px(2)});
  ui.heading("Picture");
  check(ui, "Grid and axes", "settings grid", "view.grid", settings.grid);
  check(ui, "Points snap to the grid", "settings snap", "edit.snap", settings.snap);
  ImGui::PopStyleVar();
  const float used = ImGui::GetCursorPosY() + ImGui::GetScrollY();
  if (std::exchange(content, used) != used) ui.redraw();
  ImGui::EndChild();
  if (dialog_buttons(ui, "Done", true, nullptr)) close_dialog(ui);
  end_dialog();
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::settings; }

}  // namespace

const Panel& panel_dialog_settings() {
  static const Panel panel{"settings", "Settings", Slot::float_, 54, draw, is_relevant};
  return panel;
}

}  // namespace blossom
