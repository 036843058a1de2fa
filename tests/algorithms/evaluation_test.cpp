// de Casteljau's and de Boor's algorithm where things go wrong: ends, knots of every multiplicity, unclamped ends, all
// degrees, single segments, coincident points, weights of zero. Held against basis functions and the blossom.

#include "algorithms/curves.hpp"
#include "kernel/blossom.hpp"
#include "kernel/de_boor.hpp"
#include "kernel/de_casteljau.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

template <Scalar S>
void check_point(const Curve<Exact>& exact_curve, const Exact& exact_u) {
  const auto curve = convert<S>(exact_curve);
  const S u = from_exact<S>(exact_u);
  INFO("u = " << exact_u.to_string() << " on " << write_curve(exact_curve));
  const double scale = largest_coordinate(exact_curve);
  const auto C = both_ways<S>([&](auto& rec) { return de_boor(curve, u, rec); });
  const auto right = point(curve, u);
  REQUIRE(right);
  CHECK(near(Point<S>(C.x, C.y, C.z), *right, scale));

  const int k = find_span<S>(curve.knots, curve.degree, u);
  const auto f = blossom::blossom<S>(curve, k, std::vector<S>(static_cast<std::size_t>(curve.degree), u));
  CHECK(near(Point<S>(C.x, C.y, C.z), Point<S>(f.x / f.w, f.y / f.w, f.z / f.w), scale));

  if (exact_curve.knots == bezier_knots<Exact>(curve.degree)) {
    const auto B = both_ways<S>([&](auto& rec) { return de_casteljau(curve, u, rec); });
    CHECK(near(Point<S>(B.x, B.y, B.z), *right, scale));
  }
}

void check_both(const Curve<Exact>& curve, const Exact& u) {
  check_point<Exact>(curve, u);
  check_point<double>(curve, u);
}

void check_at_its_knots(const Curve<Exact>& curve) {
  for (std::size_t i = 0; i < curve.knots.size(); ++i) {
    const Exact& u = curve.knots[i];
    if (u < curve.domain_begin() || curve.domain_end() < u) continue;
    check_both(curve, u);
    if (i + 1 < curve.knots.size() && u < curve.domain_end()) check_both(curve, (u + curve.knots[i + 1]) / Exact(2));
  }
}

// A quadratic whose denominator is 0 at u = 1/2: (1-u)^2 - 2 u (1-u) + u^2.
template <Scalar S>
Curve<S> with_pole() {
  Curve<S> curve;
  curve.degree = 2;
  curve.rational = true;
  curve.knots = bezier_knots<S>(2);
  curve.points = {{S(0), S(0), S(0), S(1)}, {S(-1), S(-2), S(0), S(-1)}, {S(2), S(0), S(0), S(1)}};
  return curve;
}

template <class Evaluate>
std::string message_of(Evaluate&& evaluate) {
  try {
    evaluate();
  } catch (const KernelError& error) {
    return error.input + ": " + error.message;
  }
  return "";
}

}  // namespace

TEST_CASE("de Boor's algorithm at every knot and between, whatever the multiplicity", "[evaluation]") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937 random(seed);
    for (int p = 1; p <= 5; ++p) {
      for (int multiplicity = 1; multiplicity <= p + 1; ++multiplicity) {
        INFO("seed " << seed << ", p = " << p << ", multiplicity up to " << multiplicity);
        check_at_its_knots(random_curve(random, p, 3, multiplicity, true, seed % 2 == 0));
        check_at_its_knots(random_curve(random, p, 3, multiplicity, false, seed % 2 == 0));
      }
    }
  }
}

TEST_CASE("an inner knot of every multiplicity from 1 to p + 1, evaluated at it", "[evaluation]") {
  for (int p = 1; p <= 6; ++p) {
    for (int s = 1; s <= p + 1; ++s) {
      INFO("p = " << p << ", s = " << s);
      std::mt19937 random(static_cast<unsigned>(100 * p + s));
      Curve<Exact> curve;
      curve.degree = p;
      curve.dimension = 3;
      curve.knots.assign(static_cast<std::size_t>(p) + 1, Exact(0));
      curve.knots.insert(curve.knots.end(), static_cast<std::size_t>(s), Exact::ratio(2, 5));
      curve.knots.insert(curve.knots.end(), static_cast<std::size_t>(p) + 1, Exact(1));
      for (int i = 0; i <= p + s; ++i) curve.points.push_back(random_point(random, false));
      check_both(curve, Exact::ratio(2, 5));
      check_both(curve, Exact(0));
      check_both(curve, Exact(1));
    }
  }
}

