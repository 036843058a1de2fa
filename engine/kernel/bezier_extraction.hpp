#pragma once
// Bezier extraction: a curve as its Bezier segments, one for each nonempty span of the domain (The NURBS Book 5.3,
// A5.6). Every knot inside the domain is inserted until it has multiplicity p, in a phase of its own; an unclamped
// curve is clamped first. Then each p + 1 control points are a Bezier polygon:
//
//     B[j][0] .. B[j][p]   over [u_a, u_{a+1}], the j-th nonempty span:   P_{a-p} .. P_a of the refined curve.
//
// Neighbours share their end point, except where a knot of multiplicity p + 1 lets the curve jump. Each segment is
// given back as a Bezier curve on [0, 1]: its parameter is (u - u_a) / (u_{a+1} - u_a).

#include "kernel/clamping.hpp"

namespace blossom {

// Precondition: a valid curve.
template <class R>
std::vector<Curve<typename R::Number>> bezier_extraction(const Curve<typename R::Number>& curve, R& rec) {
  using S = typename R::Number;
  const int p = curve.degree;
  rec.input("p"_v, p);
  const auto list = rec.list("U"_v, curve.knots);
  const auto given = given_curve(rec, curve);
  auto [made, knots] = clamped(rec, given, list);

  int number = 0;
  for (int i = p + 1; i < made.P.size();) {  // the knots inside the domain, one after the other
    const S inner = made.U[i].value;
    const int s = multiplicity<S>(made.U.values(), inner);
    if (s < p) {
      auto phase = rec.phase({"knot", number++, true, "knot_insertion"});
      const auto times = rec.input("h"_v, p - s);
      const auto u = rec.apply(SameNumber{}, "u"_v, made.U[i]);
      if constexpr (R::recording)
        if (number > 1) knots = compatible::name_curve(rec, made, number > 2);
      auto refined = insert_knot(rec, made, knots, u, times);
      made = std::move(refined.curve);
      if constexpr (R::recording)
        knots = std::move(refined.knots);
      else
        knots.value.assign(made.U.values().begin(), made.U.values().end());
    }
    i += std::max(s, p);
  }

  auto phase = rec.phase({"segments"});
  std::vector<Curve<S>> segments;
  for (const int a : elevation::span_begins(made.U, p)) {
    const int j = static_cast<int>(segments.size());
    Curve<S> segment{p, bezier_knots<S>(p), {}, curve.dimension, curve.rational, true};
    auto step = rec.one_step();
    for (int i = 0; i <= p; ++i) {
      segment.points.push_back(rec.apply(Same{}, "B"_v(j, i), made.P[a - p + i]).value);
      if (!curve.rational) segment.points.back().w = S(1);  // up to rounding it is
    }
    segments.push_back(std::move(segment));
  }
  return segments;
}

}  // namespace blossom
