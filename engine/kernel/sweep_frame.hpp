#pragma once
// The moving frame of a true sweep: where a trajectory is at v, its tangent t, and a normal n and binormal b = t x n
// that are carried along it without turning about t, by double reflection (Wang, Juettler, Zheng, Liu, Computation of
// rotation minimizing frames, ACM TOG 27(1), 2008, table I): reflect the old frame in the plane halfway between both
// points, then in the plane that brings the reflected tangent to the new one. The error falls with the fourth power of
// the steps. The first normal is chosen so that the binormal is as near to the z-axis as it can be: n = z x t / |z x
// t|; where the trajectory begins along the z-axis it is the x-axis.

#include <cmath>

#include "kernel/interpolation.hpp"

namespace blossom {

// a P
struct WeighPoint {
  static constexpr std::string_view name = "weigh_point";
  static constexpr std::string_view formula = "{0} {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const S& a, const HPoint<S>& P) {
    return {a * P.x, a * P.y, a * P.z, a * P.w};
  }
};

// A + a P
struct AddWeighed {
  static constexpr std::string_view name = "add_weighed";
  static constexpr std::string_view formula = "{0} + {1} {2}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const S& a, const HPoint<S>& P) {
    return {A.x + a * P.x, A.y + a * P.y, A.z + a * P.z, A.w + a * P.w};
  }
};

// The direction of motion, of length 1, from the homogeneous point C and its derivative E
struct UnitTangent {
  static constexpr std::string_view name = "unit_tangent";
  static constexpr std::string_view formula = "the direction of motion at {0}, from the derivative {1}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> numerator(const HPoint<S>& C, const HPoint<S>& E) {  // of the quotient's derivative
    return {E.x * C.w - C.x * E.w, E.y * C.w - C.y * E.w, E.z * C.w - C.z * E.w, S(0)};
  }
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& C, const HPoint<S>& E) {
    using std::sqrt;
    const auto d = numerator(C, E);
    const S length = sqrt(S(d.x * d.x + d.y * d.y + d.z * d.z));
    return {d.x / length, d.y / length, d.z / length, S(0)};
  }
  template <Scalar S>
  static bool defined(const HPoint<S>& C, const HPoint<S>& E) {
    const auto d = numerator(C, E);
    return !(C.w == S(0)) && S(0) < d.x * d.x + d.y * d.y + d.z * d.z;
  }
};

// The first normal of a tangent of length 1: z x t, of length 1
struct FirstNormal {
  static constexpr std::string_view name = "first_normal";
  static constexpr std::string_view formula = "z × {0}, of length 1";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& t) {
    using std::sqrt;
    const S square = t.x * t.x + t.y * t.y;
    if (to_double(square) < 1e-20) return {S(1), S(0), S(0), S(0)};
    const S length = sqrt(square);
    return {-t.y / length, t.x / length, S(0), S(0)};
  }
};

// The vector from A to B; of vectors their difference
struct Towards {
  static constexpr std::string_view name = "towards";
  static constexpr std::string_view formula = "{1} - {0}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const HPoint<S>& B) {
    return {B.x - A.x, B.y - A.y, B.z - A.z, S(0)};
  }
};

// The vector a mirrored in the plane across d: a - 2 (a.d)/(d.d) d. Where d is nothing but rounding, a itself.
struct MirrorVector {
  static constexpr std::string_view name = "mirror_vector";
  static constexpr std::string_view formula = "{0} mirrored in the plane across {1}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& a, const HPoint<S>& d) {
    const S square = d.x * d.x + d.y * d.y + d.z * d.z;
    if (to_double(square) < 1e-24) return a;
    const S twice = S(2) * (a.x * d.x + a.y * d.y + a.z * d.z) / square;
    return {a.x - twice * d.x, a.y - twice * d.y, a.z - twice * d.z, S(0)};
  }
};

// a x b
struct CrossProduct {
  static constexpr std::string_view name = "cross_product";
  static constexpr std::string_view formula = "{0} × {1}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& a, const HPoint<S>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x, S(0)};
  }
};

