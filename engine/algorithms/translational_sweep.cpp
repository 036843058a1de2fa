#include "kernel/translational_sweep.hpp"

#include "algorithms/construction.hpp"

namespace blossom {
namespace {

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return translational_sweep(inputs.curve("profile"), inputs.curve("trajectory"), rec);
};

bool in_net(const Site& site) { return site.trace().value(site.value()).rule == &rule_info<MoveAlong>; }

// The homogeneous coordinates added, weights and all.
std::vector<Numbers<Exact>> homogeneous_sum(const Site& site) {
  if (!in_net(site) || !site.trace().rational) return {};
  const auto P = site.operand(0), T = site.operand(1);
  Numbers<Exact> made;
  for (std::size_t c = 0; c < 4; ++c) made.push_back(P[c] + T[c]);
  return {made};
}

// Only the weight of the profile's point, as though the trajectory were polynomial.
std::vector<Numbers<Exact>> one_weight(const Site& site) {
  if (!in_net(site)) return {};
  const auto P = site.operand(0), T = site.operand(1);
  if (T[3] == Exact(0)) return {};
  Numbers<Exact> made;
  for (std::size_t c = 0; c < 3; ++c) made.push_back(P[c] + P[3] * T[c] / T[3]);
  made.push_back(P[3]);
  return {made};
}

// Rows and columns exchanged.
std::vector<Numbers<Exact>> transposed(const Site& site) {
  if (!in_net(site)) return {};
  const auto there = site.sibling("Q"_v(site.name().index[1], site.name().index[0]));
  if (!there) return {};
  const auto operands = site.trace().operands(*there);
  const auto P = site.numbers(operands[0]), T = site.numbers(operands[1]);
  Numbers<Exact> made;
  for (std::size_t c = 0; c < 3; ++c) made.push_back(T[3] * P[c] + P[3] * T[c]);
  made.push_back(P[3] * T[3]);
  return {made};
}

}  // namespace

const Algorithm& translational_sweep() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "translational_sweep";
    a.family = Family::construction;
    a.title = "Translational sweep";
    a.summary = "A profile moved along a trajectory without turning.";
    a.source = "The NURBS Book, 10.4; Shene, CS3621 notes, \"Swept Surfaces\"";
    a.inputs = {
        {"profile", InputSpec::Type::curve,
         "The curve that is moved. Given in the plane it stands in the xz-plane: (x, y) means (x, 0, y)."},
        {"trajectory", InputSpec::Type::curve, "The curve it is moved along; in the plane: in the xy-plane."},
    };
    a.pseudo_code = {
        "for each control point T[j] of the trajectory",
        "  for each control point P[i] of the profile",
        "    Q[i][j] = P[i] + T[j]",
        "    with the weight of P[i] times that of T[j]",
    };
    a.given_narration =
        "A profile P(u) and a trajectory T(v). The surface S(u, v) = T(v) + P(u) has a copy of the profile at every "
        "point of the trajectory.";
    a.values = {
        {"U", {"i"}, "the knot i of the profile"},
        {"V", {"j"}, "the knot j of the trajectory"},
        {"P", {"i"}, "the control point i of the profile", 0, "", ValueSpec::Draw::polygon},
        {"T", {"j"}, "the control point j of the trajectory", 0, "", ValueSpec::Draw::polygon},
        {"G",
         {"i"},
         "the control point i of the profile, upright in space",
         2,
         "(x, y) stands for (x, 0, y).",
         ValueSpec::Draw::polygon},
        {"Q",
         {"i", "j"},
         "the surface's control point",
         3,
         "The point {@0} of the profile, moved by {@1}: {name} = {value}.",
         ValueSpec::Draw::net},
    };
    a.phases = {
        {"upright", "Stand the profile up", 2, "The profile is drawn in the plane and stands upright in space."},
        {"column", "Control point {index} of the trajectory", 1,
         "The whole control polygon of the profile is moved by control point {index} of the trajectory."},
    };
    a.rules = {&rule_info<StandUp>, &rule_info<MoveAlong>};
    a.misconceptions = {
        {"homogeneous-sum", "the homogeneous coordinates are added",
         "It is the points that are added, and the weights that are multiplied: (Tw P + Pw T, Pw Tw).",
         homogeneous_sum},
        {"one-weight", "the trajectory's weight is left out",
         "The net's weight is the product of both weights, that of the profile and that of the trajectory.",
         one_weight},
        {"transposed", "rows and columns of the net are exchanged",
         "The profile runs along u: the first index counts its control points, the second those of the trajectory.",
         transposed}};
    a.asks = {"Q[*][*]"};
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
