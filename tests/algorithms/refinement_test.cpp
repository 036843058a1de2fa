// Refinement: the same curve over more knots, whatever their order.

#include "kernel/refinement.hpp"
#include "algorithms/pieces.hpp"
#include "kernel/blossom.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Curve<Exact> refined(const Curve<Exact>& curve, const std::vector<Exact>& added) {
  return both_ways<Exact>([&](auto& rec) { return refinement(curve, added, rec); });
}

// New knots that there is room for.
std::vector<Exact> any_knots(std::mt19937& random, const Curve<Exact>& curve, int count) {
  std::vector<Exact> all = curve.knots, added;
  for (int i = 0; i < count; ++i) {
    const Exact u = any_parameter(random, curve);
    if (std::ranges::count(all, u) >= curve.degree) continue;
    all.push_back(u);
    added.push_back(u);
  }
  return added;
}

}  // namespace

TEST_CASE("refinement keeps the curve, and its knots are the old and the new ones in order", "[refinement]") {
  for_random_curves(40, [](const Curve<Exact>& curve, std::mt19937& random) {
    const auto added = any_knots(random, curve, 6);
    const auto made = refined(curve, added);
    auto all = curve.knots;
    all.insert(all.end(), added.begin(), added.end());
    std::ranges::sort(all);
    CHECK(made.knots == all);
    REQUIRE(made.points.size() == curve.points.size() + added.size());
    CHECK(is_part(made, curve));
  });
}

TEST_CASE("the order of the new knots does not matter", "[refinement]") {
  for_random_curves(20, [](const Curve<Exact>& curve, std::mt19937& random) {
    auto added = any_knots(random, curve, 5);
    const auto made = refined(curve, added);
    std::ranges::shuffle(added, random);
    CHECK(refined(curve, added) == made);
  });
}

// Oslo and A5.4 say the same by another route: each new point is a value of the old curve's blossom (Ramshaw 1987).
TEST_CASE("a refined point is the blossom of the old curve at the new knots", "[refinement]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const auto curve = random_curve(random, 3, 4, 1, seed % 2 == 0, seed % 3 == 0);
    const auto made = refined(curve, any_knots(random, curve, 6));
    for (std::size_t i = 0; i < made.points.size(); ++i) {
      // A span of the old curve among the knots the point depends on.
      for (int k = curve.degree; k <= curve.n(); ++k) {
        const auto &a = curve.knots[static_cast<std::size_t>(k)], &b = curve.knots[static_cast<std::size_t>(k) + 1];
        if (!(a < b) || a < made.knots[i] || made.knots[i + 4] < b) continue;
        const auto arguments = std::span<const Exact>(made.knots).subspan(i + 1, 3);
        CHECK(blossom::blossom(curve, k, arguments) == made.points[i]);
      }
    }
  }
}

TEST_CASE("each span halved: the polygon of a quadratic with uniform knots is cut at 1/4 and 3/4", "[refinement]") {
  // Chaikin 1974, Riesenfeld 1975: corner cutting is the refinement of the uniform quadratic B-spline.
  const auto run = run_of("refinement", R"({"curve": {"degree": 2, "knots": [0,1,2,3,4,5,6],
    "points": [[0,0],[4,8],[12,4],[16,0]]}, "new_knots": [2.5, 3.5]})");
  const auto& made = std::get<Curve<Exact>>(run.outcome);
  // Between the new knots each old leg is divided at 1/4 and 3/4.
  CHECK(point_of(run, "Q[2]") == std::vector<Exact>{6, 7});
  CHECK(point_of(run, "Q[3]") == std::vector<Exact>{10, 5});
  CHECK(made.points.size() == 6);
}

TEST_CASE("what cannot be inserted is said for each knot", "[refinement]") {
  const auto message = [](const std::string& added) {
    const std::string curve =
        R"({"curve": {"degree": 2, "knots": [0,0,0,1,2,2,3,3,3], "points": [[0,0],[1,1],[2,0],[3,1],[4,0],[5,1]]}, )";
    return to_string(inputs_of(*find_algorithm("refinement"), curve + R"("new_knots": )" + added + "}").diagnostics);
  };
  CHECK(message("[1, 0.5, 0.5]").empty());
  CHECK(message("[5, -1]").find("new_knots[0]: must lie in the domain [0, 3], not at 5") != std::string::npos);
  CHECK(message("[5, -1]").find("new_knots[1]: must lie in the domain [0, 3], not at -1") != std::string::npos);
  CHECK(message("[1, 0.5, 1]")
            .find("has 1 2 times, but it can be inserted at most 1 time: its multiplicity is 1 and the degree is 2") !=
        std::string::npos);
  CHECK(message("[2]").find("has 2 1 time, but it can be inserted at most 0 times") != std::string::npos);
  CHECK(message("[0.5, 0.5000000000000000000001]").find("less than a double can tell") != std::string::npos);
  CHECK(message("[]").find("new_knots") != std::string::npos);
}
