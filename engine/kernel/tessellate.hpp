#pragma once
// Many points at once: samples of a curve, grids of a surface with normals.
//
// A grid is evaluated separably. The basis functions are tabulated once for each u and once for each v; each row of the
// grid first combines the rows of the control net into one row of points (one curve in v), and then each vertex is a
// sum of q + 1 points only:
//
//   S^w(u_a, v_b) = sum_j N_{j,q}(v_b) (sum_i N_{i,p}(u_a) P_{i,j})
//
// The results go into objects that the caller keeps: used again, they allocate nothing. A grid keeps its tables, so
// that a moved control point costs only the vertices that it acts on.

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
#include "kernel/lanes.hpp"
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
  std::array<std::vector<double>, 2> parameters;  // u_a and v_b

  // The basis functions at every parameter of one direction: the first control point that counts, and p + 1 values,
  // then p + 1 derivatives if normals are asked for.
  struct Table {
    std::vector<int> first;
    std::vector<double> values;
    std::size_t stride = 0;

    // The first and the last parameter that the control points first..last act on; the latter is less where none is.
    std::array<int, 2> acted_on(int first_point, int last_point, int p) const {
      const auto acts = [=](int k) { return k <= last_point && first_point <= k + p; };
      const auto begin = std::ranges::find_if(first, acts);
      if (begin == first.end()) return {0, -1};
      const auto end = std::find_if(first.rbegin(), first.rend(), acts);
      return {static_cast<int>(begin - first.begin()), static_cast<int>(first.rend() - end) - 1};
    }
  };
  std::array<Table, 2> tables;                     // working memory
  std::array<std::vector<HPoint<double>>, 2> row;  // working memory: a curve in v, and its derivative by u
};

namespace detail {

inline void tabulate(std::span<const double> U, int p, std::span<const double> parameters, int derivatives,
                     SurfaceGrid::Table& table) {
  table.stride = static_cast<std::size_t>((derivatives + 1) * (p + 1));
  table.first.resize(parameters.size());
  table.values.assign(parameters.size() * table.stride, 0.0);  // those above the degree stay zero
  Reciprocals<double> R;
  int known = -1;  // the span that R belongs to
  for (std::size_t a = 0; a < parameters.size(); ++a) {
    const int k = find_span<double>(U, p, parameters[a]);
    if (k != known) knot_reciprocals<0>(U.data() + k, p, R.data());
    known = k;
    table.first[a] = k - p;
    basis_derivatives_on_span<0>(U.data() + k, p, parameters[a], std::min(derivatives, p), R.data(),
                                 table.values.data() + a * table.stride);
  }
}

// Makes room, and the tables with so many derivatives.
inline void prepare_grid(const Surface<double>& surface, std::span<const double> u, std::span<const double> v,
                         int derivatives, SurfaceGrid& grid) {
  grid.rows = static_cast<int>(u.size());
  grid.columns = static_cast<int>(v.size());
  const std::size_t vertices = u.size() * v.size();
  grid.points.resize(vertices);
  grid.normals.resize(derivatives > 0 ? vertices : 0);
  grid.undefined.clear();
  grid.parameters[0].assign(u.begin(), u.end());
  grid.parameters[1].assign(v.begin(), v.end());
  tabulate(surface.knots[0], surface.degree[0], u, derivatives, grid.tables[0]);
  tabulate(surface.knots[1], surface.degree[1], v, derivatives, grid.tables[1]);
  for (auto& row : grid.row) row.resize(surface.columns);
}

// row[j] = sum_i M[i] P[i][j], for the columns j = begin..end-1 of the net.
inline void combine_rows(const Surface<double>& surface, int first, const double* M, int begin, int end,
                         HPoint<double>* row) {
  const int p = surface.degree[0];
  const HPoint<double>* P = &surface.at(first, 0);
  for (int j = begin; j < end; ++j) {
    Blend<double> sum(P[j], M[0]);
    for (int i = 1; i <= p; ++i) sum.add(P[i * surface.columns + j], M[i]);
    row[j] = sum.point();
  }
}

// A block of vertices: rows a and columns b, both ends included; and the columns of the net that act on it.
struct GridBlock {
  int first_a, last_a, first_b, last_b;
  int begin_j, end_j;

