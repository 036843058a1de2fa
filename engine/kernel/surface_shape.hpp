#pragma once
// How a surface bends: fundamental forms and curvatures at (u, v), and over a whole grid. In double, for display.
//
// With the unit normal n (do Carmo, Differential Geometry of Curves and Surfaces, chapter 3):
//
//   first form    E = S_u.S_u   F = S_u.S_v   G = S_v.S_v
//   second form   L = S_uu.n    M = S_uv.n    N = S_vv.n
//   Gaussian curvature  K = k1 k2 = (L N - M^2) / (E G - F^2)
//   mean curvature      H = (k1 + k2) / 2 = (E N - 2 F M + G L) / (2 (E G - F^2))
//
// The principal curvatures k1 >= k2 are the eigenvalues of the second form in an orthonormal basis e1, e2 of the
// tangent plane, e1 along S_u: of a symmetric matrix (a b; b c), where
//
//   k = (a + c)/2 +- sqrt(((a - c)/2)^2 + b^2)
//
// loses nothing where both are nearly the same, as H +- sqrt(H^2 - K) does. K and H are made of them. They are positive
// where the surface bends towards n. A curvature that rounding alone can have made counts as zero, so that the map of a
// plane, or of the Gaussian curvature of a cylinder, shows no noise. For rational surfaces the derivatives are
//
//   n.S_uu = n.(A_uu - 2 w_u S_u - w_uu S) / w   and so on (The NURBS Book, equation 4.20).

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <vector>

#include "geometry/geometry.hpp"
#include "kernel/basis.hpp"
#include "kernel/derivatives.hpp"
#include "kernel/evaluate.hpp"
#include "kernel/lanes.hpp"
#include "kernel/span.hpp"
#include "kernel/tessellate.hpp"

