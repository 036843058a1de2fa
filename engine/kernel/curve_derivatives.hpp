#pragma once
// Derivatives of a curve at u, step by step (The NURBS Book 3.3, A3.3, and 4.3, A4.2; Shene, "Derivatives of a B-spline
// Curve"). The d-th derivative of a B-spline curve is a B-spline curve of degree p - d on the same knots, with the
// control points (eq. 3.8)
//
//     P[d][i] = (p-d+1) / (u_{i+p+1} - u_{i+d}) (P[d-1][i+1] - P[d-1][i]),   P[0][i] = P_i,
//
// of which P[d][k-p] .. P[d][k-d] are in force on the span k. Each of these curves is evaluated at u by de Boor's
// algorithm, E[r][i] in a phase "at" of its own. For a rational curve that gives the derivatives A[d] of (wx, wy, wz,
// w), and Leibniz' rule those of the curve itself (eq. 4.8):
//
//     D[d] = (A[d] - sum over i = 1..d of binom(d, i) w^(i) D[d-i]) / w^(0).
//
// At a knot the derivatives are those of the piece to the right, at the domain's end of the piece to the left.

#include "kernel/basis_functions.hpp"
#include "kernel/de_boor.hpp"
#include "kernel/derivatives.hpp"

namespace blossom {

// q / (b - a) (B - A)
struct ControlSlope {
  static constexpr std::string_view name = "control_slope";
  static constexpr std::string_view formula = "{0} / ({2} - {1}) · ({4} - {3})";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(int q, const S& a, const S& b, const HPoint<S>& A, const HPoint<S>& B) {
    const S c = S(q) / (b - a);
    return {c * (B.x - A.x), c * (B.y - A.y), c * (B.z - A.z), c * (B.w - A.w)};
  }
  template <Scalar S>
  static bool defined(int, const S& a, const S& b, const HPoint<S>&, const HPoint<S>&) {
    return !(a == b);
  }
};

// (1 - a) A + a B of vectors
struct BlendVectors {
  static constexpr std::string_view name = "blend_vectors";
  static constexpr std::string_view formula = Blend::formula;
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const S& a, const HPoint<S>& A, const HPoint<S>& B) {
    return Blend::apply<S>(a, A, B);
  }
};

// The same vector under another name
struct SameVector {
  static constexpr std::string_view name = "same_vector";
  static constexpr std::string_view formula = "{0}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A) {
    return A;
  }
};

// Above the degree all derivatives of a polynomial are zero
struct VanishAbove {
  static constexpr std::string_view name = "vanish_above";
  static constexpr std::string_view formula = "zero, beyond the degree {0}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(int) {
    return {S(0), S(0), S(0), S(0)};
  }
};

// X - b w D: what the rule for products takes away
struct TakeProduct {
  static constexpr std::string_view name = "take_product";
  static constexpr std::string_view formula = "{0} - {1} · {2} · {3}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& X, int b, const S& w, const HPoint<S>& D) {
    const S factor = S(b) * w;
    return {X.x - factor * D.x, X.y - factor * D.y, X.z - factor * D.z, X.w - factor * D.w};
  }
};

// X / w
struct DivideVector {
  static constexpr std::string_view name = "divide_vector";
  static constexpr std::string_view formula = "{0} / {1}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& X, const S& w) {
    return {X.x / w, X.y / w, X.z / w, X.w / w};
  }
  template <Scalar S>
  static bool defined(const HPoint<S>&, const S& w) {
    return !(w == S(0));
  }
};

