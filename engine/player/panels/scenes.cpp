// Which scene of the lesson one is in, and the way to the others.
#include <algorithm>

#include "player/action.hpp"
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

bool at_end(const Player& player) {
  return player.session()->timeline().at_end() && player.scene() + 1 < player.scene_count();
}

void draw(Ui& ui) {
  const Player& player = ui.player();
  const std::size_t here = player.scene(), count = player.scene_count();
  const bool ends = at_end(player);
  ImGui::SetCursorPosY(ui.px(5));
  if (ui.button("\u25C0", "lesson.previous_scene", here > 0, "The scene before   Ctrl+PageUp"))
    ui.act("lesson.previous_scene");
  ImGui::SameLine();
  // At its end the next one is what one wants: named and marked.
  const std::string next = ends ? "Next: " + player.scene_heading(here + 1) + "  \u25B6" : "\u25B6";
  const float room = ImGui::GetContentRegionAvail().x;
  const std::string label = shortened(next, room * 0.5f);
  const float button = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
  const std::string place = std::to_string(here + 1) + " of " + std::to_string(count);
  const float left = ImGui::GetCursorPosX();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", place.c_str());
  ui.thing("scenes place");
  ImGui::SameLine();
  const float used = ImGui::GetCursorPosX() - left;
  ImGui::PushFont(ui.bold());
  ImGui::TextUnformatted(shortened(player.scene_heading(here), room - used - button - ui.px(14)).c_str());
  ImGui::PopFont();
  ui.thing("scenes heading");
  ImGui::SameLine();
  ImGui::SetCursorPosX(left + room - button);
  if (ends) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_TabActive));
  if (ui.button(label.c_str(), "lesson.next_scene", here + 1 < count, "The next scene   Ctrl+PageDown"))
    ui.act("lesson.next_scene");
  if (ends) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRectFilled({low.x, high.y - ui.px(2.5)}, high, ui.color(Role::current));
    ImGui::PopStyleColor();
  }
}

// Where there is little height, only where the next scene is wanted.
bool relevant(const Player& player) { return player.scene_count() > 1; }

double wanted(const Ui&, double) { return 38; }

}  // namespace

const Panel& panel_scenes() {
  static const Panel panel{"scenes", "Scenes", Slot::foot, 5, draw, relevant, wanted, 0, true};
  return panel;
}

}  // namespace blossom
