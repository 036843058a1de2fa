#include "kernel/approximation.hpp"

#include "algorithms/fitting.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const int p = inputs.integer("degree");
  const int count = inputs.integer("count");
  const int points = static_cast<int>(inputs.points("points").points.size());
  if (p > points - 1)
    at("degree").error("the degree must be from 1 to " + std::to_string(points - 1) + " here (points less one), not " +
                       std::to_string(p) + ": take a lower degree or more points");
  else if (count != 0 && (count <= p || count > points))
    at("count").error("must be from " + std::to_string(p + 1) + " (degree + 1) to " + std::to_string(points) +
                      " (the number of points), or 0, not " + std::to_string(count));
  if (inputs.number("tolerance") < Exact(0)) at("tolerance").error("must not be negative");
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return approximation(inputs.points("points"), inputs.integer("degree"), inputs.integer("count"),
                       inputs.number("tolerance"), fitting::parametrization(inputs), rec);
};

// The inner knot at the parameter below it, whatever alpha is.
std::vector<Numbers<Exact>> knot_at_parameter(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<BlendNumbers>) return {};
  std::vector<Numbers<Exact>> candidates;
  for (const std::size_t i : {2U, 1U}) {
    const auto t = site.operand(i);
    candidates.emplace_back(t.begin(), t.end());
  }
  return candidates;
}

}  // namespace

