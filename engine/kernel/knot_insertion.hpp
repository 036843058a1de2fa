#pragma once
// Knot insertion (Boehm 1980; The NURBS Book 5.2, A5.1): u inserted `times` times into a curve, which stays the same
// curve. With u_k <= u < u_{k+1} and multiplicity s:
//
//     alpha[r][i] = (u - u_i) / (u_{i+p-r+1} - u_i),  Q[r][i] = (1 - alpha) Q[r-1][i-1] + alpha Q[r-1][i],
//     r = 1..times, i = k-p+r..k-s,   Q[0][i] = P[i].
//
// The new control points Q[i] are P_0..P_{k-p}, the left edge of the triangle, its last level, its right edge, and
// P_{k-s}..P_n: n + 1 + times of them.

#include "kernel/triangle.hpp"

namespace blossom {

// The knots with u put in behind its last equal or smaller knot.
struct InsertKnot {
  static constexpr std::string_view name = "insert_knot";
  static constexpr std::string_view formula = "{2} with {0} put in {1} times";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static std::vector<S> apply(const S& u, int times, std::span<const S> U) {
    const auto behind = std::upper_bound(U.begin(), U.end(), u);
    std::vector<S> knots;
    knots.reserve(U.size() + static_cast<std::size_t>(times));
    knots.assign(U.begin(), behind);
    knots.insert(knots.end(), static_cast<std::size_t>(times), u);
    knots.insert(knots.end(), behind, U.end());
    return knots;
  }
  template <Scalar S>
  static bool defined(const S&, int times, std::span<const S>) {
    return times >= 0 && times <= max_degree + 1;
  }
};

// A refined curve; when recording, its knot vector as one value, which a next insertion can go on from; and which of
// its points, P[begin] .. P[end-1], the triangle made, while the others were kept.
template <class R>
struct RefinedCurve {
  MadeCurve<R> curve;
  Traced<std::vector<typename R::Number>, typename R::Id> knots;
  int begin, end;
};

// Preconditions: u in the domain of the curve, times >= 1, multiplicity of u + times <= p.
// Curve is a TracedCurve; `knots` its knot vector as one value.
template <class R, class CurveIn, class KnotList, class Parameter, class Times>
RefinedCurve<R> insert_knot(R& rec, const CurveIn& curve, const KnotList& knots, const Parameter& u,
                            const Times& times) {
  using S = typename R::Number;
  const int p = curve.degree;
  const int h = times.value;
  const auto& U = curve.U;
  const auto& P = curve.P;

  const auto k = rec.apply(LastKnot{}, "k"_v, u, knots);
  const auto s = rec.apply(Multiplicity{}, "s"_v, u, knots);
  const int first = k.value - p;       // the last point in front that stays
  const int last = k.value - s.value;  // the first point behind that stays
  const int width = last - first;

  MadeCurve<R> made;
  made.degree = p;
  made.dimension = curve.dimension;
  made.rational = curve.rational;
  auto& Q = made.P;
  Q.reserve(P.size() + h);
  Q.append(P, 0, first);
  Q.resize(last + h);  // what the triangle makes
  Q.append(P, last, P.size() - last);

  TriangleRow<R> row;
  for (int j = 0; j <= width; ++j) row[static_cast<std::size_t>(j)] = {P[first + j].value, P[first + j].id};
  triangle(rec, U, u, row, p, s.value, last, h, {"Q"_v, 0, true},
           [&](int r) { Q.set(last + h - r, row[static_cast<std::size_t>(width)]); });
  // Left edge and the last level; the right edge was kept as the levels were done.
  for (int j = 0; j < width; ++j) Q.set(first + j, row[static_cast<std::size_t>(j)]);

  auto Ubar = rec.apply(InsertKnot{}, "Ubar"_v, u, times, knots);
  auto& V = made.U;
  if constexpr (R::recording) {  // each knot keeps its id
    V.reserve(static_cast<int>(Ubar.value.size()));
    V.append(U, 0, k.value + 1);
    for (int r = 0; r < h; ++r) V.push_back(Ref<S, typename R::Id>{u.value, u.id});
    V.append(U, k.value + 1, U.size() - k.value - 1);
  } else {
    V.give(std::move(Ubar.value));
  }
  return {std::move(made), std::move(Ubar), first, last + h};
}

// The curve as given: its knots and points as input values U, U[i], P[i] with their polar labels.
template <class R>
auto given_curve(R& rec, const Curve<typename R::Number>& curve) {
  using S = typename R::Number;
  using Id = typename R::Id;
  TracedCurve<Givens<S, Id>, Givens<HPoint<S>, Id>> given;
  given.degree = curve.degree;
  given.dimension = curve.dimension;
  given.rational = curve.rational;
  given.U = rec.inputs("U"_v, std::span<const S>(curve.knots));
  given.P = rec.inputs("P"_v, std::span<const HPoint<S>>(curve.points));
  if constexpr (R::recording)
    for (int i = 0; i < given.P.size(); ++i) rec.polar_knots(given.P[i].id, given.U[i + 1].id, curve.degree);
  return given;
}

// The made curve as a plain value. A polynomial's weights, 1 up to rounding where points were extrapolated (among
// P[begin] .. P[end-1]), are 1.
template <class R>
Curve<typename R::Number> plain_curve(MadeCurve<R>&& made, int begin, int end) {
  auto points = made.P.take();
  if (!made.rational)
    for (int i = begin; i < end; ++i) points[static_cast<std::size_t>(i)].w = typename R::Number(1);
  return {made.degree, made.U.take(), std::move(points), made.dimension, made.rational, false};
}

// The whole algorithm on a curve, with its new control net Q[i] named.
template <class R>
Curve<typename R::Number> knot_insertion(const Curve<typename R::Number>& curve, const typename R::Number& parameter,
                                         int times, R& rec) {
  const auto u = rec.input("u"_v, parameter);
  const auto h = rec.input("h"_v, times);
  const auto knots = rec.list("U"_v, curve.knots);
  const auto given = given_curve(rec, curve);
  auto [made, list, begin, end] = insert_knot(rec, given, knots, u, h);
  if constexpr (R::recording) {
    auto phase = rec.phase({"collect"});
    auto step = rec.one_step();
    for (int i = 0; i < made.P.size(); ++i) rec.apply(Same{}, "Q"_v(i), made.P[i]);
  }
  return plain_curve<R>(std::move(made), begin, end);
}

}  // namespace blossom
