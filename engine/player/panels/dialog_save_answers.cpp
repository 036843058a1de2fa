// The answers to an exercise as a file to hand in.
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

void draw(Ui& ui) {
  static Target file;
  const Session* session = ui.player().session();
  const Prediction* prediction = session != nullptr ? session->prediction() : nullptr;
  if (prediction == nullptr) return close_dialog(ui);
  if (!begin_dialog(ui, "Save the answers", 520)) return;
  if (dialog_opens()) file = {folder_to_save(ui.player()), prediction->exercise().id + "-answers.json", {}};
  std::size_t answered = 0;
  for (std::size_t q = 0; q < prediction->questions().size(); ++q)
    if (const auto& attempt = prediction->attempt(q)) answered += attempt->shown ? 0 : 1;
  quiet_text(ui, std::to_string(answered) + " of " + std::to_string(prediction->questions().size()) +
                     " values are answered. The file is what one hands in; values that were shown are left out.");
  ImGui::Dummy({0, ui.px(2)});
  const bool entered = dialog_field(ui, "File", "dialog file", file.text, true);
  quiet_text(ui, "in " + printable(file.path().parent_path().string()));
  if (const auto path = ask_to_save(ui, file, file.wrong({".json"}), entered))
    ui.send([path = *path](Player& player) {
      player.dialog = Dialog::none;  // what goes wrong is said in the window
      player.save_answers(path);
    });
  end_dialog();
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::save_answers; }

}  // namespace

const Panel& panel_dialog_save_answers() {
  static const Panel panel{"save-answers", "Save the answers", Slot::float_, 54, draw, is_relevant};
  return panel;
}

}  // namespace blossom
