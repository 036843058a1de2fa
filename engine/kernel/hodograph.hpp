#pragma once
// The hodograph: the derivative of a B-spline curve as a curve, whose points are the velocities of the given one (The
// NURBS Book 3.3, eqs. 3.4-3.6; Shene, "Derivatives of a B-spline Curve"). It has degree p - 1, the knots without the
// first and the last, and the control points
//
//     c[i] = p / (u_{i+p+1} - u_{i+1}),   Q[i] = c[i] (P_{i+1} - P_i),   i = 0..n-1.
//
// For polynomial curves only: the derivative of a rational curve of degree p is one of degree 2p, over the square of
// the weights (curve_derivatives.hpp gives its values). A knot inside the domain may have multiplicity p at most: where
// the curve jumps it has no derivative. And the degree is at least 2, as a curve of degree 0 is a row of separate
// points.

#include "kernel/knot_insertion.hpp"

namespace blossom {

// p / (b - a)
struct SlopeFactor {
  static constexpr std::string_view name = "slope_factor";
  static constexpr std::string_view formula = "{0} / ({2} - {1})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(int p, const S& a, const S& b) {
    return S(p) / (b - a);
  }
  template <Scalar S>
  static bool defined(int, const S& a, const S& b) {
    return !(a == b);
  }
};

// c (B - A), as a point of the hodograph
struct Velocity {
  static constexpr std::string_view name = "velocity";
  static constexpr std::string_view formula = "{0} · ({2} - {1})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const S& c, const HPoint<S>& A, const HPoint<S>& B) {
    return {c * (B.x - A.x), c * (B.y - A.y), c * (B.z - A.z), S(1)};
  }
};

// The knots without the first and the last one
struct InnerKnots {
  static constexpr std::string_view name = "inner_knots";
  static constexpr std::string_view formula = "{0} without its first and last knot";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static std::vector<S> apply(std::span<const S> U) {
    return {U.begin() + 1, U.end() - 1};
  }
  template <Scalar S>
  static bool defined(std::span<const S> U) {
    return U.size() >= 2;
  }
};

// Preconditions: a valid polynomial curve of degree 2 or more, u_{i+1} < u_{i+p+1} for i = 0..n-1.
template <class R>
Curve<typename R::Number> hodograph(const Curve<typename R::Number>& curve, R& rec) {
  const int p = curve.degree;
  const auto degree = rec.input("p"_v, p);
  const auto knots = rec.list("U"_v, curve.knots);
  const auto given = given_curve(rec, curve);

  Curve<typename R::Number> made{p - 1, {}, {}, curve.dimension, false, curve.bezier};
  for (int i = 0; i < curve.n(); ++i) {
    const auto c = rec.apply(SlopeFactor{}, "c"_v(i), degree, given.U[i + 1], given.U[i + p + 1]);
    made.points.push_back(rec.apply(Velocity{}, "Q"_v(i), c, given.P[i], given.P[i + 1]).value);
  }
  made.knots = rec.apply(InnerKnots{}, "V"_v, knots).value;
  return made;
}

}  // namespace blossom
