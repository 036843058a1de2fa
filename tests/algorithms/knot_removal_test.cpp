// Knot removal: it undoes insertion exactly, and its bound is a bound.

#include "kernel/knot_removal.hpp"
#include "algorithms/curves.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Curve<Exact> removed(const Curve<Exact>& curve, const Exact& u, int times, const Exact& tolerance) {
  return both_ways<Exact>([&](auto& recorder) { return knot_removal(curve, u, times, tolerance, recorder); });
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

std::string mistake(const std::string& rest) {
  const auto read = inputs_of(*find_algorithm("knot_removal"),
                              R"({"curve": {"degree": 2, "knots": [0,0,0,1,1,2,3,3,3],
                                  "points": [[0,0],[1,2],[2,3],[3,2],[4,1],[5,0]]}, )" +
                                  rest + "}");
  return to_string(read.diagnostics);
}

}  // namespace

TEST_CASE("insertion and then removal give the curve back exactly", "[knot_removal]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 5);
    const auto curve = random_curve(random, p, random_int(random, 1, 4), p, seed % 3 != 0, seed % 2 == 0);
    const Exact u = any_parameter(random, curve);
    const int s = multiplicity(std::span<const Exact>(curve.knots), u);
    if (!(curve.domain_begin() < u && u < curve.domain_end()) || s >= p) continue;
    const int times = random_int(random, 1, p - s);
    INFO("degree " << p << ", u = " << u.to_string() << ", " << times << " times");
    NoRecorder<Exact> none;
    const auto refined = knot_insertion(curve, u, times, none);
    CHECK(removed(refined, u, times, Exact(0)) == curve);
    // In double, too, to rounding.
    NoRecorder<double> plain;
    const auto rounded = knot_removal(convert<double>(refined), u.to_double(), times, 0.0, plain);
    REQUIRE(rounded.points.size() == curve.points.size());
    for (std::size_t i = 0; i < curve.points.size(); ++i)
      for (int c = 0; c < 4; ++c)
        CHECK(std::abs(rounded.points[i][c] - curve.points[i][c].to_double()) <= 1e-7 * largest_coordinate(curve));
  }
}

TEST_CASE("no point of the curve moves farther than the bound", "[knot_removal]") {
  int tight = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 4);
    const auto curve =
        random_curve(random, p, random_int(random, 2, 4), seed % 4 == 0 ? p + 1 : p, seed % 3 != 0, seed % 2 == 0);
    std::vector<Exact> inner;
    for (const Exact& u : curve.knots)
      if (curve.domain_begin() < u && u < curve.domain_end()) inner.push_back(u);
    const Exact u = inner[static_cast<std::size_t>(random_int(random, 0, static_cast<int>(inner.size()) - 1))];
    const int s = multiplicity(std::span<const Exact>(curve.knots), u);
    TraceRecorder<Exact> recorder;
    const auto shorter = knot_removal(curve, u, 1, Exact(1000), recorder);
    REQUIRE(shorter.points.size() + 1 == curve.points.size());
    CHECK(multiplicity(std::span<const Exact>(shorter.knots), u) == s - 1);
    const double bound = recorder.trace().numbers(*recorder.trace().find("E"))[0].to_double();
    const double moved = farthest(curve, shorter);
    CHECK(moved <= bound * (1 + 1e-9));
    tight += moved > 0.2 * bound ? 1 : 0;
    // With a tolerance below the bound nothing happens.
    if (bound > 0) CHECK(removed(curve, u, s, Exact::ratio(1, 2) * Exact(bound)) == curve);
  }
  CHECK(tight > 20);  // the bound is not much larger than what it bounds
}

TEST_CASE("the book's equations by hand: a cubic with one knot too many", "[knot_removal]") {
  // (0,0), (0,6), (6,6), (6,0) with 1/2 inserted: (0,0), (0,3), (3,6), (6,3), (6,0).
  const auto run = run_of("knot_removal", R"({"curve": {"degree": 3, "knots": [0,0,0,0,"1/2",1,1,1,1],
      "points": [[0,0],[0,3],[3,6],[6,3],[6,0]]}, "u": "1/2"})");
  CHECK(number_of(run, "removal[1].r") == Exact(4));
  CHECK(point_of(run, "removal[1].L[1]") == std::vector<Exact>{0, 6});
  CHECK(point_of(run, "removal[1].R[2]") == std::vector<Exact>{6, 6});
  CHECK(point_of(run, "removal[1].M") == std::vector<Exact>{3, 6});
  CHECK(number_of(run, "E") == Exact(0));
  const auto& curve = std::get<Curve<Exact>>(run.outcome);
  CHECK(curve.knots == bezier_knots<Exact>(3));
  CHECK(curve.points.size() == 4);
}

TEST_CASE("a jump closes when both its points coincide", "[knot_removal]") {
  Curve<Exact> curve = plane_curve(1, knots({"0", "0", "1", "1", "2", "2"}), {{0, 0}, {1, 1}, {1, 1}, {2, 0}});
  const auto closed = removed(curve, Exact(1), 1, Exact(0));
  CHECK(closed.points.size() == 3);
  curve.points[2].y = Exact(2);
  CHECK(removed(curve, Exact(1), 1, Exact(0)) == curve);
  CHECK(removed(curve, Exact(1), 1, Exact(1)).points.size() == 3);
}

TEST_CASE("only as many are removed as the tolerance allows, and it is said how many", "[knot_removal]") {
  // A corner: taking out the first copy moves (2, 0) by half a diagonal, then both sides miss each other by 2.
  const auto run = [](const char* rest) {
    return run_of("knot_removal", std::string(R"({"curve": {"degree": 2, "knots": [0,0,0,1,1,2,2,2],
      "points": [[0,0],[1,0],[2,0],[2,1],[2,4]]}, "u": 1, )") +
                                      rest + "}");
  };
  CHECK(number_of(run(R"("times": 2)"), "h") == Exact(0));
  CHECK(number_of(run(R"("times": 2, "tolerance": 1)"), "h") == Exact(1));
  CHECK(number_of(run(R"("times": 2, "tolerance": 9)"), "h") == Exact(2));
}

TEST_CASE("what knot removal cannot do is told", "[knot_removal]") {
  CHECK(mistake(R"("u": 0)").find("u: must be a knot between the ends of the domain: 1, 2") != std::string::npos);
  CHECK(mistake(R"("u": "1/2")").find("u: must be a knot between the ends of the domain: 1, 2") != std::string::npos);
  CHECK(mistake(R"("u": 2, "times": 2)").find("times: must be at most 1 here, the multiplicity of u") !=
        std::string::npos);
  CHECK(mistake(R"("u": 2, "tolerance": -1)").find("tolerance: must not be negative") != std::string::npos);
  CHECK(mistake(R"("u": 1, "times": 2)").empty());
}
