// Worked examples from the literature. NB: Piegl & Tiller, The NURBS Book. Shene: C.-K. Shene's CS3621 notes.

#include "algorithms/curves.hpp"
#include "kernel/knot_insertion.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

// What every control point weighs in a value: run with one point at 1 and the others at 0.
std::vector<Exact> weights_of(const char* id, const std::string& degree_and_knots, int points, const std::string& rest,
                              const std::string& name) {
  std::vector<Exact> weights;
  for (int one = 0; one < points; ++one) {
    std::string P;
    for (int i = 0; i < points; ++i) P += (i > 0 ? ", [" : "[") + std::string(i == one ? "1" : "0") + ", 0]";
    weights.push_back(numbers_of(
        run_of(id, R"({"curve": {)" + degree_and_knots + R"(, "points": [)" + P + "]}, " + rest + "}"), name)[0]);
  }
  return weights;
}

}  // namespace

TEST_CASE("Shene, de Boor's algorithm: a cubic on [0, 1] at u = 0.4", "[published]") {
  const std::string curve = R"("degree": 3, "knots": [0,0,0,0,0.25,0.5,0.75,1,1,1,1])";
  const auto run = run_of(
      "de_boor", R"({"curve": {)" + curve + R"(, "points": [[0,0],[1,3],[2,1],[4,2],[5,0],[6,2],[7,7]]}, "u": "2/5"})");
  CHECK(number_of(run, "k") == 4);
  CHECK(number_of(run, "s") == 0);
  CHECK(number_of(run, "alpha[1][4]") == q("1/5"));
  CHECK(number_of(run, "alpha[1][3]") == q("8/15"));
  CHECK(number_of(run, "alpha[1][2]") == q("4/5"));
  CHECK(number_of(run, "alpha[2][4]") == q("3/10"));
  CHECK(number_of(run, "alpha[2][3]") == q("4/5"));
  CHECK(number_of(run, "alpha[3][4]") == q("3/5"));
  CHECK(weights_of("de_boor", curve, 7, R"("u": "2/5")", "C") ==
        knots({"0", "2/125", "307/750", "202/375", "9/250", "0", "0"}));
}

TEST_CASE("NB example 4.1: a point on a NURBS curve, at a knot", "[published]") {
  const auto run = run_of("de_boor", R"({"curve": {"degree": 2, "knots": [0,0,0,1,2,3,3,3],
    "points": [[0,0],[1,1],[3,2],[4,1],[5,-1]], "weights": [1,4,1,1,1]}, "u": 1})");
  CHECK(number_of(run, "s") == 1);
  const auto last = numbers_of(run, "P[1][2]");
  CHECK(last == std::vector<Exact>{q("7/2"), 3, 0, q("5/2")});
  CHECK(point_of(run, "C") == knots({"7/5", "6/5"}));
}

TEST_CASE("NB: the quarter circle with the weights 1, 1, 2", "[published]") {
  const std::string curve = R"({"degree": 2, "points": [[1,0],[1,1],[0,1]], "weights": [1,1,2]})";
  for (const char* id : {"de_casteljau", "de_boor"})
    CHECK(point_of(run_of(id, R"({"curve": )" + curve + R"(, "u": 0.5})"), "C") == knots({"3/5", "4/5"}));
}

TEST_CASE("the division by w: right and forgotten", "[published]") {
  const auto run = run_of(
      "de_casteljau", R"({"curve": {"degree": 2, "points": [[0,0],[0.5,1],[1,0]], "weights": [1,10,1]}, "u": 0.5})");
  CHECK(point_of(run, "C") == knots({"1/2", "10/11"}));
  const auto top = numbers_of(run, "P[2][0]");
  CHECK(top[0] == q("11/4"));
  CHECK(top[1] == 5);
}

TEST_CASE("NB: insertion of u = 5/2 into a cubic", "[published]") {
  const std::string curve = R"("degree": 3, "knots": [0,0,0,0,1,2,3,4,5,5,5,5])";
  const std::string rest = R"("u": 2.5)";
  CHECK(weights_of("knot_insertion", curve, 8, rest, "Q[3]") == knots({"0", "0", "1/6", "5/6", "0", "0", "0", "0"}));
  CHECK(weights_of("knot_insertion", curve, 8, rest, "Q[4]") == knots({"0", "0", "0", "1/2", "1/2", "0", "0", "0"}));
  CHECK(weights_of("knot_insertion", curve, 8, rest, "Q[5]") == knots({"0", "0", "0", "0", "5/6", "1/6", "0", "0"}));
  CHECK(weights_of("knot_insertion", curve, 8, rest, "Q[2]") == knots({"0", "0", "1", "0", "0", "0", "0", "0"}));
}

