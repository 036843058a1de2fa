#include "kernel/surface_knot_removal.hpp"

#include "algorithms/surface_common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  if (inputs.number("tolerance") < Exact(0)) at("tolerance").error("must not be negative");
  const auto d = direction_of(inputs);
  if (!check_surface_parameter(inputs, "t", d, at)) return;
  const auto& surface = inputs.surface("surface");
  const auto& knots = surface.knots[index(d)];
  const auto p = static_cast<std::size_t>(surface.degree[index(d)]);
  const Exact& t = inputs.number("t");
  const bool inside = knots[p] < t && t < knots[knots.size() - p - 1];
  if (!inside || multiplicity(std::span<const Exact>(knots), t) == 0)
    at("t").error("must be a knot between the ends of the domain in this direction");
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return surface_knot_removal(inputs.surface("surface"), direction_of(inputs), inputs.number("t"),
                              inputs.number("tolerance"), rec);
};

// alpha and 1 - alpha exchanged in the equation that is solved.
std::vector<Numbers<Exact>> swapped(const Site& site) {
  const RuleInfo* rule = site.trace().value(site.value()).rule;
  if (rule != &rule_info<UnblendEnd> && rule != &rule_info<UnblendBegin>) return {};
  const auto C = site.operand(1), A = site.operand(2);
  const Exact& a = site.operand(0)[0];
  const Exact own = rule == &rule_info<UnblendEnd> ? Exact(1) - a : a;
  if (own == Exact(0)) return {};
  Numbers<Exact> made;
  for (std::size_t c = 0; c < 4; ++c) made.push_back((C[c] - (Exact(1) - own) * A[c]) / own);
  return {made};
}

// The last line's bound, or the smallest, where the largest of all is meant.
std::vector<Numbers<Exact>> smallest_bound(const Site& site) {
  if (!(site.name() == "E"_v())) return {};
  Exact smallest = site.operand(0)[0];
  for (std::size_t i = 1; i < site.trace().operands(site.value()).size(); ++i)
    smallest = std::min(smallest, site.operand(i)[0]);
  return {{smallest}};
}

}  // namespace

const Algorithm& surface_knot_removal() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "surface_knot_removal";
    a.family = Family::surface_technique;
    a.title = "Knot removal from a surface";
    a.summary = "A surface with a row or column less that is the same, or as close to it as a tolerance asks.";
    a.source = "The NURBS Book, 5.4, A5.8; Tiller, \"Knot-removal algorithms for NURBS curves and surfaces\", 1992";
    a.inputs = {
        surface_input(),
        direction_input("Whether it is a knot in u, removed from the columns, or in v, from the rows."),
        {"t", InputSpec::Type::number, "The inner knot, of which one copy is removed."},
        {"tolerance",
         InputSpec::Type::number,
         "How far the surface may move (a rational one: its homogeneous points).",
         0,
         0,
         {},
         "\"0\""},
    };
    a.pseudo_code = {
        "for each column (u) or row (v) of the net",
        "  remove t once, as from a curve: new points, and a bound",
        "  e = this bound",
        "E = the largest of them",
        "if E <= tolerance: Q = the new points, a row (column) less",
        "  else Q = P",
    };
    a.given_narration =
        "A surface with the knots U = {U} and V = {V}. One copy of the knot {t} is to be removed, where the tolerance "
        "{tol} allows it.";
    a.values = surface_values();
    append(a.values, {
                         {"t", {}, "the knot"},
                         {"tol", {}, "the tolerance"},
                         {"eps", {}, "what counts as rounding"},
                         {"e", {"j"}, "the bound of line j", 3, "The curve of line {j} moves by {value} at most."},
                         {"E",
                          {},
                          "the bound on how far the surface moves",
                          4,
                          "All lines must allow it, so the largest bound counts: E = {value}."},
                         {"all",
                          {},
                          "whether all lines allow it",
                          6,
                          "{@0} is more than the tolerance {@1}: the knot stays.",
                          ValueSpec::Draw::none,
                          false,
                          {{"", "all", 5, "{@0} is not more than the tolerance {@1}: the knot can go."}}},
                         {"Q",
                          {"i", "j"},
                          "the control point in row i and column j afterwards",
                          5,
                          "The control net afterwards.",
                          ValueSpec::Draw::net,
                          false,
                          {{"", "1-all", 6, "The control net is what it was."}}},
                     });
    a.phases = {
        {"column", "Column {index}", 1, "Column {index} is a curve over the knots U."},
        {"row", "Row {index}", 1, "Row {index} is a curve over the knots V."},
        {"remove", "Knot removal", 2, "Would this curve be the same without the knot?"},
        {"collect", "The control net", 5, "What is left is to write down the control net."},
    };
    a.rules = {&rule_info<LastKnot>,     &rule_info<Multiplicity>, &rule_info<Ratio>, &rule_info<UnblendEnd>,
               &rule_info<UnblendBegin>, &rule_info<MiddleOf>,     &rule_info<Gap>,   &rule_info<Within>,
               &rule_info<RemoveKnot>,   &rule_info<Relabel>,      &rule_info<Total>, &rule_info<SameNumber>,
               &rule_info<Largest>};
    a.misconceptions = {
        {"swapped-weights", "alpha and 1 - alpha are exchanged",
         "P[i] = (1-alpha[i]) Q[i-1] + alpha[i] Q[i]: the new point from the left is divided by alpha[i].", swapped},
        {"smallest-bound", "the smallest bound is taken",
         "Every column (row) must allow the removal, so the largest of the bounds counts.", smallest_bound}};
    a.asks = {"e[*]", "E", "Q[*][*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
