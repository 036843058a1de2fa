// A lesson for those who have no Blossom: as a page, a film, a handout, pictures.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "export/export.hpp"
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

constexpr int least_width = 480, least_height = 360, longest_side = 16384;
constexpr double most_pixels = 64e6;

struct Fields {
  std::string format = "html";
  Target file;
  std::string steps, size;
  int per_page = 2;
  std::string theme;
  std::string lesson;      // whose fields these are
  std::uint32_t last = 0;  // step, of all its scenes
};

bool takes_option(const Fields& fields, unsigned option) {
  const LessonFormat* format = find_lesson_format(fields.format);
  return format != nullptr && (format->takes & option) != 0;
}

std::string without_blanks(std::string text) {
  std::erase(text, ' ');
  return text;
}

std::optional<int> whole(std::string_view text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

// "3..9", "3..", "..9" or "7".
std::string wrong_with_steps(const std::string& typed, std::uint32_t last) {
  if (typed.empty()) return {};
  const std::string like = "Steps are written like 3..9, 3.., ..9 or 7.";
  const std::size_t dots = typed.find("..");
  const std::string from = typed.substr(0, dots), to = dots == std::string::npos ? from : typed.substr(dots + 2);
  if (from.empty() && to.empty()) return like;
  const auto first = from.empty() ? std::optional(0) : whole(from);
  const auto behind = to.empty() ? std::optional(static_cast<int>(last)) : whole(to);
  if (!first || !behind || *first < 0 || *behind < 0) return like;
  if (*first > static_cast<int>(last)) return "The last step is " + std::to_string(last) + ".";
  return *first > *behind ? "The first of the steps is behind the last." : std::string();
}

// "1120x700".
std::string wrong_with_size(const std::string& typed) {
  if (typed.empty()) return {};
  const std::size_t x = typed.find('x');
  const auto width = whole(typed.substr(0, x)),
             height = x == std::string::npos ? std::nullopt : whole(typed.substr(x + 1));
  if (!width || !height) return "A size is written like 1120x700.";
  if (*width < least_width || *height < least_height)
    return "The smallest size is " + std::to_string(least_width) + "x" + std::to_string(least_height) + ".";
  const bool fits = *width <= longest_side && *height <= longest_side && 1.0 * *width * *height <= most_pixels;
  return fits ? std::string() : "That is too large: at most 64 million pixels.";
}

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
    if (radio(ui, std::string(format->title), "dialog format " + std::string(format->id), chosen)) {
      fields.format = format->id;
      fields.file.text = named(fields.file.text, *format);
    }
    ImGui::SameLine(ui.px(178));
    ImGui::PushStyleColor(ImGuiCol_Text, ui.ink(Role::text_quiet));
    ImGui::TextUnformatted(shortened(std::string(format->summary), ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopStyleColor();
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", std::string(format->summary).c_str());
  }
  ImGui::EndChild();
}

// What is asked of the format, beside each other, each under its label.
void format_fields(Ui& ui, Fields& fields) {
  const float width = std::floor((ImGui::GetContentRegionAvail().x - ui.px(12)) / 2);
  const ImVec2 at = ImGui::GetCursorPos();
  const auto label = [&](float x, const char* words) {
    ImGui::SetCursorPos({x, at.y});
    ImGui::TextUnformatted(words);
    ImGui::SetCursorPosX(x);
  };
  const auto field = [&](float x, const char* words, const char* name, std::string& text, const char* hint) {
    label(x, words);
    ImGui::SetNextItemWidth(width);
    ImGui::PushID(name);
    ImGui::InputTextWithHint("##field", hint, &text);
    ImGui::PopID();
    ui.thing(name);
  };
  field(at.x, "Steps", "dialog steps", fields.steps, "all; or 3..9");
  const float second = at.x + width + ui.px(12);
  if (takes_option(fields, export_use::size)) field(second, "Size", "dialog size", fields.size, "1120x700");
  if (!takes_option(fields, export_use::per_page)) return;
  label(second, "Steps on a page");
  for (const int count : {1, 2, 4, 6}) {
    if (count > 1) ImGui::SameLine();
    const std::string words = std::to_string(count);
    if (radio(ui, words, "dialog per page " + words, fields.per_page == count)) fields.per_page = count;
  }
}

void draw_options(Ui& ui, Fields& fields) {
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted("Colours");
  for (const auto& [name, title] : theme_list) {
    ImGui::SameLine();
    if (radio(ui, std::string(title), "dialog theme " + std::string(name), fields.theme == name)) fields.theme = name;
  }
  format_fields(ui, fields);
}

std::string wrong_with(const Fields& fields, const LessonFormat* format) {
  if (format == nullptr) return "Choose a format.";
  if (auto wrong = wrong_with_steps(without_blanks(fields.steps), fields.last); !wrong.empty()) return wrong;
  if (takes_option(fields, export_use::size))
    if (auto wrong = wrong_with_size(without_blanks(fields.size)); !wrong.empty()) return wrong;
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
    if (text.empty()) return;
    options.emplace_back(option);
    options.push_back(text);
  };
  add("--steps", without_blanks(fields.steps));
  if (takes_option(fields, export_use::size)) add("--size", without_blanks(fields.size));
  if (takes_option(fields, export_use::per_page)) add("--per-page", std::to_string(fields.per_page));
  const auto languages = player.languages();
  if (std::ranges::find(languages, player.language()) != languages.end())
    add("--language", std::string(player.language()));
  if (!player.settings.exact) options.emplace_back("--decimals");
  return options;
}

