#include "kernel/surface_basis.hpp"

#include "algorithms/surface_common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  check_surface_parameter(inputs, "u", tensor::Direction::u, at);
  check_surface_parameter(inputs, "v", tensor::Direction::v, at);
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return surface_basis(inputs.surface("surface"), inputs.number("u"), inputs.number("v"), rec);
};

bool is(const Site& site, std::string_view symbol) {
  return site.name().symbol == Symbol::of(symbol) && site.name().arity == 2;
}

// N + M for N M
std::vector<Numbers<Exact>> added(const Site& site) {
  if (!is(site, "B")) return {};
  return {{site.operand(0)[0] + site.operand(1)[0]}};
}

// The weighted function, not divided by the sum of all
std::vector<Numbers<Exact>> not_divided(const Site& site) {
  if (!is(site, "R")) return {};
  return {{site.operand(0)[0]}};
}

// The function without its weight
std::vector<Numbers<Exact>> without_weight(const Site& site) {
  if (!is(site, "R")) return {};
  auto name = "B"_v(site.name().index[0], site.name().index[1]);
  const auto B = site.sibling_numbers(name);
  if (!B) return {};
  return {{(*B)[0]}};
}

}  // namespace

const Algorithm& surface_basis() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "surface_basis";
    a.family = Family::evaluation;
    a.title = "Basis functions of a surface";
    a.summary = "The share that every control point has in one point of a surface: the shares add up to 1.";
    a.source = "Shene, CS3621 notes, \"B-spline Surfaces: Construction\"; The NURBS Book, 3.4, 4.4";
    a.inputs = {
        surface_input(),
        {"u", InputSpec::Type::number, "The parameter u, in the domain."},
        {"v", InputSpec::Type::number, "The parameter v, in the domain."},
    };
    a.pseudo_code = {
        "k = span of u, l = span of v",
        "N[i] = N_{i,p}(u), i = k-p..k",
        "M[j] = N_{j,q}(v), j = l-q..l",
        "B[i][j] = N[i] M[j]; their sum is 1",
        "rational: W = sum of B[i][j] w_ij",
        "  R[i][j] = B[i][j] w_ij / W; their sum is 1",
        "S = sum of B[i][j] P[i][j] (rational: divided by W)",
    };
    a.given_narration =
        "A surface of degrees {p} and {q}, with the knots U = {U} and V = {V}, and the parameters u = {u} and v = {v}.";
    a.values = surface_values();
    append(a.values, {
                         {"p", {}, "the degree in u"},
                         {"q", {}, "the degree in v"},
                         {"u", {}, "the parameter u"},
                         {"v", {}, "the parameter v"},
                         {"i", {"i"}, "the index i"},
                         {"j", {"j"}, "the index j"},
                         {"k",
                          {},
                          "the span of u",
                          1,
                          "u = {u} lies in the span k = {k}: only N[{k-p}] to N[{k}] can differ from zero."},
                         {"l",
                          {},
                          "the span of v",
                          1,
                          "v = {v} lies in the span l = {l}: only M[{l-q}] to M[{l}] can differ from zero."},
                         {"N", {"i"}, "the basis function i at u", 2, "{name} = {chain}."},
                         {"M", {"j"}, "the basis function j at v", 3, "{name} = {chain}."},
                         {"B",
                          {"i", "j"},
                          "the basis function of P[i][j] at (u, v)",
                          4,
                          "The share of P[{i}][{j}]: {name} = {chain}."},
                         {"sum", {}, "the sum of all B[i][j]", 4, "All together: {numbers} = {value}."},
                         {"G", {"i", "j"}, "the basis function times its weight", 5, "{name} = {chain}."},
                         {"W", {}, "the weight at (u, v)", 5, "The sum of the weighted functions: W = {value}."},
                         {"R", {"i", "j"}, "the rational basis function of P[i][j]", 6, "{name} = {chain}."},
                         {"one", {}, "the sum of all R[i][j]", 6, "The shares add up to {value}, with weights, too."},
                         {"C", {"i", "j"}, "the sum so far", 7, "The share of P[{i}][{j}] is added: {result}."},
                         {"H", {}, "the point in homogeneous coordinates", 7, "In homogeneous coordinates: {made}."},
                         {"S",
                          {},
                          "the point on the surface",
                          7,
                          "All shares together: S({u}, {v}) = {value}.",
                          ValueSpec::Draw::point},
                     });
    a.phases = {
        {"products", "The products", 4, "Each control point gets the product of a function in u and one in v."},
        {"weights", "The weights", 5, "The surface is rational: each function counts with the weight of its point."},
        {"point", "The point", 7, "The point is the sum of all control points, each times its function."},
    };
    a.rules = {&rule_info<FindSpan>, &rule_info<BasisValue>,       &rule_info<tensor::Product>,
               &rule_info<Total>,    &rule_info<tensor::Weighted>, &rule_info<Quotient>,
               &rule_info<Multiple>, &rule_info<AddMultiple>,      &rule_info<tensor::WholeSum>,
               &rule_info<Project>};
    a.misconceptions = {
        {"sum-for-product", "the two functions are added", "The basis function of a surface is a product, N[i] M[j].",
         added},
        {"undivided-weights", "the weighted functions are not divided by their sum",
         "R[i][j] = B[i][j] w_ij / W: without the division by W the shares don't add up to 1.", not_divided},
        {"forgotten-weights", "the weights are forgotten",
         "On a rational surface each function is multiplied by the weight of its control point.", without_weight}};
    a.asks = {"k", "N[*]", "M[*]", "B[*][*]", "S"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
