#include "kernel/surface_shape.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "shapes.hpp"
#include "splines.hpp"

namespace blossom {
namespace {

using namespace test;
using Vector = Point<double>;

std::vector<double> inside(int count) {
  std::vector<double> result;
  for (int i = 0; i < count; ++i) result.push_back((i + 0.37) / count);
  return result;
}

void check_invariants(const SurfaceShape& at) {
  const auto& [K, H, k1, k2] = at.curvatures;
  CHECK(K == Approx(k1 * k2).margin(1e-12));
  CHECK(H == Approx((k1 + k2) / 2).margin(1e-12));
  CHECK(k1 >= k2);
  const double area = at.E * at.G - at.F * at.F;
  const double size = 1 + k1 * k1 + k2 * k2;
  CHECK(K == Approx((at.L * at.N - at.M * at.M) / area).margin(1e-7 * size));
  CHECK(H == Approx((at.E * at.N - 2 * at.F * at.M + at.G * at.L) / (2 * area)).margin(1e-7 * size));
  CHECK(at.E == Approx(glm::dot(at.Su, at.Su)));
  CHECK(at.F == Approx(glm::dot(at.Su, at.Sv)).margin(1e-9 * std::sqrt(at.E * at.G)));
  CHECK(at.G == Approx(glm::dot(at.Sv, at.Sv)));
  CHECK(glm::length(at.maximum_direction) == Approx(1));
  CHECK(distance(Vector(glm::cross(at.maximum_direction, at.minimum_direction)), at.normal) < 1e-9);
}

// The curvature of the normal section in a direction of the tangent plane, from the fundamental forms: with the
// direction = x S_u + y S_v, it is the second form of (x, y), over the first.
double section_curvature(const SurfaceShape& at, const Vector& direction) {
  const double area = at.E * at.G - at.F * at.F;
  const double du = glm::dot(direction, at.Su), dv = glm::dot(direction, at.Sv);
  const double x = (at.G * du - at.F * dv) / area, y = (at.E * dv - at.F * du) / area;
  return (at.L * x * x + 2 * at.M * x * y + at.N * y * y) / (at.E * x * x + 2 * at.F * x * y + at.G * y * y);
}

TEST_CASE("every point of a sphere is an umbilic of curvature 1/r", "[surface_shape]") {
  const auto ball = sphere(2);
  for (const double u : inside(9)) {
    for (const double v : inside(7)) {
      INFO("u = " << u << ", v = " << v);
      const auto at = surface_shape(ball, u, v);
      REQUIRE(at);
      check_invariants(*at);
      CHECK(distance(at->normal, at->point / 2.0) < 1e-12);  // outwards, so the surface bends away from it
      CHECK(at->curvatures.maximum == Approx(-0.5));
      CHECK(at->curvatures.minimum == Approx(-0.5));
      CHECK(at->curvatures.gaussian == Approx(0.25));
      CHECK(at->curvatures.mean == Approx(-0.5));
      CHECK(at->umbilic);
      CHECK(distance(at->maximum_direction, at->Su / glm::length(at->Su)) < 1e-12);
    }
  }
}

TEST_CASE("the poles of a sphere have no shape, but limits of the curvatures", "[surface_shape]") {
  const auto ball = sphere(2);
  for (const double u : {0.0, 0.2, 0.25, 1.0}) {
    for (const double v : {0.0, 1.0}) {
      INFO("u = " << u << ", v = " << v);
      CHECK_FALSE(surface_shape(ball, u, v));
      const auto limit = curvatures_from_inside(ball, u, v);
      REQUIRE(limit);
      CHECK(limit->gaussian == Approx(0.25).epsilon(1e-5));
      CHECK(limit->mean == Approx(-0.5).epsilon(1e-5));
    }
  }
}

TEST_CASE("a torus has the curvatures of its formulas", "[surface_shape]") {
  const double R = 3, r = 1;
  const auto ring = torus(R, r);
  for (const double u : inside(7)) {
    for (const double v : inside(11)) {
      INFO("u = " << u << ", v = " << v);
      const auto at = surface_shape(ring, u, v);
      REQUIRE(at);
      check_invariants(*at);
      // At the angle t of the small circle: 1/r along it, cos t / (R + r cos t) around the axis.
      const double x = std::hypot(at->point.x, at->point.y), cosine = (x - R) / r;
      CHECK(std::abs(at->curvatures.minimum) == Approx(1 / r));
      CHECK(at->curvatures.minimum < 0);
      CHECK(at->curvatures.maximum == Approx(-cosine / x).margin(1e-10));
      CHECK(at->curvatures.gaussian == Approx(cosine / (r * x)).margin(1e-10));
      CHECK_FALSE(at->umbilic);
      const Vector around = glm::normalize(Vector(-at->point.y, at->point.x, 0));
      CHECK(std::abs(glm::dot(at->maximum_direction, around)) == Approx(1));
    }
  }
}

TEST_CASE("a plane is flat whatever its parameters", "[surface_shape]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    auto plane = rounded(random_surface(random, 3, 2, 3, true, seed % 2 == 0));
    const Vector a(0.3, 0.9, -0.2), b(-1.1, 0.1, 0.7);
    for (int i = 0; i < plane.rows; ++i) {
      for (int j = 0; j < plane.columns; ++j) {
        auto& P = plane.at(i, j);
        const double x = i + 0.1 * P.x / P.w, y = j + 0.07 * P.y / P.w;
        P = HPoint<double>(Vector(5, 6, 7) + a * x + b * y, 1) * P.w;
      }
    }
    const auto& [U, V] = plane.knots;
    const auto at =
        surface_shape(plane, U.front() + (U.back() - U.front()) * 0.3, V.front() + (V.back() - V.front()) * 0.6);
    REQUIRE(at);
    CHECK(at->curvatures.maximum == 0);
    CHECK(at->curvatures.minimum == 0);
    CHECK(at->umbilic);
    CHECK(std::abs(glm::dot(at->normal, glm::cross(a, b))) == Approx(glm::length(glm::cross(a, b))));
  }
}

TEST_CASE("a cylinder has a Gaussian curvature of zero, exactly", "[surface_shape]") {
  const auto tube = revolved(polynomial_curve({{2}, {-1, 3}}, 0, 1));
  for (const double u : inside(12)) {
    INFO("u = " << u);
    const auto at = surface_shape(tube, u, 0.3);
    REQUIRE(at);
    check_invariants(*at);
    CHECK(at->curvatures.gaussian == 0);
    CHECK(at->curvatures.maximum == 0);
    CHECK(at->curvatures.minimum == Approx(-0.5));
    CHECK(std::abs(at->maximum_direction.z) == Approx(1));
  }
}

TEST_CASE("the saddle z = xy: K = -1/(1+x^2+y^2)^2, H = -xy/(1+x^2+y^2)^(3/2)", "[surface_shape]") {
  const auto saddle = bilinear_graph({-2, 3}, {-1, 2}, [](double x, double y) { return x * y; });
  for (const double x : {-2.0, -0.5, 0.0, 1.0, 3.0}) {
    for (const double y : {-1.0, 0.0, 0.7, 2.0}) {
      INFO("x = " << x << ", y = " << y);
      const auto at = surface_shape(saddle, x, y);
      REQUIRE(at);
      check_invariants(*at);
      const double s = 1 + x * x + y * y;
      CHECK(at->curvatures.gaussian == Approx(-1 / (s * s)));
      CHECK(at->curvatures.mean == Approx(-x * y / std::pow(s, 1.5)).margin(1e-14));
    }
  }
  const auto middle = surface_shape(saddle, 0, 0);
  CHECK(distance(middle->maximum_direction, glm::normalize(Vector(1, 1, 0))) < 1e-12);
  CHECK(distance(middle->minimum_direction, glm::normalize(Vector(-1, 1, 0))) < 1e-12);
}

TEST_CASE("principal curvatures are the extreme ones of all normal sections", "[surface_shape]") {
  int regular = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 4), q = random_int(random, 2, 4);
    const auto surface = rounded(random_surface(random, p, q, 2, seed % 2 == 0, seed % 3 == 0));
    const auto at = [&](int d, double t) {
      const auto& U = surface.knots[d];
      const auto degree = static_cast<std::size_t>(surface.degree[d]);
      return U[degree] + (U[U.size() - degree - 1] - U[degree]) * t;
    };
    const auto shape = surface_shape(surface, at(0, 0.31), at(1, 0.62));
    if (!shape || shape->E * shape->G - shape->F * shape->F < 1e-4 * shape->E * shape->G) continue;
    ++regular;
    check_invariants(*shape);
    const auto& [K, H, k1, k2] = shape->curvatures;
    const double size = std::max(std::abs(k1), std::abs(k2));
    CHECK(section_curvature(*shape, shape->maximum_direction) == Approx(k1).margin(1e-7 * size));
    CHECK(section_curvature(*shape, shape->minimum_direction) == Approx(k2).margin(1e-7 * size));
    for (double angle = 0; angle < 3.2; angle += 0.4) {
      const Vector direction = shape->maximum_direction * std::cos(angle) + shape->minimum_direction * std::sin(angle);
      const double euler = k1 * std::cos(angle) * std::cos(angle) + k2 * std::sin(angle) * std::sin(angle);
      CHECK(section_curvature(*shape, direction) == Approx(euler).margin(1e-7 * size));
    }
  }
  CHECK(regular >= 25);
}

