#include "kernel/degree_reduction.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  if (inputs.curve("curve").degree < 2) at("curve").error("must have a degree of at least 2 to be reduced, not 1");
  if (inputs.number("tolerance") < Exact(0)) at("tolerance").error("must not be negative");
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return degree_reduction(inputs.curve("curve"), inputs.number("tolerance"), rec);
};

bool is_undone(const Site& site) {
  const RuleInfo* rule = site.trace().value(site.value()).rule;
  return rule == &rule_info<UnblendBegin> || rule == &rule_info<UnblendEnd>;
}

// i/(p-1) for i/p
std::vector<Numbers<Exact>> wrong_ratio(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<Fraction> || site.operand(1)[0] == Exact(1)) return {};
  return {{site.operand(0)[0] / (site.operand(1)[0] - Exact(1))}};
}

// The points of the old polygon blended, as though the degree were elevated once more.
std::vector<Numbers<Exact>> elevated_again(const Site& site) {
  if (!is_undone(site)) return {};
  const bool left = site.trace().value(site.value()).rule == &rule_info<UnblendBegin>;
  return {left ? blend(site.operand(0), site.operand(1), site.operand(2))
               : blend(site.operand(0), site.operand(2), site.operand(1))};
}

// The old point itself: inner points just left out.
std::vector<Numbers<Exact>> point_kept(const Site& site) {
  if (!is_undone(site)) return {};
  const auto B = site.operand(1);
  return {Numbers<Exact>(B.begin(), B.end())};
}

}  // namespace

const Algorithm& degree_reduction() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "degree_reduction";
    a.family = Family::curve_technique;
    a.title = "Degree reduction";
    a.summary = "A curve of one degree less with the same ends, close to the given one, and a bound on the error.";
    a.source =
        "The NURBS Book, 5.6, A5.11; Forrest, \"Interactive interpolation and approximation by Bézier "
        "polynomials\", 1972";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A curve of any kind of degree 2 or more; clamped or not."},
        {"tolerance",
         InputSpec::Type::number,
         "How far taking out each knot between the reduced segments may move the curve besides (of a rational curve: "
         "its homogeneous points).",
         0,
         0,
         {},
         "0"},
    };
    a.pseudo_code = {
        "decompose the curve into Bézier segments B",
        "for each segment: alpha[i] = i / p, r = floor((p-1)/2)",
        "  from the left:  Q[i] = (B[i] - alpha[i] Q[i-1]) / (1-alpha[i])",
        "  from the right: Q[i-1] = (B[i] - (1-alpha[i]) Q[i]) / alpha[i]",
        "  p even: e = |B[r+1] - (Q[r] + Q[r+1]) / 2|",
        "  p odd: Q[r] = (L + R) / 2, e = (1-alpha[r]) / 2 |L - R|",
        "E = largest e",
        "join the segments, remove their knots where they can go",
        "E = E + the bounds of all removals",
    };
    a.given_narration =
        "A curve of degree p = {p} with the knots U = {U}. It is to be approximated by one of degree "
        "p - 1.";
    a.values = {
        {"p", {}, "the degree before"},
        {"tol", {}, "the tolerance"},
        {"eps", {}, "what counts as rounding"},
        {"i", {"i"}, "the index i"},
        {"U", {}, "the knot vector", 0, "Its knots are U = {value}."},
        {"U", {"i"}, "the knot u_i"},
        {"P", {"i"}, "the control point P_i", 0, "", ValueSpec::Draw::polygon},
        {"alpha", {"i"}, "the ratio i/p", 2, "alpha[{i}] = i / p = {result}."},
        {"Q",
         {"j", "i"},
         "the point i of the reduced segment j",
         3,
         "From the left: {name} = {chain}.",
         ValueSpec::Draw::level,
         false,
         {{"relabel", "", 3, "Segment {j}: an end stays where it is, {name} = {chain}."},
          {"unblend_end", "", 4, "From the right: {name} = {chain}."},
          {"half_way", "", 6, "Half way between both: {name} = {chain}."}}},
        {"L",
         {"j"},
         "the point in the middle of segment j as the left side finds it",
         3,
         "The left side finds the point in the middle at {chain}.",
         ValueSpec::Draw::point},
        {"R",
         {"j"},
         "the point in the middle of segment j as the right side finds it",
         4,
         "The right side finds it at {chain}.",
         ValueSpec::Draw::point},
        {"e",
         {"j"},
         "the bound on the error of segment j",
         6,
         "The two sides do not agree: this moves the curve by up to {chain}.",
         ValueSpec::Draw::none,
         false,
         {{"missed_middle", "", 5, "The equation in the middle is off, and the curve by up to {chain}."}}},
        {"E",
         {"z"},
         "the largest error of the segments",
         7,
         "Reducing the segments moves the curve by at most {value}."},
        {"Ubar", {}, "the knots with full joints", 8, "The joined segments have the knots {value}."},
        {"u", {}, "the knot of a joint", 8, "The joint at u = {value}: is its knot needed as often?"},
        {"E",
         {},
         "the bound on the whole error",
         9,
         "All together the curve has moved by at most E = {value}.",
         ValueSpec::Draw::none,
         false,
         {{"largest", "", 7}}},
        {"Q",
         {"i"},
         "the new control point Q_i",
         3,
         "From the left: {name} = {chain}.",
         ValueSpec::Draw::polygon,
         false,
         {{"relabel", "", 3, "The ends stay where they are: {name} = {chain}."},
          {"unblend_end", "", 4, "From the right: {name} = {chain}."},
          {"half_way", "", 6, "Half way between both: {name} = {chain}."}}},
    };
    a.phases = {
        {"decompose", "Decompose into Bézier segments", 1,
         "First the curve falls into Bézier segments: each knot of the domain is inserted until it has multiplicity "
         "p."},
        {"knot", "Insert knot {index}", 1, "Insert knot number {index} until it has full multiplicity."},
        {"reduce", "Reduce each segment", 2,
         "If the curve had been elevated, elevation could be undone. So we undo it, from both ends to the middle."},
        {"join", "Join the segments", 8,
         "The reduced segments meet at their ends. Knots that are not needed there are taken out."},
        {"removal", "Removal {index}", 8, "Can one copy of the joint's knot go?"},
        {"collect", "The new control net", 9, "What has come of it?"},
    };
    a.rules = {&rule_info<Fraction>,     &rule_info<UnblendBegin>, &rule_info<UnblendEnd>, &rule_info<HalfWay>,
               &rule_info<MissedMiddle>, &rule_info<SharedGap>,    &rule_info<Largest>,    &rule_info<Total>,
               &rule_info<Gather>,       &rule_info<SameNumber>,   &rule_info<Relabel>,    &rule_info<Ratio>,
               &rule_info<Blend>};
    a.misconceptions = {
        {"reduction-ratio", "the ratio is i/(p-1) instead of i/p",
         "The polygon that is given has p legs: as the result of an elevation its points divide at i/p.", wrong_ratio},
        {"elevated-again", "the points are blended instead of taken apart",
         "Reducing undoes elevation: B[i] is the blend, and one of the two points it was blended of is wanted.",
         elevated_again},
        {"point-kept", "a point of the old polygon is taken as it is",
         "Leaving out points changes the curve much more than needed: ask which points elevation would have made these "
         "of.",
         point_kept}};
    a.asks = {"alpha[*]", "Q[*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
