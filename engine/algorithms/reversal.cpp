#include "kernel/reversal.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return reversal(inputs.curve("curve"), rec);
};

bool is_mirrored(const Site& site) { return site.trace().value(site.value()).rule == &rule_info<Mirror>; }

// The knots of the old order, as only the points were turned around.
std::vector<Numbers<Exact>> same_knots(const Site& site) {
  if (!is_mirrored(site)) return {};
  return {{site.inputs().curve("curve").knots[static_cast<std::size_t>(site.name().index[0])]}};
}

// b - u, as though the domain began at 0.
std::vector<Numbers<Exact>> begin_forgotten(const Site& site) {
  if (!is_mirrored(site)) return {};
  return {{site.operand(1)[0] - site.operand(2)[0]}};
}

// The knots in the opposite order, not mirrored.
std::vector<Numbers<Exact>> decreasing_knots(const Site& site) {
  if (!is_mirrored(site)) return {};
  return {{site.operand(2)[0]}};
}

}  // namespace

const Algorithm& reversal() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "reversal";
    a.family = Family::curve_technique;
    a.title = "Reversal";
    a.summary = "The same curve, run through from its end to its beginning.";
    a.source = "The NURBS Book, 6.5";
    a.inputs = {{"curve", InputSpec::Type::curve, "A curve of any kind; clamped or not."}};
    a.pseudo_code = {
        "a = u_p, b = u_{n+1}: the domain",
        "for i = 0 to m",
        "  V[i] = a + b - u_{m-i}",
        "for i = 0 to n",
        "  Q[i] = P_{n-i}",
    };
    a.given_narration = "A curve with the knots U = {U}. It is to run the other way round.";
    a.values = {
        {"n", {}, "the index of the last control point"},
        {"m", {}, "the index of the last knot"},
        {"U", {}, "the knot vector"},
        {"U", {"i"}, "the knot u_i"},
        {"P", {"i"}, "the control point P_i", 0, "", ValueSpec::Draw::polygon},
        {"V", {"i"}, "the knot i of the reversed curve", 3, "{name} = {chain}."},
        {"V",
         {},
         "the knots of the reversed curve",
         3,
         "The distances between the knots are the old ones, from the "
         "back: V = {value}."},
        {"Q",
         {"i"},
         "the control point i of the reversed curve",
         5,
         "The control points stay where they are and are counted from the other end.",
         ValueSpec::Draw::polygon},
    };
    a.phases = {
        {"mirror", "Mirror the knots", 2,
         "Each knot is as far from the end now as it was from the beginning. Knots must not decrease, so they are "
         "taken from the back."}};
    a.rules = {&rule_info<Mirror>, &rule_info<Renumber>, &rule_info<Gather>};
    a.misconceptions = {
        {"same-knots", "the knots are left as they were",
         "The knots belong to the curve as much as its points: mirror them, V[i] = a + b - u_{m-i}.", same_knots},
        {"begin-forgotten", "the beginning of the domain is forgotten",
         "The mirror image of u in [a, b] is a + b - u; b - u is right only where a is 0.", begin_forgotten},
        {"decreasing-knots", "the knots are only turned around, so that they decrease",
         "A knot vector never decreases: each knot is mirrored, a + b - u.", decreasing_knots}};
    a.asks = {"V[*]", "V", "Q[*]"};
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
