#include "kernel/circular_arc.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const Exact& radius = inputs.number("radius");
  if (!(radius.to_double() > 0)) at("radius").error("must be above 0, not " + format_brief(radius));
  if (inputs.points("center").dimension != 2) at("center").error("must be a point of the plane, [x, y]");
  const Exact& start = inputs.number("start");
  const Exact& end = inputs.number("end");
  for (const auto& [name, angle] : {std::pair<std::string_view, const Exact&>("start", start), {"end", end}})
    if (std::abs(angle.to_double()) > 720)
      at(name).error("is an angle in degrees, from -720 to 720, not " + format_brief(angle));
  if (!((end - start).to_double() > 0) || Exact(360) < end - start)
    at("end").error("must be above the start, " + format_brief(start) + ", and at most 360 degrees further, not " +
                    format_brief(end));
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return circular_arc(inputs.points("center"), inputs.number("radius"), inputs.number("start"), inputs.number("end"),
                      rec);
};

// The arc is seen from the beginning.
std::vector<Curve<double>> pictured(const Inputs<double>& inputs) {
  NoRecorder<double> plain;
  return {circular_arc(inputs.points("center"), inputs.number("radius"), inputs.number("start"), inputs.number("end"),
                       plain)};
}

bool is_corner(const Site& site) { return site.trace().value(site.value()).rule == &rule_info<TangentCorner>; }

// O + f r (c, s) with a weight, homogeneous.
Numbers<Exact> around(const Site& site, const Exact& f, const Exact& weight) {
  const auto O = site.operand(0);
  const Exact r = f * site.operand(1)[0];
  return {weight * (O[0] + r * site.operand(2)[0]), weight * (O[1] + r * site.operand(3)[0]), weight * O[2], weight};
}

// The corner counts as much as the ends.
std::vector<Numbers<Exact>> equal_weights(const Site& site) {
  if (!is_corner(site) || site.operand(4)[0] == Exact(0)) return {};
  return {around(site, Exact(1) / site.operand(4)[0], Exact(1))};
}

// A control point on the circle where the corner of the tangents is meant.
std::vector<Numbers<Exact>> corner_on_circle(const Site& site) {
  if (!is_corner(site)) return {};
  return {around(site, Exact(1), site.operand(4)[0])};
}

// The cosine of the whole angle of a piece for that of its half.
std::vector<Numbers<Exact>> whole_angle(const Site& site) {
  if (!(site.name() == "w"_v())) return {};
  const Exact angle = Exact(2) * site.operand(0)[0];
  if (!Cosine::defined(angle)) return {};
  return {{Cosine::apply(angle)}};
}

// The angles of a piece's ends given to the corners, too: steps of 2 h.
std::vector<Numbers<Exact>> whole_steps(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<ArcAngle>) return {};
  return {{site.operand(0)[0] + Exact(2) * site.operand(1)[0] * site.operand(2)[0]}};
}

}  // namespace

const Algorithm& circular_arc() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "circular_arc";
    a.family = Family::fitting;
    a.title = "Circular arc";
    a.summary = "An arc or a full circle as a rational quadratic curve of one to four pieces.";
    a.source = "The NURBS Book, 7.5, A7.1; Shene, CS3621 notes, \"Circular Arcs and Circles\"";
    a.inputs = {
        {"radius", InputSpec::Type::number, "The radius, above 0.", 0, 0, {}, "1"},
        {"start", InputSpec::Type::number, "The angle at which the arc begins, in degrees.", 0, 0, {}, "0"},
        {"end", InputSpec::Type::number, "The angle at which it ends, at most 360 degrees further."},
        {"center", InputSpec::Type::points, "One point of the plane: the centre.", 1, 1, {}, "[[0, 0]]"},
    };
    a.pseudo_code = {
        "theta = end - start",
        "n = theta / 90, rounded up",
        "h = theta / (2 n), w = cos(h)",
        "U = 0, 0, 0, 1/n, 1/n, .., 1, 1, 1",
        "for j = 0 to 2n",
        "  t[j] = start + j h",
        "  j even: P[j] = O + r (cos t[j], sin t[j]), weight 1",
        "  j odd:  P[j] = O + r/w (cos t[j], sin t[j]), weight w",
    };
    a.given_narration = "A circular arc of radius r = {r} from {alpha} to {beta} degrees, about the point {O}.";
    a.values = {
        {"O", {}, "the centre", 0, "", ValueSpec::Draw::point},
        {"r", {}, "the radius"},
        {"alpha", {}, "the angle at the start, in degrees"},
        {"beta", {}, "the angle at the end, in degrees"},
        {"theta", {}, "the angle of the whole arc", 1, "The arc has theta = {chain} degrees."},
        {"n",
         {},
         "the number of pieces",
         2,
         "A piece may have at most 90 degrees, so {theta} degrees need n = {value} of them."},
        {"h", {}, "half of the angle of a piece", 3, "Half of a piece has h = {chain} degrees."},
        {"w", {}, "the weight of the corners", 3, "The weight of a corner between two ends: w = {chain}."},
        {"U", {}, "the knots", 4, "The knots: U = {value}. At an inner knot, twice there, two pieces meet."},
        {"j", {"j"}, "the index j"},
        {"t", {"j"}, "the angle of control point j", 6, "t[{j}] = {chain} degrees."},
        {"c", {"j"}, "the cosine of t[j]", 6, "c[{j}] = {chain}."},
        {"s", {"j"}, "the sine of t[j]", 6, "s[{j}] = {chain}."},
        {"P",
         {"j"},
         "the control point j",
         7,
         "An end of a piece lies on the circle, with the weight 1: {name} = {value}.",
         ValueSpec::Draw::polygon,
         false,
         {{"tangent_corner", "", 8,
           "The tangents at both ends of the piece meet at {t[j]} degrees, r/w away from the centre: {name} = "
           "{value}."}}},
    };
    a.phases = {{"point", "Control point {index}", 5, "Control point number {index}: which angle belongs to it?"}};
    a.rules = {&rule_info<Sweep>,    &rule_info<CountArcs>,   &rule_info<HalfArc>,
               &rule_info<Cosine>,   &rule_info<Sine>,        &rule_info<ArcKnots>,
               &rule_info<ArcAngle>, &rule_info<CirclePoint>, &rule_info<TangentCorner>};
    a.misconceptions = {
        {"equal-weights", "the corners get the same weight as the ends",
         "With equal weights the pieces are parabolas. A circle needs the weight cos(h) at a corner, h half the angle "
         "of a piece.",
         equal_weights},
        {"corner-on-circle", "the corners are put on the circle",
         "A middle control point is where the tangents at both ends of the piece meet: outside of the circle, r/w from "
         "the centre.",
         corner_on_circle},
        {"whole-angle", "the cosine of the whole angle of a piece is taken",
         "The weight of a corner is the cosine of half the angle of a piece.", whole_angle},
        {"whole-steps", "the angle grows by a whole piece from one control point to the next",
         "From an end to the corner it is half a piece only: t[j] = start + j h.", whole_steps}};
    a.asks = {"n", "h", "w", "t[*]", "P[*]"};
    a.check = check;
    a.pictured = pictured;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
