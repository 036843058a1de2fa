#include "kernel/de_casteljau.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const auto& curve = inputs.curve("curve");
  if (curve.n() != curve.degree || curve.knots != bezier_knots<Exact>(curve.degree))
    at("curve").error(
        "must be a Bézier curve: leave out \"knots\", and give degree + 1 points; for a B-spline curve use de_boor");
  const Exact& u = inputs.number("u");
  if (u < Exact(0) || Exact(1) < u) at("u").error("must lie in the domain [0, 1], not at " + format_brief(u));
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return de_casteljau(inputs.curve("curve"), inputs.number("u"), rec);
};

// P[r-1][i-1] for P[r-1][i+1]: the wrong neighbour.
std::vector<Numbers<Exact>> wrong_pair(const Site& site) {
  if (!is_blend(site)) return {};
  const auto [r, i] = site.name().index;
  const auto left = site.sibling_numbers("P"_v(r - 1, i - 1));
  if (!left) return {};
  return {blend(site.operand(0), *left, site.operand(1))};
}

}  // namespace

const Algorithm& de_casteljau() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "de_casteljau";
    a.family = Family::evaluation;
    a.title = "de Casteljau's algorithm";
    a.summary = "A point on a Bézier curve by repeated linear interpolation of its control points.";
    a.source = "Shene, CS3621 notes, \"Finding a Point on a Bézier Curve\"; The NURBS Book, A1.5";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A Bézier or rational Bézier curve (no knots)."},
        {"u", InputSpec::Type::number, "The parameter, in [0, 1]."},
    };
    a.pseudo_code = {
        "for r = 1 to n",
        "  for i = 0 to n-r",
        "    P[r][i] = (1-u) P[r-1][i] + u P[r-1][i+1]",
        "C = P[n][0]",
    };
    a.given_narration = "The control points P[0][0] to P[0][n] of a Bézier curve, and the parameter u = {u}.";
    a.values = {
        {"u", {}, "the parameter"},
        {"P",
         {"r", "i"},
         "the point i of level r (level 0: the control points)",
         3,
         "Level {r}: divide the segment from {#P[r-1][i]} to {#P[r-1][i+1]} at u = {u}: "
         "P[{r}][{i}] = (1 - {u}) {~P[r-1][i]} + {u} {~P[r-1][i+1]} = {made}.",
         ValueSpec::Draw::level,
         true},
        {"C",
         {},
         "the point on the curve",
         4,
         "One point is left: the point of the curve at u = {u} is C = {value}.",
         ValueSpec::Draw::point},
    };
    a.rules = {&rule_info<Blend>, &rule_info<Same>, &rule_info<Project>};
    a.misconceptions = {
        swapped_weights(
            "P[r][i] = (1-u) P[r-1][i] + u P[r-1][i+1]: at u = 0 the result is the first point, so that one "
            "gets 1-u and the second gets u."),
        missing_division(),
        unweighted_points(),
        unweighted_coordinates(),
        {"wrong-pair", "the point on the wrong side is taken",
         "P[r][i] lies between P[r-1][i] and its right neighbour P[r-1][i+1], not between P[r-1][i-1] and P[r-1][i].",
         wrong_pair},
    };
    a.asks = {"P[1][*]", "P[*][*]", "C"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
