#pragma once
// Curves and surfaces whose shape is known from their formulas.

#include <functional>
#include <vector>

#include "geometry/geometry.hpp"
#include "kernel/derivatives.hpp"

namespace blossom::test {

// The coefficients of 1, t, t^2, ... of one coordinate.
using Polynomial = std::vector<double>;

// The curve (x, y, z)/w of polynomials in t, as one Bezier piece over t in [begin, end]. With t = begin + h s, the
// Bezier form of sum_j c_j s^j is b_i = sum_j binom(i,j)/binom(p,j) c_j.
inline Curve<double> polynomial_curve(const std::vector<Polynomial>& coordinates, double begin, double end,
                                      int dimension = 3) {
  Curve<double> curve;
  curve.dimension = dimension;
  curve.rational = coordinates.size() == 4;
  for (const auto& c : coordinates) curve.degree = std::max(curve.degree, static_cast<int>(c.size()) - 1);
  const int p = curve.degree;
  curve.knots.assign(static_cast<std::size_t>(p) + 1, begin);
  curve.knots.insert(curve.knots.end(), static_cast<std::size_t>(p) + 1, end);
  curve.points.assign(static_cast<std::size_t>(p) + 1, HPoint<double>(0, 0, 0, curve.rational ? 0 : 1));
  for (std::size_t d = 0; d < coordinates.size(); ++d) {
    Polynomial shifted(static_cast<std::size_t>(p) + 1, 0.0);  // in s
    for (std::size_t k = 0; k < coordinates[d].size(); ++k) {
      for (std::size_t j = 0; j <= k; ++j) {
        shifted[j] += coordinates[d][k] * detail::binomial[k][j] * std::pow(begin, k - j) * std::pow(end - begin, j);
      }
    }
    for (int i = 0; i <= p; ++i) {
      double b = 0;
      for (int j = 0; j <= i; ++j) b += shifted[j] * detail::binomial[i][j] / detail::binomial[p][j];
      curve.points[i][static_cast<int>(d)] = b;
    }
  }
  return curve;
}

inline Curve<double> twisted_cubic(double begin, double end) {
  return polynomial_curve({{0, 1}, {0, 0, 1}, {0, 0, 0, 1}}, begin, end);
}

// The circle of nine control points in the xy-plane (The NURBS Book, section 7.5).
inline Curve<double> full_circle(double radius, double cx = 0, double cy = 0) {
  Curve<double> curve;
  curve.degree = 2;
  curve.rational = true;
  curve.knots = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
  const double x[] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, y[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
  for (int i = 0; i < 9; ++i) {
    const double w = i % 2 == 0 ? 1 : std::sqrt(0.5);
    curve.points.emplace_back(w * (cx + radius * x[i]), w * (cy + radius * y[i]), 0, w);
  }
  return curve;
}

// The profile (x, y) = (radius, height), turned about the z-axis: u runs around, v along the profile (The NURBS Book,
// section 8.5, with the directions exchanged).
inline Surface<double> revolved(const Curve<double>& profile) {
  const auto circle = full_circle(1);
  Surface<double> surface;
  surface.degree = {2, profile.degree};
  surface.knots = {circle.knots, profile.knots};
  surface.rows = 9;
  surface.columns = static_cast<int>(profile.points.size());
  surface.rational = true;
  for (const auto& A : circle.points) {
    for (const auto& P : profile.points) surface.points.emplace_back(A.x * P.x, A.y * P.x, A.w * P.y, A.w * P.w);
  }
  return surface;
}

// A half circle around (0, 0) from the south pole to the north pole.
inline Curve<double> half_circle(double radius) {
  Curve<double> curve;
  curve.degree = 2;
  curve.rational = true;
  curve.knots = {0, 0, 0, 0.5, 0.5, 1, 1, 1};
  const double h = std::sqrt(0.5), r = radius;
  curve.points = {{0, -r, 0, 1}, {h * r, -h * r, 0, h}, {r, 0, 0, 1}, {h * r, h * r, 0, h}, {0, r, 0, 1}};
  return curve;
}

inline Surface<double> sphere(double radius) { return revolved(half_circle(radius)); }
inline Surface<double> torus(double large, double small) { return revolved(full_circle(small, large, 0)); }

// The graph z = c0 + c1 x + c2 y + c3 xy over [x0,x1] x [y0,y1], bilinear, x = u, y = v.
inline Surface<double> bilinear_graph(std::array<double, 2> x, std::array<double, 2> y,
                                      const std::function<double(double, double)>& z) {
  Surface<double> surface;
  surface.degree = {1, 1};
  surface.knots = {std::vector{x[0], x[0], x[1], x[1]}, std::vector{y[0], y[0], y[1], y[1]}};
  surface.rows = surface.columns = 2;
  for (const double a : x) {
    for (const double b : y) surface.points.emplace_back(a, b, z(a, b), 1);
  }
  return surface;
}

}  // namespace blossom::test
