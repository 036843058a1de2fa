#include "app/input.hpp"

#include <algorithm>
#include <iostream>

#include "lesson/catalog.hpp"

namespace blossom {
namespace fs = std::filesystem;

void add_subject_options(CLI::App& app, SubjectOptions& options) {
  auto* lesson = app.add_option("LESSON", options.lesson, "A lesson: a file, or the name or number of one in lessons/");
  auto* algorithm =
      app.add_option("--algorithm", options.algorithm, "Instead of a lesson: an algorithm, see `blossom list`");
  auto* inputs =
      app.add_option("--inputs", options.inputs, "A JSON file with the algorithm's inputs (- is standard input)");
  app.add_option("--scene", options.scene, "Of a lesson of several scenes: which one, by its id or number")
      ->needs(lesson);
  app.add_option("--language", options.language, "Of a lesson in several languages: which one, such as de")
      ->needs(lesson);
  algorithm->needs(inputs)->excludes(lesson);
  inputs->needs(algorithm);
}

fs::path find_folder(const std::string& name) {
  std::error_code error;
  if (fs::is_directory(name, error)) return name;
  for (fs::path at = fs::read_symlink("/proc/self/exe", error).parent_path(); at.has_relative_path();
       at = at.parent_path())
    if (fs::is_directory(at / name, error)) return at / name;
  return name;
}

Checked<fs::path> find_lesson(const std::string& given) {
  std::error_code error;
  if (fs::exists(given, error) || given == "-") return fs::path(given);
  const fs::path folder = find_folder("lessons");
  std::vector<fs::path> matches;
  std::vector<std::string> names;
  Diagnostics none;  // a folder that cannot be read has no lessons
  for (const fs::path& file : json_files(folder, none)) {
    const std::string stem = file.stem().string();
    if (stem == given) return file;
    names.push_back(stem);
    if (const auto dash = stem.find('-'); dash != std::string::npos) names.push_back(stem.substr(dash + 1));
    if (stem.starts_with(given + "-") || stem.starts_with("0" + given + "-") || stem.ends_with("-" + given))
      matches.push_back(file);
  }
  if (matches.size() == 1) return matches[0];
  std::string message = "there is no such file, and no lesson of that name; `blossom list` lists them";
  if (!matches.empty()) {
    message = "more than one lesson is meant:";
    for (const fs::path& match : matches) message += " " + match.stem().string();
  } else if (const auto near = did_you_mean(given, names)) {
    message += "; did you mean \"" + *near + "\"?";
  }
  return Diagnostics{{given, 0, 0, "", message}};
}

namespace {

std::string no_such_scene(const Lesson& lesson, const std::string& given) {
  std::string message = "this lesson has no scene " + excerpt(given) + ", only ";
  if (lesson.scene_count() == 1) return message + "one";
  for (std::size_t i = 0; i < lesson.scene_count(); ++i)
    message += (i > 0 ? ", " : "") + std::to_string(i + 1) + " (" + lesson.scene_at(i).scene + ")";
  return message;
}

bool is_in(const Lesson& lesson, const std::string& language) {
  return language == lesson.languages.own ||
         std::ranges::find(lesson.languages.others, language) != lesson.languages.others.end();
}

std::string languages_of(const Lesson& lesson) {
  std::string names = lesson.languages.own;
  for (const std::string& other : lesson.languages.others) names += ", " + other;
  return names;
}

}  // namespace

Checked<Subject> load_subject(const SubjectOptions& options) {
  Subject subject;
  if (!options.algorithm.empty()) {
    subject.algorithm = find_algorithm(options.algorithm);
    if (subject.algorithm == nullptr) {
      std::string message = "there is no algorithm " + excerpt(options.algorithm);
      if (const auto near = did_you_mean(options.algorithm, algorithm_ids()))
        message += "; did you mean \"" + *near + "\"?";
      throw CLI::ValidationError("--algorithm", message);
    }
    auto document = JsonDocument::load(options.inputs);
    if (!document) return document.diagnostics;
    Diagnostics diagnostics;
    auto inputs = read_inputs(*subject.algorithm, Cursor(*document, diagnostics));
    if (!inputs) return diagnostics;
    subject.inputs = std::move(*inputs);
    subject.document = std::move(*document);
    return subject;
  }
  if (options.lesson.empty()) throw CLI::RequiredError("LESSON (see `blossom list`), or --algorithm and --inputs,");
  const auto file = find_lesson(options.lesson);
  if (!file) return file.diagnostics;
  auto document = JsonDocument::load(*file);
  if (!document) return document.diagnostics;
  auto lesson = load_lesson(*document);
  if (!lesson) return lesson.diagnostics;
  if (!options.scene.empty()) {
    const auto scene = lesson->find_scene(options.scene);
    if (!scene) throw CLI::ValidationError("--scene", no_such_scene(*lesson, options.scene));
    subject.scene = *scene;
  }
  if (!options.language.empty()) {
    if (!is_in(*lesson, options.language))
      throw CLI::ValidationError("--language", excerpt(options.language) + " is no language of this lesson; it is in " +
                                                   languages_of(*lesson));
    if (options.language != lesson->languages.own) subject.language = options.language;
  }
  subject.algorithm = lesson->scene_at(subject.scene).algorithm;
  subject.inputs = lesson->scene_at(subject.scene).inputs;
  subject.lesson = std::move(*lesson);
  subject.document = std::move(*document);
  return subject;
}

std::string Subject::scene_note() const {
  if (!lesson || lesson->scene_count() < 2) return {};
  std::string note = "Scene " + std::to_string(scene + 1) + " of " + std::to_string(lesson->scene_count()) + ": " +
                     printable(lesson_scene()->heading.in(language)) + ". --scene NUMBER shows another:";
  for (std::size_t i = 0; i < lesson->scene_count(); ++i)
    note += (i == 0 ? " " : ", ") + std::to_string(i + 1) + " (" + lesson->scene_at(i).scene + ")";
  return note;
}

Diagnostics at_inputs(const Subject& subject, const Diagnostics& of_run) {
  Diagnostics diagnostics;
  const Cursor root(subject.document, diagnostics);
  Cursor at = root;
  if (subject.lesson) {
    if (const auto scenes = root.optional("scenes")) at = (*scenes)[subject.scene];
    at = *at.optional("inputs");
  }
  report_at(at, of_run);
  return diagnostics;
}

int report(const Diagnostics& diagnostics) {
  std::cerr << to_string(diagnostics);
  return diagnostics.empty() ? done : input_at_fault;
}

}  // namespace blossom
