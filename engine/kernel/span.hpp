#pragma once
// Where a parameter lies among the knots.
//
// Index conventions of The NURBS Book (Piegl & Tiller), section 2.1: knots u_0..u_m, degree p, n = m - p - 1, domain
// [u_p, u_{n+1}]. Nothing here asks for clamped ends; knots may have any multiplicity up to p + 1, and the domain must
// not be empty (u_p < u_{n+1}).

#include <cassert>
#include <cstddef>
#include <span>
#include <type_traits>

#include "base/scalar.hpp"

namespace blossom {

// The knots as an argument: S is deduced from the other arguments, so a std::vector<S> can be passed as it is.
template <Scalar S>
using Knots = std::type_identity_t<std::span<const S>>;

namespace detail {

// The last k in [first, last] with u_k <= u, or `first` if there is none. The loop has no branch that depends on the
// knots, so random parameters cost no mispredictions.
template <Scalar S>
int last_not_above(const S* U, int first, int last, const S& u) {
  std::ptrdiff_t base = first;
  std::ptrdiff_t length = static_cast<std::ptrdiff_t>(last) - first + 1;
  while (length > 1) {
    const std::ptrdiff_t half = length / 2;
    base += half & -static_cast<std::ptrdiff_t>(U[base + half] <= u);
    length -= half;
  }
  return static_cast<int>(base);
}

}  // namespace detail

// The span k in [p, n] with u_k <= u < u_{k+1}; at the domain's end u = u_{n+1}, where there is none, the last k <= n
// with u_k < u_{k+1} (the curve's limit from the left). The NURBS Book, algorithm A2.1; O(log n).
// Precondition: u_p <= u <= u_{n+1}.
template <Scalar S>
int find_span(Knots<S> U, int p, const S& u) {
  const int n = static_cast<int>(U.size()) - p - 2;
  assert(n >= p && U[static_cast<std::size_t>(p)] <= u && u <= U[static_cast<std::size_t>(n) + 1]);
  int k = detail::last_not_above(U.data(), p, n, u);
  while (k > p && !(U[static_cast<std::size_t>(k)] < U[static_cast<std::size_t>(k) + 1])) --k;  // only at the end
  return k;
}

// How often u occurs among the knots, 0 if it is no knot.
template <Scalar S>
int multiplicity(Knots<S> U, const S& u) {
  const int last = static_cast<int>(U.size()) - 1;
  int count = 0;
  for (int i = detail::last_not_above(U.data(), 0, last, u); i >= 0 && U[static_cast<std::size_t>(i)] == u; --i)
    ++count;
  return count;
}

}  // namespace blossom
