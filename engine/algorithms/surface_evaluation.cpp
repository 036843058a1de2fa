#include "kernel/surface_evaluation.hpp"

#include "algorithms/surface_common.hpp"
#include "kernel/evaluate.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  check_surface_parameter(inputs, "u", tensor::Direction::u, at);
  check_surface_parameter(inputs, "v", tensor::Direction::v, at);
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  const auto first = inputs.choice("order") == "u then v" ? tensor::Direction::u : tensor::Direction::v;
  return surface_evaluation(inputs.surface("surface"), inputs.number("u"), inputs.number("v"), first, rec);
};

// The point at (v, u).
std::vector<Numbers<Exact>> parameters_exchanged(const Site& site) {
  if (site.name().symbol != Symbol::of("S") || site.name().arity != 0) return {};
  const auto& surface = site.inputs().surface("surface");
  const std::array parameter{site.inputs().number("v"), site.inputs().number("u")};
  for (std::size_t d = 0; d < 2; ++d) {
    const auto& knots = surface.knots[d];
    const auto p = static_cast<std::size_t>(surface.degree[d]);
    if (parameter[d] < knots[p] || knots[knots.size() - p - 1] < parameter[d]) return {};
  }
  const auto S = homogeneous_point(surface, parameter[0], parameter[1]);
  if (S.w == Exact(0)) return {};
  return {{S.x / S.w, S.y / S.w, S.z / S.w, Exact(1)}};
}

}  // namespace

const Algorithm& surface_evaluation() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "surface_evaluation";
    a.family = Family::evaluation;
    a.title = "A point on a surface";
    a.summary = "A point on a surface by de Boor's algorithm on its rows, and then once on the points found.";
    a.source = "Shene, CS3621 notes, \"B-spline Surfaces\"; The NURBS Book, 3.4, A3.5";
    a.inputs = {
        surface_input(),
        {"u", InputSpec::Type::number, "The parameter u, in the domain."},
        {"v", InputSpec::Type::number, "The parameter v, in the domain."},
        {"order",
         InputSpec::Type::choice,
         "Which parameter is put in first: v, along the rows, or u, along the columns.",
         0,
         0,
         {"v then u", "u then v"},
         "\"v then u\""},
    };
    a.pseudo_code = {
        "find the span k of the second parameter, and its multiplicity s",
        "for each row (column) of index k-p+s..k",
        "  R = its point at the first parameter, by de Boor",
        "S = the point of the curve of these at the second parameter",
    };
    a.given_narration =
        "A surface of degrees {p} and {q}, with the knots U = {U} and V = {V}, and the parameters u = {u} and v = {v}.";
    a.values = surface_values();
    append(a.values,
           {
               {"p", {}, "the degree in u"},
               {"q", {}, "the degree in v"},
               {"u", {}, "the parameter u"},
               {"v", {}, "the parameter v"},
               {"k",
                {},
                "the span of the second parameter",
                1,
                "The parameter {@1} lies in the span k = {k} of the knots {@2}: only the lines up to index {k} "
                "have an influence there."},
               {"s",
                {},
                "the multiplicity of the second parameter",
                1,
                "{@0} is a knot of multiplicity {s}: so many lines fewer are needed.",
                ValueSpec::Draw::none,
                false,
                {{"", "1-s", 0, "{@0} is no knot: all of them are needed."}}},
               {"R",
                {"i"},
                "the point of row (column) i at the first parameter",
                3,
                "The point of this curve is R[{i}] = {value}: a control point of the curve to come.",
                ValueSpec::Draw::point},
               {"S",
                {},
                "the point on the surface",
                4,
                "One point is left: S({u}, {v}) = {value}.",
                ValueSpec::Draw::point},
           });
    a.phases = {
        {"row", "Row {index}", 2, "Row {index} of the control net is a curve of its own, over the knots V."},
        {"column", "Column {index}", 2, "Column {index} of the control net is a curve of its own, over the knots U."},
        {"evaluate", "de Boor's algorithm", 3, "Its point is found by de Boor's algorithm."},
        {"across", "The curve across", 4, "The points found are control points of a curve on the surface."},
    };
    a.rules = {&rule_info<FindSpan>, &rule_info<Multiplicity>, &rule_info<Gather>, &rule_info<SameNumber>,
               &rule_info<Ratio>,    &rule_info<Blend>,        &rule_info<Same>,   &rule_info<Project>};
    a.misconceptions = {
        swapped_weights("P[r][i] = (1-alpha[r][i]) P[r-1][i-1] + alpha[r][i] P[r-1][i]: where alpha is 0 the result is "
                        "the earlier point, so that one gets 1-alpha and the later one gets alpha."),
        missing_division(),
        {"exchanged-parameters", "u and v are exchanged",
         "The rows are curves over the knots V, so v is put into them; u belongs to the columns.",
         parameters_exchanged}};
    a.asks = {"k", "R[*]", "S"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
