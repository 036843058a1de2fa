// Degree elevation: the same curve over the smallest knot vector of the higher degree.

#include "algorithms/curves.hpp"
#include "kernel/degree_elevation.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

void check_elevation(const Curve<Exact>& curve, int times) {
  INFO(times << " times: " << write_curve(curve));
  const auto made = both_ways<Exact>([&](auto& rec) { return degree_elevation(curve, times, rec); });
  CHECK(made.degree == curve.degree + times);
  CHECK(made.rational == curve.rational);
  CHECK(made.dimension == curve.dimension);
  REQUIRE(made.knots.size() == made.points.size() + static_cast<std::size_t>(made.degree) + 1);
  CHECK(std::is_sorted(made.knots.begin(), made.knots.end()));
  CHECK(same_curve(made, curve));

  // Minimal: inside the domain every knot `times` more often; at its ends so much that there is a domain of this
  // degree.
  for (std::size_t i = 0; i < made.knots.size(); ++i) {
    const Exact& u = made.knots[i];
    INFO("knot " << u.to_string());
    const int before = multiplicity<Exact>(curve.knots, u);
    const int after = multiplicity<Exact>(made.knots, u);
    if (curve.domain_begin() < u && u < curve.domain_end()) {
      CHECK(after == before + times);
    } else {
      CHECK(before > 0);
      CHECK(after <= before + times);
    }
  }
  for (const Exact& u : curve.knots)
    if (curve.domain_begin() < u && u < curve.domain_end()) CHECK(multiplicity<Exact>(made.knots, u) > 0);

  const auto rounded =
      both_ways<double>([&](auto& rec) { return degree_elevation(convert<double>(curve), times, rec); });
  CHECK(rounded.knots == convert<double>(made).knots);
  const double scale = largest_coordinate(curve) + largest_coordinate(made);
  for (std::size_t i = 0; i < made.points.size(); ++i)
    for (int c = 0; c < 4; ++c) CHECK(near(rounded.points[i][c], made.points[i][c].to_double(), scale));
}

}  // namespace

TEST_CASE("elevation by the formula for Bezier curves, of every degree", "[elevation]") {
  for (int p = 1; p < max_degree; ++p) {
    std::mt19937 random(static_cast<unsigned>(p));
    auto curve = random_curve(random, p, 1, 1, true, p % 2 == 0);
    curve.knots = bezier_knots<Exact>(p);
    INFO("p = " << p);
    NoRecorder<Exact> none;
    const auto made = degree_elevation(curve, 1, none);
    for (int i = 0; i <= p + 1; ++i) {
      HPoint<Exact> right(0, 0, 0, 0);
      if (i > 0) right += curve.points[static_cast<std::size_t>(i) - 1] * Exact::ratio(i, p + 1);
      if (i <= p) right += curve.points[static_cast<std::size_t>(i)] * Exact::ratio(p + 1 - i, p + 1);
      CHECK(made.points[static_cast<std::size_t>(i)] == right);
    }
    CHECK(made.knots == bezier_knots<Exact>(p + 1));
    check_elevation(curve, std::min(3, max_degree - p));
  }
}

TEST_CASE("several times in one go is several times one after the other", "[elevation]") {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    std::mt19937 random(seed);
    INFO("seed " << seed);
    const auto curve = random_curve(random, random_int(random, 1, 3), 3, 2, true, seed % 2 == 0);
    NoRecorder<Exact> none;
    CHECK(degree_elevation(curve, 2, none) == degree_elevation(degree_elevation(curve, 1, none), 1, none));
  }
}

TEST_CASE("elevation of B-splines, clamped or not, with knots of every multiplicity", "[elevation]") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937 random(seed);
    for (int p = 1; p <= 4; ++p) {
      for (const int highest : {1, p, p + 1}) {
        for (const bool clamped : {true, false}) {
          INFO("seed " << seed << ", p = " << p << ", multiplicity up to " << highest);
          check_elevation(random_curve(random, p, random_int(random, 1, 4), highest, clamped, seed % 2 == 0),
                          random_int(random, 1, 3));
        }
      }
    }
  }
}

TEST_CASE("a clamped curve stays clamped, and its knot vector is told in full", "[elevation]") {
  Curve<Exact> curve;
  curve.degree = 2;
  curve.knots = knots({"0", "0", "0", "1", "2", "2", "3", "3", "3", "4", "4", "4"});
  std::mt19937 random(1);
  for (int i = 0; i < 9; ++i) curve.points.push_back(random_point(random, false));
  curve.dimension = 3;
  check_elevation(curve, 1);
  NoRecorder<Exact> none;
  CHECK(degree_elevation(curve, 1, none).knots ==
        knots({"0", "0", "0", "0", "1", "1", "2", "2", "2", "3", "3", "3", "3", "4", "4", "4", "4"}));
}

TEST_CASE("coincident points and weights of zero go through elevation", "[elevation]") {
  std::mt19937 random(9);
  auto curve = random_curve(random, 2, 3, 1, true, true);
  curve.points[1] = HPoint<Exact>(0, 0, 0, 0);
  check_elevation(curve, 2);
  for (auto& P : curve.points) P = curve.points.back();
  check_elevation(curve, 2);
  NoRecorder<Exact> none;
  for (const auto& P : degree_elevation(curve, 2, none).points) CHECK(P == curve.points.back());
}

TEST_CASE("elevation beyond the highest degree is refused", "[elevation]") {
  const auto message = [](int times) {
    return to_string(
        inputs_of(*find_algorithm("degree_elevation"),
                  R"({"curve": {"degree": 2, "points": [[0,0],[1,1],[2,0]]}, "times": )" + std::to_string(times) + "}")
            .diagnostics);
  };
  CHECK(message(23).empty());
  CHECK(message(24).find("times: must be at most 23 here: the degree is 2 and may grow up to 25") != std::string::npos);
}
