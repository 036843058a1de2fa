#include "kernel/bernstein.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const auto& curve = inputs.curve("curve");
  if (curve.n() != curve.degree || curve.knots != bezier_knots<Exact>(curve.degree))
    at("curve").error(
        "must be a Bézier curve: leave out \"knots\", and give degree + 1 points; for a B-spline curve use "
        "basis_functions");
  if (curve.rational) at("curve").error("must have no weights; for a rational curve use basis_functions");
  const Exact& u = inputs.number("u");
  if (u < Exact(0) || Exact(1) < u) at("u").error("must lie in the domain [0, 1], not at " + format_brief(u));
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return bernstein(inputs.curve("curve"), inputs.number("u"), rec);
};

bool is_polynomial(const Site& site) {
  return site.name().symbol == Symbol::of("B") && site.name().arity == 2 && !site.trace().is_input(site.value());
}

Exact power(const Exact& u, int exponent) {
  Exact made(1);
  for (int e = 0; e < exponent; ++e) made *= u;
  return made;
}

// u B[i][r-1] + (1 - u) B[i-1][r-1], also where one of them is missing.
std::vector<Numbers<Exact>> swapped(const Site& site) {
  if (!is_polynomial(site)) return {};
  const Exact& u = site.operand(0)[0];
  const auto [i, r] = site.name().index;
  if (i == 0) return {{u * site.operand(1)[0]}};
  if (i == r) return {{(Exact(1) - u) * site.operand(1)[0]}};
  return {{u * site.operand(1)[0] + (Exact(1) - u) * site.operand(2)[0]}};
}

// (1-u)^(r-i) u^i.
std::vector<Numbers<Exact>> no_binomial(const Site& site) {
  if (!is_polynomial(site)) return {};
  const auto [i, r] = site.name().index;
  if (i == 0 || i == r) return {};
  const auto u = site.sibling_numbers("u"_v);
  if (!u) return {};
  return {{power(Exact(1) - (*u)[0], r - i) * power((*u)[0], i)}};
}

// The mean of the control points, whatever u is.
std::vector<Numbers<Exact>> plain_mean(const Site& site) {
  if (!(site.name() == "C"_v())) return {};
  const int n = site.inputs().curve("curve").degree;
  Numbers<Exact> sum(4, Exact(0));
  for (int i = 0; i <= n; ++i) {
    const auto P = site.sibling_numbers("P"_v(i));
    if (!P) return {};
    for (std::size_t x = 0; x < 4; ++x) sum[x] += (*P)[x] / Exact(n + 1);
  }
  return {sum};
}

}  // namespace

const Algorithm& bernstein() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "bernstein";
    a.family = Family::evaluation;
    a.title = "Bernstein polynomials";
    a.summary = "How much each control point of a Bézier curve counts at a parameter, by the recurrence.";
    a.source = "The NURBS Book, 1.3 (A1.2, A1.3); Shene, CS3621 notes, \"Bézier Curves\"";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A Bézier curve (no knots, no weights)."},
        {"u", InputSpec::Type::number, "The parameter, in [0, 1]."},
    };
    a.pseudo_code = {
        "B[0][0] = 1",
        "for r = 1 to n",
        "  B[0][r] = (1-u) B[0][r-1]",
        "  for i = 1 to r-1",
        "    B[i][r] = (1-u) B[i][r-1] + u B[i-1][r-1]",
        "  B[r][r] = u B[r-1][r-1]",
        "sum of B[i][n] = 1",
        "C = sum of B[i][n] P_i",
    };
    a.given_narration =
        "A Bézier curve of degree n = {n}. How much does each control point count at u = {u}? It begins with "
        "B[0][0] = 1, the only polynomial of degree 0.";
    a.values = {
        {"n", {}, "the degree"},
        {"u", {}, "the parameter"},
        {"P", {"i"}, "the control point P_i", 0, "", ValueSpec::Draw::polygon},
        {"B",
         {"i", "r"},
         "the Bernstein polynomial i of degree r at u",
         5,
         "Degree {r}: {name} is a mean of two of degree {r-1}: {chain}.",
         ValueSpec::Draw::none,
         true,
         {{"rest_of", "", 3, "Degree {r}: the first one has only one above it: {name} = {chain}."},
          {"part_of", "", 6, "Degree {r}: so has the last one: {name} = {chain}."}}},
        {"sum",
         {},
         "the sum of the polynomials of degree n",
         7,
         "Together they are {value}, so the point will be a mean of the control points, never outside of them."},
        {"T", {"i"}, "the sum of the terms up to i", 8, "Up to control point {i} the sum is {chain}."},
        {"C", {}, "the point on the curve", 8, "The sum is complete: C({u}) = {value}.", ValueSpec::Draw::point},
    };
    a.phases = {
        {"degree", "Degree {index}", 2,
         "From degree to degree: each polynomial gives 1-u of itself to the one below, and u to the next one."},
        {"point", "The point", 7, "Each control point counts as much as its polynomial says."},
    };
    a.rules = {&rule_info<RestOf>, &rule_info<BlendNumbers>, &rule_info<PartOf>, &rule_info<Total>,
               &rule_info<Share>,  &rule_info<AddShare>,     &rule_info<Same>};
    a.misconceptions = {
        {"swapped-weights", "the weights are swapped",
         "B[i][r] = (1-u) B[i][r-1] + u B[i-1][r-1]: at u = 0 only the first control point counts, so the first "
         "polynomial is multiplied by 1-u each time.",
         swapped},
        {"no-binomial", "the binomial coefficient is left out",
         "B[i][n] = binom(n, i) (1-u)^(n-i) u^i: without the binomial coefficients they do not sum to 1.", no_binomial},
        {"plain-mean", "the control points all count alike",
         "Each control point counts by its own polynomial at u: C = B[0][n] P_0 + ... + B[n][n] P_n.", plain_mean}};
    a.asks = {"B[*][*]", "C"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
