// blossom lint: every mistake of lessons, exercises, assignments, scenes, geometry and answers, each at its line and
// column.

#include <algorithm>
#include <iostream>

#include "algorithms/trace_json.hpp"
#include "app/input.hpp"
#include "geometry/document.hpp"
#include "grader/answers.hpp"
#include "grader/assignment.hpp"
#include "grader/variant.hpp"
#include "lesson/catalog.hpp"
#include "lesson/document.hpp"
#include "lesson/file_kind.hpp"
#include "studio/scene_file.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

// The files meant: a folder means those of json_files.
std::vector<fs::path> expand(const std::vector<std::string>& given, Diagnostics& diagnostics) {
  std::vector<fs::path> files;
  for (const std::string& name : given) {
    std::error_code error;
    if (!fs::is_directory(name, error)) {
      files.emplace_back(name);
      continue;
    }
    const std::size_t before = diagnostics.size();
    const auto found = json_files(name, diagnostics);
    if (found.empty() && diagnostics.size() == before)
      diagnostics.push_back({name, 0, 0, "", "there are no *.json files in this folder"});
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

// The exercise of this id in the folder of exercises, if it is there and in order.
std::optional<Exercise> find_exercise(const std::string& id) {
  Diagnostics none;  // a folder that cannot be read has no exercises
  for (const fs::path& file : json_files(find_folder("exercises"), none)) {
    const auto document = JsonDocument::load(file);
    if (!document) continue;
    const Json* own = document->root().find("id");
    if (own == nullptr || own->text != id) continue;
    auto exercise = read_exercise(*document);
    if (exercise) return std::move(*exercise);
  }
  return std::nullopt;
}

// A number, an array of numbers, or {"set": [numbers]}.
void check_answer(const Cursor& at) {
  if (at.is(Json::Kind::object)) {
    at.expect_object({"set"});
    if (const auto set = at.required("set"); set && set->expect_array())
      for (std::size_t i = 0; i < set->size(); ++i) (*set)[i].number();
  } else if (at.is(Json::Kind::array)) {
    for (std::size_t i = 0; i < at.size(); ++i) at[i].number();
  } else {
    at.number();
  }
}

// What answers can be told without grading them: their form, and names that their exercise does not ask for.
void check_answers(const Cursor& root) {
  if (!root.expect_object({"$schema", "schema", "exercise", "student", "answers"})) return;
  expect_schema(root, "blossom.answers/1");
  const auto id = root.required("exercise");
  const auto text = id ? id->string() : std::nullopt;
  if (const auto student = root.optional("student")) student->string();
  const auto answers = root.required("answers");
  if (!answers || !answers->is(Json::Kind::object)) {
    if (answers) answers->error("must be an object of names and values, such as {\"P[1][0]\": [1, \"3/2\"]}");
    return;
  }
  const auto exercise = text ? find_exercise(*text) : std::nullopt;
  std::vector<std::string> asked;
  if (exercise)
    for (const Part& part : exercise->parts) asked.push_back(part.name);
  for (std::size_t i = 0; i < answers->size(); ++i) {
    const std::string& name = answers->json().keys[i];
    check_answer(answers->member(i));
    if (asked.empty() || std::ranges::find(asked, name) != asked.end()) continue;
    std::string message = "the exercise does not ask for " + excerpt(name);
    if (const auto near = nearest_asked(*exercise, name)) message += "; did you mean \"" + *near + "\"?";
    answers->key_error(i, message);
  }
}

Diagnostics lint(const JsonDocument& document) {
  if (document.name().ends_with(".schema.json")) return {};  // it is about such files
  Diagnostics diagnostics;
  const Cursor root(document, diagnostics);
  switch (file_kind(document.root())) {
    case FileKind::lesson:
      return load_lesson(document).diagnostics;
    case FileKind::exercise: {
      const auto exercise = read_exercise(document);
      return exercise ? check_variants(document) : exercise.diagnostics;
    }
    case FileKind::assignment:
      return read_assignment(document).diagnostics;
    case FileKind::trace:
      return read_trace(document).diagnostics;
    case FileKind::curve:
      read_curve(root);
      break;
    case FileKind::surface:
      read_surface(root);
      break;
    case FileKind::scene:
      return read_scene(document).diagnostics;
    case FileKind::answers:
      check_answers(root);
      break;
    case FileKind::grade:
      expect_schema(root, "blossom.grade/1");
      break;
    case FileKind::result:
      expect_schema(root, "blossom.result/1");
      break;
    case FileKind::schema:
      break;
    case FileKind::unknown:
      root.error(
          "is no file of Blossom's: \"schema\" must be \"blossom.lesson/1\", \"blossom.exercise/1\", "
          "\"blossom.assignment/1\", \"blossom.answers/1\", \"blossom.scene/1\" or \"blossom.trace/1\"; a curve or "
          "surface has \"degree\" "
          "and \"points\"");
      break;
  }
  return diagnostics;
}

int run(const std::vector<std::string>& given) {
  Diagnostics all;
  std::size_t good = 0;
  const auto files = expand(given, all);
  for (const fs::path& file : files) {
    const auto document = JsonDocument::load(file);
    const Diagnostics found = document ? lint(*document) : document.diagnostics;
    good += found.empty() ? 1 : 0;
    all.insert(all.end(), found.begin(), found.end());
  }
  const int status = report(all);
  if (files.empty()) return status;
  std::cout << good << (good == 1 ? " file is" : " files are") << " in order";
  if (!all.empty()) std::cout << ", " << all.size() << (all.size() == 1 ? " mistake" : " mistakes") << " in the others";
  std::cout << "\n";
  return status;
}

void set_up(CLI::App& app, int& status) {
  auto files = std::make_shared<std::vector<std::string>>();
  app.add_option("FILES", *files, "Files, or folders of them; by default `lessons`, `exercises` and `lessons/scenes`");
  app.footer(
      "Names every mistake at once, as file:line:column: path: what is wrong, and what would be right.\n"
      "Examples:\n"
      "  blossom lint\n"
      "  blossom lint my-lesson.json exercises\n"
      "Exit status: 0 all in order, 1 mistakes, 2 wrong usage.");
  app.callback([files, &status] {
    if (files->empty()) {
      const fs::path lessons = find_folder("lessons");
      *files = {lessons.string(), find_folder("exercises").string()};
      std::error_code error;
      if (fs::is_directory(lessons / "scenes", error)) files->push_back((lessons / "scenes").string());
    }
    status = run(*files);
  });
}

}  // namespace

const Command& command_lint() {
  static const Command command{"lint", "Check lessons, exercises, assignments, scenes, geometry, answers and traces",
                               40, set_up};
  return command;
}

}  // namespace blossom
