#pragma once
// Global interpolation of a net of points: the surface of degrees p, q with S(u_k, v_l) = Q[k][l], k = 0..n, l = 0..m
// (The NURBS Book 9.2.5, A9.4; Shene, "Global Surface Interpolation"):
//
//   along u, along v   parameters u_k, v_l averaged over the columns (rows), knots by averaging (NB 9.8), and the
//   matrix
//                      of basis functions, eliminated once;
//   columns            for each l the curve through Q[0][l]..Q[n][l] at the u_k: control points R[i][l];
//   rows               for each i the curve through R[i][0]..R[i][m] at the v_l: control points P[i][j].
//
// R[i][l] is the blossom value at u_{i+1}, ..., u_{i+p} and v_l, ..., v_l.

#include "kernel/surface_fitting.hpp"

namespace blossom {

namespace tensor {

// One direction: parameters, knots, and the matrix sum_j N_{j,p}(t_k) P[j] = D[k], eliminated.
template <class R>
struct Interpolated {
  Course<R> course;
  Band<R> matrix;
};

template <class R>
Interpolated<R> interpolate_along(R& rec, const GivenNet<R>& Q, Direction d, const Traced<int, typename R::Id>& degree,
                                  Parametrization parametrization) {
  using S = typename R::Number;
  auto phase = rec.phase(course_phase(d));
  const int n = Q.length(d) - 1, p = degree.value;
  Course<R> course{degree, averaged_parameters(rec, Q, d, parametrization), {}};
  const auto& t = course.t;
  course.knots = knot_vector(rec, d, interpolating::averaged_knots(rec, t, interpolating::rows(n, false, false), p));

  Band<R> A(n + 1, p + 1);
  {
    auto system = rec.phase({"system"});
    for (int k = 0; k <= n; ++k) {
      // A curve ends in its first and last control point: these rows are unit rows.
      const bool end = k == 0 || k == n;
      const int last = end ? k : row_span(std::span<const S>(course.knots.value), p, t[k].value);
      A.set_row(k, end ? k : last - p, last);
      for (int j = A.begin(k); j <= last; ++j)
        A.set(k, j, rec.apply(BasisValue{}, "N"_v(k, j), rec.input("j"_v(k, j), j), degree, t[k], course.knots));
    }
  }
  auto elimination = rec.phase({"eliminate"});
  eliminate(rec, A, "points");
  return {std::move(course), std::move(A)};
}

}  // namespace tensor

// Preconditions: at least 2 x 2 points; 1 <= p <= rows - 1, 1 <= q <= columns - 1. Errors: see averaged_parameters.
template <class R>
Surface<typename R::Number> surface_interpolation(const PointNet<typename R::Number>& points, int degree_u,
                                                  int degree_v, Parametrization parametrization, R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  using tensor::Direction;
  const auto p = rec.input("p"_v, degree_u);
  const auto q = rec.input("q"_v, degree_v);
  const tensor::GivenNet<R> Q(rec, points);
  const auto along_u = tensor::interpolate_along(rec, Q, Direction::u, p, parametrization);
  const auto along_v = tensor::interpolate_along(rec, Q, Direction::v, q, parametrization);
  const auto &u = along_u.course, &v = along_v.course;
  tensor::label_points(rec, Q, u, v);
  auto surface = tensor::surface_over(u, v);

  std::vector<Cells<HPoint<S>, Id>> rows(static_cast<std::size_t>(points.rows));  // R[i][0..m]
  {
    auto phase = rec.phase({"columns"});
    for (int l = 0; l < points.columns; ++l) {
      auto column = rec.phase({"column", l, true});
      Cells<HPoint<S>, Id> right;
      for (int k = 0; k < points.rows; ++k) right.push_back(Q.at(k, l));
      solve(
          rec, along_u.matrix, right, [&](int i) { return outer("R"_v(i, l)); },
          [&](int i, const auto& point) {
            if constexpr (R::recording) rec.polar_net(point.id, u.arguments(i), v.at(l));
          });
      for (int i = 0; i < points.rows; ++i) rows[static_cast<std::size_t>(i)].push_back(right[i]);
    }
  }
  auto phase = rec.phase({"rows"});
  for (int i = 0; i < points.rows; ++i) {
    auto row = rec.phase({"line", i, true});
    solve(
        rec, along_v.matrix, rows[static_cast<std::size_t>(i)], [&](int j) { return outer("P"_v(i, j)); },
        [&](int j, const auto& point) {
          surface.at(i, j) = point.value;
          surface.at(i, j).w = S(1);  // up to rounding it is
          if constexpr (R::recording) rec.polar_net(point.id, u.arguments(i), v.arguments(j));
        });
  }
  return surface;
}

}  // namespace blossom
