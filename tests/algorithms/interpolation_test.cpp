// Global interpolation: the curve passes through every point at its parameter, and has the derivatives wanted.

#include "kernel/interpolation.hpp"
#include "algorithms/curves.hpp"
#include "kernel/derivatives.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr Parametrization all_ways[] = {Parametrization::chord, Parametrization::centripetal, Parametrization::uniform,
                                        Parametrization::universal};

PointRow<Exact> random_row(std::mt19937& random, int count, int dimension) {
  PointRow<Exact> row{{}, dimension};
  while (static_cast<int>(row.points.size()) < count) {
    const auto P = any_place(random, dimension);
    if (row.points.empty() || row.points.back() != P) row.points.push_back(P);
  }
  return row;
}

PointRow<double> rounded_row(const PointRow<Exact>& row) { return convert<double>(row); }

std::vector<Exact> parameters_of(const Trace<Exact>& trace, std::size_t count) {
  std::vector<Exact> t;
  for (std::size_t k = 0; k < count; ++k) t.push_back(trace.numbers(*trace.find("t[" + std::to_string(k) + "]"))[0]);
  return t;
}

void check_interpolates(const PointRow<Exact>& points, int degree, Parametrization way, const PointRow<Exact>& start,
                        const PointRow<Exact>& end) {
  TraceRecorder<Exact> recorder;
  NoRecorder<double> none;
  const auto curve = interpolation(points, degree, way, start, end, recorder);
  const auto rounded = interpolation(rounded_row(points), degree, way, rounded_row(start), rounded_row(end), none);
  const auto& trace = recorder.trace();
  const auto t = parameters_of(trace, points.points.size());
  const bool exact = trace.approximate_values().empty();
  if (way == Parametrization::uniform || (way == Parametrization::universal && degree == 2)) CHECK(exact);
  const double scale = largest_coordinate(curve);
  CHECK(curve.degree == degree);
  CHECK(curve.points.size() == points.points.size() + start.points.size() + end.points.size());
  REQUIRE(curve.knots.size() == curve.points.size() + static_cast<std::size_t>(degree) + 1);
  CHECK(std::ranges::is_sorted(curve.knots));
  CHECK(t.front() == Exact(0));
  CHECK(t.back() == Exact(1));
  const auto agrees = [&](const Point<Exact>& A, const HPoint<Exact>& B, double size) {
    for (int c = 0; c < 3; ++c) {
      if (exact)
        CHECK(A[c] == B[c]);
      else
        CHECK(near(A[c].to_double(), B[c].to_double(), size));
    }
  };
  for (std::size_t k = 0; k < t.size(); ++k) {
    INFO("point " << k << " at t = " << t[k].to_string());
    if (k > 0) CHECK(t[k - 1] < t[k]);
    agrees(point(curve, t[k]).value(), points.points[k], scale);
    const auto R = point(rounded, t[k].to_double()).value();
    for (int c = 0; c < 3; ++c) CHECK(near(R[c], points.points[k][c].to_double(), 100 * scale));
  }
  for (const auto* tangent : {&start, &end}) {
    if (tangent->points.empty()) continue;
    std::vector<Point<Exact>> C(2);
    REQUIRE(derivatives(curve, Exact(tangent == &start ? 0 : 1), 1, C));
    agrees(C[1], tangent->points.front(), 1e3 * scale);
  }
}

const PointRow<Exact> none_given{{}, 2};

Run<Exact> run_with(const std::string& points, const std::string& rest) {
  return run_of("interpolation", R"({"points": )" + points + rest + "}");
}

std::string mistake(const std::string& inputs) {
  const Algorithm& algorithm = *find_algorithm("interpolation");
  const auto read = inputs_of(algorithm, inputs);
  return to_string(read ? record<Exact>(algorithm, *read).diagnostics : read.diagnostics);
}

}  // namespace

TEST_CASE("random points, degrees and parametrizations, with and without tangents", "[interpolation]") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int dimension = random_int(random, 2, 3);
    const int count = random_int(random, 2, 8);
    const auto points = random_row(random, count, dimension);
    for (const int tangents : {0, 1, 2, 3}) {
      const auto start = tangents % 2 == 1 ? random_row(random, 1, dimension) : none_given;
      const auto end = tangents / 2 == 1 ? random_row(random, 1, dimension) : none_given;
      const int most = count + static_cast<int>(start.points.size() + end.points.size()) - 1;
      const int degree = random_int(random, tangents > 0 ? 2 : 1, std::min(most, 5));
      for (const auto way : all_ways) {
        INFO("degree " << degree << ", way " << static_cast<int>(way) << ", tangents " << tangents);
        check_interpolates(points, degree, way, start, end);
      }
    }
  }
}

