// The blossom of a piece against what defines it: symmetric, affine in each argument, and the curve on the diagonal.

#include "kernel/polar_form.hpp"
#include "algorithms/pieces.hpp"
#include "kernel/blossom.hpp"
#include "kernel/de_boor.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

HPoint<Exact> value(const Curve<Exact>& curve, const std::vector<Exact>& arguments, int span) {
  return both_ways<Exact>([&](auto& rec) { return polar_form(curve, arguments, span, rec); });
}

int any_span(std::mt19937& random, const Curve<Exact>& curve) {
  for (;;) {
    const int k = random_int(random, curve.degree, curve.n());
    if (curve.knots[static_cast<std::size_t>(k)] < curve.knots[static_cast<std::size_t>(k) + 1]) return k;
  }
}

// Inside and outside of the domain, and knots.
std::vector<Exact> any_arguments(std::mt19937& random, const Curve<Exact>& curve) {
  std::vector<Exact> arguments;
  for (int r = 0; r < curve.degree; ++r)
    arguments.push_back(random_int(random, 0, 2) == 0 ? random_ratio(random, -5, 9, 3) : any_parameter(random, curve));
  return arguments;
}

Curve<Exact> polynomial(std::mt19937& random) {
  const int p = random_int(random, 1, 5);
  return random_curve(random, p, random_int(random, 1, 4), p, random_int(random, 0, 1) == 1, false);
}

}  // namespace

TEST_CASE("the order of the arguments does not matter", "[polar_form]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const auto curve = polynomial(random);
    const int span = seed % 3 == 0 ? 0 : any_span(random, curve);
    auto arguments = any_arguments(random, curve);
    INFO("seed " << seed << ", span " << span << "\n" << write_curve(curve));
    const auto right = value(curve, arguments, span);
    for (int shuffle = 0; shuffle < 5; ++shuffle) {
      std::shuffle(arguments.begin(), arguments.end(), random);
      CHECK(value(curve, arguments, span) == right);
    }
  }
}

TEST_CASE("in each argument the blossom is affine", "[polar_form]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const auto curve = polynomial(random);
    const int span = any_span(random, curve);
    const auto arguments = any_arguments(random, curve);
    const auto place = static_cast<std::size_t>(random_int(random, 0, curve.degree - 1));
    const auto at = [&](const Exact& t) {
      auto changed = arguments;
      changed[place] = t;
      return value(curve, changed, span);
    };
    const Exact a = random_ratio(random, -3, 3, 2), b = random_ratio(random, 4, 6, 2),
                s = random_ratio(random, -1, 2, 5);
    INFO("seed " << seed << "\n" << write_curve(curve));
    CHECK(at((Exact(1) - s) * a + s * b) == (Exact(1) - s) * at(a) + s * at(b));
  }
}

TEST_CASE("with all arguments equal to u it is the point that de Boor's algorithm finds", "[polar_form]") {
  for_random_curves(60, [](const Curve<Exact>& curve, std::mt19937& random) {
    for (int draw = 0; draw < 4; ++draw) {
      const Exact u = any_parameter(random, curve);
      INFO("u = " << u.to_string());
      NoRecorder<Exact> plain;
      const std::vector<Exact> diagonal(static_cast<std::size_t>(curve.degree), u);
      std::optional<HPoint<Exact>> point;
      try {
        point = de_boor(curve, u, plain);
      } catch (const KernelError&) {
        CHECK_THROWS_AS(value(curve, diagonal, 0), KernelError);
      }
      if (point) CHECK(value(curve, diagonal, 0) == *point);
    }
  });
}

TEST_CASE("at consecutive knots it is a control point", "[polar_form]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const auto curve = polynomial(random);
    INFO("seed " << seed << "\n" << write_curve(curve));
    for (int i = 0; i <= curve.n(); ++i) {
      const auto first = curve.knots.begin() + i + 1;
      const std::vector<Exact> knots(first, first + curve.degree);
      for (int k = std::max(i, curve.degree); k <= std::min(i + curve.degree, curve.n()); ++k)
        if (curve.knots[static_cast<std::size_t>(k)] < curve.knots[static_cast<std::size_t>(k) + 1])
          CHECK(value(curve, knots, k) == curve.points[static_cast<std::size_t>(i)]);
      CHECK(value(curve, knots, 0) == curve.points[static_cast<std::size_t>(i)]);
    }
  }
}

TEST_CASE("every point of the triangle is the blossom of its label", "[polar_form]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const auto curve = polynomial(random);
    const int span = any_span(random, curve);
    INFO("seed " << seed << ", span " << span << "\n" << write_curve(curve));
    TraceRecorder<Exact> recorder;
    polar_form(curve, any_arguments(random, curve), span, recorder);
    const auto trace = std::move(recorder).take();
    const auto labels = trace.polar_labels();
    for (ValueId v = 0; v < trace.value_count(); ++v) {
      if (trace.value(v).kind != ValueKind::point || trace.is_input(v)) continue;
      INFO(trace.name(v) << " = " << to_string(labels[v]));
      const auto P = trace.numbers(v);
      CHECK(blossom::blossom<Exact>(curve, span, labels[v].u) == HPoint<Exact>(P[0], P[1], P[2], P[3]));
    }
  }
}

TEST_CASE("by hand: a parabola", "[polar_form]") {
  // C(u) = (u, u^2): b(s, t) = ((s + t)/2, s t).
  Curve<Exact> parabola{2, bezier_knots<Exact>(2), {{0, 0, 0, 1}, {Exact::ratio(1, 2), 0, 0, 1}, {1, 1, 0, 1}}};
  CHECK(value(parabola, {Exact::ratio(1, 4), Exact::ratio(1, 2)}, 0) ==
        HPoint<Exact>(Exact::ratio(3, 8), Exact::ratio(1, 8), 0, 1));
  CHECK(value(parabola, {Exact(3), Exact(-1)}, 0) == HPoint<Exact>(1, -3, 0, 1));
}

TEST_CASE("as many arguments as the degree are asked for, and a piece that exists", "[polar_form]") {
  const auto mistakes = [](const std::string& more) {
    const auto document = JsonDocument::parse("inputs", R"({"curve": {"degree": 2, "knots": [0, 0, 0, 1, 1, 2, 2, 2],
          "points": [[0, 0], [1, 2], [3, 2], [4, 0], [5, 1]]}, )" +
                                                            more + "}");
    REQUIRE(document);
    Diagnostics found;
    CHECK(!read_inputs(*find_algorithm("polar_form"), Cursor(*document, found)));
    return to_string(found);
  };
  CHECK(mistakes(R"("arguments": [1])").find("as many arguments as the degree of the curve, 2, not 1") !=
        std::string::npos);
  CHECK(mistakes(R"("arguments": [1, 1], "span": 3)").find("empty span: u_3 and u_4 are both 1") != std::string::npos);
  CHECK(mistakes(R"("arguments": [1, 1], "span": 5)").find("2 to 4, not 5") != std::string::npos);
}
