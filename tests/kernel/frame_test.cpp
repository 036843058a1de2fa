#include "kernel/frame.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "kernel/tessellate.hpp"
#include "shapes.hpp"
#include "splines.hpp"

namespace blossom {
namespace {

using namespace test;
using Vector = Point<double>;

std::vector<double> evenly(double begin, double end, int steps) {
  std::vector<double> result;
  for (int i = 0; i <= steps; ++i) result.push_back(i == steps ? end : begin + (end - begin) * i / steps);
  return result;
}

void check_orthonormal(const Vector& T, const Vector& N, const Vector& B) {
  CHECK(glm::length(T) == Approx(1));
  CHECK(glm::length(N) == Approx(1));
  CHECK(std::abs(glm::dot(T, N)) < 1e-12);
  CHECK(distance(B, Vector(glm::cross(T, N))) < 1e-12);
}

TEST_CASE("a rational circle has one curvature, and its own centre", "[frame]") {
  const auto circle = full_circle(2.5, 3, -1);
  for (const double u : evenly(0, 1, 37)) {
    INFO("u = " << u);
    const auto at = frame(circle, u);
    REQUIRE(at);
    CHECK(*at->curvature == Approx(0.4));
    CHECK(*at->signed_curvature == Approx(0.4));
    CHECK(*at->torsion == 0);
    CHECK(distance(*at->binormal, Vector(0, 0, 1)) < 1e-12);
    const auto round = osculating_circle(*at);
    REQUIRE(round);
    CHECK(round->radius == Approx(2.5));
    CHECK(distance(round->centre, Vector(3, -1, 0)) < 1e-10);
    const auto ball = osculating_sphere(circle, u);
    REQUIRE(ball);
    CHECK(ball->radius == Approx(2.5));
    CHECK(distance(ball->centre, Vector(3, -1, 0)) < 1e-10);
  }
}

TEST_CASE("a circle run through the other way turns to the right", "[frame]") {
  auto circle = full_circle(1);
  std::reverse(circle.points.begin(), circle.points.end());
  CHECK(*frame(circle, 0.3)->signed_curvature == Approx(-1));
  circle.dimension = 3;
  CHECK_FALSE(frame(circle, 0.3)->signed_curvature);
}

TEST_CASE("the twisted cubic (t, t^2, t^3) has the curvature and torsion of its formulas", "[frame]") {
  const auto cubic = twisted_cubic(-2, 2);
  for (const double t : evenly(-2, 2, 40)) {
    INFO("t = " << t);
    const auto at = frame(cubic, t);
    REQUIRE(at);
    const double speed = std::sqrt(1 + 4 * t * t + 9 * t * t * t * t);
    const double cross = 1 + 9 * t * t + 9 * t * t * t * t;
    CHECK(at->speed == Approx(speed));
    CHECK(*at->curvature == Approx(2 * std::sqrt(cross) / std::pow(speed, 3)));
    CHECK(*at->torsion == Approx(3 / cross));
    CHECK(distance(*at->binormal, Vector(3 * t * t, -3 * t, 1) / std::sqrt(cross)) < 1e-12);
  }
  const auto ball = osculating_sphere(cubic, 0);
  REQUIRE(ball);
  CHECK(distance(ball->centre, Vector(0, 0.5, 0)) < 1e-12);
}

TEST_CASE("a helix has constant curvature and torsion", "[frame]") {
  // Its Taylor polynomials of degree 20 differ from it by less than 1e-19 on [0, 1].
  const double r = 3, c = 4;
  Polynomial x, y;
  double factorial = 1;
  for (int k = 0; k <= 20; ++k) {
    factorial *= std::max(k, 1);
    const double sign = k % 4 < 2 ? 1 : -1;
    x.push_back(k % 2 == 0 ? sign * r / factorial : 0);
    y.push_back(k % 2 == 1 ? sign * r / factorial : 0);
  }
  const auto helix = polynomial_curve({x, y, {0, c}}, 0, 1);
  for (const double t : evenly(0, 1, 10)) {
    INFO("t = " << t);
    const auto at = frame(helix, t);
    REQUIRE(at);
    CHECK(at->speed == Approx(5));
    CHECK(*at->curvature == Approx(r / 25));
    CHECK(*at->torsion == Approx(c / 25));
    CHECK(distance(*at->normal, Vector(-std::cos(t), -std::sin(t), 0)) < 1e-9);
  }
}

TEST_CASE("a curve on a sphere has that sphere as osculating sphere everywhere", "[frame]") {
  // The parabola (t, t^2) by stereographic projection on the unit sphere.
  const auto curve = polynomial_curve({{0, 2}, {0, 0, 2}, {-1, 0, 1, 0, 1}, {1, 0, 1, 0, 1}}, -1, 1.5);
  for (const double t : evenly(-1, 1.5, 20)) {
    INFO("t = " << t);
    const auto ball = osculating_sphere(curve, t);
    const auto at = frame(curve, t);
    if (std::abs(*at->torsion) < 1e-6) continue;
    REQUIRE(ball);
    CHECK(ball->radius == Approx(1).epsilon(1e-7));
    CHECK(distance(ball->centre, Vector(0.0)) < 1e-7);
  }
}

TEST_CASE("a plane curve that is no circle has no osculating sphere", "[frame]") {
  const auto parabola = polynomial_curve({{0, 1}, {0, 0, 1}, {0.5}}, -1, 1);
  CHECK(osculating_circle(*frame(parabola, 0.5)));
  CHECK_FALSE(osculating_sphere(parabola, 0.5));
}

TEST_CASE("a straight line has a tangent, no normal and curvature zero, however it is run through", "[frame]") {
  const Vector from(0.1, -0.7, 3.3), way(1.7, 0.3, -2.9);
  for (const bool rational : {false, true}) {
    Curve<double> line{4, {0, 0, 0, 0, 0, 0.3, 1, 1, 1, 1, 1}, {}, 3, rational, false};
    const double s[] = {0, 0.1, 0.15, 0.6, 0.8, 1}, w[] = {1, 2, 0.7, 1.3, 0.4, 1};
    for (int i = 0; i < 6; ++i) line.points.push_back(HPoint<double>(from + way * s[i], 1) * (rational ? w[i] : 1));
    for (const double u : evenly(0, 1, 13)) {
      INFO("u = " << u << ", rational: " << rational);
      const auto at = frame(line, u);
      REQUIRE(at);
      CHECK(distance(at->tangent, way / glm::length(way)) < 1e-12);
      CHECK_FALSE(at->normal);
      CHECK_FALSE(at->binormal);
      CHECK_FALSE(at->torsion);
      CHECK(at->curvature == 0.0);
      CHECK_FALSE(osculating_circle(*at));
      CHECK_FALSE(osculating_sphere(line, u));
    }
  }
}

TEST_CASE("an inflection has curvature zero and no normal", "[frame]") {
  const auto at = frame(polynomial_curve({{0, 1}, {0, 0, 0, 1}}, -1, 1, 2), 0);
  REQUIRE(at);
  CHECK(at->speed == Approx(1));
  CHECK(*at->curvature == 0);
  CHECK(*at->signed_curvature == 0);
  CHECK_FALSE(at->normal);
}

TEST_CASE("a curve that stays at one point has no frame", "[frame]") {
  CHECK_FALSE(frame(polynomial_curve({{0.1, 0, 0, 0, 0}, {0.7}}, 0, 1), 0.3));
  auto pole = polynomial_curve({{0, 1}, {1}, {0}, {0, 1}}, 0, 1);
  CHECK_FALSE(frame(pole, 0));
}

TEST_CASE("the cusp of (t^2, t^3) has a tangent, a normal and no curvature", "[frame]") {
  const auto at = frame(polynomial_curve({{0, 0, 1}, {0, 0, 0, 1}}, -1, 1, 2), 0);
  REQUIRE(at);
  CHECK(at->speed == 0);
  CHECK(distance(at->tangent, Vector(1, 0, 0)) < 1e-12);
  REQUIRE(at->normal);
  CHECK(distance(*at->normal, Vector(0, 1, 0)) < 1e-12);
  CHECK_FALSE(at->curvature);
  CHECK_FALSE(at->signed_curvature);
  CHECK_FALSE(osculating_circle(*at));
}

TEST_CASE("where the speed is zero, all is the limit of what is beside it", "[frame]") {
  struct Case {
    std::vector<Polynomial> curve;
    std::optional<double> curvature, torsion;
    double beside = 1e-2;
  };
  const auto power = [](int k, double c) {
    Polynomial result(static_cast<std::size_t>(k) + 1, 0.0);
    result.back() = c;
    return result;
  };
  const Case cases[] = {
      {{power(2, 1), power(4, 1), power(6, 1)}, 2, 3},         // the twisted cubic at 0, with t^2 for t
      {{power(2, 3), power(5, 1), power(7, 1)}, 0, {}},        // the curvature vanishes; the torsion is found below
      {{power(3, 1), power(6, 2), power(9, 1)}, 4, 1.5, 0.1},  // (s, 2 s^2, s^3)
      {{power(2, 1), power(3, 1), power(4, 5)}, {}, {}},       // both infinite
      {{power(2, 1), power(3, 1), power(6, 0.05)}, {}, 0},     // flat
  };
  for (std::size_t i = 0; i < std::size(cases); ++i) {
    const auto& [coordinates, curvature, torsion, beside] = cases[i];
    for (const bool from_left : {false, true}) {
      const auto curve = from_left ? polynomial_curve(coordinates, -1, 0) : polynomial_curve(coordinates, 0, 1);
      INFO("case " << i << (from_left ? ", from the left" : ""));
      const auto at = frame(curve, 0);
      const auto near = frame(curve, from_left ? -beside : beside);
      REQUIRE(at);
      REQUIRE(at->normal);
      check_orthonormal(at->tangent, *at->normal, *at->binormal);
      CHECK(distance(at->tangent, near->tangent) < 0.2);
      CHECK(distance(*at->normal, *near->normal) < 0.2);
      CHECK(distance(*at->binormal, *near->binormal) < 0.2);
      CHECK(at->curvature.has_value() == curvature.has_value());
      if (curvature) CHECK(*at->curvature == Approx(*curvature));
      if (curvature) CHECK(*near->curvature == Approx(*curvature).margin(1e-2));
      if (torsion) {
        REQUIRE(at->torsion);
        CHECK(*at->torsion == Approx(*torsion));
        CHECK(*near->torsion == Approx(*torsion).margin(5e-2));
      }
    }
  }
  // a + b = c = 7: a torsion that is neither zero nor infinite.
  const auto curve = polynomial_curve({power(2, 3), power(5, 1), power(7, 1)}, 0, 1);
  CHECK(*frame(curve, 0)->torsion == Approx(*frame(curve, 0.1)->torsion).epsilon(1e-3));
}

TEST_CASE("frames of random curves obey Frenet's formulas", "[frame]") {
  int regular = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 3, 6);
    const auto curve = rounded(random_curve(random, p, 1, 1, seed % 2 == 0, seed % 3 == 0));
    const double length = curve.domain_end() - curve.domain_begin();
    const double u = curve.domain_begin() + length * 0.371, h = 1e-5 * length;
    const auto at = frame(curve, u), before = frame(curve, u - h), after = frame(curve, u + h);
    REQUIRE(at);
    if (!at->normal || at->speed < 0.1 || *at->curvature > 10 || std::abs(*at->torsion) > 10) continue;
    ++regular;
    check_orthonormal(at->tangent, *at->normal, *at->binormal);
    const double s = 2 * h * at->speed;  // dT/ds = curvature N, dB/ds = -torsion N
    CHECK(distance((after->tangent - before->tangent) / s, *at->normal * *at->curvature) < 1e-4);
    CHECK(distance((*after->binormal - *before->binormal) / s, *at->normal * -*at->torsion) < 1e-3);
  }
  CHECK(regular >= 15);
}

