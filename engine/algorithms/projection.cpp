#include "kernel/projection.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const auto& curve = inputs.curve("curve");
  if (curve.dimension != 2) at("curve").error("must be a plane curve: its weights become the third coordinate");
  for (std::size_t i = 0; i < curve.points.size(); ++i)
    if (curve.points[i].w.to_double() == 0)
      at("curve").error("has the weight 0 at P_" + std::to_string(i) + ", which has no place in the plane at height 1");
  check_parameter(inputs, at);
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return projection(inputs.curve("curve"), inputs.number("u"), rec);
};

bool is_made_by(const Site& site, const RuleInfo* rule) { return site.trace().value(site.value()).rule == rule; }

// (x, y, w): the weight written beside the coordinates.
std::vector<Numbers<Exact>> weight_appended(const Site& site) {
  if (!is_made_by(site, &rule_info<Lift>)) return {};
  const auto A = site.operand(0);
  return {{A[0], A[1], site.operand(1)[0], Exact(1)}};
}

// Straight down, as a map shows mountains: only the height is changed.
std::vector<Numbers<Exact>> straight_down(const Site& site) {
  if (!is_made_by(site, &rule_info<Shadow>)) return {};
  const auto A = site.operand(0);
  return {{A[0], A[1], Exact(1), Exact(1)}};
}

// The points of the plane divided, not those of space.
std::vector<Numbers<Exact>> in_the_plane(const Site& site) {
  if (!is_blend(site)) return {};
  const auto A = site.operand(1), B = site.operand(2);
  if (A[2] == Exact(0) || B[2] == Exact(0)) return {};
  const auto shadow = [](NumbersView<Exact> P) { return Numbers<Exact>{P[0] / P[2], P[1] / P[2], Exact(1), Exact(1)}; };
  return {blend(site.operand(0), shadow(A), shadow(B))};
}

}  // namespace

const Algorithm& projection() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "projection";
    a.family = Family::evaluation;
    a.title = "A NURBS curve from above";
    a.summary =
        "A rational plane curve as the picture of a polynomial curve in space, whose heights are the weights, for an "
        "eye at the origin.";
    a.source = "The NURBS Book, 1.4 and 4.2; Shene, CS3621 notes, \"NURBS: Definition\"";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A plane curve of any kind, without weights of 0."},
        {"u", InputSpec::Type::number, "The parameter, in the domain [u_p, u_{n+1}]."},
    };
    a.pseudo_code = {
        "for i = 0 to n",
        "  H[i] = w_i (x_i, y_i, 1)",
        "find k with u_k <= u < u_{k+1}, s = multiplicity of u",
        "for r = 1 to p-s",
        "  for i = k-p+r to k-s",
        "    a = alpha[r][i] = (u - u_i) / (u_{i+p-r+1} - u_i)",
        "    H[r][i] = (1-a) H[r-1][i-1] + a H[r-1][i], H[0] = H",
        "Cw = H[p-s][k-s], the point in space",
        "C = Cw / height of Cw",
    };
    a.given_narration =
        "A plane curve of degree p = {p}, and u = {u}. Its plane lies at height 1: the control point (x, y) stands at "
        "(x, y, 1).";
    a.values = {
        {"p", {}, "the degree"},
        {"u", {}, "the parameter"},
        {"U", {}, "the knot vector"},
        {"U", {"i"}, "the knot u_i"},
        {"P", {"i"}, "the control point P_i, at height 1", 0, "", ValueSpec::Draw::polygon, false, {}, "", true},
        {"w", {"i"}, "the weight of P_i"},
        {"k",
         {},
         "the span of u",
         3,
         "u = {u} belongs to the span from u_{k} = {U[k]} to u_{k+1} = {U[k+1]}, so k = {k}: the points {k-p} to {k} "
         "count."},
        {"s",
         {},
         "the multiplicity of u",
         3,
         "u = {u} is a knot of multiplicity s = {s}.",
         ValueSpec::Draw::none,
         false,
         {{"", "1-s", 0, "u = {u} is no knot: s = 0, and there are {p} levels."}}},
        {"alpha", {"r", "i"}, "the ratio for H[r][i]", 6, "alpha[{r}][{i}] = {chain}."},
        {"H",
         {"i"},
         "the control point P_i, lifted into space",
         2,
         "P_{i} has the weight {w[i]}: on its line through the origin it moves to the height {w[i]}, {name} = {chain}.",
         ValueSpec::Draw::polygon,
         true,
         {},
         "",
         true},
        {"H",
         {"r", "i"},
         "the point i of level r, in space",
         7,
         "{name} divides the segment from {#H[r-1][i-1]} to {#H[r-1][i]}, in space: {numbers} = {value}.",
         ValueSpec::Draw::level,
         true,
         {{"", "2-r", 0, "{name} divides the segment from {#H[i-1]} to {#H[i]}, in space: {numbers} = {value}."}}},
        {"Cw",
         {},
         "the point of the curve in space",
         8,
         "The point of the curve in space: {value}. Nothing was divided by a weight so far.",
         ValueSpec::Draw::point,
         false,
         {},
         "",
         true},
        {"C",
         {},
         "the point of the curve, at height 1",
         9,
         "Along the line to the origin to height 1: all coordinates of {Cw} divided by its height, C = {value}.",
         ValueSpec::Draw::point,
         false,
         {},
         "",
         true},
    };
    a.phases = {
        {"lift", "Lift the control points", 1,
         "Each control point moves along its line through the origin, until its height is its weight."},
        {"space", "De Boor's algorithm in space", 3,
         "The lifted points are the control points of a curve in space, an ordinary one without weights."},
        {"shadow", "Back into the plane", 9, "Seen from the origin, the point in space covers a point of the plane."},
    };
    a.rules = {&rule_info<Lift>,  &rule_info<FindSpan>, &rule_info<Multiplicity>, &rule_info<Ratio>,
               &rule_info<Blend>, &rule_info<Same>,     &rule_info<Shadow>};
    a.misconceptions = {
        {"weight-appended", "the coordinates are not multiplied by the weight",
         "The point moves along its line through the origin: all three coordinates of (x, y, 1) are multiplied by w.",
         weight_appended},
        {"straight-down", "the point is dropped straight down",
         "It is seen from the origin, not from above: divide all coordinates by the height.", straight_down},
        {"in-the-plane", "the points of the plane are divided instead of those in space",
         "The ratio divides the segment in space. In the plane the weights shift the point along the segment.",
         in_the_plane},
        swapped_weights("H[r][i] = (1-alpha[r][i]) H[r-1][i-1] + alpha[r][i] H[r-1][i]: where alpha is 0 "
                        "the result is the earlier point, so that one gets 1-alpha and the later one gets alpha."),
        neighbour_knot(),
        wrong_pair(),
        wrong_span()};
    a.asks = {"H[*]", "H[*][*]", "Cw", "C"};
    a.check = check;
    a.lifts = true;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
