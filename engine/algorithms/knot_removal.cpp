#include "kernel/knot_removal.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  if (inputs.number("tolerance") < Exact(0)) at("tolerance").error("must not be negative");
  if (!check_parameter(inputs, at)) return;
  const auto& curve = inputs.curve("curve");
  const Exact& u = inputs.number("u");
  const int s = multiplicity(std::span<const Exact>(curve.knots), u);
  const bool inside = curve.domain_begin() < u && u < curve.domain_end();
  if (!inside || s == 0) {
    std::vector<Exact> inner;
    for (const Exact& knot : curve.knots)
      if (curve.domain_begin() < knot && knot < curve.domain_end() && (inner.empty() || inner.back() != knot))
        inner.push_back(knot);
    std::string message = "must be a knot between the ends of the domain";
    for (std::size_t i = 0; i < std::min<std::size_t>(inner.size(), 8); ++i)
      message += (i == 0 ? ": " : ", ") + format_brief(inner[i]);
    at("u").error(message + (inner.empty() ? "; this curve has none" : inner.size() > 8 ? ", ..." : ""));
  } else if (const int times = inputs.integer("times"); times > s) {
    at("times").error("must be at most " + std::to_string(s) + " here, the multiplicity of u, not " +
                      std::to_string(times));
  }
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return knot_removal(inputs.curve("curve"), inputs.number("u"), inputs.integer("times"), inputs.number("tolerance"),
                      rec);
};

// alpha and 1 - alpha exchanged in the equation that is solved.
std::vector<Numbers<Exact>> swapped(const Site& site) {
  const RuleInfo* rule = site.trace().value(site.value()).rule;
  if (rule != &rule_info<UnblendEnd> && rule != &rule_info<UnblendBegin>) return {};
  const auto C = site.operand(1), A = site.operand(2);
  const Exact& a = site.operand(0)[0];
  const Exact own = rule == &rule_info<UnblendEnd> ? Exact(1) - a : a;  // what X is divided by, and is not
  if (own == Exact(0)) return {};
  Numbers<Exact> made;
  for (std::size_t c = 0; c < 4; ++c) made.push_back((C[c] - (Exact(1) - own) * A[c]) / own);
  return {made};
}

// The points blended as though the knot were inserted once more.
std::vector<Numbers<Exact>> inserted_again(const Site& site) {
  const RuleInfo* rule = site.trace().value(site.value()).rule;
  if (rule == &rule_info<UnblendEnd>) return {blend(site.operand(0), site.operand(2), site.operand(1))};
  if (rule == &rule_info<UnblendBegin>) return {blend(site.operand(0), site.operand(1), site.operand(2))};
  return {};
}

// u_{i+p} for u_{i+p+1}, the knots as they are without the one that goes.
std::vector<Numbers<Exact>> short_window(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<Ratio>) return {};
  const int i = site.name().index[0];
  const auto& curve = site.inputs().curve("curve");
  const auto right = static_cast<std::size_t>(i + curve.degree);
  if (site.trace().scope(site.value()) != "removal[1]." || right >= curve.knots.size()) return {};
  const Exact& a = site.operand(1)[0];
  if (curve.knots[right] == a) return {};
  return {{(site.operand(0)[0] - a) / (curve.knots[right] - a)}};
}

}  // namespace