TEST_CASE("frames do not depend on the size of the curve, and nothing overflows", "[frame]") {
  const auto cubic = twisted_cubic(-1, 1);
  const auto at = frame(cubic, 0.3);
  for (const double scale : {1e-150, 1e-9, 1e9, 1e150}) {
    INFO("scale " << scale);
    auto scaled = cubic;
    for (auto& P : scaled.points) P = {P.x * scale, P.y * scale, P.z * scale, 1};
    const auto other = frame(scaled, 0.3);
    REQUIRE(other);
    CHECK(distance(*other->normal, *at->normal) < 1e-10);
    CHECK(*other->curvature * scale == Approx(*at->curvature));
    CHECK(*other->torsion * scale == Approx(*at->torsion));
  }
}

TEST_CASE("samples are the frames one by one", "[frame]") {
  const auto cubic = twisted_cubic(0, 1);
  const auto parameters = evenly(0, 1, 8);
  std::vector<std::optional<FrenetFrame>> frames(3);
  sample_frames(cubic, parameters, frames);
  REQUIRE(frames.size() == 9);
  for (std::size_t i = 0; i < 9; ++i) CHECK(*frames[i]->curvature == *frame(cubic, parameters[i])->curvature);
}

double final_angle(const Curve<double>& curve, double begin, double end, int steps) {
  std::vector<std::optional<MovingFrame>> frames;
  rotation_minimising_frames(curve, evenly(begin, end, steps), frames);
  const auto last = frame(curve, end);
  const auto& r = frames.back()->normal;
  return std::atan2(glm::dot(r, *last->binormal), glm::dot(r, *last->normal));
}

