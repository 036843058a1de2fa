#include "kernel/tessellate.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "splines.hpp"

namespace blossom {
namespace {

using namespace test;

TEST_CASE("span_parameters goes through each nonempty span in equal steps, knots included", "[tessellate]") {
  const std::vector<double> U{0, 0, 0, 1, 1, 3, 3, 3};
  std::vector<double> parameters{99};
  span_parameters(U, 2, 2, parameters);
  CHECK(parameters == std::vector<double>{0, 0.5, 1, 2, 3});
  span_parameters(std::vector<double>{0, 1, 2, 3, 4, 5, 6}, 2, 1, parameters);
  CHECK(parameters == std::vector<double>{2, 3, 4});
}

TEST_CASE("samples of a continuous curve are its points, in one piece", "[tessellate]") {
  CurveSamples samples;
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 6);
    const auto curve = rounded(random_curve(random, p, 4, p, seed % 2 == 0, seed % 3 == 0));
    sample_curve(curve, 5, samples);
    std::vector<double> expected;
    span_parameters(curve.knots, p, 5, expected);
    CHECK(samples.u == expected);
    CHECK(samples.pieces == std::vector<std::size_t>{0});
    REQUIRE(samples.points.size() == samples.u.size());
    for (std::size_t i = 0; i < samples.u.size(); ++i) CHECK(samples.points[i] == *point(curve, samples.u[i]));
  }
}

TEST_CASE("a curve that jumps is sampled in pieces, with both limits at the jump", "[tessellate]") {
  const auto curve = rounded(plane_curve(1, {0, 0, 1, 1, 2, 2}, {{0, 0}, {1, 0}, {5, 5}, {6, 5}}));
  CurveSamples samples;
  sample_curve(curve, 2, samples);
  CHECK(samples.u == std::vector<double>{0, 0.5, 1, 1, 1.5, 2});
  CHECK(samples.pieces == std::vector<std::size_t>{0, 3});
  REQUIRE(samples.points.size() == 6);
  CHECK(samples.points[2] == Point<double>(1, 0, 0));
  CHECK(samples.points[3] == Point<double>(5, 5, 0));
}

TEST_CASE("a zero denominator interrupts the samples of a curve and leaves no NaN", "[tessellate]") {
  auto curve = rounded(plane_curve(1, {0, 0, 1, 2, 2}, {{0, 0}, {1, 0}, {2, 0}}));
  CurveSamples samples;
  SECTION("inside") {
    curve.points[1] = {1, 0, 0, 0};
    sample_curve(curve, 2, samples);
    CHECK(samples.u == std::vector<double>{0, 0.5, 1.5, 2});
    CHECK(samples.pieces == std::vector<std::size_t>{0, 2});
  }
  SECTION("everywhere") {
    for (auto& P : curve.points) P.w = 0;
    sample_curve(curve, 2, samples);
    CHECK(samples.points.empty());
    CHECK(samples.pieces.empty());
  }
}

TEST_CASE("a grid has the points and normals that single evaluation gives", "[tessellate]") {
  SurfaceGrid grid;  // one for all: what it held before must not matter
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 5), q = random_int(random, 1, 5);
    const auto surface = rounded(random_surface(random, p, q, 3, seed % 2 == 0, seed % 3 == 0));
    std::vector<double> u, v;
    span_parameters(surface.knots[0], p, 3, u);
    span_parameters(surface.knots[1], q, 2, v);
    std::shuffle(u.begin(), u.end(), random);
    for (const bool with_normals : {true, false}) {
      evaluate_grid(surface, u, v, with_normals, grid);
      REQUIRE(grid.points.size() == u.size() * v.size());
      REQUIRE(grid.normals.size() == (with_normals ? grid.points.size() : 0));
      CHECK(grid.undefined.empty());
      for (int a = 0; a < grid.rows; ++a) {
        for (int b = 0; b < grid.columns; ++b) {
          const int vertex = a * grid.columns + b;
          CHECK(distance(grid.points[vertex], *point(surface, u[a], v[b])) < 1e-12);
          if (!with_normals) continue;
          const auto normal = unit_normal(surface, u[a], v[b]);
          CHECK(distance(grid.normals[vertex], normal.value_or(Point<double>(0.0))) < 1e-9);
        }
      }
    }
  }
}

TEST_CASE("a vertex has the same bits whatever vertices are computed beside it", "[tessellate]") {
  std::mt19937 random(7);
  const auto surface = rounded(random_surface(random, 3, 3, 3, true, true));
  const double begin = surface.knots[1].front(), length = surface.knots[1].back() - begin;
  const std::vector<double> u{surface.knots[0].front(), surface.knots[0].back()};
  std::vector<double> v;
  SurfaceGrid grid, alone;
  for (int columns = 1; columns <= 9; ++columns) {
    INFO(columns << " columns");
    v.push_back(begin + length * columns / 10);
    evaluate_grid(surface, u, v, true, grid);
    for (int b = 0; b < columns; ++b) {
      evaluate_grid(surface, u, std::vector{v[b]}, true, alone);
      for (int a = 0; a < 2; ++a) {
        CHECK(grid.points[a * columns + b] == alone.points[a]);
        CHECK(grid.normals[a * columns + b] == alone.normals[a]);
      }
    }
  }
}