  GridBlock(const SurfaceGrid& grid, int q, std::array<int, 2> a, std::array<int, 2> b)
      : first_a(a[0]), last_a(a[1]), first_b(b[0]), last_b(b[1]), begin_j(0), end_j(0) {
    if (first_b > last_b) return;
    const auto [low, high] = std::minmax_element(grid.tables[1].first.begin() + first_b,  //
                                                 grid.tables[1].first.begin() + last_b + 1);
    begin_j = *low;
    end_j = *high + q + 1;
  }
};

template <int Q>
void fill_points(const Surface<double>& surface, const GridBlock& block, SurfaceGrid& grid) {
  const int q = surface.degree[1];
  const auto& [in_u, in_v] = grid.tables;
  HPoint<double>* row = grid.row[0].data();
  for (int a = block.first_a; a <= block.last_a; ++a) {
    combine_rows(surface, in_u.first[a], in_u.values.data() + a * in_u.stride, block.begin_j, block.end_j, row);
    for (int b = block.first_b; b <= block.last_b; ++b) {
      const int vertex = a * grid.columns + b;
      const auto S = affine_point(combine<Q>(in_v.values.data() + b * in_v.stride, row + in_v.first[b], q).point());
      if (!S) grid.undefined.push_back(vertex);
      grid.points[vertex] = S ? *S : Point<double>(0.0);
    }
  }
}

// As affine_point and plain_unit_normal, for several vertices; whether both exist at all of them, and are plain.
inline bool plain_points_and_normals(const Xyzw<Lanes>& S, const Xyzw<Lanes>& Su, const Xyzw<Lanes>& Sv,
                                     double length_u, double length_v, Xyz<Lanes>& point, Xyz<Lanes>& normal) {
  point = {S.xyz.x / S.w, S.xyz.y / S.w, S.xyz.z / S.w};
  const Xyz<Lanes> a = (Su.xyz - point * Su.w) * length_u;
  const Xyz<Lanes> b = (Sv.xyz - point * Sv.w) * length_v;
  const Xyz<Lanes> across = cross(a, b);
  const Lanes aa = dot(a, a), bb = dot(b, b), cc = dot(across, across);
  normal = across * (1.0 / square_root(cc));
  constexpr double doubtful = 1e-12;
  // A point that is not finite makes cc no number.
  return all_of(aa > doubtful * bb, bb > doubtful * aa, cc > doubtful * (aa * bb), finite_number(cc));
}

// One vertex that may be anything.
inline void fill_vertex(const Surface<double>& surface, int a, int b, const TangentPlane& plane, double length_u,
                        double length_v, SurfaceGrid& grid) {
  const int vertex = a * grid.columns + b;
  const auto S = affine_point(plane.S);
  if (!S) grid.undefined.push_back(vertex);
  const Point<double> point = S ? *S : Point<double>(0.0);
  Point<double> normal(0.0);
  if (S && !plain_unit_normal(plane, point, length_u, length_v, normal)) {
    normal = unit_normal(surface, grid.parameters[0][a], grid.parameters[1][b]).value_or(normal);
  }
  grid.points[vertex] = point;
  grid.normals[vertex] = normal;
}

template <int Q>
void fill_points_and_normals(const Surface<double>& surface, const GridBlock& block, SurfaceGrid& grid) {
  const int p = surface.degree[0];
  const int q = surface.degree[1];
  const double length_u = surface.knots[0][surface.rows] - surface.knots[0][p];
  const double length_v = surface.knots[1][surface.columns] - surface.knots[1][q];
  const auto& [in_u, in_v] = grid.tables;
  HPoint<double>*const row = grid.row[0].data(), *const row_u = grid.row[1].data();
  std::array<HPoint<double>, lanes> S, Su, Sv;
  S.fill(HPoint<double>(0, 0, 0, 1)), Su = Sv = S;
  for (int a = block.first_a; a <= block.last_a; ++a) {
    const double* M = in_u.values.data() + a * in_u.stride;
    combine_rows(surface, in_u.first[a], M, block.begin_j, block.end_j, row);
    combine_rows(surface, in_u.first[a], M + p + 1, block.begin_j, block.end_j, row_u);
    for (int b = block.first_b; b <= block.last_b; b += lanes) {
      const int count = std::min(lanes, block.last_b + 1 - b);
      for (int k = 0; k < count; ++k) {
        const double* N = in_v.values.data() + (b + k) * in_v.stride;
        const int j = in_v.first[b + k];
        S[k] = combine<Q>(N, row + j, q).point();
        Su[k] = combine<Q>(N, row_u + j, q).point();
        Sv[k] = combine<Q>(N + q + 1, row + j, q).point();
      }
      Xyz<Lanes> point, normal;
      const int vertex = a * grid.columns + b;
      if (plain_points_and_normals(load_lanes(S.data()), load_lanes(Su.data()), load_lanes(Sv.data()), length_u,
                                   length_v, point, normal)) {
        store(point, count, &grid.points[vertex]);
        store(normal, count, &grid.normals[vertex]);
      } else {
        for (int k = 0; k < count; ++k) {
          fill_vertex(surface, a, b + k, {S[k], Su[k], Sv[k]}, length_u, length_v, grid);
        }
      }
    }
  }
}

inline void fill_block(const Surface<double>& surface, std::array<int, 2> a, std::array<int, 2> b, SurfaceGrid& grid) {
  const GridBlock block(grid, surface.degree[1], a, b);
  with_degree<double>(surface.degree[1], [&](auto Q) {
    if (grid.normals.empty()) {
      fill_points<Q()>(surface, block, grid);
    } else {
      fill_points_and_normals<Q()>(surface, block, grid);
    }
  });
}

}  // namespace detail

