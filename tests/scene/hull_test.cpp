// Convex hulls in a lesson's picture: which beats say so, and how they are drawn.

#include "scene/beat_look.hpp"
#include "scene/hull_shape.hpp"
#include "scene/recording.hpp"
#include "scene/shipped_lessons.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Lesson lesson_with(const std::string& beats) {
  const auto document = JsonDocument::parse("lesson.json", R"({"schema": "blossom.lesson/1", "id": "hulls", "title":
    "Hulls", "algorithm": "de_casteljau", "inputs": {"curve": {"degree": 3, "points":
    [[0, 0], [1, 4], [5, 4], [6, 0]]}, "u": "1/2"}, "beats": [)" +
                                                               beats + "]}");
  REQUIRE(document);
  auto lesson = load_lesson(*document);
  INFO(to_string(lesson.diagnostics));
  REQUIRE(lesson);
  return *std::move(lesson);
}

}  // namespace

TEST_CASE("A hull holds until another beat has one, and grows with the points that are made") {
  const Lesson lesson = lesson_with(R"({"at": "start", "say": "A.", "hull": ["P[0][*]", "P[1][*]"]},
    {"at": "P[2][0]", "say": "B."}, {"at": "P[2][1]", "say": "C.", "hull": ["P[2][*]"]},
    {"at": "end", "say": "D.", "hull": []})");
  const auto recording = Recording::make(*lesson.algorithm, lesson.inputs, true);
  REQUIRE(recording);
  const auto beats = (*recording)->beats(lesson);
  const auto sizes = [&](std::uint32_t step) {
    std::vector<std::size_t> found;
    for (const auto& hull : hulls_in_force(beats, (*recording)->source(), step)) found.push_back(hull.size());
    return found;
  };
  using Sizes = std::vector<std::size_t>;
  CHECK(sizes(0) == Sizes{4});  // of level 1 there is nothing yet
  CHECK(sizes(1) == Sizes{4});  // one point has no hull
  CHECK(sizes(2) == Sizes{4, 2});
  CHECK(sizes(4) == Sizes{4, 3});
  CHECK(sizes(5) == Sizes{2});
  CHECK(sizes((*recording)->last()) == Sizes{});
}

TEST_CASE("In the plane a hull is a polygon below everything else") {
  const auto lesson = prepare<double>("convex-hull");
  ViewportOptions options;
  const auto point = [&](const char* name) { return lesson->run.trace.find(name).value(); };
  options.hulls = {{point("P[0][0]"), point("P[0][1]"), point("P[0][2]"), point("P[0][3]")}};
  const View view = lesson->scenes.viewport(0, 700, 500, options).view;
  REQUIRE(view.polygons.size() == 1);
  CHECK(view.polygons[0].points.size() == 4);
  CHECK(lesson->scenes.viewport(0, 700, 500, ViewportOptions{}).view.polygons.empty());
}

TEST_CASE("In space a hull has faces one can see through, and each edge once") {
  View view;
  view.camera.kind = Camera::Kind::orbit;
  const std::vector<Point<double>> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.1, 0.1}};
  add_hull(view, corners);
  REQUIRE(view.meshes.size() == 1);
  CHECK(view.meshes[0].indices.size() == 4 * 3);
  CHECK(view.meshes[0].opacity < 1);
  CHECK(view.polylines.size() == 6);
}

TEST_CASE("Of points in a line a hull is a segment, of one nothing") {
  View view;
  add_hull(view, std::vector<Point<double>>{{0, 0, 0}, {2, 2, 0}, {1, 1, 0}});
  CHECK(view.polygons.empty());
  REQUIRE(view.polylines.size() == 1);
  CHECK(view.polylines[0].points.size() == 2);
  add_hull(view, std::vector<Point<double>>{{1, 1, 0}});
  CHECK(view.polylines.size() == 1);
}
