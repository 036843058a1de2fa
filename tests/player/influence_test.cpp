#include "player/influence.hpp"

#include <catch2/catch.hpp>
#include <map>

#include "algorithms/inputs.hpp"
#include "kernel/basis.hpp"
#include "player/inputs.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

// A run with all that is drawn of it.
template <Scalar S>
struct Recorded {
  Recorded(const char* algorithm, const Inputs<Exact>& inputs)
      : run(made(algorithm, inputs)), narrator(run), source(make_source(narrator)) {}
  Recorded(const char* algorithm, const std::string& inputs) : Recorded(algorithm, inputs_from(algorithm, inputs)) {}
  Recorded(const Recorded&) = delete;

  ValueId operator[](const std::string& name) const {
    const auto v = run.trace.find(name);
    INFO(name);
    REQUIRE(v);
    return *v;
  }
  std::uint32_t last() const { return run.trace.step_count() - 1; }
  std::vector<std::string> names(const std::vector<ValueId>& values) const {
    std::vector<std::string> texts;
    for (const ValueId v : values) texts.push_back(run.trace.name(v));
    return texts;
  }
  Emphasis emphasis(Link::Kind kind, std::uint32_t id, std::uint32_t step) const {
    return emphasis_of(source, {kind, id}, step);
  }
  Emphasis pointing_at(const std::string& name, std::uint32_t step) const {
    return emphasis(Link::Kind::value, (*this)[name], step);
  }

  Run<S> run;
  Narrator<S> narrator;
  StepSource source;

 private:
  static Run<S> made(const char* algorithm, const Inputs<Exact>& inputs) {
    auto run = record<S>(*find_algorithm(algorithm), inputs);
    INFO(to_string(run.diagnostics));
    REQUIRE(run);
    return std::move(*run);
  }
};

bool is_point(const TraceGraph& graph, ValueId v) {
  return graph.value(v).kind == ValueKind::point || graph.value(v).kind == ValueKind::vector;
}

// What the given points and their shares add up to, in homogeneous coordinates, and the sum of the shares.
struct Combined {
  std::vector<double> point = std::vector<double>(4);
  double sum = 0;
};
Combined combined(const StepSource& source, const std::vector<double>& share) {
  Combined made;
  for (ValueId v = 0; v < share.size(); ++v) {
    if (!source.graph->is_input(v) || share[v] == 0) continue;
    const auto numbers = source.raw(v);
    for (std::size_t c = 0; c < 4; ++c) made.point[c] += share[v] * numbers[c];
    made.sum += share[v];
  }
  return made;
}

void check_reproduced(const StepSource& source, ValueId v, double margin) {
  INFO(source.graph->name(v));
  const auto made = combined(source, shares(source, v));
  const auto numbers = source.raw(v);
  double scale = 1;
  for (const double x : numbers) scale = std::max(scale, std::abs(x));
  CHECK(made.sum == Approx(1).margin(margin));
  for (std::size_t c = 0; c < 4; ++c) CHECK(made.point[c] == Approx(numbers[c]).margin(margin * scale));
}

// knots 0 0 0 0 1/4 1/2 3/4 1 1 1 1 at 2/5: the span is k = 4, and P[0][1]..P[0][4] count
const char* const de_boor_text =
    R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, "1/4", "1/2", "3/4", 1, 1, 1, 1],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10]]}, "u": "2/5"})";

using Names = std::vector<std::string>;
using Kind = Link::Kind;

}  // namespace

TEMPLATE_TEST_CASE("the shares of the control points in C are the B-spline basis functions", "", double, Exact) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    std::mt19937 random(seed);
    const int p = random_int(random, 1, 5);
    const bool rational = seed % 2 == 0;
    const auto curve = random_curve(random, p, random_int(random, 1, 5), p, random_int(random, 0, 2) > 0, rational);
    Inputs<Exact> inputs;
    inputs.values["curve"] = curve;
    inputs.values["u"] = random_parameter(random, curve.knots, p);
    INFO("seed " << seed << "\n" << to_text(inputs));
    const Recorded<TestType> made("de_boor", inputs);

    const auto U = rounded(curve.knots);
    const double u = inputs.number("u").to_double();
    const int k = find_span<double>(U, p, u);
    std::vector<double> N(static_cast<std::size_t>(p) + 1);
    basis_functions<double>(U, p, k, u, N);

    const ValueId C = made["C"];
    const auto share = shares(made.source, C);
    REQUIRE(share.size() == std::size_t{C} + 1);
    CHECK(share[C] == 1);
    double sum = 0;
    for (int i = 0; i <= curve.n(); ++i) {
      INFO("P[0][" << i << "]");
      const ValueId P = made["P[0][" + std::to_string(i) + "]"];
      const bool inside = k - p <= i && i <= k;
      CHECK(share[P] == Approx(inside ? N[static_cast<std::size_t>(i - k + p)] : 0).margin(1e-12));
      CHECK(shares_onward(made.source, P)[C] == Approx(share[P]).margin(1e-12));
      sum += share[P];
    }
    CHECK(sum == Approx(1).margin(1e-12));
  }
}

