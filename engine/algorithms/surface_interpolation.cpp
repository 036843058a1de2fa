#include "kernel/surface_interpolation.hpp"

#include "algorithms/surface_common.hpp"
#include "algorithms/surface_fitting.hpp"

namespace blossom {
namespace {

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  const auto& points = inputs.net("points");
  return surface_interpolation(points, tensor::degree_for(inputs, "degree_u", points.rows),
                               tensor::degree_for(inputs, "degree_v", points.columns),
                               tensor::parametrization_of(inputs), rec);
};

// The parameters taken as knots, without averaging.
std::vector<Numbers<Exact>> parameters_as_knots(const Site& site) {
  if (site.name().symbol != Symbol::of("U") || site.name().arity != 1 ||
      site.trace().value(site.value()).rule != &rule_info<Mean>)
    return {};
  const auto middle = site.trace().operands(site.value());
  const auto v = site.numbers(middle[middle.size() / 2]);
  return {Numbers<Exact>(v.begin(), v.end())};
}

}  // namespace

const Algorithm& surface_interpolation() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "surface_interpolation";
    a.family = Family::fitting;
    a.title = "Surface interpolation";
    a.summary = "The surface through a net of points: curves through its columns, then through what these give.";
    a.source = "Shene, CS3621 notes, \"Global Surface Interpolation\"; The NURBS Book, 9.2.5, A9.4";
    a.inputs = tensor::fitting_inputs();
    a.pseudo_code = {
        "u[k], v[l] = mean parameters over all columns, all rows",
        "U, V = averages of p (of q) neighbouring parameters",
        "N = basis functions at the parameters; eliminate",
        "for each column l: the curve through Q[.][l], R[.][l]",
        "for each row i: the curve through R[i][.], P[i][.]",
    };
    a.given_narration = "Points in rows and columns. The surface through them is to have the degrees {p} and {q}.";
    a.values = tensor::fitting_values(1, 2, 3);
    append(a.values, {
                         {"Q", {"k", "l"}, "the point in row k and column l", 0, "", ValueSpec::Draw::net},
                         {"D", {"k", "c"}, "the right-hand side after removing row c", 4, "Forward: {chain}."},
                         {"X", {"k", "j"}, "the right-hand side after removing what is known", 4, "Backward: {chain}."},
                         {"R",
                          {"i", "l"},
                          "the control point i of the curve through column l",
                          4,
                          "The control point {name} = {chain}.",
                          ValueSpec::Draw::level},
                         {"P",
                          {"i", "j"},
                          "the surface's control point",
                          5,
                          "The control point {name} = {chain}.",
                          ValueSpec::Draw::net},
                     });
    a.phases = tensor::fitting_phases(1, 2, 3, 5);
    a.phases.insert(
        a.phases.end(),
        {
            {"system", "The system", 3, "Each point gives an equation: its basis functions are the row."},
            {"columns", "Columns", 4, "A curve is put through the points of each column."},
            {"column", "Column {index}", 4, "Solve for the curve through column {index}."},
            {"rows", "Rows", 5, "The control points found are points again: a curve is put through each row of them."},
        });
    a.rules = {&rule_info<Distance>, &rule_info<Root>,  &rule_info<Total>,      &rule_info<Quotient>,
               &rule_info<Mean>,     &rule_info<Sum>,   &rule_info<Fraction>,   &rule_info<Gather>,
               &rule_info<Reduce>,   &rule_info<Scale>, &rule_info<BasisValue>, &rule_info<ReduceNumber>};
    a.misconceptions = {
        tensor::always_uniform(),
        tensor::not_divided(),
        {"parameters-as-knots", "the parameters themselves are taken as knots",
         "The knots are means of neighbouring parameters: otherwise the system to be solved can become singular.",
         parameters_as_knots}};
    a.asks = {"u[*]", "v[*]", "U", "V", "R[*][*]", "P[*][*]"};
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