std::uint32_t last_step(const Player& player) {
  std::uint32_t last = player.session()->last();
  for (std::size_t scene = 0; scene < player.scene_count(); ++scene) {
    if (scene == player.scene()) continue;
    Document document = player.session()->document();
    document.show_scene(scene);
    if (const auto made = Recording::make(*document.algorithm, document.inputs, false))
      last = std::max(last, (*made)->last());
  }
  return last;
}

// What was typed stays while the same lesson is open: who is told of a mistake is to correct it, not to begin anew.
void begin(Fields& fields, const Player& player) {
  const Document& document = player.session()->document();
  fields.last = last_step(player);
  if (const std::string lesson = document.file.string() + " " + document.id(); fields.lesson != lesson) {
    const std::uint32_t last = fields.last;
    fields = {};
    fields.lesson = lesson;
    fields.last = last;
    fields.theme = player.settings.theme;
    fields.file = {folder_to_save(player), document.id(), {}};
  }
  fields.file.armed.clear();
  const LessonFormat* format = find_lesson_format(fields.format);
  if (format == nullptr && !lesson_formats().empty()) fields.format = (format = lesson_formats().front())->id;
  if (format != nullptr) fields.file.text = named(fields.file.text, *format);
}

void draw(Ui& ui) {
  static Fields fields;
  const Player& player = ui.player();
  const Session* session = player.session();
  if (session == nullptr) return close_dialog(ui);
  if (!begin_dialog(ui, "Export the lesson", 640)) return;
  if (dialog_opens()) begin(fields, player);
  draw_formats(ui, fields);
  const LessonFormat* format = find_lesson_format(fields.format);
  const bool folder = format != nullptr && format->many_files;
  const bool entered = dialog_field(ui, folder ? "Folder" : "File", "dialog file", fields.file.text, true);
  quiet_text(ui, "in " + printable(fields.file.path().parent_path().string()));
  draw_options(ui, fields);

  const std::string wrong = wrong_with(fields, format);
  const bool asks = wrong.empty() && !folder && fields.file.asks();
  if (!wrong.empty()) {
    dialog_warning(ui, wrong);
    ui.thing("dialog wrong");
  } else if (asks) {
    dialog_warning(ui, "There is a file of this name already. Press Replace to write over it.");
  } else {
    quiet_text(ui, player.unsaved() ? "With the inputs as they are now." : " ");
  }
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
