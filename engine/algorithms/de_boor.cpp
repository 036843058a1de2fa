#include "kernel/de_boor.hpp"

#include "algorithms/common.hpp"
#include "kernel/blossom.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  check_parameter(inputs, at);
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return de_boor(inputs.curve("curve"), inputs.number("u"), rec);
};

// A wrong span reads a neighbouring polynomial piece, which the result shows.
std::vector<Numbers<Exact>> point_of_wrong_span(const Site& site) {
  auto candidates = wrong_span().wrong(site);
  if (!candidates.empty() || !(site.name() == "C"_v())) return candidates;
  const auto& curve = site.inputs().curve("curve");
  const Exact& u = site.inputs().number("u");
  const int right = find_span(std::span<const Exact>(curve.knots), curve.degree, u);
  const std::vector<Exact> diagonal(static_cast<std::size_t>(curve.degree), u);
  for (const int k : {right - 1, right + 1}) {
    if (k < curve.degree || k > curve.n() ||
        curve.knots[static_cast<std::size_t>(k)] == curve.knots[static_cast<std::size_t>(k) + 1])
      continue;
    const auto C = blossom::blossom(curve, k, std::span<const Exact>(diagonal));
    if (C.w == Exact(0)) continue;
    candidates.push_back({C.x / C.w, C.y / C.w, C.z / C.w, Exact(1)});
  }
  return candidates;
}

}  // namespace

const Algorithm& de_boor() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "de_boor";
    a.family = Family::evaluation;
    a.title = "de Boor's algorithm";
    a.summary = "A point on a B-spline or NURBS curve by inserting its parameter until it has full multiplicity.";
    a.source = "Shene, CS3621 notes, \"De Boor's Algorithm\"; The NURBS Book, 5.2";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A curve of any kind; clamped or not."},
        {"u", InputSpec::Type::number, "The parameter, in the domain [u_p, u_{n+1}]."},
    };
    a.pseudo_code = {
        "find k with u_k <= u < u_{k+1} (at the end: the last)",
        "s = multiplicity of u",
        "for r = 1 to p-s",
        "  for i = k-p+r to k-s",
        "    a = alpha[r][i] = (u - u_i) / (u_{i+p-r+1} - u_i)",
        "    P[r][i] = (1-a) P[r-1][i-1] + a P[r-1][i]",
        "C = P[p-s][k-s] (at an end: its control point)",
    };
    a.given_narration = "A B-spline curve of degree p = {p} with the knots U = {U}, and the parameter u = {u}.";
    a.values = {
        {"p", {}, "the degree"},
        {"u", {}, "the parameter"},
        {"U", {}, "the knot vector", 0, "Level 0 is P[0][i], the control points of this curve. Its knots are {value}."},
        {"U", {"i"}, "the knot u_i"},
        {"k",
         {},
         "the span of u",
         1,
         "{@1} belongs to the span from {U[k]} to {U[k+1]}, the knots of index {k} and {k+1}. So k = {k}: only the "
         "control points from index {k-p} to {k} count."},
        {"s",
         {},
         "the multiplicity of u",
         2,
         "How often is {@0} a knot already? s = {s}, so there are p - s = {p-s} levels to compute.",
         ValueSpec::Draw::none,
         false,
         {{"", "s-p+1", 0,
           "{@0} is a knot of multiplicity s = {s}, and the degree is p = {p}: the curve passes through a control "
           "point "
           "there, and no level is left to compute."}}},
        {"alpha", {"r", "i"}, "the ratio for P[r][i]", 5, "alpha[{r}][{i}] = {chain}."},
        {"P",
         {"r", "i"},
         "the point i of level r (level 0: the control points)",
         6,
         "Level {r}: P[{r}][{i}] divides the segment from {#P[r-1][i-1]} to {#P[r-1][i]} at alpha = {alpha[r][i]}: "
         "(1 - {alpha[r][i]}) {~P[r-1][i-1]} + {alpha[r][i]} {~P[r-1][i]} = {made}.",
         ValueSpec::Draw::level,
         true},
        {"C",
         {},
         "the point on the curve",
         7,
         "One point is left: the point of the curve at u = {u} is C = {value}.",
         ValueSpec::Draw::point},
    };
    a.rules = {&rule_info<FindSpan>, &rule_info<Multiplicity>, &rule_info<Ratio>,
               &rule_info<Blend>,    &rule_info<Same>,         &rule_info<Project>};
    a.misconceptions = {
        swapped_weights("P[r][i] = (1-alpha[r][i]) P[r-1][i-1] + alpha[r][i] P[r-1][i]: where alpha is 0 "
                        "the result is the earlier point, so that one gets 1-alpha and the later one "
                        "gets alpha."),
        missing_division(),
        unweighted_points(),
        unweighted_coordinates(),
        neighbour_knot(),
        wrong_pair(),
        wrong_span()};
    a.misconceptions.back().wrong = point_of_wrong_span;
    a.asks = {"k", "alpha[1][*]", "P[1][*]", "P[*][*]", "C"};
    a.check = check;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
