// The scene of the studio as a file.
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

struct Fields {
  std::string title;
  Target file;
  bool named = false;  // the file by the person, not after the title
};

std::string file_like(const std::string& title) {
  std::string name;
  for (const char c : title) {
    const char small = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    const bool letter = ('a' <= small && small <= 'z') || ('0' <= small && small <= '9');
    if (letter)
      name += small;
    else if (!name.empty() && name.back() != '-')
      name += '-';
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return (name.empty() ? "scene" : name.substr(0, 60)) + ".json";
}

void draw(Ui& ui) {
  static Fields fields;
  const Studio* studio = ui.player().studio();
  if (studio == nullptr) return close_dialog(ui);
  if (!begin_dialog(ui, "Save the scene", 560)) return;
  if (dialog_opens()) {
    fields = {};
    fields.title = studio->workspace().title.empty() ? "My scene" : studio->workspace().title;
    const std::string name = studio->file().empty() ? file_like(fields.title) : studio->file().filename().string();
    fields.file = {folder_to_save(ui.player()), name, {}};
    fields.named = !studio->file().empty();
  }
  quiet_text(ui, "All things with how they are made and shown. Blossom can open it again, and so can others.");
  ImGui::Dummy({0, ui.px(2)});
  const std::string title_before = fields.title;
  bool entered = dialog_field(ui, "Title", "dialog title", fields.title, true);
  if (fields.title != title_before && !fields.named) fields.file.text = file_like(fields.title);
  const std::string file_before = fields.file.text;
  entered |= dialog_field(ui, "File", "dialog file", fields.file.text);
  fields.named = fields.named || fields.file.text != file_before;
  quiet_text(ui, "in " + printable(fields.file.path().parent_path().string()));

  std::string wrong = fields.title.find_first_not_of(" \t") == std::string::npos ? "Give the scene a title." : "";
  if (wrong.empty()) wrong = fields.file.wrong({".json"});
  if (const auto path = ask_to_save(ui, fields.file, wrong, entered))
    ui.send([file = *path, title = fields.title](Player& player) {
      player.dialog = Dialog::none;  // what goes wrong is said in the window
      player.save_scene(file, title);
    });
  end_dialog();
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::save_scene; }

}  // namespace

const Panel& panel_dialog_save_scene() {
  static const Panel panel{"save-scene", "Save the scene", Slot::float_, 59, draw, is_relevant};
  return panel;
}

}  // namespace blossom
