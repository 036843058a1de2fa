#include "kernel/derivatives.hpp"

#include <catch2/catch.hpp>
#include <vector>

#include "kernel/evaluator.hpp"
#include "splines.hpp"

namespace blossom {
namespace {

using namespace test;

Curve<Exact> quarter_circle() { return plane_curve(2, bezier_knots<Exact>(2), {{1, 0}, {1, 1}, {0, 1, 2}}); }

std::string text(const Point<Exact>& P) { return P.x.to_string() + " " + P.y.to_string() + " " + P.z.to_string(); }

TEST_CASE("derivatives of the rational quarter circle, as The NURBS Book has them", "[derivatives]") {
  std::vector<Point<Exact>> C(4);
  REQUIRE(derivatives(quarter_circle(), 0, 3, C));
  CHECK(text(C[0]) == "1 0 0");
  CHECK(text(C[1]) == "0 2 0");
  CHECK(text(C[2]) == "-4 0 0");
  CHECK(text(C[3]) == "0 -12 0");
  REQUIRE(derivatives(quarter_circle(), 1, 2, C));
  CHECK(text(C[1]) == "-1 0 0");
  CHECK(text(C[2]) == "1 -1 0");
}

// The derivative curve: Q_i = p (P_{i+1} - P_i) / (u_{i+p+1} - u_{i+1}) on the inner knots (The NURBS Book, eq. 3.8).
Curve<Exact> derivative_curve(const Curve<Exact>& curve) {
  const int p = curve.degree;
  Curve<Exact> result{p - 1, {curve.knots.begin() + 1, curve.knots.end() - 1}, {}, curve.dimension, true, false};
  for (int i = 0; i < curve.n(); ++i) {
    const Exact length = curve.knots[i + p + 1] - curve.knots[i + 1];
    // Where p + 1 knots coincide the point acts on no span; any will do.
    result.points.push_back(length == Exact(0) ? HPoint<Exact>(Exact(0))
                                               : (curve.points[i + 1] - curve.points[i]) * (Exact(p) / length));
  }
  return result;
}

TEST_CASE("the derivative curve of Shene's notes", "[derivatives]") {
  const std::vector<Exact> U{0, 0, 0, 0, q("2/5"), q("3/5"), q("3/5"), 1, 1, 1, 1};
  // P_i = (sum of the first i powers of two): then P_{i+1} - P_i = 2^i, and Q_i = c_i 2^i.
  std::vector<PlanePoint> points;
  for (int i = 0; i < 7; ++i) points.push_back({(1 << i) - 1, 0});
  const auto Q = derivative_curve(plane_curve(3, U, points));
  const std::vector<Exact> c{q("15/2"), 5, 5, 5, q("15/2"), q("15/2")};
  for (int i = 0; i < 6; ++i) CHECK(Q.points[i].x == c[i] * Exact(1 << i));

  std::vector<HPoint<Exact>> A(2);
  homogeneous_derivatives<Exact>(plane_curve(3, U, points), q("1/2"), 1, A);
  CHECK(A[1].x == homogeneous_point(Q, q("1/2")).x);
}

TEST_CASE("homogeneous derivatives are points of the derivative curves, and vanish above the degree", "[derivatives]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 2, 6);
    const auto curve = random_curve(random, p, 3, p + 1, seed % 2 == 0, true);
    const Exact u = random_parameter(random, curve.knots, p);
    std::vector<HPoint<Exact>> A(static_cast<std::size_t>(p) + 3, HPoint<Exact>(Exact(7)));
    homogeneous_derivatives<Exact>(curve, u, p + 2, A);
    std::vector<HPoint<double>> B(A.size());
    homogeneous_derivatives<double>(rounded(curve), u.to_double(), p + 2, B);
    CHECK(A[0] == homogeneous_point(curve, u));
    auto hodograph = curve;
    for (int j = 1; j < p; ++j) {
      hodograph = derivative_curve(hodograph);
      CHECK(A[j] == homogeneous_point(hodograph, u));
      const double size = 1 + glm::length(rounded(A[j]));
      CHECK(distance(B[j], rounded(A[j])) < 1e-9 * size);
    }
    CHECK(A[p + 1] == HPoint<Exact>(Exact(0)));
    CHECK(A[p + 2] == HPoint<Exact>(Exact(0)));
  }
}

TEST_CASE("the first derivatives are limits of difference quotients, taken exactly", "[derivatives]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const auto curve = random_curve(random, random_int(random, 1, 4), 1, 1, true, true);
    const Exact begin = curve.domain_begin(), length = curve.domain_end() - begin;
    const Exact u = begin + length * q("3/7");
    std::vector<Point<Exact>> C(3);
    REQUIRE(derivatives(curve, u, 2, C));
    const auto at = [&](const Exact& x) { return *point(curve, x); };
    const auto error = [&](const Exact& h, int order) {
      const auto quotient =
          order == 1 ? (at(u + h) - at(u - h)) / (2 * h) : (at(u + h) - at(u) * Exact(2) + at(u - h)) / (h * h);
      return distance(rounded(quotient), rounded(C[static_cast<std::size_t>(order)]));
    };
    // Central quotients err by O(h^2): a step ten times as small, an error a hundred times as small.
    for (int order : {1, 2}) {
      const double coarse = error(length * q("1/1000"), order);
      const double fine = error(length * q("1/10000"), order);
      CHECK(fine <= coarse * 0.011 + 1e-12);
    }
  }
}