TEST_CASE("the shares of a Bezier curve's control points are Bernstein polynomials, at every level") {
  const Recorded<double> made("de_casteljau",
                              R"({"curve": {"degree": 4, "points": [[0, 0], [1, 3], [4, 4], [6, 1], [7, 7]],
                                  "weights": [1, 2, "1/2", 1, 3]}, "u": "2/7"})");
  const double u = 2.0 / 7;
  const double binomial[5][5] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}, {1, 4, 6, 4, 1}};
  for (int r = 0; r <= 4; ++r) {
    for (int i = 0; i + r <= 4; ++i) {
      const auto share = shares(made.source, made["P[" + std::to_string(r) + "][" + std::to_string(i) + "]"]);
      for (int j = 0; j <= r; ++j) {
        INFO("P[" << r << "][" << i << "] of P[0][" << i + j << "]");
        CHECK(share[made["P[0][" + std::to_string(i + j) + "]"]] ==
              Approx(binomial[r][j] * std::pow(u, j) * std::pow(1 - u, r - j)).margin(1e-15));
      }
    }
  }
}

TEST_CASE("every point that elevation and insertion make is what the given points and their shares add up to") {
  for (const char* algorithm : {"degree_elevation", "knot_insertion"}) {
    for (unsigned seed = 1; seed <= 25; ++seed) {
      const auto inputs = any_inputs(*find_algorithm(algorithm), seed);
      INFO(algorithm << ", seed " << seed << "\n" << to_text(inputs));
      const Recorded<Exact> made(algorithm, inputs);
      for (ValueId v = 0; v < made.run.trace.value_count(); ++v)
        if (is_point(made.run.trace, v)) check_reproduced(made.source, v, 1e-10);
    }
  }
}

TEST_CASE("every control point of a skinned surface is what the profiles' points and their shares add up to") {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const auto inputs = any_inputs(*find_algorithm("skinning"), seed);
    INFO("seed " << seed << "\n" << to_text(inputs));
    const Recorded<double> made("skinning", inputs);
    const auto& surface = std::get<Surface<double>>(made.run.outcome);
    for (int i = 0; i < surface.rows; ++i)
      for (int j = 0; j < surface.columns; ++j)
        check_reproduced(made.source, made["Q[" + std::to_string(i) + "][" + std::to_string(j) + "]"], 1e-8);
  }
}

TEST_CASE("a number has no shares, nor do numbers count in what is made with them") {
  const Recorded<double> made("de_boor", std::string(de_boor_text));
  const ValueId alpha = made["alpha[1][3]"];
  auto expected = std::vector<double>(std::size_t{alpha} + 1);
  expected[alpha] = 1;
  CHECK(shares(made.source, alpha) == expected);
  const auto onward = shares_onward(made.source, alpha);
  CHECK(onward.size() == made.run.trace.value_count());
  CHECK(std::ranges::count_if(onward, [](double x) { return x != 0; }) == 1);
  CHECK(shares(made.source, made["C"])[alpha] == 0);
}

