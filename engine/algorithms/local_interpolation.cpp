#include "kernel/local_interpolation.hpp"

#include "algorithms/fitting.hpp"

namespace blossom {
namespace {

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  const auto tangents = inputs.choice("tangents") == "akima" ? LocalTangents::akima : LocalTangents::bessel;
  return local_interpolation(inputs.points("points"), tangents, fitting::parametrization(inputs), rec);
};

// The two slopes with each other's weights.
std::vector<Numbers<Exact>> swapped(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<BlendSlopes>) return {};
  return {blend(site.operand(0), site.operand(2), site.operand(1))};
}

// The derivative itself where a third of it is meant.
std::vector<Numbers<Exact>> no_third(const Site& site) {
  const RuleInfo* rule = site.trace().value(site.value()).rule;
  if (rule != &rule_info<ThirdAhead> && rule != &rule_info<ThirdBack>) return {};
  const auto A = site.operand(0), w = site.operand(1), V = site.operand(2);
  const Exact factor = rule == &rule_info<ThirdAhead> ? w[0] : -w[0];
  return {{A[0] + factor * V[0], A[1] + factor * V[1], A[2] + factor * V[2], A[3]}};
}

}  // namespace

const Algorithm& local_interpolation() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "local_interpolation";
    a.family = Family::fitting;
    a.title = "Local cubic interpolation";
    a.summary = "Cubic pieces through given points that meet with one tangent; each depends on few points.";
    a.source = "The NURBS Book, 9.3.1 and 9.3.4; Akima, \"A new method of interpolation\", J. ACM 17, 1970";
    a.inputs = {
        {"points", InputSpec::Type::points, "The points in order, which the curve passes through.", 2, 200},
        {"tangents",
         InputSpec::Type::choice,
         "Where the tangents come from: parabolas through three points, or Akima's five points.",
         0,
         0,
         {"bessel", "akima"},
         "\"bessel\""},
        {"parametrization",
         InputSpec::Type::choice,
         "How the points get their parameters.",
         0,
         0,
         {"chord", "centripetal", "uniform"},
         "\"chord\""},
    };
    a.pseudo_code = {
        "t_k = t_{k-1} + |D[k] - D[k-1]| / L",
        "w[k] = t_k - t_{k-1}",
        "s[k] = (D[k] - D[k-1]) / w[k]",
        "a[k] = w[k] / (w[k] + w[k+1])   (Akima: g[k] / (g[k] + g[k+2]))",
        "V[k] = (1 - a[k]) s[k] + a[k] s[k+1]",
        "V[0] = 2 s[1] - V[1], V[n] = 2 s[n] - V[n-1]",
        "U: each inner t_k twice",
        "P: D[k] + w[k+1]/3 V[k], D[k+1] - w[k+1]/3 V[k+1]",
    };
    a.given_narration = "The points to pass through, in order.";
    a.values = {
        {"D", {"k"}, "the given point D[k]", 0, "", ValueSpec::Draw::point},
        {"n", {}, "the number of points less one"},
        {"k", {"k"}, "the index k"},
        {"eps", {}, "what counts as rounding"},
        {"c", {"k"}, "the distance from the point before", 1, "{name} = {chain}."},
        {"d", {"k"}, "the distance from the point before (centripetal: its square root)", 1, "{name} = {chain}."},
        {"L", {}, "the whole length", 1, "All together: L = {value}."},
        {"e", {"k"}, "the share of this distance", 1, "{name} = {chain}."},
        {"t", {"k"}, "the parameter of point k", 1, "Point {k} gets the parameter t_{k} = {value}."},
        {"w", {"k"}, "the width of the piece that ends in point k", 2, "Piece {k} is {chain} wide."},
        {"s", {"k"}, "the slope of the chord to point k", 3, "Its chord has the slope {chain}."},
        {"x",
         {"e"},
         "a slope beyond the ends: s_{-1}, s_0, s_{n+1}, s_{n+2}",
         4,
         "The slopes go on evenly beyond the end: {chain}."},
        {"g", {"k"}, "how much the slope changes from s[k-1] to s[k]", 4, "{name} = {chain}."},
        {"a", {"k"}, "how much the slope behind counts at point k", 4, "At point {k} the next slope counts {chain}."},
        {"V",
         {"k"},
         "the derivative at point k",
         5,
         "The tangent at point {k} lies between both slopes: V[{k}] = {chain}.",
         ValueSpec::Draw::none,
         false,
         {{"continue_slope", "", 6, "At the end the parabola's slope goes on: V[{k}] = {chain}."}},
         "D[k]"},
        {"U", {}, "the knot vector", 7, "Each inner parameter is a knot twice: U = {value}."},
        {"P",
         {"i"},
         "the control point P_i",
         8,
         "A third of the tangent from its point: {name} = {chain}.",
         ValueSpec::Draw::polygon,
         false,
         {{"relabel", "", 8, "The curve begins and ends in given points: {name} = {chain}."}}},
    };
    a.phases = {
        {"parameters", "Parameters", 1, "At which t does the curve pass each point? The choice shapes the curve."},
        {"slopes", "Slopes of the chords", 2, "How fast does one get from each point to the next on a straight line?"},
        {"tangents", "Tangents", 4, "Each point gets a tangent from the slopes next to it. Nothing is solved for."},
        {"pieces", "The pieces", 7, "Two points and two tangents make a cubic piece. The pieces become one B-spline."},
    };
    a.rules = {&rule_info<Distance>,   &rule_info<Root>,      &rule_info<Total>,         &rule_info<Quotient>,
               &rule_info<Sum>,        &rule_info<Fraction>,  &rule_info<Gather>,        &rule_info<StepWidth>,
               &rule_info<ChordSlope>, &rule_info<ShareOf>,   &rule_info<AkimaShare>,    &rule_info<SlopeChange>,
               &rule_info<ThirdAhead>, &rule_info<ThirdBack>, &rule_info<ContinueSlope>, &rule_info<BlendSlopes>,
               &rule_info<Relabel>};
    a.misconceptions = {fitting::always_uniform(),
                        fitting::not_divided(),
                        {"swapped-weights", "the weights of the slopes are swapped",
                         "The shorter neighbour counts more: V[k] = (1 - a[k]) s[k] + a[k] s[k+1], where a[k] grows "
                         "with the piece before the point.",
                         swapped},
                        {"no-third", "the whole tangent is gone, not a third of it",
                         "A cubic's derivative at its end is three times the first leg of its polygon, so the leg is a "
                         "third of the derivative.",
                         no_third}};
    a.asks = {"s[*]", "V[*]", "P[*]"};
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
