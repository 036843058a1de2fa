// blossom lint: every mistake of lessons, exercises, assignments, scenes, geometry and answers, each at its line and
// column.

#include <algorithm>
#include <atomic>
#include <iostream>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include "algorithms/trace_json.hpp"
#include "app/input.hpp"
#include "geometry/document.hpp"
#include "grader/answers.hpp"
#include "grader/assignment.hpp"
#include "grader/lesson_grader.hpp"
#include "grader/variant.hpp"
#include "lesson/catalog.hpp"
#include "lesson/document.hpp"
#include "lesson/file_kind.hpp"
#include "lesson/links.hpp"
#include "lesson/slider_check.hpp"
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

// What the files that are checked name: lessons, and exercises with the answers that they expect. Each exercise is read
// once, whoever asks for it.
class Course {
 public:
  CourseIndex index;
  const CourseFolders shipped{find_folder("lessons"), find_folder("exercises")};

  // The folders that this file may name something in.
  void add_folders_of(const fs::path& file, const Json& root) {
    switch (file_kind(root)) {
      case FileKind::lesson:
        if (root.find("prerequisites") != nullptr) {
          index.add_folder(file.parent_path());
          index.add_folder(shipped.lessons);
        }
        if (root.find("exercises") != nullptr) {
          for (const fs::path& folder : folders_of_exercises(file)) index.add_folder(folder);
          index.add_folder(shipped.exercises);
        }
        break;
      case FileKind::answers:
        index.add_folder(shipped.exercises);
        index.add_folder(shipped.lessons);
        break;
      default:
        break;
    }
  }

  // The exercise of this id or the checkpoints of the lesson, which may have the same: the one that asks for more of
  // these names. nullptr if there is none, or not in order.
  const Exercise* find_exercise(const std::string& id, const std::vector<std::string>& names) {
    const std::scoped_lock lock(mutex_);
    const Exercise* exercise = read(index.exercise_file(shipped.exercises, id), false);
    const Exercise* sheet = read(index.lesson_file(shipped.lessons, id), true);
    if (exercise == nullptr || sheet == nullptr) return exercise != nullptr ? exercise : sheet;
    const auto asked = [&](const Exercise& of) {
      return std::ranges::count_if(names, [&](const std::string& name) { return of.part(name).has_value(); });
    };
    return asked(*exercise) < asked(*sheet) ? sheet : exercise;
  }

 private:
  const Exercise* read(const fs::path& file, bool lesson) {
    if (file.empty()) return nullptr;
    const auto [known, is_new] = read_.try_emplace(file);
    if (!is_new) return known->second ? &*known->second : nullptr;
    const auto document = JsonDocument::load(file);
    if (!document) return nullptr;
    auto exercise = lesson ? read_sheet(*document) : read_exercise(*document);
    if (!exercise) return nullptr;
    known->second = std::move(*exercise);
    known->second->run.trace.find({});  // builds its index now, for others read it at the same time
    return &*known->second;
  }

  std::mutex mutex_;
  std::map<fs::path, std::optional<Exercise>> read_;
};

bool is_letters(const Json& json) {
  return json.kind == Json::Kind::string && !json.text.empty() &&
         json.text.find_first_not_of("abcdefghABCDEFGH ,") == std::string::npos;
}

// A number, an array of numbers, {"set": [numbers]}, or letters.
void check_answer(const Cursor& at) {
  if (at.is(Json::Kind::object)) {
    at.expect_object({"set"});
    if (const auto set = at.required("set"); set && set->expect_array())
      for (std::size_t i = 0; i < set->size(); ++i) (*set)[i].number();
  } else if (at.is(Json::Kind::array)) {
    for (std::size_t i = 0; i < at.size(); ++i)
      if (!is_letters(at[i].json())) at[i].number();
  } else if (!is_letters(at.json())) {
    at.number();
  }
}

// What answers can be told without grading them: their form, and names that their exercise does not ask for.
void check_answers(const Cursor& root, Course& course) {
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
  const Exercise* exercise = text ? course.find_exercise(*text, answers->json().keys) : nullptr;
  for (std::size_t i = 0; i < answers->size(); ++i) {
    const std::string& name = answers->json().keys[i];
    const Cursor answer = answers->member(i);
    const auto part = exercise != nullptr ? exercise->part(name) : std::nullopt;
    const Question* question = part ? exercise->parts[*part].question.get() : nullptr;
    if (question != nullptr && !question->is_value()) {
      if (const auto mark = mark_letters(*question, answer.json()); !mark.problem.empty()) answer.error(mark.problem);
      continue;
    }
    check_answer(answer);
    if (exercise == nullptr || part) continue;
    std::string message = "the exercise does not ask for " + excerpt(name);
    if (const auto near = nearest_asked(*exercise, name)) message += "; did you mean \"" + *near + "\"?";
    answers->key_error(i, message);
  }
}

// A lesson by itself, and what it names in other files.
Diagnostics lint_lesson(const JsonDocument& document, const Course& course) {
  Diagnostics diagnostics = load_lesson(document).diagnostics;
  const auto add = [&](const Diagnostics& more) { diagnostics.insert(diagnostics.end(), more.begin(), more.end()); };
  if (diagnostics.empty()) add(check_sliders(document));
  add(check_id(document, course.index));
  add(check_addresses(document));
  add(check_links(document, course.index, course.shipped));
  return diagnostics;
}

