// What an algorithm says of a step: the names are those of the curve in hand, and the line is the one that runs.

#include "algorithms/curves.hpp"
#include "algorithms/narrate.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

ValueId value_of(const Run<Exact>& run, const std::string& name) {
  const auto v = run.trace.find(name);
  INFO(name);
  REQUIRE(v);
  return *v;
}

std::string formula_of(const Run<Exact>& run, const std::string& name) {
  return Narrator<Exact>(run).formula(value_of(run, name));
}

int line_of(const Run<Exact>& run, const std::string& name) {
  return Narrator<Exact>(run).line(run.trace.value(value_of(run, name)).step);
}

std::string text_of(const Run<Exact>& run, const std::string& name) {
  return Narrator<Exact>(run).text(run.trace.value(value_of(run, name)).step);
}

}  // namespace

TEST_CASE("the second end of a clamped curve has the knots and points that the first one left", "[wording]") {
  const auto run = run_of("clamping", R"({"curve": {"degree": 2, "knots": [0,1,2,3,4,5,6],
    "points": [[-1,0],["-1/2","1/2"],["1/2","-1/2"],[1,0]]}})");
  CHECK(formula_of(run, "end[0].alpha[1][1]") == "(u - u_1) / (u_3 - u_1)");
  CHECK(formula_of(run, "end[1].alpha[1][4]") == "(u - u_4) / (u_6 - u_4)");
  CHECK(formula_of(run, "end[1].Q[1][4]") == "(1 - alpha[1][4]) P[3] + alpha[1][4] P[4]");
  CHECK(!run.trace.find("end[0].P[0]"));  // the given curve has its names
}

TEST_CASE("each new knot of several has the knots and points that the one before left", "[wording]") {
  const auto run = run_of("refinement", R"({"curve": {"degree": 2, "points": [[0,0],[2,4],[4,0]]},
    "new_knots": ["1/4", "1/2", "3/4"]})");
  CHECK(formula_of(run, "knot[2].alpha[1][4]") == "(u - u_4) / (u_6 - u_4)");
  // What has been worked on since is no longer the curve's.
  const std::uint32_t last = run.trace.step_count() - 1;
  CHECK(!run.trace.alive(value_of(run, "knot[1].P[1]"), last));
  CHECK(run.trace.alive(value_of(run, "P[0]"), last));
}

TEST_CASE("unclamping shows the lines of the end that it is at", "[wording]") {
  const auto run = run_of("unclamping", R"({"curve": {"degree": 2, "points": [[0,0],[1,2],[2,0]]}})");
  CHECK(line_of(run, "h[0]") == 2);
  CHECK(line_of(run, "V[1]") == 3);
  CHECK(line_of(run, "side[0].beta[1][0]") == 5);
  CHECK(line_of(run, "side[0].Q[1][0]") == 6);
  CHECK(line_of(run, "h[1]") == 7);
  CHECK(line_of(run, "V[4]") == 8);
  CHECK(line_of(run, "side[1].beta[1][2]") == 10);
  CHECK(line_of(run, "side[1].Q[1][2]") == 11);
}

TEST_CASE("a row of a surface is evaluated at v, a column at u", "[wording]") {
  const auto run = run_of(
      "surface_evaluation",
      R"({"surface": {"degree": [1, 1], "points": [[[0,0,0],[0,4,0]],[[4,0,0],[4,4,8]]]}, "u": "1/4", "v": "1/2"})");
  CHECK(formula_of(run, "row[1].alpha[1][1]").starts_with("(v - "));
  CHECK(formula_of(run, "across.alpha[1][1]") == "(u - u_1) / (u_2 - u_1)");
  CHECK(text_of(run, "row[1].k").starts_with("1/2 belongs to the span from 0 to 1"));
}

TEST_CASE("rules of one name are one rule: each has its own formula", "[wording]") {
  const auto splitting = run_of("knot_splitting", R"({"curve": {"degree": 2, "knots": [0,0,0,1,1,3,3,3],
    "points": [[0,0],[2,4],[6,0],[8,4],[10,0]]}, "u": 1})");
  CHECK(formula_of(splitting, "h") == "apart · g");
  const auto bernstein = run_of("bernstein", R"({"curve": {"degree": 1, "points": [[0,0],[4,4]]}, "u": "1/4"})");
  CHECK(formula_of(bernstein, "B[1][1]") == "u B[0][0]");
}

TEST_CASE("whether a knot can go is a matter of the bound and the tolerance", "[wording]") {
  const auto run = run_of("knot_removal", R"({"curve": {"degree": 1, "knots": [0,0,1,2,2],
    "points": [[0,0],[1,1],[2,2]]}, "u": 1})");
  CHECK(formula_of(run, "removal[1].ok") == "1 if b <= tol, else 0");
  CHECK(number_of(run, "removal[1].ok") == 1);
}

TEST_CASE("a sum on its way to a rational point is not divided by the weights so far", "[wording]") {
  const auto run = run_of("sweep", R"({"profile": {"degree": 1, "points": [[0,0],[1,0]], "weights": [2, 1]},
    "trajectory": {"degree": 2, "points": [[0,0],[2,2],[4,0]]}, "sections": 3})");
  CHECK(text_of(run, "section[1].C[0]").ends_with("(0, 0, 0, 1/4)."));
}
