#pragma once
// Many points at once: samples of a curve, grids of a surface with normals.
//
// A grid is evaluated separably. The basis functions are tabulated once for each u and once for each v; each row of the
// grid first combines the rows of the control net into one row of points (one curve in v), and then each vertex is a
// sum of q + 1 points only:
//
//   S^w(u_a, v_b) = sum_j N_{j,q}(v_b) (sum_i N_{i,p}(u_a) P_{i,j})
//
// The results go into objects that the caller keeps: used again, they allocate nothing.

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/geometry.hpp"
#include "kernel/basis.hpp"
#include "kernel/derivatives.hpp"
#include "kernel/evaluate.hpp"
#include "kernel/span.hpp"

namespace blossom {

// The parameter i/steps of the way along the span [u_k, u_{k+1}]; its ends are hit exactly.
inline double parameter_in_span(const double* Uk, int i, int steps) {
  return i == steps ? Uk[1] : std::min(Uk[1], Uk[0] + (Uk[1] - Uk[0]) * i / steps);
}

// `steps` uniform steps through every nonempty span of the domain, so that every knot is a parameter: steps times the
// number of such spans, plus 1, values, ascending. steps >= 1.
inline void span_parameters(std::span<const double> U, int p, int steps, std::vector<double>& parameters) {
  assert(steps >= 1);
  parameters.clear();
  const int n = static_cast<int>(U.size()) - p - 2;
  for (int k = p; k <= n; ++k) {
    if (!(U[k] < U[k + 1])) continue;
    for (int i = 0; i < steps; ++i) parameters.push_back(parameter_in_span(U.data() + k, i, steps));
  }
  parameters.push_back(U[n + 1]);
}

struct CurveSamples {
  std::vector<double> u;
  std::vector<Point<double>> points;
  std::vector<std::size_t> pieces;  // the first sample of each connected piece; empty when there are no samples
};

// Samples as span_parameters says, one connected piece for a continuous curve. Where the curve jumps (a knot of
// multiplicity p + 1 inside of the domain) a piece ends with the limit from the left, and the next one begins at the
// same u with that from the right. A parameter with a zero denominator gives no sample and ends the piece.
inline void sample_curve(const Curve<double>& curve, int steps, CurveSamples& samples) {
  assert(steps >= 1);
  samples.u.clear();
  samples.points.clear();
  samples.pieces.clear();
  const int p = curve.degree;
  bool connected = false;
  for (int k = p; k <= curve.n(); ++k) {
    const double* Uk = curve.knots.data() + k;
    if (!(Uk[0] < Uk[1])) continue;
    const bool jumps_at_end = Uk[1] == Uk[p + 1];
    const bool with_end = jumps_at_end || Uk[1] == curve.domain_end();
    detail::with_degree<double>(p, [&](auto P) {
      detail::Reciprocals<double> R;
      detail::knot_reciprocals<P()>(Uk, p, R.data());
      for (int i = 0; i < steps + (with_end ? 1 : 0); ++i) {
        const double u = parameter_in_span(Uk, i, steps);
        detail::BasisRow<double> N;
        detail::basis_on_span<P()>(Uk, p, u, R.data(), N.data());
        const auto C = affine_point(detail::combine<P()>(N.data(), curve.points.data() + (k - p), p).point());
        if (C) {
          if (!connected) samples.pieces.push_back(samples.points.size());
          samples.u.push_back(u);
          samples.points.push_back(*C);
        }
        connected = C.has_value();
      }
    });
    if (jumps_at_end) connected = false;
  }
}

// A grid of surface points: vertex (a, b) at [a * columns + b] belongs to (u_a, v_b).
struct SurfaceGrid {
  int rows = 0;
  int columns = 0;
  std::vector<Point<double>> points;
  std::vector<Point<double>> normals;  // of length 1, or (0,0,0) where there is none; empty if not asked for
  std::vector<int> undefined;          // the vertices with a zero denominator, ascending; their point is (0,0,0)