TEST_CASE("against Frenet's frame a rotation-minimising one turns back by the integral of the torsion", "[frame]") {
  const auto cubic = twisted_cubic(0, 1.5);
  // The integral of torsion times speed, by Simpson's rule; the frames begin with Frenet's.
  const int n = 2000;
  double integral = 0;
  for (int i = 0; i <= n; ++i) {
    const auto at = frame(cubic, 1.5 * i / n);
    integral += *at->torsion * at->speed * (i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2) * 1.5 / (3 * n);
  }
  const double coarse = std::abs(final_angle(cubic, 0, 1.5, 16) + integral);
  const double fine = std::abs(final_angle(cubic, 0, 1.5, 32) + integral);
  CHECK(coarse < 1e-3);
  CHECK(fine < coarse / 12);  // fourth order: a sixteenth
  CHECK(std::abs(final_angle(cubic, 0, 1.5, 1000) + integral) < 1e-9);
}

TEST_CASE("rotation-minimising frames pass through inflections, straight pieces and cusps", "[frame]") {
  std::vector<std::optional<MovingFrame>> frames;
  SECTION("an inflection: Frenet's normal changes sides, this one does not") {
    const auto curve = polynomial_curve({{0, 1}, {0, 0, 0, 1}, {0}}, -1, 1);
    CHECK(frame(curve, -0.5)->normal->y * frame(curve, 0.5)->normal->y < 0);
    rotation_minimising_frames(curve, evenly(-1, 1, 40), frames);
    for (const auto& at : frames) CHECK(distance(at->binormal, frames.front()->binormal) < 1e-12);
  }
  SECTION("a straight line") {
    rotation_minimising_frames(polynomial_curve({{0, 1}, {0, 2}, {1, -1}}, 0, 1), evenly(0, 1, 10), frames);
    for (const auto& at : frames) CHECK(distance(at->normal, frames.front()->normal) < 1e-12);
  }
  SECTION("a cusp: the tangent turns over, the normal stays") {
    const auto curve = polynomial_curve({{0, 0, 1}, {0, 0, 0, 1}, {0}}, -1, 1);
    rotation_minimising_frames(curve, evenly(-1, 1, 40), frames, Vector(0, 0, 1));
    for (const auto& at : frames) CHECK(distance(at->normal, Vector(0, 0, 1)) < 1e-12);
  }
  SECTION("two parameters with one point") {
    rotation_minimising_frames(full_circle(1), std::vector<double>{0, 0, 1}, frames);
    CHECK(distance(frames[1]->normal, frames[0]->normal) < 1e-12);
    CHECK(distance(frames[2]->normal, frames[0]->normal) < 1e-12);
  }
  SECTION("a parameter without a point is left out") {
    auto curve = rounded(plane_curve(1, {0, 0, 1, 2, 2}, {{0, 0}, {1, 0}, {2, 0}}));
    curve.points[1] = {1, 0, 0, 0};
    rotation_minimising_frames(curve, std::vector<double>{0.5, 1, 1.5}, frames);
    CHECK_FALSE(frames[1]);
    REQUIRE(frames[2]);
    check_orthonormal(frames[2]->tangent, frames[2]->normal, frames[2]->binormal);
  }
}

