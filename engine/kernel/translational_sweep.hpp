#pragma once
// Translational sweeps (The NURBS Book 10.4, with M = identity): a profile moved along a trajectory without turning,
//
//     S(u, v) = T(v) + P(u),
//
// so that every isoparametric curve is the profile, or the trajectory, moved. The net is the sum of control points, and
// the weights are multiplied; in homogeneous coordinates Q[i][j] = (Tw P + Pw T, Pw Tw).

#include <utility>

#include "kernel/construction.hpp"

namespace blossom {

// P + T, the sum of two points, with the product of their weights
struct MoveAlong {
  static constexpr std::string_view name = "move_along";
  static constexpr std::string_view formula = "{0} moved by {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& P, const HPoint<S>& T) {
    return {T.w * P.x + P.w * T.x, T.w * P.y + P.w * T.y, T.w * P.z + P.w * T.z, P.w * T.w};
  }
};

// Preconditions: valid curves.
template <class R>
Surface<typename R::Number> translational_sweep(const Curve<typename R::Number>& profile,
                                                const Curve<typename R::Number>& trajectory, R& rec) {
  auto plane = construct::given(rec, profile, -1, "U"_v, "P"_v);
  const auto T = construct::given(rec, trajectory, -1, "V"_v, "T"_v);
  const auto P = construct::stand_up(rec, std::move(plane), "G"_v);
  construct::Net<R> net(P.P.size(), T.P.size());
  for (int j = 0; j < net.columns; ++j) {
    auto column = rec.phase({"column", j});
    for (int i = 0; i < net.rows; ++i) net.set(i, j, rec.apply(MoveAlong{}, "Q"_v(i, j), P.P[i], T.P[j]));
  }
  return construct::surface(rec, std::move(net), P.degree, P.U.values(), T.degree, T.U.values(),
                            profile.rational || trajectory.rational);
}

}  // namespace blossom
