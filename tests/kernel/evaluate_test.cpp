#include "kernel/evaluate.hpp"

#include <catch2/catch.hpp>
#include <limits>
#include <vector>

#include "kernel/blossom.hpp"
#include "kernel/evaluator.hpp"
#include "splines.hpp"

namespace blossom {
namespace {

using namespace test;

std::vector<Exact> exact(std::initializer_list<const char*> texts) {
  std::vector<Exact> result;
  for (const char* text : texts) result.push_back(q(text));
  return result;
}

void check_point(const std::optional<Point<Exact>>& P, const char* x, const char* y) {
  REQUIRE(P.has_value());
  CHECK(P->x.to_string() == q(x).to_string());
  CHECK(P->y.to_string() == q(y).to_string());
  CHECK(P->z == Exact(0));
}

// The quarter circle with the weights 1, 1, 2 (The NURBS Book, example 4.2).
Curve<Exact> quarter_circle() { return plane_curve(2, bezier_knots<Exact>(2), {{1, 0}, {1, 1}, {0, 1, 2}}); }

TEST_CASE("the point of The NURBS Book, example 4.1", "[evaluate]") {
  const auto curve =
      plane_curve(2, exact({"0", "0", "0", "1", "2", "3", "3", "3"}), {{0, 0}, {1, 1, 4}, {3, 2}, {4, 1}, {5, -1}});
  CHECK(homogeneous_point(curve, 1) == HPoint<Exact>(q("7/2"), q("3"), q("0"), q("5/2")));
  check_point(point(curve, 1), "7/5", "6/5");
}

TEST_CASE("a point of the rational quarter circle", "[evaluate]") {
  check_point(point(quarter_circle(), q("1/2")), "3/5", "4/5");
}

TEST_CASE("the weighted parabola needs the division by w", "[evaluate]") {
  const auto curve = plane_curve(2, bezier_knots<Exact>(2), {{0, 0}, {q("1/2"), 1, 10}, {1, 0}});
  check_point(point(curve, q("1/2")), "1/2", "10/11");
}

TEST_CASE("de Boor's weights in Shene's example", "[evaluate]") {
  // With P_i = (1 at i, else 0) the point's coordinate is the weight of P_i.
  for (int i = 0; i <= 6; ++i) {
    std::vector<PlanePoint> points(7, {0, 0});
    points[static_cast<std::size_t>(i)].x = 1;
    const auto curve = plane_curve(3, exact({"0", "0", "0", "0", "1/4", "1/2", "3/4", "1", "1", "1", "1"}), points);
    const auto weights = exact({"0", "2/125", "307/750", "202/375", "9/250", "0", "0"});
    CHECK(point(curve, q("2/5"))->x == weights[static_cast<std::size_t>(i)]);
  }
}

TEST_CASE("an unclamped uniform quadratic", "[evaluate]") {
  // The domain is [2, 4]; t = 0..1 runs through it.
  const auto curve = plane_curve(2, {0, 1, 2, 3, 4, 5, 6}, {{-1, 0}, {q("-.5"), q(".5")}, {q(".5"), q("-.5")}, {1, 0}});
  check_point(point(curve, 2), "-.75", ".25");
  check_point(point(curve, q("2.2")), "-.64", ".32");
  check_point(point(curve, 3), "0", "0");
  check_point(point(curve, 4), ".75", "-.25");
}

TEST_CASE("clamped curves begin and end in their end points, exactly, in double too", "[evaluate]") {
  for (int p = 1; p <= max_degree; ++p) {
    INFO("degree " << p);
    std::mt19937 random(static_cast<unsigned>(p));
    const auto curve = random_curve(random, p, 3, p, true, true);
    CHECK(homogeneous_point(curve, curve.domain_begin()) == curve.points.front());
    CHECK(homogeneous_point(curve, curve.domain_end()) == curve.points.back());
    const auto in_double = rounded(curve);
    CHECK(distance(homogeneous_point(in_double, in_double.domain_begin()), in_double.points.front()) < 1e-14);
    CHECK(distance(homogeneous_point(in_double, in_double.domain_end()), in_double.points.back()) < 1e-14);
  }
}

TEST_CASE("where the curve jumps, the value is the right limit; at the domain's end the left one", "[evaluate]") {
  const auto curve = plane_curve(1, {0, 0, 1, 1, 2, 2}, {{0, 0}, {1, 0}, {5, 5}, {6, 5}});
  check_point(point(curve, 1), "5", "5");
  check_point(point(curve, 2), "6", "5");

  // Unclamped, with a double knot at the domain's end u_4 = 2: the point of the piece on [1, 2], not of the next.
  const auto unclamped = plane_curve(2, {0, 0, 1, 2, 2, 2, 3}, {{0, 0}, {1, 0}, {2, 3}, {7, 7}});
  check_point(point(unclamped, 2), "2", "3");
}

TEST_CASE("a curve point is the blossom's diagonal: all degrees, both scalars, knots included", "[evaluate]") {
  for (unsigned seed = 0; seed < 75; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = static_cast<int>(seed) % max_degree + 1;
    const auto curve = random_curve(random, p, 3, p + 1, seed % 2 == 0, seed % 3 != 0);
    const auto in_double = rounded(curve);
    const CurveEvaluator evaluator(in_double);
    std::vector<Exact> parameters(curve.knots.begin() + p, curve.knots.end() - p);
    for (int i = 0; i < 3; ++i) parameters.push_back(random_parameter(random, curve.knots, p));
    for (const Exact& u : parameters) {
      const std::vector<Exact> diagonal(static_cast<std::size_t>(p), u);
      const HPoint<Exact> C = homogeneous_point(curve, u);
      CHECK(C == blossom::blossom<Exact>(curve, find_span<Exact>(curve.knots, p, u), diagonal));
      const HPoint<double> D = homogeneous_point(in_double, u.to_double());
      CHECK(distance(D, rounded(C)) < 1e-12);
      CHECK(distance(evaluator.homogeneous_point(u.to_double()), rounded(C)) < 1e-12);
    }
  }
}

TEST_CASE("a zero denominator gives no point, and never a NaN", "[evaluate]") {
  SECTION("an end point with weight zero") {
    const auto curve = plane_curve(2, bezier_knots<Exact>(2), {{1, 0}, {1, 1}, {0, 1}});
    auto at_infinity = curve;
    at_infinity.points[2] = {0, 1, 0, 0};  // the direction (0, 1)
    CHECK_FALSE(point(at_infinity, 1).has_value());
    CHECK_FALSE(point(rounded(at_infinity), 1.0).has_value());
    CHECK_FALSE(CurveEvaluator(rounded(at_infinity)).point(1.0).has_value());
    check_point(point(at_infinity, q("1/2")), "1", "1");
  }
  SECTION("a control point at infinity makes the semicircle") {
    auto semicircle = plane_curve(2, bezier_knots<Exact>(2), {{1, 0}, {0, 0}, {-1, 0}});
    semicircle.points[1] = {0, 1, 0, 0};
    check_point(point(semicircle, q("1/2")), "0", "1");
    check_point(point(semicircle, q("1/3")), "3/5", "4/5");
  }
  SECTION("all weights zero") {
    auto nowhere = plane_curve(1, bezier_knots<Exact>(1), {{0, 0}, {1, 1}});
    nowhere.points = {{0, 0, 0, 0}, {0, 0, 0, 0}};
    CHECK_FALSE(point(nowhere, q("1/2")).has_value());
    CHECK_FALSE(point(rounded(nowhere), 0.5).has_value());
  }
  SECTION("a weight too small to divide by") {
    CHECK_FALSE(affine_point(HPoint<double>(1, 1, 1, std::numeric_limits<double>::denorm_min())).has_value());
    CHECK_FALSE(affine_point(HPoint<double>(0, 0, 0, -0.0)).has_value());
  }
}

// S(u, v) as a point of the curve in v whose control points are points of the curves in u.
HPoint<Exact> curve_of_curves(const Surface<Exact>& surface, const Exact& u, const Exact& v) {
  Curve<Exact> across{surface.degree[1], surface.knots[1], {}, 3, true, false};
  for (int j = 0; j < surface.columns; ++j) {
    Curve<Exact> column{surface.degree[0], surface.knots[0], {}, 3, true, false};
    for (int i = 0; i < surface.rows; ++i) column.points.push_back(surface.at(i, j));
    across.points.push_back(homogeneous_point(column, u));
  }
  return homogeneous_point(across, v);
}

TEST_CASE("a surface point is a curve of curves, in both scalars, with the evaluator too", "[evaluate]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 5);
    const int q = seed % 4 == 0 ? p : random_int(random, 1, 5);
    const auto surface = random_surface(random, p, q, 3, seed % 2 == 0, seed % 3 == 0);
    const auto in_double = rounded(surface);
    const SurfaceEvaluator evaluator(in_double);
    for (int times = 0; times < 5; ++times) {
      const Exact u = times == 0 ? surface.knots[0][surface.rows] : random_parameter(random, surface.knots[0], p);
      const Exact v = random_parameter(random, surface.knots[1], q);
      const HPoint<Exact> S = homogeneous_point(surface, u, v);
      CHECK(S == curve_of_curves(surface, u, v));
      const HPoint<double> D = homogeneous_point(in_double, u.to_double(), v.to_double());
      CHECK(distance(D, rounded(S)) < 1e-12);
      CHECK(D == evaluator.homogeneous_point(u.to_double(), v.to_double()));
      CHECK(evaluator.point(u.to_double(), v.to_double()) == point(in_double, u.to_double(), v.to_double()));
    }
  }
}

TEST_CASE("the evaluators' span table finds what find_span finds, on any knots", "[evaluate]") {
  const auto check = [](const std::vector<double>& U, int p, double u) {
    const SpanTable table(U, p);
    CHECK(table.span(table.find(u)) == find_span<double>(U, p, u));
  };
  for (unsigned seed = 0; seed < 100; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 4);
    auto U = rounded(random_knots(random, p, random_int(random, 1, 30), p + 1, seed % 2 == 0));
    // Half of them with knots that crowd together, so that a bucket holds many: u -> exp(4u).
    if (seed % 4 < 2) {
      for (double& u : U) u = std::exp(4 * u);
    }
    const double begin = U[p], end = U[U.size() - p - 1];
    for (std::size_t i = p; i < U.size() - p; ++i) {
      check(U, p, U[i]);
      check(U, p, std::clamp(std::nextafter(U[i], begin), begin, end));
      check(U, p, std::clamp(std::nextafter(U[i], end), begin, end));
    }
    for (int i = 0; i <= 20; ++i) check(U, p, std::min(end, begin + (end - begin) * i / 20));
  }
  SECTION("and on a domain too small, or too large, for the buckets") {
    const double tiny = std::numeric_limits<double>::denorm_min();
    for (double u : {0.0, tiny, 2 * tiny, 3 * tiny}) check({0, 0, tiny, 2 * tiny, 3 * tiny, 3 * tiny}, 1, u);
    for (double u : {-1.7e308, -1e308, 0.0, 1e308, 1.7e308}) {
      check({-1.7e308, -1.7e308, -1e307, 1e307, 1.7e308, 1.7e308}, 1, u);
    }
  }
}

}  // namespace
}  // namespace blossom
