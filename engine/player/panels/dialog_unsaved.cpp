// Before edits are lost.
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

void draw(Ui& ui) {
  if (ui.player().session() == nullptr) return close_dialog(ui);
  if (!begin_dialog(ui, "Your edits are not saved", 460)) return;
  quiet_text(ui, "You have changed the inputs of \u201C" + ui.player().session()->document().title() +
                     "\u201D. Save them as a lesson of your own, or go on without them.");
  ImGui::Dummy({0, ui.px(4)});
  const auto wide = [&](const char* label, const char* name) {
    const bool pressed = ImGui::Button(label, {ImGui::GetContentRegionAvail().x, 0});
    ui.thing(name);
    return pressed;
  };
  ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_TabActive));
  ImGui::PushFont(ui.bold());
  if (wide("Keep them as a lesson ...", "dialog ok"))
    ui.send([](Player& player) { player.dialog = Dialog::save_lesson; });
  ImGui::PopFont();
  ImGui::PopStyleColor();
  ImGui::SetItemDefaultFocus();
  if (wide("Go on without them", "dialog discard")) ui.send([](Player& player) { proceed_after_unsaved(player); });
  if (wide("Cancel", "dialog cancel")) close_dialog(ui);
  end_dialog();
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::unsaved; }

}  // namespace

const Panel& panel_dialog_unsaved() {
  static const Panel panel{"unsaved", "Unsaved edits", Slot::float_, 50, draw, is_relevant};
  return panel;
}

}  // namespace blossom