  // The basis functions at every parameter of one direction: the first control point that counts, and p + 1 values,
  // then p + 1 derivatives if normals are asked for.
  struct Table {
    std::vector<int> first;
    std::vector<double> values;
    std::size_t stride = 0;
  };
  std::array<Table, 2> tables;                     // working memory
  std::array<std::vector<HPoint<double>>, 2> row;  // working memory: a curve in v, and its derivative by u
};

namespace detail {

inline void tabulate(std::span<const double> U, int p, std::span<const double> parameters, int derivatives,
                     SurfaceGrid::Table& table) {
  table.stride = static_cast<std::size_t>((derivatives + 1) * (p + 1));
  table.first.resize(parameters.size());
  table.values.resize(parameters.size() * table.stride);
  Reciprocals<double> R;
  int known = -1;  // the span that R belongs to
  for (std::size_t a = 0; a < parameters.size(); ++a) {
    const int k = find_span<double>(U, p, parameters[a]);
    if (k != known) knot_reciprocals<0>(U.data() + k, p, R.data());
    known = k;
    table.first[a] = k - p;
    basis_derivatives_on_span<0>(U.data() + k, p, parameters[a], derivatives, R.data(),
                                 table.values.data() + a * table.stride);
  }
}

// row[j] = sum_i M[i] P[i][j], for all columns j of the net.
inline void combine_rows(const Surface<double>& surface, int first, const double* M, std::vector<HPoint<double>>& row) {
  row.assign(surface.columns, HPoint<double>(0.0));
  for (int i = 0; i <= surface.degree[0]; ++i) {
    const HPoint<double>* P = &surface.at(first + i, 0);
    for (int j = 0; j < surface.columns; ++j) row[j] += P[j] * M[i];
  }
}

template <int Q>
void fill_points(const Surface<double>& surface, SurfaceGrid& grid) {
  const int q = surface.degree[1];
  const auto& [in_u, in_v] = grid.tables;
  int vertex = 0;
  for (int a = 0; a < grid.rows; ++a) {
    combine_rows(surface, in_u.first[a], in_u.values.data() + a * in_u.stride, grid.row[0]);
    for (int b = 0; b < grid.columns; ++b, ++vertex) {
      const auto S =
          affine_point(combine<Q>(in_v.values.data() + b * in_v.stride, grid.row[0].data() + in_v.first[b], q).point());
      if (!S) grid.undefined.push_back(vertex);
      grid.points[vertex] = S ? *S : Point<double>(0.0);
    }
  }
}

template <int Q>
void fill_points_and_normals(const Surface<double>& surface, std::span<const double> u, std::span<const double> v,
                             SurfaceGrid& grid) {
  const int p = surface.degree[0];
  const int q = surface.degree[1];
  const double length_u = surface.knots[0][surface.rows] - surface.knots[0][p];
  const double length_v = surface.knots[1][surface.columns] - surface.knots[1][q];
  const auto& [in_u, in_v] = grid.tables;
  int vertex = 0;
  for (int a = 0; a < grid.rows; ++a) {
    const double* M = in_u.values.data() + a * in_u.stride;
    combine_rows(surface, in_u.first[a], M, grid.row[0]);
    combine_rows(surface, in_u.first[a], M + p + 1, grid.row[1]);
    for (int b = 0; b < grid.columns; ++b, ++vertex) {
      const double* N = in_v.values.data() + b * in_v.stride;
      const HPoint<double>* row = grid.row[0].data() + in_v.first[b];
      const TangentPlane plane{combine<Q>(N, row, q).point(),
                               combine<Q>(N, grid.row[1].data() + in_v.first[b], q).point(),
                               combine<Q>(N + q + 1, row, q).point()};
      const auto S = affine_point(plane.S);
      if (!S) grid.undefined.push_back(vertex);
      const Point<double> point = S ? *S : Point<double>(0.0);
      Point<double> normal(0.0);
      if (S && !plain_unit_normal(plane, point, length_u, length_v, normal)) {
        normal = unit_normal(surface, u[a], v[b]).value_or(normal);
      }
      grid.points[vertex] = point;
      grid.normals[vertex] = normal;
    }
  }
}

}  // namespace detail

// The points S(u_a, v_b), and the unit normals if asked for (as unit_normal, limits at poles included). The parameters
// lie in the domain, in any order; span_parameters gives good ones.
inline void evaluate_grid(const Surface<double>& surface, std::span<const double> u, std::span<const double> v,
                          bool with_normals, SurfaceGrid& grid) {
  grid.rows = static_cast<int>(u.size());
  grid.columns = static_cast<int>(v.size());
  const std::size_t vertices = u.size() * v.size();
  grid.points.resize(vertices);
  grid.normals.resize(with_normals ? vertices : 0);
  grid.undefined.clear();
  detail::tabulate(surface.knots[0], surface.degree[0], u, with_normals ? 1 : 0, grid.tables[0]);
  detail::tabulate(surface.knots[1], surface.degree[1], v, with_normals ? 1 : 0, grid.tables[1]);
  detail::with_degree<double>(surface.degree[1], [&](auto Q) {
    if (with_normals) {
      detail::fill_points_and_normals<Q()>(surface, u, v, grid);
    } else {
      detail::fill_points<Q()>(surface, grid);
    }
  });
}

}  // namespace blossom
