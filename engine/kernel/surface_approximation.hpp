#pragma once
// Least-squares approximation of a net of points Q[k][l], k = 0..m, l = 0..r, by a surface with fewer control points
// (The NURBS Book 9.4.3; Shene, "Global Surface Approximation"):
//
//   along u, along v   parameters averaged over the columns (rows), knots spread among them (NB 9.69), basis functions
//                      at the parameters, and the normal equations (see approximation.hpp), eliminated once;
//   columns            for each l the curve nearest to Q[0][l]..Q[m][l] that begins and ends in the first and last of
//                      them: control points R[i][l];
//   rows               for each i the curve nearest to R[i][0]..R[i][r]: control points P[i][j];
//   error              E = the largest of the distances e[k][l] = |Q[k][l] - S(u_k, v_l)|.
//
// The corners are interpolated. The surface is not the nearest of all, but needs two small systems instead of one large
// one. With as many control points as points it interpolates.

#include "kernel/approximation.hpp"
#include "kernel/surface_fitting.hpp"

namespace blossom {

namespace tensor {

// One direction: parameters, knots, basis functions N[k][j] of the points between the ends, normal equations.
template <class R>
struct Approximated {
  Course<R> course;
  approximating::Rows<R> basis;
  Band<R> matrix;

  int last_point() const { return course.t.size() - 1; }
  int last() const { return matrix.size - 1; }
};

// M[i][j] = sum_k N[k][i] N[k][j] between the unit rows of the two ends.
template <class R>
Band<R> normal_matrix(R& rec, const approximating::Rows<R>& basis, int p, int n, int m) {
  using S = typename R::Number;
  auto phase = rec.phase({"normal"});
  Band<R> M(n + 1, 2 * p + 1);
  for (const int end : {0, n}) {
    M.set_row(end, end, end);
    M.set(end, end, rec.input("M"_v(end, end), S(1)));
  }
  for (int i = 1; i < n; ++i) {
    M.set_row(i, std::max(0, i - p), std::min(n, i + p));
    for (int j = M.begin(i); j <= M.end(i); ++j) {
      Cells<S, typename R::Id> pairs;
      for (int k = 1; k < m; ++k) {
        if (!basis.holds(k, i) || !basis.holds(k, j)) continue;
        pairs.push_back(basis.at(k, i));
        pairs.push_back(basis.at(k, j));
      }
      if (pairs.size() == 0)
        M.set(i, j, rec.input("M"_v(i, j), S(0)));
      else
        M.set(i, j, rec.apply(ProductSum{}, "M"_v(i, j), slice(pairs, 0, pairs.size())));
    }
  }
  return M;
}

template <class R>
Approximated<R> approximate_along(R& rec, const GivenNet<R>& Q, Direction d, const Traced<int, typename R::Id>& degree,
                                  int count, Parametrization parametrization) {
  auto phase = rec.phase(course_phase(d));
  Course<R> course{degree, averaged_parameters(rec, Q, d, parametrization), {}};
  course.knots = knot_vector(rec, d, approximating::spread_knots(rec, course.t, degree, count - 1));
  auto basis = approximating::basis_rows(rec, course.t, degree, course.knots);
  auto M = normal_matrix(rec, basis, degree.value, count - 1, Q.length(d) - 1);
  auto elimination = rec.phase({"eliminate"});
  eliminate(rec, M, d == Direction::u ? "rows" : "columns");
  return {std::move(course), std::move(basis), std::move(M)};
}

// The right-hand sides for a line of points: the ends, and b[i] = sum_k N[k][i] D[k] between them.
template <class R>
Cells<HPoint<typename R::Number>, typename R::Id> right_sides(
    R& rec, const Approximated<R>& along, const Cells<HPoint<typename R::Number>, typename R::Id>& D) {
  using Point = Traced<HPoint<typename R::Number>, typename R::Id>;
  const int n = along.last(), m = along.last_point();
  Cells<HPoint<typename R::Number>, typename R::Id> right;
  right.push_back(D[0]);
  for (int i = 1; i < n; ++i) {
    Point sum{};
    bool any = false;
    for (int k = 1; k < m; ++k) {
      if (!along.basis.holds(k, i)) continue;
      sum = any ? rec.apply(AddMultiple{}, "b"_v(i, k), sum, along.basis.at(k, i), D[k])
                : rec.apply(Multiple{}, "b"_v(i, k), along.basis.at(k, i), D[k]);
      any = true;
    }
    right.push_back(sum);  // N[.][i] has a parameter in its support: the knots are spread so
  }
  right.push_back(D[m]);
  return right;
}

// What has an influence at the parameter k: `step(j, N[k][j])`; at the ends the end point alone, with the 1 of its row.
template <class R, class Step>
void for_basis(const Approximated<R>& along, int k, Step&& step) {
  if (k == 0 || k == along.last_point()) {
    const int end = k == 0 ? 0 : along.last();
    step(end, along.matrix.at(end, end));
    return;
  }
  for (int j = 0; j <= along.last(); ++j)
    if (along.basis.holds(k, j)) step(j, along.basis.at(k, j));
}

// The largest distance of a point from the surface at its parameters. For each column l the points T[i] of the rows of
// the net at v_l (partial sums s[i][j]), then for each point what is left of it, r[k][i], and its length e[k][l].
template <class R>
void largest_error(R& rec, const GivenNet<R>& Q, const Approximated<R>& u, const Approximated<R>& v,
                   const std::vector<Cells<HPoint<typename R::Number>, typename R::Id>>& P) {
  using S = typename R::Number;
  using Id = typename R::Id;
  auto phase = rec.phase({"error"});
  Cells<S, Id> e;
  for (int l = 0; l <= v.last_point(); ++l) {
    auto strip = rec.phase({"strip", l, true});
    Cells<HPoint<S>, Id> T;
    for (int i = 0; i <= u.last(); ++i) {
      const auto& row = P[static_cast<std::size_t>(i)];
      Traced<HPoint<S>, Id> sum{};
      bool any = false;
      auto step = rec.one_step();
      for_basis(v, l, [&](int j, const auto& factor) {
        sum = any ? rec.apply(AddMultiple{}, "s"_v(i, j), sum, factor, row[j])
                  : rec.apply(Multiple{}, "s"_v(i, j), factor, row[j]);
        any = true;
      });
      T.push_back(sum);
    }
    for (int k = 0; k <= u.last_point(); ++k) {
      auto step = rec.one_step();
      Traced<HPoint<S>, Id> rest{Q.at(k, l).value, Q.at(k, l).id};
      for_basis(u, k, [&](int i, const auto& factor) { rest = rec.apply(Reduce{}, "r"_v(k, i), rest, factor, T[i]); });
      e.push_back(rec.apply(Length{}, outer("e"_v(k, l)), rest));
    }
  }
  rec.apply(Largest{}, "E"_v, slice(e, 0, e.size()));
}

}  // namespace tensor

// With rows x columns control points. Preconditions: at least 2 x 2 points; p < rows <= points in u, q < columns <=
// points in v. Errors: see averaged_parameters.
template <class R>
Surface<typename R::Number> surface_approximation(const PointNet<typename R::Number>& points, int degree_u,
                                                  int degree_v, int rows, int columns, Parametrization parametrization,
                                                  R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  using tensor::Direction;
  using Row = Cells<HPoint<S>, Id>;
  const auto p = rec.input("p"_v, degree_u);
  const auto q = rec.input("q"_v, degree_v);
  const tensor::GivenNet<R> Q(rec, points);
  const auto u = tensor::approximate_along(rec, Q, Direction::u, p, rows, parametrization);
  const auto v = tensor::approximate_along(rec, Q, Direction::v, q, columns, parametrization);
  auto surface = tensor::surface_over(u.course, v.course);

  std::vector<Row> R_net(static_cast<std::size_t>(rows));  // R[i][0..r]
  {
    auto phase = rec.phase({"columns"});
    for (int l = 0; l < points.columns; ++l) {
      auto column = rec.phase({"column", l, true});
      Row line;
      for (int k = 0; k < points.rows; ++k) line.push_back(Q.at(k, l));
      auto right = tensor::right_sides(rec, u, line);
      solve(
          rec, u.matrix, right, [&](int i) { return outer("R"_v(i, l)); },
          [&](int i, const auto& point) {
            if constexpr (R::recording) rec.polar_net(point.id, u.course.arguments(i), {});  // of this column's curve
          });
      for (int i = 0; i < rows; ++i) R_net[static_cast<std::size_t>(i)].push_back(right[i]);
    }
  }

  std::vector<Row> P;
  {
    auto phase = rec.phase({"rows"});
    for (int i = 0; i < rows; ++i) {
      auto row = rec.phase({"line", i, true});
      P.push_back(tensor::right_sides(rec, v, R_net[static_cast<std::size_t>(i)]));
      solve(
          rec, v.matrix, P.back(), [&](int j) { return outer("P"_v(i, j)); },
          [&](int j, const auto& point) {
            surface.at(i, j) = point.value;
            surface.at(i, j).w = S(1);  // up to rounding it is
            if constexpr (R::recording) rec.polar_net(point.id, u.course.arguments(i), v.course.arguments(j));
          });
    }
  }
  tensor::largest_error(rec, Q, u, v, P);
  return surface;
}

}  // namespace blossom