TEST_CASE("in the plane the normal of the moving frames is on the left", "[frame]") {
  std::vector<std::optional<MovingFrame>> frames;
  rotation_minimising_frames(polynomial_curve({{0, 1}, {0, 0, 0, 1}}, -1, 1, 2), evenly(-1, 1, 30), frames);
  for (const auto& at : frames) CHECK(distance(at->binormal, Vector(0, 0, 1)) < 1e-12);
}

TEST_CASE("moving frames of random curves are orthonormal and begin as told", "[frame]") {
  std::vector<std::optional<MovingFrame>> frames;
  for (unsigned seed = 0; seed < 20; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 5);
    const auto curve = rounded(random_curve(random, p, 3, p, seed % 2 == 0, seed % 3 == 0));
    std::vector<double> parameters;
    span_parameters(curve.knots, p, 20, parameters);
    rotation_minimising_frames(curve, parameters, frames, Vector(0.3, -2, 1));
    REQUIRE(frames.size() == parameters.size());
    CHECK(std::abs(glm::dot(glm::cross(frames[0]->tangent, frames[0]->normal), Vector(0.3, -2, 1))) < 1e-12);
    for (const auto& at : frames) check_orthonormal(at->tangent, at->normal, at->binormal);
  }
}

}  // namespace
}  // namespace blossom
