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
  std::string scene;     // of a lesson that has several: its id or number; empty: the first
  std::string language;  // of what a lesson says; empty: its own
};
void add_subject_options(CLI::App&, SubjectOptions&);

struct Subject {
  const Algorithm* algorithm = nullptr;
  Inputs<Exact> inputs;
  std::optional<Lesson> lesson;
  std::size_t scene = 0;  // of the lesson
  std::string language;
  JsonDocument document;  // where the inputs stand: it is them, or has them as its member "inputs" if it is a lesson

  std::string title() const { return lesson ? printable(lesson->title.in(language)) : std::string(algorithm->title); }
  // "Scene 2 of 3: ...", with the way to the others; empty where there are no others.
  std::string scene_note() const;
  const LessonScene* lesson_scene() const { return lesson ? &lesson->scene_at(scene) : nullptr; }
  // The narration of a step: the lesson's, where it has something to say.
  template <Scalar S>
  std::string narration(const Narrator<S>& narrator, std::uint32_t step) const {
    return lesson ? lesson_scene()->narration(narrator, step, language) : narrator.text(step);
  }
};
// What is wrong in a file is a diagnostic; options that name nothing throw a CLI::ParseError, which is wrong usage.
Checked<Subject> load_subject(const SubjectOptions&);

// Diagnostics of a run of the subject, at the places in its document where its inputs stand.
Diagnostics at_inputs(const Subject&, const Diagnostics&);

template <Scalar S>
Checked<Run<S>> record(const Subject& subject) {
  auto run = record<S>(*subject.algorithm, subject.inputs);
  if (!run) run.diagnostics = at_inputs(subject, run.diagnostics);
  return run;
}

// "22", "22-de-boor" and "de-boor" all find lessons/22-de-boor.json; also any file by its path.
Checked<std::filesystem::path> find_lesson(const std::string& given);

// The folder of a kind of files ("lessons", "exercises"): in the working folder or the nearest one around the program.
std::filesystem::path find_folder(const std::string& name);

// Prints diagnostics to standard error; the exit status for them.
int report(const Diagnostics&);

}  // namespace blossom
