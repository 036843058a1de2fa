#pragma once
// What lessons and exercises say of other files: the lessons to be seen before, the exercises that go with them, and
// the files their words lead to.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/json.hpp"

namespace blossom {

// Which lessons and exercises there are, by their ids, in the folders that somebody asked for.
class CourseIndex {
 public:
  // A document that was read already: its folder will not be asked for it again.
  void add(const std::filesystem::path& file, const JsonDocument&);
  // All lessons and exercises of a folder. One that is not there, and files that cannot be read, have none.
  void add_folder(const std::filesystem::path& folder);

  bool has_lesson(const std::filesystem::path& folder, const std::string& id) const;
  bool has_exercise(const std::filesystem::path& folder, const std::string& id) const;
  // The file of a lesson or an exercise in a folder; empty if there is none.
  std::filesystem::path lesson_file(const std::filesystem::path& folder, const std::string& id) const;
  std::filesystem::path exercise_file(const std::filesystem::path& folder, const std::string& id) const;
  std::vector<std::string> lessons(const std::filesystem::path& folder) const;
  std::vector<std::string> exercises(const std::filesystem::path& folder) const;
  // From a lesson's prerequisite back to the lesson: the ids on the way, both among them; empty: no such way.
  std::vector<std::string> way_back(const std::filesystem::path& folder, const std::string& lesson,
                                    const std::string& prerequisite) const;

 private:
  struct Entry {
    std::filesystem::path file;
    std::vector<std::string> prerequisites;
  };
  struct Folder {
    std::map<std::string, Entry, std::less<>> lessons, exercises;
    std::map<std::filesystem::path, bool> files;  // that are known
    bool whole = false;
  };
  const Folder* find(const std::filesystem::path& folder) const;

  std::map<std::filesystem::path, Folder> folders_;
};

// The folders in which the files stand that a lesson names: its own for lessons; that and ../exercises for exercises.
std::vector<std::filesystem::path> folders_of_exercises(const std::filesystem::path& lesson);

// The folders of a course, which lessons elsewhere may refer to.
struct CourseFolders {
  std::filesystem::path lessons, exercises;
};

// Prerequisites and exercises of a lesson that no file has, and prerequisites in a circle. The folders of the file and
// of the course are in the index.
Diagnostics check_links(const JsonDocument& lesson, const CourseIndex&, const CourseFolders& course = {});
// Links in the words of a lesson or an exercise that lead to no file beside it.
Diagnostics check_addresses(const JsonDocument&);
// Nothing, unless an earlier file of the folder has the id of this lesson or exercise, too.
Diagnostics check_id(const JsonDocument&, const CourseIndex&);

}  // namespace blossom