TEST_CASE("the second form is the change of the normal along the surface", "[surface_shape]") {
  // Weingarten: n_u.S_u = -L, n_u.S_v = -M, n_v.S_v = -N, with n differentiated numerically.
  for (unsigned seed = 0; seed < 20; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const auto surface = rounded(random_surface(random, 3, 2, 1, true, true));
    const auto& [U, V] = surface.knots;
    const double lu = U.back() - U.front(), lv = V.back() - V.front();
    const double u = U.front() + lu * 0.3, v = V.front() + lv * 0.45, h = 1e-6;
    const auto at = surface_shape(surface, u, v);
    if (!at || at->E * at->G - at->F * at->F < 1) continue;
    const auto n = [&](double x, double y) { return *unit_normal(surface, x, y); };
    const Vector nu = (n(u + h * lu, v) - n(u - h * lu, v)) / (2 * h * lu);
    const Vector nv = (n(u, v + h * lv) - n(u, v - h * lv)) / (2 * h * lv);
    const double size = 1 + std::abs(at->L) + std::abs(at->M) + std::abs(at->N);
    CHECK(glm::dot(nu, at->Su) == Approx(-at->L).margin(1e-4 * size));
    CHECK(glm::dot(nu, at->Sv) == Approx(-at->M).margin(1e-4 * size));
    CHECK(glm::dot(nv, at->Sv) == Approx(-at->N).margin(1e-4 * size));
  }
}

