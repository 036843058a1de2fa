#include "kernel/surface_degree_elevation.hpp"

#include "algorithms/surface_common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const int p = inputs.surface("surface").degree[index(direction_of(inputs))];
  if (p + inputs.integer("times") > max_degree)
    at("times").error("must be at most " + std::to_string(max_degree - p) + " here: the degree is " +
                      std::to_string(p) + " and may grow up to " + std::to_string(max_degree));
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return surface_degree_elevation(inputs.surface("surface"), direction_of(inputs), inputs.integer("times"), rec);
};

bool is_elevate(const Site& site) { return site.trace().value(site.value()).rule == &rule_info<Elevate>; }

// i/p for i/(p+1)
std::vector<Numbers<Exact>> wrong_ratio(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<Fraction> || site.operand(1)[0] == Exact(1)) return {};
  return {{site.operand(0)[0] / (site.operand(1)[0] - Exact(1))}};
}

std::vector<Numbers<Exact>> swapped(const Site& site) {
  if (!is_elevate(site)) return {};
  return {blend(site.operand(0), site.operand(1), site.operand(2))};
}

}  // namespace

const Algorithm& surface_degree_elevation() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "surface_degree_elevation";
    a.family = Family::surface_technique;
    a.title = "Degree elevation of a surface";
    a.summary = "The same surface with a higher degree in u or in v: each column or row is elevated as a curve.";
    a.source = "Shene, CS3621 notes, \"Degree Elevation of a Bézier Curve\"; The NURBS Book, 5.5, A5.10";
    a.inputs = {
        surface_input(),
        direction_input("Whether the degree in u is raised, by the columns, or that in v, by the rows."),
        {"times", InputSpec::Type::integer, "By how much the degree is raised.", 1, max_degree - 1, {}, "1"},
    };
    a.pseudo_code = {
        "for each column (u) or row (v) of the net",
        "  raise its degree by t, as of a curve",
        "  Q = its new control points",
    };
    a.given_narration = "A surface with the knots U = {U} and V = {V}. One of its degrees is to be raised by t = {t}.";
    a.values = surface_values();
    append(a.values, {
                         {"t", {}, "by how much the degree is raised"},
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
        {"raise", "Degree elevation", 2, "Its degree is raised, and it stays the same curve."},
    };
    a.rules = {&rule_info<Fraction>,     &rule_info<Elevate>, &rule_info<ElevateEnd>, &rule_info<tensor::ElevateEndV>,
               &rule_info<ElevateKnots>, &rule_info<Ratio>,   &rule_info<Blend>,      &rule_info<Same>};
    a.misconceptions = {
        {"elevation-ratio", "the ratio is i/p instead of i/(p+1)",
         "The new polygon has p+1 segments, so its points divide the old ones at i/(p+1).", wrong_ratio},
        {"swapped-weights", "the weights are swapped",
         "Q[i] = i/(p+1) P[i-1] + (1 - i/(p+1)) P[i]: the earlier point gets i/(p+1).", swapped}};
    a.asks = {"Q[*][*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
