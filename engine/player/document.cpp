#include "player/document.hpp"

#include <algorithm>

#include "geometry/document.hpp"
#include "grader/exercise.hpp"
#include "lesson/catalog.hpp"
#include "lesson/document.hpp"
#include "lesson/file_kind.hpp"
#include "player/edit.hpp"

namespace blossom {

void Document::show_scene(std::size_t which) {
  const LessonScene& shown = lesson->scene_at(which);
  scene = which;
  algorithm = shown.algorithm;
  inputs = shown.inputs;
  marking = shown.marking;
  asks = shown.asks;
}

std::string Document::id() const {
  if (lesson) return lesson->id;
  if (grader) return grader->exercise().id;
  return file.empty() ? std::string(algorithm->id) : file.stem().string();
}

std::string Document::title(std::string_view language) const {
  if (lesson) return printable(lesson->title.in(language));
  if (grader) return printable(grader->exercise().title);
  if (!called.empty()) return called;
  return file.empty() ? std::string(algorithm->title) : printable(file.filename().string());
}

namespace {

// Whether the inputs can be run, in one kind of numbers at least; what is wrong is said at their places in the file.
bool can_run(const Algorithm& algorithm, const Inputs<Exact>& inputs, const Cursor& at) {
  const auto rounded = record<double>(algorithm, inputs);
  if (rounded || record<Exact>(algorithm, inputs)) return true;
  report_at(at, rounded.diagnostics);
  return false;
}

void read_as_lesson(Document& document, Diagnostics& diagnostics) {
  auto lesson = load_lesson(document.json);
  if (!lesson) {
    diagnostics = std::move(lesson.diagnostics);
    return;
  }
  document.kind = Document::Kind::lesson;
  document.lesson = std::move(*lesson);
  document.show_scene(0);
}

void read_as_exercise(Document& document, Diagnostics& diagnostics) {
  auto exercise = read_exercise(document.json);
  if (!exercise) {
    diagnostics = std::move(exercise.diagnostics);
    return;
  }
  document.kind = Document::Kind::exercise;
  document.algorithm = exercise->run.algorithm;
  document.inputs = exercise->run.inputs;
  document.marking = exercise->marking;
  const Json* ask = document.json.root().find("ask");
  for (const Json& asked : ask->items) document.asks.push_back(asked.find("value")->text);
  document.grader = std::make_shared<const Grader>(std::move(*exercise));
}

void read_as_inputs(Document& document, const Cursor& at) {
  auto inputs = read_inputs(*document.algorithm, at);
  if (inputs && can_run(*document.algorithm, *inputs, at)) document.inputs = std::move(*inputs);
}

// What it shows follows from its algorithm and inputs.
void read_as_trace(Document& document, const Cursor& root) {
  expect_schema(root, "blossom.trace/1");
  document.algorithm = read_algorithm(root);
  const auto inputs = root.required("inputs");
  if (document.algorithm != nullptr && inputs) read_as_inputs(document, *inputs);
}

void read_as_curve(Document& document, const Cursor& root) {
  const auto curve = read_curve(root);
  if (!curve) return;
  auto inputs = inputs_around(*document.algorithm, *curve);
  for (const Diagnostic& diagnostic : inputs.diagnostics) root.error(diagnostic.message);
  if (inputs && can_run(*document.algorithm, *inputs, root)) document.inputs = std::move(*inputs);
}

// A file of no kind that can be opened: what it is, or what it would have to be.
std::string not_to_be_opened(FileKind kind, const Json& root) {
  const auto exercise = [&] {
    const Json* id = root.find("exercise");
    return id != nullptr && id->kind == Json::Kind::string ? "the exercise " + excerpt(id->text)
                                                           : std::string("their exercise");
  };
  switch (kind) {
    case FileKind::answers:
      return "these are answers: open " + exercise() + ", or grade them with blossom-grade";
    case FileKind::grade:
      return "this is a grade: open " + exercise();
    case FileKind::surface:
      return "this is a surface, which no algorithm takes as its input: open a curve, inputs, a lesson, an exercise or "
             "a trace";
    case FileKind::schema:
      return "this is a JSON Schema, which says how files are to be written; open one of these";
    default:
      break;
  }
  std::string message = "is no lesson, exercise, trace or curve";
  if (root.kind != Json::Kind::object) return message + ": these are objects, {...}";
  const auto takes = [&](const Algorithm& algorithm) {
    return !root.keys.empty() && std::all_of(root.keys.begin(), root.keys.end(),
                                             [&](const std::string& key) { return algorithm.input(key) != nullptr; });
  };
  std::string fitting;
  for (const Algorithm* algorithm : algorithms())
    if (takes(*algorithm)) fitting += (fitting.empty() ? "" : ", ") + std::string(algorithm->id);
  if (!fitting.empty())
    return message + "; to open it as inputs, say of which algorithm (" + fitting + "): --algorithm ID";
  return message + R"(: it has no "schema" ("blossom.lesson/1", "blossom.exercise/1", "blossom.trace/1"))";
}

}  // namespace

Checked<Document> read_document(JsonDocument json, std::string_view algorithm) {
  Document document;
  document.json = std::move(json);
  Diagnostics diagnostics;
  const Cursor root(document.json, diagnostics);
  const FileKind kind = file_kind(root.json());
  const bool alone = kind == FileKind::curve || (kind == FileKind::unknown && !algorithm.empty());
  if (alone) {
    document.algorithm = find_algorithm(algorithm.empty() ? "de_boor" : algorithm);
    if (document.algorithm == nullptr) return Diagnostics{{"", 0, 0, "", no_such_algorithm(algorithm)}};
  }
  if (kind == FileKind::lesson)
    read_as_lesson(document, diagnostics);
  else if (kind == FileKind::exercise)
    read_as_exercise(document, diagnostics);
  else if (kind == FileKind::trace)
    read_as_trace(document, root);
  else if (kind == FileKind::curve)
    read_as_curve(document, root);
  else if (alone)
    read_as_inputs(document, root);
  else
    root.error(not_to_be_opened(kind, root.json()));
  if (!diagnostics.empty()) return diagnostics;
  return document;
}

Checked<Document> open_document(const std::filesystem::path& path, std::string_view algorithm) {
  auto json = JsonDocument::load(path);
  if (!json) return json.diagnostics;
  auto document = read_document(std::move(*json), algorithm);
  std::error_code error;
  if (document) document->file = std::filesystem::absolute(path, error).lexically_normal();
  return document;
}

namespace {

// Whether one of its scenes is, looked at without reading all of it.
bool is_about(const Json& lesson, std::string_view algorithm) {
  const auto names_it = [&](const Json& run) {
    const Json* about = run.kind == Json::Kind::object ? run.find("algorithm") : nullptr;
    return about != nullptr && about->text == algorithm;
  };
  const Json* scenes = lesson.find("scenes");
  return names_it(lesson) || (scenes != nullptr && std::ranges::any_of(scenes->items, names_it));
}

}  // namespace

Checked<Document> example_document(std::string_view algorithm, const std::filesystem::path& lessons) {
  Document document;
  document.algorithm = find_algorithm(algorithm);
  if (document.algorithm == nullptr) return Diagnostics{{"", 0, 0, "", no_such_algorithm(algorithm)}};
  Diagnostics diagnostics;
  for (const auto& file : json_files(lessons, diagnostics)) {
    auto json = JsonDocument::load(file);
    if (!json || file_kind(json->root()) != FileKind::lesson) continue;
    if (!is_about(json->root(), algorithm)) continue;
    const auto lesson = load_lesson(*json);  // one with mistakes is no example
    for (std::size_t i = 0; lesson && i < lesson->scene_count(); ++i) {
      if (lesson->scene_at(i).algorithm != document.algorithm) continue;
      document.inputs = lesson->scene_at(i).inputs;
      return document;
    }
  }
  diagnostics.push_back(
      {lessons.string(), 0, 0, "",
       "has no lesson about " + std::string(algorithm) + " to take inputs from; open a file of inputs"});
  return diagnostics;
}

}  // namespace blossom
