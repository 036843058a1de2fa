#include "app/export_options.hpp"

#include <algorithm>
#include <charconv>

namespace blossom {
namespace {

namespace fs = std::filesystem;

std::string format_names() {
  std::string names;
  for (const LessonFormat* format : lesson_formats()) names += (names.empty() ? "" : ", ") + std::string(format->id);
  return names;
}

std::string formats_help() {
  std::string text = "Formats (--to):\n";
  for (const LessonFormat* format : lesson_formats()) {
    std::string id(format->id);
    id.resize(6, ' ');
    text += "  " + id + std::string(format->summary) + "\n";
  }
  return text;
}

std::optional<std::uint32_t> whole(std::string_view text) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(number) : std::nullopt;
}

// "3..9", "3..", "..9", "7".
bool read_steps(const std::string& text, std::uint32_t& first, std::uint32_t& last) {
  const auto dots = text.find("..");
  if (dots == std::string::npos) {
    const auto only = whole(text);
    first = last = only.value_or(0);
    return only.has_value();
  }
  const std::string from = text.substr(0, dots), to = text.substr(dots + 2);
  if (from.empty() && to.empty()) return false;
  const auto begin = from.empty() ? 0 : whole(from), end = to.empty() ? UINT32_MAX : whole(to);
  if (!begin || !end || *begin > *end) return false;
  first = *begin;
  last = *end;
  return true;
}

double read_number(const std::string& option, const std::string& text, double least, double most,
                   Diagnostics& mistakes) {
  if (text.empty()) return 0;
  const auto number = parse_number<double>(text);
  if (number && least <= *number && *number <= most) return *number;
  mistakes.push_back(
      {"", 0, 0, option,
       "must be a number from " + format_short(least, 3) + " to " + format_short(most, 3) + ", not " + excerpt(text)});
  return 0;
}

void read_formats(const ExportOptions& typed, ExportRequest& request, Diagnostics& mistakes) {
  std::vector<std::string> ids;
  for (const LessonFormat* format : lesson_formats()) ids.emplace_back(format->id);
  for (const std::string& id : typed.to) {
    const LessonFormat* format = find_lesson_format(id);
    if (format == nullptr) {
      const auto near = did_you_mean(id, ids);
      mistakes.push_back({"", 0, 0, "--to",
                          excerpt(id) + " is no format; " + (near ? "did you mean \"" + *near + "\"? " : "") +
                              "there are " + format_names()});
    } else if (std::ranges::find(request.formats, format) == request.formats.end()) {
      request.formats.push_back(format);
    }
  }
  if (!typed.to.empty()) return;
  const std::string extension = fs::path(typed.out).extension().string();
  for (const LessonFormat* format : lesson_formats())
    if (!extension.empty() && format->extension == extension) request.formats.push_back(format);
  if (request.formats.empty())
    mistakes.push_back(
        {"", 0, 0, "--to",
         (extension.empty() ? "says which format: "
                            : "must say which format, for " + excerpt(extension) + " is the extension of none: ") +
             format_names()});
}

// Whether an extension is that of a format.
bool names_a_file(const std::string& extension) {
  return std::ranges::any_of(lesson_formats(), [&](const LessonFormat* f) { return f->extension == extension; });
}

void read_out(const ExportOptions& typed, ExportRequest& request, Diagnostics& mistakes) {
  request.out = typed.out;
  const auto mistake = [&](const std::string& message) { mistakes.push_back({"", 0, 0, "--out", message}); };
  std::error_code error;
  const auto status = fs::status(request.out, error);
  const bool there = !typed.out.empty() && fs::exists(status);
  if (there && !fs::is_directory(status) && !fs::is_regular_file(status)) {
    mistake(excerpt(typed.out) + " must be a file or a folder, not a device");
    return;
  }
  if (typed.out == "-") {
    mistake("must be a file or a folder; an export is not written to the terminal");
    return;
  }
  const bool many = typed.all || request.formats.size() > 1 || typed.to.size() > 1;
  const std::string extension = request.out.extension().string();
  request.into_folder = many || extension.empty() || fs::is_directory(status);
  if (request.formats.empty()) return;
  const LessonFormat& format = *request.formats.front();
  if ((request.into_folder || format.many_files) && there && fs::is_regular_file(status)) {
    mistake("must be a folder; " + excerpt(typed.out) + " is a file");
  } else if (!many && format.many_files && extension == format.extension) {
    mistake("must be a folder, for " + std::string(format.id) +
            " is a file for each step; for the picture of one step see `blossom render --help`");
  } else if (!request.into_folder && !format.many_files && extension != format.extension) {
    mistake("must end in " + std::string(format.extension) + " for --to " + std::string(format.id) + ", not in " +
            excerpt(extension) + "; or be a folder");
  } else if (!there && (request.into_folder || format.many_files) && names_a_file(extension)) {
    mistake("must be a folder, and " + excerpt(typed.out) + " would be one with a file's name");
  }
}

// An option that none of the formats has a use for, as far as it was typed.
void refuse_useless(const CLI::App& app, const ExportRequest& request, Diagnostics& mistakes) {
  if (request.formats.empty()) return;
  const auto refuse = [&](const std::string& option, unsigned use, const std::string& about) {
    if (app.count(option) == 0) return;
    if (std::ranges::any_of(request.formats, [&](const LessonFormat* f) { return (f->takes & use) != 0; })) return;
    std::string names;
    for (const LessonFormat* format : lesson_formats())
      if ((format->takes & use) != 0) names += (names.empty() ? "" : ", ") + std::string(format->id);
    mistakes.push_back(
        {"", 0, 0, option,
         about + " (" + names + "); " + std::string(request.formats.front()->id) + " has no use for it"});
  };
  refuse("--size", export_use::size, "is for pictures and films");
  refuse("--scale", export_use::scale, "is for pictures of pixels");
  refuse("--fps", export_use::time, "is for films");
  refuse("--seconds", export_use::time, "is for films");
  refuse("--per-page", export_use::per_page, "is for handouts");
}

}  // namespace

