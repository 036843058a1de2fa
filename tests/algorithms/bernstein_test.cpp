// Bernstein polynomials by their recurrence: against binom(n, i) (1-u)^(n-i) u^i, de Casteljau, and the basis
// functions.

#include "algorithms/curves.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

std::string on_degree(int n, const Exact& u) {
  std::string points;
  for (int i = 0; i <= n; ++i)
    points += (i > 0 ? ", [" : "[") + std::to_string(i) + ", " + std::to_string((7 * i * i) % 5) + "]";
  return R"({"curve": {"degree": )" + std::to_string(n) + R"(, "points": [)" + points + R"(]}, "u": ")" +
         u.to_string() + "\"}";
}

Exact power(const Exact& u, int exponent) {
  Exact made(1);
  for (int e = 0; e < exponent; ++e) made *= u;
  return made;
}

}  // namespace

TEST_CASE("the cubic Bernstein polynomials at 1/3 are 8/27, 12/27, 6/27 and 1/27", "[bernstein]") {
  const auto run = run_of("bernstein", on_degree(3, Exact::ratio(1, 3)));
  const auto B = knots({"8/27", "12/27", "6/27", "1/27"});
  for (int i = 0; i <= 3; ++i)
    CHECK(number_of(run, "B[" + std::to_string(i) + "][3]") == B[static_cast<std::size_t>(i)]);
}

TEST_CASE("the recurrence gives the binomial formula, and the curve de Casteljau's point", "[bernstein]") {
  for (int n = 1; n <= 6; ++n)
    for (int j = 0; j <= 7; ++j) {
      const Exact u = Exact::ratio(j, 7);
      const std::string inputs = on_degree(n, u);
      INFO(inputs);
      const auto run = run_of("bernstein", inputs);
      Exact binomial(1);
      for (int i = 0; i <= n; ++i) {
        CHECK(number_of(run, "B[" + std::to_string(i) + "][" + std::to_string(n) + "]") ==
              binomial * power(Exact(1) - u, n - i) * power(u, i));
        binomial *= Exact::ratio(n - i, i + 1);
      }
      CHECK(number_of(run, "sum") == Exact(1));
      CHECK(point_of(run, "C") == point_of(run_of("de_casteljau", inputs), "C"));
      CHECK(point_of(run, "C") == point_of(run_of("basis_functions", inputs), "C"));
    }
}

TEST_CASE("Bernstein polynomials are those of a polynomial Bezier curve", "[bernstein]") {
  const auto mistakes = [](const std::string& curve) {
    return to_string(inputs_of(*find_algorithm("bernstein"), R"({"curve": )" + curve + R"(, "u": 0})").diagnostics);
  };
  CHECK(mistakes(R"({"degree": 1, "points": [[0, 0], [1, 1]], "weights": [1, 2]})").find("must have no weights") !=
        std::string::npos);
  CHECK(mistakes(R"({"degree": 1, "knots": [0, 0, 1, 2, 2], "points": [[0, 0], [1, 1], [2, 0]]})")
            .find("must be a Bézier curve") != std::string::npos);
}
