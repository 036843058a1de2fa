#pragma once
// The shipped lessons, run and ready to be drawn, as the tests of scenes and of pictures look at them.

#include <catch2/catch.hpp>
#include <memory>
#include <stdexcept>

#include "lesson/catalog.hpp"
#include "scene/step_scene.hpp"

namespace blossom::test {

template <Scalar S>
struct PreparedLesson {
  std::string name;
  Lesson lesson;
  Run<S> run;
  Narrator<S> narrator;
  StepSource source;
  StepScenes scenes;

  // `digits` of decimals as the narrator takes them; 6 is what pictures have.
  PreparedLesson(const CatalogEntry& entry, Run<S> made, int digits)
      : name(entry.file.stem().string()),
        lesson(entry.lesson),
        run(std::move(made)),
        narrator(run, digits),
        source(make_source(narrator)),
        scenes(source) {}
  PreparedLesson(const PreparedLesson&) = delete;

  std::uint32_t step_count() const { return run.trace.step_count(); }
  std::string narration(std::uint32_t step) const { return lesson.narration(narrator, step); }
  Scene page(std::uint32_t step, double width = 1120, double height = 700) const {
    return scenes.page(step, narration(step), {width, height, lesson.title.own()});
  }
};

inline const Catalog& shipped_lessons() {
  static const Catalog catalog = load_catalog(std::string(BLOSSOM_SOURCE_DIR) + "/lessons");
  return catalog;
}

template <Scalar S>
std::unique_ptr<PreparedLesson<S>> prepare(const CatalogEntry& entry, int digits = 6) {
  auto made = record<S>(*entry.lesson.algorithm, entry.lesson.inputs);
  if (!made) throw std::runtime_error(to_string(made.diagnostics));
  return std::make_unique<PreparedLesson<S>>(entry, std::move(*made), digits);
}

template <Scalar S = Exact>
std::unique_ptr<PreparedLesson<S>> prepare(const std::string& id) {
  const auto* entry = shipped_lessons().find(id);
  if (entry == nullptr) throw std::runtime_error("there is no lesson " + id);
  return prepare<S>(*entry);
}

// `body(lesson, step)` at every step of every shipped lesson, with its name when it fails.
template <Scalar S, class Body>
void for_each_step(Body&& body) {
  REQUIRE(shipped_lessons().lessons.size() >= 8);
  for (const auto& entry : shipped_lessons().lessons) {
    const auto lesson = prepare<S>(entry);
    for (std::uint32_t step = 0; step < lesson->step_count(); ++step) {
      INFO(lesson->name << ", step " << step << ": " << lesson->narration(step));
      body(*lesson, step);
    }
  }
}

inline std::string plain_text(const RichText& runs) {
  std::string text;
  for (const TextRun& run : runs) text += run.text;
  return text;
}

}  // namespace blossom::test
