#pragma once
// Knot splitting: the copies of a multiple knot u are moved apart, evenly, and the control points stay where they are
// (DesignMentor's "knot splitting"). The curve becomes smoother there, and it changes: with s copies of u between the
// knots a and b next to it,
//
//     g = min(u - a, b - u),  h = apart g,  t[j] = (2j - s + 1) / (s - 1),  V[f + j] = u + t[j] h,   j = 0..s-1,
//
// where u_f is the first copy. How much it changes is shown where it changes most visibly: delta is the distance of the
// old and the new point at u.

#include "kernel/compatible.hpp"
#include "kernel/de_boor.hpp"
#include "kernel/knot_insertion.hpp"
#include "kernel/parameters.hpp"

namespace blossom {

// How far it is to the nearer one of two neighbours
struct NearestKnot {
  static constexpr std::string_view name = "nearest_knot";
  static constexpr std::string_view formula = "min({0} - {1}, {2} - {0})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& u, const S& a, const S& b) {
    const S before = u - a;
    const S behind = b - u;
    return behind < before ? behind : before;
  }
};

// A part of a length
struct PartOfGap {
  static constexpr std::string_view name = "part_of_gap";
  static constexpr std::string_view formula = "{0} · {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& part, const S& length) {
    return part * length;
  }
};

// u + t h
struct SpreadKnot {
  static constexpr std::string_view name = "spread_knot";
  static constexpr std::string_view formula = "{0} + {1} · {2}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& u, const S& t, const S& h) {
    return u + t * h;
  }
};

namespace splitting {

// The knots with the copies of u moved apart.
template <class R, class Knots, class KnotList, class Parameter, class Part>
Cells<typename R::Number, typename R::Id> spread(R& rec, const Knots& U, const KnotList& knots, const Parameter& u,
                                                 const Part& apart) {
  const auto k = rec.apply(LastKnot{}, "k"_v, u, knots);
  const auto s = rec.apply(Multiplicity{}, "s"_v, u, knots);
  const int first = k.value - s.value + 1;
  const auto gap = rec.apply(NearestKnot{}, "g"_v, u, U[first - 1], U[k.value + 1]);
  const auto h = rec.apply(PartOfGap{}, "h"_v, apart, gap);
  Cells<typename R::Number, typename R::Id> V;
  V.append(U, 0, U.size());
  for (int j = 0; j < s.value; ++j) {
    const auto numerator = rec.input("a"_v(j), 2 * j - s.value + 1);
    const auto t = rec.apply(Fraction{}, "t"_v(j), numerator, rec.input("b"_v(j), s.value - 1));
    V.set(first + j, rec.apply(SpreadKnot{}, "V"_v(first + j), u, t, h));
  }
  return V;
}

// The point from its homogeneous one. Error: its weight is zero.
template <class R, class Top>
auto point(R& rec, const Top& top, bool rational, const Name& name) {
  if (!rational) return rec.apply(Same{}, name, top);
  if (top.value.w == typename R::Number(0))
    throw KernelError{"u", "the weight of the point at this knot is 0: it lies at infinity"};
  return rec.apply(Project{}, name, top);
}

}  // namespace splitting

// Preconditions: a valid curve; u a knot inside its domain, of multiplicity 2 or more; 0 < apart < 1.
template <class R>
Curve<typename R::Number> knot_splitting(const Curve<typename R::Number>& curve, const typename R::Number& parameter,
                                         const typename R::Number& fraction, R& rec) {
  using S = typename R::Number;
  const auto degree = rec.input("p"_v, curve.degree);
  const auto u = rec.input("u"_v, parameter);
  const auto apart = rec.input("apart"_v, fraction);
  const auto knots = rec.list("U"_v, curve.knots);
  const auto U = rec.inputs("U"_v, std::span<const S>(curve.knots));
  const auto P = rec.inputs("P"_v, 0, std::span<const HPoint<S>>(curve.points));
  if constexpr (R::recording)
    for (int i = 0; i < P.size(); ++i) rec.polar_knots(P[i].id, U[i + 1].id, curve.degree);

  const auto V = splitting::spread(rec, U, knots, u, apart);
  auto made = rec.apply(Gather{}, "V"_v, slice(V, 0, V.size()));

  // The phases are de Boor's algorithm, which names its knots U.
  const auto before = [&] {
    auto phase = rec.phase({"old", -1, true, "de_boor"});
    return de_boor_point(rec, degree, U, knots, P, u);
  }();
  const auto C0 = splitting::point(rec, before, curve.rational, "C"_v(0));
  // The same points are another curve's over the new knots: its blossom gives their labels.
  Cells<HPoint<S>, typename R::Id> Q;
  Q.reserve(P.size());
  {
    auto phase = rec.phase({"net"});
    auto step = rec.one_step();
    for (int i = 0; i < P.size(); ++i) {
      Q.push_back(rec.apply(Reparametrize{}, "Q"_v(i), P[i]));
      if constexpr (R::recording)
        rec.polar_net(Q[i].id,
                      std::span<const S>(made.value)
                          .subspan(static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(curve.degree)),
                      {});
    }
  }
  const auto behind = [&] {
    auto phase = rec.phase({"new", -1, true, "de_boor"});
    const auto list = rec.apply(Gather{}, "U"_v, slice(V, 0, V.size()));
    return de_boor_point(rec, degree, V, list, Q, u);
  }();
  const auto C1 = splitting::point(rec, behind, curve.rational, "C"_v(1));
  rec.apply(Distance{}, "delta"_v, C0, C1);
  return {curve.degree, std::move(made.value), curve.points, curve.dimension, curve.rational, false};
}

}  // namespace blossom
