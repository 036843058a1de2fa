#pragma once
// Knot removal from a surface (The NURBS Book 5.4, A5.8 on every row or column; Tiller 1992): one copy of t is taken
// out of every column (a knot in u) or every row (a knot in v), as out of a curve (see knot_removal.hpp). All of them
// must allow it: each tells a bound b on how far its homogeneous points move, and the surface moves no farther than E,
// the largest of these. If E is above the tolerance the surface stays as it is.

#include "kernel/knot_removal.hpp"
#include "kernel/surface_lines.hpp"

namespace blossom {

// Preconditions: a valid surface; t a knot inside its domain; tolerance not negative.
template <class R>
Surface<typename R::Number> surface_knot_removal(const Surface<typename R::Number>& surface, tensor::Direction d,
                                                 const typename R::Number& parameter,
                                                 const typename R::Number& tolerance, R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const auto t = rec.input("t"_v, parameter);
  const auto tol = rec.input("tol"_v, tolerance);
  const auto rounding = rec.input("eps"_v, rounding_of(std::span<const HPoint<S>>(surface.points)));
  const tensor::GivenSurface<R> given(rec, surface);
  const auto& list = given.lists[index(d)];

  std::vector<MadeCurve<R>> lines;
  Cells<S, Id> bounds;
  bool removed = true;
  for (int line = 0; line < given.lines(d); ++line) {
    auto phase = rec.phase(tensor::line_phase(d, line));
    auto now = [&] {
      auto inner = rec.phase({"remove", -1, false, "knot_removal"});
      return remove_knot(rec, given.line(d, line), {surface.knots[index(d)], list.id}, t, tol, rounding);
    }();
    bounds.push_back(rec.apply(SameNumber{}, outer("e"_v(line)), now.bound));
    removed = removed && now.removed;
    lines.push_back(std::move(now.curve));
  }
  const auto E = rec.apply(Largest{}, "E"_v, slice(bounds, 0, bounds.size()));
  rec.apply(Within{}, "all"_v, E, tol, rounding);

  auto made = surface;
  if (removed) {
    const auto knots = lines[0].U.values();
    made.bezier = false;
    made.knots[index(d)].assign(knots.begin(), knots.end());
    --(d == tensor::Direction::u ? made.rows : made.columns);
    made.points.resize(static_cast<std::size_t>(made.rows) * static_cast<std::size_t>(made.columns));
  }
  auto phase = rec.phase({"collect"});
  auto step = rec.one_step();
  for (int i = 0; i < made.rows; ++i)
    for (int j = 0; j < made.columns; ++j) {
      const auto [line, at] = d == tensor::Direction::u ? std::array{j, i} : std::array{i, j};
      const auto source = removed ? Traced<HPoint<S>, Id>{lines[static_cast<std::size_t>(line)].P[at].value,
                                                          lines[static_cast<std::size_t>(line)].P[at].id}
                                  : Traced<HPoint<S>, Id>{given.at(i, j).value, given.at(i, j).id};
      const auto Q = rec.apply(Relabel{}, "Q"_v(i, j), source);
      if (removed) made.at(i, j) = Q.value;
      if (removed && !surface.rational) made.at(i, j).w = S(1);  // up to rounding it is
      if constexpr (R::recording) {
        const auto arguments = [&](std::size_t direction, int first) {
          return std::span<const S>(made.knots[direction])
              .subspan(static_cast<std::size_t>(first) + 1, static_cast<std::size_t>(made.degree[direction]));
        };
        rec.polar_net(Q.id, arguments(0, i), arguments(1, j));
      }
    }
  return made;
}

}  // namespace blossom
