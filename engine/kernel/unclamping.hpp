#pragma once
// Unclamping: the same curve with single knots beyond the ends of its domain, as a curve needs that is to be joined
// with itself (The NURBS Book 12.2, A12.1). The new knots are as far apart as the first and the last span are long,
// h[0] and h[1]. Each control point near an end exchanges its arguments there for the new knots, one by one; in place,
//
//     left    for r = 1..p-1, j = r-1..0:  P[j] = (1 - beta) P[j] + beta P[j+1],
//             beta = (c - a) / (u_{p+j+1} - a),          c = u_{p-r+j}, new,     a = u_p
//     right   for r = 1..p-1, j = r-1..0:  P[n-j] = (1 - beta) P[n-j-1] + beta P[n-j],
//             beta = (c - u_{n-j}) / (b - u_{n-j}),      c = u_{n+1+r-j}, new,   b = u_{n+1}
//
// beta is negative or above 1: the points are extrapolated, and weights may come out zero or negative, which is
// refused.

#include "kernel/clamping.hpp"
#include "kernel/error.hpp"

namespace blossom {

// The length of a span
struct SpanLength {
  static constexpr std::string_view name = "span_length";
  static constexpr std::string_view formula = "{1} - {0}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a, const S& b) {
    return b - a;
  }
};

// One step back from a knot
struct StepBack {
  static constexpr std::string_view name = "step_back";
  static constexpr std::string_view formula = "{0} - {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& u, const S& h) {
    return u - h;
  }
};

namespace unclamp {

// Exchanges the point `at` for the blend of its neighbours A, B at beta.
template <class R, class Ratio, class A, class B>
void exchange(R& rec, MadeCurve<R>& curve, int at, const Name& name, const Ratio& beta, const A& first,
              const B& second) {
  const auto before = curve.P[at].id;
  const auto made = rec.apply(Blend{}, name, beta, first, second);
  rec.retire(before);
  curve.P.set(at, made);
}

// p new knots in front of the domain, and the points that depend on them.
template <class R>
void left(R& rec, MadeCurve<R>& curve) {
  const int p = curve.degree;
  const auto a = curve.U[p];
  const auto h = rec.apply(SpanLength{}, "h"_v(0), a, curve.U[p + 1]);
  for (int i = p - 1; i >= 0; --i) curve.U.set(i, rec.apply(StepBack{}, "V"_v(i), curve.U[i + 1], h));
  auto phase = rec.phase({"side", 0, true});
  for (int r = 1; r <= p - 1; ++r)
    for (int j = r - 1; j >= 0; --j) {
      const auto beta = rec.apply(Ratio{}, "beta"_v(r, j), curve.U[p - r + j], a, curve.U[p + j + 1]);
      exchange(rec, curve, j, "Q"_v(r, j), beta, curve.P[j], curve.P[j + 1]);
    }
}

// p new knots behind the domain, and the points that depend on them.
template <class R>
void right(R& rec, MadeCurve<R>& curve) {
  const int p = curve.degree;
  const int n = curve.P.size() - 1;
  const auto b = curve.U[n + 1];
  const auto h = rec.apply(SpanLength{}, "h"_v(1), curve.U[n], b);
  for (int i = n + 2; i <= n + p + 1; ++i) curve.U.set(i, rec.apply(Sum{}, "V"_v(i), curve.U[i - 1], h));
  auto phase = rec.phase({"side", 1, true});
  rec.input("n"_v, n);
  for (int r = 1; r <= p - 1; ++r)
    for (int j = r - 1; j >= 0; --j) {
      const auto beta = rec.apply(Ratio{}, "beta"_v(r, n - j), curve.U[n + 1 + r - j], curve.U[n - j], b);
      exchange(rec, curve, n - j, "Q"_v(r, n - j), beta, curve.P[n - j - 1], curve.P[n - j]);
    }
}

}  // namespace unclamp

// Precondition: a valid curve; an unclamped one is clamped first. Error: a weight would not be positive.
template <class R>
Curve<typename R::Number> unclamping(const Curve<typename R::Number>& curve, R& rec) {
  using S = typename R::Number;
  rec.input("p"_v, curve.degree);
  const auto list = rec.list("U"_v, curve.knots);
  const auto given = given_curve(rec, curve);
  auto made = clamped(rec, given, list).curve;
  unclamp::left(rec, made);
  unclamp::right(rec, made);
  for (int i = 0; i < made.P.size(); ++i)
    if (made.rational && !(S(0) < made.P[i].value.w))
      throw KernelError{"curve", "control point " + std::to_string(i) +
                                     " would get a weight that is not positive: insert a knot near the end first, or "
                                     "make the weights more alike"};
  {
    auto phase = rec.phase({"collect"});
    rec.apply(Gather{}, "V"_v, slice(made.U, 0, made.U.size()));
    name_points(rec, "Q"_v, made.P);
  }
  return plain_curve<R>(std::move(made));
}

}  // namespace blossom
