// Sign changes along a polygon that is cut down to the curve.

#include "algorithms/pieces.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

int changes(const Run<Exact>& run, int round) {
  return static_cast<int>(number_of(run, "V[" + std::to_string(round) + "]").to_double());
}

const char* const zigzag =
    R"("curve": {"degree": 3, "points": [[0, -1], [1, 3], [2, -3], [3, 1]]}, "line": [[0, 0], [1, 0]])";

}  // namespace

TEST_CASE("over the x-axis, a side is the height", "[variation]") {
  const auto run = run_of("variation_diminishing", std::string("{") + zigzag + "}");
  CHECK(number_of(run, "d[0][1]") == Exact(3));
  CHECK(number_of(run, "d[0][2]") == Exact(-3));
  CHECK(changes(run, 0) == 3);
  CHECK(changes(run, 1) == 3);
  CHECK(changes(run, 2) == 3);
}

TEST_CASE("a polygon may cross a line that the curve does not", "[variation]") {
  const auto run = run_of("variation_diminishing",
                          R"({"curve": {"degree": 2, "points": [[0, 2], [1, -1], [2, 2]]}, "line": [[0, 0], [1, 0]]})");
  CHECK(changes(run, 0) == 2);
  CHECK(changes(run, 1) == 0);
}

TEST_CASE("a point on the line is on no side", "[variation]") {
  const auto run = run_of("variation_diminishing",
                          R"({"curve": {"degree": 2, "points": [[0, 1], [1, 0], [2, 1]]}, "line": [[0, 0], [1, 0]]})");
  CHECK(changes(run, 0) == 0);
}

TEST_CASE("changes never become more, nor fewer by an odd number, and the pieces are the curve", "[variation]") {
  int seen = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const Algorithm& algorithm = *find_algorithm("variation_diminishing");
    const auto inputs = any_inputs(algorithm, seed);
    INFO("seed " << seed << "\n" << to_text(inputs));
    const auto run = record<Exact>(algorithm, inputs);
    REQUIRE(run);
    const auto& curve = inputs.curve("curve");
    const int rounds = inputs.integer("rounds");
    for (int r = 1; r <= rounds; ++r) {
      CHECK(changes(*run, r) <= changes(*run, r - 1));
      // The ends stay, so that both polygons begin on one side and end on one; unless an end lies on the line.
      const Exact first = number_of(*run, "d[0][0]"), last = number_of(*run, "d[0][" + std::to_string(curve.n()) + "]");
      if (first != Exact(0) && last != Exact(0)) CHECK((changes(*run, r - 1) - changes(*run, r)) % 2 == 0);
      seen += changes(*run, 0) > 0 ? 1 : 0;
    }
    const auto& pieces = std::get<std::vector<Curve<Exact>>>(run->outcome);
    REQUIRE(static_cast<int>(pieces.size()) == 1 << rounds);
    for (int j = 0; j < 1 << rounds; ++j)
      CHECK(is_part(pieces[static_cast<std::size_t>(j)], curve, Exact::ratio(j, 1 << rounds),
                    Exact::ratio(j + 1, 1 << rounds)));
  }
  CHECK(seen > 20);
}

TEST_CASE("what cannot be counted is refused", "[variation]") {
  const auto mistakes = [](const std::string& text) {
    return to_string(inputs_of(*find_algorithm("variation_diminishing"), text).diagnostics);
  };
  const std::string flat = R"({"curve": {"degree": 1, "points": [[0, 0], [2, 0]]}, "line": )";
  CHECK(mistakes(flat + "[[1, 0], [5, 0]]}").find("must not contain all control points") != std::string::npos);
  CHECK(mistakes(flat + "[[1, 1], [1, 1]]}").find("must be two different points") != std::string::npos);
  CHECK(
      mistakes(
          R"({"curve": {"degree": 2, "points": [[0, 0], [2, 2], [4, 0]], "weights": [1, 0, 1]}, "line": [[0, 1], [1, 1]]})")
          .find("must have positive weights") != std::string::npos);
}