TEST_CASE("pointing at a value lights it, its line, and what it came from") {
  const Recorded<double> made("de_boor", std::string(de_boor_text));
  const auto emphasis = made.pointing_at("P[2][3]", made.last());
  CHECK(made.names(emphasis.lit) == Names{"P[2][3]"});
  CHECK(emphasis.line == 6);
  std::map<std::string, double> share;
  for (const auto& [v, x] : emphasis.shares) share[made.run.trace.name(v)] = x;
  // alpha[2][3] = (2/5) / (1/2), alpha[1][2] = (2/5) / (1/2), alpha[1][3] = (2/5) / (3/4)
  CHECK(share.size() == 5);
  CHECK(share["P[1][2]"] == Approx(1.0 / 5));
  CHECK(share["P[1][3]"] == Approx(4.0 / 5));
  CHECK(share["P[0][1]"] == Approx(1.0 / 25));
  CHECK(share["P[0][2]"] == Approx(4.0 / 25 + 4.0 / 5 * 7 / 15));
  CHECK(share["P[0][3]"] == Approx(4.0 / 5 * 8 / 15));
  CHECK(std::ranges::is_sorted(emphasis.shares));
}

TEST_CASE("a value that goes on under another name is lit under both, as soon as there are two") {
  const Recorded<double> made("de_boor", std::string(de_boor_text));
  const std::uint32_t before = made.run.trace.value(made["P[3][4]"]).step;
  CHECK(made.names(made.pointing_at("P[3][4]", before).lit) == Names{"P[3][4]"});
  CHECK(made.names(made.pointing_at("P[3][4]", made.last()).lit) == Names{"P[3][4]", "C"});
  CHECK(made.names(made.pointing_at("C", made.last()).lit) == Names{"P[3][4]", "C"});

  // Profiles over [0, 2] and [0, 1]: their points stay where they are while the knots are mapped.
  const Recorded<double> skinned("skinning", std::string(R"({"profiles": [
      {"degree": 1, "knots": [0, 0, 2, 2], "points": [[0, 0, 0], [1, 0, 0]]},
      {"degree": 1, "points": [[0, 4, 0], [3, 4, 0]]}], "degree_v": 1})"));
  const auto lit = skinned.names(skinned.pointing_at("P[1][0]", skinned.last()).lit);
  CHECK(lit == Names{"P[1][0]", "domain[1].P[0]"});
}

TEST_CASE("a given control point shows how much it counts in everything made so far; its basis function likewise") {
  const Recorded<double> made("de_boor", std::string(de_boor_text));
  const ValueId P = made["P[0][2]"];
  const auto& curve = made.source.curves[0];
  const double N = basis_function<double>(curve.knots, 3, 2, *made.source.parameter);

  const auto at_end = made.emphasis(Kind::value, P, made.last());
  CHECK(at_end.share(made["C"]) == Approx(N));
  CHECK(at_end.share(made["P[1][2]"]) == Approx(4.0 / 5));
  CHECK(made.emphasis(Kind::basis, 2, made.last()) == at_end);

  const auto early = made.emphasis(Kind::value, P, made.run.trace.value(made["P[1][2]"]).step);
  CHECK(made.names(early.lit) == Names{"P[0][2]"});
  REQUIRE(early.shares.size() == 1);
  CHECK(early.shares[0].first == made["P[1][2]"]);

  CHECK(made.pointing_at("P[0][0]", made.last()).shares.empty());  // outside of the span
  CHECK(made.emphasis(Kind::basis, 99, made.last()).empty());
}

TEST_CASE("pointing at a line of code lights what it made so far") {
  const Recorded<double> made("de_boor", std::string(de_boor_text));
  const std::uint32_t step = made.run.trace.value(made["P[1][3]"]).step;
  CHECK(made.names(made.emphasis(Kind::line, 6, step).lit) == Names{"P[1][2]", "P[1][3]"});
  CHECK(made.names(made.emphasis(Kind::line, 1, step).lit) == Names{"k"});
  CHECK(made.emphasis(Kind::line, 7, step).lit.empty());
  CHECK(made.emphasis(Kind::line, 7, step).line == 7);
  CHECK(made.names(made.emphasis(Kind::line, 7, made.last()).lit) == Names{"C"});
}

TEST_CASE("a line of an algorithm within another lights only what it made in that phase") {
  // Both profiles but the last are elevated, each in a phase of its own.
  const Recorded<double> made("skinning", std::string(R"({"profiles": [
      {"degree": 1, "points": [[0, 0, 0], [1, 0, 0]]}, {"degree": 1, "points": [[0, 4, 0], [3, 4, 0]]},
      {"degree": 2, "points": [[0, 5, 1], [1, 5, 2], [2, 5, 1]]}], "degree_v": 1})"));
  const std::uint32_t step = made.run.trace.value(made["raise[1].Q[1]"]).step;
  CHECK(made.names(made.emphasis(Kind::line, 5, step).lit) == Names{"raise[1].Q[1]"});
  CHECK(made.names(made.emphasis(Kind::line, 4, step).lit) == Names{"raise[1].alpha[1]"});
  // The line of a value is that of the pseudo-code one sees, or none.
  CHECK(made.pointing_at("raise[1].Q[1]", step).line == 5);
  CHECK(made.pointing_at("raise[1].Q[1]", made.last()).line == 0);
}

