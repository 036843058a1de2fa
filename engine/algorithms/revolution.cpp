#include "kernel/revolution.hpp"

#include "algorithms/construction.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const Exact& angle = inputs.number("angle");
  if (!(angle.to_double() > 0) || angle > Exact(360))
    at("angle").error("must be above 0 and at most 360 degrees, not " + format_brief(angle));
  const auto& axis = inputs.points("axis").points;
  bool differ = false;
  for (int c = 0; c < 3; ++c) differ = differ || axis[0][c].to_double() != axis[1][c].to_double();
  if (!differ) at("axis").error("needs two points that differ: they say where the axis runs");
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return revolution(inputs.curve("profile"), inputs.points("axis"), inputs.number("angle"), rec);
};

bool is_corner(const Site& site) { return site.trace().value(site.value()).rule == &rule_info<CircleCorner>; }

// The corner counts as much as the ends of the arc: its weight is not multiplied by cos(h).
std::vector<Numbers<Exact>> equal_weights(const Site& site) {
  if (!is_corner(site)) return {};
  const Exact w = site.operand(5)[0];
  if (w == Exact(0)) return {};
  const auto O = site.operand(0), X = site.operand(1), Y = site.operand(2);
  const Exact c = site.operand(3)[0], s = site.operand(4)[0];
  Numbers<Exact> made;
  for (std::size_t i = 0; i < 4; ++i) made.push_back(O[i] + (c * X[i] + s * Y[i]) / w);
  return {made};
}

// A control point on the circle where the corner of the tangents is meant.
std::vector<Numbers<Exact>> corner_on_circle(const Site& site) {
  if (!is_corner(site)) return {};
  const auto O = site.operand(0), X = site.operand(1), Y = site.operand(2);
  const Exact c = site.operand(3)[0], s = site.operand(4)[0], w = site.operand(5)[0];
  Numbers<Exact> made;
  for (std::size_t i = 0; i < 4; ++i) made.push_back(w * (O[i] + c * X[i] + s * Y[i]));
  return {made};
}

// Turned the other way round.
std::vector<Numbers<Exact>> clockwise(const Site& site) {
  const RuleInfo* rule = site.trace().value(site.value()).rule;
  if (rule != &rule_info<OnCircle> && !is_corner(site)) return {};
  const auto O = site.operand(0), X = site.operand(1), Y = site.operand(2);
  const Exact c = site.operand(3)[0], s = site.operand(4)[0];
  const Exact w = is_corner(site) ? site.operand(5)[0] : Exact(1);
  Numbers<Exact> made;
  for (std::size_t i = 0; i < 4; ++i) made.push_back(w * O[i] + c * X[i] - s * Y[i]);
  return {made};
}

}  // namespace

