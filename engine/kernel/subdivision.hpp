#pragma once
// Subdivision: a curve cut in two at u (The NURBS Book 5.3; Shene, "Subdividing a Bezier Curve"). u is inserted until
// it has multiplicity p, by the triangle of knot insertion, whose tip lies on the curve:
//
//     alpha[r][i] = (u - u_i) / (u_{i+p-r+1} - u_i),  Q[r][i] = (1 - alpha) Q[r-1][i-1] + alpha Q[r-1][i],
//     r = 1..p-s, i = k-p+r..k-s,   Q[0][i] = P[i].
//
//   left part    P_0..P_{k-p-1}, the left edge of the triangle from P_{k-p} to the tip; knots u_i < u, then u^{p+1}
//   right part   the right edge from the tip back to P_{k-s}, P_{k-s+1}..P_n;           knots u^{p+1}, then u_i > u
//
// For a Bezier curve each alpha is u, and the triangle is de Casteljau's. Both parts keep their interval of the domain
// and are clamped, whatever the curve was: an unclamped one is clamped first. At a knot of multiplicity p + 1 the curve
// may jump, and each part gets its own end.

#include "kernel/clamping.hpp"

namespace blossom {

// The knots before u, closed by u p + 1 times
struct KnotsBefore {
  static constexpr std::string_view name = "knots_before";
  static constexpr std::string_view formula = "the knots of {2} below {1}, then {1}, {0} + 1 times";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static std::vector<S> apply(int p, const S& u, std::span<const S> U) {
    std::vector<S> V(U.begin(), std::lower_bound(U.begin(), U.end(), u));
    V.insert(V.end(), static_cast<std::size_t>(p) + 1, u);
    return V;
  }
  template <Scalar S>
  static bool defined(int p, const S&, std::span<const S> U) {
    return p >= 0 && p <= max_degree && std::is_sorted(U.begin(), U.end());
  }
};

// u p + 1 times, and the knots behind it
struct KnotsBehind {
  static constexpr std::string_view name = "knots_behind";
  static constexpr std::string_view formula = "{1}, {0} + 1 times, then the knots of {2} above {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static std::vector<S> apply(int p, const S& u, std::span<const S> U) {
    std::vector<S> V(static_cast<std::size_t>(p) + 1, u);
    V.insert(V.end(), std::upper_bound(U.begin(), U.end(), u), U.end());
    return V;
  }
  template <Scalar S>
  static bool defined(int p, const S& u, std::span<const S> U) {
    return KnotsBefore::defined<S>(p, u, U);
  }
};

// The two parts of a cut: their control points, and their knots.
template <class R>
struct Cut {
  Cells<HPoint<typename R::Number>, typename R::Id> left, right;
  Traced<std::vector<typename R::Number>, typename R::Id> left_knots, right_knots;
};

// Cuts a clamped curve at u, inside its domain; `knots` is its knot vector as one value.
template <class R, class CurveIn, class KnotList, class Degree, class Parameter>
Cut<R> cut_curve(R& rec, const CurveIn& whole, const KnotList& knots, const Degree& degree, const Parameter& u) {
  const int p = degree.value;
  const auto& P = whole.P;
  const auto k = rec.apply(LastKnot{}, "k"_v, u, knots);
  const auto s = rec.apply(Multiplicity{}, "s"_v, u, knots);
  const int first = k.value - p;       // the first point of the triangle
  const int last = k.value - s.value;  // its last one; before the first where the curve jumps
  const int width = p - s.value;

  Cut<R> cut;
  auto& left = cut.left;
  auto& right = cut.right;
  left.append(P, 0, std::min(first, last + 1));
  if (width >= 0) {
    TriangleRow<R> row;
    for (int j = 0; j <= width; ++j) row[static_cast<std::size_t>(j)] = {P[first + j].value, P[first + j].id};
    right.resize(width + 1);
    right.set(width, row[static_cast<std::size_t>(width)]);
    triangle(rec, whole.U, u, row, p, s.value, last, width, {"Q"_v},
             [&](int r) { right.set(width - r, row[static_cast<std::size_t>(width)]); });
    for (int j = 0; j <= width; ++j) left.push_back(row[static_cast<std::size_t>(j)]);
  }
  right.append(P, last + 1, P.size() - last - 1);
  cut.left_knots = rec.apply(KnotsBefore{}, "UL"_v, degree, u, knots);
  cut.right_knots = rec.apply(KnotsBehind{}, "UR"_v, degree, u, knots);
  return cut;
}

// Preconditions: a valid curve, u inside its domain, not at an end.
template <class R>
std::vector<Curve<typename R::Number>> subdivision(const Curve<typename R::Number>& curve,
                                                   const typename R::Number& parameter, R& rec) {
  using S = typename R::Number;
  const int p = curve.degree;
  const auto degree = rec.input("p"_v, p);
  const auto u = rec.input("u"_v, parameter);
  const auto list = rec.list("U"_v, curve.knots);
  const auto given = given_curve(rec, curve);
  const auto [whole, knots] = clamped(rec, given, list);
  auto [left, right, left_knots, right_knots] = cut_curve(rec, whole, knots, degree, u);
  {
    auto phase = rec.phase({"cut"});
    name_points(rec, "L"_v, left);
    name_points(rec, "R"_v, right);
  }
  const auto part = [&](std::vector<S>&& U, std::vector<HPoint<S>>&& points) {
    if (!curve.rational)
      for (auto& point : points) point.w = S(1);  // up to rounding it is
    return Curve<S>{p, std::move(U), std::move(points), curve.dimension, curve.rational, false};
  };
  return {part(std::move(left_knots.value), left.take()), part(std::move(right_knots.value), right.take())};
}

}  // namespace blossom