TEST_CASE("knots, the parameter, phases and steps light their values") {
  const Recorded<double> made("knot_insertion", std::string(de_boor_text));
  const auto at = [&](Kind kind, std::uint32_t id) { return made.names(made.emphasis(kind, id, made.last()).lit); };
  CHECK(at(Kind::knot, 0) == Names{"U[0]", "U[1]", "U[2]", "U[3]"});
  CHECK(at(Kind::knot, 5) == Names{"U[5]"});
  CHECK(at(Kind::knot, 99).empty());
  CHECK(at(Kind::parameter, 0) == Names{"u"});
  CHECK(at(Kind::none, 0).empty());
  CHECK(at(Kind::step, made.run.trace.value(made["k"]).step) == Names{"k"});

  const auto& phases = made.run.trace.phases();
  REQUIRE(phases.size() == 1);
  CHECK(at(Kind::phase, 0) == Names{"Q[0]", "Q[1]", "Q[2]", "Q[3]", "Q[4]", "Q[5]", "Q[6]", "Q[7]"});
  CHECK(made.emphasis(Kind::phase, 0, phases[0].first_step - 1).empty());
  CHECK(at(Kind::phase, 1).empty());

  // Of several curves the knots of the first, whatever else is called U.
  const Recorded<double> skinned("skinning", std::string(R"({"profiles": [
      {"degree": 1, "knots": [0, 0, "1/2", 1, 1], "points": [[0, 0, 0], [1, 0, 0], [2, 1, 0]]},
      {"degree": 1, "points": [[0, 4, 0], [3, 4, 0]]}], "degree_v": 1})"));
  CHECK(skinned.names(skinned.emphasis(Kind::knot, 2, skinned.last()).lit) == Names{"U[0][2]"});
}

TEST_CASE("two emphases in one: all that either lights, and the second's shares and line where both have them") {
  Emphasis pinned{{2, 5}, {{0, 0.5}, {1, 0.5}}, 3};
  const Emphasis over{{5, 7}, {{1, 0.25}, {4, 0.75}}, 6};
  const Emphasis both = merged(pinned, over);
  CHECK(both.lit == std::vector<ValueId>{2, 5, 7});
  CHECK(both.shares == std::vector<std::pair<ValueId, double>>{{0, 0.5}, {1, 0.25}, {4, 0.75}});
  CHECK(both.line == 6);
  CHECK(merged(pinned, {}) == pinned);
  CHECK(merged({}, pinned) == pinned);
}

TEST_CASE("why: each value is opened once, into its operands in order, down to what was given") {
  for (const char* algorithm : {"de_boor", "degree_elevation", "skinning"}) {
    const Recorded<double> made(algorithm, any_inputs(*find_algorithm(algorithm), 7));
    const auto& trace = made.run.trace;
    const ValueId top = trace.value_count() - 1;
    const auto lines = why(trace, top, 100'000);
    REQUIRE(lines.size() > 3);
    CHECK(lines[0].value == top);
    CHECK(lines[0].depth == 0);
    std::vector<bool> opened(trace.value_count());
    for (std::size_t l = 0; l < lines.size(); ++l) {
      const WhyLine& line = lines[l];
      INFO(algorithm << ", line " << l << ": " << trace.name(line.value));
      std::vector<ValueId> below;
      for (std::size_t m = l + 1; m < lines.size() && lines[m].depth > line.depth; ++m)
        if (lines[m].depth == line.depth + 1) below.push_back(lines[m].value);
      CHECK(line.given == trace.is_input(line.value));
      CHECK(line.told_above == opened[line.value]);
      if (line.given || line.told_above) {
        CHECK(below.empty());
      } else {
        CHECK(std::ranges::equal(below, trace.operands(line.value)));
        opened[line.value] = true;
      }
    }
    CHECK(why(trace, top, 3).size() == 3);
  }
}
