#pragma once
// A rational plane curve as the shadow of a polynomial one in space (The NURBS Book 1.4 and 4.2; Shene, "NURBS:
// Motivation and Definition"). The control point P_i = (x, y) of weight w stands at (x, y, 1), in the plane at
// height 1. Its vector from the origin, times its weight, is a point of space:
//
//     H[i] = w_i (x_i, y_i, 1) = (w_i x_i, w_i y_i, w_i).
//
// These are the control points of a polynomial B-spline curve. De Boor's algorithm runs on them, in space:
//
//     alpha[r][i] = (u - u_i) / (u_{i+p-r+1} - u_i),  H[r][i] = (1 - alpha) H[r-1][i-1] + alpha H[r-1][i],  H[0] = H,
//
// and its point is seen from the origin, in the plane at height 1: C = H / (height of H). Here all points are points of
// space with weight 1; a weight is a height.

#include "kernel/de_boor.hpp"
#include "kernel/lift.hpp"

namespace blossom {

// w A: the point at height 1 moved along its line through the origin to the height w
struct Lift {
  static constexpr std::string_view name = "lift";
  static constexpr std::string_view formula = "{1} {0}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const S& w) {
    return {w * A.x, w * A.y, w * A.z, A.w};
  }
};

// The point at height 1 on the line from the origin through A
struct Shadow {
  static constexpr std::string_view name = "shadow";
  static constexpr std::string_view formula = "{0} / height";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A) {
    return {A.x / A.z, A.y / A.z, S(1), A.w};
  }
  template <Scalar S>
  static bool defined(const HPoint<S>& A) {
    return !(A.z == S(0));
  }
};

// Preconditions: a valid plane curve without weights of 0, u in its domain. Gives C as a point of the plane at
// height 1. Error: the weight at u is zero.
template <class R>
HPoint<typename R::Number> projection(const Curve<typename R::Number>& curve, const typename R::Number& parameter,
                                      R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const int p = curve.degree;
  const auto degree = rec.input("p"_v, p);
  const auto u = rec.input("u"_v, parameter);
  const auto knots = rec.list("U"_v, curve.knots);
  const auto U = rec.inputs("U"_v, std::span<const S>(curve.knots));
  std::vector<HPoint<S>> plane;
  std::vector<S> weights;
  for (const auto& P : curve.points) {
    plane.push_back(at_height_one(P));
    weights.push_back(P.w);
  }
  const auto P = rec.inputs("P"_v, std::span<const HPoint<S>>(plane));
  const auto w = rec.inputs("w"_v, std::span<const S>(weights));

  Cells<HPoint<S>, Id> H;
  {
    auto phase = rec.phase({"lift"});
    for (int i = 0; i < P.size(); ++i) {
      H.push_back(rec.apply(Lift{}, "H"_v(i), P[i], w[i]));
      if constexpr (R::recording) rec.polar_knots(H[i].id, U[i + 1].id, p);
    }
  }
  const auto top = [&] {
    auto phase = rec.phase({"space"});
    const auto k = rec.apply(FindSpan{}, "k"_v, degree, u, knots);
    const auto s = rec.apply(Multiplicity{}, "s"_v, u, knots);
    const auto [first, last] = points_in_force(U, p, k.value, s.value, u.value);
    const int levels = last - first;
    TriangleRow<R> row;
    for (int j = 0; j <= levels; ++j) row[static_cast<std::size_t>(j)] = {H[first + j].value, H[first + j].id};
    triangle(rec, U, u, row, p, p - levels, last, levels, {"H"_v}, [](int) {});
    return rec.apply(Same{}, "Cw"_v, row[static_cast<std::size_t>(levels)]);
  }();
  if (top.value.z == S(0))
    throw KernelError{"u", "the weight of the point at this parameter is 0: it lies at infinity"};
  auto phase = rec.phase({"shadow"});
  return rec.apply(Shadow{}, "C"_v, top).value;
}

}  // namespace blossom
