// The picture of the step as a file.
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

void draw(Ui& ui) {
  static Target file;
  const Player& player = ui.player();
  const Session* session = player.session();
  if (session == nullptr && !player.in_studio()) return close_dialog(ui);
  if (!begin_dialog(ui, "Save the picture", 520)) return;
  if (dialog_opens()) {
    const std::string name =
        session != nullptr ? session->document().id() + "-" + std::to_string(session->step())
                           : (player.studio()->file().empty() ? "scene" : player.studio()->file().stem().string());
    file = {folder_to_save(player), name + ".png", {}};
  }
  quiet_text(ui, session != nullptr ? "The page of step " + std::to_string(session->step()) +
                                          ": the picture with the scheme, the code and what is said of it."
                                    : "The scene as it is looked at now, with its title and its legend.");
  ImGui::Dummy({0, ui.px(2)});
  const bool entered = dialog_field(ui, "File", "dialog file", file.text, true);
  quiet_text(ui, "in " + printable(file.path().parent_path().string()));
  std::filesystem::path name = file.text;
  const auto kind = [&](const char* label, const char* extension, const char* thing) {
    if (radio(ui, label, thing, name.extension() == extension)) file.text = name.replace_extension(extension).string();
  };
  kind("PNG, for the screen and for slides", ".png", "dialog png");
  kind("SVG, for print at any size", ".svg", "dialog svg");

  if (const auto path = ask_to_save(ui, file, file.wrong({".png", ".svg"}), entered))
    ui.send([path = *path](Player& p) {
      p.dialog = Dialog::none;  // what goes wrong is said in the window
      p.save_picture(path);
    });
  end_dialog();
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::save_picture; }

}  // namespace

const Panel& panel_dialog_save_picture() {
  static const Panel panel{"save-picture", "Save the picture", Slot::float_, 53, draw, is_relevant};
  return panel;
}

}  // namespace blossom
