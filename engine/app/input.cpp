#include "app/input.hpp"

#include <iostream>

namespace blossom {
namespace fs = std::filesystem;

void add_subject_options(CLI::App& app, SubjectOptions& options) {
  auto* lesson = app.add_option("LESSON", options.lesson, "A lesson: a file, or the name or number of one in lessons/");
  auto* algorithm = app.add_option("--algorithm", options.algorithm, "Instead of a lesson: an algorithm, see `blossom list`");
  auto* inputs = app.add_option("--inputs", options.inputs, "A JSON file with the algorithm's inputs (- is standard input)");
  algorithm->needs(inputs)->excludes(lesson);
  inputs->needs(algorithm);
}

fs::path find_folder(const std::string& name) {
  std::error_code error;
  if (fs::is_directory(name, error)) return name;
  for (fs::path at = fs::read_symlink("/proc/self/exe", error).parent_path(); at.has_relative_path(); at = at.parent_path())
    if (fs::is_directory(at / name, error)) return at / name;
  return name;
}

namespace {

// "05", "05-de-boor" and "de-boor" all find lessons/05-de-boor.json.
fs::path find_lesson(const std::string& given) {
  std::error_code error;
  if (fs::exists(given, error) || given == "-") return given;
  const fs::path folder = find_folder("lessons");
  std::vector<fs::path> matches;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() != ".json" || stem.ends_with(".schema")) continue;
    if (stem == given) return entry.path();
    if (stem.starts_with(given + "-") || stem.ends_with("-" + given)) matches.push_back(entry.path());
  }
  return matches.size() == 1 ? matches[0] : fs::path(given);
}

}  // namespace

Checked<Subject> load_subject(const SubjectOptions& options) {
  Subject subject;
  if (!options.algorithm.empty()) {
    subject.algorithm = find_algorithm(options.algorithm);
    if (subject.algorithm == nullptr) {
      std::string message = "there is no algorithm \"" + options.algorithm + "\"";
      if (const auto near = did_you_mean(options.algorithm, algorithm_ids())) message += "; did you mean \"" + *near + "\"?";
      return Diagnostics{{"", 0, 0, "--algorithm", message}};
    }
    const auto document = JsonDocument::load(options.inputs);
    if (!document) return document.diagnostics;
    Diagnostics diagnostics;
    auto inputs = read_inputs(*subject.algorithm, Cursor(*document, diagnostics));
    if (!inputs) return diagnostics;
    subject.inputs = std::move(*inputs);
    return subject;
  }
  if (options.lesson.empty())
    return Diagnostics{{"", 0, 0, "", "nothing to work on: give a LESSON (see `blossom list`), or --algorithm and --inputs"}};
  const auto document = JsonDocument::load(find_lesson(options.lesson));
  if (!document) return document.diagnostics;
  auto lesson = load_lesson(*document);
  if (!lesson) return lesson.diagnostics;
  subject.algorithm = lesson->algorithm;
  subject.inputs = lesson->inputs;
  subject.lesson = std::move(*lesson);
  return subject;
}

int report(const Diagnostics& diagnostics) {
  std::cerr << to_string(diagnostics);
  return diagnostics.empty() ? done : input_at_fault;
}

}  // namespace blossom
