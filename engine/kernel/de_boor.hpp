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

  const auto k = rec.apply(FindSpan{}, "k"_v, degree, u, knots);
  const auto s = rec.apply(Multiplicity{}, "s"_v, u, knots);
  const bool at_the_end = U[k.value + 1].value == u.value;
  const int known = std::min(s.value, p);  // a knot of multiplicity p is a point of the curve already
  const int last = at_the_end ? k.value : k.value - known;

  TriangleRow<R> row;
  for (int j = 0; j <= p - known; ++j) {
    const auto given = P[last - (p - known) + j];
    row[static_cast<std::size_t>(j)] = {given.value, given.id};
  }
  triangle(rec, U, u, row, p, known, last, p - known, {"P"_v}, [](int) {});

  const auto& top = row[static_cast<std::size_t>(p - known)];
  if (!curve.rational) return rec.apply(Same{}, "C"_v, top).value;
  if (top.value.w == S(0))
    throw KernelError{"u", "the weight of the point at this parameter is 0: it lies at infinity"};
  return rec.apply(Project{}, "C"_v, top).value;
}

}  // namespace blossom
