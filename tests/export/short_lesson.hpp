#pragma once
// A short lesson with everything that exports have to tell: words, a camera, pauses, questions of several kinds.

#include <catch2/catch.hpp>

#include "export/export.hpp"

namespace blossom::test {

inline constexpr const char* short_lesson = R"({
  "schema": "blossom.lesson/1", "id": "short", "title": "A point on a parabola & more",
  "unit": "Bézier curves", "summary": "Three points, two divisions, *one* point.", "minutes": 5,
  "objectives": ["Divide a leg at $u$"],
  "algorithm": "de_casteljau",
  "inputs": {"curve": {"degree": 2, "points": [[0, 0], [2, 4], [4, 0]]}, "u": "1/4"},
  "beats": [
    {"at": "start", "say": "Three control points make a parabola. Where is its point at $u = \\value{u}$?", "pause": 2},
    {"at": "P[1][0]", "say": "Walk {u} of the way along the first leg: that is **{value}**.",
     "highlight": ["P[0][0..1]"], "camera": {"fit": ["P[0][0..1]"]},
     "checkpoint": {"id": "next", "kind": "choice", "ask": "And then?",
                    "choices": [{"text": "the second leg", "right": true, "feedback": "Yes."},
                                {"text": "nothing", "feedback": "There is another leg."}]}},
    {"at": "C", "say": "And there it is: C = {C}."}
  ]
})";

inline Story story_of(const std::string& text, const StoryOptions& options = {}) {
  const auto document = JsonDocument::parse("short.json", text);
  REQUIRE(document);
  const auto lesson = load_lesson(*document);
  INFO(to_string(lesson.diagnostics));
  REQUIRE(lesson);
  auto story = make_story(*lesson, options);
  INFO(to_string(story.diagnostics));
  REQUIRE(story);
  return std::move(*story);
}

inline LessonExportOptions small_pages() {
  LessonExportOptions options;
  options.theme = &light_theme();
  options.width = 640;
  options.height = 480;
  return options;
}

}  // namespace blossom::test