namespace blossom {

struct Curvatures {
  double gaussian, mean;    // K, H
  double maximum, minimum;  // k1 >= k2
};

struct SurfaceShape {
  Point<double> point, normal;
  Point<double> Su, Sv;
  double E, F, G, L, M, N;
  Curvatures curvatures;
  // Where k1 and k2 belong to: of length 1, maximum x minimum = normal. At an umbilic, where every direction is one,
  // e1 along S_u and e2.
  Point<double> maximum_direction, minimum_direction;
  bool umbilic;
};

namespace detail {

// What tells how much rounding can do: the largest coordinate and weight of the net, and the sums of |N'| and |N''| of
// the basis functions in one direction.
struct NetSize {
  double coordinate = 0, weight = 0;
  explicit NetSize(const Surface<double>& surface) {
    for (const auto& P : surface.points) {
      coordinate = std::max(coordinate, max_norm(xyz(P)));
      weight = std::max(weight, std::abs(P.w));
    }
  }
};
template <class T>
struct Slopes {
  T first{}, second{};
};
inline Slopes<double> slopes(const double* rows, int p) {
  Slopes<double> sums;
  for (int i = p + 1; i < 2 * (p + 1); ++i) sums.first += std::abs(rows[i]);
  for (int i = 2 * (p + 1); i < 3 * (p + 1); ++i) sums.second += std::abs(rows[i]);
  return sums;
}

// S^w and its derivatives of order 1 and 2, of one vertex or several.
template <class T>
struct SecondOrder {
  Xyzw<T> S, Su, Sv, Suu, Suv, Svv;
};

// The second form (a b; b c) in the orthonormal basis.
template <class T>
struct ShapeMatrix {
  Xyz<T> point, normal;
  T a, b, c;
  T noise;  // what a, b, c can be where they are zero
};

// False where S_u and S_v span no plane at one of the vertices, or there is no point.
template <class T>
inline bool find_shape_matrix(const SecondOrder<T>& A, const NetSize& net, const Slopes<double>& in_u,
                              const Slopes<T>& in_v, ShapeMatrix<T>& shape) {
  const T r = 1.0 / A.S.w;
  const Xyz<T> S = {A.S.xyz.x / A.S.w, A.S.xyz.y / A.S.w, A.S.xyz.z / A.S.w};
  const Xyz<T> Su = (A.Su.xyz - S * A.Su.w) * r;
  const Xyz<T> Sv = (A.Sv.xyz - S * A.Sv.w) * r;
  const T size_u = square_root(dot(Su, Su));
  const T size_v = square_root(dot(Sv, Sv));
  // From here on with both tangents, and so both parameters, scaled to speed 1: E = G = 1.
  const T ru = 1.0 / size_u, rv = 1.0 / size_v;
  const Xyz<T> Tu = Su * ru, Tv = Sv * rv;
  const Xyz<T> across = cross(Tu, Tv);
  const T cosine = dot(Tu, Tv), sine2 = dot(across, across), rs = 1.0 / square_root(sine2);
  shape.point = S;
  shape.normal = across * rs;

  const T wu = A.Su.w * r, wv = A.Sv.w * r;
  const Xyz<T> Suu = ((A.Suu.xyz - S * A.Suu.w) * r - Su * (wu * 2.0)) * (ru * ru);
  const Xyz<T> Suv = ((A.Suv.xyz - S * A.Suv.w) * r - Su * wv - Sv * wu) * (ru * rv);
  const Xyz<T> Svv = ((A.Svv.xyz - S * A.Svv.w) * r - Sv * (wv * 2.0)) * (rv * rv);
  const T L = dot(Suu, shape.normal);
  const T M = dot(Suv, shape.normal);
  const T N = dot(Svv, shape.normal);
  shape.a = L;
  shape.b = (M - cosine * L) * rs;
  shape.c = (N - cosine * (M * 2.0 - cosine * L)) * (rs * rs);

  // The normal, too, is rounded: it leans by unit |N'|/|S_u|, and then sees the second derivatives along the surface.
  const T unit = absolute(r) * (net.coordinate + net.weight * max_norm(S)) * 1e-13;
  const T slope_u = in_u.first * ru, slope_v = in_v.first * rv;
  const T bends = (in_u.second * ru + slope_u * absolute(wu)) * ru + (in_v.second * rv + slope_v * absolute(wv)) * rv;
  const T leans = (slope_u + slope_v) * (max_norm(Suu) + max_norm(Suv) * 2.0 + max_norm(Svv)) * rs;
  shape.noise = unit * (bends + slope_u * slope_v * 2.0 + leans) * (rs * rs);
  return all_of(size_u > in_u.first * unit * 10.0, size_v > in_v.first * unit * 10.0, sine2 > 1e-12,
                finite_number(shape.a), finite_number(shape.b), finite_number(shape.c));
}

// K, H, k1, k2.
template <class T>
inline std::array<T, 4> curvatures(const ShapeMatrix<T>& shape) {
  const T middle = (shape.a + shape.c) * 0.5;
  const T half = (shape.a - shape.c) * 0.5;
  const T radius = square_root(half * half + shape.b * shape.b);
  const T zero{}, high = middle + radius, low = middle - radius;
  const T k1 = absolute(high) > shape.noise ? high : zero;
  const T k2 = absolute(low) > shape.noise ? low : zero;
  return {k1 * k2, (k1 + k2) * 0.5, k1, k2};
}

// The derivatives up to order 2 of the basis functions of a span, rows above the degree zero.
using SecondOrderRows = std::array<double, 3 * max_order>;

inline Point<double> plain_point(const Xyz<double>& P) { return {P.x, P.y, P.z}; }

}  // namespace detail

// Nothing where the denominator is zero, or S_u and S_v span no plane (poles, apices, folds; see
// curvatures_from_inside). At knots the second derivatives are those of the piece to the right.
inline std::optional<SurfaceShape> surface_shape(const Surface<double>& surface, double u, double v) {
  const auto [p, q] = surface.degree;
  const int k = find_span<double>(surface.knots[0], p, u);
  const int l = find_span<double>(surface.knots[1], q, v);
  detail::SecondOrderRows M{}, N{};
  basis_derivatives<double>(surface.knots[0], p, k, u, 2, M);
  basis_derivatives<double>(surface.knots[1], q, l, v, 2, N);
  const auto combined = [&, p = p, q = q](int i, int j) {
    return detail::load(detail::combine<0, 0>(M.data() + i * (p + 1), N.data() + j * (q + 1), &surface.at(k - p, l - q),
                                              surface.columns, p, q)
                            .point());
  };
  const detail::SecondOrder<double> A{combined(0, 0), combined(1, 0), combined(0, 1),
                                      combined(2, 0), combined(1, 1), combined(0, 2)};
  detail::ShapeMatrix<double> shape;
  if (!detail::find_shape_matrix(A, detail::NetSize(surface), detail::slopes(M.data(), p), detail::slopes(N.data(), q),
                                 shape)) {
    return std::nullopt;
  }

  SurfaceShape result;
  std::array<Point<double>, 9> D;
  if (!derivatives(surface, u, v, 2, D)) return std::nullopt;
  result.point = detail::plain_point(shape.point);
  result.normal = detail::plain_point(shape.normal);
  result.Su = D[3];
  result.Sv = D[1];
  result.E = glm::dot(result.Su, result.Su);
  result.F = glm::dot(result.Su, result.Sv);
  result.G = glm::dot(result.Sv, result.Sv);
  result.L = glm::dot(D[6], result.normal);
  result.M = glm::dot(D[4], result.normal);
  result.N = glm::dot(D[2], result.normal);
  const auto [K, H, k1, k2] = detail::curvatures(shape);
  result.curvatures = {K, H, k1, k2};

  const double spread = std::hypot((shape.a - shape.c) * 0.5, shape.b);
  const double size = std::max(std::abs(shape.a), std::abs(shape.c));
  result.umbilic = spread <= shape.noise + 1e-9 * size;
  const Point<double> e1 = result.Su / glm::length(result.Su);
  const Point<double> e2 = glm::cross(result.normal, e1);
  const double angle = result.umbilic ? 0 : 0.5 * std::atan2(2 * shape.b, shape.a - shape.c);
  result.maximum_direction = e1 * std::cos(angle) + e2 * std::sin(angle);
  result.minimum_direction = e2 * std::cos(angle) - e1 * std::sin(angle);
  return result;
}

// The limit of the curvatures towards a place of the boundary where surface_shape finds none, such as the pole of a
// sphere: from values a little inside, carried on along a line. Nothing where they grow towards it (an apex), for then
// there is no limit, and nothing at places inside of the domain.
inline std::optional<Curvatures> curvatures_from_inside(const Surface<double>& surface, double u, double v) {
  const auto inwards = [](const std::vector<double>& U, int p, double x) {
    const double begin = U[p], end = U[U.size() - static_cast<std::size_t>(p) - 1];
    const int k = find_span<double>(U, p, x);
    const double step = (U[k + 1] - U[k]) * (1.0 / 1024);
    return x == begin ? step : x == end ? -step : 0;
  };
  double du = inwards(surface.knots[0], surface.degree[0], u);
  double dv = inwards(surface.knots[1], surface.degree[1], v);
  if (du == 0 && dv == 0) return std::nullopt;
  // At a corner both ways lead inside; a side that has shrunk to a point is left across it.
  const auto near = surface_shape(surface, u + du, v + dv);
  const auto far = surface_shape(surface, u + 2 * du, v + 2 * dv);
  if (!near || !far) return std::nullopt;
  const auto& [K1, H1, a1, b1] = near->curvatures;
  const auto& [K2, H2, a2, b2] = far->curvatures;
  const double size = std::max(std::abs(a1), std::abs(b1));
  if (std::abs(a1 - a2) + std::abs(b1 - b2) > 0.1 * size) return std::nullopt;
  const double k1 = 2 * a1 - a2, k2 = 2 * b1 - b2;
  return Curvatures{k1 * k2, (k1 + k2) * 0.5, std::max(k1, k2), std::min(k1, k2)};
}

// Curvatures at the vertices of a grid, in the order of its points, for maps in colours.
struct CurvatureGrid {
  SurfaceGrid grid;  // with normals
  std::vector<double> gaussian, mean, maximum, minimum;
  std::vector<int> singular;  // the vertices without curvatures, ascending; theirs are 0

