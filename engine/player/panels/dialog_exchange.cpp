// Files of other programs, into the scene and out of it.
#include "exchange/format.hpp"
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

// Each format that can be read (or written), one below the other: what it is and what it holds.
void draw_formats(Ui& ui, bool reading, Target* target) {
  for (const ExchangeFormat* format : exchange_formats()) {
    if (reading ? format->import == nullptr : format->write == nullptr) continue;
    const std::string extension(format->extensions.front());
    if (target != nullptr) {
      if (ui.button(extension.c_str(), "dialog format " + std::string(format->id)))
        target->text = std::filesystem::path(target->text).replace_extension(extension).string();
      ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + ui.px(70), 0);
      ImGui::AlignTextToFramePadding();
    } else {
      ImGui::TextUnformatted(extension.c_str());
      ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + ui.px(70), 0);
    }
    ImGui::TextUnformatted(std::string(format->title).c_str());
    ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + ui.px(280), 0);
    quiet_text(ui, std::string(format->holds));
  }
}

struct Fields {
  Target file;
  bool only_chosen = false;
};

void draw_import(Ui& ui) {
  static Fields fields;
  if (!begin_dialog(ui, "Import into the scene", 660)) return;
  if (dialog_opens()) fields.file = {folder_to_save(ui.player()), "", {}};
  draw_formats(ui, true, nullptr);
  ImGui::Dummy({0, ui.px(4)});
  const bool entered = dialog_field(ui, "File", "dialog file", fields.file.text, true, "points.csv");
  quiet_text(ui, "in " + printable(fields.file.path().parent_path().string()));
  const auto path = fields.file.path();
  std::error_code error;
  const bool there = !fields.file.text.empty() && std::filesystem::is_regular_file(path, error);
  if (!fields.file.text.empty() && !there) dialog_warning(ui, "There is no such file.");
  if (there && format_of(path) == nullptr) dialog_warning(ui, "Its ending is of no format that can be imported.");
  const bool can = there && format_of(path) != nullptr;
  if (dialog_buttons(ui, "Import", can) || (entered && can))
    ui.send([path](Player& player) {
      player.dialog = Dialog::none;
      player.import_file(path);
    });
  end_dialog();
}

void draw_export(Ui& ui) {
  static Fields fields;
  const Studio* studio = ui.player().studio();
  if (studio == nullptr) return close_dialog(ui);
  if (!begin_dialog(ui, "Export for another program", 660)) return;
  if (dialog_opens()) {
    const std::string name = studio->file().empty() ? "scene" : studio->file().stem().string();
    fields = {{folder_to_save(ui.player()), name + ".obj", {}}, false};
  }
  draw_formats(ui, false, &fields.file);
  ImGui::Dummy({0, ui.px(4)});
  const bool entered = dialog_field(ui, "File", "dialog file", fields.file.text, true);
  quiet_text(ui, "in " + printable(fields.file.path().parent_path().string()));
  ImGui::Checkbox("Only what is chosen", &fields.only_chosen);
  ui.thing("dialog only-chosen");
  std::vector<std::string> extensions;
  for (const ExchangeFormat* format : exchange_formats())
    if (format->write != nullptr)
      for (const std::string_view extension : format->extensions) extensions.emplace_back(extension);
  if (const auto path = ask_to_save(ui, fields.file, fields.file.wrong(extensions), entered))
    ui.send([file = *path, chosen = fields.only_chosen](Player& player) {
      player.dialog = Dialog::none;
      player.export_file(file, chosen);
    });
  end_dialog();
}

void draw(Ui& ui) {
  if (ui.player().dialog == Dialog::import_file)
    draw_import(ui);
  else
    draw_export(ui);
}

bool is_relevant(const Player& player) {
  return player.dialog == Dialog::import_file || player.dialog == Dialog::export_file;
}

}  // namespace

const Panel& panel_dialog_exchange() {
  static const Panel panel{"exchange", "Import and export", Slot::float_, 58, draw, is_relevant};
  return panel;
}

}  // namespace blossom
