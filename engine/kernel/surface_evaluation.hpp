#pragma once
// A point on a surface by de Boor's algorithm, twice (The NURBS Book 3.4 and A3.5; Shene, "B-spline Surfaces", de
// Boor's algorithm extended). First v, then u: each row i in force at u is a curve over the knots V, and its point at v
// is
//
//     R[i] = sum_j N_{j,q}(v) P[i][j],     i = k-p..k-s;
//
// these points are control points of a curve over U, and its point at u is S(u, v) = sum_i N_{i,p}(u) R[i]. First u,
// then v: the columns in force, R[j] = sum_i N_{i,p}(u) P[i][j]. On a Bezier surface all ratios are u or v: de
// Casteljau's algorithm. Homogeneous until the end.

#include "kernel/compatible.hpp"
#include "kernel/de_boor.hpp"
#include "kernel/surface_lines.hpp"

namespace blossom {

namespace tensor {

// The triangle on one curve, in a phase that is de Boor's algorithm, with what it names: p, U, and P[0][i] for the
// points first..last. The parameter keeps its name: u, v or t. `list` is the knot vector as one value.
template <class R, class Knots, class KnotList, class Points, class Parameter>
Traced<HPoint<typename R::Number>, typename R::Id> point_of_line(R& rec, const Phase& boor, int p, const Knots& U,
                                                                 const KnotList& list, const Points& P, int first,
                                                                 int last, const Parameter& parameter) {
  using S = typename R::Number;
  using Id = typename R::Id;
  if constexpr (!R::recording) {
    return de_boor_point(rec, Traced<int, NoId>{p, {}}, U, list, P, parameter);
  } else {
    auto phase = rec.phase(boor);
    Traced<int, Id> degree{};
    Cells<HPoint<S>, Id> copies;
    copies.resize(last + 1);
    Traced<std::vector<S>, Id> knots;
    {
      auto step = rec.one_step();
      degree = rec.input("p"_v, p);
      for (int i = first; i <= last; ++i) copies.set(i, rec.apply(Same{}, "P"_v(0, i), P[i]));
      knots = rec.apply(Gather{}, "U"_v, slice(U, 0, U.size()));
    }
    return de_boor_point(rec, degree, U, knots, copies, parameter);
  }
}

}  // namespace tensor

// Preconditions: a valid surface, u and v in its domain. Error: the weight there is zero.
template <class R>
HPoint<typename R::Number> surface_evaluation(const Surface<typename R::Number>& surface,
                                              const typename R::Number& u_value, const typename R::Number& v_value,
                                              tensor::Direction first, R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const std::array degree{rec.input("p"_v, surface.degree[0]), rec.input("q"_v, surface.degree[1])};
  const std::array parameter{rec.input("u"_v, u_value), rec.input("v"_v, v_value)};
  const tensor::GivenSurface<R> given(rec, surface);

  // Which rows (columns) the point depends on is a matter of the other direction.
  const auto second = tensor::other(first);
  const auto& across = parameter[index(second)];
  const auto& knots = given.knots[index(second)];
  const auto k = rec.apply(FindSpan{}, "k"_v, degree[index(second)], across, given.lists[index(second)]);
  const auto s = rec.apply(Multiplicity{}, "s"_v, across, given.lists[index(second)]);
  const auto force = points_in_force(knots, given.degree(second), k.value, s.value, across.value);

  constexpr Phase boor{"evaluate", -1, false, "de_boor"};
  Cells<HPoint<S>, Id> made;
  made.resize(given.length(second));
  for (int i = force.first; i <= force.last; ++i) {
    auto phase = rec.phase(tensor::line_phase(first, i));
    const auto line = given.line(first, i);
    const auto top =
        tensor::point_of_line(rec, boor, given.degree(first), given.knots[index(first)], given.lists[index(first)],
                              line.P, 0, line.P.size() - 1, parameter[index(first)]);
    made.set(i, rec.apply(Same{}, outer("R"_v(i)), top));
  }

  auto phase = rec.phase({"across", -1, true});
  const auto top = tensor::point_of_line(rec, boor, given.degree(second), knots, given.lists[index(second)], made,
                                         force.first, force.last, across);
  if (!surface.rational) return rec.apply(Same{}, outer("S"_v()), top).value;
  if (top.value.w == S(0))
    throw KernelError{"u", "the weight of the point at this parameter is 0: it lies at infinity"};
  return rec.apply(Project{}, outer("S"_v()), top).value;
}

}  // namespace blossom
