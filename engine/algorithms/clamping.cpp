#include "kernel/clamping.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return clamping(inputs.curve("curve"), rec);
};

// The ends of the knot vector, u_0 and u_m, are taken for those of the domain.
std::vector<Numbers<Exact>> ends_of_the_vector(const Site& site) {
  if (!(site.name() == "u"_v())) return {};
  const auto& curve = site.inputs().curve("curve");
  return {{site.operand(0)[0] == curve.domain_begin() ? curve.knots.front() : curve.knots.back()}};
}

// Nothing left out: the knots before and behind the domain are still there.
std::vector<Numbers<Exact>> outside_kept(const Site& site) {
  if (!(site.name() == "W"_v())) return {};
  const auto& curve = site.inputs().curve("curve");
  const auto raised = [&](Numbers<Exact> knots, const Exact& u) {
    const int missing = curve.degree - multiplicity<Exact>(knots, u);
    knots.insert(std::upper_bound(knots.begin(), knots.end(), u), static_cast<std::size_t>(std::max(0, missing)), u);
    return knots;
  };
  return {raised(raised(curve.knots, curve.domain_begin()), curve.domain_end())};
}

}  // namespace

const Algorithm& clamping() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "clamping";
    a.family = Family::curve_technique;
    a.title = "Clamping";
    a.summary = "The same curve with knots that make it begin and end in a control point.";
    a.source = "The NURBS Book, 12.2; Shene, CS3621 notes, \"B-spline Curves: Important Properties\"";
    a.inputs = {{"curve", InputSpec::Type::curve, "A curve of any kind: open, or closed with periodic knots."}};
    a.pseudo_code = {
        "a = u_p, b = u_{n+1}: the domain",
        "insert a, then b, until each has multiplicity p: see knot insertion",
        "W = a p+1 times, the knots inside, b p+1 times",
        "Q = the points from the one at a to the one at b",
    };
    a.given_narration =
        "A curve with the knots U = {U}. Does it begin and end in a control point? Only if the ends of its domain are "
        "knots often enough.";
    a.values = {
        {"U", {}, "the knot vector"},
        {"U", {"i"}, "the knot u_i"},
        {"P", {"i"}, "the control point P_i", 0, "", ValueSpec::Draw::polygon},
        {"W",
         {},
         "the knots of the clamped curve",
         3,
         "What lies outside of the domain is left out, and each end is written once more: W = {value}."},
        {"Q",
         {"i"},
         "the control point i of the clamped curve",
         4,
         "The control points of the clamped curve: the first and the last lie on the curve.",
         ValueSpec::Draw::polygon},
    };
    a.phases = {
        {"clamp", "Clamp", 2, "The curve is not clamped: its ends become knots of full multiplicity."},
        {"end", "End {index}", 2,
         "An end of the domain (0: the beginning, 1: the end) is inserted until it has "
         "multiplicity p."},
        {"collect", "The clamped curve", 4, "The curve begins and ends in a control point now."},
    };
    a.rules = {&rule_info<LastKnot>, &rule_info<Multiplicity>, &rule_info<Ratio>,  &rule_info<Blend>,
               &rule_info<Same>,     &rule_info<InsertKnot>,   &rule_info<Gather>, &rule_info<SameNumber>};
    a.misconceptions = {
        swapped_weights("Q[r][i] = (1-alpha[r][i]) Q[r-1][i-1] + alpha[r][i] Q[r-1][i]: where alpha is 0 the result is "
                        "the earlier point, so that one gets 1-alpha and the later one gets alpha."),
        {"ends-of-the-vector", "the ends of the knot vector are taken for the ends of the curve",
         "The curve is defined from u_p to u_{n+1} only: these are the ends to be inserted, not u_0 and u_m.",
         ends_of_the_vector},
        {"outside-kept", "the knots outside of the domain are kept",
         "Once the ends have multiplicity p, the knots outside do nothing: each end stands p+1 times, and no knot lies "
         "beyond it.",
         outside_kept}};
    a.asks = {"end[*].alpha[*][*]", "end[*].Q[*][*]", "W", "Q[*]"};
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
