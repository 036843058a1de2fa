#include "kernel/light_lines.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "kernel/tessellate.hpp"
#include "shapes.hpp"

namespace blossom {
namespace {

using namespace test;
using Vector = Point<double>;
const double pi = std::acos(-1.0);

Vector random_unit(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random);
  return glm::normalize(Vector(x, y, normal(random)));
}

TEST_CASE("isophotes are angles to the light", "[light_lines]") {
  CHECK(*isophote({0, 0, 1}, {0, 0, 3}) == 0);
  CHECK(*isophote({0, 0, 1}, {1, 0, 1}) == Approx(pi / 4));
  CHECK(*isophote({0, 0, 1}, {5, -1, 0}) == Approx(pi / 2));
  CHECK(*isophote({0, 0, 1}, {0, 0, -2}) == Approx(pi));
  CHECK(*isophote({0, 0, 1}, {1e-9, 0, 1}) == Approx(1e-9));
  CHECK_FALSE(isophote({0, 0, 0}, {0, 0, 1}));
}

TEST_CASE("isophotes of a sphere are its circles of latitude about the light", "[light_lines]") {
  const std::vector<double> at{0, 0.1, 0.25, 0.4, 0.5, 0.9, 1};
  SurfaceGrid grid;
  evaluate_grid(sphere(2), at, at, true, grid);
  VertexValues made;
  isophotes(grid.normals, {0, 0, 1}, made);
  CHECK(made.undefined.empty());
  REQUIRE(made.values.size() == grid.points.size());
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    CHECK(made.values[i] == Approx(std::acos(std::clamp(grid.points[i].z / 2, -1.0, 1.0))).margin(1e-7));
  }
}

TEST_CASE("a ray is reflected at the angle it comes in, in one plane with the normal", "[light_lines]") {
  std::mt19937 random(3);
  for (int k = 0; k < 50; ++k) {
    const Vector ray = 3.0 * random_unit(random), normal = random_unit(random);
    const Vector back = reflected(ray, normal);
    CHECK(glm::length(back) == Approx(3));
    CHECK(glm::dot(back, normal) == Approx(-glm::dot(ray, normal)).margin(1e-12));
    CHECK(std::abs(glm::dot(back, glm::cross(ray, normal))) < 1e-12);
    CHECK(glm::length(back - reflected(ray, -normal)) < 1e-12);
  }
}

TEST_CASE("a flat mirror shows parallel lines in their true distances", "[light_lines]") {
  // A mirror in z = 0, the eye at height 1 above (0, 0), the lines at height 3: by the mirrored eye at -1, the plane at
  // 3 is seen magnified by 4 from the point at 1.
  const LightLines lines{{0.5, 7, 3}, {0, 1, 0}, {1, 0, 0}};
  for (const double x : {-2.0, 0.0, 0.3, 1.5}) {
    for (const double y : {-1.0, 0.0, 4.0}) {
      const auto value = reflection_line({x, y, 0}, {0, 0, 1}, {{0, 0, 1}}, lines);
      REQUIRE(value);
      CHECK(*value == Approx(4 * x - 0.5));
    }
  }
}

TEST_CASE("reflected rays are found again by construction", "[light_lines]") {
  // A point, a place on the plane of the lines, and an eye: the mirror between them has the bisector as normal.
  for (unsigned seed = 0; seed < 50; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-2, 2);
    const Vector upright = random_unit(random);
    const Vector direction = glm::normalize(glm::cross(upright, random_unit(random)));
    const LightLines lines{random_unit(random), direction, Vector(glm::cross(upright, direction))};
    const Vector point = 3.0 * random_unit(random), eye = 5.0 * random_unit(random);
    const double along = uniform(random), value = uniform(random);
    const Vector lamp = lines.origin + lines.direction * along + lines.across * value;
    const Vector normal = glm::normalize(glm::normalize(eye - point) + glm::normalize(lamp - point));
    const auto found = reflection_line(point, normal, {eye}, lines);
    REQUIRE(found);
    CHECK(*found == Approx(value).margin(1e-9));
    const auto far = reflection_line(point, normal, {glm::normalize(eye - point), true}, lines);
    REQUIRE(far);
    CHECK(*far == Approx(value).margin(1e-9));
    const auto angle = reflection_angle(point, normal, {eye}, lines);
    REQUIRE(angle);
    const Vector up(glm::cross(lines.across, lines.direction));
    CHECK(*angle == Approx(std::atan2(glm::dot(lamp - point, lines.across), glm::dot(lamp - point, up))).margin(1e-9));
  }
}

