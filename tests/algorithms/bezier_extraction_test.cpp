// Bezier extraction: one Bezier curve for each span.

#include "kernel/bezier_extraction.hpp"
#include "algorithms/pieces.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

std::vector<Curve<Exact>> segments_of(const Curve<Exact>& curve) {
  return both_ways<Exact>([&](auto& rec) { return bezier_extraction(curve, rec); });
}

}  // namespace

TEST_CASE("each segment is the curve over its span, on [0, 1]", "[extraction]") {
  for_random_curves(80, [](const Curve<Exact>& curve, std::mt19937&) {
    const auto segments = segments_of(curve);
    std::size_t j = 0;
    for (std::size_t a = static_cast<std::size_t>(curve.degree); a < curve.points.size(); ++a) {
      if (curve.knots[a] == curve.knots[a + 1]) continue;
      REQUIRE(j < segments.size());
      const auto& segment = segments[j++];
      CHECK(segment.bezier);
      CHECK(segment.degree == curve.degree);
      CHECK(segment.rational == curve.rational);
      CHECK(segment.dimension == curve.dimension);
      CHECK(segment.knots == bezier_knots<Exact>(curve.degree));
      REQUIRE(segment.points.size() == static_cast<std::size_t>(curve.degree) + 1);
      CHECK(is_part(segment, curve, curve.knots[a], curve.knots[a + 1]));
    }
    CHECK(j == segments.size());
  });
}

TEST_CASE("a Bezier curve is its only segment", "[extraction]") {
  std::mt19937 random(7);
  auto curve = random_curve(random, 4, 1, 1, true, true);
  curve.knots = bezier_knots<Exact>(4);
  curve.bezier = true;
  CHECK(segments_of(curve) == std::vector<Curve<Exact>>{curve});
}

TEST_CASE("a uniform cubic has the Bezier points that everybody knows", "[extraction]") {
  // Of the span over P_0..P_3: (P0 + 4 P1 + P2)/6, (2 P1 + P2)/3, (P1 + 2 P2)/3, (P1 + 4 P2 + P3)/6 (Farin,
  // Curves and Surfaces for CAGD, 8.2; Boehm 1977).
  const auto run = run_of("bezier_extraction", R"({"curve": {"degree": 3, "knots": [0,1,2,3,4,5,6,7],
    "points": [[0,0],[6,12],[12,18],[24,6]]}})");
  CHECK(point_of(run, "B[0][0]") == std::vector<Exact>{6, 11});
  CHECK(point_of(run, "B[0][1]") == std::vector<Exact>{8, 14});
  CHECK(point_of(run, "B[0][2]") == std::vector<Exact>{10, 16});
  CHECK(point_of(run, "B[0][3]") == std::vector<Exact>{13, 15});
}