const Algorithm& approximation() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "approximation";
    a.family = Family::fitting;
    a.title = "Least-squares approximation";
    a.summary = "The B-spline curve with few control points that passes given points as closely as it can.";
    a.source = "Shene, CS3621 notes, \"Global Curve Approximation\"; The NURBS Book, 9.4.1";
    a.inputs = {
        {"points", InputSpec::Type::points, "The points in order; the curve begins in the first and ends in the last.",
         2, 200},
        {"degree",
         InputSpec::Type::integer,
         "The degree, at most the number of points less one.",
         1,
         max_degree,
         {},
         "3"},
        {"count",
         InputSpec::Type::integer,
         "The number of control points, from degree + 1 to the number of points; 0: as few as keep the tolerance.",
         0,
         200,
         {},
         "0"},
        {"tolerance",
         InputSpec::Type::number,
         "With count 0: how far the curve may be from a point at its parameter.",
         0,
         0,
         {},
         "0"},
        {"parametrization",
         InputSpec::Type::choice,
         "How the points get their parameters.",
         0,
         0,
         {"chord", "centripetal", "uniform"},
         "\"chord\""},
    };
    a.pseudo_code = {
        "d[k] = distance from D[k-1] to D[k], L = their sum",
        "t_k = t_{k-1} + d[k] / L",
        "for n = p, p+1, ... (or the n that is given)",
        "  U: every (m+1)/(n-p+1)-th parameter",
        "  N[k][j] = N_{j,p}(t_k)",
        "  M[i][j] = sum over k of N[k][i] N[k][j]",
        "  R[i] = sum over k of N[k][i] D[k]",
        "  solve M P = R with P_0 = D[0], P_n = D[m]",
        "  gap[k] = |D[k] - C(t_k)|, E = the largest",
        "  stop when E is small enough",
    };
    a.given_narration = "The points to pass closely, in order, and the degree p = {p}.";
    a.values = {
        {"p", {}, "the degree"},
        {"count", {}, "the number of control points"},
        {"tol", {}, "the tolerance"},
        {"eps", {}, "what counts as rounding"},
        {"D", {"k"}, "the given point D[k]", 0, "", ValueSpec::Draw::point},
        {"n", {}, "the number of points less one"},
        {"h", {}, "the number of spans"},
        {"k", {"k"}, "the index k"},
        {"i", {"j"}, "the remainder of j (m+1) by the number of spans"},
        {"j", {"k", "j"}, "the index j"},
        {"c", {"k"}, "the distance from the point before", 1, "{name} = {chain}."},
        {"d", {"k"}, "the distance from the point before (centripetal: its square root)", 1, "{name} = {chain}."},
        {"L", {}, "the whole length", 1, "All together: L = {value}."},
        {"e", {"k"}, "the share of this distance", 2, "{name} = {chain}."},
        {"gap",
         {"k"},
         "the distance of point k from the curve at its parameter",
         9,
         "Point {k} is {result} away from the curve at its parameter."},
        {"t", {"k"}, "the parameter of point k", 2, "Point {k} gets the parameter t_{k} = {value}."},
        {"alpha", {"j"}, "how far the knot is on its way to the next parameter", 4, "alpha[{j}] = {chain}."},
        {"U", {"j"}, "the knot u_j", 4, "The knot lies between two parameters: u_{j} = {chain}."},
        {"U", {}, "the knot vector", 4, "The knot vector: U = {value}."},
        {"N", {"k", "j"}, "the basis function j at t_k", 5, "{name} = {chain}."},
        {"M",
         {"i", "j"},
         "the entry of row i and column j of the normal equations",
         6,
         "Column {i} times column {j}, {@0} · {@1} and the other products added up: {name} = {value}.",
         ValueSpec::Draw::none,
         false},
        {"R", {"i", "k"}, "the right-hand side of row i up to point k", 7, "Point {k} adds its part: {chain}."},
        {"m", {"l", "c"}, "what is subtracted of row c from row l", 8, "Row {l} loses {chain} times row {c}."},
        {"A", {"c", "j"}, "an entry of the eliminated matrix", 8, "Entry {j} of the row: {result}."},
        {"D", {"l", "c"}, "the right-hand side after removing row c", 8, "Forward: {chain}."},
        {"X", {"l", "j"}, "the right-hand side after removing what is known", 8, "Backward: {chain}."},
        {"P", {"i"}, "the control point P_i", 8, "The control point {name} = {chain}.", ValueSpec::Draw::polygon},
        {"r", {"k", "j"}, "what is left of D[k] without the part of P_j", 9, "Without the part of P[{j}]: {chain}."},
        {"E", {}, "the largest error", 9, "The largest of these distances: E = {value}."},
        {"ok",
         {},
         "whether the error keeps the tolerance",
         10,
         "{@0} is larger than the tolerance {@1}: one more control point.",
         ValueSpec::Draw::none,
         false,
         {{"", "ok", 10, "{@0} is not more than the tolerance {@1}: this is the curve."}}},
    };
    a.phases = {
        {"parameters", "Parameters", 1, "At which t shall the curve pass each point? The choice shapes the curve."},
        {"try", "{index} control points", 3, "Is a curve with {index} control points close enough?"},
        {"knots", "Knots", 4, "The knots are spread so that every span holds some of the parameters."},
        {"basis", "Basis functions", 5,
         "At each parameter p + 1 basis functions differ from zero. We need all their values."},
        {"normal", "Normal equations", 6,
         "There are more points than control points, so not all can be met. The sum of the squared distances is least "
         "where the normal equations hold."},
        {"eliminate", "Elimination", 8, "The equations are made triangular, row after row."},
        {"row", "Eliminate in row {index}", 8, "Row {index} loses its entry left of the diagonal."},
        {"solve", "Solve", 8,
         "With the triangle solving is easy: forward to the last row, then backward to the first."},
        {"error", "The error", 9, "How far is the curve from each point, at that point's parameter?"},
    };
    a.rules = {&rule_info<Distance>,     &rule_info<Root>,       &rule_info<Total>,        &rule_info<Quotient>,
               &rule_info<Sum>,          &rule_info<Fraction>,   &rule_info<BlendNumbers>, &rule_info<Gather>,
               &rule_info<BasisValue>,   &rule_info<ProductSum>, &rule_info<Multiple>,     &rule_info<AddMultiple>,
               &rule_info<ReduceNumber>, &rule_info<Reduce>,     &rule_info<Scale>,        &rule_info<Length>,
               &rule_info<Largest>,      &rule_info<Within>};
    a.misconceptions = {fitting::always_uniform(),
                        fitting::not_divided(),
                        {"knot-at-parameter", "the knots are parameters themselves",
                         "A knot lies between two parameters, alpha of the way from the first to the second: so every "
                         "span holds about equally many of them.",
                         knot_at_parameter}};
    a.asks = {"t[*]", "U", "M[*][*]", "P[*]", "try[*].U", "try[*].M[*][*]", "try[*].P[*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