Diagnostics lint(const JsonDocument& document, Course& course) {
  if (document.name().ends_with(".schema.json")) return {};  // it is about such files
  Diagnostics diagnostics;
  const Cursor root(document, diagnostics);
  switch (file_kind(document.root())) {
    case FileKind::lesson:
      return lint_lesson(document, course);
    case FileKind::exercise: {
      const auto exercise = read_exercise(document);
      diagnostics = exercise ? check_variants(document) : exercise.diagnostics;
      for (const Diagnostics& more : {check_id(document, course.index), check_addresses(document)})
        diagnostics.insert(diagnostics.end(), more.begin(), more.end());
      return diagnostics;
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
      check_answers(root, course);
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

// Does this for every number below count, on as many threads as there are processors.
template <class Work>
void for_each_in_parallel(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next = 0;
  const auto loop = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> others;
  const std::size_t threads = std::min<std::size_t>(std::max(1u, std::thread::hardware_concurrency()), count);
  for (std::size_t t = 1; t < threads; ++t) others.emplace_back(loop);
  loop();
}

// An assignment tells the mistakes of its exercises, too: not again where these are checked themselves.
void tell_once(const std::vector<fs::path>& files, std::vector<Diagnostics>& found) {
  const auto normal = [](const fs::path& file) {
    std::error_code error;
    return fs::weakly_canonical(file, error).string();
  };
  std::set<std::string> checked;
  for (const fs::path& file : files) checked.insert(normal(file));
  for (std::size_t i = 0; i < files.size(); ++i)
    std::erase_if(found[i],
                  [&](const Diagnostic& d) { return d.file != files[i].string() && checked.contains(normal(d.file)); });
}

int run(const std::vector<std::string>& given) {
  Diagnostics all;
  std::size_t good = 0;
  const auto files = expand(given, all);
  std::vector<std::optional<Checked<JsonDocument>>> documents(files.size());
  for_each_in_parallel(files.size(), [&](std::size_t i) { documents[i] = JsonDocument::load(files[i]); });
  Course course;
  for (std::size_t i = 0; i < files.size(); ++i)
    if (*documents[i]) course.index.add(files[i], **documents[i]);
  for (std::size_t i = 0; i < files.size(); ++i)
    if (*documents[i]) course.add_folders_of(files[i], (*documents[i])->root());
  std::vector<Diagnostics> found(files.size());
  for_each_in_parallel(files.size(), [&](std::size_t i) {
    found[i] = *documents[i] ? lint(**documents[i], course) : documents[i]->diagnostics;
  });
  tell_once(files, found);
  for (const Diagnostics& of_file : found) {
    good += of_file.empty() ? 1 : 0;
    all.insert(all.end(), of_file.begin(), of_file.end());
  }
  const int status = report(all);
  if (files.empty()) return status;
  const std::size_t bad = files.size() - good;
  if (good > 0 || all.empty()) std::cout << good << (good == 1 ? " file is" : " files are") << " in order";
  if (!all.empty()) std::cout << (good > 0 ? ", " : "") << all.size() << (all.size() == 1 ? " mistake" : " mistakes");
  if (bad > 0) std::cout << " in " << bad << (good > 0 ? " other" : bad == 1 ? " file" : " files");
  if (bad > 1 && good > 0) std::cout << "s";
  std::cout << "\n";
  return status;
}

// What is meant by no files: the course that is here; else the files that are here; else the course around the program.
std::vector<std::string> files_by_default() {
  std::error_code error;
  std::vector<std::string> files;
  Diagnostics none;  // a folder that cannot be read has no files
  if (!fs::is_directory("lessons", error))
    for (const fs::path& file : json_files(".", none))
      if (const auto document = JsonDocument::load(file); document && file_kind(document->root()) != FileKind::unknown)
        files.push_back(file.filename().string());
  if (!files.empty()) return files;
  const fs::path lessons = find_folder("lessons");
  files = {lessons.string(), find_folder("exercises").string()};
  if (fs::is_directory(lessons / "scenes", error)) files.push_back((lessons / "scenes").string());
  return files;
}

void set_up(CLI::App& app, int& status) {
  auto files = std::make_shared<std::vector<std::string>>();
  app.add_option(
      "FILES", *files,
      "Files, or folders of them; by default `lessons`, `exercises` and `lessons/scenes`, or, where there is no "
      "`lessons`, the files that are here");
  app.footer(
      "Names every mistake at once, as file:line:column: path: what is wrong, and what would be right: in their form\n"
      "and words, in what they say at each step, in the lessons, exercises and files they name, in what a slider "
      "would\n"
      "make of their inputs.\n"
      "Examples:\n"
      "  blossom lint\n"
      "  blossom lint my-lesson.json exercises\n"
      "Exit status: 0 all in order, 1 mistakes, 2 wrong usage.");
  app.callback([files, &status] {
    if (files->empty()) *files = files_by_default();
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