const Algorithm& knot_removal() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "knot_removal";
    a.family = Family::curve_technique;
    a.title = "Knot removal";
    a.summary = "A curve with fewer knots that is the same, or as close to it as a tolerance asks.";
    a.source = "The NURBS Book, 5.4, A5.8; Tiller, \"Knot-removal algorithms for NURBS curves and surfaces\", 1992";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A curve of any kind with inner knots; clamped or not."},
        {"u", InputSpec::Type::number, "The inner knot to be removed."},
        {"times", InputSpec::Type::integer, "How often, at most its multiplicity.", 1, max_degree + 1, {}, "1"},
        {"tolerance",
         InputSpec::Type::number,
         "How far each removal may move the curve (of a rational curve: its homogeneous points).",
         0,
         0,
         {},
         "0"},
    };
    a.pseudo_code = {
        "for t = 1 to times",
        "  r = last index with u_r = u, s = multiplicity of u",
        "  alpha[i] = (u - u_i) / (u_{i+p+1} - u_i)",
        "  L[i] = (P[i] - (1-alpha[i]) L[i-1]) / alpha[i], from the left",
        "  R[i-1] = (P[i] - alpha[i] R[i]) / (1-alpha[i]), from the right",
        "  b = how far the two sides miss each other in the middle",
        "  if b > tolerance: stop",
        "  take u out of U, the points L and R in for the old ones",
    };
    a.given_narration =
        "A curve with the knots U = {U}. The knot u = {u} is to be removed, where the tolerance {tol} "
        "allows it.";
    a.values = {
        {"u", {}, "the knot"},
        {"tol", {}, "the tolerance"},
        {"eps", {}, "what counts as rounding"},
        {"U", {}, "the knot vector", 0, "Its knots are U = {value}."},
        {"U", {"i"}, "the knot u_i"},
        {"P", {"i"}, "the control point P_i", 0, "", ValueSpec::Draw::polygon},
        {"r", {}, "the index of the last copy of u", 2, "In the knots {@1} the last copy of {@0} has the index {r}."},
        {"s", {}, "the multiplicity of u", 2, "It is a knot of multiplicity s = {s}."},
        {"alpha", {"i"}, "the ratio for P[i]", 3, "alpha[{i}] = {chain}."},
        {"L",
         {"i"},
         "the new point i as the left side finds it",
         4,
         "From the left: {name} = {chain}.",
         ValueSpec::Draw::point},
        {"R",
         {"i"},
         "the new point i as the right side finds it",
         5,
         "From the right: {name} = {chain}.",
         ValueSpec::Draw::point},
        {"M",
         {},
         "the point in the middle as the new points have it",
         6,
         "With these points the one in the middle would be {chain}.",
         ValueSpec::Draw::point},
        {"b",
         {},
         "the bound on how far the curve moves",
         6,
         "They miss each other by b = {chain}: the curve moves no "
         "farther than that."},
        {"ok",
         {},
         "whether the bound keeps the tolerance",
         7,
         "{@0} is more than the tolerance {@1}: the knot stays.",
         ValueSpec::Draw::none,
         false,
         {{"", "ok", 7, "{@0} is not more than the tolerance {@1}: the knot can go."}}},
        {"Ubar", {}, "the new knot vector", 8, "One copy less: Ubar = {value}."},
        {"h", {}, "how often the knot was removed"},
        {"E",
         {},
         "the bound on the whole change",
         8,
         "Removed h = {h} times, the curve has moved by at most E = {value}.",
         ValueSpec::Draw::none,
         false,
         {{"", "1-h", 8, "The knot was not removed: no copy of it can go within the tolerance."}}},
        {"Q",
         {"i"},
         "the new control point Q_i",
         8,
         "The control points of the curve, in order.",
         ValueSpec::Draw::polygon},
    };
    a.phases = {{"removal", "Removal {index}", 1,
                 "If the knot can go, inserting it again would give these control points. So insertion is undone."},
                {"collect", "The new control net", 8, "What has come of it?"}};
    a.rules = {&rule_info<LastKnot>,     &rule_info<Multiplicity>, &rule_info<Ratio>,  &rule_info<UnblendEnd>,
               &rule_info<UnblendBegin>, &rule_info<MiddleOf>,     &rule_info<Gap>,    &rule_info<Within>,
               &rule_info<RemoveKnot>,   &rule_info<Total>,        &rule_info<Relabel>};
    a.misconceptions = {
        {"swapped-weights", "alpha and 1 - alpha are exchanged",
         "P[i] = (1-alpha[i]) Q[i-1] + alpha[i] Q[i]: to find Q[i] take off (1-alpha[i]) Q[i-1] and divide by "
         "alpha[i].",
         swapped},
        {"inserted-again", "the points are blended instead of taken apart",
         "Removing undoes insertion: P[i] is the blend, and one of the two points it was blended of is wanted.",
         inserted_again},
        {"short-window", "the denominator of alpha uses u_{i+p}",
         "The knot that goes is still counted here: the denominator of alpha[i] is u_{i+p+1} - u_i.", short_window}};
    a.asks = {"removal[1].alpha[*]", "removal[1].L[*]", "removal[1].R[*]", "Q[*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