void add_export_options(CLI::App& app, ExportOptions& options) {
  add_subject_options(app, options.subject);
  auto* lesson = app.get_option("LESSON");
  auto* all = app.add_flag("--all", options.all, "All lessons of lessons/, each in a file (or folder) of its own")
                  ->excludes(lesson)
                  ->excludes(app.get_option("--algorithm"));
  app.get_option("--scene")->description("Only this scene, by its id or number")->excludes(all);
  app.get_option("--language")->remove_needs(lesson);
  app.add_option("--to", options.to, "What to write: one format or several, see below; or --out tells by its extension")
      ->delimiter(',');
  app.add_option("--out", options.out,
                 "The file, or the folder for several; without it one called after the lesson, here");
  app.add_option("--steps", options.steps, "Only these: 3..9, 3.., ..9 or 7; they begin at 0");
  add_page_look_options(app, options.look);
  app.add_flag("--decimals", options.decimals, "Numbers as decimals instead of fractions");
  app.add_flag("--no-checkpoints", options.no_checkpoints, "Without the lesson's questions");
  app.add_option("--fps", options.fps, "Of films: pictures a second, 1 to 60 (by default 30, of GIF 20)");
  app.add_option("--seconds", options.seconds,
                 "Of films: for each step, 0.1 to 600 (by default as long as its words are read)");
  app.add_option("--per-page", options.per_page, "Of handouts: steps on a page, 1, 2 (by default), 4 or 6");
  app.add_option("--progress", options.progress, "bar: on a terminal, when it takes long; lines: for programs")
      ->check(CLI::IsMember({"bar", "lines"}));
  app.footer(formats_help() +
             "\nExamples:\n"
             "  blossom export 22-de-boor --out de-boor.html\n"
             "  blossom export 22-de-boor --to mp4,gif --out films --size 1280x720 --theme dark\n"
             "  blossom export 22-de-boor --to pdf --steps 3..9 --per-page 4\n"
             "  blossom export my-lesson.json --to png --out pictures --scale 2\n"
             "  blossom export --all --to html --out site\n"
             "Films need the program ffmpeg. Files of the same names are replaced, each as a whole; what is stopped "
             "leaves\nnothing half written.\n"
             "Exit status: 0 done, 1 the input is at fault, 2 wrong usage, 3 the machine.");
}

fs::path ExportRequest::place(const LessonFormat& format, const std::string& lesson) const {
  if (!into_folder) return out;
  if (!format.many_files) return out / (lesson + std::string(format.extension));
  const bool alone = !out.empty() && formats.size() == 1 && !all;
  return alone ? out : out / (lesson + "-" + std::string(format.id));
}

ExportRequest read_export_options(const CLI::App& app, const ExportOptions& typed, Diagnostics& mistakes) {
  ExportRequest request;
  request.all = typed.all;
  read_formats(typed, request, mistakes);
  read_out(typed, request, mistakes);
  refuse_useless(app, request, mistakes);
  const PageLook look = read_page_look(typed.look, true, mistakes);
  LessonExportOptions& options = request.options;
  options.width = look.width;
  options.height = look.height;
  options.scale = look.scale;
  options.theme = look.theme;
  options.frames_per_second = read_number("--fps", typed.fps, 1, 60, mistakes);
  options.seconds_per_step = read_number("--seconds", typed.seconds, 0.1, 600, mistakes);
  options.checkpoints = !typed.no_checkpoints;
  const auto per_page = typed.per_page.empty() ? std::optional<std::uint32_t>(2) : whole(typed.per_page);
  if (per_page && (*per_page == 1 || *per_page == 2 || *per_page == 4 || *per_page == 6))
    options.per_page = static_cast<int>(*per_page);
  else
    mistakes.push_back({"", 0, 0, "--per-page", "must be 1, 2, 4 or 6, not " + excerpt(typed.per_page)});
  if (!typed.steps.empty() && !read_steps(typed.steps, request.first, request.last))
    mistakes.push_back(
        {"", 0, 0, "--steps",
         "must be like 3..9, 3.., ..9 or 7, the first not behind the last, not " + excerpt(typed.steps)});
  request.progress_lines = typed.progress == "lines";
  return request;
}

}  // namespace blossom
