#include "kernel/surface_subdivision.hpp"

#include "algorithms/surface_common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const auto d = direction_of(inputs);
  if (!check_surface_parameter(inputs, "t", d, at)) return;
  const auto& surface = inputs.surface("surface");
  const auto& knots = surface.knots[index(d)];
  const auto p = static_cast<std::size_t>(surface.degree[index(d)]);
  const Exact &begin = knots[p], &end = knots[knots.size() - p - 1];
  if (inputs.number("t") == begin || inputs.number("t") == end)
    at("t").error("is an end of the domain: to cut the surface in two, choose t between " + format_brief(begin) +
                  " and " + format_brief(end));
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return surface_subdivision(inputs.surface("surface"), direction_of(inputs), inputs.number("t"), rec);
};

// The new end with the multiplicity p that insertion gives it, not p + 1.
std::vector<Numbers<Exact>> open_end(const Site& site) {
  const bool left = site.name() == "UL"_v();
  if (!left && !(site.name() == "UR"_v())) return {};
  const auto right_answer = site.trace().numbers(site.value());
  Numbers<Exact> knots(right_answer.begin(), right_answer.end());
  knots.erase(left ? knots.end() - 1 : knots.begin());
  return {knots};
}

}  // namespace

const Algorithm& surface_subdivision() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "surface_subdivision";
    a.family = Family::surface_technique;
    a.title = "Subdivision of a surface";
    a.summary = "A surface cut in two along an isoparametric curve: each column or row is cut as a curve.";
    a.source = "Shene, CS3621 notes, \"Subdividing a Bézier Curve\"; The NURBS Book, 5.3";
    a.inputs = {
        surface_input(),
        direction_input("Whether it is cut at u = t, each column in two, or at v = t, each row."),
        {"t", InputSpec::Type::number, "Where it is cut, inside the domain."},
    };
    a.pseudo_code = {
        "for each column (u) or row (v) of the net",
        "  cut it at t, as a curve",
        "  L = the control points of its first part",
        "  R = the control points of its second part",
    };
    a.given_narration = "A surface with the knots U = {U} and V = {V}. It is to be cut in two at {t}.";
    a.values = surface_values();
    append(a.values, {
                         {"p", {}, "the degree in the direction of the cut"},
                         {"t", {}, "where the surface is cut"},
                         {"L",
                          {"i", "j"},
                          "the control point of the first part in row i and column j",
                          3,
                          "The first part of this curve belongs to the first surface.",
                          ValueSpec::Draw::net},
                         {"R",
                          {"i", "j"},
                          "the control point of the second part in row i and column j",
                          4,
                          "The second part belongs to the second surface; both have the point on the cut.",
                          ValueSpec::Draw::net},
                     });
    a.phases = {
        {"column", "Column {index}", 1, "Column {index} is a curve over the knots U."},
        {"row", "Row {index}", 1, "Row {index} is a curve over the knots V."},
        {"cut", "Subdivision", 2, "The curve is cut in two, and the ratios are the same for every column or row."},
    };
    a.rules = {&rule_info<LastKnot>,    &rule_info<Multiplicity>, &rule_info<Ratio>,
               &rule_info<Blend>,       &rule_info<Same>,         &rule_info<KnotsBefore>,
               &rule_info<KnotsBehind>, &rule_info<Gather>,       &rule_info<SameNumber>};
    a.misconceptions = {
        swapped_weights("Q[r][i] = (1-alpha[r][i]) Q[r-1][i-1] + alpha[r][i] Q[r-1][i]: where alpha is 0 the result is "
                        "the earlier point, so that one gets 1-alpha and the later one gets alpha."),
        unweighted_points(),
        {"open-end", "the new end is a knot only p times",
         "A clamped end is a knot of multiplicity p+1: one more than insertion gives, as for the ends of U and V.",
         open_end}};
    a.asks = {"L[*][*]", "R[*][*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
