// The shares of control points in a point of a surface.

#include "kernel/surface_basis.hpp"

#include "algorithms/surfaces.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Exact sum_of(const Trace<Exact>& trace, std::string_view symbol) {
  Exact sum(0);
  for (ValueId x = 0; x < trace.value_count(); ++x)
    if (trace.value(x).name.symbol == Symbol::of(symbol) && trace.value(x).name.arity == 2) sum += trace.numbers(x)[0];
  return sum;
}

}  // namespace

TEST_CASE("the shares are positive, add up to 1, and make the point", "[surface_basis]") {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const auto surface = any_surface(random);
    const Exact u = test::any_parameter(random, surface, 0), v = test::any_parameter(random, surface, 1);
    INFO("seed " << seed << "\n" << write_surface(surface) << " at " << u.to_string() << ", " << v.to_string());
    const auto S = both_ways<Exact>([&](auto& rec) { return surface_basis(surface, u, v, rec); });
    const auto expected = homogeneous_point(surface, u, v);
    CHECK(S == expected / expected.w);

    TraceRecorder<Exact> recorder;
    surface_basis(surface, u, v, recorder);
    const auto trace = std::move(recorder).take();
    CHECK(sum_of(trace, "B") == Exact(1));
    CHECK(trace.numbers(*trace.find("sum"))[0] == Exact(1));
    CHECK(trace.find("W").has_value() == surface.rational);
    if (surface.rational) {
      CHECK(sum_of(trace, "R") == Exact(1));
      CHECK(trace.numbers(*trace.find("W"))[0] == expected.w);
    }
    for (ValueId x = 0; x < trace.value_count(); ++x)
      if (trace.value(x).rule == &rule_info<tensor::Product>) CHECK(!(trace.numbers(x)[0] < Exact(0)));
    // The share of a point is how far S moves when the point does.
    const int k = find_span<Exact>(surface.knots[0], surface.degree[0], u);
    const int l = find_span<Exact>(surface.knots[1], surface.degree[1], v);
    auto moved = surface;
    auto& P = moved.at(k, l);
    P.z += P.w;
    const auto name = std::string(surface.rational ? "R[" : "B[") + std::to_string(k) + "][" + std::to_string(l) + "]";
    const auto after = homogeneous_point(moved, u, v);
    CHECK(after.z / after.w - S.z == trace.numbers(*trace.find(name))[0]);
  }
}

TEST_CASE("published basis functions, and their product", "[surface_basis]") {
  // NB examples 2.1-2.3: p = 2, U = {0^3, 1, 2, 3, 4, 4, 5^3}, u = 5/2: 1/8, 6/8, 1/8 in the span 4.
  std::string points;
  for (int i = 0; i < 8; ++i) {
    const auto x = std::to_string(i);
    points += (i > 0 ? ", " : "") + ("[[" + x + ", 0, 0], [" + x + ", 1, 0]]");
  }
  const auto run = run_of("surface_basis", R"({"surface": {"degree": [2, 1],
    "knots": [[0,0,0,1,2,3,4,4,5,5,5], [0,0,1,1]], "points": [)" +
                                               points + R"(]}, "u": "5/2", "v": "1/4"})");
  CHECK(number_of(run, "k") == Exact(4));
  CHECK(number_of(run, "N[2]") == Exact::ratio(1, 8));
  CHECK(number_of(run, "N[3]") == Exact::ratio(3, 4));
  CHECK(number_of(run, "N[4]") == Exact::ratio(1, 8));
  CHECK(number_of(run, "M[0]") == Exact::ratio(3, 4));
  CHECK(number_of(run, "B[3][0]") == Exact::ratio(9, 16));
  CHECK(numbers_of(run, "S") == std::vector<Exact>{3, q("1/4"), 0, 1});
}

TEST_CASE("where all weights that count are zero there is no point", "[surface_basis]") {
  NoRecorder<Exact> none;
  Surface<Exact> surface{{1, 1}, {bezier_knots<Exact>(1), bezier_knots<Exact>(1)},           2,
                         2,      {{0, 0, 0, 1}, {0, 1, 0, 1}, {1, 0, 0, -1}, {1, 1, 0, -1}}, true,
                         true};
  CHECK_THROWS_AS(surface_basis(surface, Exact::ratio(1, 2), Exact(0), none), KernelError);
}
