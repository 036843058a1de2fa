// Ruled surfaces: straight segments between the points of equal parameters of two curves.

#include "algorithms/construction.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Inputs<Exact> two(const Curve<Exact>& first, const Curve<Exact>& second) {
  Inputs<Exact> inputs;
  inputs.values.emplace("first", first);
  inputs.values.emplace("second", second);
  return inputs;
}

// A circle of radius r at height z as an exact cubic NURBS curve, beginning at r (cos, sin) for a quarter turn `turns`.
Curve<Exact> circle(int r, int z, int turns) {
  const std::vector<std::pair<int, int>> corners = {{1, 0}, {1, 2}, {-1, 2}, {-1, 0}, {-1, -2}, {1, -2}, {1, 0}};
  Curve<Exact> curve{3, knots({"0", "0", "0", "0", "1/2", "1/2", "1/2", "1", "1", "1", "1"}), {}, 3, true, false};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    auto [x, y] = corners[i];
    for (int k = 0; k < turns; ++k) std::tie(x, y) = std::pair(-y, x);
    const Exact w = i % 3 == 0 ? Exact(1) : Exact::ratio(1, 3);
    curve.points.emplace_back(w * Exact(r * x), w * Exact(r * y), w * Exact(z), w);
  }
  return curve;
}

}  // namespace

TEST_CASE("at v = 0 and v = 1 a ruled surface is its curves, and its rulings are straight", "[ruled]") {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    std::mt19937 random(seed);
    const auto draw = [&] {
      const int p = random_int(random, 1, 4);
      return random_curve(random, p, random_int(random, 1, 3), p, random_int(random, 0, 2) > 0,
                          random_int(random, 0, 1) == 1);
    };
    const auto first = draw(), second = draw();
    INFO("seed " << seed << "\n" << write_curve(first) << "\n" << write_curve(second));
    const auto surface = construct("ruled", two(first, second));
    CHECK(surface.degree[0] == std::max(first.degree, second.degree));
    CHECK(surface.degree[1] == 1);
    const Exact &begin = surface.knots[0].front(), &end = surface.knots[0].back();
    for (int i = 0; i <= 12; ++i) {
      const Exact t = Exact::ratio(i, 12), u = begin + (end - begin) * t;
      const auto A = homogeneous_point(first, at_share(first, t)), B = homogeneous_point(second, at_share(second, t));
      CHECK(homogeneous_point(surface, u, 0) == A);
      CHECK(homogeneous_point(surface, u, 1) == B);
      const Exact v = random_ratio(random, 0, 1, 16);
      CHECK(homogeneous_point(surface, u, v) == A * (Exact(1) - v) + B * v);
      const auto a = *affine_point(A), b = *affine_point(B), P = *point(surface, u, v);
      CHECK(cross(P - a, b - a) == Point<Exact>(0, 0, 0));
      CHECK(dot(P - a, P - b) <= Exact(0));  // between them
    }
  }
}

TEST_CASE("v divides a ruling evenly where the two curves have equal weights", "[ruled]") {
  const auto surface = construct("ruled", two(circle(2, 0, 0), circle(3, 4, 1)));
  std::mt19937 random(7);
  for (int i = 0; i < 20; ++i) {
    const Exact u = random_ratio(random, 0, 1, 24), v = random_ratio(random, 0, 1, 24);
    CHECK(*point(surface, u, v) == *point(circle(2, 0, 0), u) * (Exact(1) - v) + *point(circle(3, 4, 1), u) * v);
  }
}

TEST_CASE("two circles, one a quarter turn ahead, span a hyperboloid of one sheet", "[ruled]") {
  const auto surface = construct("ruled", two(circle(2, 0, 0), circle(2, 4, 1)));
  std::mt19937 random(3);
  for (int i = 0; i < 40; ++i) {
    const auto P = *point(surface, random_u(random, surface), random_v(random, surface));
    // x^2 + y^2 = 4 (1 - 2 t (1 - t)) at the height z = 4 t: the waist is half as wide in area.
    const Exact t = P.z / Exact(4);
    CHECK(P.x * P.x + P.y * P.y == Exact(4) * (Exact(1) - Exact(2) * t * (Exact(1) - t)));
  }
}
