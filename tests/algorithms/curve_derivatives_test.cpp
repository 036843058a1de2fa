// Derivatives step by step, against published ones and the library's own; the hodograph as a curve.

#include "kernel/curve_derivatives.hpp"

#include "algorithms/pieces.hpp"
#include "kernel/hodograph.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

std::vector<Exact> vector_of(const Run<Exact>& run, const std::string& name) {
  const auto numbers = numbers_of(run, name);
  return {numbers[0], numbers[1]};
}

std::string one_hot(int points, int one) {
  std::string P;
  for (int i = 0; i < points; ++i) P += (i > 0 ? ", [" : "[") + std::string(i == one ? "1" : "0") + ", 0]";
  return "[" + P + "]";
}

}  // namespace

TEST_CASE("NB: the quarter circle with the weights 1, 1, 2 and its derivatives at both ends", "[derivatives]") {
  const std::string curve = R"({"curve": {"degree": 2, "points": [[1,0],[1,1],[0,1]], "weights": [1,1,2]}, )";
  const auto begin = run_of("curve_derivatives", curve + R"("u": 0, "order": 3})");
  CHECK(point_of(begin, "D[0]") == std::vector<Exact>{1, 0});
  CHECK(vector_of(begin, "D[1]") == std::vector<Exact>{0, 2});
  CHECK(vector_of(begin, "D[2]") == std::vector<Exact>{-4, 0});
  CHECK(vector_of(begin, "D[3]") == std::vector<Exact>{0, -12});
  const auto end = run_of("curve_derivatives", curve + R"("u": 1})");
  CHECK(vector_of(end, "D[1]") == std::vector<Exact>{-1, 0});
  CHECK(vector_of(end, "D[2]") == std::vector<Exact>{1, -1});
  CHECK(point_of(run_of("curve_derivatives", curve + R"("u": 0.5})"), "D[0]") == knots({"3/5", "4/5"}));
}

TEST_CASE("NB example 2.4: derivatives of the quadratic basis functions at u = 5/2", "[derivatives]") {
  // What each control point weighs in the derivatives: the derivatives of its basis function.
  const std::vector<Exact> first = knots({"0", "0", "-1/2", "0", "1/2", "0", "0", "0"});
  const std::vector<Exact> second = knots({"0", "0", "1", "-2", "1", "0", "0", "0"});
  for (int one = 0; one < 8; ++one) {
    const auto run =
        run_of("curve_derivatives", R"({"curve": {"degree": 2, "knots": [0,0,0,1,2,3,4,4,5,5,5], "points": )" +
                                        one_hot(8, one) + R"(}, "u": 2.5})");
    INFO("point " << one);
    CHECK(vector_of(run, "D[1]")[0] == first[static_cast<std::size_t>(one)]);
    CHECK(vector_of(run, "D[2]")[0] == second[static_cast<std::size_t>(one)]);
  }
}

TEST_CASE("derivatives step by step are the derivatives, of every kind of curve, at knots and between",
          "[derivatives]") {
  int seen = 0;
  for_random_curves(80, [&](const Curve<Exact>& curve, std::mt19937& random) {
    for (int draw = 0; draw < 4; ++draw) {
      const Exact u = any_parameter(random, curve);
      const int order = random_int(random, 1, 3);
      std::vector<Point<Exact>> right(4);
      if (!derivatives(curve, u, order, right)) continue;
      ++seen;
      INFO("u = " << u.to_string() << ", order " << order);
      const auto C = both_ways<Exact>([&](auto& rec) { return curve_derivatives(curve, u, order, rec); });
      CHECK(Point<Exact>(C.x, C.y, C.z) == right[0]);
      TraceRecorder<Exact> recorder;
      curve_derivatives(curve, u, order, recorder);
      for (int d = 0; d <= order; ++d) {
        const auto D = recorder.trace().numbers(*recorder.trace().find("D[" + std::to_string(d) + "]"));
        CHECK(Point<Exact>(D[0], D[1], D[2]) == right[static_cast<std::size_t>(d)]);
        CHECK(D[3] == (d == 0 ? 1 : 0));  // a vector has no weight
      }
    }
  });
  CHECK(seen > 200);
}

TEST_CASE("Shene: the derivative of a cubic over knots with a double one", "[hodograph]") {
  const auto run = run_of("hodograph", R"({"curve": {"degree": 3, "knots": [0,0,0,0,0.4,0.6,0.6,1,1,1,1],
    "points": [[0,0],[1,2],[2,4],[4,4],[5,0],[7,1],[8,3]]}})");
  const auto factors = knots({"15/2", "5", "5", "5", "15/2", "15/2"});
  for (int i = 0; i < 6; ++i)
    CHECK(number_of(run, "c[" + std::to_string(i) + "]") == factors[static_cast<std::size_t>(i)]);
  CHECK(numbers_of(run, "V") == knots({"0", "0", "0", "0.4", "0.6", "0.6", "1", "1", "1"}));
  CHECK(point_of(run, "Q[0]") == knots({"15/2", "15"}));
  CHECK(std::get<Curve<Exact>>(run.outcome).degree == 2);
}

TEST_CASE("a point of the hodograph is the velocity of the curve", "[hodograph]") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 2, 5);
    const auto curve = random_curve(random, p, random_int(random, 1, 4), p, seed % 2 == 0, false);
    const auto made = both_ways<Exact>([&](auto& rec) { return hodograph(curve, rec); });
    CHECK(made.domain_begin() == curve.domain_begin());
    CHECK(made.domain_end() == curve.domain_end());
    for (int draw = 0; draw < 8; ++draw) {
      const Exact u = any_parameter(random, curve);
      std::vector<Point<Exact>> D(2);
      REQUIRE(derivatives(curve, u, 1, D));
      CHECK(point(made, u) == D[1]);
    }
  }
}

TEST_CASE("curves whose derivative is no such curve are refused with the reason", "[hodograph]") {
  const auto message = [](const std::string& curve) {
    return to_string(inputs_of(*find_algorithm("hodograph"), R"({"curve": )" + curve + "}").diagnostics);
  };
  CHECK(message(R"({"degree": 2, "points": [[0,0],[1,1],[2,0]]})").empty());
  CHECK(message(R"({"degree": 2, "points": [[0,0],[1,1],[2,0]], "weights": [1,2,1]})")
            .find("must be without weights: the derivative of a rational curve is of degree 4") != std::string::npos);
  CHECK(message(R"({"degree": 1, "points": [[0,0],[1,1]]})").find("must be of degree 2 or more") != std::string::npos);
  CHECK(message(R"({"degree": 2, "knots": [0,0,0,1,1,1,2,2,2], "points": [[0,0],[1,1],[2,0],[3,0],[4,1],[5,0]]})")
            .find("has the knot 1 of multiplicity 3 inside") != std::string::npos);
}