TEST_CASE("every degree from 1 to 25", "[evaluation]") {
  for (int p = 1; p <= max_degree; ++p) {
    INFO("p = " << p);
    std::mt19937 random(static_cast<unsigned>(p));
    auto curve = random_curve(random, p, 1, 1, true, p % 2 == 0);
    curve.knots = bezier_knots<Exact>(p);
    for (const char* u : {"0", "1", "1/3", "7/8"}) check_both(curve, q(u));
    const auto spline = random_curve(random, p, 2, 1, p % 3 != 0, p % 2 == 1);
    check_both(spline, spline.domain_begin());
    check_both(spline, spline.domain_end());
    check_both(spline, random_parameter(random, spline.knots, p));
  }
}

TEST_CASE("points that all coincide give that point", "[evaluation]") {
  for (const bool clamped : {true, false}) {
    std::mt19937 random(7);
    auto curve = random_curve(random, 3, 3, 2, clamped, false);
    for (auto& P : curve.points) P = curve.points.front();
    check_at_its_knots(curve);
    NoRecorder<Exact> none;
    CHECK(de_boor(curve, random_parameter(random, curve.knots, 3), none) == curve.points.front());
  }
}

TEST_CASE("weights of zero inside take their points out of the curve", "[evaluation]") {
  // The half circle with a point at infinity between its ends: (1-u)^2 (1,0) + 2u(1-u) (0,1; 0) + u^2 (-1,0).
  Curve<Exact> half;
  half.degree = 2;
  half.rational = true;
  half.knots = bezier_knots<Exact>(2);
  half.points = {{1, 0, 0, 1}, {0, 1, 0, 0}, {-1, 0, 0, 1}};
  for (int i = 0; i <= 8; ++i) {
    const Exact u = Exact::ratio(i, 8);
    check_both(half, u);
    NoRecorder<Exact> none;
    const auto C = de_casteljau(half, u, none);
    CHECK(C.x * C.x + C.y * C.y == Exact(1));
  }
  std::mt19937 random(3);
  auto spline = random_curve(random, 3, 4, 1, true, true);
  spline.points[2] = spline.points[4] = HPoint<Exact>(0, 0, 0, 0);
  check_at_its_knots(spline);
}

TEMPLATE_TEST_CASE("a denominator of zero is told, never computed with", "[evaluation]", double, Exact) {
  using S = TestType;
  const auto curve = with_pole<S>();
  const S half = S(1) / S(2);
  TraceRecorder<S> recorder;
  NoRecorder<S> none;
  const std::string expected = "u: the weight of the point at this parameter is 0: it lies at infinity";
  CHECK(message_of([&] { de_boor(curve, half, recorder); }) == expected);
  CHECK(message_of([&] { de_boor(curve, half, none); }) == expected);
  recorder.clear();
  CHECK(message_of([&] { de_casteljau(curve, half, recorder); }) == expected);
  CHECK(message_of([&] { de_casteljau(curve, half, none); }) == expected);
}

TEST_CASE("parameters outside of the domain, and curves of the wrong kind, are refused", "[evaluation]") {
  const auto message = [](const char* id, const std::string& text) {
    return to_string(inputs_of(*find_algorithm(id), text).diagnostics);
  };
  const std::string bezier = R"({"degree": 2, "points": [[0,0],[1,1],[2,0]]})";
  const std::string unclamped = R"({"degree": 2, "knots": [0,1,2,3,4,5,6], "points": [[0,0],[1,1],[2,0],[3,3]]})";
  CHECK(message("de_casteljau", R"({"curve": )" + bezier + R"(, "u": "9/8"})")
            .find("must lie in the domain [0, 1], not at 9/8") != std::string::npos);
  CHECK(message("de_casteljau", R"({"curve": )" + unclamped + R"(, "u": 0})").find("curve: must be a B") !=
        std::string::npos);
  CHECK(message("de_boor", R"({"curve": )" + unclamped + R"(, "u": 1})")
            .find("must lie in the domain [2, 4], not at 1") != std::string::npos);
  CHECK(message("de_boor", R"({"curve": )" + unclamped + R"(, "u": 2})").empty());
}
