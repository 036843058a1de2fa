// Least-squares approximation: no other control points come closer, and what can be met exactly is met.

#include "kernel/approximation.hpp"
#include "algorithms/curves.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

PointRow<Exact> random_row(std::mt19937& random, int count, int dimension) {
  PointRow<Exact> row{{}, dimension};
  while (static_cast<int>(row.points.size()) < count) {
    const auto P = any_place(random, dimension);
    if (row.points.empty() || row.points.back() != P) row.points.push_back(P);
  }
  return row;
}

Curve<Exact> approximated(const PointRow<Exact>& points, int degree, int count, const Exact& tolerance,
                          Parametrization way) {
  return both_ways<Exact>(
      [&](auto& recorder) { return approximation(points, degree, count, tolerance, way, recorder); });
}

double error_of(const Curve<Exact>& curve, const PointRow<Exact>& points) {  // with uniform parameters
  double error = 0;
  const int m = static_cast<int>(points.points.size()) - 1;
  for (int k = 0; k <= m; ++k) {
    const auto C = point(curve, Exact::ratio(k, m)).value();
    Exact square(0);
    for (int c = 0; c < 3; ++c) square += (C[c] - points.points[k][c]) * (C[c] - points.points[k][c]);
    error = std::max(error, std::sqrt(square.to_double()));
  }
  return error;
}

std::string mistake(const std::string& inputs) {
  const Algorithm& algorithm = *find_algorithm("approximation");
  const auto read = inputs_of(algorithm, inputs);
  return to_string(read ? record<Exact>(algorithm, *read).diagnostics : read.diagnostics);
}

}  // namespace

TEST_CASE("the sum of the squared distances is least: its gradient vanishes", "[approximation]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 random(seed);
    const auto points = random_row(random, random_int(random, 4, 14), random_int(random, 2, 3));
    const int m = static_cast<int>(points.points.size()) - 1;
    const int p = random_int(random, 1, 3);
    const int n = random_int(random, p, m);
    INFO("seed " << seed << ", p = " << p << ", n = " << n << ", m = " << m);
    const auto curve = approximated(points, p, n + 1, Exact(0), Parametrization::uniform);
    REQUIRE(curve.points.size() == static_cast<std::size_t>(n) + 1);
    CHECK(curve.dimension == points.dimension);
    CHECK(curve.points.front() == points.points.front());
    CHECK(curve.points.back() == points.points.back());
    for (int i = 1; i < n; ++i) {
      HPoint<Exact> gradient(0, 0, 0, 0);
      for (int k = 1; k < m; ++k) {
        const Exact t = Exact::ratio(k, m);
        gradient += (points.points[k] - homogeneous_point(curve, t)) *
                    basis_function<Exact>(std::span<const Exact>(curve.knots), p, i, t);
      }
      CHECK(gradient == HPoint<Exact>(0, 0, 0, 0));
    }
    if (n == m) CHECK(error_of(curve, points) == 0);  // as many control points as points: interpolation
  }
}

TEST_CASE("points of a spline over the same knots give that spline back", "[approximation]") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 2, 4), n = p + random_int(random, 1, 4), m = n + random_int(random, 2, 6);
    auto spline = approximated(random_row(random, m + 1, 3), p, n + 1, Exact(0), Parametrization::uniform);
    for (auto& P : spline.points) P = any_place(random, 3);
    PointRow<Exact> samples{{}, 3};
    for (int k = 0; k <= m; ++k) samples.points.push_back(homogeneous_point(spline, Exact::ratio(k, m)));
    CHECK(approximated(samples, p, n + 1, Exact(0), Parametrization::uniform) == spline);
  }
}