TEST_CASE("rational derivatives satisfy Leibniz' rule A = w C to any order, also above the degree", "[derivatives]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 4);
    const int d = p + 3;
    const auto curve = random_curve(random, p, 3, p, seed % 2 == 0, true);
    const Exact u = random_parameter(random, curve.knots, p);
    std::vector<HPoint<Exact>> A(static_cast<std::size_t>(d) + 1);
    std::vector<Point<Exact>> C(A.size());
    homogeneous_derivatives<Exact>(curve, u, d, A);
    REQUIRE(derivatives(curve, u, d, C));
    for (int k = 0; k <= d; ++k) {
      Point<Exact> sum(Exact(0));
      Exact binomial(1);
      for (int i = 0; i <= k; ++i) {
        sum += C[k - i] * (binomial * A[i].w);
        binomial = binomial * Exact(k - i) / Exact(i + 1);
      }
      CHECK(sum == Point<Exact>(A[k].x, A[k].y, A[k].z));
    }

    std::vector<Point<double>> D(C.size()), E(C.size());
    REQUIRE(derivatives(rounded(curve), u.to_double(), d, D));
    REQUIRE(CurveEvaluator(rounded(curve)).derivatives(u.to_double(), d, E));
    CHECK(D == E);
    for (int k = 0; k <= d; ++k) {
      INFO("order " << k);
      CHECK(distance(D[k], rounded(C[k])) < 1e-8 * (1 + glm::length(rounded(C[k]))));
    }
  }
}

TEST_CASE("at a knot the derivatives are those of the piece to the right, at the end of the piece to the left",
          "[derivatives]") {
  const auto corner = plane_curve(1, {0, 0, 1, 2, 2}, {{0, 0}, {1, 0}, {1, 3}});
  std::vector<Point<Exact>> C(2);
  REQUIRE(derivatives(corner, 1, 1, C));
  CHECK(text(C[1]) == "0 3 0");
  REQUIRE(derivatives(corner, 2, 1, C));
  CHECK(text(C[1]) == "0 3 0");
  REQUIRE(derivatives(corner, 0, 1, C));
  CHECK(text(C[1]) == "1 0 0");
}

TEST_CASE("there are no derivatives where the denominator is zero", "[derivatives]") {
  auto curve = quarter_circle();
  curve.points[2] = {0, 1, 0, 0};
  std::vector<Point<Exact>> C(3);
  CHECK_FALSE(derivatives(curve, 1, 2, C));
  std::vector<Point<double>> D(3);
  CHECK_FALSE(derivatives(rounded(curve), 1.0, 2, D));
  CHECK_FALSE(CurveEvaluator(rounded(curve)).derivatives(1.0, 2, D));
}

// An isoparametric curve of the surface: in u at fixed v, from the definition.
Curve<Exact> curve_in_u(const Surface<Exact>& surface, const Exact& v) {
  Curve<Exact> result{surface.degree[0], surface.knots[0], {}, 3, true, false};
  for (int i = 0; i < surface.rows; ++i) {
    Curve<Exact> row{surface.degree[1], surface.knots[1], {}, 3, true, false};
    for (int j = 0; j < surface.columns; ++j) row.points.push_back(surface.at(i, j));
    result.points.push_back(homogeneous_point(row, v));
  }
  return result;
}

Surface<Exact> transposed(const Surface<Exact>& surface) {
  Surface<Exact> result = surface;
  std::swap(result.degree[0], result.degree[1]);
  std::swap(result.knots[0], result.knots[1]);
  std::swap(result.rows, result.columns);
  for (int i = 0; i < result.rows; ++i) {
    for (int j = 0; j < result.columns; ++j) result.at(i, j) = surface.at(j, i);
  }
  return result;
}

