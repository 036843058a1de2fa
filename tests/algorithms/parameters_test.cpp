// Parameters and knots for points that a curve is to pass through.

#include "algorithms/curves.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Run<Exact> parameters_of(const std::string& points, int degree, const std::string& parametrization) {
  return run_of("parameters", R"({"points": )" + points + R"(, "degree": )" + std::to_string(degree) +
                                  R"(, "parametrization": ")" + parametrization + "\"}");
}

}  // namespace

TEST_CASE("NB example 9.1: chord length parameters and the knot that they give", "[parameters]") {
  const auto run = parameters_of("[[0, 0], [3, 4], [-1, 4], [-4, 0], [-4, -3]]", 3, "chord");
  CHECK(number_of(run, "t[1]") == q("5/17"));
  CHECK(number_of(run, "t[2]") == q("9/17"));
  CHECK(number_of(run, "t[3]") == q("14/17"));
  CHECK(number_of(run, "U[4]") == q("28/51"));
  CHECK(numbers_of(run, "U") == knots({"0", "0", "0", "0", "28/51", "1", "1", "1", "1"}));
}

TEST_CASE("Shene: chord length and centripetal parameters of four points", "[parameters]") {
  const std::string points = "[[0, 0], [1, 2], [3, 4], [4, 0]]";
  const auto chord = parameters_of(points, 3, "chord");
  CHECK(number_of(chord, "t[1]").to_double() == Approx(0.243379).epsilon(1e-5));
  CHECK(number_of(chord, "t[2]").to_double() == Approx(0.551232).epsilon(1e-5));
  const auto centripetal = parameters_of(points, 3, "centripetal");
  CHECK(number_of(centripetal, "t[1]").to_double() == Approx(0.287143).epsilon(1e-5));
  CHECK(number_of(centripetal, "t[2]").to_double() == Approx(0.610087).epsilon(1e-5));
}

TEST_CASE("the curve is the one that interpolation makes of the same parameters", "[parameters]") {
  const std::string points = "[[0, 0], [3, 4], [3, 5], [9, 13], [12, 9]]";
  for (const char* parametrization : {"uniform", "chord", "centripetal"})
    for (int degree = 1; degree <= 4; ++degree) {
      INFO(parametrization << ", degree " << degree);
      const auto run = parameters_of(points, degree, parametrization);
      const auto whole =
          run_of("interpolation", R"({"points": )" + points + R"(, "degree": )" + std::to_string(degree) +
                                      R"(, "parametrization": ")" + parametrization + "\"}");
      CHECK(run.outcome == whole.outcome);
      for (const char* name : {"t[0]", "t[1]", "t[2]", "t[3]", "t[4]", "U"})
        CHECK(numbers_of(run, name) == numbers_of(whole, name));
    }
}
