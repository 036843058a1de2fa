// The edited inputs as a lesson of its own.
#include <algorithm>

#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

bool is_id_letter(char c) { return ('a' <= c && c <= 'z') || ('0' <= c && c <= '9') || c == '-'; }

// The rule of read_id(), said beside the field at once.
std::string wrong_id(const std::string& id) {
  if (id.empty()) return "Give the lesson a short name.";
  if (id.size() > 64) return "The short name has at most 64 letters.";
  if (!std::ranges::all_of(id, is_id_letter)) return "The short name has only a-z, 0-9 and -, such as de-boor-2.";
  return {};
}

std::string id_like(std::string text) {
  for (char& c : text) {
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!is_id_letter(c)) c = '-';
  }
  if (text.size() > 57) text.resize(57);
  return text.ends_with("-edited") ? text : text + "-edited";
}

struct Fields {
  std::string id, title;
  Target file;
  bool named = false;  // the file by the person, not after the id
};

void draw(Ui& ui) {
  static Fields fields;
  const Session* session = ui.player().session();
  if (session == nullptr) return close_dialog(ui);
  if (!begin_dialog(ui, "Save as a lesson", 560)) return;
  if (dialog_opens()) {
    fields = {};
    fields.id = id_like(session->document().id());
    fields.title = session->document().title();
    fields.file = {folder_to_save(ui.player()), fields.id + ".json", {}};
  }
  quiet_text(ui, "A new lesson with the inputs as they are now. Blossom can open it, and so can others.");
  ImGui::Dummy({0, ui.px(2)});
  bool entered = dialog_field(ui, "Title", "dialog title", fields.title, true);
  const std::string id_before = fields.id;
  entered |= dialog_field(ui, "Short name", "dialog id", fields.id, false, "de-boor-2");
  if (fields.id != id_before && !fields.named) fields.file.text = fields.id + ".json";
  const std::string file_before = fields.file.text;
  entered |= dialog_field(ui, "File", "dialog file", fields.file.text);
  fields.named = fields.named || fields.file.text != file_before;
  quiet_text(ui, "in " + printable(fields.file.path().parent_path().string()));

  std::string wrong = fields.title.find_first_not_of(" \t") == std::string::npos ? "Give the lesson a title." : "";
  if (wrong.empty()) wrong = wrong_id(fields.id);
  if (wrong.empty()) wrong = fields.file.wrong({".json"});
  if (const auto path = ask_to_save(ui, fields.file, wrong, entered))
    ui.send([file = *path, id = fields.id, title = fields.title](Player& player) {
      player.dialog = Dialog::none;  // what goes wrong is said in the window
      player.save_lesson(file, id, title);
    });
  end_dialog();
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::save_lesson; }

}  // namespace

const Panel& panel_dialog_save_lesson() {
  static const Panel panel{"save-lesson", "Save as a lesson", Slot::float_, 52, draw, is_relevant};
  return panel;
}

}  // namespace blossom
