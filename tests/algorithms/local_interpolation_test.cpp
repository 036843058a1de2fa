// Local interpolation: through the points, with one derivative at the joints, and local.

#include "kernel/local_interpolation.hpp"
#include "algorithms/curves.hpp"
#include "kernel/derivatives.hpp"

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

Curve<Exact> uniform_curve(const PointRow<Exact>& points, LocalTangents tangents) {
  return both_ways<Exact>(
      [&](auto& recorder) { return local_interpolation(points, tangents, Parametrization::uniform, recorder); });
}

// C'(t) of the piece that ends at t, or of the one that begins there.
Point<Exact> slope(const Curve<Exact>& curve, std::size_t knot, bool left) {
  const auto U = curve.knots[knot];
  const auto i = static_cast<std::size_t>(left ? std::ranges::lower_bound(curve.knots, U) - curve.knots.begin() - 1
                                               : std::ranges::upper_bound(curve.knots, U) - curve.knots.begin() - 1);
  std::vector<Exact> ders(8);
  basis_derivatives<Exact>(std::span<const Exact>(curve.knots), 3, static_cast<int>(i), U, 1, ders);
  Point<Exact> sum(Exact(0));
  for (std::size_t r = 0; r < 4; ++r) {
    const auto& P = curve.points[i - 3 + r];
    sum += Point<Exact>(P.x, P.y, P.z) * ders[4 + r];
  }
  return sum;
}

}  // namespace

TEST_CASE("through every point at its parameter, and with one derivative there", "[local_interpolation]") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int count = random_int(random, 2, 9);
    const auto points = random_row(random, count, random_int(random, 2, 3));
    for (const auto tangents : {LocalTangents::bessel, LocalTangents::akima}) {
      for (const auto way : {Parametrization::uniform, Parametrization::chord, Parametrization::centripetal}) {
        TraceRecorder<Exact> recorder;
        const auto curve = local_interpolation(points, tangents, way, recorder);
        const auto& trace = recorder.trace();
        CHECK(curve.points.size() == 2 * static_cast<std::size_t>(count));
        REQUIRE(curve.knots.size() == curve.points.size() + 4);
        const double scale = 10 * largest_coordinate(curve);
        for (int k = 0; k < count; ++k) {
          const Exact t = trace.numbers(*trace.find("t[" + std::to_string(k) + "]"))[0];
          const auto V = trace.numbers(*trace.find("V[" + std::to_string(k) + "]"));
          const auto C = point(curve, t).value();
          std::vector<Point<Exact>> ders(2);
          REQUIRE(derivatives(curve, t, 1, ders));
          for (int c = 0; c < 3; ++c) {
            CHECK(near(C[c].to_double(), points.points[static_cast<std::size_t>(k)][c].to_double(), scale));
            CHECK(near(ders[1][c].to_double(), V[static_cast<std::size_t>(c)].to_double(), 100 * scale));
          }
        }
      }
      const auto exact = uniform_curve(points, tangents);
      for (std::size_t k = 1; k + 1 < static_cast<std::size_t>(count); ++k) {
        CHECK(point(exact, Exact::ratio(static_cast<int>(k), count - 1)).value() ==
              Point<Exact>(points.points[k].x, points.points[k].y, points.points[k].z));
        if (tangents == LocalTangents::bessel) CHECK(slope(exact, 2 + 2 * k, true) == slope(exact, 2 + 2 * k, false));
      }
    }
  }
}

TEST_CASE("Bessel's tangents give a parabola back", "[local_interpolation]") {
  PointRow<Exact> points{{}, 3};
  const auto at = [](const Exact& t) {
    return HPoint<Exact>(Exact(3) * t * t - t, Exact(2) - t * t, Exact(5) * t + Exact(1), Exact(1));
  };
  for (int k = 0; k <= 5; ++k) points.points.push_back(at(Exact::ratio(k, 5)));
  const auto curve = uniform_curve(points, LocalTangents::bessel);
  for (int i = 0; i <= 40; ++i) CHECK(homogeneous_point(curve, Exact::ratio(i, 40)) == at(Exact::ratio(i, 40)));
}

TEST_CASE("Akima's tangents are those of his formula for functions, and keep straight what is straight",
          "[local_interpolation]") {
  // A function over evenly spaced x: the slopes' differences are those of y alone. The first data of Akima's paper.
  const std::vector<int> y{0, 0, 0, 0, 0, 1, 10, 11, 15, 50, 60, 80};
  PointRow<Exact> points{{}, 2};
  for (std::size_t k = 0; k < y.size(); ++k) points.points.push_back({Exact(static_cast<int>(k)), y[k], 0, 1});
  TraceRecorder<Exact> recorder;
  const auto curve = local_interpolation(points, LocalTangents::akima, Parametrization::uniform, recorder);
  const auto& trace = recorder.trace();
  CHECK(trace.approximate_values().empty());
  for (std::size_t k = 2; k + 2 < y.size(); ++k) {
    const auto m = [&](std::size_t i) { return y[i + 1] - y[i]; };
    const int above = std::abs(m(k + 1) - m(k)), below = std::abs(m(k - 1) - m(k - 2));
    const Exact tangent = above + below == 0 ? Exact::ratio(m(k - 1) + m(k), 2)
                                             : Exact::ratio(above * m(k - 1) + below * m(k), above + below);
    INFO("point " << k);
    const auto V = trace.numbers(*trace.find("V[" + std::to_string(k) + "]"));
    CHECK(V[1] / V[0] == tangent);
  }
  for (int i = 0; i <= 30; ++i)  // straight up to the point before the last of five in a row
    CHECK(point(curve, Exact::ratio(3 * i, 30 * 11)).value().y == Exact(0));
}

TEST_CASE("a point has influence on few pieces only", "[local_interpolation]") {
  std::mt19937 random(9);
  auto points = random_row(random, 12, 2);
  for (const auto tangents : {LocalTangents::bessel, LocalTangents::akima}) {
    const auto before = uniform_curve(points, tangents);
    auto moved = points;
    moved.points[5].y += Exact(3);
    const auto after = uniform_curve(moved, tangents);
    const std::size_t reach = tangents == LocalTangents::bessel ? 2 : 3;  // pieces on either side
    for (std::size_t i = 0; i < before.points.size(); ++i) {
      const std::size_t piece = i / 2;  // P[2k+1] and P[2k+2] belong to piece k
      const bool far = i <= 2 * (5 - reach) || i >= 2 * (5 + reach) + 1;
      INFO("control point " << i << " of piece " << piece);
      if (far) CHECK(before.points[i] == after.points[i]);
    }
    CHECK(before.points[10] != after.points[10]);
  }
}

TEST_CASE("points that coincide have no chord", "[local_interpolation]") {
  const auto inputs = inputs_of(*find_algorithm("local_interpolation"), R"({"points": [[0,0],[1,0],[1,0],[2,0]]})");
  REQUIRE(inputs);
  CHECK(to_string(record<Exact>(*find_algorithm("local_interpolation"), *inputs).diagnostics)
            .find("points[2]: coincides with the point before it") != std::string::npos);
}
