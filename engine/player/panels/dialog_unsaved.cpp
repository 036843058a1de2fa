// Before edits are lost.
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

void three_ways(Ui& ui, const char* save, const char* go_on, std::function<void(Player&)> keep) {
  ImGui::Dummy({0, ui.px(4)});
  const auto wide = [&](const char* label, const char* name) {
    const bool pressed = ImGui::Button(label, {ImGui::GetContentRegionAvail().x, 0});
    ui.thing(name);
    return pressed;
  };
  ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_TabActive));
  ImGui::PushFont(ui.bold());
  if (wide(save, "dialog ok")) ui.send(std::move(keep));
  ImGui::PopFont();
  ImGui::PopStyleColor();
  ImGui::SetItemDefaultFocus();
  if (wide(go_on, "dialog discard")) ui.send([](Player& p) { proceed_after_unsaved(p); });
  if (wide("Cancel", "dialog cancel")) close_dialog(ui);
  end_dialog();
}

void draw_for_scene(Ui& ui) {
  if (!begin_dialog(ui, "Your scene is not saved", 460)) return;
  const Studio& studio = *ui.player().studio();
  quiet_text(ui, "You have changed \u201C" + studio.title() + "\u201D. Save it, or go on without the changes.");
  three_ways(ui, studio.file().empty() ? "Save the scene ..." : "Save the scene", "Go on without saving",
             [](Player& p) { p.save_scene(); });
}

void draw(Ui& ui) {
  const Player& player = ui.player();
  if (player.asks_about_scene() && player.studio() != nullptr) return draw_for_scene(ui);
  if (player.session() == nullptr) return close_dialog(ui);
  const bool edits = player.session()->unsaved();
  if (!begin_dialog(ui, edits ? "Your edits are not saved" : "Your answers are not saved", 460)) return;
  const std::string title = "\u201C" + player.session()->document().title() + "\u201D";
  quiet_text(
      ui,
      edits ? "You have changed the inputs of " + title + ". Save them as a lesson of your own, or go on without them."
            : "You have answered questions of " + title + ". Save the answers as a file, or go on without them.");
  three_ways(ui, edits ? "Keep them as a lesson ..." : "Save the answers ...", "Go on without them",
             [edits](Player& p) { p.dialog = edits ? Dialog::save_lesson : Dialog::save_answers; });
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::unsaved; }

}  // namespace

const Panel& panel_dialog_unsaved() {
  static const Panel panel{"unsaved", "Unsaved edits", Slot::float_, 50, draw, is_relevant};
  return panel;
}

}  // namespace blossom
