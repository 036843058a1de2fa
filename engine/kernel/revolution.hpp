#pragma once
// Surfaces of revolution (The NURBS Book 8.5, A8.1): a profile turned about an axis, exactly, as a NURBS surface. Along
// u it is circles, of n = 1..4 arcs of at most 90 degrees, along v the profile. With the half angle h of an arc, a
// control point P of the profile, its foot O on the axis, X = P - O and Y = (axis direction) x X, row i = 0..2n of the
// net at the angle t_i = i h is
//
//     O + cos(t_i) X + sin(t_i) Y                      at the ends of the arcs (i even), with the weight of P;
//     the corner O + (cos(t_i) X + sin(t_i) Y)/cos(h)  between them (i odd), with that weight times cos(h),
//
// where the tangents at the two ends meet. In homogeneous coordinates the latter is cos(h) O + cos(t_i) X + sin(t_i) Y:
// no division. Cosines are exact where they are rational; cos(45) is not, so the corners are mostly approximate.

#include <cmath>
#include <utility>

#include "kernel/construction.hpp"
#include "kernel/parameters.hpp"

namespace blossom {

// How many arcs of at most 90 degrees an angle needs
struct CountArcs {
  static constexpr std::string_view name = "count_arcs";
  static constexpr std::string_view formula = "{0} / 90, rounded up";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static int apply(const S& angle) {
    const double degrees = to_double(angle);  // in either arithmetic, so that both make as many arcs
    return degrees <= 90 ? 1 : degrees <= 180 ? 2 : degrees <= 270 ? 3 : 4;
  }
};

// Half of one of n equal arcs
struct HalfArc {
  static constexpr std::string_view name = "half_arc";
  static constexpr std::string_view formula = "{0} / (2 · {1})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& angle, int arcs) {
    return angle / S(2 * arcs);
  }
  template <Scalar S>
  static bool defined(const S&, int arcs) {
    return arcs > 0 && arcs < 1000;
  }
};

// i times an angle
struct AngleTimes {
  static constexpr std::string_view name = "angle_times";
  static constexpr std::string_view formula = "{0} · {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(int i, const S& angle) {
    return S(i) * angle;
  }
};

namespace revolve {

// The cosine of an angle in degrees: exact at the multiples of 60 and 90 degrees, where it is rational (Niven).
template <Scalar S>
S cosine(const S& degrees) {
  constexpr std::pair<int, int> halves[] = {{0, 2},   {60, 1},  {90, 0},  {120, -1}, {180, -2}, {240, -1},
                                            {270, 0}, {300, 1}, {360, 2}, {-60, 1},  {-90, 0}};
  for (const auto& [angle, twice] : halves)
    if (degrees == S(angle)) return S(twice) / S(2);
  // Folded into [0, 90], so that angles that mirror each other have the same cosines to the last bit.
  double fold = std::fmod(std::abs(to_double(degrees)), 360);
  if (fold > 180) fold = 360 - fold;
  const double size = std::cos((fold > 90 ? 180 - fold : fold) * (3.14159265358979323846 / 180));
  const double value = fold > 90 ? -size : size;
  if constexpr (std::same_as<S, Exact>)
    return Exact::approximate(value);
  else
    return value;
}

template <Scalar S>
bool has_cosine(const S& degrees) {
  return std::abs(to_double(degrees)) < 1e6;
}

}  // namespace revolve

// cos of an angle in degrees
struct Cosine {
  static constexpr std::string_view name = "cosine";
  static constexpr std::string_view formula = "cos({0}°)";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& degrees) {
    return revolve::cosine(degrees);
  }
  template <Scalar S>
  static bool defined(const S& degrees) {
    return revolve::has_cosine(degrees);
  }
};

// sin of an angle in degrees
struct Sine {
  static constexpr std::string_view name = "sine";
  static constexpr std::string_view formula = "sin({0}°)";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& degrees) {
    return revolve::cosine(S(degrees - S(90)));
  }
  template <Scalar S>
  static bool defined(const S& degrees) {
    return revolve::has_cosine(degrees);
  }
};

// The point of the line through A and B that is nearest to P; with the weight of P
struct Foot {
  static constexpr std::string_view name = "foot";
  static constexpr std::string_view formula = "foot of {0} on the line {1} {2}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& P, const HPoint<S>& A, const HPoint<S>& B) {
    const S x = B.x - A.x, y = B.y - A.y, z = B.z - A.z;
    const S along = (P.x - P.w * A.x) * x + (P.y - P.w * A.y) * y + (P.z - P.w * A.z) * z;
    const S t = along / (x * x + y * y + z * z);
    return {P.w * A.x + t * x, P.w * A.y + t * y, P.w * A.z + t * z, P.w};
  }
  template <Scalar S>
  static bool defined(const HPoint<S>&, const HPoint<S>& A, const HPoint<S>& B) {
    return A.w == S(1) && B.w == S(1) && !(A == B);
  }
};

// P - O: from the axis to the point
struct Spoke {
  static constexpr std::string_view name = "spoke";
  static constexpr std::string_view formula = "{0} - {1}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& P, const HPoint<S>& O) {
    return {P.x - O.x, P.y - O.y, P.z - O.z, S(0)};
  }
};

