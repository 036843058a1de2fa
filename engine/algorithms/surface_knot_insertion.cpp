#include "kernel/surface_knot_insertion.hpp"

#include "algorithms/surface_common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const auto d = direction_of(inputs);
  if (!check_surface_parameter(inputs, "t", d, at)) return;
  const auto& surface = inputs.surface("surface");
  const int p = surface.degree[index(d)];
  const int s = multiplicity(std::span<const Exact>(surface.knots[index(d)]), inputs.number("t"));
  if (s >= p)
    at("t").error("is a knot of multiplicity " + std::to_string(s) +
                  " already: nothing can be inserted beyond the degree " + std::to_string(p));
  else if (s + inputs.integer("times") > p)
    at("times").error("must be at most " + std::to_string(p - s) + " here: t has multiplicity " + std::to_string(s) +
                      " and the degree is " + std::to_string(p));
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return surface_knot_insertion(inputs.surface("surface"), direction_of(inputs), inputs.number("t"),
                                inputs.integer("times"), rec);
};

}  // namespace

const Algorithm& surface_knot_insertion() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "surface_knot_insertion";
    a.family = Family::surface_technique;
    a.title = "Knot insertion into a surface";
    a.summary = "The same surface with one more knot in u or in v: each column or row is refined as a curve.";
    a.source = "Shene, CS3621 notes, \"Knot Insertion\"; The NURBS Book, 5.3, A5.3";
    a.inputs = {
        surface_input(),
        direction_input("Whether it is a knot in u, inserted into the columns, or in v, into the rows."),
        {"t", InputSpec::Type::number, "The new knot, in the domain."},
        {"times",
         InputSpec::Type::integer,
         "How often it is inserted; its multiplicity may grow up to the degree.",
         1,
         max_degree,
         {},
         "1"},
    };
    a.pseudo_code = {
        "for each column (u) or row (v) of the net",
        "  insert t into its knots h times, as into a curve",
        "  Q = its new control points",
    };
    a.given_narration = "A surface with the knots U = {U} and V = {V}. The knot {t} is to be inserted h = {h} times.";
    a.values = surface_values();
    append(a.values, {
                         {"t", {}, "the new knot"},
                         {"h", {}, "how often it is inserted"},
                         {"Q",
                          {"i", "j"},
                          "the new control point in row i and column j",
                          3,
                          "The new control points of this curve take their places in the net.",
                          ValueSpec::Draw::net},
                     });
    a.phases = {
        {"column", "Column {index}", 1, "Column {index} is a curve over the knots U."},
        {"row", "Row {index}", 1, "Row {index} is a curve over the knots V."},
        {"insert", "Knot insertion", 2, "The knot is inserted, and the ratios are the same for every column or row."},
    };
    a.rules = {&rule_info<LastKnot>, &rule_info<Multiplicity>, &rule_info<Ratio>,
               &rule_info<Blend>,    &rule_info<Same>,         &rule_info<InsertKnot>};
    a.misconceptions = {
        swapped_weights("Q[r][i] = (1-alpha[r][i]) Q[r-1][i-1] + alpha[r][i] Q[r-1][i]: where alpha is 0 the result is "
                        "the earlier point, so that one gets 1-alpha and the later one gets alpha."),
        unweighted_points()};
    a.asks = {"Q[*][*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
