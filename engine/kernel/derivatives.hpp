#pragma once
// Derivatives of curves and surfaces of any order, and surface normals.
//
// The homogeneous derivatives A^(j) = sum_i N_{i,p}^(j)(u) P_i are those of a polynomial curve in four dimensions. With
// A = w C, Leibniz' rule gives those of the curve itself (The NURBS Book, section 4.3, equation 4.8, algorithm A4.2):
//
//   C^(k)   = (A^(k) - sum_{i=1..k} binom(k,i) w^(i) C^(k-i)) / w
//   S^(k,l) = (A^(k,l) - sum_{(i,j) != (0,0)} binom(k,i) binom(l,j) w^(i,j) S^(k-i,l-j)) / w       (eq. 4.20, A4.4)
//
// Orders go up to max_degree. At knots the derivatives are those of the piece to the right, at the domain's end of the
// piece to the left.

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>

#include "geometry/geometry.hpp"
#include "kernel/basis.hpp"
#include "kernel/evaluate.hpp"
#include "kernel/span.hpp"

namespace blossom {

namespace detail {

// Pascal's triangle: binom(n, i) at [n][i].
inline constexpr auto binomial = [] {
  std::array<std::array<int, max_order>, max_order> rows{};
  for (std::size_t n = 0; n < rows.size(); ++n) {
    rows[n][0] = 1;
    for (std::size_t i = 1; i <= n; ++i) rows[n][i] = rows[n - 1][i - 1] + (i < n ? rows[n - 1][i] : 0);
  }
  return rows;
}();

// The derivatives of order 0..p of the p + 1 basis functions of a span, row after row.
template <Scalar S>
using DerivativeRows = std::array<S, max_order * max_order>;

template <Scalar S>
Point<S> xyz(const HPoint<S>& P) {
  return {P.x, P.y, P.z};
}

// sink(j, A^(j)) for j = 0..min(d, p); all higher ones are zero. `points` are P_{k-p}..P_k.
template <int P, Scalar S, class Sink>
inline void homogeneous_derivatives(const S* Uk, int p, const S* R, const HPoint<S>* points, const S& u, int d,
                                    Sink&& sink) {
  std::conditional_t<(P > 0), std::array<S, (P + 1) * (P + 1)>, DerivativeRows<S>> ders;
  const int last = std::min(d, p);
  basis_derivatives_on_span<P>(Uk, p, u, last, R, ders.data());
  for (int j = 0; j <= last; ++j) sink(j, combine<P>(ders.data() + j * (p + 1), points, p).point());
}

// In: C[k] = xyz of A^(k), k = 0..d, and the derivatives of w, zero above order `last`. Out: C[k] = C^(k). Algorithm
// A4.2.
template <Scalar S>
bool divide_by_weight(Point<S>* C, int d, const S* w, int last) {
  if (w[0] == S(0)) return false;
  for (int k = 0; k <= d; ++k) {
    for (int i = 1; i <= std::min(k, last); ++i) C[k] -= C[k - i] * (S(binomial[k][i]) * w[i]);
    C[k] /= w[0];
    if (!is_finite(C[k])) return false;
  }
  return true;
}

template <int P, Scalar S>
inline bool curve_derivatives(const S* Uk, int p, const S* R, const HPoint<S>* points, const S& u, int d, Point<S>* C) {
  BasisRow<S> w;
  homogeneous_derivatives<P>(Uk, p, R, points, u, d, [&](int j, const HPoint<S>& A) {
    C[j] = xyz(A);
    w[j] = A.w;
  });
  for (int j = p + 1; j <= d; ++j) C[j] = Point<S>(S(0));
  return divide_by_weight(C, d, w.data(), std::min(d, p));
}

}  // namespace detail

// A[j] = j-th derivative of C^w at u, j = 0..d; zero above the degree. A has room for d + 1 points.
template <Scalar S>
void homogeneous_derivatives(const Curve<S>& curve, const std::type_identity_t<S>& u, int d, Out<HPoint<S>> A) {
  assert(d >= 0 && A.size() > static_cast<std::size_t>(d));
  const int p = curve.degree;
  const int k = find_span<S>(curve.knots, p, u);
  const S* Uk = curve.knots.data() + k;
  detail::Reciprocals<S> R{};
  detail::knot_reciprocals<0>(Uk, p, R.data());
  detail::homogeneous_derivatives<0>(Uk, p, R.data(), curve.points.data() + (k - p), u, d,
                                     [&](int j, const HPoint<S>& value) { A[j] = value; });
  for (int j = p + 1; j <= d; ++j) A[j] = HPoint<S>(S(0));
}

// C[j] = j-th derivative of C at u, j = 0..d, d <= max_degree. False where the denominator is zero; C then holds
// nothing of use. C has room for d + 1 points.
template <Scalar S>
[[nodiscard]] bool derivatives(const Curve<S>& curve, const std::type_identity_t<S>& u, int d, Out<Point<S>> C) {
  assert(d >= 0 && d <= max_degree && C.size() > static_cast<std::size_t>(d));
  const int p = curve.degree;
  const int k = find_span<S>(curve.knots, p, u);
  const S* Uk = curve.knots.data() + k;
  return detail::with_degree<S>(p, [&](auto P) {
    detail::Reciprocals<S> R;
    detail::knot_reciprocals<P()>(Uk, p, R.data());
    return detail::curve_derivatives<P()>(Uk, p, R.data(), curve.points.data() + (k - p), u, d, C.data());
  });
}

// Derivs[k (d+1) + l] = the derivative of S, k times by u and l times by v, for all k + l <= d, d <= max_degree (the
// other entries are not touched). False where the denominator is zero. Derivs has room for (d+1)^2 points.
template <Scalar S>
[[nodiscard]] bool derivatives(const Surface<S>& surface, const std::type_identity_t<S>& u,
                               const std::type_identity_t<S>& v, int d, Out<Point<S>> Derivs) {
  assert(d >= 0 && d <= max_degree && Derivs.size() >= static_cast<std::size_t>((d + 1) * (d + 1)));
  const auto [p, q] = surface.degree;
  const int k0 = find_span<S>(surface.knots[0], p, u);
  const int l0 = find_span<S>(surface.knots[1], q, v);
  const int last_u = std::min(d, p);
  const int last_v = std::min(d, q);
  detail::DerivativeRows<S> M;
  detail::DerivativeRows<S> N;
  basis_derivatives<S>(surface.knots[0], p, k0, u, last_u, M);
  basis_derivatives<S>(surface.knots[1], q, l0, v, last_v, N);

  detail::DerivativeRows<S> w;  // w^(i,j) at [i (last_v + 1) + j]
  for (int k = 0; k <= d; ++k) {
    for (int l = 0; k + l <= d; ++l) {
      Point<S>& D = Derivs[k * (d + 1) + l];
      D = Point<S>(S(0));
      if (k <= last_u && l <= last_v) {
        const HPoint<S> A = detail::combine<0, 0>(M.data() + k * (p + 1), N.data() + l * (q + 1),
                                                  &surface.at(k0 - p, l0 - q), surface.columns, p, q)
                                .point();
        D = detail::xyz(A);
        w[k * (last_v + 1) + l] = A.w;
      }
      if (w[0] == S(0)) return false;
      for (int i = 0; i <= std::min(k, last_u); ++i) {
        for (int j = i == 0 ? 1 : 0; j <= std::min(l, last_v); ++j) {
          const S factor = S(detail::binomial[k][i]) * S(detail::binomial[l][j]) * w[i * (last_v + 1) + j];
          D -= Derivs[(k - i) * (d + 1) + (l - j)] * factor;
        }
      }
      D /= w[0];
      if (!is_finite(D)) return false;
    }
  }
  return true;
}

namespace detail {

template <Scalar S>
S max_norm(const Point<S>& P) {
  using std::abs;
  return std::max({S(abs(P.x)), S(abs(P.y)), S(abs(P.z))});
}

// Bounds on what rounding can leave of S_u, S_v and S_uv where they are zero: 1e-12 of the sum of the absolute terms.
struct RoundingNoise {
  double u, v, uv;
};

inline RoundingNoise rounding_noise(const Surface<double>& surface, double u, double v, const Point<double>& S) {
  const auto [p, q] = surface.degree;
  const int k = find_span<double>(surface.knots[0], p, u);
  const int l = find_span<double>(surface.knots[1], q, v);
  DerivativeRows<double> M;
  DerivativeRows<double> N;
  basis_derivatives<double>(surface.knots[0], p, k, u, 1, M);
  basis_derivatives<double>(surface.knots[1], q, l, v, 1, N);
  double slope_u = 0;
  double slope_v = 0;
  for (int r = 0; r <= p; ++r) slope_u += std::abs(M[p + 1 + r]);
  for (int r = 0; r <= q; ++r) slope_v += std::abs(N[q + 1 + r]);
  double largest = 0;
  double w = 0;
  for (int i = 0; i <= p; ++i) {
    for (int j = 0; j <= q; ++j) {
      const HPoint<double>& P = surface.at(k - p + i, l - q + j);
      largest = std::max(largest, max_norm(xyz(P)) + std::abs(P.w) * max_norm(S));
      w += M[i] * N[j] * P.w;
    }
  }
  const double unit = 1e-12 * largest / std::abs(w);
  return {unit * slope_u, unit * slope_v, unit * slope_u * slope_v};
}

}  // namespace detail

// A vector along the normal, S_u x S_v up to a positive factor.
//
// Where one of the two tangents vanishes along a whole boundary (the pole of a sphere: S_u = 0 at all of v = v_end), it
// is the limit from inside of the domain: near the boundary S_u = (v - v_end) S_uv, so S_uv, turned to point inward,
// takes the place of S_u. Nothing where that does not help (both tangents zero, parallel tangents, a pinch in the
// interior, whose two sides have opposite normals), and where the denominator is zero. In double, a tangent counts as
// zero when rounding alone could have made it.
template <Scalar S>
std::optional<Point<S>> normal_direction(const Surface<S>& surface, const std::type_identity_t<S>& u,
                                         const std::type_identity_t<S>& v) {
  std::array<Point<S>, 9> D;
  if (!derivatives(surface, u, v, 2, D)) return std::nullopt;
  Point<S> Su = D[3];
  Point<S> Sv = D[1];
  const Point<S>& Suv = D[4];

  S noise_u(0), noise_v(0), noise_uv(0);
  if constexpr (std::is_same_v<S, double>) {
    const auto noise = detail::rounding_noise(surface, u, v, D[0]);
    noise_u = noise.u, noise_v = noise.v, noise_uv = noise.uv;
  }
  const auto [p, q] = surface.degree;
  const bool u_vanishes = detail::max_norm(Su) <= noise_u;
  const bool v_vanishes = detail::max_norm(Sv) <= noise_v;
  if (u_vanishes && v_vanishes) return std::nullopt;
  if (u_vanishes) {
    const bool at_begin = v == surface.knots[1][q];
    const bool at_end = v == surface.knots[1][surface.columns];
    if (!at_begin && !at_end) return std::nullopt;
    Su = at_end ? -Suv : Suv;
    noise_u = noise_uv;
  } else if (v_vanishes) {
    const bool at_begin = u == surface.knots[0][p];
    const bool at_end = u == surface.knots[0][surface.rows];
    if (!at_begin && !at_end) return std::nullopt;
    Sv = at_end ? -Suv : Suv;
    noise_v = noise_uv;
  }

  // Both factors are scaled to size 1, so that neither squares nor products can overflow or vanish.
  const S size_u = detail::max_norm(Su);
  const S size_v = detail::max_norm(Sv);
  if (size_u <= noise_u || size_v <= noise_v) return std::nullopt;
  const Point<S> a = Su / size_u;
  const Point<S> b = Sv / size_v;
  const Point<S> normal(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
  if (detail::max_norm(normal) <= noise_u / size_u + noise_v / size_v) return std::nullopt;
  return normal;
}

// The same, of length 1.
inline std::optional<Point<double>> unit_normal(const Surface<double>& surface, double u, double v) {
  const auto normal = normal_direction(surface, u, v);
  return normal ? std::optional(*normal / glm::length(*normal)) : std::nullopt;
}

struct PointAndNormal {
  Point<double> point;
  std::optional<Point<double>> normal;  // as unit_normal
};

namespace detail {

// S^w and its two first derivatives.
struct TangentPlane {
  HPoint<double> S, Su, Sv;
};

// From the basis functions of both directions and their first derivatives; each row of the net is read once.
template <int P, int Q>
inline TangentPlane tangent_plane(const double* M, const double* dM, const double* N, const double* dN,
                                  const HPoint<double>* points, std::ptrdiff_t stride, int p_degree, int q_degree) {
  const int p = P > 0 ? P : p_degree;
  const Blend<double> first = combine<Q>(N, points, q_degree);
  Blend<double> S(first, M[0]);
  Blend<double> Su(first, dM[0]);
  Blend<double> Sv(combine<Q>(dN, points, q_degree), M[0]);
  for (int r = 1; r <= p; ++r) {
    points += stride;
    const Blend<double> row = combine<Q>(N, points, q_degree);
    S.add(row, M[r]);
    Su.add(row, dM[r]);
    Sv.add(combine<Q>(dN, points, q_degree), M[r]);
  }
  return {S.point(), Su.point(), Sv.point()};
}

// The unit normal at `point`, provided it is safely away from all degenerate cases: both tangents of comparable size
// (over the whole domain, whose lengths are given) and not nearly parallel. The doubtful cases are for unit_normal.
// With S_u = (A_u - w_u S) / w, the positive factor 1/w^2 is left out.
inline bool plain_unit_normal(const TangentPlane& plane, const Point<double>& point, double length_u, double length_v,
                              Point<double>& normal) {
  const Point<double> a = (xyz(plane.Su) - point * plane.Su.w) * length_u;
  const Point<double> b = (xyz(plane.Sv) - point * plane.Sv.w) * length_v;
  const Point<double> cross = glm::cross(a, b);
  const double aa = glm::dot(a, a);
  const double bb = glm::dot(b, b);
  const double cc = glm::dot(cross, cross);
  constexpr double doubtful = 1e-12;  // of squares: one part in a million
  if (!(aa > doubtful * bb && bb > doubtful * aa && cc > doubtful * (aa * bb) && std::isfinite(cc))) return false;
  normal = cross * (1.0 / std::sqrt(cc));
  return true;
}

// Both from the tangent plane at (u, v), whether plain or not.
inline std::optional<PointAndNormal> point_and_normal(const TangentPlane& plane, const Surface<double>& surface,
                                                      double u, double v, double length_u, double length_v) {
  const auto point = affine_point(plane.S);
  if (!point) return std::nullopt;
  Point<double> normal;
  if (plain_unit_normal(plane, *point, length_u, length_v, normal)) return PointAndNormal{*point, normal};
  return PointAndNormal{*point, unit_normal(surface, u, v)};
}

}  // namespace detail

// The point with its unit normal, which is that of unit_normal; nothing where the denominator is zero.
inline std::optional<PointAndNormal> point_and_normal(const Surface<double>& surface, double u, double v) {
  const auto [p, q] = surface.degree;
  const auto& [U, V] = surface.knots;
  const int k = find_span<double>(U, p, u);
  const int l = find_span<double>(V, q, v);
  // The derivatives of order 0 and 1; the unrolled loops serve surfaces of the same degree in both directions.
  const auto plane = detail::with_degree<double>(p == q ? p : 0, [&, p = p, q = q, &U = U, &V = V](auto P) {
    std::array<double, 2 * (P() > 0 ? P() + 1 : detail::max_order)> M, N;
    detail::Reciprocals<double> R;
    detail::knot_reciprocals<P()>(U.data() + k, p, R.data());
    detail::basis_derivatives_on_span<P()>(U.data() + k, p, u, 1, R.data(), M.data());
    detail::knot_reciprocals<P()>(V.data() + l, q, R.data());
    detail::basis_derivatives_on_span<P()>(V.data() + l, q, v, 1, R.data(), N.data());
    return detail::tangent_plane<P(), P()>(M.data(), M.data() + p + 1, N.data(), N.data() + q + 1,
                                           &surface.at(k - p, l - q), surface.columns, p, q);
  });
  return detail::point_and_normal(plane, surface, u, v, U[surface.rows] - U[p], V[surface.columns] - V[q]);
}

}  // namespace blossom
