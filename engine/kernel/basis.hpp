#pragma once
// B-spline basis functions N_{i,p}, their derivatives and their Greville abscissae.
//
// On the span [u_k, u_{k+1}) exactly N_{k-p,p}..N_{k,p} can differ from zero; they are computed together, level by
// level (The NURBS Book, section 2.2, equation 2.5, with 0/0 = 0):
//
//   N_{i,0}(u) = 1 on [u_i, u_{i+1}), else 0
//   N_{i,q}(u) = (u - u_i)/(u_{i+q} - u_i) N_{i,q-1}(u) + (u_{i+q+1} - u)/(u_{i+q+1} - u_{i+1}) N_{i+1,q-1}(u)
//
// The span decides which polynomial piece is meant: with k from find_span the values are right limits at the knots and
// the left limit at the domain's end. On a nonempty span no denominator is zero.

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "base/scalar.hpp"
#include "geometry/geometry.hpp"
#include "kernel/span.hpp"

namespace blossom {

// Where results go, S deduced from the other arguments.
template <class T>
using Out = std::type_identity_t<std::span<T>>;

namespace detail {

inline constexpr int max_order = max_degree + 1;

// One value per basis function of a span, and one per reciprocal (below): on the stack, whatever the degree.
template <Scalar S>
using BasisRow = std::array<S, max_order>;
template <Scalar S>
using Reciprocals = std::array<S, max_degree * max_order / 2>;

// Calls f(std::integral_constant<int, P>) with P = p for the degrees that get loops of their own, which the compiler
// unrolls (double only), and with P = 0, "known at run time", for the others.
template <Scalar S, class F>
inline decltype(auto) with_degree(int p, F&& f) {
  if constexpr (std::is_same_v<S, double>) {
    if (p == 3) return f(std::integral_constant<int, 3>{});
    if (p == 2) return f(std::integral_constant<int, 2>{});
  }
  return f(std::integral_constant<int, 0>{});
}

// The reciprocals of the p(p+1)/2 knot differences that the span k needs, level after level: for q = 1..p, r = 0..q-1,
// R[q(q-1)/2 + r] = 1/(u_{i+q} - u_i) with i = k + 1 - q + r. `Uk` points to u_k.
template <int P, Scalar S>
inline void knot_reciprocals(const S* Uk, int degree, S* R) {
  const int p = P > 0 ? P : degree;
  for (int q = 1; q <= p; ++q) {
    for (int r = 0; r < q; ++r) *R++ = S(1) / (Uk[1 + r] - Uk[1 + r - q]);
  }
}

// From N_{k-q+1..k, q-1} in N[0..q-1] to N_{k-q..k, q} in N[0..q]; R: the q reciprocals of this level.
template <Scalar S>
inline void raise_basis(const S* Uk, int q, const S& u, const S* R, S* N) {
  S saved(0);
  for (int r = 0; r < q; ++r) {
    const S quotient = N[r] * R[r];
    N[r] = saved + (Uk[1 + r] - u) * quotient;
    saved = (u - Uk[1 + r - q]) * quotient;
  }
  N[q] = saved;
}

// N_{k-p..k, p}(u) in N[0..p]. Algorithm A2.2 with the divisions taken out.
template <int P, Scalar S>
inline void basis_on_span(const S* Uk, int degree, const S& u, const S* R, S* N) {
  const int p = P > 0 ? P : degree;
  N[0] = S(1);
  for (int q = 1; q <= p; ++q) {
    raise_basis(Uk, q, u, R, N);
    R += q;
  }
}

// The same in one go, for a single evaluation.
template <int P, Scalar S>
inline void basis_on_span(const S* Uk, int degree, const S& u, S* N) {
  if constexpr (P > 0) {
    std::array<S, P*(P + 1) / 2> R;
    knot_reciprocals<P>(Uk, degree, R.data());
    basis_on_span<P>(Uk, degree, u, R.data(), N);
  } else {
    Reciprocals<S> R;
    knot_reciprocals<P>(Uk, degree, R.data());
    basis_on_span<P>(Uk, degree, u, R.data(), N);
  }
}

// Row j = 0..d of `ders` (p + 1 values each) receives the j-th derivatives of N_{k-p..k, p} at u, d <= p. Equation 2.9,
// applied j times: N^(j)_{i,q} = q (N^(j-1)_{i,q-1} / (u_{i+q} - u_i) - N^(j-1)_{i+1,q-1} / (u_{i+q+1} - u_{i+1})).
template <int P, Scalar S>
inline void basis_derivatives_on_span(const S* Uk, int degree, const S& u, int d, const S* R, S* ders) {
  const int p = P > 0 ? P : degree;
  const int order = p + 1;
  S* N = ders;  // row 0 passes through every lower degree on its way to p; row j starts from degree p - j
  N[0] = S(1);
  for (int q = 0; q <= p; ++q) {
    if (q > 0) raise_basis(Uk, q, u, R + q * (q - 1) / 2, N);
    const int j = p - q;
    if (j == 0 || j > d) continue;
    S* D = ders + j * order;
    for (int r = 0; r <= q; ++r) D[r] = N[r];
    for (int level = q + 1; level <= p; ++level) {
      const S* reciprocal = R + level * (level - 1) / 2;
      S saved(0);
      for (int r = 0; r < level; ++r) {
        const S slope = S(level) * (D[r] * reciprocal[r]);
        D[r] = saved - slope;
        saved = slope;
      }
      D[level] = saved;
    }
  }
}

}  // namespace detail

// N_{k-p..k, p}(u) in N[0..p]; k: a nonempty span, u in [u_k, u_{k+1}]. N has room for p + 1 values.
template <Scalar S>
void basis_functions(Knots<S> U, int p, int k, const S& u, Out<S> N) {
  assert(p >= 0 && p <= max_degree && N.size() > static_cast<std::size_t>(p));
  detail::with_degree<S>(p, [&](auto P) { detail::basis_on_span<P()>(U.data() + k, p, u, N.data()); });
}

// The derivatives of order 0..d of N_{k-p..k, p} at u: ders[j (p+1) + r] is the j-th derivative of N_{k-p+r, p}. Those
// above the degree are zero. `ders` has room for (d+1)(p+1) values. Does what algorithm A2.3 does.
template <Scalar S>
void basis_derivatives(Knots<S> U, int p, int k, const S& u, int d, Out<S> ders) {
  assert(p >= 0 && p <= max_degree && d >= 0 && ders.size() >= static_cast<std::size_t>((d + 1) * (p + 1)));
  detail::Reciprocals<S> R;
  detail::with_degree<S>(p, [&](auto P) {
    detail::knot_reciprocals<P()>(U.data() + k, p, R.data());
    detail::basis_derivatives_on_span<P()>(U.data() + k, p, u, std::min(d, p), R.data(), ders.data());
  });
  for (int i = (p + 1) * (p + 1); i < (d + 1) * (p + 1); ++i) ders[i] = S(0);
}

// The single basis function N_{i,p}(u), for any real u and without regard to the domain: zero outside of
// [u_i, u_{i+p+1}], the limit from the right at a knot, and from the left at the last knot u_m. Algorithm A2.4.
// Precondition: 0 <= i <= m - p - 1.
template <Scalar S>
S basis_function(Knots<S> U, int p, int i, const S& u) {
  assert(p >= 0 && p <= max_degree && i >= 0 && static_cast<std::size_t>(i + p + 1) < U.size());
  const S* support = U.data() + i;  // u_i..u_{i+p+1}
  const S& last = U.back();
  if (u < support[0] || u > support[p + 1]) return S(0);

  detail::BasisRow<S> N;  // the degree-0 functions i..i+p: one of them is 1, or none
  for (int r = 0; r <= p; ++r) {
    const bool inside = support[r] <= u && u < support[r + 1];
    const bool at_the_end = u == last && support[r] < last && support[r + 1] == last;
    N[r] = S(inside || at_the_end ? 1 : 0);
  }
  for (int q = 1; q <= p; ++q) {
    for (int r = 0; r + q <= p; ++r) {
      // A function of degree q-1 whose knots all coincide is zero, and its quotient counts as zero.
      const S rising = support[r + q] - support[r];
      const S falling = support[r + q + 1] - support[r + 1];
      S value(0);
      if (rising != S(0)) value += (u - support[r]) / rising * N[r];
      if (falling != S(0)) value += (support[r + q + 1] - u) / falling * N[r + 1];
      N[r] = value;
    }
  }
  return N[0];
}

// The Greville abscissa of P_i, the mean of u_{i+1}..u_{i+p}: where a control point acts most nearly, and
// sum_i greville(i) N_{i,p}(u) = u. (Farin, Curves and Surfaces for CAGD, section 8.6.) p >= 1.
template <Scalar S>
S greville_abscissa(Knots<S> U, int p, int i) {
  S sum(0);
  for (int j = i + 1; j <= i + p; ++j) sum += U[j];
  return sum / S(p);
}

// All of them, n + 1 values.
template <Scalar S>
std::vector<S> greville_abscissae(const std::vector<S>& U, int p) {
  std::vector<S> result;
  for (int i = 0; i + p + 1 < static_cast<int>(U.size()); ++i) result.push_back(greville_abscissa<S>(U, p, i));
  return result;
}

}  // namespace blossom
