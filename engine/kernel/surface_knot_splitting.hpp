#pragma once
// Knot splitting on a surface (DesignMentor): the copies of a multiple knot in u or v are moved apart, as for a curve
// (see knot_splitting.hpp), and the control net stays where it is. The surface becomes smoother along the isoparametric
// curve at t, and it changes. How much is shown there: each column (row) gives one control point of that curve, A[j]
// before and B[j] behind, and e[j] is how far it has moved. On a polynomial surface the curve itself moves by no more
// than E, the largest of these.

#include "kernel/knot_splitting.hpp"
#include "kernel/surface_evaluation.hpp"
#include "kernel/tolerance.hpp"

namespace blossom {

// Preconditions: a valid surface; t a knot inside its domain, of multiplicity 2 or more; 0 < apart < 1.
template <class R>
Surface<typename R::Number> surface_knot_splitting(const Surface<typename R::Number>& surface, tensor::Direction d,
                                                   const typename R::Number& parameter,
                                                   const typename R::Number& fraction, R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const auto t = rec.input("t"_v, parameter);
  const auto apart = rec.input("apart"_v, fraction);
  const tensor::GivenSurface<R> given(rec, surface);
  const auto& U = given.knots[index(d)];
  const auto& list = given.lists[index(d)];
  const auto V = [&] {
    auto phase = rec.phase({"split", -1, true, "knot_splitting"});
    return splitting::spread(rec, U, list, t, apart);
  }();
  const auto moved = rec.apply(Gather{}, "Ubar"_v, slice(V, 0, V.size()));
  auto made = surface;
  made.bezier = false;
  made.knots[index(d)] = moved.value;

  std::vector<Cells<HPoint<S>, Id>> lines(static_cast<std::size_t>(given.lines(d)));
  {
    auto phase = rec.phase({"net"});
    auto step = rec.one_step();
    for (int line = 0; line < given.lines(d); ++line)
      for (int at = 0; at < given.length(d); ++at) {
        const auto [i, j] = tensor::cell(d, line, at);
        const auto Q = rec.apply(Reparametrize{}, "Q"_v(i, j), given.at(i, j));
        lines[static_cast<std::size_t>(line)].push_back(Q);
        if constexpr (R::recording) {
          const auto arguments = [&](std::size_t direction, int first) {
            return std::span<const S>(made.knots[direction])
                .subspan(static_cast<std::size_t>(first) + 1, static_cast<std::size_t>(made.degree[direction]));
          };
          rec.polar_net(Q.id, arguments(0, i), arguments(1, j));
          rec.retire(given.at(i, j).id);
        }
      }
  }

  Cells<S, Id> distances;
  for (int line = 0; line < given.lines(d); ++line) {
    auto phase = rec.phase(tensor::line_phase(d, line));
    const auto& Q = lines[static_cast<std::size_t>(line)];
    const auto point = [&](const Phase& boor, const auto& knots, const auto& knot_list, const auto& P) {
      return tensor::point_of_line(rec, boor, given.degree(d), knots, knot_list, P, 0, P.size() - 1, t);
    };
    const auto before = point({"old", -1, true, "de_boor"}, U, list, given.line(d, line).P);
    const auto A = rec.apply(Same{}, outer("A"_v(line)), before);
    const auto behind = point({"new", -1, true, "de_boor"}, V, moved, Q);
    const auto B = rec.apply(Same{}, outer("B"_v(line)), behind);
    if (!(A.value.w == S(0)) && !(B.value.w == S(0)))
      distances.push_back(rec.apply(Distance{}, outer("e"_v(line)), A, B));
  }
  if (distances.size() > 0) rec.apply(Largest{}, "E"_v, slice(distances, 0, distances.size()));
  return made;
}

}  // namespace blossom