TEST_CASE("where the tangents span no plane, or there is no point, there is no shape", "[surface_shape]") {
  auto folded = bilinear_graph({0, 1}, {0, 1}, [](double, double) { return 0; });
  for (auto& P : folded.points) P.y = P.x;
  CHECK_FALSE(surface_shape(folded, 0.5, 0.5));
  CHECK_FALSE(curvatures_from_inside(folded, 0.5, 0.5));
  auto pole = bilinear_graph({0, 1}, {0, 1}, [](double, double) { return 0; });
  pole.at(0, 0).w = 0;
  CHECK_FALSE(surface_shape(pole, 0, 0));
}

TEST_CASE("towards the apex of a cone the curvature grows: it has no limit there", "[surface_shape]") {
  const auto cone = revolved(polynomial_curve({{0, 1}, {0, 2}}, 0, 1));
  CHECK_FALSE(surface_shape(cone, 0.3, 0));
  CHECK_FALSE(curvatures_from_inside(cone, 0.3, 0));
  CurvatureGrid made;
  evaluate_curvatures(cone, std::vector<double>{0, 0.3, 1}, std::vector<double>{0, 0.5, 1}, made);
  CHECK(made.singular == std::vector{0, 3, 6});
  CHECK(made.maximum[0] == 0);
  CHECK(made.minimum[1] < 0);
}

TEST_CASE("a grid has the points, normals and curvatures of single evaluation", "[surface_shape]") {
  CurvatureGrid made;
  SurfaceGrid plain;
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 5), q = random_int(random, 1, 5);
    const auto surface = rounded(random_surface(random, p, q, 3, seed % 2 == 0, seed % 3 == 0));
    std::vector<double> u, v;
    span_parameters(surface.knots[0], p, 3, u);
    span_parameters(surface.knots[1], q, 2, v);
    evaluate_curvatures(surface, u, v, made);
    evaluate_grid(surface, u, v, true, plain);
    REQUIRE(made.gaussian.size() == u.size() * v.size());
    CHECK(made.grid.undefined == plain.undefined);
    std::size_t singular = 0;
    for (int a = 0; a < plain.rows; ++a) {
      for (int b = 0; b < plain.columns; ++b) {
        const int vertex = a * plain.columns + b;
        INFO("vertex " << vertex);
        CHECK(distance(made.grid.points[vertex], plain.points[vertex]) < 1e-12);
        CHECK(distance(made.grid.normals[vertex], plain.normals[vertex]) < 1e-9);
        const auto shape = surface_shape(surface, u[a], v[b]);
        auto expected = shape ? std::optional(shape->curvatures) : curvatures_from_inside(surface, u[a], v[b]);
        if (!expected) {
          REQUIRE(singular < made.singular.size());
          CHECK(made.singular[singular++] == vertex);
          expected = Curvatures{};
        }
        const double size = 1 + std::abs(expected->maximum) + std::abs(expected->minimum);
        CHECK(made.gaussian[vertex] == Approx(expected->gaussian).margin(1e-8 * size * size));
        CHECK(made.mean[vertex] == Approx(expected->mean).margin(1e-8 * size));
        CHECK(made.maximum[vertex] == Approx(expected->maximum).margin(1e-8 * size));
        CHECK(made.minimum[vertex] == Approx(expected->minimum).margin(1e-8 * size));
      }
    }
    CHECK(singular == made.singular.size());
  }
}

TEST_CASE("the map of a sphere has no holes at its poles, that of a plane no noise", "[surface_shape]") {
  CurvatureGrid made;
  std::vector<double> ends{0, 0.125, 0.25, 0.5, 0.6, 1};
  evaluate_curvatures(sphere(0.5), ends, ends, made);
  CHECK(made.singular.empty());
  for (const double K : made.gaussian) CHECK(K == Approx(4).epsilon(1e-4));
  for (const double H : made.mean) CHECK(H == Approx(-2).epsilon(1e-4));
  evaluate_curvatures(bilinear_graph({0, 1}, {0, 1}, [](double x, double y) { return 0.1 + 0.7 * x - 0.3 * y; }), ends,
                      ends, made);
  CHECK(made.gaussian == std::vector(36, 0.0));
  CHECK(made.mean == std::vector(36, 0.0));
}

}  // namespace
}  // namespace blossom
