#pragma once
// A circular arc as a rational quadratic curve (The NURBS Book 7.5, A7.1; Shene, "NURBS: Circular Arcs and Circles"): n
// = 1..4 pieces of at most 90 degrees. With the half angle h of a piece and the directions d(t) = (cos t, sin t), the
// control point j = 0..2n belongs to the angle t_j = start + j h:
//
//     O + r d(t_j), weight 1,               at the ends of the pieces (j even);
//     O + r/cos(h) d(t_j), weight cos(h),   between them (j odd), where the tangents at both ends meet,
//
// in homogeneous coordinates (cos(h) O + r d(t_j), cos(h)): no division. Cosines are exact where they are rational.

#include "kernel/revolution.hpp"

namespace blossom {

// The angle from a to b
struct Sweep {
  static constexpr std::string_view name = "sweep";
  static constexpr std::string_view formula = "{1} - {0}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a, const S& b) {
    return b - a;
  }
};

// The angle of control point j: a + j h
struct ArcAngle {
  static constexpr std::string_view name = "arc_angle";
  static constexpr std::string_view formula = "{0} + {1} · {2}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a, int j, const S& h) {
    return a + S(j) * h;
  }
};

// O + r (c, s): a point of the circle
struct CirclePoint {
  static constexpr std::string_view name = "circle_point";
  static constexpr std::string_view formula = "{0} + {1} ({2}, {3})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& O, const S& r, const S& c, const S& s) {
    return {O.x + r * c, O.y + r * s, O.z, O.w};
  }
};

// O + r/w (c, s) with the weight w: where the tangents at the ends of a piece meet
struct TangentCorner {
  static constexpr std::string_view name = "tangent_corner";
  static constexpr std::string_view formula = "{0} + {1} / {4} ({2}, {3})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& O, const S& r, const S& c, const S& s, const S& w) {
    return {w * O.x + r * c, w * O.y + r * s, w * O.z, w * O.w};
  }
};

// Preconditions: a centre, a radius above 0, start < end <= start + 360 degrees.
template <class R>
Curve<typename R::Number> circular_arc(const PointRow<typename R::Number>& centre,
                                       const typename R::Number& given_radius, const typename R::Number& start,
                                       const typename R::Number& end, R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const auto O = rec.input("O"_v, centre.points.front());
  const auto r = rec.input("r"_v, given_radius);
  const auto a = rec.input("alpha"_v, start);
  const auto b = rec.input("beta"_v, end);

  const auto theta = rec.apply(Sweep{}, "theta"_v, a, b);
  const auto n = rec.apply(CountArcs{}, "n"_v, theta);
  const auto h = rec.apply(HalfArc{}, "h"_v, theta, n);
  const auto w = rec.apply(Cosine{}, "w"_v, h);
  auto U = rec.apply(ArcKnots{}, "U"_v, n);

  Cells<HPoint<S>, Id> P;
  for (int j = 0; j <= 2 * n.value; ++j) {
    auto phase = rec.phase({"point", j});
    const auto t = rec.apply(ArcAngle{}, "t"_v(j), a, rec.input("j"_v(j), j), h);
    const auto c = rec.apply(Cosine{}, "c"_v(j), t);
    const auto s = rec.apply(Sine{}, "s"_v(j), t);
    P.push_back(j % 2 == 0 ? rec.apply(CirclePoint{}, "P"_v(j), O, r, c, s)
                           : rec.apply(TangentCorner{}, "P"_v(j), O, r, c, s, w));
    if constexpr (R::recording) {
      const std::span<const S> knots(U.value);
      rec.polar_net(P[j].id, knots.subspan(static_cast<std::size_t>(j) + 1, 2), {});
    }
  }
  return {2, std::move(U.value), P.take(), centre.dimension, true, false};
}

}  // namespace blossom
