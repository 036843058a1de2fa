#pragma once
// Lessons for other programs: pictures, films, handouts, pages. One format is one file of this folder, which defines
// `const LessonFormat& lesson_NAME()` for a file NAME.cpp.

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "export/story.hpp"
#include "render/theme.hpp"

namespace blossom {

// Told what is done of how much; false: it is to stop, and nothing is written.
using ExportProgress = std::function<bool(std::size_t done, std::size_t of)>;

struct LessonExportOptions {
  const Theme* theme = nullptr;       // never none
  double width = 1120, height = 700;  // of a page
  double scale = 1;                   // pixels for each of its units
  double frames_per_second = 0;       // of films; 0: what the format has by default
  double seconds_per_step = 0;        // likewise
  int per_page = 2;                   // steps on a page of a handout: 1, 2, 4 or 6
  bool checkpoints = true;            // questions are in it, where the format can hold them
  ExportProgress progress;            // may be empty
};

// What was written: names beside each other, the first of which is to be opened.
struct LessonExported {
  std::vector<std::filesystem::path> files;
  std::vector<std::string> notes;  // what was left out, as sentences
};

// The options that not every format has a use for.
namespace export_use {
inline constexpr unsigned size = 1, scale = 2, time = 4, per_page = 8;
}

struct LessonFormat {
  std::string_view id;         // "html", as `--to` takes it
  std::string_view title;      // "Web page", as a menu has it
  std::string_view extension;  // ".html"
  bool many_files = false;     // `out` is a folder; otherwise a file
  std::string_view summary;    // "one self-contained page that steps, plays and asks"
  // Diagnostics without a file's name are about the machine (an encoder that is missing, a full disk); nothing half
  // written is left behind.
  Checked<LessonExported> (*write)(const Story&, const std::filesystem::path& out,
                                   const LessonExportOptions&) = nullptr;
  unsigned takes = 0;  // of export_use
};

const std::vector<const LessonFormat*>& lesson_formats();
const LessonFormat* find_lesson_format(std::string_view id);

// What the file of a step is called: "ID-07.svg"; of several scenes "ID-SCENE-07.svg".
std::string step_file_name(const Story&, const StoryScene&, std::uint32_t step, std::string_view extension);

// For formats of many files: each step's page is drawn into a file of its own. Files of other names in the folder stay.
// All of them come to their places at the end.
Checked<LessonExported> write_pages(
    const Story&, const std::filesystem::path& folder, std::string_view extension, const LessonExportOptions&,
    const std::function<Checked<bool>(const Scene&, const std::filesystem::path&)>& draw);

// Calls the progress, if there is one; false: stop.
bool report_progress(const LessonExportOptions&, std::size_t done, std::size_t of);
// What is said of an export that was stopped.
Diagnostics stopped();

}  // namespace blossom
