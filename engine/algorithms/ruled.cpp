#include "kernel/ruled.hpp"

#include "algorithms/construction.hpp"

namespace blossom {
namespace {

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return ruled(inputs.curve("first"), inputs.curve("second"), rec);
};

// Not every Q[i][j]: those of knot insertion, while the curves are made compatible, are called the same.
bool in_net(const Site& site) { return site.trace().value(site.value()).rule == &rule_info<PutIntoNet>; }

// The control point of a compatible curve that belongs at (i, j) of the net, which another one was put in place of.
std::vector<Numbers<Exact>> belongs_at(const Site& site, int i, int j) {
  const auto v = site.sibling("Q"_v(i, j));
  if (!v) return {};
  const auto P = site.numbers(site.trace().operands(*v)[0]);
  return {Numbers<Exact>(P.begin(), P.end())};
}

// The second curve is run through backwards.
std::vector<Numbers<Exact>> reversed(const Site& site) {
  if (!in_net(site) || site.name().index[1] != 1) return {};
  const auto [i, j] = site.name().index;
  return belongs_at(site, last_row(site, site.name()) - i, j);
}

// v = 0 at the second curve.
std::vector<Numbers<Exact>> exchanged(const Site& site) {
  if (!in_net(site)) return {};
  const auto [i, j] = site.name().index;
  return belongs_at(site, i, 1 - j);
}

// The control points as given, although the curves were changed to fit each other.
std::vector<Numbers<Exact>> not_compatible(const Site& site) {
  if (!in_net(site)) return {};
  const auto [i, j] = site.name().index;
  return value_instead(site, "P"_v(j, i));
}

}  // namespace

const Algorithm& ruled() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "ruled";
    a.family = Family::construction;
    a.title = "Ruled surface";
    a.summary = "The straight segments between the points of equal parameters of two curves.";
    a.source = "Shene, CS3621 notes, \"Ruled Surfaces\"; The NURBS Book, 8.4";
    a.inputs = {
        {"first", InputSpec::Type::curve, "The curve at v = 0, of any kind and degree."},
        {"second", InputSpec::Type::curve, "The curve at v = 1, of any kind and degree."},
    };
    a.pseudo_code = {
        "make both curves compatible: one degree, one knot vector",
        "V = (0, 0, 1, 1)",
        "for each i",
        "  Q[i][0] = P[0][i], Q[i][1] = P[1][i]",
    };
    a.given_narration =
        "Two curves. For each u, a straight segment is to run from the point of the first to the point of the second.";
    a.values = {
        {"U", {"l", "j"}, "the knot j of curve l"},
        {"P", {"l", "i"}, "the control point i of curve l", 0, "", ValueSpec::Draw::level},
        {"V", {}, "the knots along the rulings", 2, "Along the rulings: V = {value}."},
        {"Q",
         {"i", "j"},
         "the surface's control point",
         4,
         "Row {i} of the net: the control points number {i} of both curves, {Q[i][0]} and {value}.",
         ValueSpec::Draw::net},
    };
    a.phases = {
        {"rulings", "Join the control points", 3,
         "Both curves now have equally many control points: those with the same number are joined. Along the joins "
         "the degree is 1."},
    };
    a.rules = {&rule_info<PutIntoNet>};
    add_compatible(a, 1);
    a.misconceptions = {
        {"reversed-curve", "the second curve is run through backwards",
         "Points of equal parameter are joined: the first control point of one curve with the first of the other. "
         "Joined crosswise, the surface is twisted.",
         reversed},
        {"ends-exchanged", "v = 0 and v = 1 are exchanged",
         "S(u, v) = (1 - v) C_0(u) + v C_1(u) is the first curve at v = 0, so column 0 of the net is the first curve.",
         exchanged},
        {"not-compatible", "the control points are joined before the curves are compatible",
         "Only control points over the same knots and of the same degree belong together: elevate the degree and "
         "insert the missing knots first.",
         not_compatible}};
    a.asks = {"W[*]", "Q[*][*]"};
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
