#pragma once
// de Boor's algorithm: a point on a B-spline or NURBS curve by repeated knot insertion at u (de Boor 1972; The NURBS
// Book, end of 5.2; Shene, "De Boor's Algorithm"). With span k, multiplicity s of u and h = p - s levels:
//
//     alpha[r][i] = (u - u_i) / (u_{i+p-r+1} - u_i),  P[r][i] = (1 - alpha) P[r-1][i-1] + alpha P[r-1][i],
//     r = 1..h, i = k-p+r..k-s,   C = P[h][k-s],
//
// followed by the division by the weight for a rational curve. At the end of the domain u equals the knot to the right
// of its span, and the triangle ends at P[h][k].

#include "kernel/error.hpp"
#include "kernel/triangle.hpp"

namespace blossom {

// Which points u depends on, P[first] .. P[last]: p - s + 1 of them, at a knot of multiplicity p or more just one.
struct InForce {
  int first, last;
};
template <class Knots, class S>
InForce points_in_force(const Knots& U, int p, int k, int s, const S& u) {
  const int known = std::min(s, p);  // a knot of multiplicity p is a point of the curve already
  const int last = U[k + 1].value == u ? k : k - known;
  return {last - (p - known), last};
}

// The triangle: the homogeneous point at u. `knots` is the knot vector U as one value; of P, what is in force counts.
template <class R, class Knots, class Points, class Degree, class Parameter, class KnotList>
Traced<HPoint<typename R::Number>, typename R::Id> de_boor_point(R& rec, const Degree& degree, const Knots& U,
                                                                 const KnotList& knots, const Points& P,
                                                                 const Parameter& u) {
  const int p = degree.value;
  const auto k = rec.apply(FindSpan{}, "k"_v, degree, u, knots);
  const auto s = rec.apply(Multiplicity{}, "s"_v, u, knots);
  const auto [first, last] = points_in_force(U, p, k.value, s.value, u.value);
  const int levels = last - first;
  TriangleRow<R> row;
  for (int j = 0; j <= levels; ++j) {
    const auto given = P[first + j];
    row[static_cast<std::size_t>(j)] = {given.value, given.id};
  }
  triangle(rec, U, u, row, p, p - levels, last, levels, {"P"_v}, [](int) {});
  return row[static_cast<std::size_t>(levels)];
}

// Preconditions: a valid curve, u in its domain. Error: the weight at u is zero.
template <class R>
HPoint<typename R::Number> de_boor(const Curve<typename R::Number>& curve, const typename R::Number& parameter,
                                   R& rec) {
  using S = typename R::Number;
  const int p = curve.degree;
  const auto degree = rec.input("p"_v, p);
  const auto u = rec.input("u"_v, parameter);
  const auto knots = rec.list("U"_v, curve.knots);
  const auto U = rec.inputs("U"_v, std::span<const S>(curve.knots));
  const auto P = rec.inputs("P"_v, 0, std::span<const HPoint<S>>(curve.points));
  if constexpr (R::recording)
    for (int i = 0; i < P.size(); ++i) rec.polar_knots(P[i].id, U[i + 1].id, p);

  const auto top = de_boor_point(rec, degree, U, knots, P, u);
  if (!curve.rational) return rec.apply(Same{}, "C"_v, top).value;
  if (top.value.w == S(0))
    throw KernelError{"u", "the weight of the point at this parameter is 0: it lies at infinity"};
  return rec.apply(Project{}, "C"_v, top).value;
}

}  // namespace blossom
