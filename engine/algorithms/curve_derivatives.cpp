#include "kernel/curve_derivatives.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  check_parameter(inputs, at);
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return curve_derivatives(inputs.curve("curve"), inputs.number("u"), inputs.integer("order"), rec);
};

bool is_slope(const Site& site) { return site.trace().value(site.value()).rule == &rule_info<ControlSlope>; }

Numbers<Exact> slope(const Exact& c, NumbersView<Exact> A, NumbersView<Exact> B) {
  Numbers<Exact> made;
  for (std::size_t i = 0; i < 4; ++i) made.push_back(c * (B[i] - A[i]));
  return made;
}

// B - A alone.
std::vector<Numbers<Exact>> difference_only(const Site& site) {
  if (!is_slope(site)) return {};
  return {slope(Exact(1), site.operand(3), site.operand(4))};
}

// (B - A) / (b - a), without the degree.
std::vector<Numbers<Exact>> degree_forgotten(const Site& site) {
  if (!is_slope(site)) return {};
  const Exact length = site.operand(2)[0] - site.operand(1)[0];
  if (length == Exact(0)) return {};
  return {slope(Exact(1) / length, site.operand(3), site.operand(4))};
}

// p on every level, where the degree has become smaller.
std::vector<Numbers<Exact>> same_degree(const Site& site) {
  if (!is_slope(site)) return {};
  const Exact length = site.operand(2)[0] - site.operand(1)[0];
  if (length == Exact(0)) return {};
  return {slope(Exact(site.inputs().curve("curve").degree) / length, site.operand(3), site.operand(4))};
}

// The derivative of (wx, wy) divided by w, as though w did not depend on u.
std::vector<Numbers<Exact>> constant_weight(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<DivideVector>) return {};
  const auto A = site.sibling_numbers("A"_v(site.name().index[0]));
  const Exact& w = site.operand(1)[0];
  if (!A || w == Exact(0)) return {};
  return {{(*A)[0] / w, (*A)[1] / w, (*A)[2] / w, Exact(0)}};
}

}  // namespace

const Algorithm& curve_derivatives() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "curve_derivatives";
    a.family = Family::evaluation;
    a.title = "Derivatives of a curve";
    a.summary = "The point of a curve and its derivatives there, from differences of control points.";
    a.source = "The NURBS Book, 3.3 and 4.3 (A4.2); Shene, CS3621 notes, \"Derivatives of a B-spline Curve\"";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A curve of any kind; clamped or not."},
        {"u", InputSpec::Type::number, "The parameter, in the domain [u_p, u_{n+1}]."},
        {"order", InputSpec::Type::integer, "Up to which derivative.", 1, 3, {}, "2"},
    };
    a.pseudo_code = {
        "find k with u_k <= u < u_{k+1}, s = multiplicity of u",
        "for d = 1 to order",
        "  for i = k-p to k-d",
        "    c = (p-d+1) / (u_{i+p+1} - u_{i+d})",
        "    P[d][i] = c (P[d-1][i+1] - P[d-1][i])",
        "for d = 0 to order",
        "  D[d] = de Boor(P[d], u), of degree p-d",
        "rational: call these A[d], with weights w[d]",
        "  X = A[d] - sum of binom(d,i) w[i] D[d-i]",
        "  D[d] = X / w[0]",
        "C = D[0]",
    };
    a.given_narration = "A curve of degree p = {p} with the knots U = {U}. Its derivatives at u = {u} are wanted.";
    a.values = {
        {"p", {}, "the degree"},
        {"u", {}, "the parameter"},
        {"U", {}, "the knot vector"},
        {"U", {"i"}, "the knot u_i"},
        {"k",
         {},
         "the span of u",
         1,
         "u = {u} belongs to the span from u_{k} = {U[k]} to u_{k+1} = {U[k+1]}, so k = {k}: the points {k-p} to {k} "
         "count."},
        {"s",
         {},
         "the multiplicity of u",
         1,
         "u = {u} is a knot of multiplicity s = {s}.",
         ValueSpec::Draw::none,
         false,
         {{"", "1-s", 0, "u = {u} is no knot: s = 0."}}},
        {"q", {"d"}, "the degree of the curve that is differentiated"},
        {"P",
         {"d", "i"},
         "the control point i of the d-th derivative (d = 0: of the curve)",
         5,
         "{name} = {chain}.",
         ValueSpec::Draw::level},
        {"alpha", {"r", "i"}, "the ratio for E[r][i]", 7, "alpha[{r}][{i}] = {chain}."},
        {"E",
         {"r", "i"},
         "the point i of level r of de Boor's triangle",
         7,
         "{name} = {chain}.",
         ValueSpec::Draw::level},
        {"A",
         {"d"},
         "the d-th derivative of (wx, wy, wz, w)",
         8,
         "With the weight as a coordinate: {name} = {value}.",
         ValueSpec::Draw::none,
         false,
         {{"vanish_above", "", 0, "The degree is {p}, so the derivative {d} of (wx, wy, wz, w) is zero."}}},
        {"w",
         {"d"},
         "the d-th derivative of the weight",
         8,
         "The derivative {d} of the weight is the last number of A[{d}]: {value}."},
        {"b", {"d", "i"}, "the binomial coefficient d over i"},
        {"X",
         {"d", "i"},
         "what is left of A[d] after taking away i terms",
         9,
         "(w C) differentiated by the rule for products: {name} = {chain}."},
        {"D",
         {"d"},
         "the d-th derivative (d = 0: the point)",
         7,
         "The derivative {d} at u = {u} is {value}.",
         ValueSpec::Draw::point,
         false,
         {{"same", "", 11, "The point itself: C = D[0] = {value}."},
          {"project", "", 10, "The point itself: C = D[0] = {chain}."},
          {"divide_vector", "", 10,
           "The derivative {d} of the curve itself: {chain}. The last number is 0: it is a vector."},
          {"vanish_above", "", 0, "The degree is {p}, so the derivative {d} is zero."}},
         "D[0]"},
    };
    a.phases = {
        {"differences", "Control points of derivative {index}", 2,
         "The derivative {index} is a B-spline curve, too. Its control points are differences of the ones before, "
         "times "
         "the degree, over the knots they span."},
        {"at", "Derivative {index} at u", 7, "Evaluate derivative {index} at u by de Boor's algorithm (0: the curve)."},
    };
    a.rules = {&rule_info<FindSpan>,    &rule_info<Multiplicity>, &rule_info<Ratio>,        &rule_info<Blend>,
               &rule_info<Same>,        &rule_info<Project>,      &rule_info<ControlSlope>, &rule_info<BlendVectors>,
               &rule_info<SameVector>,  &rule_info<VanishAbove>,  &rule_info<WeightOf>,     &rule_info<TakeProduct>,
               &rule_info<DivideVector>};
    a.misconceptions = {
        {"difference-only", "the factor in front of the difference is forgotten",
         "A derivative measures change over the parameter: multiply by the degree and divide by the knots' distance.",
         difference_only},
        {"degree-forgotten", "the degree is left out of the factor",
         "The factor is the degree over the distance of the knots: (p-d+1) / (u_{i+p+1} - u_{i+d}).", degree_forgotten},
        {"same-degree", "the degree is not lowered for the next derivative",
         "Each derivative has one degree less, so the factor of the d-th begins with p-d+1.", same_degree},
        {"constant-weight", "the weight is not differentiated",
         "The weight depends on u as the point does: C' = (A' - w' C) / w.", constant_weight}};
    a.asks = {"P[1..3][*]", "D[*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
