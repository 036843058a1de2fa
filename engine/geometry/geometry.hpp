#pragma once
// Curves and surfaces as values. Control points are homogeneous, (w x, w y, w z, w): a polynomial curve has w = 1
// throughout, and every algorithm that only blends points serves all four kinds (Bezier, rational Bezier, B-spline,
// NURBS).
//
// Index conventions of The NURBS Book: degree p, control points P_0..P_n, knots u_0..u_m, m = n + p + 1, domain
// [u_p, u_{n+1}]. A Bezier curve is stored with the knots 0 (p+1 times), 1 (p+1 times).

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "base/scalar.hpp"

namespace blossom {

inline constexpr int max_degree = 25;

template <Scalar S>
using HPoint = glm::vec<4, S, glm::defaultp>;
template <Scalar S>
using Point = glm::vec<3, S, glm::defaultp>;

template <Scalar S>
struct Curve {
  int degree = 0;                 // 1..max_degree
  std::vector<S> knots;           // nondecreasing, no multiplicity above degree + 1
  std::vector<HPoint<S>> points;  // at least degree + 1
  int dimension = 2;              // 2 or 3; in 2D z = 0
  bool rational = false;          // weights were given
  bool bezier = false;            // given without knots

  int n() const { return static_cast<int>(points.size()) - 1; }
  int m() const { return static_cast<int>(knots.size()) - 1; }
  const S& domain_begin() const { return knots[static_cast<std::size_t>(degree)]; }
  const S& domain_end() const { return knots[points.size()]; }
  bool operator==(const Curve&) const = default;
};

// Control net P[i][j], i = 0..rows-1 along u, j = 0..columns-1 along v, stored row by row.
template <Scalar S>
struct Surface {
  std::array<int, 2> degree{};
  std::array<std::vector<S>, 2> knots;
  int rows = 0;
  int columns = 0;
  std::vector<HPoint<S>> points;
  bool rational = false;
  bool bezier = false;

  const HPoint<S>& at(int i, int j) const { return points[static_cast<std::size_t>(i) * columns + j]; }
  HPoint<S>& at(int i, int j) { return points[static_cast<std::size_t>(i) * columns + j]; }
  bool operator==(const Surface&) const = default;
};

// Points in a row: data to be interpolated, two points of an axis. All weights are 1.
template <Scalar S>
struct PointRow {
  std::vector<HPoint<S>> points;
  int dimension = 2;  // 2 or 3; in 2D z = 0

  bool operator==(const PointRow&) const = default;
};

// Points in rows and columns, D[i][j], stored row by row: data to be interpolated by a surface. All weights are 1.
template <Scalar S>
struct PointNet {
  int rows = 0;
  int columns = 0;
  std::vector<HPoint<S>> points;

  const HPoint<S>& at(int i, int j) const { return points[static_cast<std::size_t>(i) * columns + j]; }
  bool operator==(const PointNet&) const = default;
};

// The same geometry in another scalar: each number rounded once.
template <Scalar S>
Curve<S> convert(const Curve<Exact>&);
template <Scalar S>
Surface<S> convert(const Surface<Exact>&);
template <Scalar S>
PointRow<S> convert(const PointRow<Exact>&);
template <Scalar S>
PointNet<S> convert(const PointNet<Exact>&);

// The Bezier knots 0^(p+1), 1^(p+1).
template <Scalar S>
std::vector<S> bezier_knots(int degree) {
  std::vector<S> knots(static_cast<std::size_t>(2 * (degree + 1)), S(0));
  for (int i = degree + 1; i < 2 * (degree + 1); ++i) knots[static_cast<std::size_t>(i)] = S(1);
  return knots;
}

}  // namespace blossom
