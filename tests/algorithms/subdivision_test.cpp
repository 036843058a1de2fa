// Subdivision: two curves that are the given one, left and right of u.

#include "kernel/subdivision.hpp"
#include "algorithms/pieces.hpp"
#include "kernel/de_casteljau.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

std::vector<Curve<Exact>> cut(const Curve<Exact>& curve, const Exact& u) {
  return both_ways<Exact>([&](auto& rec) { return subdivision(curve, u, rec); });
}

}  // namespace

TEST_CASE("both parts are clamped, keep their interval and are the curve there", "[subdivision]") {
  for_random_curves(60, [](const Curve<Exact>& curve, std::mt19937& random) {
    for (int draw = 0; draw < 6; ++draw) {
      const Exact u = any_parameter(random, curve);
      if (u == curve.domain_begin() || u == curve.domain_end()) continue;
      INFO("u = " << u.to_string());
      const auto parts = cut(curve, u);
      REQUIRE(parts.size() == 2);
      for (const auto& part : parts) {
        CHECK(part.degree == curve.degree);
        CHECK(part.dimension == curve.dimension);
        CHECK(part.rational == curve.rational);
        CHECK(part.knots.size() == part.points.size() + static_cast<std::size_t>(part.degree) + 1);
        CHECK(is_clamped(part));
        CHECK(is_part(part, curve));
      }
      CHECK(parts[0].domain_begin() == curve.domain_begin());
      CHECK(parts[0].domain_end() == u);
      CHECK(parts[1].domain_begin() == u);
      CHECK(parts[1].domain_end() == curve.domain_end());
      // They meet, except where the curve itself has a gap.
      if (multiplicity<Exact>(curve.knots, u) <= curve.degree) CHECK(parts[0].points.back() == parts[1].points.front());
    }
  });
}

TEST_CASE("of a Bezier curve the parts are the edges of de Casteljau's triangle", "[subdivision]") {
  for (int p = 1; p <= 8; ++p) {
    std::mt19937 random(static_cast<unsigned>(p));
    INFO("p = " << p);
    auto curve = random_curve(random, p, 1, 1, true, p % 2 == 0);
    curve.knots = bezier_knots<Exact>(p);
    const Exact u = Exact::ratio(2, 7);
    TraceRecorder<Exact> recorder;
    de_casteljau(curve, u, recorder);
    const auto& triangle = recorder.trace();
    const auto parts = cut(curve, u);
    for (int r = 0; r <= p; ++r) {
      const auto left = *triangle.find("P[" + std::to_string(r) + "][0]");
      const auto right = *triangle.find("P[" + std::to_string(r) + "][" + std::to_string(p - r) + "]");
      const auto is = [&](const HPoint<Exact>& P, ValueId v) {
        const auto numbers = triangle.numbers(v);
        return P == HPoint<Exact>(numbers[0], numbers[1], numbers[2], numbers[3]);
      };
      CHECK(is(parts[0].points[static_cast<std::size_t>(r)], left));
      CHECK(is(parts[1].points[static_cast<std::size_t>(p - r)], right));
    }
  }
}

TEST_CASE("Shene: t = 0.5 inserted three times cuts a cubic at the tip of the triangle", "[subdivision]") {
  const auto run = run_of("subdivision", R"({"curve": {"degree": 3, "knots": [0,0,0,0,0.2,0.4,0.6,0.8,1,1,1,1],
    "points": [[10,10],[4,0],[-4,0],[2,24],[32,24],[38,0],[30,0],[24,10]]}, "u": 0.5})");
  CHECK(number_of(run, "k") == 5);
  CHECK(number_of(run, "alpha[1][5]") == q("1/6"));
  CHECK(number_of(run, "alpha[1][4]") == q("1/2"));
  CHECK(number_of(run, "alpha[1][3]") == q("5/6"));
  CHECK(number_of(run, "alpha[2][4]") == q("3/4"));
  CHECK(number_of(run, "alpha[2][5]") == q("1/4"));
  CHECK(number_of(run, "alpha[3][5]") == q("1/2"));
  CHECK(numbers_of(run, "UL") == knots({"0", "0", "0", "0", "0.2", "0.4", "0.5", "0.5", "0.5", "0.5"}));
  CHECK(numbers_of(run, "UR") == knots({"0.5", "0.5", "0.5", "0.5", "0.6", "0.8", "1", "1", "1", "1"}));
  CHECK(point_of(run, "L[5]") == point_of(run, "Q[3][5]"));
  CHECK(point_of(run, "R[0]") == point_of(run, "Q[3][5]"));
}

TEST_CASE("the ends of the domain cut nothing off, and that is said", "[subdivision]") {
  const auto message = [](const std::string& u) {
    return to_string(inputs_of(*find_algorithm("subdivision"),
                               R"({"curve": {"degree": 2, "points": [[0,0],[1,1],[2,0]]}, "u": )" + u + "}")
                         .diagnostics);
  };
  CHECK(message("0.5").empty());
  CHECK(message("0").find("is an end of the domain: to cut the curve in two, choose u between 0 and 1") !=
        std::string::npos);
  CHECK(message("1").find("is an end of the domain") != std::string::npos);
  CHECK(message("2").find("must lie in the domain [0, 1], not at 2") != std::string::npos);
}
