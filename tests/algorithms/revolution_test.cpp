// Surfaces of revolution: constant distance from the axis and constant height along each circle.

#include "algorithms/construction.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Inputs<Exact> turned(const Curve<Exact>& profile, const Point<Exact>& A, const Point<Exact>& B, const Exact& angle) {
  Inputs<Exact> inputs;
  inputs.values.emplace("profile", profile);
  inputs.values.emplace("axis", PointRow<Exact>{{HPoint<Exact>(A, 1), HPoint<Exact>(B, 1)}, 3});
  inputs.values.emplace("angle", angle);
  return inputs;
}

Point<Exact> any_place(std::mt19937& random) {
  const auto coordinate = [&] { return Exact(random_int(random, -4, 4)); };
  return {coordinate(), coordinate(), coordinate()};
}

bool close(const Exact& a, const Exact& b) {
  return std::abs((a - b).to_double()) < 1e-10 * (1 + std::abs(b.to_double()));
}

// A half circle of radius r about (r + 2, 0) in the plane, through (2, 0) and (2r + 2, 0), exactly: degree 2.
const char* ring = R"({"degree": 2, "knots": [0, 0, 0, "1/2", "1/2", 1, 1, 1],
  "points": [[4, 0], [4, 1], [3, 1], [2, 1], [2, 0]], "weights": [2, 1, 1, 1, 2]})";

}  // namespace

TEST_CASE("each point of the profile keeps its height along the axis and its distance from it", "[revolution]") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 3);
    const auto profile = random_curve(random, p, random_int(random, 1, 3), p, random_int(random, 0, 2) > 0, seed % 2);
    const auto A = any_place(random);
    auto B = any_place(random);
    if (A == B) B.x += Exact(1);
    const Exact angle = random_ratio(random, 1, 360, 1);
    INFO("seed " << seed << ", " << angle.to_string() << " degrees\n" << write_curve(profile));
    const auto surface = construct("revolution", turned(profile, A, B, angle));
    const auto D = B - A;
    for (int i = 0; i < 12; ++i) {
      const Exact u = random_u(random, surface), v = random_v(random, surface);
      const auto P = *point(profile, v), Q = *point(surface, u, v);
      CHECK(close(dot(Q - A, D), dot(P - A, D)));
      CHECK(close(dot(cross(Q - A, D), cross(Q - A, D)), dot(cross(P - A, D), cross(P - A, D))));
      const auto begin = *point(surface, 0, v);  // at the profile
      for (int c = 0; c < 3; ++c) CHECK(close(begin[c], P[c]));
    }
  }
}

TEST_CASE("the ends of the arcs are exact where their angles have rational cosines and sines", "[revolution]") {
  std::mt19937 random(11);
  for (const int angle : {90, 180, 270, 360}) {
    const auto profile = random_curve(random, 2, 2, 2, true, true);
    const auto surface = construct("revolution", turned(profile, {0, 0, 0}, {0, 0, 3}, angle));
    const int arcs = angle / 90;
    CHECK(surface.rows == 2 * arcs + 1);
    CHECK(surface.degree[0] == 2);
    for (int k = 0; k <= arcs; ++k) {
      for (int j = 0; j < surface.columns; ++j) {
        auto expected = profile.points[static_cast<std::size_t>(j)];
        for (int turn = 0; turn < k; ++turn) expected = {-expected.y, expected.x, expected.z, expected.w};
        CHECK(surface.at(2 * k, j) == expected);
        CHECK(!surface.at(2 * k, j).x.is_approximate());
      }
    }
  }
}

TEST_CASE("the angle turned is the angle asked for, in up to four arcs of at most 90 degrees", "[revolution]") {
  for (const auto& [angle, arcs] :
       {std::pair{1, 1}, {90, 1}, {91, 2}, {180, 2}, {200, 3}, {270, 3}, {271, 4}, {360, 4}}) {
    const auto profile =
        R"({"profile": {"degree": 1, "points": [[2, 0], [2, 3]]}, "angle": )" + std::to_string(angle) + "}";
    const auto surface = surface_from("revolution", profile);
    INFO(angle);
    CHECK(surface.rows == 2 * arcs + 1);
    const auto end = *point(surface, 1, 0);
    const double t = angle * 3.14159265358979323846 / 180;
    CHECK(std::abs(end.x.to_double() - 2 * std::cos(t)) < 1e-12);
    CHECK(std::abs(end.y.to_double() - 2 * std::sin(t)) < 1e-12);
    // Counterclockwise all the way: the middle is at half the angle.
    const auto middle = *point(surface, Exact::ratio(1, 2), Exact::ratio(1, 2));
    CHECK(std::abs(middle.x.to_double() - 2 * std::cos(t / 2)) < 1e-12);
    CHECK(std::abs(middle.y.to_double() - 2 * std::sin(t / 2)) < 1e-12);
  }
}

TEST_CASE("a circle of degree 2 makes a torus of degree (2, 2)", "[revolution]") {
  const auto surface = surface_from("revolution", std::string(R"({"profile": )") + ring + "}");
  CHECK(surface.degree == std::array{2, 2});
  std::mt19937 random(5);
  for (int i = 0; i < 40; ++i) {
    const auto P = *point(surface, random_u(random, surface), random_v(random, surface));
    // (x^2 + y^2 + z^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + y^2) with R = 3, r = 1
    const Exact around = P.x * P.x + P.y * P.y, all = around + P.z * P.z + Exact(8);
    CHECK(close(all * all, Exact(36) * around));
  }
}

TEST_CASE("points on the axis become poles", "[revolution]") {
  const auto surface = surface_from("revolution", R"({"profile": {"degree": 2, "points": [[0, -1], [2, 0], [0, 1]]}})");
  for (int i = 0; i < surface.rows; ++i) {
    CHECK(*affine_point(surface.at(i, 0)) == Point<Exact>(0, 0, -1));
    CHECK(*affine_point(surface.at(i, 2)) == Point<Exact>(0, 0, 1));
  }
}

TEST_CASE("an axis given in the plane stands upright like the profile", "[revolution]") {
  const auto upright =
      surface_from("revolution",
                   R"({"profile": {"degree": 1, "points": [[3, 0], [4, 2]]}, "axis": [[1, 0], [1, 5]], "angle": 180})");
  CHECK(*point(upright, 1, 0) == Point<Exact>(-1, 0, 0));
  CHECK(*point(upright, 1, 1) == Point<Exact>(-2, 0, 2));
}

TEST_CASE("an angle out of range and an axis of one point are told", "[revolution]") {
  const auto with = [](const char* more) {
    return refusal("revolution",
                   std::string(R"({"profile": {"degree": 1, "points": [[3, 0], [4, 2]]}, )") + more + "}");
  };
  CHECK(with(R"("angle": 360)").empty());
  CHECK(with(R"("angle": 0)").find("angle: must be above 0 and at most 360 degrees, not 0") != std::string::npos);
  CHECK(with(R"("angle": 361)").find("not 361") != std::string::npos);
  CHECK(with(R"("axis": [[1, 2, 3], [1, 2, 3]])").find("axis: needs two points that differ") != std::string::npos);
  CHECK(with(R"("axis": [[1, 2, 3]])").find("axis") != std::string::npos);
}
