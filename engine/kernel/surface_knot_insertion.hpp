#pragma once
// Knot insertion into a surface (The NURBS Book 5.3, A5.3; Shene, "Knot Insertion"): t is inserted into every column of
// the control net (a knot in u) or into every row (a knot in v), by the same ratios. The surface stays the same; its
// net gets `times` rows (columns) more.

#include "kernel/knot_insertion.hpp"
#include "kernel/surface_lines.hpp"

namespace blossom {

// Preconditions: a valid surface, t in its domain, multiplicity of t + times at most the degree there.
template <class R>
Surface<typename R::Number> surface_knot_insertion(const Surface<typename R::Number>& surface, tensor::Direction d,
                                                   const typename R::Number& parameter, int times, R& rec) {
  const auto t = rec.input("t"_v, parameter);
  const auto h = rec.input("h"_v, times);
  const tensor::GivenSurface<R> given(rec, surface);
  tensor::SurfaceOfLines<R> made(surface, d);
  for (int line = 0; line < given.lines(d); ++line) {
    auto phase = rec.phase(tensor::line_phase(d, line));
    const auto refined = [&] {
      auto inner = rec.phase({"insert", -1, false, "knot_insertion"});
      return insert_knot(rec, given.line(d, line), given.lists[index(d)], t, h);
    }();
    if (line == 0) made.along(given.degree(d), refined.curve.U.values());
    made.set_line(rec, "Q"_v, line, refined.curve.P, 0);
  }
  return made.take();
}

}  // namespace blossom
