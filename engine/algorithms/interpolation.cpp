#include "kernel/interpolation.hpp"

#include "algorithms/fitting.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const int p = inputs.integer("degree");
  const int points = static_cast<int>(inputs.points("points").points.size());
  const int tangents =
      static_cast<int>(inputs.points("start_tangent").points.size() + inputs.points("end_tangent").points.size());
  if (tangents > 0 && p < 2) at("degree").error("the degree must be at least 2 where a tangent is given, not 1");
  if (const int most = points + tangents - 1; p > most)
    at("degree").error("the degree must be from 1 to " + std::to_string(most) + " here (points" +
                       (tangents > 0 ? " and tangents" : "") + " less one), not " + std::to_string(p) +
                       ": take a lower degree or more points");
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return interpolation(inputs.points("points"), inputs.integer("degree"), fitting::parametrization(inputs),
                       inputs.points("start_tangent"), inputs.points("end_tangent"), rec);
};

// A parameter itself where a mean of p of them is meant.
std::vector<Numbers<Exact>> parameters_as_knots(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<Mean>) return {};
  const auto averaged = site.trace().operands(site.value());
  const auto t = site.numbers(averaged[averaged.size() / 2]);
  return {Numbers<Exact>(t.begin(), t.end())};
}

}  // namespace

const Algorithm& interpolation() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "interpolation";
    a.family = Family::fitting;
    a.title = "Global interpolation";
    a.summary = "The B-spline curve that passes through given points, with given end tangents where wanted.";
    a.source = "Shene, CS3621 notes, \"Global Curve Interpolation\"; The NURBS Book, 9.2.1 and 9.2.2, A9.1";
    a.inputs = {
        {"points", InputSpec::Type::points, "The points in order, which the curve passes through.", 2, 200},
        {"degree",
         InputSpec::Type::integer,
         "The degree, at most the number of points and tangents less one.",
         1,
         max_degree,
         {},
         "3"},
        {"parametrization",
         InputSpec::Type::choice,
         "How the points get their parameters.",
         0,
         0,
         {"chord", "centripetal", "uniform", "universal"},
         "\"chord\""},
        {"start_tangent",
         InputSpec::Type::points,
         "The derivative of the curve at its start: one vector, or none.",
         0,
         1,
         {},
         "[]"},
        {"end_tangent",
         InputSpec::Type::points,
         "The derivative of the curve at its end: one vector, or none.",
         0,
         1,
         {},
         "[]"},
    };
    a.pseudo_code = {
        "d[k] = distance from D[k-1] to D[k]",
        "L = sum of d[1..n]",
        "t_k = t_{k-1} + d[k] / L",
        "U = averages of p parameters each",
        "row of a point: sum N_{j,p}(t_k) P[j] = D[k]",
        "row of a tangent: sum N'_{j,p}(t) P[j] = T",
        "eliminate below the diagonal",
        "solve for P, forward and backward",
    };
    a.given_narration = "The points to pass through, in order, and the degree p = {p}.";
    a.values = {
        {"p", {}, "the degree"},
        {"D", {"k"}, "the given point D[k]", 0, "", ValueSpec::Draw::point},
        {"T", {"e"}, "the given derivative at the start (0) or the end (1)", 0, "{name} = {value}."},
        {"V", {"e"}, "the same as a vector", 6, "The right-hand side of the tangent's row is the vector {value}."},
        {"n", {}, "the number of points less one"},
        {"h", {}, "the number of spans"},
        {"k", {"k"}, "the index k"},
        {"i", {"k"}, "the row of point k, and the index of its basis function"},
        {"j", {"j"}, "the index j"},
        {"j", {"l", "j"}, "the index j"},
        {"c", {"k"}, "the distance from the point before", 1, "{name} = {chain}."},
        {"d", {"k"}, "the distance from the point before (centripetal: its square root)", 1, "{name} = {chain}."},
        {"L", {}, "the whole length", 2, "All together: L = {value}."},
        {"e", {"k"}, "the share of this distance", 3, "{name} = {chain}."},
        {"t",
         {"k"},
         "the parameter of point k",
         3,
         "Point {k} gets the parameter t_{k} = {value}.",
         ValueSpec::Draw::none,
         false,
         {{"peak", "", 3,
           "Point {k} gets the parameter where the basis function of its row is largest: t_{k} = {value}."}}},
        {"U",
         {"j"},
         "the knot u_j",
         4,
         "An end of the domain: u_{j} = {value}.",
         ValueSpec::Draw::none,
         false,
         {{"fraction", "", 4, "The knots are evenly spaced: u_{j} = {chain}."},
          {"mean", "", 4, "The knot u_{j} is the mean of p = {p} parameters: {value}."}}},
        {"U", {}, "the knot vector", 4, "The knot vector: U = {value}."},
        {"N",
         {"l", "j"},
         "the entry of row l and column j: a basis function, or its slope in a tangent's row",
         5,
         "{name} = {chain}.",
         ValueSpec::Draw::none,
         false,
         {{"basis_slope", "", 6}}},
        {"m", {"l", "c"}, "what is subtracted of row c from row l", 7, "Row {l} loses {chain} times row {c}."},
        {"A", {"c", "j"}, "an entry of the eliminated matrix", 7, "Entry {j} of the row: {result}."},
        {"D", {"l", "c"}, "the right-hand side after removing row c", 8, "Forward: {chain}."},
        {"X", {"l", "j"}, "the right-hand side after removing what is known", 8, "Backward: {chain}."},
        {"P", {"i"}, "the control point P_i", 8, "The control point {name} = {chain}.", ValueSpec::Draw::polygon},
    };
    a.phases = {
        {"parameters", "Parameters", 1,
         "At which t does the curve pass each point? The curve's shape depends much on this choice."},
        {"knots", "Knots", 4, "The knots come next: the system can be solved when they lie among the parameters."},
        {"system", "The equations", 5,
         "Each point gives one equation for the unknown control points: the curve at its parameter is the point."},
        {"eliminate", "Elimination", 7, "The equations are made triangular, row after row. It works without pivoting."},
        {"row", "Eliminate in row {index}", 7, "Row {index} loses its entry left of the diagonal."},
        {"solve", "Solve", 8,
         "With the triangle solving is easy: forward to the last row, then backward to the first."},
    };
    a.rules = {&rule_info<Distance>,     &rule_info<Root>,       &rule_info<Total>,      &rule_info<Quotient>,
               &rule_info<Sum>,          &rule_info<Fraction>,   &rule_info<Mean>,       &rule_info<Gather>,
               &rule_info<Peak>,         &rule_info<BasisValue>, &rule_info<BasisSlope>, &rule_info<Direction>,
               &rule_info<ReduceNumber>, &rule_info<Reduce>,     &rule_info<Scale>};
    a.misconceptions = {fitting::always_uniform(),
                        fitting::not_divided(),
                        {"parameters-as-knots", "the parameters themselves are taken as knots",
                         "The knots are means of p neighbouring parameters: otherwise the system to be solved can "
                         "become singular.",
                         parameters_as_knots}};
    a.asks = {"t[*]", "U", "P[*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
