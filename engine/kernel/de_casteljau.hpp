#pragma once
// de Casteljau's algorithm: a point on a Bezier curve of degree n (de Casteljau 1959; The NURBS Book A1.5; Shene,
// "Finding a Point on a Bezier Curve"):
//
//     P[r][i] = (1 - u) P[r-1][i] + u P[r-1][i+1],   r = 1..n, i = 0..n-r,   C = P[n][0],
//
// in homogeneous coordinates for a rational curve, which is then divided by the weight. In blossom form
// P[r][i] = f(0^{n-r-i}, u^r, 1^i).

#include "kernel/error.hpp"
#include "kernel/rules.hpp"

namespace blossom {

// Preconditions: a Bezier curve on [0, 1]; u in [0, 1]. Error: the weight at u is zero.
template <class R>
HPoint<typename R::Number> de_casteljau(const Curve<typename R::Number>& curve, const typename R::Number& parameter,
                                        R& rec) {
  using S = typename R::Number;
  const int n = curve.degree;
  const auto u = rec.input("u"_v, parameter);
  const auto P = rec.inputs("P"_v, 0, std::span<const HPoint<S>>(curve.points));
  if constexpr (R::recording)
    for (int i = 0; i <= n; ++i) rec.polar_bezier(P[i].id, i, n);

  std::array<Traced<HPoint<S>, typename R::Id>, max_degree + 1> row;
  for (int i = 0; i <= n; ++i) row[static_cast<std::size_t>(i)] = {P[i].value, P[i].id};
  for (int r = 1; r <= n; ++r) {
    for (int i = 0; i <= n - r; ++i) {
      auto& left = row[static_cast<std::size_t>(i)];
      left = rec.apply(Blend{}, "P"_v(r, i), u, left, row[static_cast<std::size_t>(i) + 1]);
    }
  }

  const auto& top = row[0];
  if (!curve.rational) return rec.apply(Same{}, "C"_v, top).value;
  if (top.value.w == S(0))
    throw KernelError{"u", "the weight of the point at this parameter is 0: it lies at infinity"};
  return rec.apply(Project{}, "C"_v, top).value;
}

}  // namespace blossom
