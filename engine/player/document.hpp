#pragma once
// A file one can open in the player: a lesson, an exercise, a trace, a file of inputs or of one curve.

#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "grader/grade.hpp"
#include "lesson/lesson.hpp"
#include "player/prediction.hpp"

namespace blossom {

struct Document {
  enum class Kind : std::uint8_t { lesson, exercise, inputs };
  Kind kind = Kind::inputs;
  std::filesystem::path file;  // absolute; empty: not from a file
  JsonDocument json;
  const Algorithm* algorithm = nullptr;
  Inputs<Exact> inputs;
  std::optional<Lesson> lesson;
  std::size_t scene = 0;                 // of the lesson, which this run is of
  std::shared_ptr<const Grader> grader;  // of an exercise
  Marking marking = Marking::at_once;
  std::string called;             // its title, where neither a lesson nor a file says one
  std::vector<std::string> asks;  // what a lesson has predicted; empty: what its algorithm usually asks

  const LessonScene* lesson_scene() const { return lesson ? &lesson->scene_at(scene) : nullptr; }
  void show_scene(std::size_t);  // of its lesson
  std::string id() const;
  std::string title(std::string_view language = {}) const;  // printable
};

// Every mistake of the file at once. `algorithm` is for a file of inputs (or of a curve), which does not name one; a
// curve alone is evaluated in the middle of its domain, by de Boor's algorithm unless another is named.
Checked<Document> open_document(const std::filesystem::path&, std::string_view algorithm = {});
Checked<Document> read_document(JsonDocument, std::string_view algorithm = {});
// Ready-made inputs for an algorithm: those of the first lesson about it in the folder.
Checked<Document> example_document(std::string_view algorithm, const std::filesystem::path& lessons);

// The document as the file of a new lesson with these inputs. Left out are beats whose place is no longer there or
// whose words name a value that is not, and likewise highlights and asks; an exercise's prompt becomes the first beat.
// The id and the title are made such as a lesson may have.
// Of a lesson of several scenes the others stay as they are, but for the inputs of those that are `edited`, too.
std::string as_lesson(const Document&, const Inputs<Exact>&, const std::string& id, const std::string& title,
                      const std::map<std::size_t, Inputs<Exact>>& edited = {});

}  // namespace blossom
