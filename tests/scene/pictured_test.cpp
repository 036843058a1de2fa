// Curves that inputs stand for, and vectors where they stand, by what the algorithms' tables say of them.

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "scene/shipped_lessons.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

std::vector<Polyline> lines_of(const View& view, bool arrows) {
  std::vector<Polyline> found;
  for (const Polyline& line : view.polylines)
    if (line.arrow == arrows) found.push_back(line);
  return found;
}

}  // namespace

TEST_CASE("The curve of given coefficients is drawn before anything is computed") {
  const auto lesson = prepare("parametric-curves");  // from (0, 0) to (4, 0), its top at (2, 1)
  const View view = lesson->scenes.viewport(0, 700, 500);
  const auto curve = std::ranges::find(view.polylines, Role::curve, &Polyline::role);
  REQUIRE(curve != view.polylines.end());
  CHECK(glm::length(curve->points.front() - glm::dvec3(0, 0, 0)) < 1e-12);
  CHECK(glm::length(curve->points.back() - glm::dvec3(4, 0, 0)) < 1e-12);
  CHECK(std::ranges::any_of(curve->points,
                            [](const glm::dvec3& at) { return glm::length(at - glm::dvec3(2, 1, 0)) < 1e-9; }));
}

TEST_CASE("Coefficients are arrows from the first of them, the tangent vector is one from the point") {
  const auto lesson = prepare("parametric-curves");
  const auto first = lines_of(lesson->scenes.viewport(0, 700, 500), true);
  REQUIRE(first.size() == 2);  // a[1] and a[2]
  for (const Polyline& arrow : first) CHECK(glm::length(arrow.points.front()) < 1e-12);
  // At the end what was used up is gone: the mean velocity is left, the last operand, and C'(1/4) at (1, 3/4).
  const auto last = lines_of(lesson->scenes.viewport(lesson->step_count() - 1, 700, 500), true);
  REQUIRE(last.size() == 3);
  const Polyline& tangent = last.back();
  CHECK(glm::length(tangent.points.front() - glm::dvec3(1, 0.75, 0)) < 1e-12);
  const glm::dvec3 along = tangent.points.back() - tangent.points.front();
  CHECK(std::abs(along.x - 2 * along.y) < 1e-12);  // along (4, 2)
  CHECK(along.y > 0);
}

TEST_CASE("A line through two points reaches as far as the control points do") {
  const auto lesson = prepare("variation-diminishing");  // the x-axis, control points from x = 0 to 6
  const View view = lesson->scenes.viewport(0, 700, 500);
  const bool reaches = std::ranges::any_of(view.polylines, [](const Polyline& line) {
    return line.role == Role::curve && line.points.front().x <= 0 && line.points.back().x >= 6 &&
           line.points.front().y == 0 && line.points.back().y == 0;
  });
  CHECK(reaches);
}
