#pragma once
// What `blossom export` is asked for, read and checked.

#include <filesystem>
#include <string>
#include <vector>

#include "app/input.hpp"
#include "app/page_look.hpp"
#include "export/export.hpp"

namespace blossom {

// As typed.
struct ExportOptions {
  SubjectOptions subject;
  PageLookOptions look;
  std::vector<std::string> to;
  std::string out, steps, fps, seconds, per_page, progress;
  bool all = false, decimals = false, no_checkpoints = false;
};
void add_export_options(CLI::App&, ExportOptions&);

struct ExportRequest {
  std::vector<const LessonFormat*> formats;
  std::filesystem::path out;  // empty: in the working folder
  bool into_folder = false;   // `out` is a folder for what is named after the lesson
  bool all = false;           // lessons, not one
  std::uint32_t first = 0, last = UINT32_MAX;
  bool progress_lines = false;
  LessonExportOptions options;

  // Where a format of a lesson goes.
  std::filesystem::path place(const LessonFormat&, const std::string& lesson) const;
};
// Adds all that is wrong. The app knows what was typed.
ExportRequest read_export_options(const CLI::App&, const ExportOptions&, Diagnostics&);

}  // namespace blossom
