#include "kernel/hodograph.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const auto& curve = inputs.curve("curve");
  const int p = curve.degree;
  if (curve.rational)
    at("curve").error(
        "must be without weights: the derivative of a rational curve is of degree " + std::to_string(2 * p) +
        " over the square of the weights, not a difference of control points (curve_derivatives gives its values)");
  if (p == 1) {
    at("curve").error(
        "must be of degree 2 or more: the derivative of a polyline is one vector for each of its legs, no "
        "curve");
    return;
  }
  for (int i = 0; i < curve.n(); ++i) {
    const Exact& u = curve.knots[static_cast<std::size_t>(i) + 1];
    if (!(u == curve.knots[static_cast<std::size_t>(i + p) + 1])) continue;
    at("curve").error("has the knot " + format_brief(u) + " of multiplicity " + std::to_string(p + 1) +
                      " inside: the curve may jump there and has no derivative; the multiplicity must be at most " +
                      std::to_string(p));
    i += p;
  }
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return hodograph(inputs.curve("curve"), rec);
};

bool is_factor(const Site& site) { return site.trace().value(site.value()).rule == &rule_info<SlopeFactor>; }

// 1 / (b - a)
std::vector<Numbers<Exact>> degree_forgotten(const Site& site) {
  if (!is_factor(site) || site.operand(2)[0] == site.operand(1)[0]) return {};
  return {{Exact(1) / (site.operand(2)[0] - site.operand(1)[0])}};
}

// p, as for a Bezier curve
std::vector<Numbers<Exact>> knots_forgotten(const Site& site) {
  if (!is_factor(site)) return {};
  return {{site.operand(0)[0]}};
}

// u_{i+p+1} - u_i
std::vector<Numbers<Exact>> whole_support(const Site& site) {
  if (!is_factor(site)) return {};
  const auto left = site.sibling_numbers("U"_v(site.name().index[0]));
  if (!left || (*left)[0] == site.operand(2)[0]) return {};
  return {{site.operand(0)[0] / (site.operand(2)[0] - (*left)[0])}};
}

// All knots kept.
std::vector<Numbers<Exact>> knots_kept(const Site& site) {
  if (!(site.name() == "V"_v())) return {};
  const auto U = site.operand(0);
  return {Numbers<Exact>(U.begin(), U.end())};
}

}  // namespace

const Algorithm& hodograph() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "hodograph";
    a.family = Family::curve_technique;
    a.title = "Hodograph";
    a.summary = "The derivative of a curve as a curve of its own, one degree lower.";
    a.source = "Shene, CS3621 notes, \"Derivatives of a B-spline Curve\"; The NURBS Book, 3.3";
    a.inputs = {{"curve", InputSpec::Type::curve, "A curve of degree 2 or more, without weights."}};
    a.pseudo_code = {
        "for i = 0 to n-1",
        "  c[i] = p / (u_{i+p+1} - u_{i+1})",
        "  Q[i] = c[i] (P_{i+1} - P_i)",
        "V = U without its first and last knot",
    };
    a.given_narration =
        "A curve of degree p = {p} with the knots U = {U}. How fast does it run, and in which direction?";
    a.values = {
        {"p", {}, "the degree"},
        {"U", {}, "the knot vector"},
        {"U", {"i"}, "the knot u_i"},
        {"P", {"i"}, "the control point P_i", 0, "", ValueSpec::Draw::polygon},
        {"c",
         {"i"},
         "the factor of the i-th leg",
         2,
         "Leg {i}: the degree over the distance of the knots u_{i+1} and u_{i+p+1}, {chain}."},
        {"Q",
         {"i"},
         "the control point i of the hodograph",
         3,
         "{name} = {chain}. It is a direction, drawn from the origin.",
         ValueSpec::Draw::polygon},
        {"V",
         {},
         "the knots of the hodograph",
         4,
         "The degree is one less, and so is each end's multiplicity: V = "
         "{value}."},
    };
    a.rules = {&rule_info<SlopeFactor>, &rule_info<Velocity>, &rule_info<InnerKnots>};
    a.misconceptions = {
        {"degree-forgotten", "the degree is left out of the factor",
         "The factor is the degree over the distance of the knots: c[i] = p / (u_{i+p+1} - u_{i+1}).",
         degree_forgotten},
        {"knots-forgotten", "the factor is the degree alone",
         "Only where the knots are 1 apart is the factor p, as for a Bézier curve: divide by u_{i+p+1} - u_{i+1}.",
         knots_forgotten},
        {"whole-support", "the factor is divided by u_{i+p+1} - u_i",
         "Q[i] belongs to a basis function of degree p-1, whose support is one span shorter: u_{i+p+1} - u_{i+1}.",
         whole_support},
        {"knots-kept", "the knots of the curve are kept",
         "The hodograph has one control point and one degree less, so it has two knots less: drop the first and the "
         "last.",
         knots_kept}};
    a.asks = {"c[*]", "Q[*]", "V"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
