// Circular arcs: all points at the radius from the centre, from the start to the end.

#include "kernel/circular_arc.hpp"
#include "algorithms/pieces.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Curve<Exact> arc(const Exact& x, const Exact& y, const Exact& r, const Exact& start, const Exact& end) {
  const PointRow<Exact> centre{{HPoint<Exact>(x, y, 0, 1)}, 2};
  return both_ways<Exact>([&](auto& rec) { return circular_arc(centre, r, start, end, rec); });
}

bool close(const Exact& a, double b) { return std::abs(a.to_double() - b) < 1e-12 * (1 + std::abs(b)); }

constexpr double radian = 3.14159265358979323846 / 180;

}  // namespace

TEST_CASE("every point of the arc is at the radius from the centre, and its ends are at the angles", "[circular_arc]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const Exact x = random_ratio(random, -4, 4, 2), y = random_ratio(random, -4, 4, 2);
    const Exact r = random_ratio(random, 0, 4, 3) + Exact::ratio(1, 3);
    const Exact start = random_int(random, -360, 360);
    const Exact sweep = random_int(random, 1, 360);
    INFO("seed " << seed << ", from " << start.to_string() << " by " << sweep.to_string());
    const auto curve = arc(x, y, r, start, start + sweep);
    const int pieces = (static_cast<int>(sweep.to_double()) + 89) / 90;
    CHECK(curve.points.size() == static_cast<std::size_t>(2 * pieces + 1));
    CHECK(curve.knots.size() == curve.points.size() + 3);
    for (int i = 0; i <= 12; ++i) {
      const auto P = *point(curve, Exact::ratio(i, 12));
      CHECK(close((P.x - x) * (P.x - x) + (P.y - y) * (P.y - y), (r * r).to_double()));
    }
    for (const auto& [u, angle] : {std::pair<int, Exact>(0, start), {1, start + sweep}}) {
      const auto P = *point(curve, Exact(u));
      CHECK(close(P.x, (x + r * Exact::approximate(std::cos(angle.to_double() * radian))).to_double()));
      CHECK(close(P.y, (y + r * Exact::approximate(std::sin(angle.to_double() * radian))).to_double()));
    }
    // The middle of a piece is at the middle of its angle, by symmetry.
    const auto M = *point(curve, Exact::ratio(1, 2 * pieces));
    const double middle = (start.to_double() + sweep.to_double() / (2 * pieces)) * radian;
    CHECK(close(M.x, x.to_double() + r.to_double() * std::cos(middle)));
    CHECK(close(M.y, y.to_double() + r.to_double() * std::sin(middle)));
  }
}

TEST_CASE("a corner lies on the tangents at both ends of its piece", "[circular_arc]") {
  const auto curve = arc(1, -2, 3, 20, 250);
  for (std::size_t j = 1; j < curve.points.size(); j += 2) {
    const auto place = [&](std::size_t i) {
      const auto& P = curve.points[i];
      return Point<Exact>(P.x / P.w, P.y / P.w, 0);
    };
    const Point<Exact> centre(1, -2, 0);
    for (const std::size_t end : {j - 1, j + 1}) {
      const auto leg = place(j) - place(end), spoke = place(end) - centre;
      CHECK(close(leg.x * spoke.x + leg.y * spoke.y, 0));
    }
  }
}

TEST_CASE("the weight of a corner is the cosine of half its piece; ends at quarter turns are exact", "[circular_arc]") {
  CHECK(close(arc(0, 0, 1, 0, 90).points[1].w, std::sqrt(2) / 2));
  CHECK(close(arc(0, 0, 1, 0, 120).points[1].w, std::sqrt(3) / 2));
  const auto circle = arc(0, 0, 1, 0, 360);
  CHECK(circle.knots == std::vector<Exact>{0, 0, 0, Exact::ratio(1, 4), Exact::ratio(1, 4), Exact::ratio(1, 2),
                                           Exact::ratio(1, 2), Exact::ratio(3, 4), Exact::ratio(3, 4), 1, 1, 1});
  CHECK(circle.points.front() == HPoint<Exact>(1, 0, 0, 1));
  CHECK(circle.points[2] == HPoint<Exact>(0, 1, 0, 1));
  CHECK(circle.points[4] == HPoint<Exact>(-1, 0, 0, 1));
  CHECK(circle.points[6] == HPoint<Exact>(0, -1, 0, 1));
  CHECK(circle.points.back() == circle.points.front());
}

TEST_CASE("arcs that are none are refused, with all that is wrong", "[circular_arc]") {
  const auto document =
      JsonDocument::parse("inputs", R"({"radius": 0, "start": 10, "end": 371, "center": [[0, 0, 1]]})");
  REQUIRE(document);
  Diagnostics found;
  CHECK(!read_inputs(*find_algorithm("circular_arc"), Cursor(*document, found)));
  const std::string text = to_string(found);
  CHECK(text.find("must be above 0, not 0") != std::string::npos);
  CHECK(text.find("at most 360 degrees further, not 371") != std::string::npos);
  CHECK(text.find("must be a point of the plane") != std::string::npos);
}
