// Basis functions by the recurrence, against the published examples and the library's own evaluation.

#include "kernel/basis_functions.hpp"

#include "algorithms/pieces.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Run<Exact> basis_run(int degree, const std::string& knots, int points, const std::string& u) {
  std::string P;
  for (int i = 0; i < points; ++i) P += (i > 0 ? ", [" : "[") + std::to_string(i) + ", " + std::to_string(i * i) + "]";
  return run_of("basis_functions", R"({"curve": {"degree": )" + std::to_string(degree) + R"(, "knots": )" + knots +
                                       R"(, "points": [)" + P + R"(]}, "u": )" + u + "}");
}

std::vector<Exact> functions(const Run<Exact>& run, int first, int last, int degree) {
  std::vector<Exact> N;
  for (int i = first; i <= last; ++i)
    N.push_back(number_of(run, "N[" + std::to_string(i) + "][" + std::to_string(degree) + "]"));
  return N;
}

}  // namespace

TEST_CASE("NB examples 2.1 and 2.3: the basis functions at u = 5/2", "[basis][published]") {
  const auto run = basis_run(2, "[0,0,0,1,2,3,4,4,5,5,5]", 8, "2.5");
  CHECK(number_of(run, "k") == 4);
  CHECK(functions(run, 2, 4, 2) == knots({"1/8", "3/4", "1/8"}));
  CHECK(functions(run, 3, 4, 1) == knots({"1/2", "1/2"}));
  CHECK(number_of(run, "N[4][0]") == 1);
  CHECK(number_of(run, "sum") == 1);
}

TEST_CASE("NB example 2.3: the spans", "[basis][published]") {
  const std::string U = "[0,0,0,1,2,3,4,4,5,5,5]";
  const std::vector<std::pair<std::string, int>> spans{{"0", 2}, {"1", 3}, {"1.5", 3}, {"4.9", 7}, {"5", 7}};
  for (const auto& [u, k] : spans) CHECK(number_of(basis_run(2, U, 8, u), "k") == k);
}

TEST_CASE("Shene: quadratic basis functions over knots with a double one", "[basis][published]") {
  const std::string U = "[0,0,0,0.3,0.5,0.5,0.6,1,1,1]";
  CHECK(functions(basis_run(2, U, 7, "0.4"), 1, 3, 2) == knots({"1/10", "13/20", "1/4"}));
  CHECK(functions(basis_run(2, U, 7, "0.55"), 3, 5, 2) == knots({"1/4", "7/10", "1/20"}));
}

TEST_CASE("Shene: the hat function N[0][1] and the parabola N[0][2] over uniform knots", "[basis][published]") {
  // U = {0, 1/4, 1/2, 3/4, 1}; over an unclamped curve, shifted so that the span of interest is its domain.
  const auto at = [](const std::string& u) { return basis_run(2, "[-0.5,-0.25,0,0.25,0.5,0.75]", 3, u); };
  const auto run = at("0.1");
  const Exact u = q("1/10");
  CHECK(number_of(run, "N[2][1]") == Exact(4) * u);
  CHECK(number_of(run, "N[2][2]") == Exact(8) * u * u);
  // N_{0,2} on its second and third piece, met by the functions before: -1.5 + 12x - 16x^2, 4.5 - 12x + 8x^2.
  const Exact x = u + q("1/4"), y = u + q("1/2");
  CHECK(number_of(run, "N[1][2]") == q("-3/2") + Exact(12) * x - Exact(16) * x * x);
  CHECK(number_of(run, "N[0][2]") == q("9/2") - Exact(12) * y + Exact(8) * y * y);
}

TEST_CASE("NB example 4.1: the rational basis functions, and the point", "[basis][published]") {
  const auto run = run_of("basis_functions", R"({"curve": {"degree": 2, "knots": [0,0,0,1,2,3,3,3],
    "points": [[0,0],[1,1],[3,2],[4,1],[5,-1]], "weights": [1,4,1,1,1]}, "u": 1})");
  CHECK(number_of(run, "W") == q("5/2"));
  CHECK(number_of(run, "R[1]") == q("4/5"));
  CHECK(number_of(run, "R[2]") == q("1/5"));
  CHECK(number_of(run, "R[3]") == 0);
  CHECK(point_of(run, "C") == knots({"7/5", "6/5"}));
}

TEST_CASE("the combination of the control points is the point of the curve, and the functions sum to 1", "[basis]") {
  int seen = 0;
  for_random_curves(80, [&](const Curve<Exact>& curve, std::mt19937& random) {
    for (int draw = 0; draw < 4; ++draw) {
      const Exact u = any_parameter(random, curve);
      const auto right = point(curve, u);
      if (!right) continue;
      ++seen;
      INFO("u = " << u.to_string());
      const auto made = both_ways<Exact>([&](auto& rec) { return basis_combination(curve, u, rec); });
      CHECK(Point<Exact>(made.x, made.y, made.z) == *right);
      CHECK(made.w == 1);
      TraceRecorder<Exact> recorder;
      basis_combination(curve, u, recorder);
      CHECK(recorder.trace().numbers(*recorder.trace().find("sum"))[0] == 1);
    }
  });
  CHECK(seen > 200);
}
