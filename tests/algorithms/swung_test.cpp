// Swung surfaces and translational sweeps: products and sums of two curves, exactly.

#include "algorithms/construction.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Curve<Exact> draw(std::mt19937& random) {
  const int p = random_int(random, 1, 3);
  return random_curve(random, p, random_int(random, 1, 3), p, random_int(random, 0, 2) > 0, random_int(random, 0, 1));
}

Inputs<Exact> along(const Curve<Exact>& profile, const Curve<Exact>& trajectory) {
  Inputs<Exact> inputs;
  inputs.values.emplace("profile", profile);
  inputs.values.emplace("trajectory", trajectory);
  return inputs;
}

// A quarter of the unit circle, exact with rational weights.
const char* quarter = R"({"degree": 2, "points": [[1, 0], [1, 1], [0, 1]], "weights": [1, 1, 2]})";

}  // namespace

TEST_CASE("a swung surface is (a Px Tx, a Px Ty, Pz) everywhere", "[swung]") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    auto profile = draw(random), trajectory = draw(random);
    for (auto& P : profile.points) P.y = Exact(0);
    for (auto& T : trajectory.points) T.z = Exact(0);
    auto inputs = along(profile, trajectory);
    const Exact a = random_ratio(random, 1, 4, 3);
    inputs.values.emplace("scale", a);
    INFO("seed " << seed << ", a = " << a.to_string() << "\n"
                 << write_curve(profile) << "\n"
                 << write_curve(trajectory));
    const auto surface = construct("swung", inputs);
    for (int i = 0; i < 12; ++i) {
      const Exact u = random_u(random, surface), v = random_v(random, surface);
      const auto P = *point(profile, u), T = *point(trajectory, v);
      CHECK(*point(surface, u, v) == Point<Exact>(a * P.x * T.x, a * P.x * T.y, P.z));
    }
  }
}

TEST_CASE("swung along a unit circle, a profile makes a surface of revolution", "[swung]") {
  const auto surface =
      surface_from("swung", std::string(R"({"profile": {"degree": 3, "points": [[1, 0], [4, 1], [-1, 2], [2, 5]]},
                                            "trajectory": )") +
                                quarter + "}");
  const auto turned = surface_from(
      "revolution", R"({"profile": {"degree": 3, "points": [[1, 0], [4, 1], [-1, 2], [2, 5]]}, "angle": 90})");
  std::mt19937 random(2);
  for (int i = 0; i < 40; ++i) {
    const Exact u = random_u(random, surface), v = random_v(random, surface);
    const auto P = *point(surface, u, v), begin = *point(surface, u, 0);
    CHECK(P.x * P.x + P.y * P.y == begin.x * begin.x);
    CHECK(P.z == begin.z);
    // Both end a quarter turn further, in the same copy of the profile.
    const auto A = *point(surface, u, 1), B = *point(turned, 1, u);
    CHECK(A == B);
  }
}

TEST_CASE("profiles and trajectories outside of their planes, and a scale of 0, are told", "[swung]") {
  const auto with = [](const char* text) { return refusal("swung", text); };
  CHECK(
      with(
          R"({"profile": {"degree": 1, "points": [[1, 0], [1, 2]]}, "trajectory": {"degree": 1, "points": [[1, 0], [0, 1]]}})")
          .empty());
  const auto message = with(R"({"profile": {"degree": 1, "points": [[1, 0, 0], [1, 2, 3]]},
      "trajectory": {"degree": 1, "points": [[1, 0, 5], [0, 1, 0]]}, "scale": 0})");
  CHECK(message.find("profile: must lie in the xz-plane, but y is not 0 at its control point 1") != std::string::npos);
  CHECK(message.find("trajectory: must lie in the xy-plane, but z is not 0 at its control point 0") !=
        std::string::npos);
  CHECK(message.find("scale: must not be 0") != std::string::npos);
}

TEST_CASE("a translational sweep is T(v) + P(u) everywhere", "[translational_sweep]") {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    std::mt19937 random(seed);
    const auto profile = draw(random), trajectory = draw(random);
    INFO("seed " << seed << "\n" << write_curve(profile) << "\n" << write_curve(trajectory));
    const auto surface = construct("translational_sweep", along(profile, trajectory));
    for (int i = 0; i < 12; ++i) {
      const Exact u = random_u(random, surface), v = random_v(random, surface);
      CHECK(*point(surface, u, v) == *point(trajectory, v) + *point(profile, u));
    }
  }
}

TEST_CASE("a plane profile stands upright on its way along a plane trajectory", "[translational_sweep]") {
  const auto surface =
      surface_from("translational_sweep", std::string(R"({"trajectory": )") + quarter +
                                              R"(, "profile": {"degree": 1, "points": [[1, 2], [3, 5]]}})");
  CHECK(*point(surface, 0, 0) == Point<Exact>(2, 0, 2));
  CHECK(*point(surface, 1, 1) == Point<Exact>(3, 1, 5));
}
