#include "kernel/sweep.hpp"

#include "algorithms/construction.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  if (inputs.integer("sections") == 1)
    at("sections").error("must be 0 (as many as the tolerance needs) or from 2 to 64, not 1");
  if (!(inputs.number("tolerance").to_double() > 0))
    at("tolerance").error("must be above 0, not " + format_brief(inputs.number("tolerance")));
  const auto& trajectory = inputs.curve("trajectory");
  for (const Exact& v : trajectory.knots)
    if (trajectory.domain_begin() < v && v < trajectory.domain_end() &&
        multiplicity<Exact>(trajectory.knots, v) > trajectory.degree) {
      at("trajectory")
          .error("must be connected, but at the knot " + format_brief(v) +
                 " it may jump: its multiplicity is above the degree");
      return;
    }
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return sweep(inputs.curve("profile"), inputs.curve("trajectory"), inputs.choice("frame") == "fixed",
               inputs.integer("sections"), inputs.number("tolerance"), rec);
};

// The derivative itself where the direction is meant.
std::vector<Numbers<Exact>> not_unit(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<UnitTangent>) return {};
  const auto C = site.operand(0), E = site.operand(1);
  if (C[3] == Exact(0)) return {};
  Numbers<Exact> made;
  for (std::size_t i = 0; i < 3; ++i) made.push_back((E[i] * C[3] - C[i] * E[3]) / (C[3] * C[3]));
  made.emplace_back(0);
  return {made};
}

// The binormal on the wrong side. It shows in where the profile goes: in the vector itself it is a wrong sign, which
// might be a slip.
std::vector<Numbers<Exact>> left_handed(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<PlaceInFrame>) return {};
  const auto P = site.operand(0), X = site.operand(1), t = site.operand(2), n = site.operand(3), b = site.operand(4);
  Numbers<Exact> made;
  for (std::size_t c = 0; c < 3; ++c) made.push_back(P[3] * X[c] + P[0] * n[c] - P[1] * b[c] + P[2] * t[c]);
  made.push_back(P[3]);
  return {made};
}

// The profile is moved, but not turned.
std::vector<Numbers<Exact>> not_turned(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<PlaceInFrame>) return {};
  const auto P = site.operand(0), X = site.operand(1);
  return {{P[0] + P[3] * X[0], P[1] + P[3] * X[1], P[2] + P[3] * X[2], P[3]}};
}

}  // namespace

