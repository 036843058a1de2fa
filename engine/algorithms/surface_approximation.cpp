#include "kernel/surface_approximation.hpp"

#include "algorithms/surface_common.hpp"
#include "algorithms/surface_fitting.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const auto& points = inputs.net("points");
  for (const bool rows : {true, false}) {
    const std::string_view name = rows ? "rows" : "columns";
    if (const int most = rows ? points.rows : points.columns; inputs.integer(name) > most)
      at(name).error("must be from 2 to " + std::to_string(most) + ", as there are " + std::to_string(most) + " " +
                     std::string(name) + " of points, not " + std::to_string(inputs.integer(name)));
  }
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  const int rows = inputs.integer("rows"), columns = inputs.integer("columns");
  return surface_approximation(inputs.net("points"), tensor::degree_for(inputs, "degree_u", rows),
                               tensor::degree_for(inputs, "degree_v", columns), rows, columns,
                               tensor::parametrization_of(inputs), rec);
};

}  // namespace

const Algorithm& surface_approximation() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "surface_approximation";
    a.family = Family::fitting;
    a.title = "Surface approximation";
    a.summary = "A surface with few control points near a net of many points, by least squares in each direction.";
    a.source = "Shene, CS3621 notes, \"Global Surface Approximation\"; The NURBS Book, 9.4.3";
    a.inputs = tensor::fitting_inputs();
    a.inputs.push_back({"rows", InputSpec::Type::integer, "How many rows the control net is to have.", 2, 256});
    a.inputs.push_back({"columns", InputSpec::Type::integer, "How many columns it is to have.", 2, 256});
    a.pseudo_code = {
        "u[k], v[l] = mean parameters over all columns, all rows", "U, V = knots spread evenly among the parameters",
        "N = basis functions at the parameters between the ends",  "M = N^T N; eliminate",
        "for each column l: solve M R[.][l] = N^T Q[.][l]",        "for each row i: solve M P[i][.] = N^T R[i][.]",
        "e[k][l] = |Q[k][l] - S(u[k], v[l])|, E = the largest",
    };
    a.given_narration =
        "Points in rows and columns. A surface of the degrees {p} and {q} with fewer control points is to pass near "
        "them.";
    a.values = tensor::fitting_values(1, 2, 4);
    append(a.values, {
                         {"Q", {"k", "l"}, "the point in row k and column l", 0, "", ValueSpec::Draw::net},
                         {"D", {"k", "c"}, "the right-hand side after removing row c", 5, "Forward: {chain}."},
                         {"h", {}, "the number of spans", 2},
                         {"i", {"j"}, "what is left over of the j-th step", 2},
                         {"alpha", {"j"}, "where the knot lies between two parameters", 2, "{name} = {chain}."},
                         {"M",
                          {"i", "j"},
                          "an entry of the normal equations",
                          4,
                          "The products {@0} · {@1} and so on added up: {name} = {value}."},
                         {"b", {"i", "k"}, "the right-hand side i, up to point k", 5, "{name} = {chain}."},
                         {"X", {"k", "j"}, "the right-hand side after removing what is known", 5, "Backward: {chain}."},
                         {"R",
                          {"i", "l"},
                          "the control point i of the curve near column l",
                          5,
                          "The control point {name} = {chain}.",
                          ValueSpec::Draw::level},
                         {"P",
                          {"i", "j"},
                          "the surface's control point",
                          6,
                          "The control point {name} = {chain}.",
                          ValueSpec::Draw::net},
                         {"s",
                          {"i", "j"},
                          "the point of row i of the net at v[l], up to column j",
                          7,
                          "At v[{index}], row {i} of the net is at {value}."},
                         {"r", {"k", "i"}, "what is left of the point k, up to row i", 7, "{name} = {chain}."},
                         {"e",
                          {"k", "l"},
                          "the distance of point Q[k][l]; in a direction: a share",
                          1,
                          "{name} = {chain}.",
                          ValueSpec::Draw::none,
                          false,
                          {{"length", "", 7, "The point Q[{k}][{l}] is {value} away."}}},
                         {"E", {}, "the largest distance", 7, "The largest distance of all: E = {value}."},
                     });
    // The shares of both directions and the distances have one name.
    std::erase_if(a.values, [](const ValueSpec& spec) {
      return spec.symbol == "e" && spec.indices.size() == 2 && spec.cases.empty();
    });
    a.phases = tensor::fitting_phases(1, 2, 4, 6);
    a.phases.insert(
        a.phases.end(),
        {
            {"basis", "Basis functions", 3, "How much has each control point to say at each parameter?"},
            {"normal", "Normal equations", 4,
             "There are more points than control points: the squares of all distances are to be least."},
            {"columns", "Columns", 5, "A curve is put near the points of each column."},
            {"column", "Column {index}", 5, "Solve for the curve near column {index}."},
            {"rows", "Rows", 6, "The control points found are points again: a curve is put near each row of them."},
            {"error", "How near?", 7, "How far are the points from the surface?"},
            {"strip", "Column {index} of the points", 7, "The points of column {index}."},
        });
    a.rules = {&rule_info<Distance>,     &rule_info<Root>,        &rule_info<Total>,    &rule_info<Quotient>,
               &rule_info<Mean>,         &rule_info<Sum>,         &rule_info<Fraction>, &rule_info<Gather>,
               &rule_info<Reduce>,       &rule_info<Scale>,       &rule_info<Multiple>, &rule_info<AddMultiple>,
               &rule_info<BlendNumbers>, &rule_info<BasisValue>,  &rule_info<Length>,   &rule_info<Largest>,
               &rule_info<ProductSum>,   &rule_info<ReduceNumber>};
    a.misconceptions = {tensor::always_uniform(), tensor::not_divided()};
    a.asks = {"u[*]", "v[*]", "U", "V", "P[*][*]", "E"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