TEST_CASE("after control points moved, an updated grid is the grid evaluated anew", "[tessellate]") {
  SurfaceGrid grid, anew;
  for (unsigned seed = 0; seed < 60; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 4), q = random_int(random, 1, 4);
    auto surface = rounded(random_surface(random, p, q, 5, seed % 2 == 0, seed % 3 == 0));
    std::vector<double> u, v;
    span_parameters(surface.knots[0], p, 3, u);
    span_parameters(surface.knots[1], q, 4, v);
    if (seed % 5 == 0) std::shuffle(v.begin(), v.end(), random);
    const bool with_normals = seed % 4 != 0;
    evaluate_grid(surface, u, v, with_normals, grid);
    for (int k = 0; k < 4; ++k) {
      const int i = random_int(random, 0, surface.rows - 1), j = random_int(random, 0, surface.columns - 1);
      const int last_i = random_int(random, i, surface.rows - 1);
      const bool one = k % 2 == 0;
      for (int r = i; r <= (one ? i : last_i); ++r) {
        const auto moved = rounded(random_point(random, surface.rational));
        surface.at(r, j) = surface.rational && k == 2 ? HPoint<double>(1, 2, 3, 0) : moved;
      }
      const auto before = grid;
      const auto update = one ? update_grid(surface, grid, i, j) : update_grid(surface, grid, {i, last_i}, {j, j});
      evaluate_grid(surface, u, v, with_normals, anew);
      CHECK(grid.points == anew.points);
      CHECK(grid.normals == anew.normals);
      CHECK(grid.undefined == anew.undefined);
      REQUIRE_FALSE(update.empty());
      if (seed % 5 == 0) continue;
      // Nothing outside of the block has moved, and nothing in it is outside of the support.
      for (int vertex = 0; vertex < grid.rows * grid.columns; ++vertex) {
        const int a = vertex / grid.columns, b = vertex % grid.columns;
        const bool inside = update.first_a <= a && a <= update.last_a && update.first_b <= b && b <= update.last_b;
        if (!inside) CHECK(grid.points[vertex] == before.points[vertex]);
        if (inside && one) {
          CHECK((surface.knots[0][i] <= u[a] && u[a] <= surface.knots[0][i + p + 1]));
          CHECK((surface.knots[1][j] <= v[b] && v[b] <= surface.knots[1][j + q + 1]));
        }
      }
    }
  }
}

TEST_CASE("a control point that comes from infinity takes its vertices off the list of undefined ones",
          "[tessellate]") {
  Surface<double> surface{{1, 1}, {bezier_knots<double>(1), bezier_knots<double>(1)}, 2, 2, {}, true, true};
  surface.points = {{0, 0, 0, 1}, {1, 0, 0, 0}, {0, 1, 0, 1}, {1, 1, 1, 0}};
  const std::vector<double> ends{0, 0.5, 1};
  SurfaceGrid grid;
  evaluate_grid(surface, ends, ends, true, grid);
  CHECK(grid.undefined == std::vector<int>{2, 5, 8});
  surface.at(0, 1).w = 1;
  update_grid(surface, grid, 0, 1);
  CHECK(grid.undefined == std::vector<int>{8});
  surface.at(0, 1).w = 0;
  update_grid(surface, grid, 0, 1);
  CHECK(grid.undefined == std::vector<int>{2, 5, 8});
}

TEST_CASE("a grid has limit normals on a collapsed edge", "[tessellate]") {
  // A cone with its apex at v = 1: straight lines from the parabola (u, u^2, 0) to (0, 0, 1).
  Surface<double> cone{{2, 1}, {bezier_knots<double>(2), bezier_knots<double>(1)}, 3, 2, {}, false, true};
  cone.points = {{-1, 1, 0, 1}, {0, 0, 1, 1}, {0, -1, 0, 1}, {0, 0, 1, 1}, {1, 1, 0, 1}, {0, 0, 1, 1}};
  const std::vector<double> u{0, 0.25, 0.5, 1}, v{0, 0.5, 1};
  SurfaceGrid grid;
  evaluate_grid(cone, u, v, true, grid);
  for (int a = 0; a < grid.rows; ++a) {
    // Along a ruling of a cone the normal does not change; at u = 0 and 1 here too.
    CHECK(distance(grid.normals[a * 3 + 2], grid.normals[a * 3]) < 1e-12);
    CHECK(glm::length(grid.normals[a * 3 + 2]) == Approx(1));
  }
}

TEST_CASE("a grid names its vertices without a point, and holds no NaN", "[tessellate]") {
  Surface<double> surface{{1, 1}, {bezier_knots<double>(1), bezier_knots<double>(1)}, 2, 2, {}, true, true};
  surface.points = {{0, 0, 0, 1}, {1, 0, 0, 0}, {0, 1, 0, 1}, {1, 1, 1, 1}};
  const std::vector<double> ends{0, 0.5, 1};
  SurfaceGrid grid;
  for (const bool with_normals : {true, false}) {
    evaluate_grid(surface, ends, ends, with_normals, grid);
    CHECK(grid.undefined == std::vector<int>{2});
    CHECK(grid.points[2] == Point<double>(0, 0, 0));
    for (const auto& P : grid.points) CHECK(is_finite(P));
    for (const auto& N : grid.normals) CHECK(is_finite(N));
  }
}

}  // namespace
}  // namespace blossom
