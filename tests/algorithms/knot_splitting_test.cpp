// Knot splitting and unclamping: what changes, and what does not.

#include "kernel/knot_splitting.hpp"

#include "algorithms/pieces.hpp"
#include "kernel/derivatives.hpp"
#include "kernel/subdivision.hpp"
#include "kernel/unclamping.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

const std::string double_knot = R"({"curve": {"degree": 2, "knots": [0,0,0,1,1,3,3,3],
  "points": [[0,0],[2,4],[6,0],[8,4],[10,0]]}, "u": 1)";

}  // namespace

TEST_CASE("the copies are spread evenly around the knot, and the points stay", "[splitting]") {
  const auto run = run_of("knot_splitting", double_knot + R"(, "apart": "1/2"})");
  CHECK(number_of(run, "g") == 1);  // the nearer neighbour is 0, not 3
  CHECK(number_of(run, "h") == q("1/2"));
  CHECK(numbers_of(run, "V") == knots({"0", "0", "0", "1/2", "3/2", "3", "3", "3"}));
  const auto& made = std::get<Curve<Exact>>(run.outcome);
  CHECK(made.points == run.inputs.curve("curve").points);
  // Before, the curve passed through (6, 0); now it passes by it.
  CHECK(point_of(run, "C[0]") == std::vector<Exact>{6, 0});
  const auto there = point(made, 1);
  CHECK(point_of(run, "C[1]") == std::vector<Exact>{there->x, there->y});
}

TEST_CASE("three copies: the middle one stays", "[splitting]") {
  const auto run = run_of("knot_splitting", R"({"curve": {"degree": 3, "knots": [0,0,0,0,2,2,2,3,3,3,3],
    "points": [[0,0],[1,3],[2,0],[4,1],[5,5],[6,0],[7,1]]}, "u": 2, "apart": "1/5"})");
  CHECK(numbers_of(run, "V") == knots({"0", "0", "0", "0", "9/5", "2", "11/5", "3", "3", "3", "3"}));
}

TEST_CASE("a split knot makes the curve smoother: a corner becomes round", "[splitting]") {
  // The velocities on both sides of a knot: those of the parts that it cuts the curve into.
  const auto bend = [](const Curve<Exact>& curve, const Exact& u) {
    NoRecorder<Exact> none;
    const auto parts = subdivision(curve, u, none);
    std::vector<Point<Exact>> left(2), right(2);
    REQUIRE(derivatives(parts[0], u, 1, left));
    REQUIRE(derivatives(parts[1], u, 1, right));
    return right[1] - left[1];
  };
  const auto run = run_of("knot_splitting", double_knot + "}");
  const auto& made = std::get<Curve<Exact>>(run.outcome);
  CHECK(bend(run.inputs.curve("curve"), 1) != Point<Exact>(Exact(0)));
  CHECK(bend(made, made.knots[3]) == Point<Exact>(Exact(0)));
  CHECK(bend(made, made.knots[4]) == Point<Exact>(Exact(0)));
}

TEST_CASE("delta is the distance of the curves at the knot, and shrinks with the split", "[splitting]") {
  double before = 1e9;
  for (const char* apart : {"1/2", "1/4", "1/8", "1/1000"}) {
    const auto run = run_of("knot_splitting", double_knot + R"(, "apart": ")" + apart + "\"}");
    const auto a = point(run.inputs.curve("curve"), 1), b = point(std::get<Curve<Exact>>(run.outcome), 1);
    const double x = (a->x - b->x).to_double(), y = (a->y - b->y).to_double();
    const double delta = number_of(run, "delta").to_double();
    CHECK(delta == Approx(std::hypot(x, y)));
    CHECK(delta < before);
    before = delta;
  }
  CHECK(before < 0.01);
}

TEST_CASE("what cannot be split is said", "[splitting]") {
  const auto message = [](const std::string& rest) {
    const std::string curve =
        R"({"curve": {"degree": 2, "knots": [0,0,0,1,2,2,3,3,3], "points": [[0,0],[1,1],[2,0],[3,1],[4,0],[5,1]]}, )";
    return to_string(inputs_of(*find_algorithm("knot_splitting"), curve + rest + "}").diagnostics);
  };
  CHECK(message(R"("u": 2)").empty());
  CHECK(message(R"("u": 1)").find("is a simple knot: only a multiple knot can be split") != std::string::npos);
  CHECK(message(R"("u": 1.5)").find("is no knot: choose a multiple knot of the curve") != std::string::npos);
  CHECK(message(R"("u": 0)").find("is an end of the domain, which must stay") != std::string::npos);
  CHECK(message(R"("u": 2, "apart": 1)").find("apart: must lie between 0 and 1") != std::string::npos);
  CHECK(message(R"("u": 2, "apart": "1e-30")").find("apart: must be larger") != std::string::npos);
}

TEST_CASE("an unclamped curve is the same curve over single knots at both ends", "[unclamping]") {
  int made_some = 0;
  for_random_curves(80, [&](const Curve<Exact>& curve, std::mt19937&) {
    try {
      const auto made = both_ways<Exact>([&](auto& rec) { return unclamping(curve, rec); });
      ++made_some;
      const auto p = static_cast<std::size_t>(curve.degree);
      CHECK(made.domain_begin() == curve.domain_begin());
      CHECK(made.domain_end() == curve.domain_end());
      CHECK(made.knots.size() == made.points.size() + p + 1);
      CHECK(is_part(made, curve));
      const Exact front = made.knots[p + 1] - made.knots[p];
      const Exact back = made.domain_end() - made.knots[made.points.size() - 1];
      for (std::size_t i = 0; i < p; ++i) {
        CHECK(made.knots[i + 1] - made.knots[i] == front);
        CHECK(made.knots[made.knots.size() - 1 - i] - made.knots[made.knots.size() - 2 - i] == back);
      }
    } catch (const KernelError& error) {
      CHECK(curve.rational);
      CHECK(error.message.find("a weight that is not positive") != std::string::npos);
    }
  });
  CHECK(made_some > 40);
}

TEST_CASE("clamping undoes unclamping", "[unclamping]") {
  NoRecorder<Exact> none;
  for (int p = 1; p <= 5; ++p) {
    const auto curve = plain_spline(p, 3);
    CHECK(clamping(unclamping(curve, none), none) == curve);
  }
}

TEST_CASE("a parabola over the knots -2, -1, 0, 1, 2, 3", "[unclamping]") {
  // f(s, t) = b(s, t) of the polynomial: P[0] = f(-1, 0), P[1] = f(0, 1), P[2] = f(1, 2).
  const auto run = run_of("unclamping", R"({"curve": {"degree": 2, "points": [[0,0],[1,2],[2,0]]}})");
  CHECK(numbers_of(run, "V") == std::vector<Exact>{-2, -1, 0, 1, 2, 3});
  CHECK(point_of(run, "Q[0]") == std::vector<Exact>{-1, -2});
  CHECK(point_of(run, "Q[1]") == std::vector<Exact>{1, 2});
  CHECK(point_of(run, "Q[2]") == std::vector<Exact>{3, -2});
}
