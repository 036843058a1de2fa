// The run itself, for other programs: every value, where it comes from, and the words of the algorithm
// (algorithms/trace_json.hpp). Of several scenes one file each.

#include "base/json.hpp"
#include "export/export.hpp"
#include "export/export_staging.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

Checked<LessonExported> write(const Story& story, const fs::path& out, const LessonExportOptions& options) {
  auto staging = Staging::open(out.parent_path());
  if (!staging) return staging.diagnostics;
  std::size_t done = 0;
  for (const StoryScene& scene : story.scenes) {
    fs::path name = out.filename();
    if (story.scenes.size() > 1) name = out.stem().string() + "-" + scene.id + out.extension().string();
    const auto written = write_file(staging->path(name), scene.recording->trace_json());
    if (!written) return staging->in_place(written.diagnostics);
    if (!report_progress(options, ++done, story.scenes.size())) return stopped();
  }
  auto files = staging->publish();
  if (!files) return files.diagnostics;
  LessonExported exported{*std::move(files), {}};
  for (const StoryScene& scene : story.scenes) {
    if (scene.steps.size() > scene.recording->last()) continue;
    exported.notes.push_back("A trace always has all steps, whatever steps are asked for.");
    break;
  }
  return exported;
}

}  // namespace

const LessonFormat& lesson_json() {
  static const LessonFormat format{
      "json", "Trace", ".json", false, "the run for other programs: every value and where it comes from", write};
  return format;
}

}  // namespace blossom
