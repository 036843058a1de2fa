#include "export/export.hpp"

#include <algorithm>

#include "export/export_staging.hpp"

namespace blossom {

const LessonFormat* find_lesson_format(std::string_view id) {
  const auto found = std::ranges::find_if(lesson_formats(), [&](const LessonFormat* f) { return f->id == id; });
  return found != lesson_formats().end() ? *found : nullptr;
}

Checked<LessonExported> write_pages(
    const Story& story, const std::filesystem::path& folder, std::string_view extension,
    const LessonExportOptions& options,
    const std::function<Checked<bool>(const Scene&, const std::filesystem::path&)>& draw) {
  auto staging = Staging::open(folder);
  if (!staging) return staging.diagnostics;
  const std::size_t count = story.step_count();
  std::size_t done = 0;
  for (const StoryScene& scene : story.scenes) {
    for (const StoryStep& step : scene.steps) {
      const std::filesystem::path file = staging->path(step_file_name(story, scene, step.step, extension));
      const auto drawn = draw(scene.page(step, story.title, options.width, options.height), file);
      if (!drawn) return staging->in_place(drawn.diagnostics);
      if (!report_progress(options, ++done, count)) return stopped();
    }
  }
  auto files = staging->publish();
  if (!files) return files.diagnostics;
  return LessonExported{*std::move(files), {}};
}

std::string step_file_name(const Story& story, const StoryScene& scene, std::uint32_t step,
                           std::string_view extension) {
  const std::size_t digits = std::to_string(scene.recording->last()).size();
  std::string number = std::to_string(step);
  number.insert(0, digits - number.size(), '0');
  return story.id + (scene.id.empty() ? "-" : "-" + scene.id + "-") + number + std::string(extension);
}

bool report_progress(const LessonExportOptions& options, std::size_t done, std::size_t of) {
  return !options.progress || options.progress(done, of);
}

Diagnostics stopped() { return {{"", 0, 0, "", "the export was stopped; nothing is written"}}; }

}  // namespace blossom
