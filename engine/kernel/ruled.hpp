#pragma once
// Ruled surfaces (The NURBS Book 8.4): the segments between the points of equal parameters of two curves,
//
//     S(u, v) = (1 - v) C_0(u) + v C_1(u),   0 <= v <= 1.
//
// The curves are made compatible: one degree and one knot vector. Then their control points are the two columns of the
// net, and the degree along v is 1: Q[i][0] = P[0][i], Q[i][1] = P[1][i]. In homogeneous coordinates when a curve is
// rational. Then, too, each ruling is a straight segment from C_0(u) to C_1(u); where the two curves have different
// weights at u, v does not divide it evenly, but moves faster near the lighter end.

#include "kernel/construction.hpp"

namespace blossom {

// Preconditions: valid curves.
template <class R>
Surface<typename R::Number> ruled(const Curve<typename R::Number>& first, const Curve<typename R::Number>& second,
                                  R& rec) {
  using S = typename R::Number;
  std::vector<MadeCurve<R>> curves;
  curves.push_back(construct::given(rec, first, 0));
  curves.push_back(construct::given(rec, second, 1));
  {
    auto phase = rec.phase({"compatible"});
    make_compatible(rec, curves);
  }

  auto phase = rec.phase({"rulings"});
  const auto& U = curves[0].U;
  const std::vector<S> linear = bezier_knots<S>(1);
  construct::Net<R> net(curves[0].P.size(), 2);
  rec.list("V"_v, std::span<const S>(linear));
  for (int i = 0; i < net.rows; ++i) {
    auto step = rec.one_step();
    for (int j = 0; j < 2; ++j)
      net.set(i, j, rec.apply(PutIntoNet{}, "Q"_v(i, j), curves[static_cast<std::size_t>(j)].P[i]));
  }
  return construct::surface(rec, std::move(net), curves[0].degree, U.values(), 1, std::span<const S>(linear),
                            first.rational || second.rational);
}

}  // namespace blossom
