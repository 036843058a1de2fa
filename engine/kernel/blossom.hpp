#pragma once
// The blossom, or polar form, of a spline, straight from its definition: the reference that tests hold everything
// else against.
//
// A polynomial piece C of degree p has exactly one function f of p arguments that is symmetric, affine in each argument
// and has f(u, ..., u) = C(u). Its values at runs of consecutive knots are the control points, f(u_{i+1}..u_{i+p}) =
// P_i, and any other value follows from them by p rounds of affine interpolation, each round putting in one argument:
//
//   f_i^0 = P_i,  f_i^r = ((u_{i+p+1-r} - a_r) f_{i-1}^{r-1} + (a_r - u_i) f_i^{r-1}) / (u_{i+p+1-r} - u_i)
//
// and f(a_1..a_p) = f_k^p on the span k. (Ramshaw, "Blossoms are polar forms", CAGD 6, 1989; The NURBS Book,
// section 5.2.)

#include <array>
#include <cassert>
#include <cstddef>
#include <span>

#include "geometry/geometry.hpp"

namespace blossom {

// f(arguments) of the piece of `curve` on the span k, p <= k <= n, u_k < u_{k+1}. `arguments` holds exactly p values,
// in any order; they may lie anywhere, also outside of the span. In homogeneous coordinates, where the blossom is
// affine.
template <Scalar S>
HPoint<S> blossom(const Curve<S>& curve, int k, std::span<const S> arguments) {
  const int p = curve.degree;
  const std::vector<S>& U = curve.knots;
  assert(static_cast<int>(arguments.size()) == p && p <= k && k <= curve.n() && U[k] < U[k + 1]);

  std::array<HPoint<S>, max_degree + 1> f;  // f[i - (k - p)] is f_i of the current round
  for (int i = k - p; i <= k; ++i) f[i - (k - p)] = curve.points[i];
  for (int r = 1; r <= p; ++r) {
    const S& a = arguments[r - 1];
    for (int i = k; i >= k - p + r; --i) {
      const S length = U[i + p + 1 - r] - U[i];
      HPoint<S>& here = f[i - (k - p)];
      here = f[i - 1 - (k - p)] * ((U[i + p + 1 - r] - a) / length) + here * ((a - U[i]) / length);
    }
  }
  return f[p];
}

}  // namespace blossom