TEST_CASE("surface derivatives: pure ones are those of isoparametric curves, mixed ones obey Leibniz",
          "[derivatives]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 3), q = random_int(random, 1, 3), d = 4;
    const auto surface = random_surface(random, p, q, 2, seed % 2 == 0, true);
    const Exact u = random_parameter(random, surface.knots[0], p);
    const Exact v = random_parameter(random, surface.knots[1], q);
    std::vector<Point<Exact>> D(25), along_u(5), along_v(5);
    REQUIRE(derivatives(surface, u, v, d, D));
    REQUIRE(derivatives(curve_in_u(surface, v), u, d, along_u));
    REQUIRE(derivatives(curve_in_u(transposed(surface), u), v, d, along_v));
    for (int k = 0; k <= d; ++k) {
      CHECK(D[k * (d + 1)] == along_u[k]);
      CHECK(D[k] == along_v[k]);
    }

    // (wS)_uv = w S_uv + w_u S_v + w_v S_u + w_uv S; the left side from a bilinear blend of basis derivatives.
    std::vector<Exact> M(2 * (p + 1)), N(2 * (q + 1));
    const int k = find_span<Exact>(surface.knots[0], p, u), l = find_span<Exact>(surface.knots[1], q, v);
    basis_derivatives<Exact>(surface.knots[0], p, k, u, 1, M);
    basis_derivatives<Exact>(surface.knots[1], q, l, v, 1, N);
    const auto blend = [&](int i, int j) {
      HPoint<Exact> sum(Exact(0));
      for (int r = 0; r <= p; ++r) {
        for (int s = 0; s <= q; ++s) {
          sum += surface.at(k - p + r, l - q + s) * (M[i * (p + 1) + r] * N[j * (q + 1) + s]);
        }
      }
      return sum;
    };
    const HPoint<Exact> Auv = blend(1, 1);
    CHECK(Point<Exact>(Auv.x, Auv.y, Auv.z) ==
          D[d + 2] * blend(0, 0).w + D[1] * blend(1, 0).w + D[d + 1] * blend(0, 1).w + D[0] * Auv.w);

    std::vector<Point<double>> E(25);
    REQUIRE(derivatives(rounded(surface), u.to_double(), v.to_double(), d, E));
    for (int a = 0; a <= d; ++a) {
      for (int b = 0; a + b <= d; ++b) {
        INFO("order " << a << ", " << b);
        const Point<double> expected = rounded(D[a * (d + 1) + b]);
        CHECK(distance(E[a * (d + 1) + b], expected) < 1e-8 * (1 + glm::length(expected)));
      }
    }
  }
}

TEST_CASE("the unit normal is the cross product of the partial derivatives, normalized", "[derivatives]") {
  for (unsigned seed = 0; seed < 30; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 4);
    const int q = seed % 2 == 0 ? p : random_int(random, 1, 4);
    const auto exact_surface = random_surface(random, p, q, 2, seed % 2 == 0, seed % 3 == 0);
    const auto surface = rounded(exact_surface);
    const double u = random_parameter(random, exact_surface.knots[0], p).to_double();
    const double v = random_parameter(random, exact_surface.knots[1], q).to_double();
    std::vector<Point<double>> D(4);
    REQUIRE(derivatives(surface, u, v, 1, D));
    const auto expected = glm::normalize(glm::cross(D[2], D[1]));
    const auto normal = unit_normal(surface, u, v);
    REQUIRE(normal.has_value());
    CHECK(distance(*normal, expected) < 1e-9);
    for (const auto& both : {SurfaceEvaluator(surface).point_and_normal(u, v), point_and_normal(surface, u, v)}) {
      REQUIRE(both.has_value());
      CHECK(distance(both->point, D[0]) < 1e-12);
      REQUIRE(both->normal.has_value());
      CHECK(distance(*both->normal, expected) < 1e-9);
    }
  }
}

// An octant of the unit sphere, a quarter circle in u (latitude) by one in v (longitude); all of u = 1 is the pole.
Surface<double> octant() {
  const double c = std::sqrt(0.5);
  const double circle[3][3] = {{1, 0, 1}, {1, 1, c}, {0, 1, 1}};  // (cos, sin, weight)
  Surface<double> surface{{2, 2}, {bezier_knots<double>(2), bezier_knots<double>(2)}, 3, 3, {}, true, true};
  for (const auto& latitude : circle) {
    for (const auto& longitude : circle) {
      const double w = latitude[2] * longitude[2];
      surface.points.push_back({w * latitude[0] * longitude[0], w * latitude[0] * longitude[1], w * latitude[1], w});
    }
  }
  return surface;
}

