#pragma once
// Reversal: the same curve run through from its end to its beginning, C(a + b - u) (The NURBS Book 6.5, on reversing
// knots and points). Over the domain [a, b]:
//
//     V_i = a + b - u_{m-i},   Q_i = P_{n-i}.

#include "kernel/knot_insertion.hpp"

namespace blossom {

// a + b - u: the other way round in [a, b]
struct Mirror {
  static constexpr std::string_view name = "mirror";
  static constexpr std::string_view formula = "{0} + {1} - {2}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a, const S& b, const S& u) {
    return a + b - u;
  }
};

// A point that stays, under another number; its polar label is told by the mirrored knots
struct Renumber {
  static constexpr std::string_view name = "renumber";
  static constexpr std::string_view formula = "{0}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A) {
    return A;
  }
};

// Precondition: a valid curve.
template <class R>
Curve<typename R::Number> reversal(const Curve<typename R::Number>& curve, R& rec) {
  const int n = curve.n();
  const int m = curve.m();
  rec.input("n"_v, n);
  rec.input("m"_v, m);
  rec.list("U"_v, curve.knots);
  const auto given = given_curve(rec, curve);
  const auto a = given.U[curve.degree];
  const auto b = given.U[n + 1];

  MadeCurve<R> made;
  made.degree = curve.degree;
  made.dimension = curve.dimension;
  made.rational = curve.rational;
  {
    auto phase = rec.phase({"mirror"});
    made.U.reserve(m + 1);
    for (int i = 0; i <= m; ++i) made.U.push_back(rec.apply(Mirror{}, "V"_v(i), a, b, given.U[m - i]));
  }
  rec.apply(Gather{}, "V"_v, slice(made.U, 0, made.U.size()));
  {
    auto step = rec.one_step();
    made.P.reserve(n + 1);
    for (int i = 0; i <= n; ++i) {
      const auto Q = rec.apply(Renumber{}, "Q"_v(i), given.P[n - i]);
      if constexpr (R::recording) rec.polar_knots(Q.id, made.U[i + 1].id, curve.degree);
      made.P.push_back(Q);
    }
  }
  return {curve.degree, made.U.take(), made.P.take(), curve.dimension, curve.rational, curve.bezier};
}

}  // namespace blossom
