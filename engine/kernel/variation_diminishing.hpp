#pragma once
// The variation diminishing property of Bezier curves, counted (Lane and Riesenfeld, A Geometric Proof for the
// Variation Diminishing Property of B-spline Approximation, 1983; The NURBS Book 1.3; Shene, "Bezier Curves"): a line
// crosses the curve at most as often as its control polygon. With the line through A and B, each point Q has a side
//
//     d = (B - A) x (Q - A),    the signed distance times |AB|,  positive to the left,
//
// and the polygon changes sides V times. Halving the curve by de Casteljau's algorithm cuts corners off the polygon,
//
//     Q[r] = the polygons of the 2^r pieces in a row,
//
// so V[r] <= V[r-1]; and Q[r] comes as close to the curve as one likes, so it crosses the line at least as often as the
// curve does.

#include "kernel/error.hpp"
#include "kernel/tolerance.hpp"

namespace blossom {

// On which side of the line AB a point lies, and how far from it
struct SideOf {
  static constexpr std::string_view name = "side_of";
  static constexpr std::string_view formula = "({1} - {0}) × ({2} - {0})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const HPoint<S>& A, const HPoint<S>& B, const HPoint<S>& Q) {
    const S x = Q.x / Q.w - A.x, y = Q.y / Q.w - A.y;
    return (B.x - A.x) * y - (B.y - A.y) * x;
  }
  template <Scalar S>
  static bool defined(const HPoint<S>&, const HPoint<S>&, const HPoint<S>& Q) {
    return !(Q.w == S(0));
  }
};

// How often the sign changes along numbers; what is zero up to rounding has none
struct SignChanges {
  static constexpr std::string_view name = "sign_changes";
  static constexpr std::string_view formula = "sign changes in {*}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static int apply(std::span<const S> d) {
    S largest(0);
    for (const S& x : d) largest = std::max(largest, x < S(0) ? S(-x) : x);
    const S rounding = largest / S(1000000000);
    int changes = 0, sign = 0;
    for (const S& x : d) {
      const int here = rounding < x ? 1 : x < S(-rounding) ? -1 : 0;
      if (here == 0) continue;
      if (sign != 0 && here != sign) ++changes;
      sign = here;
    }
    return changes;
  }
};

// The middle of two points: a blend whose parameter is in the middle of the two arguments they do not share
struct Midpoint {
  static constexpr std::string_view name = "midpoint";
  static constexpr std::string_view formula = "({0} + {1}) / 2";
  static constexpr Polar polar = Polar::blend;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const HPoint<S>& B) {
    const S two(2);
    return {(A.x + B.x) / two, (A.y + B.y) / two, (A.z + B.z) / two, (A.w + B.w) / two};
  }
};

namespace variation {

template <class R>
using Points = Cells<HPoint<typename R::Number>, typename R::Id>;

// The sides of the polygon Q, and how often they change.
template <class R, class Line>
void count(R& rec, const Line& A, const Line& B, const Points<R>& Q, int round) {
  Cells<typename R::Number, typename R::Id> d;
  const auto measure = [&] {
    for (int i = 0; i < Q.size(); ++i) d.push_back(rec.apply(SideOf{}, "d"_v(round, i), A, B, Q[i]));
  };
  if (round == 0) {
    measure();
  } else {
    auto together = rec.one_step();
    measure();
  }
  rec.apply(SignChanges{}, "V"_v(round), slice(d, 0, d.size()));
}

// The polygon of twice as many pieces of degree n, each half of one of these.
template <class R>
Points<R> halve(R& rec, const Points<R>& Q, int n) {
  Points<R> made;
  for (int piece = 0; piece * n + 1 < Q.size(); ++piece) {
    auto phase = rec.phase({"piece", piece, true});
    Points<R> row, right;
    row.append(Q, piece * n, n + 1);
    if (piece == 0) made.push_back(row[0]);
    right.push_back(row[n]);
    for (int r = 1; r <= n; ++r) {
      for (int i = 0; i <= n - r; ++i) row.set(i, rec.apply(Midpoint{}, "E"_v(r, i), row[i], row[i + 1]));
      made.push_back(row[0]);
      if (r < n) right.push_back(row[n - r]);
    }
    for (int i = n - 1; i >= 0; --i) made.push_back(right[i]);
  }
  return made;
}

}  // namespace variation

// Preconditions: a Bezier curve in the plane with positive weights, not all of its points on the line; two different
// points of a line. Gives the pieces of the last round.
template <class R>
std::vector<Curve<typename R::Number>> variation_diminishing(const Curve<typename R::Number>& curve,
                                                             const PointRow<typename R::Number>& line, int rounds,
                                                             R& rec) {
  using S = typename R::Number;
  const int n = curve.degree;
  const auto A = rec.input("L"_v(0), line.points[0]);
  const auto B = rec.input("L"_v(1), line.points[1]);
  const auto P = rec.inputs("Q"_v, 0, std::span<const HPoint<S>>(curve.points));
  if constexpr (R::recording)
    for (int i = 0; i <= n; ++i) rec.polar_bezier(P[i].id, i, n);

  variation::Points<R> Q;
  Q.append(P, 0, n + 1);
  variation::count(rec, A, B, Q, 0);
  for (int r = 1; r <= rounds; ++r) {
    auto phase = rec.phase({"round", r});
    variation::Points<R> halves, named;
    {
      auto scope = rec.phase({"halve", r, true});
      halves = variation::halve(rec, Q, n);
      auto together = rec.one_step();
      for (int i = 0; i < halves.size(); ++i) named.push_back(rec.apply(Same{}, outer("Q"_v(r, i)), halves[i]));
    }
    if constexpr (R::recording)
      if (r > 1)
        for (int i = 0; i < Q.size(); ++i) rec.retire(Q[i].id);
    Q = std::move(named);
    variation::count(rec, A, B, Q, r);
  }

  std::vector<Curve<S>> pieces;
  for (int piece = 0; piece * n + 1 < Q.size(); ++piece) {
    Curve<S> made{n, bezier_knots<S>(n), {}, curve.dimension, curve.rational, true};
    for (int i = 0; i <= n; ++i) made.points.push_back(Q[piece * n + i].value);
    pieces.push_back(std::move(made));
  }
  return pieces;
}

}  // namespace blossom
