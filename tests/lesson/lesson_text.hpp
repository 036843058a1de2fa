#pragma once
// Lessons as tests write them: a header, a run, beats.

#include <catch2/catch.hpp>

#include "lesson/lesson.hpp"

namespace blossom::test {

inline JsonDocument parsed(const std::string& text, const std::string& name = "lesson.json") {
  auto document = JsonDocument::parse(name, text);
  INFO(to_string(document.diagnostics));
  REQUIRE(document);
  return *std::move(document);
}

inline const std::string header = R"({"schema": "blossom.lesson/1", "id": "a-lesson", "title": "A lesson", )";
inline const std::string parabola = R"("algorithm": "de_casteljau",
  "inputs": {"curve": {"degree": 2, "points": [[0, 0], [2, 4], [4, 0]]}, "u": "1/4"}, )";
inline const std::string spline = R"("algorithm": "de_boor",
  "inputs": {"curve": {"degree": 2, "knots": [0, 0, 0, 1, 2, 2, 2], "points": [[0, 0], [2, 4], [4, 0], [6, 2]]},
             "u": "1/2"}, )";
inline const std::string raised = R"("algorithm": "degree_elevation",
  "inputs": {"curve": {"degree": 1, "knots": [0, 0, 1, 2, 2], "points": [[0, 0], [2, 4], [4, 0]]}, "times": 2}, )";

// Of a lesson on the parabola with these beats: what is wrong.
inline std::string mistakes(const std::string& beats, const std::string& run = parabola,
                            const std::string& head = header) {
  const auto lesson = load_lesson(parsed(head + run + "\n\"beats\": [" + beats + "]}"));
  CHECK(lesson.value.has_value() == lesson.diagnostics.empty());  // a lesson or reasons, never both, never neither
  return to_string(lesson.diagnostics);
}

inline Lesson lesson_of(const std::string& beats, const std::string& run = parabola, const std::string& head = header) {
  auto lesson = load_lesson(parsed(head + run + "\"beats\": [" + beats + "]}"));
  INFO(to_string(lesson.diagnostics));
  REQUIRE(lesson);
  return *std::move(lesson);
}

inline std::string beat(const std::string& at, const std::string& say = "Look.") {
  return "{\"at\": " + at + ", \"say\": \"" + say + "\"}";
}

// At this place, with one more key: beat_with("\"start\"", R"("pause": 2)").
inline std::string beat_with(const std::string& at, const std::string& more) {
  return "{\"at\": " + at + ", \"say\": \"Look.\",\n" + more + "}";
}

}  // namespace blossom::test
