#include "export/story_links.hpp"

#include <algorithm>

#include "lesson/local_text.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

StoryLink link_to(const fs::path& file, const std::string& id, std::string_view language) {
  StoryLink link{printable(id), {}, {}, {}};
  const auto document = file.empty() ? Checked<JsonDocument>(Diagnostics{}) : JsonDocument::load(file);
  if (!document) return link;
  Diagnostics mistakes;
  const Cursor root(*document, mistakes);
  const Languages languages = read_languages(root);
  if (const auto title = root.optional("title"))
    if (const auto text = read_local_text(*title, languages)) link.title = printable(text->in(language));
  link.number = file_number(file.stem().string());
  return link;
}

}  // namespace

std::string file_number(const std::string& stem) {
  const std::size_t end = std::min(stem.find_first_not_of("0123456789"), stem.size());
  return end < stem.size() && stem[end] == '-' ? stem.substr(0, end) : std::string();
}

CourseTitles::CourseTitles(const fs::path& lesson, const CourseFolders& course, bool pages) : pages_(pages) {
  std::error_code error;
  if (fs::is_regular_file(lesson, error)) {
    lessons_.push_back(lesson.parent_path());
    exercises_ = folders_of_exercises(lesson);
  }
  lessons_.push_back(course.lessons);
  exercises_.push_back(course.exercises);
  for (const fs::path& folder : lessons_) index_.add_folder(folder);
  for (const fs::path& folder : exercises_) index_.add_folder(folder);
}

StoryLink CourseTitles::lesson(const std::string& id, std::string_view language) const {
  for (const fs::path& folder : lessons_) {
    const fs::path file = index_.lesson_file(folder, id);
    if (file.empty()) continue;
    StoryLink link = link_to(file, id, language);
    if (pages_ && folder == lessons_.front()) link.page = file.stem().string();
    return link;
  }
  return link_to({}, id, language);
}

StoryLink CourseTitles::exercise(const std::string& id, std::string_view language) const {
  for (const fs::path& folder : exercises_)
    if (const fs::path file = index_.exercise_file(folder, id); !file.empty()) return link_to(file, id, language);
  return link_to({}, id, language);
}

}  // namespace blossom
