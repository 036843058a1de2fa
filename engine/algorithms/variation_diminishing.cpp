#include "kernel/variation_diminishing.hpp"

#include "algorithms/common.hpp"

namespace blossom {
namespace {

Exact side(const HPoint<Exact>& A, const HPoint<Exact>& B, const HPoint<Exact>& Q) {
  return SideOf::apply<Exact>(A, B, Q);
}

void check(const Inputs<Exact>& inputs, const std::function<Cursor(std::string_view)>& at) {
  const auto& curve = inputs.curve("curve");
  const auto& line = inputs.points("line");
  bool valid = true;
  const auto error = [&](std::string_view name, const std::string& text) {
    at(name).error(text);
    valid = false;
  };
  if (curve.n() != curve.degree || curve.knots != bezier_knots<Exact>(curve.degree))
    error("curve", "must be a Bézier curve: leave out \"knots\", and give degree + 1 points");
  if (curve.dimension != 2) error("curve", "must lie in the plane: give points of two coordinates");
  if (line.dimension != 2) error("line", "must lie in the plane: give points of two coordinates");
  if (!std::ranges::all_of(curve.points, [](const auto& P) { return Exact(0) < P.w; }))
    error("curve", "must have positive weights: with others the curve may leave the hull of its control points");
  if (line.points[0] == line.points[1]) error("line", "must be two different points");
  if (valid && std::ranges::all_of(curve.points,
                                   [&](const auto& P) { return side(line.points[0], line.points[1], P) == Exact(0); }))
    error("line", "must not contain all control points: then there is nothing to count");
}

constexpr auto run = []<class In, class R>(const In& inputs, R& rec) -> Outcome<typename R::Number> {
  return variation_diminishing(inputs.curve("curve"), inputs.points("line"), inputs.integer("rounds"), rec);
};

// The line, as long as the control points need it.
std::vector<Curve<double>> pictured(const Inputs<double>& inputs) {
  const auto& A = inputs.points("line").points[0];
  const auto& B = inputs.points("line").points[1];
  const double x = B.x - A.x, y = B.y - A.y, length = x * x + y * y;
  double low = 0, high = 1;
  for (const auto& P : inputs.curve("curve").points) {
    const double along = ((P.x / P.w - A.x) * x + (P.y / P.w - A.y) * y) / length;
    low = std::min(low, along);
    high = std::max(high, along);
  }
  Curve<double> line{1, bezier_knots<double>(1), {}, 2, false, true};
  const double more = 0.05 * (high - low);
  for (const double along : {low - more, high + more}) line.points.push_back({A.x + along * x, A.y + along * y, 0, 1});
  return {line};
}

// The numbers that the sign changes are counted in.
std::vector<Exact> sides(const Site& site) {
  std::vector<Exact> d;
  if (site.trace().value(site.value()).rule == &rule_info<SignChanges>)
    for (std::size_t i = 0; i < site.trace().operands(site.value()).size(); ++i) d.push_back(site.operand(i)[0]);
  return d;
}

// A point on the line taken for one on its left.
std::vector<Numbers<Exact>> zero_counted(const Site& site) {
  const auto d = sides(site);
  if (std::ranges::find(d, Exact(0)) == d.end()) return {};
  int changes = 0;
  for (std::size_t i = 1; i < d.size(); ++i) changes += (d[i] < Exact(0)) != (d[i - 1] < Exact(0)) ? 1 : 0;
  return {{Exact(changes)}};
}

// The points of one side counted, not the changes.
std::vector<Numbers<Exact>> points_counted(const Site& site) {
  const auto d = sides(site);
  if (d.empty()) return {};
  const auto below = std::ranges::count_if(d, [](const Exact& x) { return x < Exact(0); });
  const auto above = std::ranges::count_if(d, [](const Exact& x) { return Exact(0) < x; });
  return {{Exact(static_cast<int>(below))}, {Exact(static_cast<int>(above))}};
}

// (L[1] - L[0]) · (Q - L[0]): how far along the line, not how far from it.
std::vector<Numbers<Exact>> dot_product(const Site& site) {
  if (site.trace().value(site.value()).rule != &rule_info<SideOf>) return {};
  const auto A = site.operand(0), B = site.operand(1), Q = site.operand(2);
  if (Q[3] == Exact(0)) return {};
  return {{(B[0] - A[0]) * (Q[0] / Q[3] - A[0]) + (B[1] - A[1]) * (Q[1] / Q[3] - A[1])}};
}

}  // namespace

const Algorithm& variation_diminishing() {
  static const Algorithm algorithm = [] {
    Algorithm a;
    a.id = "variation_diminishing";
    a.family = Family::evaluation;
    a.title = "Variation diminishing";
    a.summary = "How often a line crosses a Bézier curve: never more often than its control polygon.";
    a.source = "Shene, CS3621 notes, \"Bézier Curves\"; The NURBS Book, 1.3; Lane and Riesenfeld, 1983";
    a.inputs = {
        {"curve", InputSpec::Type::curve, "A Bézier curve in the plane (no knots), with positive weights if any."},
        {"line", InputSpec::Type::points, "Two points of the line.", 2, 2},
        {"rounds", InputSpec::Type::integer, "How often all pieces are halved.", 1, 4, {}, "2"},
    };
    a.pseudo_code = {
        "Q[0] = control points, L[0], L[1] = two points of the line",
        "d[0][i] = (L[1] - L[0]) × (Q[0][i] - L[0])",
        "V[0] = sign changes in d[0][0], d[0][1], ...",
        "for r = 1 to rounds",
        "  halve each piece (de Casteljau at 1/2)",
        "  Q[r] = the polygons of all pieces in a row",
        "  d[r][i] = (L[1] - L[0]) × (Q[r][i] - L[0])",
        "  V[r] = sign changes in d[r], V[r] <= V[r-1]",
    };
    a.given_narration =
        "A Bézier curve and the line through {L[0]} and {L[1]}. How often can the line cross the curve? We look at the "
        "control polygon only.";
    a.values = {
        {"L", {"i"}, "a point of the line", 0, "", ValueSpec::Draw::point},
        {"E",
         {"r", "i"},
         "the point i of level r of de Casteljau's triangle",
         5,
         "{name} = {chain}.",
         ValueSpec::Draw::level},
        {"Q",
         {"r", "i"},
         "the point i of the polygon after r rounds (r = 0: the control points)",
         6,
         "Cut corners: after round {r} the polygons of the pieces in a row have {value} as their point {i}.",
         ValueSpec::Draw::level},
        {"d",
         {"r", "i"},
         "the side of Q[r][i]: its signed distance to the line times |L[1] - L[0]|",
         2,
         "The point {i} is {@2}: ({#L[1]} - {#L[0]}) × ({#Q[r][i]} - {#L[0]}) = {value}. The sign says on which side "
         "of the line it is.",
         ValueSpec::Draw::none,
         false,
         {{"", "r", 7, "The sides of all points of the polygon after round {r}: {name} = {value}, and so on."}}},
        {"V",
         {"r"},
         "how often the polygon changes sides after r rounds",
         3,
         "The number of sign changes along the control polygon is V = {value}: no line crosses the curve more often "
         "than its polygon, so there are no more than {value} crossings.",
         ValueSpec::Draw::none,
         false,
         {{"", "r", 8,
           "The number of sign changes is {value} now, after {V[r-1]} before: cutting corners never adds one."}}},
    };
    a.phases = {
        {"round", "Round {index}", 4, "Halve the curve by de Casteljau's algorithm: its polygon comes closer."},
        {"halve", "Halve all pieces", 5, "Each piece is cut at 1/2."},
        {"piece", "Piece {index}", 5, "Piece {index}: the edges of the triangle are the polygons of its halves."},
    };
    a.rules = {&rule_info<SideOf>, &rule_info<SignChanges>, &rule_info<Midpoint>, &rule_info<Same>};
    a.misconceptions = {
        {"dot-product", "the dot product is taken for the cross product",
         "The dot product tells how far along the line a point is. Its side is the cross product (a, b) × (c, d) = "
         "ad - bc.",
         dot_product},
        {"zero-counted", "a point on the line counts as on its left",
         "A point on the line is on neither side: leave out the zeros before you count the sign changes.",
         zero_counted},
        {"points-counted", "the points of one side are counted",
         "It is the changes from one side to the other that count, as you walk along the polygon.", points_counted}};
    a.asks = {"d[0][*]", "V[*]"};
    a.check = check;
    a.pictured = pictured;
    set_runners<run>(a);
    return a;
  }();
  return algorithm;
}

}  // namespace blossom