// X turned by 90 degrees about the axis from A to B, whose length is L
struct QuarterTurn {
  static constexpr std::string_view name = "quarter_turn";
  static constexpr std::string_view formula = "({1} - {0}) × {3} / {2}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const HPoint<S>& B, const S& L, const HPoint<S>& X) {
    const S x = (B.x - A.x) / L, y = (B.y - A.y) / L, z = (B.z - A.z) / L;
    return {y * X.z - z * X.y, z * X.x - x * X.z, x * X.y - y * X.x, S(0)};
  }
  template <Scalar S>
  static bool defined(const HPoint<S>& A, const HPoint<S>& B, const S& L, const HPoint<S>&) {
    return A.w == S(1) && B.w == S(1) && !(L == S(0));
  }
};

// Where an arc ends: a point of the circle
struct OnCircle {
  static constexpr std::string_view name = "on_circle";
  static constexpr std::string_view formula = "{0} + {3} {1} + {4} {2}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& O, const HPoint<S>& X, const HPoint<S>& Y, const S& c, const S& s) {
    return {O.x + c * X.x + s * Y.x, O.y + c * X.y + s * Y.y, O.z + c * X.z + s * Y.z, O.w};
  }
};

// Where the tangents at the ends of an arc meet, with the weight w
struct CircleCorner {
  static constexpr std::string_view name = "circle_corner";
  static constexpr std::string_view formula = "{5} {0} + {3} {1} + {4} {2}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& O, const HPoint<S>& X, const HPoint<S>& Y, const S& c, const S& s,
                         const S& w) {
    return {w * O.x + c * X.x + s * Y.x, w * O.y + c * X.y + s * Y.y, w * O.z + c * X.z + s * Y.z, w * O.w};
  }
};

// The knots of a circle of n arcs: 0 three times, k/n twice each, 1 three times
struct ArcKnots {
  static constexpr std::string_view name = "arc_knots";
  static constexpr std::string_view formula = "the knots of {0} arcs";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static std::vector<S> apply(int arcs) {
    std::vector<S> U(3, S(0));
    for (int k = 1; k < arcs; ++k) U.insert(U.end(), 2, S(k) / S(arcs));
    U.insert(U.end(), 3, S(1));
    return U;
  }
  template <Scalar S>
  static bool defined(int arcs) {
    return arcs > 0 && arcs < 1000;
  }
};

// Preconditions: a valid profile, two points of the axis that differ, 0 < degrees <= 360.
template <class R>
Surface<typename R::Number> revolution(const Curve<typename R::Number>& profile,
                                       const PointRow<typename R::Number>& axis, const typename R::Number& degrees,
                                       R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const auto theta = rec.input("theta"_v, degrees);
  auto plane = construct::given(rec, profile, -1, "V"_v, "P"_v);
  Cells<HPoint<S>, Id> A;  // behind the control points, which are counted among the points that are given
  A.append(rec.inputs("A"_v, std::span<const HPoint<S>>(axis.points)), 0, 2);
  const auto curve = construct::stand_up(rec, std::move(plane), "G"_v);
  if (axis.dimension == 2) {
    auto phase = rec.phase({"axis"});
    auto step = rec.one_step();
    for (int i = 0; i < 2; ++i) A.set(i, rec.apply(StandUp{}, "B"_v(i), A[i]));
  }

  Traced<int, Id> n{};
  Traced<S, Id> w{};
  Traced<std::vector<S>, Id> U{};
  Cells<S, Id> c, s;
  {
    auto phase = rec.phase({"arcs"});
    n = rec.apply(CountArcs{}, "n"_v, theta);
    const auto h = rec.apply(HalfArc{}, "h"_v, theta, n);
    w = rec.apply(Cosine{}, "w"_v, h);
    for (int i = 0; i <= 2 * n.value; ++i) {
      auto step = rec.one_step();
      const auto t = rec.apply(AngleTimes{}, "t"_v(i), rec.input("i"_v(i), i), h);
      c.push_back(rec.apply(Cosine{}, "c"_v(i), t));
      s.push_back(rec.apply(Sine{}, "s"_v(i), t));
    }
    U = rec.apply(ArcKnots{}, "U"_v, n);
  }

  auto phase = rec.phase({"turn"});
  const auto L = rec.apply(Distance{}, "L"_v, A[0], A[1]);
  construct::Net<R> net(2 * n.value + 1, curve.P.size());
  for (int j = 0; j < net.columns; ++j) {
    auto circle = rec.phase({"circle", j, true});
    const auto O = rec.apply(Foot{}, "O"_v, curve.P[j], A[0], A[1]);
    const auto X = rec.apply(Spoke{}, "X"_v, curve.P[j], O);
    const auto Y = rec.apply(QuarterTurn{}, "Y"_v, A[0], A[1], L, X);
    for (int i = 0; i < net.rows; ++i) {
      const auto name = outer("Q"_v(i, j));
      net.set(i, j,
              i % 2 == 0 ? rec.apply(OnCircle{}, name, O, X, Y, c[i], s[i])
                         : rec.apply(CircleCorner{}, name, O, X, Y, c[i], s[i], w));
    }
  }
  return construct::surface(rec, std::move(net), 2, std::span<const S>(U.value), curve.degree, curve.U.values(), true);
}

}  // namespace blossom