  std::vector<detail::Slopes<double>> slopes_v;  // working memory
  std::vector<HPoint<double>> row_uu;
};

namespace detail {

// One vertex where the curvatures may be a limit, or not exist.
inline void fill_curvatures_of(const Surface<double>& surface, int a, int b, const HPoint<double>& A,
                               CurvatureGrid& made) {
  const int vertex = a * made.grid.columns + b;
  const double u = made.grid.parameters[0][a], v = made.grid.parameters[1][b];
  const auto S = affine_point(A);
  std::optional<Curvatures> found;
  Point<double> normal(0.0);
  if (!S) {
    made.grid.undefined.push_back(vertex);
  } else if (const auto shape = surface_shape(surface, u, v)) {
    normal = shape->normal;
    found = shape->curvatures;
  } else {
    normal = unit_normal(surface, u, v).value_or(normal);
    found = curvatures_from_inside(surface, u, v);
  }
  if (!found) made.singular.push_back(vertex);
  const auto [K, H, k1, k2] = found.value_or(Curvatures{});
  made.grid.points[vertex] = S.value_or(Point<double>(0.0));
  made.grid.normals[vertex] = normal;
  made.gaussian[vertex] = K;
  made.mean[vertex] = H;
  made.maximum[vertex] = k1;
  made.minimum[vertex] = k2;
}

template <int Q>
void fill_curvatures(const Surface<double>& surface, CurvatureGrid& made) {
  SurfaceGrid& grid = made.grid;
  const auto [p, q] = surface.degree;
  const NetSize net(surface);
  const auto& [in_u, in_v] = grid.tables;
  const HPoint<double>*const row = grid.row[0].data(), *const row_u = grid.row[1].data();
  const HPoint<double>* const row_uu = made.row_uu.data();
  std::array<std::array<HPoint<double>, lanes>, 6> A;
  for (auto& derivative : A) derivative.fill(HPoint<double>(0, 0, 0, 1));
  Slopes<Lanes> slopes_v;
  for (int a = 0; a < grid.rows; ++a) {
    const double* M = in_u.values.data() + a * in_u.stride;
    const auto slopes_u = slopes(M, p);
    combine_rows(surface, in_u.first[a], M, 0, surface.columns, grid.row[0].data());
    combine_rows(surface, in_u.first[a], M + p + 1, 0, surface.columns, grid.row[1].data());
    combine_rows(surface, in_u.first[a], M + 2 * (p + 1), 0, surface.columns, made.row_uu.data());
    for (int b = 0; b < grid.columns; b += lanes) {
      const int count = std::min(lanes, grid.columns - b);
      for (int k = 0; k < count; ++k) {
        const double* N = in_v.values.data() + (b + k) * in_v.stride;
        const int j = in_v.first[b + k];
        A[0][k] = combine<Q>(N, row + j, q).point();
        A[1][k] = combine<Q>(N, row_u + j, q).point();
        A[2][k] = combine<Q>(N + q + 1, row + j, q).point();
        A[3][k] = combine<Q>(N, row_uu + j, q).point();
        A[4][k] = combine<Q>(N + q + 1, row_u + j, q).point();
        A[5][k] = combine<Q>(N + 2 * (q + 1), row + j, q).point();
        slopes_v.first[k] = made.slopes_v[b + k].first;
        slopes_v.second[k] = made.slopes_v[b + k].second;
      }
      const SecondOrder<Lanes> at{load_lanes(A[0].data()), load_lanes(A[1].data()), load_lanes(A[2].data()),
                                  load_lanes(A[3].data()), load_lanes(A[4].data()), load_lanes(A[5].data())};
      ShapeMatrix<Lanes> shape;
      if (!find_shape_matrix(at, net, slopes_u, slopes_v, shape)) {
        for (int k = 0; k < count; ++k) fill_curvatures_of(surface, a, b + k, A[0][k], made);
        continue;
      }
      const auto [K, H, k1, k2] = curvatures(shape);
      const int vertex = a * grid.columns + b;
      store(shape.point, count, &grid.points[vertex]);
      store(shape.normal, count, &grid.normals[vertex]);
      store(K, count, &made.gaussian[vertex]);
      store(H, count, &made.mean[vertex]);
      store(k1, count, &made.maximum[vertex]);
      store(k2, count, &made.minimum[vertex]);
    }
  }
}

}  // namespace detail

// As evaluate_grid with normals, and the curvatures; where they exist as a limit only, that is what they are.
inline void evaluate_curvatures(const Surface<double>& surface, std::span<const double> u, std::span<const double> v,
                                CurvatureGrid& made) {
  detail::prepare_grid(surface, u, v, 2, made.grid);
  for (auto* values : {&made.gaussian, &made.mean, &made.maximum, &made.minimum}) values->resize(u.size() * v.size());
  made.singular.clear();
  made.row_uu.resize(surface.columns);
  made.slopes_v.clear();
  const auto& in_v = made.grid.tables[1];
  for (std::size_t b = 0; b < v.size(); ++b) {
    made.slopes_v.push_back(detail::slopes(in_v.values.data() + b * in_v.stride, surface.degree[1]));
  }
  detail::with_degree<double>(surface.degree[1], [&](auto Q) { detail::fill_curvatures<Q()>(surface, made); });
}

}  // namespace blossom
