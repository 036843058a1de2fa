#include "kernel/blossom.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "kernel/evaluate.hpp"
#include "splines.hpp"

namespace blossom {
namespace {

using namespace test;

TEST_CASE("blossom of a cubic monomial is the elementary symmetric mean", "[blossom]") {
  // x = u^3 on [0, 1] has the Bezier coefficients 0, 0, 0, 1, and its polar form is the product of the arguments.
  const auto curve = plane_curve(3, bezier_knots<Exact>(3), {{0, 0}, {0, 0}, {0, 0}, {1, 0}});
  const std::vector<Exact> arguments{q("1/2"), q("-3"), q("5/7")};
  CHECK(blossom::blossom<Exact>(curve, 3, arguments).x == q("-15/14"));
}

TEST_CASE("blossom is symmetric, multi-affine, the curve on its diagonal, and has the control points as values",
          "[blossom]") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 6);
    const auto curve = random_curve(random, p, 4, p + 1, seed % 2 == 0, seed % 3 == 0);
    const auto& U = curve.knots;
    const Exact u = random_parameter(random, U, p);
    const int k = find_span<Exact>(U, p, u);
    const auto f = [&](const std::vector<Exact>& arguments) { return blossom::blossom<Exact>(curve, k, arguments); };

    CHECK(f(std::vector<Exact>(static_cast<std::size_t>(p), u)) == homogeneous_point(curve, u));

    for (int i = k - p; i <= k; ++i) {
      CHECK(f(std::vector<Exact>(U.begin() + i + 1, U.begin() + i + p + 1)) == curve.points[i]);
    }

    std::vector<Exact> arguments;
    for (int r = 0; r < p; ++r) arguments.push_back(random_ratio(random, -3, 3, 5));
    auto shuffled = arguments;
    std::shuffle(shuffled.begin(), shuffled.end(), random);
    CHECK(f(shuffled) == f(arguments));

    auto at_a = arguments, at_b = arguments, between = arguments;
    const auto slot = static_cast<std::size_t>(random_int(random, 0, p - 1));
    const Exact a = random_ratio(random, -3, 3, 2), b = random_ratio(random, -3, 3, 2), t = q("2/7");
    at_a[slot] = a, at_b[slot] = b, between[slot] = (1 - t) * a + t * b;
    CHECK(f(between) == f(at_a) * (1 - t) + f(at_b) * t);
  }
}

TEST_CASE("blossom in double agrees with the exact one", "[blossom]") {
  for (unsigned seed = 0; seed < 20; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 5);
    const auto curve = random_curve(random, p, 3, p, true, true);
    std::vector<Exact> arguments;
    for (int r = 0; r < p; ++r) arguments.push_back(random_parameter(random, curve.knots, p));
    const int k = find_span<Exact>(curve.knots, p, arguments[0]);
    const auto exact = rounded(blossom::blossom<Exact>(curve, k, arguments));
    CHECK(distance(blossom::blossom<double>(rounded(curve), k, rounded(arguments)), exact) < 1e-9);
  }
}

}  // namespace
}  // namespace blossom