const Algorithm& sweep() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "sweep";
    a.family = Family::construction;
    a.title = "Sweep with a moving frame";
    a.summary = "A profile moved along a trajectory and turned with it, approximated by a skin to a known error.";
    a.source =
        "The NURBS Book, 10.4; Wang, Jüttler, Zheng and Liu, \"Computation of rotation minimizing frames\", 2008";
    a.inputs = {
        {"profile", InputSpec::Type::curve,
         "The curve that is moved: x along the normal, y along the binormal, z (if there is one) along the tangent. At "
         "the beginning the binormal is as near to the z-axis as it can be."},
        {"trajectory", InputSpec::Type::curve, "The curve it is moved along. It must have a tangent everywhere."},
        {"frame",
         InputSpec::Type::choice,
         "Whether the profile turns with the tangent, as little as possible otherwise, or keeps its first place.",
         0,
         0,
         {"rotation-minimising", "fixed"},
         "\"rotation-minimising\""},
        {"sections",
         InputSpec::Type::integer,
         "How many sections are placed, 2 to 64, more if the trajectory has more knots; 0: as many as the tolerance "
         "needs.",
         0,
         most_sections,
         {},
         "8"},
        {"tolerance",
         InputSpec::Type::number,
         "With sections = 0: how large the error may be halfway between the sections.",
         0,
         0,
         {},
         "\"1/100\""},
    };
    a.pseudo_code = {
        "v = the knots of the trajectory and places between",
        "for each section l",
        "  X = T(v_l), t = T'(v_l) / |T'(v_l)|",
        "  if l = 0: n = z x t, of length 1; b = t x n",
        "  else: a = X - X before; mirror n and t across a",
        "        d = t - mirrored t; mirror n across d; b = t x n",
        "  R[l][i] = X + x n + y b of each control point P[i]",
        "skin the sections R[l] at v_l",
        "error = distance from the sweep between the sections",
    };
    a.given_narration =
        "A profile and a trajectory. The profile is to be moved along the trajectory and turned with it.";
    a.values = {
        {"tol", {}, "the tolerance"},
        {"U", {"i"}, "the knot i of the profile"},
        {"P", {"i"}, "the control point i of the profile", 0, "", ValueSpec::Draw::polygon},
        {"V", {"j"}, "the knot j of the trajectory"},
        {"T", {"j"}, "the control point j of the trajectory", 0, "", ValueSpec::Draw::polygon},
        {"U", {}, "the trajectory's knots as one vector", 1, "Its knot vector so far: {value}."},
        {"p", {}, "the degree of the trajectory"},
        {"V", {}, "the knots of the trajectory as one vector", 1, "The trajectory has the knots {value}."},
        {"m", {}, "the number of parts between two knots"},
        {"i", {"l"}, "a whole number: a part between two knots, or an index"},
        {"v", {"l"}, "the parameter of section l", 1, "Section {l} stands at {name} = {value}."},
        {"v", {}, "the parameter in the middle", 9, "Halfway between the two sections: v = {value}."},
        {"k", {}, "the span of the trajectory", 3, "This parameter lies in the span k = {value}."},
        {"j", {"j"}, "the index j"},
        {"N", {"j"}, "the basis function j of the trajectory", 3, "{name} = {result}."},
        {"D", {"j"}, "the derivative of that basis function", 3, "Its derivative is {value}."},
        {"C", {"j"}, "the sum that makes the point", 3, "Summed up for the point so far: {~C[j]}."},
        {"E", {"j"}, "the sum that makes the derivative", 3, "Summed up for the derivative so far: {~E[j]}."},
        {"X", {}, "the place of the section", 3, "The section stands at X = {value}.", ValueSpec::Draw::point},
        {"t", {}, "the tangent, of length 1", 3, "The direction there: t = {value}."},
        {"a", {}, "from the place before", 5, "From the place before to this one: a = {value}."},
        {"nm", {}, "the normal, mirrored once", 5, "The normal before, mirrored in the plane across a: {value}."},
        {"tm", {}, "the tangent before, mirrored", 5, "The tangent before, mirrored likewise: {value}."},
        {"d",
         {},
         "what the mirrored tangent lacks",
         6,
         "The mirrored tangent is not the new one yet. The difference: d = {value}."},
        {"n",
         {},
         "the normal",
         6,
         "Mirrored once more, across d, the normal fits the new tangent: n = {value}.",
         ValueSpec::Draw::none,
         false,
         {{"first_normal", "", 4, "The first normal is horizontal: n = {value}."}}},
        {"b", {}, "the binormal", 6, "The binormal completes the frame: b = t × n = {value}."},
        {"R",
         {"l", "i"},
         "the control point i of section l",
         7,
         "{@0} of the profile goes to {#R[l][i]} = {value}.",
         ValueSpec::Draw::net},
        {"q", {}, "the degree across the sections"},
        {"W", {}, "the knots across the sections", 9, "The knots across the sections are {value}."},
        {"M", {"j"}, "the basis function j of the surface across the sections", 9, "{name} = {result}."},
        {"A",
         {"i", "j"},
         "the sum that makes row i of the surface at v",
         9,
         "Summed up for row {i} so far: {~A[i][j]}."},
        {"B",
         {"i"},
         "where the control point i of the profile belongs",
         9,
         "It should be at {value}.",
         ValueSpec::Draw::point},
        {"e",
         {"l"},
         "how far the surface is from the sweep",
         9,
         "That is {value} away.",
         ValueSpec::Draw::none,
         false,
         {{"largest", "", 0, "Between sections {l} and {l+1} the surface is up to {value} away."}}},
        {"e", {}, "the largest of all distances", 9, "Nowhere halfway between two sections is it more: {value}."},
        {"error",
         {},
         "the error of the surface",
         9,
         "Halfway between the sections the surface is at most {value} away from the true sweep."},
        {"Q", {"i", "j"}, "the surface's control point", 8, "The control net of the surface.", ValueSpec::Draw::net},
    };
    a.phases = {
        {"clamp", "Clamp the trajectory", 1, "The trajectory is not clamped: its domain's ends are inserted."},
        {"end", "End {index}", 1, "Insert the end of the domain until it has full multiplicity."},
        {"attempt", "Attempt {index}", 1, "Place sections, skin them, and measure how far the skin is from the sweep."},
        {"parameters", "Parameters of the sections", 1,
         "Where do sections stand? At each knot of the trajectory, and evenly spaced between."},
        {"sections", "Place the sections", 2, "Now the profile is placed along the trajectory."},
        {"section", "Section {index}", 2, "Section {index}: find the place and the frame, then place the profile."},
        {"skin", "Skin the sections", 8, "A surface is put through the sections, as in skinning."},
        {"errors", "Measure the error", 9,
         "The surface is right at the sections. How far off is it between them? We look halfway."},
        {"middle", "Between sections {index} and the next", 9,
         "Compare the surface with the true sweep between section {index} and the next."},
        {"result", "The result", 9, "What has been made, and how good is it?"},
    };
    a.rules = {&rule_info<Gather>,       &rule_info<SameNumber>,   &rule_info<SpanShare>,    &rule_info<FindSpan>,
               &rule_info<BasisValue>,   &rule_info<BasisSlope>,   &rule_info<WeighPoint>,   &rule_info<AddWeighed>,
               &rule_info<Project>,      &rule_info<UnitTangent>,  &rule_info<FirstNormal>,  &rule_info<Towards>,
               &rule_info<MirrorVector>, &rule_info<CrossProduct>, &rule_info<PlaceInFrame>, &rule_info<Mean>,
               &rule_info<Distance>,     &rule_info<Largest>,      &rule_info<PutIntoNet>};
    a.misconceptions = {
        {"not-unit", "the derivative is taken as the tangent, whatever its length",
         "The vectors of the frame have length 1: divide the derivative by its length.", not_unit},
        {"left-handed", "the binormal points to the wrong side",
         "b = t × n, not n × t: otherwise the profile is mirrored.", left_handed},
        {"not-turned", "the profile is moved, but not turned",
         "The profile's x is measured along the normal and its y along the binormal of the section's frame.",
         not_turned}};
    a.asks = {"v[*]", "R[*][*]", "attempt[*].v[*]", "attempt[*].R[*][*]", "error"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
