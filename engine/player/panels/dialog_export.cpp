// A lesson for those who have no Blossom: as a page, a film, a handout, pictures.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "export/export.hpp"
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

struct Fields {
  std::string format = "html";
  Target file;
  std::string steps, size;
  std::string theme;
};

// The name for a format: a file with its extension, or a folder.
std::string named(const std::string& text, const LessonFormat& format) {
  std::filesystem::path name = text;
  for (const LessonFormat* other : lesson_formats())
    if (name.extension() == other->extension) name.replace_extension();
  return name.string() + (format.many_files ? "" : std::string(format.extension));
}

// What is wanted most comes first.
std::vector<const LessonFormat*> ordered_formats() {
  static constexpr std::array<std::string_view, 10> order{"html", "pdf", "mp4", "webm", "gif",
                                                          "png",  "svg", "tex", "md",   "json"};
  auto formats = lesson_formats();
  std::ranges::stable_sort(formats, {},
                           [](const LessonFormat* format) { return std::ranges::find(order, format->id); });
  return formats;
}

void draw_formats(Ui& ui, Fields& fields) {
  const float row = ImGui::GetFrameHeightWithSpacing();
  const auto count = static_cast<float>(lesson_formats().size());
  const float height = std::min(count * row + ui.px(4), std::max(dialog_room(ui, ui.px(250)), 3 * row));
  ImGui::BeginChild("formats", {0, height}, false, ImGuiWindowFlags_NavFlattened);
  for (const LessonFormat* format : ordered_formats()) {
    const bool chosen = fields.format == format->id;
    if (ImGui::RadioButton(std::string(format->title).c_str(), chosen)) {
      fields.format = format->id;
      fields.file.text = named(fields.file.text, *format);
    }
    ui.thing("dialog format " + std::string(format->id));
    ImGui::SameLine(ui.px(178));
    ImGui::PushStyleColor(ImGuiCol_Text, ui.ink(Role::text_quiet));
    ImGui::TextUnformatted(shortened(std::string(format->summary), ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(format->summary).c_str());
  }
  ImGui::EndChild();
}

// Two fields beside each other, each under its label.
void two_fields(Ui& ui, Fields& fields) {
  const float width = std::floor((ImGui::GetContentRegionAvail().x - ui.px(12)) / 2);
  const ImVec2 at = ImGui::GetCursorPos();
  const auto field = [&](float x, const char* label, const char* name, std::string& text, const char* hint) {
    ImGui::SetCursorPos({x, at.y});
    ImGui::TextUnformatted(label);
    ImGui::SetCursorPosX(x);
    ImGui::SetNextItemWidth(width);
    ImGui::PushID(name);
    ImGui::InputTextWithHint("##field", hint, &text);
    ImGui::PopID();
    ui.thing(name);
  };
  field(at.x, "Steps", "dialog steps", fields.steps, "all; or 3..9");
  field(at.x + width + ui.px(12), "Size", "dialog size", fields.size, "1120x700");
}

void draw_options(Ui& ui, Fields& fields) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Colours");
  for (const auto& [name, title] : theme_list) {
    ImGui::SameLine();
    ImGui::PushID(name.data());
    if (ImGui::RadioButton(std::string(title).c_str(), fields.theme == name)) fields.theme = name;
    ImGui::PopID();
    ui.thing("dialog theme " + std::string(name));
  }
  two_fields(ui, fields);
}

std::string wrong_with(const Fields& fields, const LessonFormat* format) {
  if (format == nullptr) return "Choose a format.";
  if (!format->many_files) return fields.file.wrong({std::string(format->extension)});
  std::error_code error;
  if (fields.file.text.empty()) return "Give the folder a name.";
  const auto path = fields.file.path();
  if (std::filesystem::exists(path, error) && !std::filesystem::is_directory(path, error))
    return "This is a file; many files are written, into a folder.";
  if (!std::filesystem::is_directory(path.parent_path(), error))
    return "There is no folder " + printable(path.parent_path().string()) + ".";
  return {};
}

std::vector<std::string> options_of(const Fields& fields, const Player& player) {
  std::vector<std::string> options{"--theme", fields.theme};
  const auto add = [&](const char* option, const std::string& text) {
    if (text.find_first_not_of(' ') == std::string::npos) return;
    options.emplace_back(option);
    options.push_back(text);
  };
  add("--steps", fields.steps);
  add("--size", fields.size);
  const auto languages = player.languages();
  if (std::ranges::find(languages, player.language()) != languages.end())
    add("--language", std::string(player.language()));
  if (!player.settings.exact) options.emplace_back("--decimals");
  return options;
}

void draw(Ui& ui) {
  static Fields fields;
  const Player& player = ui.player();
  const Session* session = player.session();
  if (session == nullptr) return close_dialog(ui);
  if (!begin_dialog(ui, "Export the lesson", 640)) return;
  if (dialog_opens()) {
    fields = {};
    fields.theme = player.settings.theme;
    const LessonFormat* format = find_lesson_format(fields.format);
    if (format == nullptr && !lesson_formats().empty()) fields.format = (format = lesson_formats().front())->id;
    fields.file = {folder_to_save(player), session->document().id(), {}};
    if (format != nullptr) fields.file.text = named(fields.file.text, *format);
  }
  draw_formats(ui, fields);
  const LessonFormat* format = find_lesson_format(fields.format);
  const bool folder = format != nullptr && format->many_files;
  const bool entered = dialog_field(ui, folder ? "Folder" : "File", "dialog file", fields.file.text, true);
  quiet_text(ui, "in " + printable(fields.file.path().parent_path().string()));
  draw_options(ui, fields);

  const std::string wrong = wrong_with(fields, format);
  const bool asks = wrong.empty() && !folder && fields.file.asks();
  if (!wrong.empty())
    dialog_warning(ui, wrong);
  else if (asks)
    dialog_warning(ui, "There is a file of this name already. Press Replace to write over it.");
  else
    quiet_text(ui, player.unsaved() ? "With the inputs as they are now." : " ");
  const bool pressed = dialog_buttons(ui, asks ? "Replace" : "Export", wrong.empty());
  if ((pressed || entered) && wrong.empty() && (folder || fields.file.confirm()))
    ui.send([id = fields.format, out = fields.file.path(), options = options_of(fields, player)](Player& p) {
      p.dialog = Dialog::none;  // what goes wrong is said in the window
      p.export_lesson(id, out, options);
    });
  end_dialog();
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::export_lesson; }

}  // namespace

const Panel& panel_dialog_export() {
  static const Panel panel{"export", "Export the lesson", Slot::float_, 59, draw, is_relevant};
  return panel;
}

}  // namespace blossom