TEST_CASE("rays that run away from the lines, or along them, have no value", "[light_lines]") {
  const LightLines lines{{0, 0, 3}, {0, 1, 0}, {1, 0, 0}};
  const Eye above{{0, 0, 1}, true};
  CHECK(*reflection_line({0, 0, 0}, {0, 0, 1}, above, lines) == 0);
  CHECK_FALSE(reflection_line({0, 0, 4}, {0, 0, 1}, above, lines));              // the plane lies behind
  CHECK_FALSE(reflection_line({0, 0, 0}, {1, 0, 0}, {{1, 0, 0}, true}, lines));  // along the plane
  CHECK_FALSE(reflection_line({0, 0, 0}, {0, 0, 0}, above, lines));              // no normal
  CHECK_FALSE(reflection_angle({0, 0, 0}, {0, 0, 0}, above, lines));
  CHECK_FALSE(reflection_angle({0, 0, 0}, {0, 1, 0}, {{0, 1, 0}, true}, lines));
  CHECK(*reflection_angle({0, 0, 4}, {0, 0, 1}, above, lines) == 0);

  VertexValues made;
  const std::vector<Vector> points{{0, 0, 0}, {0, 0, 4}, {1, 0, 0}}, normals(3, Vector(0, 0, 1));
  reflection_lines(points, normals, above, lines, false, made);
  CHECK(made.undefined == std::vector{1});
  CHECK(made.values == std::vector<double>{0, 0, 1});
  reflection_lines(points, normals, above, lines, true, made);
  CHECK(made.undefined.empty());
}

TEST_CASE("lines above a surface lie above it", "[light_lines]") {
  const auto lines = lines_above({-1, -2, 0}, {3, 2, 1});
  CHECK(lines.origin.z > 1);
  CHECK(lines.origin.x == 1);
  CHECK(reflection_line({0, 0, 1}, {0, 0, 1}, {{0, 0, 1}, true}, lines));
  CHECK(lines_above({1, 1, 1}, {1, 1, 1}).origin.z > 1);
}

TEST_CASE("a surface with a crease tears the stripes, a smooth one does not", "[light_lines]") {
  // Two parabolas side by side, of the same tangent at x = 0, or not.
  const auto jump = [](double slope) {
    const LightLines lines{{0, 0, 10}, {0, 1, 0}, {1, 0, 0}};
    const auto value = [&](double dz) {
      return *reflection_line({0, 0, 0}, glm::normalize(Vector(-dz, 0, 1)), {{0, 0, 1}, true}, lines);
    };
    return std::abs(value(slope) - value(0));
  };
  CHECK(jump(0) == 0);
  CHECK(jump(0.05) > 0.5);
}

TEST_CASE("stripes alternate, also below zero", "[light_lines]") {
  CHECK_FALSE(is_dark_stripe(0, 0.5));
  CHECK_FALSE(is_dark_stripe(0.49, 0.5));
  CHECK(is_dark_stripe(0.5, 0.5));
  CHECK_FALSE(is_dark_stripe(1, 0.5));
  CHECK(is_dark_stripe(-0.1, 0.5));
  CHECK_FALSE(is_dark_stripe(-0.6, 0.5));
}

}  // namespace
}  // namespace blossom
