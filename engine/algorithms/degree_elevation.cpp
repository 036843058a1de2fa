#include "kernel/degree_elevation.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const int p = inputs.curve("curve").degree;
  if (p + inputs.integer("times") > max_degree)
    at("times").error("must be at most " + std::to_string(max_degree - p) + " here: the degree is " +
                      std::to_string(p) + " and may grow up to " + std::to_string(max_degree));
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return degree_elevation(inputs.curve("curve"), inputs.integer("times"), rec);
};

bool is_elevate(const Site& site) { return site.trace().value(site.value()).rule == &rule_info<Elevate>; }

Numbers<Exact> combine(NumbersView<Exact> a, NumbersView<Exact> A, NumbersView<Exact> B) { return blend(a, B, A); }

// i/p for i/(p+1)
std::vector<Numbers<Exact>> wrong_ratio(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<Fraction> || !(site.operand(1)[0] != Exact(1))) return {};
  return {{site.operand(0)[0] / (site.operand(1)[0] - Exact(1))}};
}

std::vector<Numbers<Exact>> swapped(const Site& site) {
  if (!is_elevate(site)) return {};
  return {combine(site.operand(0), site.operand(2), site.operand(1))};
}

// P[i+1] for P[i-1]
std::vector<Numbers<Exact>> wrong_neighbour(const Site& site) {
  if (!is_elevate(site)) return {};
  Name next = site.trace().value(site.trace().operands(site.value())[2]).name;
  ++next.index[next.arity - 1];
  const auto numbers = site.sibling_numbers(next);
  if (!numbers) return {};
  return {combine(site.operand(0), *numbers, site.operand(2))};
}

// Only the end knots are repeated; or none.
std::vector<Numbers<Exact>> knots_not_raised(const Site& site) {
  if (!(site.name() == "V"_v())) return {};
  const auto U = site.operand(2);
  const auto times = static_cast<std::size_t>(site.inputs().integer("times"));
  Numbers<Exact> ends(U.begin(), U.end());
  ends.insert(ends.begin(), times, U.front());
  ends.insert(ends.end(), times, U.back());
  return {ends, Numbers<Exact>(U.begin(), U.end())};
}

}  // namespace

const Algorithm& degree_elevation() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "degree_elevation";
    a.family = Family::curve_technique;
    a.title = "Degree elevation";
    a.summary = "The same curve with a higher degree and more control points.";
    a.source = "Shene, CS3621 notes, \"Degree Elevation of a Bézier Curve\"; The NURBS Book, 5.5";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A curve of any kind; clamped or not."},
        {"times", InputSpec::Type::integer, "By how much the degree is raised.", 1, max_degree - 1, {}, "1"},
    };
    a.pseudo_code = {
        "decompose the curve into Bézier segments (insert knots)",
        "for each segment, and each time",
        "  for i = 1 to p",
        "    alpha[i] = i / (p+1)",
        "    Q[i] = alpha[i] P[i-1] + (1-alpha[i]) P[i]",
        "  Q[0] = P[0], Q[p+1] = P[p]",
        "V = U with each knot repeated once more, each time",
        "Q[j] = f(v_{j+1}, ..., v_{j+q}), read from a segment",
    };
    a.given_narration =
        "A curve with the knots U = {U}. Its degree is to be raised by t = {t}; the curve stays the same.";
    a.values = {
        {"p", {}, "the degree before"},
        {"t", {}, "by how much it is raised"},
        {"q", {}, "the degree after this round"},
        {"i", {"i"}, "the index i"},
        {"U", {}, "the knot vector", 0, "Its knots are U = {value}."},
        {"U", {"i"}, "the knot u_i"},
        {"P", {"i"}, "the control point P_i", 0, "", ValueSpec::Draw::polygon},
        {"alpha", {"i"}, "the ratio i/(p+1)", 4, "alpha[{i}] = i / (p+1) = {result}."},
        {"E",
         {"j", "i"},
         "the point i of the elevated segment j",
         5,
         "Segment {j}: {name} = {chain}.",
         ValueSpec::Draw::level,
         false,
         {{"elevate_end", "", 6, "Segment {j}: an end stays where it is, {name} = {chain}."},
          {"elevate_end_v", "", 6, "Segment {j}: an end stays where it is, {name} = {chain}."}}},
        {"V",
         {},
         "the new knot vector",
         7,
         "Each knot of the domain is repeated once more for each elevation: V = {value}."},
        {"beta",
         {"r"},
         "where the argument lies relative to the segment",
         8,
         "beta[{r}] = {chain}: where the argument lies on the segment's line."},
        {"R",
         {"r", "i"},
         "a blossom value on the way to Q[j]",
         8,
         "{name} = {chain}, the blossom value {polar}.",
         ValueSpec::Draw::point},
        {"Q",
         {"i"},
         "the new control point Q_i",
         5,
         "{name} = {chain}, the blossom value {polar}.",
         ValueSpec::Draw::polygon,
         false,
         {{"elevate_end", "", 6, "The end stays where it is: {name} = {chain}."},
          {"elevate_end_v", "", 6, "The end stays where it is: {name} = {chain}."},
          {"same", "", 8},
          {"blend", "", 8}}},
    };
    a.phases = {
        {"decompose", "Decompose into Bézier segments", 1,
         "First the curve falls into Bézier segments: each knot of the domain is inserted until it has multiplicity "
         "p."},
        {"knot", "Insert knot {index}", 1, "Insert knot number {index} until it has full multiplicity."},
        {"elevate", "Elevate each segment", 2, "Now each Bézier segment is elevated by the Bézier formula."},
        {"round", "Elevation {index}", 2, "Elevation number {index}: one degree higher."},
        {"recompose", "Recompose", 7,
         "The knots inserted before are not needed: the control points over the new knots are read off."},
        {"point", "Control point {index}", 8,
         "Control point {index} has arguments beyond one segment: they are put in one after the other."},
    };
    a.rules = {&rule_info<Fraction>,     &rule_info<Elevate>, &rule_info<ElevateEnd>, &rule_info<ElevateKnots>,
               &rule_info<Multiplicity>, &rule_info<Ratio>,   &rule_info<Blend>,      &rule_info<Same>};
    a.misconceptions = {
        {"elevation-ratio", "the ratio is i/p instead of i/(p+1)",
         "The new polygon has p+1 segments, so its points divide the old ones at i/(p+1).", wrong_ratio},
        {"swapped-weights", "the weights are swapped",
         "Q[i] = i/(p+1) P[i-1] + (1 - i/(p+1)) P[i]: the earlier point gets i/(p+1).", swapped},
        {"wrong-pair", "the wrong neighbour is taken",
         "Q[i] lies between P[i-1] and P[i], not between P[i] and P[i+1].", wrong_neighbour},
        {"knots-not-raised", "the inner knots are not repeated",
         "Raising the degree keeps the smoothness at each knot only if every knot's multiplicity grows with it.",
         knots_not_raised},
        missing_division(),
        unweighted_points()};
    a.asks = {"alpha[*]", "Q[*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
