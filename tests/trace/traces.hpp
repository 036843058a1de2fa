#pragma once
// A small trace, made by hand, with all that a trace can have: nested phases, a step of two values, values that retire.

#include "trace/trace_recorder.hpp"

namespace blossom::test {

// step 0 the givens x, P[0], P[1]; 1 a = x; phase 2..6 "outer": 3 b; phase 4..5 "inner[7]": 5 c, d; 6 e; 7 f
inline Trace<double> small_trace() {
  TraceRecorder<double> rec;
  const auto x = rec.input("x"_v, 0.25);
  const HPoint<double> points[] = {{0, 0, 0, 1}, {4, 8, 0, 1}};
  const auto P = rec.inputs("P"_v, std::span<const HPoint<double>>(points));
  rec.polar_bezier(P[0].id, 0, 1);
  rec.polar_bezier(P[1].id, 1, 1);
  const auto a = rec.apply(SameNumber{}, "a"_v, x);
  {
    auto outside = rec.phase({"outer"});
    const auto b = rec.apply(Sum{}, "b"_v, a, x);
    rec.retire(a.id);
    {
      auto inside = rec.phase({"inner", 7, true});
      auto step = rec.one_step();
      const auto c = rec.apply(Blend{}, "C"_v, x, P[0], P[1]);
      rec.apply(Same{}, outer("D"_v(2)), c);
      rec.retire(b.id);
    }
    rec.apply(Quotient{}, "e"_v, x, b);
  }
  rec.apply(Fraction{}, "f"_v, rec.input("n"_v, 1), rec.input("d"_v, 2));
  return std::move(rec).take();
}

}  // namespace blossom::test