// The profile's point (x, y, z) at the place X in the frame: X + x n + y b + z t, with its weight
struct PlaceInFrame {
  static constexpr std::string_view name = "place_in_frame";
  static constexpr std::string_view formula = "{0} placed at {1} in the frame {3}, {4}, {2}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& P, const HPoint<S>& X, const HPoint<S>& t, const HPoint<S>& n,
                         const HPoint<S>& b) {
    return {P.w * X.x + P.x * n.x + P.y * b.x + P.z * t.x, P.w * X.y + P.x * n.y + P.y * b.y + P.z * t.y,
            P.w * X.z + P.x * n.z + P.y * b.z + P.z * t.z, P.w};
  }
};

namespace sweeping {

template <class R>
using TracedPoint = Traced<HPoint<typename R::Number>, typename R::Id>;

template <class R>
struct Frame {
  TracedPoint<R> X{}, t{}, n{}, b{};
};

// Point and derivative of the clamped trajectory at v, homogeneous, as sums of basis functions times control points;
// then the point X and the tangent t. Errors: no point, no tangent.
template <class R, class Degree, class KnotList, class Parameter>
void locate(R& rec, const MadeCurve<R>& trajectory, const Degree& q, const KnotList& V, const Parameter& v,
            Frame<R>& frame) {
  using S = typename R::Number;
  const auto k = rec.apply(FindSpan{}, "k"_v, q, v, V);
  TracedPoint<R> C{}, E{};
  for (int j = k.value - q.value; j <= k.value; ++j) {
    const bool first = j == k.value - q.value;
    const auto index = rec.input("j"_v(j), j);
    const auto N = rec.apply(BasisValue{}, "N"_v(j), index, q, v, V);
    C = first ? rec.apply(WeighPoint{}, "C"_v(j), N, trajectory.P[j])
              : rec.apply(AddWeighed{}, "C"_v(j), C, N, trajectory.P[j]);
    const auto D = rec.apply(BasisSlope{}, "D"_v(j), index, q, v, V);
    E = first ? rec.apply(WeighPoint{}, "E"_v(j), D, trajectory.P[j])
              : rec.apply(AddWeighed{}, "E"_v(j), E, D, trajectory.P[j]);
  }
  const auto at = [&] { return " at v = " + format_short(to_double(v.value), 6); };
  if (C.value.w == S(0))
    throw KernelError{"trajectory", "has the weight 0" + at() + ": no point to place a section at"};
  if (!UnitTangent::defined<S>(C.value, E.value))
    throw KernelError{"trajectory", "stands still" + at() + ": without a tangent no section can be placed there"};
  frame.X = rec.apply(Project{}, "X"_v, C);
  frame.t = rec.apply(UnitTangent{}, "t"_v, C, E);
}

// The normal and binormal carried on from another frame.
template <class R>
void carry(R& rec, const Frame<R>& from, Frame<R>& to) {
  const auto step = rec.apply(Towards{}, "a"_v, from.X, to.X);
  const auto& d = step.value;
  const double square = to_double(d.x * d.x + d.y * d.y + d.z * d.z);
  const double size =
      to_double(to.X.value.x * to.X.value.x + to.X.value.y * to.X.value.y + to.X.value.z * to.X.value.z);
  if (!(square > 1e-24 * size))
    throw KernelError{"trajectory", "comes back to where the section before stands: more sections are needed"};
  const auto normal = rec.apply(MirrorVector{}, "nm"_v, from.n, step);
  const auto tangent = rec.apply(MirrorVector{}, "tm"_v, from.t, step);
  const auto turn = rec.apply(Towards{}, "d"_v, tangent, to.t);
  to.n = rec.apply(MirrorVector{}, "n"_v, normal, turn);
  to.b = rec.apply(CrossProduct{}, "b"_v, to.t, to.n);
}

}  // namespace sweeping
}  // namespace blossom
