#include "kernel/swung.hpp"

#include "algorithms/construction.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const auto& profile = inputs.curve("profile");
  const auto& trajectory = inputs.curve("trajectory");
  const auto off = [](const Curve<Exact>& curve, int c) {
    return std::ranges::find_if(curve.points, [c](const auto& P) { return P[c] != Exact(0); }) - curve.points.begin();
  };
  if (const auto i = off(profile, 1); profile.dimension == 3 && i <= profile.n())
    at("profile").error("must lie in the xz-plane, but y is not 0 at its control point " + std::to_string(i) +
                        "; a profile given in the plane stands there by itself");
  if (const auto j = off(trajectory, 2); j <= trajectory.n())
    at("trajectory").error("must lie in the xy-plane, but z is not 0 at its control point " + std::to_string(j));
  if (inputs.number("scale").to_double() == 0)
    at("scale").error("must not be 0: all points would come to lie on the axis");
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return swung(inputs.curve("profile"), inputs.curve("trajectory"), inputs.number("scale"), rec);
};

bool in_net(const Site& site) { return site.trace().value(site.value()).rule == &rule_info<Swing>; }

// The profile is moved along the trajectory, instead of stretched by it.
std::vector<Numbers<Exact>> added(const Site& site) {
  if (!in_net(site)) return {};
  const auto P = site.operand(0), T = site.operand(1);
  return {{P[0] * T[3] + T[0] * P[3], P[1] * T[3] + T[1] * P[3], P[2] * T[3], P[3] * T[3]}};
}

// The height is scaled as well.
std::vector<Numbers<Exact>> height_scaled(const Site& site) {
  if (!in_net(site)) return {};
  const auto P = site.operand(0), T = site.operand(1);
  const Exact a = site.operand(2)[0];
  return {{a * P[0] * T[0], a * P[0] * T[1], a * P[2] * T[3], P[3] * T[3]}};
}

// The weights are added: the same point, with the weight P.w + T.w.
std::vector<Numbers<Exact>> weights_added(const Site& site) {
  if (!in_net(site) || !site.trace().rational) return {};
  const auto P = site.operand(0), T = site.operand(1);
  if (P[3] == Exact(0) || T[3] == Exact(0)) return {};
  const Exact a = site.operand(2)[0], w = P[3] + T[3], x = P[0] / P[3];
  return {{w * a * x * T[0] / T[3], w * a * x * T[1] / T[3], w * P[2] / P[3], w}};
}

}  // namespace

const Algorithm& swung() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "swung";
    a.family = Family::construction;
    a.title = "Swung surface";
    a.summary = "A profile swung about the z-axis along a trajectory that stretches it on its way.";
    a.source = "The NURBS Book, 10.2; Shene, CS3621 notes, \"Swung Surfaces\"";
    a.inputs = {
        {"profile", InputSpec::Type::curve,
         "The curve that is swung, in the xz-plane. Given in the plane, (x, y) means (x, 0, y)."},
        {"trajectory", InputSpec::Type::curve, "The curve it is swung along, in the xy-plane."},
        {"scale", InputSpec::Type::number, "A factor for all distances from the axis, not 0.", 0, 0, {}, "1"},
    };
    a.pseudo_code = {
        "for each control point P[i] of the profile",
        "  for each control point T[j] of the trajectory",
        "    Q[i][j] = (a Px Tx, a Px Ty, Pz)",
        "    with the weight of P[i] times that of T[j]",
    };
    a.given_narration =
        "A profile in the xz-plane and a trajectory in the xy-plane. How far the trajectory is from the axis says how "
        "much the profile is stretched there, times a = {a}.";
    a.values = {
        {"a", {}, "the scale"},
        {"U", {"i"}, "the knot i of the profile"},
        {"V", {"j"}, "the knot j of the trajectory"},
        {"P", {"i"}, "the control point i of the profile", 0, "", ValueSpec::Draw::polygon},
        {"T", {"j"}, "the control point j of the trajectory", 0, "", ValueSpec::Draw::polygon},
        {"G",
         {"i"},
         "the control point i of the profile, upright in space",
         1,
         "(x, y) stands for (x, 0, y).",
         ValueSpec::Draw::polygon},
        {"Q",
         {"i", "j"},
         "the surface's control point",
         3,
         "The point {@0} of the profile keeps its height and is stretched by {a} times the point {@1} of the "
         "trajectory: "
         "{name} = {value}.",
         ValueSpec::Draw::net},
    };
    a.phases = {
        {"upright", "Stand the profile up", 1, "The profile is drawn in the plane and stands upright in space."},
        {"row", "Control point {index} of the profile", 1,
         "Control point {index} of the profile keeps its height and runs along a copy of the trajectory, scaled by its "
         "distance from the axis."},
    };
    a.rules = {&rule_info<StandUp>, &rule_info<Swing>};
    a.misconceptions = {
        {"added", "the profile is moved along the trajectory instead of stretched by it",
         "A swung surface multiplies: Px Tx and Px Ty. Adding P and T gives a translational sweep.", added},
        {"height-scaled", "the height is scaled, too",
         "The scale a stretches across the axis only: the height Pz stays as it is.", height_scaled},
        {"weights-added", "the weights are added",
         "The point is a product of two rational functions, so the weights are multiplied.", weights_added}};
    a.asks = {"Q[*][*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
