// Reversal and clamping: the same points of the plane, in another order or over other knots.

#include "kernel/reversal.hpp"

#include "algorithms/pieces.hpp"
#include "kernel/clamping.hpp"

using namespace blossom;
using namespace blossom::test;

TEST_CASE("the reversed curve at u is the curve at a + b - u", "[reversal]") {
  for_random_curves(60, [](const Curve<Exact>& curve, std::mt19937&) {
    const auto made = both_ways<Exact>([&](auto& rec) { return reversal(curve, rec); });
    CHECK(made.bezier == curve.bezier);
    CHECK(made.domain_begin() == curve.domain_begin());
    CHECK(made.domain_end() == curve.domain_end());
    CHECK(std::ranges::is_sorted(made.knots));
    CHECK(is_part(made, curve, curve.domain_end(), curve.domain_begin()));
    NoRecorder<Exact> none;
    CHECK(reversal(made, none) == curve);
  });
}

TEST_CASE("a reversed point carries the blossom label of its mirrored knots", "[reversal]") {
  const auto run = run_of("reversal", R"({"curve": {"degree": 2, "knots": [0,0,0,1,4,4,4],
    "points": [[0,0],[1,2],[3,3],[5,0]]}})");
  CHECK(numbers_of(run, "V") == std::vector<Exact>{0, 0, 0, 3, 4, 4, 4});
  CHECK(point_of(run, "Q[0]") == std::vector<Exact>{5, 0});
  const auto labels = run.trace.polar_labels();
  CHECK(to_string(labels[*run.trace.find("Q[1]")]) == "b(0, 3)");
}

TEST_CASE("a clamped curve begins and ends in a control point and is the same curve", "[clamping]") {
  for_random_curves(80, [](const Curve<Exact>& curve, std::mt19937&) {
    const auto made = both_ways<Exact>([&](auto& rec) { return clamping(curve, rec); });
    CHECK(is_clamped(made));
    CHECK(made.knots.size() == made.points.size() + static_cast<std::size_t>(made.degree) + 1);
    CHECK(made.domain_begin() == curve.domain_begin());
    CHECK(made.domain_end() == curve.domain_end());
    CHECK(is_part(made, curve));
    CHECK(made.points.front() == homogeneous_point(curve, curve.domain_begin()));
    CHECK(made.points.back() == homogeneous_point(curve, curve.domain_end()));
    if (is_clamped(curve)) CHECK(made == curve);
  });
}

TEST_CASE("a closed curve with periodic knots becomes one whose ends coincide", "[clamping]") {
  auto curve = plane_curve(3, {}, {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}});
  for (int i = 0; i <= 10; ++i) curve.knots.push_back(i);
  const auto made = both_ways<Exact>([&](auto& rec) { return clamping(curve, rec); });
  CHECK(made.points.front() == made.points.back());
  CHECK(made.knots == std::vector<Exact>{3, 3, 3, 3, 4, 5, 6, 7, 7, 7, 7});
}

TEST_CASE("Shene: the unclamped quadratic on uniform knots begins at (-3/4, 1/4)", "[clamping]") {
  const auto run = run_of("clamping", R"({"curve": {"degree": 2, "knots": [0,1,2,3,4,5,6],
    "points": [[-1,0],["-1/2","1/2"],["1/2","-1/2"],[1,0]]}})");
  CHECK(point_of(run, "Q[0]") == knots({"-3/4", "1/4"}));
  CHECK(point_of(run, "Q[3]") == knots({"3/4", "-1/4"}));
  CHECK(numbers_of(run, "W") == std::vector<Exact>{2, 2, 2, 3, 4, 4, 4});
}
