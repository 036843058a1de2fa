#pragma once
// Degree elevation of a surface (The NURBS Book 5.5, A5.10; Shene, "Degree Elevation"): every column of the control net
// is elevated as a curve in u, or every row as one in v. The surface stays the same.

#include "kernel/degree_elevation.hpp"
#include "kernel/surface_lines.hpp"

namespace blossom {

namespace tensor {

// The ends of a row stay: one v-argument more is the same point.
struct ElevateEndV {
  static constexpr std::string_view name = "elevate_end_v";
  static constexpr std::string_view formula = "{0}";
  static constexpr Polar polar = Polar::repeat_v;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A) {
    return A;
  }
};

}  // namespace tensor

// Preconditions: a valid surface, times >= 1, degree + times <= max_degree.
template <class R>
Surface<typename R::Number> surface_degree_elevation(const Surface<typename R::Number>& surface, tensor::Direction d,
                                                     int times, R& rec) {
  const auto t = rec.input("t"_v, times);
  const tensor::GivenSurface<R> given(rec, surface);
  tensor::SurfaceOfLines<R> made(surface, d);
  for (int line = 0; line < given.lines(d); ++line) {
    auto phase = rec.phase(tensor::line_phase(d, line));
    const auto elevated = [&] {
      auto inner = rec.phase({"raise", -1, false, "degree_elevation"});
      const auto curve = given.line(d, line);
      const auto& knots = given.lists[index(d)];
      return d == tensor::Direction::u ? elevate_degree(rec, curve, knots, t)
                                       : elevate_degree<tensor::ElevateEndV>(rec, curve, knots, t);
    }();
    if (line == 0) made.along(elevated.degree, elevated.U.values());
    made.set_line(rec, "Q"_v, line, elevated.P, 0);
  }
  return made.take();
}

}  // namespace blossom
