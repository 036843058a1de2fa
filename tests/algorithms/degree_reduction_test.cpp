// Degree reduction: it undoes elevation exactly, keeps the ends, and its error is a bound.

#include "kernel/degree_reduction.hpp"
#include "algorithms/curves.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Curve<Exact> elevated(const Curve<Exact>& curve, int times) {
  NoRecorder<Exact> none;
  return degree_elevation(curve, times, none);
}

Curve<Exact> reduced(const Curve<Exact>& curve, const Exact& tolerance = Exact(0)) {
  return both_ways<Exact>([&](auto& recorder) { return degree_reduction(curve, tolerance, recorder); });
}

Curve<Exact> random_bezier(std::mt19937& random, int p, bool rational) {
  auto curve = random_curve(random, p, 1, 1, true, rational);
  curve.knots = bezier_knots<Exact>(p);
  curve.bezier = true;
  return curve;
}

double farthest(const Curve<Exact>& a, const Curve<Exact>& b) {
  double largest = 0;
  for (const Exact& u : telling_parameters(a, b)) {
    const auto A = homogeneous_point(a, u), B = homogeneous_point(b, u);
    double square = 0;
    for (int c = 0; c < 4; ++c) square += std::pow((A[c] - B[c]).to_double(), 2);
    largest = std::max(largest, std::sqrt(square));
  }
  return largest;
}

double bound_of(const Curve<Exact>& curve, const Exact& tolerance, Curve<Exact>& made) {
  TraceRecorder<Exact> recorder;
  made = degree_reduction(curve, tolerance, recorder);
  return recorder.trace().numbers(*recorder.trace().find("E"))[0].to_double();
}

}  // namespace

TEST_CASE("elevation and then reduction give the curve back exactly", "[degree_reduction]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 6);
    const bool rational = seed % 2 == 0;
    const auto curve =
        seed % 3 == 0 ? random_bezier(random, p, rational)
                      : random_curve(random, p, random_int(random, 1, 4), seed % 5 == 0 ? p + 1 : p, true, rational);
    INFO("seed " << seed << ", degree " << p);
    CHECK(reduced(elevated(curve, 1)) == curve);
    CHECK(reduced(reduced(elevated(curve, 2))) == curve);
    // In double, too, to rounding: the knots are found to be unneeded.
    NoRecorder<double> none;
    const auto rounded = degree_reduction(convert<double>(elevated(curve, 1)), 0.0, none);
    REQUIRE(rounded.points.size() == curve.points.size());
    for (std::size_t i = 0; i < curve.points.size(); ++i)
      for (int c = 0; c < 4; ++c)
        CHECK(std::abs(rounded.points[i][c] - curve.points[i][c].to_double()) <= 1e-6 * largest_coordinate(curve));
  }
}

TEST_CASE("an unclamped curve comes back as the same curve, clamped", "[degree_reduction]") {
  for (unsigned seed = 1; seed <= 15; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 4);
    const auto curve = random_curve(random, p, random_int(random, 1, 4), p, false, seed % 2 == 0);
    const auto back = reduced(elevated(curve, 1));
    CHECK(back.degree == p);
    CHECK(same_curve(back, curve));
    CHECK(multiplicity(std::span<const Exact>(back.knots), curve.domain_begin()) == p + 1);
  }
}

TEST_CASE("the ends stay, and no point moves farther than the bound", "[degree_reduction]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 2, 6);
    const auto curve = seed % 2 == 0
                           ? random_bezier(random, p, seed % 4 == 0)
                           : random_curve(random, p, random_int(random, 1, 4), p, seed % 3 != 0, seed % 5 == 0);
    for (const char* tolerance : {"0", "3"}) {
      Curve<Exact> made;
      const double bound = bound_of(curve, q(tolerance), made);
      const double moved = farthest(curve, made);
      CHECK(made.degree == p - 1);
      CHECK(made.rational == curve.rational);
      CHECK(moved <= bound * (1 + 1e-9));
      CHECK(homogeneous_point(made, made.domain_begin()) == homogeneous_point(curve, curve.domain_begin()));
      CHECK(homogeneous_point(made, made.domain_end()) == homogeneous_point(curve, curve.domain_end()));
      if (curve.bezier) {
        CHECK(made.bezier);
        CHECK(moved >= 0.05 * bound);  // the bound is not much larger than what it bounds
      }
    }
  }
}

TEST_CASE("by hand: a parabola becomes its chord, a cubic the parabola half way", "[degree_reduction]") {
  const auto line = run_of("degree_reduction", R"({"curve": {"degree": 2, "points": [[0,0],[2,4],[4,0]]}})");
  CHECK(point_of(line, "Q[1]") == std::vector<Exact>{4, 0});
  CHECK(number_of(line, "E") == Exact(4));  // the curve's top, at height 2, moves by 2: half of the bound

  // (0,0), (-1,2), (1,2), (3,0) reduces from the left to (-3/2, 3), from the right to (0, 3): half way (-3/4, 3).
  const auto cubic = run_of("degree_reduction", R"({"curve": {"degree": 3, "points": [[0,0],[-1,2],[1,2],[3,0]]}})");
  CHECK(point_of(cubic, "L[0]") == std::vector<Exact>{q("-3/2"), 3});
  CHECK(point_of(cubic, "R[0]") == std::vector<Exact>{0, 3});
  CHECK(point_of(cubic, "Q[1]") == std::vector<Exact>{q("-3/4"), 3});
  CHECK(number_of(cubic, "E") == q("1/2"));  // (1 - 1/3) / 2 * 3/2

  // The NURBS Book's elevated quadratic, back again.
  const auto back = run_of("degree_reduction", R"({"curve": {"degree": 3, "points": [[-3,0],[-1,2],[1,2],[3,0]]}})");
  CHECK(point_of(back, "Q[1]") == std::vector<Exact>{0, 3});
  CHECK(number_of(back, "E") == Exact(0));
}

TEST_CASE("a line has no degree to lose", "[degree_reduction]") {
  const auto message = [](const char* rest) {
    return to_string(inputs_of(*find_algorithm("degree_reduction"), std::string("{") + rest + "}").diagnostics);
  };
  CHECK(message(R"("curve": {"degree": 1, "points": [[0,0],[1,1]]})")
            .find("curve: must have a degree of at least 2 to be reduced, not 1") != std::string::npos);
  CHECK(message(R"("curve": {"degree": 2, "points": [[0,0],[1,1],[2,0]]}, "tolerance": -1)")
            .find("tolerance: must not be negative") != std::string::npos);
}