TEST_CASE("the normal of a sphere is radial, at the pole too", "[derivatives]") {
  const auto surface = octant();
  const SurfaceEvaluator evaluator(surface);
  for (double u : {0.0, 0.3, 0.9, 0.999999, 1 - 1e-9, 1.0}) {
    for (double v : {0.0, 0.4, 1.0}) {
      INFO("u = " << u << ", v = " << v);
      const auto S = point(surface, u, v);
      const auto normal = unit_normal(surface, u, v);
      REQUIRE(normal.has_value());
      CHECK(distance(*normal, -*S) < 1e-6);  // S_u x S_v points inward: north times east
      for (const auto& both : {evaluator.point_and_normal(u, v), point_and_normal(surface, u, v)}) {
        REQUIRE((both && both->normal));
        CHECK(distance(*both->normal, *normal) < 1e-6);
      }
    }
  }
}

TEST_CASE("a pole is recognized when rounding leaves a little of the vanishing tangent", "[derivatives]") {
  // The octant moved to where no coordinate of the pole is a short binary number, and on other knots.
  int inexact = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform(0.1, 10);
    auto surface = octant();
    const Point<double> centre(uniform(random), uniform(random), uniform(random));
    for (auto& P : surface.points) P += HPoint<double>(centre * P.w, 0);
    for (double& v : surface.knots[1]) v = 0.1 + v * uniform(random) / 100;
    std::fill(surface.knots[1].begin() + 4, surface.knots[1].end(), surface.knots[1][3]);
    const double v = 0.5 * (surface.knots[1][0] + surface.knots[1][3]);
    std::vector<Point<double>> D(4);
    REQUIRE(derivatives(surface, 1.0, v, 1, D));
    if (D[1] != Point<double>(0.0)) ++inexact;
    const auto normal = unit_normal(surface, 1.0, v);
    REQUIRE(normal.has_value());
    CHECK(distance(*normal, Point<double>(0, 0, -1)) < 1e-9);
  }
  CHECK(inexact > 0);  // otherwise this test has not tested what it says
}

TEST_CASE("the limit normal has the sign of its neighbours at either end of either direction", "[derivatives]") {
  // A triangle (0,0), (1,0), (0,1) as a bilinear patch with one edge collapsed: its normal is +-z everywhere.
  const HPoint<Exact> A(0, 0, 0, 1), B(1, 0, 0, 1), C(0, 1, 0, 1);
  const std::vector<std::vector<HPoint<Exact>>> nets{{A, A, B, C}, {B, C, A, A}, {A, B, A, C}, {B, A, C, A}};
  for (const auto& net : nets) {
    const Surface<Exact> patch{{1, 1}, {bezier_knots<Exact>(1), bezier_knots<Exact>(1)}, 2, 2, net, false, true};
    const auto inside = normal_direction(patch, q("1/2"), q("1/2"));
    REQUIRE(inside.has_value());
    for (const Exact& u : {Exact(0), q("1/3"), Exact(1)}) {
      for (const Exact& v : {Exact(0), q("1/3"), Exact(1)}) {
        const auto normal = normal_direction(patch, u, v);
        REQUIRE(normal.has_value());
        CHECK(normal->x == Exact(0));
        CHECK(normal->y == Exact(0));
        CHECK((normal->z > Exact(0)) == (inside->z > Exact(0)));
        const auto in_double = unit_normal(rounded(patch), u.to_double(), v.to_double());
        REQUIRE(in_double.has_value());
        CHECK(in_double->z == Approx(inside->z > Exact(0) ? 1 : -1));
      }
    }
  }
}

TEST_CASE("there is no normal where there is none: a point, a line, a zero denominator", "[derivatives]") {
  Surface<Exact> patch{{1, 1}, {bezier_knots<Exact>(1), bezier_knots<Exact>(1)}, 2, 2, {}, false, true};
  const auto check_none = [&] {
    CHECK_FALSE(normal_direction(patch, q("1/2"), q("1/3")).has_value());
    CHECK_FALSE(unit_normal(rounded(patch), 0.5, 1 / 3.0).has_value());
    const auto both = SurfaceEvaluator(rounded(patch)).point_and_normal(0.5, 1 / 3.0);
    CHECK((!both || !both->normal));
  };
  patch.points.assign(4, {q("1/3"), q("1/7"), 2, 1});
  check_none();
  patch.points = {{0, 0, 0, 1}, {1, q("1/3"), 1, 1}, {2, q("2/3"), 2, 1}, {3, 1, 3, 1}};
  check_none();
  patch.points = {{0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0}};
  check_none();
}

}  // namespace
}  // namespace blossom