const Algorithm& revolution() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "revolution";
    a.family = Family::construction;
    a.title = "Surface of revolution";
    a.summary = "A profile turned about an axis: circles across it, exact as a NURBS surface.";
    a.source = "The NURBS Book, 8.5, A8.1; Shene, CS3621 notes, \"Surfaces of Revolution\"";
    a.inputs = {
        {"profile", InputSpec::Type::curve,
         "The curve that is turned. Given in the plane it stands in the xz-plane: (x, y) means (x, 0, y)."},
        {"axis",
         InputSpec::Type::points,
         "Two points of the axis; in the plane like the profile. The z-axis when left out.",
         2,
         2,
         {},
         "[[0, 0, 0], [0, 0, 1]]"},
        {"angle",
         InputSpec::Type::number,
         "By how many degrees it is turned, above 0 and at most 360.",
         0,
         0,
         {},
         "360"},
    };
    a.pseudo_code = {
        "n = angle / 90, rounded up",
        "h = angle / (2 n), w = cos(h)",
        "c[i] = cos(i h), s[i] = sin(i h), i = 0..2n",
        "for each control point P[j] of the profile",
        "  O = foot of P[j] on the axis, X = P[j] - O",
        "  Y = X turned by 90 degrees",
        "  for i = 0, 2, ..: Q[i][j] = O + c[i] X + s[i] Y",
        "  for i = 1, 3, ..: Q[i][j] = w O + c[i] X + s[i] Y",
    };
    a.given_narration = "A profile is to be turned by {theta} degrees about the axis through {A[0]} and {A[1]}.";
    a.values = {
        {"theta", {}, "the angle, in degrees"},
        {"A", {"i"}, "a point of the axis", 0, "", ValueSpec::Draw::polygon},
        {"V", {"j"}, "the knot j of the profile"},
        {"P", {"j"}, "the control point j of the profile", 0, "", ValueSpec::Draw::polygon},
        {"G",
         {"j"},
         "the control point j of the profile, upright in space",
         5,
         "(x, y) stands for (x, 0, y).",
         ValueSpec::Draw::polygon},
        {"B",
         {"i"},
         "a point of the axis, upright in space",
         5,
         "(x, y) stands for (x, 0, y).",
         ValueSpec::Draw::polygon},
        {"n", {}, "the number of arcs", 1, "An arc may have at most 90 degrees: {theta} degrees make {value}."},
        {"h", {}, "half of the angle of an arc", 2, "Half an arc is h = {chain} degrees."},
        {"w", {}, "the weight factor of the corners", 2, "The corners between the arcs get the weight w = {chain}."},
        {"i", {"i"}, "the index i"},
        {"t", {"i"}, "the angle of row i", 3, "{name} = {result}."},
        {"c", {"i"}, "the cosine of the angle of row i", 3, "{name} = {chain}."},
        {"s",
         {"i"},
         "the sine of the angle of row i",
         3,
         "Row {i} of the net is at {t[i]} degrees: c[{i}] = {c[i]}, s[{i}] = {value}."},
        {"U", {}, "the knots along the circles", 3, "The knots along the circles: U = {value}."},
        {"L",
         {},
         "the length of the axis as it is given",
         6,
         "The two points that give the axis have the distance {value}."},
        {"O",
         {},
         "the centre of the circle: the nearest point of the axis",
         5,
         "The centre of its circle is the foot on the axis: {name} = {value}.",
         ValueSpec::Draw::point},
        {"X", {}, "from the centre to the point", 5, "The vector from there to the point: {name} = {value}."},
        {"Y", {}, "the same, turned by 90 degrees", 6, "Turned by 90 degrees about the axis: {name} = {value}."},
        {"Q",
         {"i", "j"},
         "the surface's control point",
         7,
         "At {t[i]} degrees: {name} = {chain}.",
         ValueSpec::Draw::net,
         false,
         {{"circle_corner", "", 8,
           "Between two arcs, at {t[i]} degrees, the corner of the tangents with the weight factor w: {name} = "
           "{chain}."}}},
    };
    a.phases = {
        {"upright", "Stand the profile up", 5, "The profile is drawn in the plane and stands upright in space."},
        {"axis", "Stand the axis up", 5, "The axis is given in the plane, too, and stands upright like the profile."},
        {"arcs", "Divide the angle into arcs", 1,
         "Every control point is going to run on the same circular arcs. How many, and at which angles?"},
        {"turn", "Turn the control points", 4, "Now each control point of the profile is turned about the axis."},
        {"circle", "Control point {index}", 4, "The circle of control point number {index}."},
    };
    a.rules = {&rule_info<StandUp>,     &rule_info<CountArcs>, &rule_info<HalfArc>,     &rule_info<AngleTimes>,
               &rule_info<Cosine>,      &rule_info<Sine>,      &rule_info<ArcKnots>,    &rule_info<Distance>,
               &rule_info<Foot>,        &rule_info<Spoke>,     &rule_info<QuarterTurn>, &rule_info<OnCircle>,
               &rule_info<CircleCorner>};
    a.misconceptions = {
        {"equal-weights", "the corners get the same weight as the ends of the arcs",
         "With equal weights the arcs are parabolas. A circle needs the corner's weight times cos(h), h half the arc.",
         equal_weights},
        {"corner-on-circle", "the corners are put on the circle",
         "A middle control point is where the tangents at both ends of the arc meet, outside of the circle.",
         corner_on_circle},
        {"clockwise", "the profile is turned the other way round",
         "Seen from the tip of the axis the profile turns counterclockwise: + sin Y, Y = axis direction x X.",
         clockwise}};
    a.asks = {"n", "w", "Q[*][*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
