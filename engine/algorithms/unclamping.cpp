#include "kernel/unclamping.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return unclamping(inputs.curve("curve"), rec);
};

// The control points are left as they are: the points P[j] for the blends.
std::vector<Numbers<Exact>> points_kept(const Site& site) {
  if (!is_blend(site) || site.name().arity != 2) return {};
  const bool left = site.trace().scope(site.value()) == "side[0].";
  const auto A = site.operand(left ? 1 : 2);
  return {Numbers<Exact>(A.begin(), A.end())};
}

// The neighbour as it was before this round, not as the round has made it.
std::vector<Numbers<Exact>> old_neighbour(const Site& site) {
  if (!is_blend(site) || site.name().arity != 2) return {};
  const bool left = site.trace().scope(site.value()) == "side[0].";
  const std::size_t neighbour = left ? 2 : 1;
  Name name = site.trace().value(site.trace().operands(site.value())[neighbour]).name;
  if (name.arity != 2 || name.index[0] != site.name().index[0]) return {};  // this round has not made it
  --name.index[0];
  auto before = site.sibling_numbers(name);
  if (!before)
    if (const auto given = site.trace().find("P[" + std::to_string(name.index[1]) + "]")) before = site.numbers(*given);
  if (!before) return {};
  return {left ? blend(site.operand(0), site.operand(1), *before) : blend(site.operand(0), *before, site.operand(2))};
}

}  // namespace

const Algorithm& unclamping() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "unclamping";
    a.family = Family::curve_technique;
    a.title = "Unclamping";
    a.summary = "The same curve with single knots beyond its ends, at even distances.";
    a.source = "The NURBS Book, 12.2, A12.1";
    a.inputs = {{"curve", InputSpec::Type::curve, "A curve of any kind; an unclamped one is clamped first."}};
    a.pseudo_code = {
        "clamp the curve, if it is not",
        "h[0] = length of the first span",
        "u_{p-1}, .., u_0 = a - h[0], a - 2 h[0], ..",
        "for r = 1 to p-1, j = r-1 down to 0",
        "  beta[r][j] = (u_{p-r+j} - a) / (u_{p+j+1} - a)",
        "  Q[r][j] = (1 - beta) P[j] + beta P[j+1], in place",
        "h[1] = length of the last span",
        "u_{n+2}, .., u_m = b + h[1], b + 2 h[1], ..",
        "for r = 1 to p-1, i = n-r+1 to n",
        "  beta[r][i] = (u_{i+1+r} - u_i) / (b - u_i)",
        "  Q[r][i] = (1 - beta) P[i-1] + beta P[i], in place",
        "V, Q = all knots, all points",
    };
    a.given_narration = "A curve of degree p = {p} with the knots U = {U}. Its ends are to become ordinary places.";
    a.values = {
        {"p", {}, "the degree"},
        {"n", {}, "the index of the last control point"},
        {"U", {}, "the knot vector"},
        {"U", {"i"}, "the knot u_i"},
        {"P", {"i"}, "the control point P_i", 0, "", ValueSpec::Draw::polygon},
        {"W", {}, "the knots of the clamped curve", 1, "Clamped, the curve has the knots {value}."},
        {"h",
         {"e"},
         "the distance of the new knots at the beginning (0) and the end (1)",
         2,
         "The new knots are as far apart as the span next to them is long: {name} = {chain}.",
         ValueSpec::Draw::none,
         false,
         {{"", "e", 7, ""}}},
        {"V",
         {"i"},
         "the new knot i",
         3,
         "The next knot outside: {name} = {chain}.",
         ValueSpec::Draw::none,
         false,
         {{"sum", "", 8, ""}}},
        {"beta",
         {"r", "i"},
         "the ratio for Q[r][i]",
         5,
         "{name} = {chain}: outside of the segment.",
         ValueSpec::Draw::none,
         false,
         {{"", "n", 10, ""}}},
        {"Q",
         {"r", "i"},
         "the point i after exchanging r arguments",
         6,
         "{name} = {chain}, the blossom value {polar}: one copy of the end less.",
         ValueSpec::Draw::polygon,
         false,
         {{"", "n", 11, ""}}},
        {"V", {}, "the new knot vector", 12, "All knots: V = {value}. Each end of the domain is a single knot now."},
        {"Q",
         {"i"},
         "the control point i of the unclamped curve",
         12,
         "The new control points lie farther out; the curve is the same.",
         ValueSpec::Draw::polygon},
    };
    a.phases = {
        {"clamp", "Clamp the curve", 1, "The curve is not clamped: first its ends become knots of full multiplicity."},
        {"end", "Insert the end {index}", 1,
         "The end of the domain (0: the beginning, 1: the end) becomes a full knot."},
        {"side", "End {index}", 0,
         "The points near this end (0: the beginning, 1: the end) exchange the copies of the end for the new knots, "
         "one "
         "after the other. That is knot insertion backwards."},
        {"collect", "The unclamped curve", 12, "Both ends are done."},
    };
    a.rules = {&rule_info<SpanLength>, &rule_info<StepBack>,     &rule_info<Sum>,       &rule_info<Ratio>,
               &rule_info<Blend>,      &rule_info<Same>,         &rule_info<Gather>,    &rule_info<SameNumber>,
               &rule_info<LastKnot>,   &rule_info<Multiplicity>, &rule_info<InsertKnot>};
    a.misconceptions = {
        {"points-kept", "only the knots are exchanged",
         "Other knots with the same points would be another curve: the points near the ends must follow.", points_kept},
        {"old-neighbour", "the neighbour is taken as it was before this round",
         "Each round works in place, from the inside to the end: the neighbour has changed already when its turn "
         "comes.",
         old_neighbour},
        swapped_weights("Q = (1 - beta) times the earlier point + beta times the later one: where beta is 0 the result "
                        "is the earlier point.")};
    a.asks = {"V", "side[*].beta[*][*]", "side[*].Q[*][*]", "Q[*]"};
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
