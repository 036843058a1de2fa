#pragma once
// What the constructions of surfaces from curves share: curves as they are given, and the control net they make.

#include "kernel/compatible.hpp"
#include "kernel/error.hpp"

namespace blossom {

// A control point put into the net of a surface. Its polar label is told by the net's knots.
struct PutIntoNet {
  static constexpr std::string_view name = "put_into_net";
  static constexpr std::string_view formula = "{0}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A) {
    return A;
  }
};

// A point (x, y) of a plane curve as (x, 0, y): profiles are drawn in the plane and stand upright in space.
struct StandUp {
  static constexpr std::string_view name = "stand_up";
  static constexpr std::string_view formula = "({0}.x, 0, {0}.y)";
  static constexpr Polar polar = Polar::same;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A) {
    return {A.x, S(0), A.y, A.w};
  }
};

// The i-th of m equal parts of the way from a to b
struct SpanShare {
  static constexpr std::string_view name = "span_share";
  static constexpr std::string_view formula = "{2} + {0}/{1} ({3} - {2})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(int i, int m, const S& a, const S& b) {
    return a + S(i) / S(m) * (b - a);
  }
  template <Scalar S>
  static bool defined(int, int m, const S&, const S&) {
    return m != 0;
  }
};

namespace construct {

// A curve as given: its knots and points as input values with their polar labels. With l < 0 they are called U[j] and
// P[i], with l >= 0 U[l][j] and P[l][i].
template <class R>
MadeCurve<R> given(R& rec, const Curve<typename R::Number>& curve, int l, NameMaker knots = "U"_v,
                   NameMaker points = "P"_v) {
  using S = typename R::Number;
  const std::span<const S> all_knots(curve.knots);
  const std::span<const HPoint<S>> all_points(curve.points);
  const auto U = l < 0 ? rec.inputs(knots, all_knots) : rec.inputs(knots, l, all_knots);
  const auto P = l < 0 ? rec.inputs(points, all_points) : rec.inputs(points, l, all_points);
  MadeCurve<R> made;
  made.degree = curve.degree;
  made.dimension = curve.dimension;
  made.rational = curve.rational;
  made.U.append(U, 0, U.size());
  made.P.append(P, 0, P.size());
  if constexpr (R::recording)
    for (int i = 0; i < P.size(); ++i) rec.polar_knots(P[i].id, U[i + 1].id, curve.degree);
  return made;
}

// A plane curve standing upright in the xz-plane, its points called `upright`; one in space as it is.
template <class R>
MadeCurve<R> stand_up(R& rec, MadeCurve<R> made, NameMaker upright) {
  if (made.dimension == 3) return made;
  auto phase = rec.phase({"upright"});
  auto step = rec.one_step();
  for (int i = 0; i < made.P.size(); ++i) made.P.set(i, rec.apply(StandUp{}, upright(i), made.P[i]));
  made.dimension = 3;
  return made;
}

// A net of control points on its way through an algorithm, row by row.
template <class R>
struct Net {
  int rows = 0, columns = 0;
  Cells<HPoint<typename R::Number>, typename R::Id> P;

  Net(int rows_, int columns_) : rows(rows_), columns(columns_) { P.resize(rows * columns); }
  auto at(int i, int j) const { return P[i * columns + j]; }
  template <class V>
  void set(int i, int j, const V& point) {
    P.set(i * columns + j, point);
  }
};

// The surface with this net, whose points get the polar labels of its knots.
template <class R>
Surface<typename R::Number> surface(R& rec, Net<R>&& net, int p, std::span<const typename R::Number> U, int q,
                                    std::span<const typename R::Number> V, bool rational) {
  using S = typename R::Number;
  Surface<S> made;
  made.degree = {p, q};
  made.knots[0].assign(U.begin(), U.end());
  made.knots[1].assign(V.begin(), V.end());
  made.rows = net.rows;
  made.columns = net.columns;
  made.rational = rational;
  if constexpr (R::recording)
    for (int i = 0; i < net.rows; ++i)
      for (int j = 0; j < net.columns; ++j)
        rec.polar_net(net.at(i, j).id, U.subspan(static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(p)),
                      V.subspan(static_cast<std::size_t>(j) + 1, static_cast<std::size_t>(q)));
  made.points = net.P.take();
  if (!rational)
    for (auto& P : made.points) P.w = S(1);  // up to rounding it is
  return made;
}

}  // namespace construct
}  // namespace blossom
