#pragma once
// What the commands read: a lesson by file or by name, or an algorithm with a file of inputs.

#include <filesystem>
#include <optional>
#include <string>

#include "app/command.hpp"
#include "lesson/lesson.hpp"

namespace blossom {

// The options LESSON, --algorithm and --inputs that trace, render and play share.
struct SubjectOptions {
  std::string lesson;
  std::string algorithm;
  std::string inputs;
};
void add_subject_options(CLI::App&, SubjectOptions&);

struct Subject {
  const Algorithm* algorithm = nullptr;
  Inputs<Exact> inputs;
  std::optional<Lesson> lesson;
  JsonDocument document;  // where the inputs stand: it is them, or has them as its member "inputs" if it is a lesson

  std::string title() const { return lesson ? printable(lesson->title) : std::string(algorithm->title); }
  // The narration of a step: the lesson's, where it has something to say.
  template <Scalar S>
  std::string narration(const Narrator<S>& narrator, std::uint32_t step) const {
    return lesson ? lesson->narration(narrator, step) : narrator.text(step);
  }
};
// What is wrong in a file is a diagnostic; options that name nothing throw a CLI::ParseError, which is wrong usage.
Checked<Subject> load_subject(const SubjectOptions&);

// The run of the subject; what turns out impossible on the way is named at its place in the document.
template <Scalar S>
Checked<Run<S>> record(const Subject& subject) {
  auto run = record<S>(*subject.algorithm, subject.inputs);
  if (run) return run;
  Diagnostics diagnostics;
  const Cursor root(subject.document, diagnostics);
  report_at(subject.lesson ? *root.optional("inputs") : root, run.diagnostics);
  return diagnostics;
}

// "22", "22-de-boor" and "de-boor" all find lessons/22-de-boor.json; also any file by its path.
Checked<std::filesystem::path> find_lesson(const std::string& given);

// The folder of a kind of files ("lessons", "exercises"): in the working folder or the nearest one around the program.
std::filesystem::path find_folder(const std::string& name);

// Prints diagnostics to standard error; the exit status for them.
int report(const Diagnostics&);

}  // namespace blossom