TEST_CASE("Shene, knot insertion: t = 0.5 once, twice, three times", "[published]") {
  const auto run = run_of("knot_insertion", R"({"curve": {"degree": 3, "knots": [0,0,0,0,0.2,0.4,0.6,0.8,1,1,1,1],
    "points": [[0,0],[1,1],[2,0],[3,1],[4,0],[5,1],[6,0],[7,1]]}, "u": 0.5, "times": 3})");
  CHECK(number_of(run, "alpha[1][5]") == q("1/6"));
  CHECK(number_of(run, "alpha[1][4]") == q("1/2"));
  CHECK(number_of(run, "alpha[1][3]") == q("5/6"));
  CHECK(number_of(run, "alpha[2][5]") == q("1/4"));
  CHECK(number_of(run, "alpha[2][4]") == q("3/4"));
  CHECK(number_of(run, "alpha[3][5]") == q("1/2"));
  CHECK(numbers_of(run, "Ubar") ==
        knots({"0", "0", "0", "0", "0.2", "0.4", "0.5", "0.5", "0.5", "0.6", "0.8", "1", "1", "1", "1"}));
}

TEST_CASE("degree elevation: a parabola as a cubic", "[published]") {
  const auto run = run_of("degree_elevation", R"({"curve": {"degree": 2, "points": [[-3,0],[0,3],[3,0]]}})");
  CHECK(point_of(run, "Q[0]") == knots({"-3", "0"}));
  CHECK(point_of(run, "Q[1]") == knots({"-1", "2"}));
  CHECK(point_of(run, "Q[2]") == knots({"1", "2"}));
  CHECK(point_of(run, "Q[3]") == knots({"3", "0"}));
}

TEST_CASE("an unclamped quadratic over uniform knots", "[published]") {
  const auto at = [](const char* u) {
    return point_of(
        run_of(
            "de_boor",
            R"({"curve": {"degree": 2, "knots": [0,1,2,3,4,5,6], "points": [[-1,0],[-0.5,0.5],[0.5,-0.5],[1,0]]}, "u": ")" +
                std::string(u) + "\"}"),
        "C");
  };
  CHECK(at("2") == knots({"-0.75", "0.25"}));    // t = 0
  CHECK(at("2.2") == knots({"-0.64", "0.32"}));  // t = 0.1
  CHECK(at("3") == knots({"0", "0"}));           // t = 0.5
}

namespace {

// Interpolation of points as skinning: each profile is the segment from a point D to D moved out of the plane, so every
// column has the same distances, those of the points.
Run<Exact> through(const std::vector<std::pair<int, int>>& D, int degree, const std::string& parametrization) {
  std::string profiles;
  for (const auto& [x, y] : D) {
    const std::string xy = std::to_string(x) + ", " + std::to_string(y);
    profiles +=
        (profiles.empty() ? "" : ", ") + std::string(R"({"degree": 1, "points": [[)") + xy + ", 0], [" + xy + ", 1]]}";
  }
  return run_of("skinning", R"({"profiles": [)" + profiles + R"(], "degree_v": )" + std::to_string(degree) +
                                R"(, "parametrization": ")" + parametrization + "\"}");
}

}  // namespace

TEST_CASE("Shene, parameter selection: chord lengths and centripetal", "[published]") {
  const std::vector<std::pair<int, int>> D{{0, 0}, {1, 2}, {3, 4}, {4, 0}};
  const auto chord = through(D, 3, "chord");
  CHECK(number_of(chord, "d[1][0]").to_double() == Approx(std::sqrt(5.0)));
  CHECK(number_of(chord, "d[2][0]").to_double() == Approx(std::sqrt(8.0)));
  CHECK(number_of(chord, "d[3][1]").to_double() == Approx(std::sqrt(17.0)));
  CHECK(number_of(chord, "v[0]") == 0);
  CHECK(number_of(chord, "v[1]").to_double() == Approx(0.243379).margin(1e-6));
  CHECK(number_of(chord, "v[2]").to_double() == Approx(0.551232).margin(1e-6));
  CHECK(number_of(chord, "v[3]") == 1);
  const auto centripetal = through(D, 3, "centripetal");
  CHECK(number_of(centripetal, "v[1]").to_double() == Approx(0.287143).margin(1e-6));
  CHECK(number_of(centripetal, "v[2]").to_double() == Approx(0.610087).margin(1e-6));
}

TEST_CASE("NB example 9.1: parameters and the averaged knot", "[published]") {
  const auto run = through({{0, 0}, {3, 4}, {-1, 4}, {-4, 0}, {-4, -3}}, 3, "chord");
  const char* v[] = {"0", "5/17", "9/17", "14/17", "1"};
  for (int l = 0; l < 5; ++l) CHECK(number_of(run, "v[" + std::to_string(l) + "]") == q(v[l]));
  CHECK(numbers_of(run, "V") == knots({"0", "0", "0", "0", "28/51", "1", "1", "1", "1"}));
  CHECK(number_of(run, "V[4]") == q("28/51"));
  CHECK(run.trace.approximate_values().empty());
}
