#include "kernel/basis_functions.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  check_parameter(inputs, at);
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return basis_combination(inputs.curve("curve"), inputs.number("u"), rec);
};

bool is_recurrence(const Site& site) { return site.trace().value(site.value()).rule == &rule_info<CoxDeBoor>; }

// The rising quotient for the function that falls, and the other way round.
std::vector<Numbers<Exact>> swapped_quotients(const Site& site) {
  if (!is_recurrence(site)) return {};
  const auto x = [&](std::size_t i) -> const Exact& { return site.operand(i)[0]; };
  if (x(1) == x(2) || x(4) == x(5)) return {};
  return {{(x(0) - x(1)) / (x(2) - x(1)) * x(6) + (x(5) - x(0)) / (x(5) - x(4)) * x(3)}};
}

// Both quotients over the support of the new function, u_{i+r+1} - u_i.
std::vector<Numbers<Exact>> whole_support(const Site& site) {
  if (!is_recurrence(site)) return {};
  const auto x = [&](std::size_t i) -> const Exact& { return site.operand(i)[0]; };
  if (x(5) == x(1)) return {};
  return {{(x(0) - x(1)) / (x(5) - x(1)) * x(3) + (x(5) - x(0)) / (x(5) - x(1)) * x(6)}};
}

// R[i] = N[i][p], as though all weights were equal.
std::vector<Numbers<Exact>> weights_forgotten(const Site& site) {
  if (!(site.name().symbol == Symbol::of("R")) || site.name().arity != 1) return {};
  const auto N = site.sibling_numbers("N"_v(site.name().index[0], site.inputs().curve("curve").degree));
  if (!N) return {};
  return {Numbers<Exact>(N->begin(), N->end())};
}

// R[i] = N[i][p] w_i, not divided by the sum of all of them.
std::vector<Numbers<Exact>> not_normalized(const Site& site) {
  if (!(site.name().symbol == Symbol::of("R")) || site.name().arity != 1) return {};
  return {{site.operand(0)[0]}};
}

}  // namespace

const Algorithm& basis_functions() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "basis_functions";
    a.family = Family::evaluation;
    a.title = "Basis functions";
    a.summary = "How much each control point counts at a parameter: the B-spline basis functions by their recurrence.";
    a.source = "The NURBS Book, 2.2, 2.5 (A2.2) and 4.2; Shene, CS3621 notes, \"B-spline Basis Functions\"";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A curve of any kind; clamped or not."},
        {"u", InputSpec::Type::number, "The parameter, in the domain [u_p, u_{n+1}]."},
    };
    a.pseudo_code = {
        "find k with u_k <= u < u_{k+1} (at the end: the last)",
        "N[k][0] = 1",
        "for r = 1 to p",
        "  for i = k-r to k",
        "    rise = (u - u_i) / (u_{i+r} - u_i) · N[i][r-1]",
        "    fall = (u_{i+r+1} - u) / (u_{i+r+1} - u_{i+1}) · N[i+1][r-1]",
        "    N[i][r] = rise + fall (at the edges: one of them)",
        "sum of N[i][p] = 1",
        "rational: R[i] = N[i][p] w_i / sum of N[j][p] w_j",
        "C = sum of N[i][p] P_i (rational: of R[i] P_i)",
    };
    a.given_narration =
        "A curve of degree p = {p} with the knots U = {U}. How much does each control point count at u = {u}?";
    a.values = {
        {"p", {}, "the degree"},
        {"u", {}, "the parameter"},
        {"U", {}, "the knot vector"},
        {"U", {"i"}, "the knot u_i"},
        {"P", {"i"}, "the control point P_i", 0, "", ValueSpec::Draw::polygon},
        {"k",
         {},
         "the span of u",
         1,
         "u = {u} belongs to the span from u_{k} = {U[k]} to u_{k+1} = {U[k+1]}, so k = {k}: only the functions "
         "{k-p} to {k} are not zero there."},
        {"N",
         {"i", "r"},
         "the basis function i of degree r at u",
         7,
         "Degree {r}: one function rises on its support, the next one falls. {name} = {chain}.",
         ValueSpec::Draw::none,
         true,
         {{"basis_start", "", 2, "Of degree 0 there is one function on each span: {name} = {value}, all others are 0."},
          {"cox_falling", "", 6, "Degree {r}: the first function only falls here. {name} = {chain}."},
          {"cox_rising", "", 5, "Degree {r}: the last function only rises here. {name} = {chain}."}}},
        {"sum",
         {},
         "the sum of the basis functions",
         8,
         "Together they are {value}: each point is a mean of P_{k-p} "
         "to P_{k}, never outside of them."},
        {"w", {"i"}, "the weight of P_i", 9, "The control point {i} has the weight {value}."},
        {"g", {"i"}, "the basis function times the weight", 9, "{name} = {chain}."},
        {"W", {}, "the sum of basis functions times weights", 9, "All of them together: W = {value}."},
        {"R", {"i"}, "the rational basis function i at u", 9, "{name} = {chain}. The weight counts, too."},
        {"A",
         {"i"},
         "the control point without its weight",
         10,
         "The control point {i} itself is {value}.",
         ValueSpec::Draw::point},
        {"T", {"i"}, "the sum of the terms up to i", 10, "Up to control point {i} the sum is {chain}."},
        {"C", {}, "the point on the curve", 10, "The sum is complete: C({u}) = {value}.", ValueSpec::Draw::point},
    };
    a.rules = {&rule_info<FindSpan>,  &rule_info<BasisStart>, &rule_info<CoxRising>, &rule_info<CoxFalling>,
               &rule_info<CoxDeBoor>, &rule_info<Total>,      &rule_info<WeightOf>,  &rule_info<BasisTimesWeight>,
               &rule_info<Quotient>,  &rule_info<Share>,      &rule_info<AddShare>,  &rule_info<Project>,
               &rule_info<Same>};
    a.misconceptions = {
        {"swapped-quotients", "the rising and the falling quotient are swapped",
         "N[i][r-1] begins at u_i and is multiplied by what rises from there, (u - u_i)/(u_{i+r} - u_i).",
         swapped_quotients},
        {"whole-support", "both quotients are divided by the support of the new function",
         "Each quotient belongs to a function of degree r-1: u_{i+r} - u_i for the first, u_{i+r+1} - u_{i+1} for the "
         "second.",
         whole_support},
        {"weights-forgotten", "the weights are left out",
         "On a rational curve each basis function counts as often as its weight says: R[i] = N[i][p] w_i / W.",
         weights_forgotten},
        {"not-normalized", "N[i][p] w_i is not divided by the sum",
         "The R[i] must sum to 1: divide each N[i][p] w_i by the sum of all of them.", not_normalized}};
    a.asks = {"k", "N[*][*]", "C"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
