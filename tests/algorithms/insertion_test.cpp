// Knot insertion: the same curve over one knot more, at every place and as often as there is room.

#include "algorithms/curves.hpp"
#include "kernel/knot_insertion.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

std::vector<Exact> with_knot(std::vector<Exact> U, const Exact& u, int times) {
  U.insert(std::upper_bound(U.begin(), U.end(), u), static_cast<std::size_t>(times), u);
  return U;
}

void check_insertion(const Curve<Exact>& curve, const Exact& u, int times) {
  INFO("u = " << u.to_string() << ", " << times << " times, into " << write_curve(curve));
  const auto made = both_ways<Exact>([&](auto& rec) { return knot_insertion(curve, u, times, rec); });
  CHECK(made.degree == curve.degree);
  CHECK(made.rational == curve.rational);
  CHECK(made.knots == with_knot(curve.knots, u, times));
  REQUIRE(made.points.size() == curve.points.size() + static_cast<std::size_t>(times));
  CHECK(same_curve(made, curve));

  const auto rounded =
      both_ways<double>([&](auto& rec) { return knot_insertion(convert<double>(curve), u.to_double(), times, rec); });
  CHECK(rounded.knots == convert<double>(made).knots);
  const double scale = largest_coordinate(curve);
  for (std::size_t i = 0; i < made.points.size(); ++i)
    for (int c = 0; c < 4; ++c) CHECK(near(rounded.points[i][c], made.points[i][c].to_double(), scale));
}

// As often as there is room, in one go and one after the other.
void check_up_to_full(const Curve<Exact>& curve, const Exact& u) {
  const int room = curve.degree - multiplicity<Exact>(curve.knots, u);
  Curve<Exact> step = curve;
  NoRecorder<Exact> none;
  for (int times = 1; times <= room; ++times) {
    check_insertion(curve, u, times);
    step = knot_insertion(step, u, 1, none);
    CHECK(knot_insertion(curve, u, times, none) == step);
  }
}

}  // namespace

TEST_CASE("insertion keeps the curve, between knots and at knots of every multiplicity", "[insertion]") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    std::mt19937 random(seed);
    INFO("seed " << seed);
    for (int p = 1; p <= 4; ++p) {
      const auto curve = random_curve(random, p, 3, p + (seed % 3 == 0 ? 1 : 0), seed % 2 == 0, seed % 4 < 2);
      check_up_to_full(curve, random_parameter(random, curve.knots, p));
      for (const Exact& u : curve.knots)
        if (!(u < curve.domain_begin()) && !(curve.domain_end() < u)) check_up_to_full(curve, u);
    }
  }
}

TEST_CASE("insertion at the domain's ends of an unclamped curve clamps it", "[insertion]") {
  for (int p = 1; p <= 6; ++p) {
    std::mt19937 random(static_cast<unsigned>(p));
    INFO("p = " << p);
    const auto curve = random_curve(random, p, 2, 1, false, p % 2 == 0);
    check_up_to_full(curve, curve.domain_begin());
    check_up_to_full(curve, curve.domain_end());
    NoRecorder<Exact> none;
    if (p < 2) continue;
    // Full multiplicity: a control point lies on the curve.
    const auto clamped = knot_insertion(curve, curve.domain_begin(), p - 1, none);
    CHECK(clamped.points[static_cast<std::size_t>(p)] != clamped.points[static_cast<std::size_t>(p) - 1]);
    CHECK(homogeneous_point(clamped, clamped.domain_begin()) == clamped.points[static_cast<std::size_t>(p) - 1]);
  }
}

TEST_CASE("insertion into a single segment, of every degree, and among coincident points", "[insertion]") {
  for (int p = 1; p <= max_degree; ++p) {
    std::mt19937 random(static_cast<unsigned>(p));
    auto curve = random_curve(random, p, 1, 1, true, p % 2 == 1);
    curve.knots = bezier_knots<Exact>(p);
    INFO("p = " << p);
    check_insertion(curve, Exact::ratio(2, 3), 1);
    check_insertion(curve, Exact::ratio(1, 2), p);
    for (auto& P : curve.points) P = curve.points.front();
    check_insertion(curve, Exact::ratio(1, 2), (p + 1) / 2);
  }
}

TEST_CASE("weights of zero go through insertion", "[insertion]") {
  std::mt19937 random(5);
  auto curve = random_curve(random, 3, 3, 1, true, true);
  curve.points[2] = HPoint<Exact>(0, 0, 0, 0);
  check_up_to_full(curve, random_parameter(random, curve.knots, 3));
}

TEST_CASE("more than full multiplicity is refused, and says how much is allowed", "[insertion]") {
  const auto message = [](const std::string& rest) {
    const std::string curve =
        R"({"curve": {"degree": 3, "knots": [0,0,0,0,1,2,2,3,3,3,3], "points": [[0,0],[1,1],[2,0],[3,1],[4,0],[5,1],[6,0]]}, )";
    return to_string(inputs_of(*find_algorithm("knot_insertion"), curve + rest + "}").diagnostics);
  };
  CHECK(message(R"("u": 1, "times": 2)").empty());
  CHECK(message(R"("u": 1, "times": 3)")
            .find("times: must be at most 2 here: u has multiplicity 1 and the degree is 3") != std::string::npos);
  CHECK(message(R"("u": 2, "times": 2)").find("must be at most 1 here") != std::string::npos);
  CHECK(message(R"("u": 3)").find("is a knot of multiplicity 4 already") != std::string::npos);
  CHECK(message(R"("u": -1)").find("must lie in the domain [0, 3], not at -1") != std::string::npos);
  CHECK(message(R"("u": 1, "times": 0)").find("times") != std::string::npos);
}
