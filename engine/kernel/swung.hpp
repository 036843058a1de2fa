#pragma once
// Swung surfaces (Woodward 1987; The NURBS Book 10.2): a profile P(u) = (Px, 0, Pz) swung about the z-axis along a
// trajectory T(v) = (Tx, Ty, 0), which stretches it on its way by how far it is from the axis:
//
//     S(u, v) = (a Px Tx, a Px Ty, Pz)
//
// The net is the same product of control points, the weights are multiplied. In homogeneous coordinates, where the
// weights are in the points already: Q[i][j] = (a Px Tx, a Px Ty, Pz Tw, Pw Tw). A circle of radius 1 as trajectory,
// and a = 1, give the surface of revolution.

#include <utility>

#include "kernel/construction.hpp"

namespace blossom {

// (a Px Tx, a Px Ty, Pz): the profile's point P stretched along T
struct Swing {
  static constexpr std::string_view name = "swing";
  static constexpr std::string_view formula = "{0} stretched by {2} times {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& P, const HPoint<S>& T, const S& a) {
    const S stretched = a * P.x;
    return {stretched * T.x, stretched * T.y, P.z * T.w, P.w * T.w};
  }
};

// Preconditions: valid curves; the profile lies in the xz-plane, the trajectory in the xy-plane.
template <class R>
Surface<typename R::Number> swung(const Curve<typename R::Number>& profile, const Curve<typename R::Number>& trajectory,
                                  const typename R::Number& scale, R& rec) {
  const auto a = rec.input("a"_v, scale);
  auto plane = construct::given(rec, profile, -1, "U"_v, "P"_v);
  const auto T = construct::given(rec, trajectory, -1, "V"_v, "T"_v);
  const auto P = construct::stand_up(rec, std::move(plane), "G"_v);
  construct::Net<R> net(P.P.size(), T.P.size());
  for (int i = 0; i < net.rows; ++i) {
    auto row = rec.phase({"row", i});
    for (int j = 0; j < net.columns; ++j) net.set(i, j, rec.apply(Swing{}, "Q"_v(i, j), P.P[i], T.P[j], a));
  }
  return construct::surface(rec, std::move(net), P.degree, P.U.values(), T.degree, T.U.values(),
                            profile.rational || trajectory.rational);
}

}  // namespace blossom
