// Horner's scheme on points: against the curve written out, its derivative, and the same curve in Bezier form.

#include "kernel/horner.hpp"

#include "algorithms/curves.hpp"
#include "kernel/evaluate.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

PointRow<Exact> any_coefficients(std::mt19937& random) {
  PointRow<Exact> row;
  row.dimension = random_int(random, 2, 3);
  for (int k = random_int(random, 2, 6); k > 0; --k) row.points.push_back(any_place(random, row.dimension));
  return row;
}

// The sum of a_k u^k, coordinate by coordinate, and of k a_k u^(k-1).
std::pair<Point<Exact>, Point<Exact>> written_out(const PointRow<Exact>& a, const Exact& u) {
  Point<Exact> C(Exact(0)), D(Exact(0));
  Exact power(1), before(0);
  for (std::size_t k = 0; k < a.points.size(); ++k) {
    for (int x = 0; x < 3; ++x) {
      C[x] += power * a.points[k][x];
      D[x] += Exact(static_cast<int>(k)) * before * a.points[k][x];
    }
    before = power;
    power *= u;
  }
  return {C, D};
}

}  // namespace

TEST_CASE("a thrown ball: its place and its velocity", "[horner]") {
  const auto run = run_of("horner", R"({"coefficients": [[0, 0], [4, 8], [0, -8]], "u": "1/4"})");
  CHECK(numbers_of(run, "b[1]") == std::vector<Exact>{4, 6, 0, 0});
  CHECK(point_of(run, "C") == knots({"1", "3/2"}));
  CHECK(numbers_of(run, "D") == std::vector<Exact>{4, 4, 0, 0});
}

TEST_CASE("Horner's scheme gives the polynomial and its derivative", "[horner]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const auto a = any_coefficients(random);
    const Exact u = random_ratio(random, -2, 2, 5);
    TraceRecorder<Exact> recorder;
    const auto C = horner(a, u, recorder);
    const auto& trace = recorder.trace();
    const auto D = trace.numbers(*trace.find("D"));
    const auto [point, tangent] = written_out(a, u);
    INFO("seed " << seed);
    for (int x = 0; x < 3; ++x) {
      CHECK(C[x] == point[x]);
      CHECK(D[static_cast<std::size_t>(x)] == tangent[x]);
    }
    CHECK(C.w == Exact(1));
    CHECK(D[3] == Exact(0));
  }
}

TEST_CASE("in Bezier form over any interval it is the same curve", "[horner]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const auto a = any_coefficients(random);
    const Exact begin = random_ratio(random, -2, 2, 3), end = begin + random_ratio(random, 0, 2, 3) + Exact(1);
    const auto curve = bezier_of_power(a, begin, end);
    INFO("seed " << seed);
    for (int j = 0; j <= curve.degree; ++j) {
      const Exact u = begin + (end - begin) * Exact::ratio(j, curve.degree);
      const auto at = point(curve, u);
      REQUIRE(at);
      const auto right = written_out(a, u).first;
      CHECK((at->x == right.x && at->y == right.y && at->z == right.z));
    }
  }
}

TEST_CASE("the parameter must lie in the interval, which must not be empty", "[horner]") {
  const auto mistake = [](const std::string& rest) {
    return to_string(
        inputs_of(*find_algorithm("horner"), R"({"coefficients": [[0, 0], [4, 8]], )" + rest + "}").diagnostics);
  };
  CHECK(mistake(R"("u": 2)").find("must lie in the interval [0, 1], not at 2") != std::string::npos);
  CHECK(mistake(R"("u": 1, "interval": [1, 1])").find("must begin before it ends") != std::string::npos);
}
