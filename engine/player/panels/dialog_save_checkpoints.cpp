// The answers to a lesson's questions as a file to hand in.
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

void draw(Ui& ui) {
  static Target file;
  const Player& player = ui.player();
  if (player.session() == nullptr || player.checkpoints().items().empty()) return close_dialog(ui);
  if (!begin_dialog(ui, "Save the answers", 520)) return;
  if (dialog_opens()) file = {folder_to_save(player), player.session()->document().id() + "-answers.json", {}};
  quiet_text(ui, std::to_string(player.checkpoints().answered()) + " of " +
                     std::to_string(player.checkpoints().items().size()) +
                     " questions are answered. The file is what one hands in; of each question the first answer "
                     "counts.");
  ImGui::Dummy({0, ui.px(2)});
  const bool entered = dialog_field(ui, "File", "dialog file", file.text, true);
  quiet_text(ui, "in " + printable(file.path().parent_path().string()));
  if (const auto path = ask_to_save(ui, file, file.wrong({".json"}), entered))
    ui.send([path = *path](Player& p) {
      p.dialog = Dialog::none;  // what goes wrong is said in the window
      p.save_checkpoints(path);
    });
  end_dialog();
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::save_checkpoints; }

}  // namespace

const Panel& panel_dialog_save_checkpoints() {
  static const Panel panel{"save-checkpoints", "Save the answers", Slot::float_, 55, draw, is_relevant};
  return panel;
}

}  // namespace blossom