TEST_CASE("two points with two tangents are the cubic of Hermite", "[interpolation]") {
  const auto run = run_with("[[0, 0], [6, 3]]", R"(, "start_tangent": [[3, 9]], "end_tangent": [[6, -3]])");
  CHECK(std::get<Curve<Exact>>(run.outcome).knots == bezier_knots<Exact>(3));
  CHECK(point_of(run, "P[1]") == std::vector<Exact>{1, 3});
  CHECK(point_of(run, "P[2]") == std::vector<Exact>{4, 4});
}

TEST_CASE("The NURBS Book, example 9.1", "[interpolation]") {
  const auto run = run_with("[[0,0],[3,4],[-1,4],[-4,0],[-4,-3]]", "");
  const char* parameters[] = {"0", "5/17", "9/17", "14/17", "1"};
  for (int k = 0; k < 5; ++k) CHECK(number_of(run, "t[" + std::to_string(k) + "]") == q(parameters[k]));
  CHECK(numbers_of(run, "U") == knots({"0", "0", "0", "0", "28/51", "1", "1", "1", "1"}));
  CHECK(run.trace.approximate_values().empty());
}

TEST_CASE("The NURBS Book, equations 9.8 and 9.9: knots without and with end derivatives", "[interpolation]") {
  const std::string points = "[[0,0],[3,4],[-1,4],[-4,0],[-4,-3]]";
  const auto run = run_with(points, R"(, "start_tangent": [[1,0]], "end_tangent": [[0,1]])");
  // u_4 = (0 + 5/17 + 9/17)/3, u_5 = (5 + 9 + 14)/51, u_6 = (9 + 14 + 17)/51
  CHECK(numbers_of(run, "U") == knots({"0", "0", "0", "0", "14/51", "28/51", "40/51", "1", "1", "1", "1"}));
}

TEST_CASE("Shene's points: chord length and centripetal parameters", "[interpolation]") {
  const std::string points = "[[0,0],[1,2],[3,4],[4,0]]";
  const auto t = [&](const char* way, int k) {
    return number_of(run_with(points, std::string(R"(, "parametrization": ")") + way + "\""),
                     "t[" + std::to_string(k) + "]")
        .to_double();
  };
  CHECK(t("chord", 1) == Approx(0.243379).margin(5e-7));
  CHECK(t("chord", 2) == Approx(0.551232).margin(5e-7));
  CHECK(t("centripetal", 1) == Approx(0.287143).margin(5e-7));
  CHECK(t("centripetal", 2) == Approx(0.610087).margin(5e-7));
  CHECK(t("uniform", 1) == Approx(1.0 / 3).margin(1e-15));
}

TEST_CASE("universal parameters are where the basis functions are largest", "[interpolation]") {
  for (int p = 1; p <= 5; ++p) {
    for (int n = p; n <= p + 5; ++n) {
      std::vector<double> U(static_cast<std::size_t>(n + p + 2), 0);
      for (int j = p + 1; j < n + p + 2; ++j)
        U[static_cast<std::size_t>(j)] = std::min(1.0, static_cast<double>(j - p) / (n - p + 1));
      double before = -1;
      for (int i = 0; i <= n; ++i) {
        INFO("degree " << p << ", function " << i << " of " << n);
        const double t = Peak::apply<double>(i, p, U);
        CHECK(before < t);
        before = t;
        const double top = basis_function<double>(U, p, i, t);
        for (int s = 0; s <= 1000; ++s) CHECK(basis_function<double>(U, p, i, s / 1000.0) <= top + 1e-12);
        // The exact one is the same, and exact where it says so.
        std::vector<Exact> E;
        for (int j = 0; j < n + p + 2; ++j)
          E.push_back(j <= p ? Exact(0) : j > n ? Exact(1) : Exact::ratio(j - p, n - p + 1));
        const Exact exact = Peak::apply<Exact>(i, p, E);
        CHECK(near(exact.to_double(), t));
        if (p <= 2 || n == p) CHECK(!exact.is_approximate());
        if (n == p) CHECK(exact == Exact::ratio(i, p));  // Bernstein polynomials
      }
    }
  }
}

TEST_CASE("what interpolation cannot do is told", "[interpolation]") {
  CHECK(mistake(R"({"points": [[0,0],[1,0],[2,0]]})")
            .find("the degree must be from 1 to 2 here (points less one), not 3: take a lower degree or more points") !=
        std::string::npos);
  CHECK(mistake(R"({"points": [[0,0],[1,0],[2,0]], "start_tangent": [[1,1]]})").empty());
  CHECK(mistake(R"({"points": [[0,0],[1,0]], "degree": 1, "start_tangent": [[1,1]]})")
            .find("degree: the degree must be at least 2 where a tangent is given") != std::string::npos);
  CHECK(mistake(R"({"points": [[0,0],[1,0],[1,0],[2,0]]})").find("points[2]: coincides with the point before it") !=
        std::string::npos);
  CHECK(mistake(R"({"points": [[0,0],[1,0],[1,0],[2,0]], "parametrization": "uniform"})").empty());
}
