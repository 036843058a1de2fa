#include "kernel/interpolation.hpp"

#include "algorithms/fitting.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const int p = inputs.integer("degree");
  if (const int most = static_cast<int>(inputs.points("points").points.size()) - 1; p > most)
    at("degree").error("the degree must be from 1 to " + std::to_string(most) + " here (points less one), not " +
                       std::to_string(p) + ": take a lower degree or more points");
}

// The parameters and knots are the subject; the curve they make is shown when they are done.
constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  using S = typename R::Number;
  const auto& points = inputs.points("points");
  const auto parametrization = fitting::parametrization(inputs);
  const auto p = rec.input("p"_v, inputs.integer("degree"));
  const auto D = rec.inputs("D"_v, std::span<const HPoint<S>>(points.points));
  Cells<S, typename R::Id> t;
  {
    auto phase = rec.phase({"parameters"});
    t = point_parameters(rec, D, parametrization);
  }
  const auto knots = interpolating::averaged_knots(rec, t, interpolating::rows(D.size() - 1, false, false), p.value);
  rec.apply(Gather{}, "U"_v, slice(knots, 0, knots.size()));
  NoRecorder<S> plain;
  return interpolation(points, p.value, parametrization, {}, {}, plain);
};

// A parameter itself where a mean of p of them is meant.
std::vector<Numbers<Exact>> parameters_as_knots(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<Mean>) return {};
  const auto averaged = site.trace().operands(site.value());
  const auto t = site.numbers(averaged[averaged.size() / 2]);
  return {Numbers<Exact>(t.begin(), t.end())};
}

// e[k] itself where it is to be added to the parameter before.
std::vector<Numbers<Exact>> not_added(const Site& site) {
  if (site.name().symbol != Symbol::of("t") || site.trace().value(site.value()).rule != &rule_info<Sum>) return {};
  const auto e = site.operand(1);
  return {Numbers<Exact>(e.begin(), e.end())};
}

// k/(n+1): the number of points for the number of intervals.
std::vector<Numbers<Exact>> points_for_intervals(const Site& site) {
  if (site.name().symbol != Symbol::of("t") || site.trace().value(site.value()).rule != &rule_info<Fraction>) return {};
  return {{site.operand(0)[0] / (site.operand(1)[0] + Exact(1))}};
}

// The chord where its square root is meant.
std::vector<Numbers<Exact>> no_root(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<Root>) return {};
  const auto c = site.operand(0);
  return {Numbers<Exact>(c.begin(), c.end())};
}

}  // namespace

const Algorithm& parameters() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "parameters";
    a.family = Family::fitting;
    a.title = "Parameters and knots for points";
    a.summary = "Which parameters points get that a curve is to pass through, and which knots follow from them.";
    a.source =
        "Shene, CS3621 notes, \"Parameter Selection and Knot Vector Generation\"; The NURBS Book, 9.2.1 (eqs. 9.3-9.8)";
    a.inputs = {
        {"points", InputSpec::Type::points, "The points in order, which a curve is to pass through.", 2, 200},
        {"degree",
         InputSpec::Type::integer,
         "The degree of the curve, at most the number of points less one.",
         1,
         max_degree,
         {},
         "3"},
        {"parametrization",
         InputSpec::Type::choice,
         "How the points get their parameters.",
         0,
         0,
         {"chord", "centripetal", "uniform"},
         "\"chord\""},
    };
    a.pseudo_code = {
        "uniform: t_k = k/n",
        "chord: d[k] = |D[k] - D[k-1]|",
        "centripetal: d[k] = sqrt |D[k] - D[k-1]|",
        "L = sum of d[1..n]",
        "t_0 = 0, t_k = t_{k-1} + d[k] / L, t_n = 1",
        "U = 0 (p+1 times), means of p parameters, 1 (p+1 times)",
    };
    a.given_narration =
        "The points D[0], D[1], ... in order, and the degree p = {p}. At which parameter is the curve to pass each?";
    a.values = {
        {"p", {}, "the degree"},
        {"D", {"k"}, "the given point D[k]", 0, "", ValueSpec::Draw::polygon},
        {"n", {}, "the number of points less one"},
        {"k", {"k"}, "the index k"},
        {"c", {"k"}, "the distance from the point before", 3, "The chord from {#D[k-1]} to {#D[k]}: {name} = {chain}."},
        {"d",
         {"k"},
         "the distance from the point before (centripetal: its square root)",
         2,
         "The chord from {#D[k-1]} to {#D[k]}: {name} = {chain}.",
         ValueSpec::Draw::none,
         false,
         {{"root", "", 3, "Of the chord the square root is taken: {name} = {chain}."}}},
        {"L", {}, "the sum of all d", 4, "All together: L = {value}."},
        {"e", {"k"}, "the share of d[k] in the whole", 5, "Its share of the whole: {name} = {chain}."},
        {"t",
         {"k"},
         "the parameter of point k",
         5,
         "Point {k} gets the parameter before it and this share: t_{k} = {chain}.",
         ValueSpec::Draw::none,
         false,
         {{"fraction", "", 1, "Whatever the distances are, point {k} gets the parameter t_{k} = {chain}."}}},
        {"U", {"j"}, "the knot u_j", 6, "The knot u_{j} is the mean of p = {p} parameters: {value}."},
        {"U", {}, "the knot vector", 6, "With p + 1 = {p+1} knots at each end: U = {value}. This is the curve."},
    };
    a.phases = {
        {"parameters", "Parameters", 1,
         "A parameter is a time. The curve starts at t = 0 and ends at t = 1; when does it pass the points between?"},
        {"knots", "Knots", 6, "The inner knots are means of p neighbouring parameters: so they lie among them."},
    };
    a.rules = {&rule_info<Distance>, &rule_info<Root>,     &rule_info<Total>, &rule_info<Quotient>,
               &rule_info<Sum>,      &rule_info<Fraction>, &rule_info<Mean>,  &rule_info<Gather>};
    a.misconceptions = {
        fitting::always_uniform(),
        fitting::not_divided(),
        {"not-added", "a share is given for the parameter",
         "The shares add up on the way: t_k is t_{k-1} and the share of the chord that leads to point k.", not_added},
        {"points-for-intervals", "the points are counted, not the intervals between them",
         "n + 1 points have n intervals between them: t_k = k/n, so that the last parameter is 1.",
         points_for_intervals},
        {"no-root", "the chord itself is taken, not its square root",
         "Centripetal parameters follow the square roots of the distances.", no_root},
        {"parameters-as-knots", "the parameters themselves are taken as knots",
         "An inner knot is the mean of p neighbouring parameters, which keeps the system solvable.",
         parameters_as_knots}};
    a.asks = {"d[*]", "t[*]", "U"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