// The points S(u_a, v_b), and the unit normals if asked for (as unit_normal, limits at poles included). The parameters
// lie in the domain, in any order; span_parameters gives good ones.
inline void evaluate_grid(const Surface<double>& surface, std::span<const double> u, std::span<const double> v,
                          bool with_normals, SurfaceGrid& grid) {
  detail::prepare_grid(surface, u, v, with_normals ? 1 : 0, grid);
  detail::fill_block(surface, {0, grid.rows - 1}, {0, grid.columns - 1}, grid);
}

// Which vertices of a grid have been computed anew: rows first_a..last_a, columns first_b..last_b; none where last_a <
// first_a.
struct GridUpdate {
  int first_a = 0, last_a = -1, first_b = 0, last_b = -1;
  bool empty() const { return last_a < first_a; }
};

// Brings a grid of the surface up to date after the control points P[i][j], i = first_i..last_i, j = first_j..last_j,
// have changed, and nothing else has: P[i][j] acts on [u_i, u_{i+p+1}) x [v_j, v_{j+q+1}) only (The NURBS Book,
// property P3.21). The grid is then the same, bit for bit, as if it were evaluated anew. With parameters in ascending
// order no vertex is computed in vain.
inline GridUpdate update_grid(const Surface<double>& surface, SurfaceGrid& grid, std::array<int, 2> i,
                              std::array<int, 2> j) {
  assert(grid.points.size() == grid.parameters[0].size() * grid.parameters[1].size());
  const auto a = grid.tables[0].acted_on(i[0], i[1], surface.degree[0]);
  const auto b = grid.tables[1].acted_on(j[0], j[1], surface.degree[1]);
  if (a[1] < a[0] || b[1] < b[0]) return {};
  std::erase_if(grid.undefined, [&](int vertex) {
    const int row = vertex / grid.columns, column = vertex % grid.columns;
    return a[0] <= row && row <= a[1] && b[0] <= column && column <= b[1];
  });
  detail::fill_block(surface, a, b, grid);
  std::ranges::sort(grid.undefined);
  return {a[0], a[1], b[0], b[1]};
}

// The same for one control point.
inline GridUpdate update_grid(const Surface<double>& surface, SurfaceGrid& grid, int i, int j) {
  return update_grid(surface, grid, {i, i}, {j, j});
}

}  // namespace blossom
