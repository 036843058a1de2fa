#include "kernel/hull.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <random>
#include <set>

#include "kernel/evaluate.hpp"
#include "splines.hpp"

namespace blossom {
namespace {

using namespace test;
using Vector = Point<double>;

// By its definition: the hull reaches as far as the points in every direction, and no point is outside of it.
void check_hull(const std::vector<Vector>& points, const Hull& hull) {
  double size = 0;
  Vector middle(0.0);
  for (const auto& P : points) middle += P / static_cast<double>(points.size());
  for (const auto& P : points) size = std::max(size, glm::length(P - middle));

  std::set<int> corners(hull.polygon.begin(), hull.polygon.end());
  for (const auto& t : hull.triangles) corners.insert(t.begin(), t.end());
  REQUIRE_FALSE(corners.empty());
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 50; ++k) {
    const Vector direction = glm::normalize(Vector(normal(random), normal(random), normal(random)));
    double reach = -1e300, corner_reach = -1e300;
    for (const auto& P : points) reach = std::max(reach, glm::dot(P - middle, direction));
    for (const int i : corners) corner_reach = std::max(corner_reach, glm::dot(points[i] - middle, direction));
    CHECK(corner_reach >= reach - 1e-8 * size);
  }

  std::map<std::pair<int, int>, int> edges;
  for (const auto& t : hull.triangles) {
    const Vector outwards = glm::cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
    for (const auto& P : points) CHECK(glm::dot(P - points[t[0]], outwards) <= 1e-10 * size * size * size);
    for (int side = 0; side < 3; ++side) ++edges[{t[side], t[(side + 1) % 3]}];
  }
  for (const auto& [edge, times] : edges) {
    CHECK(times == 1);
    CHECK(edges.count({edge.second, edge.first}) == 1);
  }
  // Euler's formula for closed surfaces of triangles.
  if (!hull.triangles.empty()) CHECK(hull.triangles.size() == 2 * corners.size() - 4);
}

double volume_of(const std::vector<Vector>& points, const Hull& hull) {
  double sum = 0;
  for (const auto& t : hull.triangles) sum += glm::dot(points[t[0]], glm::cross(points[t[1]], points[t[2]])) / 6;
  return sum;
}

TEST_CASE("the hull of plane points is their outer polygon, counterclockwise", "[hull]") {
  const std::vector<Vector> points{{1, 1, 0}, {0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {2, 2, 0},
                                   {0, 2, 0}, {2, 1, 0}, {2, 0, 0}, {0, 0, 0}};
  auto polygon = convex_hull(points).polygon;
  std::vector<Vector> corners;
  for (const int i : polygon) corners.push_back(points[i]);
  REQUIRE(corners.size() == 4);
  std::rotate(corners.begin(),
              std::min_element(corners.begin(), corners.end(),
                               [](const auto& A, const auto& B) { return A.x + A.y < B.x + B.y; }),
              corners.end());
  CHECK(corners == std::vector<Vector>{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
}

TEST_CASE("points that coincide have a point as hull, points of a line its ends", "[hull]") {
  CHECK(convex_hull({}).polygon.empty());
  CHECK(convex_hull(std::vector<Vector>(5, Vector(0.1, 0.2, 0.3))).polygon == std::vector{0});
  std::vector<Vector> line;
  for (const double s : {0.3, 0.7, -0.1, 0.2, 1.1, 0.3}) line.push_back(Vector(1, 2, 3) + s * Vector(0.1, -0.7, 0.3));
  const auto hull = convex_hull(line);
  CHECK(hull.polygon == std::vector{2, 4});
  CHECK(hull.triangles.empty());
}

TEST_CASE("a cube with points on its edges, faces and inside is twelve triangles' worth of volume", "[hull]") {
  std::vector<Vector> points;
  for (const double x : {-1, 0, 1})
    for (const double y : {-1, 0, 1})
      for (const double z : {-1, 0, 1}) points.emplace_back(x, y, z);
  for (unsigned seed = 0; seed < 20; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    std::shuffle(points.begin(), points.end(), random);
    const auto hull = convex_hull(points);
    CHECK(hull.polygon.empty());
    check_hull(points, hull);
    CHECK(volume_of(points, hull) == Approx(8));
  }
}

TEST_CASE("points of a slanted plane have a polygon as hull", "[hull]") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<Vector> points;
    const Vector a(0.3, 0.9, -0.2), b(-1.1, 0.1, 0.7);
    for (int i = 0; i < 12; ++i) points.push_back(Vector(5, 6, 7) + a * uniform(random) + b * uniform(random));
    const auto hull = convex_hull(points);
    CHECK(hull.triangles.empty());
    check_hull(points, hull);
    const auto m = hull.polygon.size();
    REQUIRE(m >= 3);
    const Vector up = glm::cross(a, b).z > 0 ? glm::cross(a, b) : glm::cross(b, a);
    for (std::size_t i = 0; i < m; ++i) {
      const Vector from = points[hull.polygon[i]], side = points[hull.polygon[(i + 1) % m]] - from;
      for (const auto& P : points) CHECK(glm::dot(glm::cross(side, P - from), up) >= -1e-10);
    }
  }
}

TEST_CASE("the hull of random points in space reaches as far as they do, and is closed", "[hull]") {
  for (unsigned seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    // Few values for each coordinate: many points that coincide, or lie on common lines and planes.
    const int values = seed % 2 == 0 ? 3 : 100000;
    std::uniform_int_distribution<int> coordinate(0, values);
    std::vector<Vector> points;
    const int count = random_int(random, 4, 30);
    const double scale = std::pow(10.0, static_cast<int>(seed % 7) * 20 - 60);
    for (int i = 0; i < count; ++i) {
      const double x = coordinate(random), y = coordinate(random);
      points.push_back(Vector(x, y, coordinate(random)) * (scale / values));
    }
    check_hull(points, convex_hull(points));
  }
}

TEST_CASE("a thin cloud still has a closed hull", "[hull]") {
  for (const double thin : {1e-3, 1e-6, 1e-8, 1e-10, 1e-14}) {
    INFO("thin " << thin);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-1, 1);
    std::vector<Vector> points;
    const Vector across = glm::normalize(Vector(1, 2, 3)), a = glm::normalize(Vector(3, 0, -1));
    for (int i = 0; i < 26; ++i) {
      points.push_back(a * uniform(random) + glm::cross(across, a) * uniform(random) +
                       across * (thin * uniform(random)));
    }
    check_hull(points, convex_hull(points));
  }
}

TEST_CASE("a curve's point lies in the hull of the control points in force", "[hull]") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const auto curve = rounded(random_curve(random, random_int(random, 3, 7), 3, 2, seed % 2 == 0, seed % 3 == 0));
    const double u = curve.domain_begin() + (curve.domain_end() - curve.domain_begin()) * 0.4;
    const int k = find_span<double>(curve.knots, curve.degree, u);
    std::vector<Vector> points;
    for (int i = k - curve.degree; i <= k; ++i) points.push_back(*affine_point(curve.points[i]));
    const auto hull = convex_hull(points);
    const Vector C = *point(curve, u);
    for (const auto& t : hull.triangles) {
      const Vector outwards = glm::cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
      CHECK(glm::dot(C - points[t[0]], outwards) <= 1e-9);
    }
    CHECK(hull.triangles.size() + hull.polygon.size() > 0);
  }
}

}  // namespace
}  // namespace blossom