TEST_CASE("as few control points as keep the tolerance", "[approximation]") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const auto points = random_row(random, random_int(random, 5, 12), 2);
    const int p = random_int(random, 1, 3);
    for (const char* tolerance : {"0", "1/2", "2", "20"}) {
      INFO("degree " << p << ", tolerance " << tolerance);
      const auto curve = approximated(points, p, 0, q(tolerance), Parametrization::uniform);
      CHECK(error_of(curve, points) <= q(tolerance).to_double() + 1e-8);
      for (int count = p + 1; count < static_cast<int>(curve.points.size()); ++count)
        CHECK(error_of(approximated(points, p, count, Exact(0), Parametrization::uniform), points) >
              q(tolerance).to_double());
    }
  }
}

TEST_CASE("The NURBS Book, equations 9.68 and 9.69: each span holds a parameter", "[approximation]") {
  // m = 9, n = 5, p = 3: d = 10/3; j = 1: i = 3, alpha = 1/3: (2/3) 2/9 + (1/3) 3/9 = 7/27; j = 2: i = 6, alpha = 2/3.
  const auto run = run_of("approximation", R"({"points": [[0,0],[1,2],[2,3],[3,3],[4,2],[5,2],[6,3],[7,5],[8,5],[9,4]],
                                               "count": 6, "parametrization": "uniform"})");
  CHECK(numbers_of(run, "U") == knots({"0", "0", "0", "0", "7/27", "17/27", "1", "1", "1", "1"}));
  CHECK(number_of(run, "alpha[1]") == q("1/3"));
  CHECK(number_of(run, "alpha[2]") == q("2/3"));
}

TEST_CASE("a parabola through three points, by hand", "[approximation]") {
  // One inner control point P over t = 1/4, 1/2, 3/4 with N = 3/8, 1/2, 3/8: M = 17/32; the heights 0, 1, 0 give
  // R = 1/2, so P has height 16/17. The largest error is at 1/2: 1 - 8/17 = 9/17.
  const auto run = run_of("approximation", R"({"points": [[0,0],[1,0],[2,1],[3,0],[4,0]], "degree": 2, "count": 3,
                                               "parametrization": "uniform"})");
  CHECK(number_of(run, "M[1][1]") == q("17/32"));
  CHECK(point_of(run, "P[1]") == std::vector<Exact>{2, q("16/17")});
  CHECK(number_of(run, "E") == q("9/17"));
}

TEST_CASE("points on a line need two control points; chord lengths make them exact", "[approximation]") {
  const auto run = run_of("approximation", R"({"points": [[0,0],[3,4],[9,12],[12,16],[30,40]], "degree": 1})");
  CHECK(std::get<Curve<Exact>>(run.outcome).points.size() == 2);
  CHECK(number_of(run, "try[2].E") == Exact(0));
}

TEST_CASE("recorded, plain, double and exact runs of longer rows agree", "[approximation]") {
  std::mt19937 random(3);
  const auto points = random_row(random, 40, 2);
  for (const auto way : {Parametrization::chord, Parametrization::centripetal}) {
    for (const int count : {4, 9, 17, 25}) {
      INFO(count << " control points");
      const auto exact = approximated(points, 3, count, Exact(0), way);
      NoRecorder<double> none;
      const auto rounded = approximation(convert<double>(points), 3, count, 0.0, way, none);
      for (std::size_t i = 0; i < exact.points.size(); ++i)
        for (int c = 0; c < 4; ++c)
          CHECK(near(rounded.points[i][c], exact.points[i][c].to_double(), largest_coordinate(exact)));
    }
  }
}

TEST_CASE("what approximation cannot do is told", "[approximation]") {
  const std::string points = R"({"points": [[0,0],[1,0],[2,0],[3,1],[4,1]])";
  CHECK(mistake(points + R"(, "count": 3})").find("count: must be from 4 (degree + 1) to 5 (the number of points)") !=
        std::string::npos);
  CHECK(mistake(points + R"(, "degree": 5})").find("degree: the degree must be from 1 to 4 here") != std::string::npos);
  CHECK(mistake(points + R"(, "tolerance": -1})").find("tolerance: must not be negative") != std::string::npos);
  CHECK(mistake(points + R"(, "count": 5})").empty());
}
