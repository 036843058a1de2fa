#pragma once
// What the panels share in which things are dragged.

#include <imgui_internal.h>

#include <algorithm>
#include <string>
#include <vector>

#include "player/ui/ui.hpp"

namespace blossom {

// The mouse in a rectangle of the window that is being drawn, in page units of that rectangle; without an item of Dear
// ImGui, which would keep it from the sheet.
struct Mouse {
  const Ui& ui;
  ImVec2 origin;
  ViewSize size;

  glm::dvec2 page(ImVec2 at) const { return {ui.units(at.x - origin.x), ui.units(at.y - origin.y)}; }
  glm::dvec2 now() const { return page(ImGui::GetIO().MousePos); }
  glm::dvec2 pressed(int button) const { return page(ImGui::GetIO().MouseClickedPos[button]); }
  bool inside(glm::dvec2 at) const { return at.x >= 0 && at.y >= 0 && at.x < size.width && at.y < size.height; }
  bool over() const { return ImGui::IsWindowHovered() && !ImGui::IsAnyItemHovered() && inside(now()); }
  // The button is down since it was pressed here, on nothing that Dear ImGui knows.
  bool owns(int button) const {
    if (!ImGui::IsMouseDown(button) || !inside(pressed(button))) return false;
    if (button == 0) return ImGui::GetCurrentContext()->ActiveId == ImGui::GetCurrentWindow()->MoveId;
    return ImGui::IsWindowHovered();
  }
  bool dragged(int button) const {  // and not only clicked
    const float least = ui.px(3);
    return ImGui::GetIO().MouseDragMaxDistanceSqr[button] >= least * least;
  }
};

inline GripKeys grip_keys(const Player& player) {
  const ImGuiIO& io = ImGui::GetIO();
  return {io.KeyShift, io.KeyCtrl || player.settings.snap};
}

// Sends the drag of what is held, if it is another one than before.
inline void send_drag(Ui& ui, glm::dvec2 now, const GripKeys& keys) {
  const GripKeys before = ui.player().held_keys();
  if (now == ui.player().held_at() && keys.along == before.along && keys.snap == before.snap) return;
  ui.send([now, keys](Player& player) { player.drag(now, keys); });
}

inline const Spot* spot_at(const std::vector<Spot>& spots, glm::dvec2 at) {
  const Spot* found = nullptr;
  for (const Spot& spot : spots)
    if (at.x >= spot.x && at.x < spot.x + spot.width && at.y >= spot.y && at.y < spot.y + spot.height) found = &spot;
  return found;
}

// A line of words on a plate with its top left here, kept within low and high.
inline void draw_tag(const Ui& ui, ImDrawList& list, ImVec2 at, const std::string& words, Role role, ImVec2 low,
                     ImVec2 high) {
  ImFont* font = ui.small();
  const ImVec2 pad{ui.px(6), ui.px(3)};
  const float widest = std::max(high.x - low.x - 2 * pad.x, ui.px(80));
  const ImVec2 room = font->CalcTextSizeA(font->FontSize, FLT_MAX, widest, words.c_str());
  const ImVec2 size{room.x + 2 * pad.x, room.y + 2 * pad.y};
  at.x = std::clamp(at.x, low.x, std::max(low.x, high.x - size.x));
  at.y = std::clamp(at.y, low.y, std::max(low.y, high.y - size.y));
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_PopupBg), ui.px(4));
  list.AddRect(at, {at.x + size.x, at.y + size.y}, ui.color(role), ui.px(4), 0, ui.px(1));
  list.AddText(font, font->FontSize, {at.x + pad.x, at.y + pad.y}, ui.ink(role), words.c_str(), nullptr, widest);
}

}  // namespace blossom