namespace derivative {

template <class R>
using Point = Traced<HPoint<typename R::Number>, typename R::Id>;

// The knots of the d-th derivative: those of the curve without the first d.
template <class Knots>
struct WithoutFirst {
  const Knots& U;
  int d;
  auto operator[](int i) const { return U[i + d]; }
};

// The d-th derivative at u, from its control points P[d][first..]: de Boor's triangle of degree q = p - d with levels
// E[r][i], which ends in `name`. Rules: of points for the curve itself, of vectors for its derivatives.
template <class BlendRule, class SameRule, class R, class Knots, class Points, class Parameter>
Point<R> at(R& rec, const Knots& U, const Points& P, const Parameter& u, int q, int k, int s, int first, int d,
            const Name& name) {
  auto phase = rec.phase({"at", d, true});
  const auto in_force = points_in_force(U, q, k - d, s, u.value);
  const int levels = in_force.last - in_force.first;
  std::vector<Point<R>> row;
  for (int i = in_force.first; i <= in_force.last; ++i) row.push_back({P[i - first].value, P[i - first].id});
  for (int r = 1; r <= levels; ++r)
    for (int j = levels; j >= r; --j) {
      const int i = in_force.first + j;
      const auto alpha = rec.apply(Ratio{}, "alpha"_v(r, i), u, U[i], U[i + q - r + 1]);
      row[static_cast<std::size_t>(j)] = rec.apply(
          BlendRule{}, "E"_v(r, i), alpha, row[static_cast<std::size_t>(j) - 1], row[static_cast<std::size_t>(j)]);
    }
  return rec.apply(SameRule{}, outer(name), row.back());
}

// D[0] .. D[order] of a rational curve from A[0] .. A[order]. Error: the weight at u is zero.
template <class R>
HPoint<typename R::Number> divide(R& rec, const std::vector<Point<R>>& A, int p) {
  using S = typename R::Number;
  const int order = static_cast<int>(A.size()) - 1;
  if (A[0].value.w == S(0))
    throw KernelError{"u", "the weight of the point at this parameter is 0: it lies at infinity"};
  Cells<S, typename R::Id> w;
  for (int i = 0; i <= std::min(order, p); ++i)
    w.push_back(rec.apply(WeightOf{}, "w"_v(i), A[static_cast<std::size_t>(i)]));
  std::vector<Point<R>> D;
  D.push_back(rec.apply(Project{}, "D"_v(0), A[0]));
  for (int d = 1; d <= order; ++d) {
    auto X = A[static_cast<std::size_t>(d)];
    for (int i = 1; i <= std::min(d, p); ++i) {
      const auto binomial =
          rec.input("b"_v(d, i), detail::binomial[static_cast<std::size_t>(d)][static_cast<std::size_t>(i)]);
      X = rec.apply(TakeProduct{}, "X"_v(d, i), X, binomial, w[i], D[static_cast<std::size_t>(d - i)]);
    }
    D.push_back(rec.apply(DivideVector{}, "D"_v(d), X, w[0]));
  }
  return D[0].value;
}

}  // namespace derivative

// Preconditions: a valid curve, u in its domain, order >= 1. Gives the point C = D[0]. Error: the weight at u is zero.
template <class R>
HPoint<typename R::Number> curve_derivatives(const Curve<typename R::Number>& curve,
                                             const typename R::Number& parameter, int order, R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const int p = curve.degree;
  const auto degree = rec.input("p"_v, p);
  const auto u = rec.input("u"_v, parameter);
  const auto knots = rec.list("U"_v, curve.knots);
  const auto U = rec.inputs("U"_v, std::span<const S>(curve.knots));
  const auto given = rec.inputs("P"_v, 0, std::span<const HPoint<S>>(curve.points));
  if constexpr (R::recording)
    for (int i = 0; i < given.size(); ++i) rec.polar_knots(given[i].id, U[i + 1].id, p);

  const auto k = rec.apply(FindSpan{}, "k"_v, degree, u, knots);
  const auto s = rec.apply(Multiplicity{}, "s"_v, u, knots);
  const int first = k.value - p;

  std::vector<Cells<HPoint<S>, Id>> P(1);  // P[d][i] at i - first
  P[0].append(given, first, p + 1);
  for (int d = 1; d <= std::min(order, p); ++d) {
    auto phase = rec.phase({"differences", d});
    const auto q = rec.input("q"_v(d), p - d + 1);
    const auto& before = P.back();
    Cells<HPoint<S>, Id> slopes;
    for (int j = 0; j <= p - d; ++j) {
      const int i = first + j;
      slopes.push_back(rec.apply(ControlSlope{}, "P"_v(d, i), q, U[i + d], U[i + p + 1], before[j], before[j + 1]));
    }
    P.push_back(std::move(slopes));
  }

  const auto symbol = curve.rational ? "A"_v : "D"_v;
  std::vector<derivative::Point<R>> A;
  for (int d = 0; d <= order; ++d) {
    if (d > p) {
      A.push_back(rec.apply(VanishAbove{}, symbol(d), degree));
      continue;
    }
    const auto& points = P[static_cast<std::size_t>(d)];
    const derivative::WithoutFirst<std::remove_cvref_t<decltype(U)>> V{U, d};
    if (d == 0)
      A.push_back(derivative::at<Blend, Same>(rec, V, points, u, p, k.value, s.value, first, d, symbol(d)));
    else
      A.push_back(
          derivative::at<BlendVectors, SameVector>(rec, V, points, u, p - d, k.value, s.value, first, d, symbol(d)));
  }
  return curve.rational ? derivative::divide(rec, A, p) : A[0].value;
}

}  // namespace blossom
