#include "kernel/subdivision.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  if (!check_parameter(inputs, at)) return;
  const auto& curve = inputs.curve("curve");
  const Exact& u = inputs.number("u");
  if (u == curve.domain_begin() || u == curve.domain_end())
    at("u").error("is an end of the domain: to cut the curve in two, choose u between " +
                  format_brief(curve.domain_begin()) + " and " + format_brief(curve.domain_end()));
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return subdivision(inputs.curve("curve"), inputs.number("u"), rec);
};

// The new end with the multiplicity p that insertion gives it, not p + 1.
std::vector<Numbers<Exact>> open_end(const Site& site) {
  const bool left = site.name() == "UL"_v();
  if (!left && !(site.name() == "UR"_v())) return {};
  const auto right_answer = site.trace().numbers(site.value());
  Numbers<Exact> knots(right_answer.begin(), right_answer.end());
  knots.erase(left ? knots.end() - 1 : knots.begin());
  return {knots};
}

}  // namespace

const Algorithm& subdivision() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "subdivision";
    a.family = Family::curve_technique;
    a.title = "Subdivision";
    a.summary = "A curve cut in two at a parameter, each part with control points of its own.";
    a.source = "Shene, CS3621 notes, \"Subdividing a Bézier Curve\"; The NURBS Book, 5.3";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A curve of any kind; an unclamped one is clamped first."},
        {"u", InputSpec::Type::number, "Where it is cut, inside the domain."},
    };
    a.pseudo_code = {
        "clamp the curve, if it is not",
        "find k with u_k <= u < u_{k+1}",
        "s = multiplicity of u",
        "for r = 1 to p-s",
        "  for i = k-p+r to k-s",
        "    a = alpha[r][i] = (u - u_i) / (u_{i+p-r+1} - u_i)",
        "    Q[r][i] = (1-a) Q[r-1][i-1] + a Q[r-1][i]",
        "UL = knots below u, u p+1 times; UR = u p+1 times, knots above u",
        "L = P_0.., along the upper edge to the tip",
        "R = from the tip along the lower edge, .., P_n",
    };
    a.given_narration = "A curve of degree p = {p} with the knots U = {U}. It is to be cut in two at u = {u}.";
    a.values = {
        {"p", {}, "the degree"},
        {"u", {}, "where the curve is cut"},
        {"U", {}, "the knot vector"},
        {"U", {"i"}, "the knot u_i"},
        {"P", {"i"}, "the control point P_i", 0, "", ValueSpec::Draw::polygon, true},
        {"W", {}, "the knots of the clamped curve", 1, "Clamped, the curve has the knots {value}."},
        {"k", {}, "the span of u", 2, "In the knots {@1} the span that holds {@0} begins at index k = {k}."},
        {"s",
         {},
         "the multiplicity of u before",
         3,
         "{@0} is a knot already, of multiplicity s = {s}: {p-s} levels are left to compute.",
         ValueSpec::Draw::none,
         false,
         {{"", "1-s", 0, "{@0} is no knot yet: s = 0, and all p = {p} levels are to be computed."},
          {"", "s-p", 0, "The curve may jump at {@0}, a knot of multiplicity s = {s}: nothing is left to compute."},
          {"", "s-p+1", 0,
           "{@0} has multiplicity s = {s} already, the degree: the curve passes through a control point there."}}},
        {"alpha", {"r", "i"}, "the ratio for Q[r][i]", 6, "alpha[{r}][{i}] = {chain}."},
        {"Q",
         {"r", "i"},
         "the point i of level r",
         7,
         "Level {r}: {name} divides its segment at alpha = {alpha[r][i]}: {numbers} = {made}.",
         ValueSpec::Draw::level,
         true},
        {"UL", {}, "the knots of the left part", 8, "The left part ends at {@1}, p + 1 = {p+1} times: UL = {value}."},
        {"UR",
         {},
         "the knots of the right part",
         8,
         "The right part begins at {@1}, p + 1 = {p+1} times: UR = {value}."},
        {"L",
         {"i"},
         "the control point i of the left part",
         9,
         "The left part: the old points in front, then the upper edge of the triangle (it lies on its side) to its "
         "tip.",
         ValueSpec::Draw::polygon},
        {"R",
         {"i"},
         "the control point i of the right part",
         10,
         "The right part: from the tip along the lower edge, then the old points behind.",
         ValueSpec::Draw::polygon},
    };
    a.phases = {
        {"clamp", "Clamp the curve", 1, "The curve is not clamped: first its ends become knots of full multiplicity."},
        {"end", "End {index}", 1, "Insert the end of the domain until it has full multiplicity."},
        {"cut", "Cut", 9, "The tip of the triangle lies on the curve. There it is cut."},
    };
    a.rules = {&rule_info<LastKnot>,    &rule_info<Multiplicity>, &rule_info<Ratio>,
               &rule_info<Blend>,       &rule_info<Same>,         &rule_info<KnotsBefore>,
               &rule_info<KnotsBehind>, &rule_info<Gather>,       &rule_info<SameNumber>};
    a.misconceptions = {
        swapped_weights("Q[r][i] = (1-alpha[r][i]) Q[r-1][i-1] + alpha[r][i] Q[r-1][i]: where alpha is 0 the result is "
                        "the earlier point, so that one gets 1-alpha and the later one gets alpha."),
        neighbour_knot(),
        wrong_pair(),
        {"open-end", "the new end is a knot only p times",
         "A clamped end is a knot of multiplicity p+1: one more than insertion gives, as for the ends of U.",
         open_end}};
    a.asks = {"k", "alpha[1][*]", "Q[*][*]", "UL", "UR", "L[*]", "R[*]"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
