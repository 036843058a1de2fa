#pragma once
// Subdivision of a surface (The NURBS Book 5.3; Shene, "Subdividing a Bezier Curve", in one direction): every column of
// the control net is cut at u = t as a curve, or every row at v = t. The two surfaces meet in the isoparametric curve
// at t; together they are the surface.

#include "kernel/subdivision.hpp"
#include "kernel/surface_lines.hpp"

namespace blossom {

// Preconditions: a valid surface, t inside its domain, not at an end.
template <class R>
std::vector<Surface<typename R::Number>> surface_subdivision(const Surface<typename R::Number>& surface,
                                                             tensor::Direction d, const typename R::Number& parameter,
                                                             R& rec) {
  const auto degree = rec.input("p"_v, surface.degree[index(d)]);
  const auto t = rec.input("t"_v, parameter);
  const tensor::GivenSurface<R> given(rec, surface);
  tensor::SurfaceOfLines<R> left(surface, d), right(surface, d);
  for (int line = 0; line < given.lines(d); ++line) {
    auto phase = rec.phase(tensor::line_phase(d, line));
    const auto cut = [&] {
      auto inner = rec.phase({"cut", -1, false, "subdivision"});
      const auto [whole, knots] = clamped(rec, given.line(d, line), given.lists[index(d)]);
      return cut_curve(rec, whole, knots, degree, t);
    }();
    if (line == 0) {
      left.along(degree.value, cut.left_knots.value);
      right.along(degree.value, cut.right_knots.value);
    }
    left.set_line(rec, "L"_v, line, cut.left, 0);
    right.set_line(rec, "R"_v, line, cut.right, 0);
  }
  return {left.take(), right.take()};
}

}  // namespace blossom
