#pragma once
// Points on curves and surfaces, of all four kinds, in either scalar.
//
//   C^w(u)   = sum_i N_{i,p}(u) P_i                         The NURBS Book, algorithms A3.1 and A4.1
//   S^w(u,v) = sum_i sum_j N_{i,p}(u) N_{j,q}(v) P_{i,j}    A3.5 and A4.3
//
// The functions are for a point here and there: they compute everything afresh, allocate nothing, and find the span in
// O(log n). For many points of one curve or surface, the evaluators (evaluator.hpp) keep what depends on the knots
// only. A parameter must lie in the domain [u_p, u_{n+1}]; at a knot where the curve jumps (multiplicity p + 1) the
// value is the limit from the right, at the domain's end that from the left.

#include <cassert>
#include <cmath>
#include <cstring>
#include <optional>

#include "geometry/geometry.hpp"
#include "kernel/basis.hpp"
#include "kernel/span.hpp"

namespace blossom {

// Whether all coordinates are finite. Exact numbers always are.
template <Scalar S>
bool is_finite(const Point<S>& P) {
  if constexpr (std::is_same_v<S, double>) return std::isfinite(P.x) && std::isfinite(P.y) && std::isfinite(P.z);
  return true;
}

// (wx, wy, wz, w) -> (x, y, z). Nothing where there is no point: w = 0, and in double also a w so small that a quotient
// overflows. So what comes out is never a NaN or an infinity.
template <Scalar S>
std::optional<Point<S>> affine_point(const HPoint<S>& P) {
  if (P.w == S(0)) return std::nullopt;
  const Point<S> Q(P.x / P.w, P.y / P.w, P.z / P.w);
  return is_finite(Q) ? std::optional(Q) : std::nullopt;
}

namespace detail {

// A sum of homogeneous points times factors.
template <Scalar S>
class Blend {
 public:
  Blend(const HPoint<S>& P, const S& factor) : sum_(P * factor) {}
  Blend(const Blend& other, const S& factor) : sum_(other.sum_ * factor) {}
  void add(const HPoint<S>& P, const S& factor) { sum_ += P * factor; }
  void add(const Blend& other, const S& factor) { sum_ += other.sum_ * factor; }
  HPoint<S> point() const { return sum_; }

 private:
  HPoint<S> sum_;
};

// In double it is one vector of four, or two of two, x y and z w, where the processor has no longer ones: the compiler,
// left alone with four numbers, vectorizes across points and loses the gain in shuffles. The operations are the same
// ones, so the bits are too.
template <>
class Blend<double> {
 public:
  Blend(const HPoint<double>& P, double factor) {
    for (int i = 0; i < parts; ++i) sum_[i] = load(P, i) * factor;
  }
  Blend(const Blend& other, double factor) {
    for (int i = 0; i < parts; ++i) sum_[i] = other.sum_[i] * factor;
  }
  void add(const HPoint<double>& P, double factor) {
    for (int i = 0; i < parts; ++i) sum_[i] += load(P, i) * factor;
  }
  void add(const Blend& other, double factor) {
    for (int i = 0; i < parts; ++i) sum_[i] += other.sum_[i] * factor;
  }
  HPoint<double> point() const {
    return {sum_[0][0], sum_[0][1], sum_[2 / width][2 % width], sum_[3 / width][3 % width]};
  }

 private:
#ifdef __AVX__
  static constexpr int width = 4;
#else
  static constexpr int width = 2;
#endif
  static constexpr int parts = 4 / width;
  using Part [[gnu::vector_size(width * sizeof(double))]] = double;
  static_assert(sizeof(HPoint<double>) == parts * sizeof(Part));

  [[gnu::always_inline]] static Part load(const HPoint<double>& P, int i) {
    Part part;
    std::memcpy(&part, &P.x + i * width, sizeof part);
    return part;
  }

  Part sum_[parts];
};

// sum_r N[r] P[r], r = 0..p.
template <int P, Scalar S>
inline Blend<S> combine(const S* N, const HPoint<S>* points, int degree) {
  const int p = P > 0 ? P : degree;
  Blend<S> sum(points[0], N[0]);
  for (int r = 1; r <= p; ++r) sum.add(points[r], N[r]);
  return sum;
}

// sum_r sum_s M[r] N[s] P[r][s], r = 0..p, s = 0..q; `stride` points from one row to the next.
template <int P, int Q, Scalar S>
inline Blend<S> combine(const S* M, const S* N, const HPoint<S>* points, std::ptrdiff_t stride, int p_degree,
                        int q_degree) {
  const int p = P > 0 ? P : p_degree;
  Blend<S> sum(combine<Q>(N, points, q_degree), M[0]);
  for (int r = 1; r <= p; ++r) sum.add(combine<Q>(N, points + r * stride, q_degree), M[r]);
  return sum;
}

}  // namespace detail

// The homogeneous point C^w(u).
template <Scalar S>
HPoint<S> homogeneous_point(const Curve<S>& curve, const std::type_identity_t<S>& u) {
  const int p = curve.degree;
  const int k = find_span<S>(curve.knots, p, u);
  return detail::with_degree<S>(p, [&](auto P) {
    detail::BasisRow<S> N;
    detail::basis_on_span<P()>(curve.knots.data() + k, p, u, N.data());
    return detail::combine<P()>(N.data(), curve.points.data() + (k - p), p).point();
  });
}

// The point C(u); nothing where the denominator is zero.
template <Scalar S>
std::optional<Point<S>> point(const Curve<S>& curve, const std::type_identity_t<S>& u) {
  return affine_point(homogeneous_point(curve, u));
}

// The homogeneous point S^w(u, v).
template <Scalar S>
HPoint<S> homogeneous_point(const Surface<S>& surface, const std::type_identity_t<S>& u,
                            const std::type_identity_t<S>& v) {
  const auto [p, q] = surface.degree;
  const int k = find_span<S>(surface.knots[0], p, u);
  const int l = find_span<S>(surface.knots[1], q, v);
  detail::BasisRow<S> M;
  detail::BasisRow<S> N;
  basis_functions<S>(surface.knots[0], p, k, u, M);
  basis_functions<S>(surface.knots[1], q, l, v, N);
  return detail::with_degree<S>(q, [&, p = p, q = q](auto Q) {
    return detail::combine<0, Q()>(M.data(), N.data(), &surface.at(k - p, l - q), surface.columns, p, q).point();
  });
}

// The point S(u, v); nothing where the denominator is zero.
template <Scalar S>
std::optional<Point<S>> point(const Surface<S>& surface, const std::type_identity_t<S>& u,
                              const std::type_identity_t<S>& v) {
  return affine_point(homogeneous_point(surface, u, v));
}

}  // namespace blossom
