#pragma once
// What a curve does at u: its Frenet frame, speed, curvature and torsion, osculating circle and sphere; and frames that
// turn about the tangent as little as possible. In double, for display.
//
// With T = C'/|C'|, N the direction of the part of C'' across T, and B = T x N (do Carmo, Differential Geometry of
// Curves and Surfaces, section 1-5):
//
//   curvature = |C' x C''| / |C'|^3        torsion = det(C', C'', C''') / |C' x C''|^2
//
// Where C' = 0 (a cusp, a doubled end point) these formulas say 0/0. There, let C^(a) be the first derivative that is
// not zero, C^(b) the first that is not parallel to it, C^(c) the first outside of their plane. Taylor's series in
// h = u' - u gives the leading terms of all of the above (for a, b, c = 1, 2, 3 they are the formulas themselves):
//
//   T -> C^(a)/|C^(a)|,  N and B of the plane of C^(a) and C^(b),
//   curvature ~ h^(b-2a)  |C^(a) x C^(b)| / |C^(a)|^3  (b-a) (a-1)!^2 / (b-1)!
//   torsion   ~ h^(c-a-b) det(C^(a), C^(b), C^(c)) / |C^(a) x C^(b)|^2  (c-a) (c-b) (a-1)! (b-1)! / ((b-a) (c-1)!)
//
// A piece of degree p shows a, b and c among its first p derivatives: where they all vanish, or stay on a line or in a
// plane, so does the piece, also a rational one (the equation of the line is a polynomial of degree p over w).
// "Vanishes" means: is no more than rounding can make of zero. Limits are those from the right, at the domain's end
// those from the left, as all derivatives are.

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
#include "kernel/span.hpp"

namespace blossom {

struct FrenetFrame {
  Point<double> point{};
  Point<double> tangent{};              // of length 1, the direction of motion
  std::optional<Point<double>> normal;  // not on a straight piece, nor at an inflection
  std::optional<Point<double>> binormal;
  double speed = 0;                        // |C'|
  std::optional<double> curvature;         // nothing where it is infinite (most cusps)
  std::optional<double> torsion;           // nothing where it is infinite, and without a normal
  std::optional<double> signed_curvature;  // of a curve in the plane: positive where it turns to the left
};

struct OsculatingCircle {
  Point<double> centre;
  double radius;
  Point<double> axis;  // the binormal
};

struct OsculatingSphere {
  Point<double> centre;
  double radius;
};

// A tangent with two vectors across it; all of length 1, and binormal = tangent x normal.
struct MovingFrame {
  Point<double> point, tangent, normal, binormal;
};

namespace detail {

using Vector = Point<double>;

inline double length(const Vector& v) { return std::hypot(v.x, v.y, v.z); }

// The part of v across a direction of length 1.
inline Vector across(const Vector& v, const Vector& direction) { return v - direction * glm::dot(v, direction); }

// A vector of length 1 across one of length 1: across the axis that is farthest from it.
inline Vector any_across(const Vector& direction) {
  const Vector size = glm::abs(direction);
  Vector axis(0.0);
  axis[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1;
  const Vector result = across(axis, direction);
  return result / length(result);
}

// C^(0)..C^(d) at one parameter, and how much of each rounding alone can have made: 1e-13 of the sum of the absolute
// values of all terms that went into it, with the largest control point in place of each (what computed the points has
// rounded them already).
struct Jet {
  std::array<Vector, max_order> C;
  std::array<double, max_order> noise;
};

inline bool find_jet(const Curve<double>& curve, double u, int d, Jet& jet) {
  const int p = curve.degree;
  const int k = find_span<double>(curve.knots, p, u);
  const HPoint<double>* P = curve.points.data() + (k - p);
  const int last = std::min(d, p);
  DerivativeRows<double> ders;
  basis_derivatives<double>(curve.knots, p, k, u, last, ders);
  auto& [C, noise] = jet;
  BasisRow<double> w{}, size_of_w{};
  for (int j = 0; j <= d; ++j) {
    const HPoint<double> A = j <= last ? combine<0>(ders.data() + j * (p + 1), P, p).point() : HPoint<double>(0.0);
    C[j] = xyz(A);
    w[j] = A.w;
  }
  if (!divide_by_weight(C.data(), d, w.data(), last)) return false;

  double largest = 0;
  for (int r = 0; r <= p; ++r) {
    largest = std::max(largest, max_norm(xyz(P[r])) + std::abs(P[r].w) * max_norm(C[0]));
  }
  for (int j = 0; j <= d; ++j) {
    noise[j] = 0;
    for (int r = 0; j <= last && r <= p; ++r) {
      const double N = std::abs(ders[j * (p + 1) + r]);
      noise[j] += 1e-13 * largest * N;
      size_of_w[j] += std::abs(P[r].w - P[0].w) * N;  // only differences of weights make derivatives of w
    }
    for (int i = 1; i <= std::min(j, last); ++i) noise[j] += binomial[j][i] * size_of_w[i] * noise[j - i];
    noise[j] /= std::abs(w[0]);
  }
  return true;
}

// The orders a, b, c that the head of this file speaks of, 0 for one that does not exist; T, N, B from them.
struct LeadingTerms {
  int a = 0, b = 0, c = 0;
  Vector T{}, N{}, B{};
  double size_a = 0, size_b = 0, size_c = 0;  // |C^(a)|, that of C^(b) across T, that of C^(c) along B (signed)
};

inline LeadingTerms leading_terms(const Jet& jet, int d) {
  LeadingTerms terms;
  int j = 1;
  for (; j <= d && terms.a == 0; ++j) {
    if (max_norm(jet.C[j]) <= jet.noise[j]) continue;
    terms.a = j;
    terms.size_a = length(jet.C[j]);
    terms.T = jet.C[j] / terms.size_a;
  }
  if (terms.a == 0) return terms;
  const double tilt_of_T = jet.noise[terms.a] / terms.size_a;  // by how much rounding can have turned it
  double tilt_of_B = 0;
  for (; j <= d && terms.b == 0; ++j) {
    const Vector part = across(jet.C[j], terms.T);
    const double size = length(part);
    const double noise = 2 * (jet.noise[j] + tilt_of_T * length(jet.C[j]));
    if (size <= noise) continue;
    terms.b = j;
    terms.size_b = size;
    terms.N = part / size;
    terms.B = glm::cross(terms.T, terms.N);
    tilt_of_B = noise / size;
  }
  for (; terms.b != 0 && j <= d && terms.c == 0; ++j) {
    const double part = glm::dot(jet.C[j], terms.B);
    if (std::abs(part) <= 2 * (jet.noise[j] + (tilt_of_T + tilt_of_B) * length(jet.C[j]))) continue;
    terms.c = j;
    terms.size_c = part;
  }
  return terms;
}

inline double factorial(int n) {
  double result = 1;
  for (int i = 2; i <= n; ++i) result *= i;
  return result;
}

inline std::optional<double> finite(double value) { return std::isfinite(value) ? std::optional(value) : std::nullopt; }

inline std::optional<double> limit_of_curvature(const LeadingTerms& terms) {
  const auto [a, b] = std::pair(terms.a, terms.b);
  if (b == 0 || b > 2 * a) return 0.0;
  if (b < 2 * a) return std::nullopt;
  const double factor = (b - a) * factorial(a - 1) * factorial(a - 1) / factorial(b - 1);
  return finite(terms.size_b / terms.size_a / terms.size_a * factor);
}

inline std::optional<double> limit_of_torsion(const LeadingTerms& terms) {
  const int a = terms.a, b = terms.b, c = terms.c;
  if (b == 0) return std::nullopt;
  if (c == 0 || c > a + b) return 0.0;
  if (c < a + b) return std::nullopt;
  const double factor = (c - a) * (c - b) * factorial(a - 1) * factorial(b - 1) / ((b - a) * factorial(c - 1));
  return finite(terms.size_c / terms.size_a / terms.size_b * factor);
}

// The jet and its leading terms: three derivatives nearly always settle it, all p where they do not.
inline bool find_leading_terms(const Curve<double>& curve, double u, Jet& jet, LeadingTerms& terms) {
  if (!find_jet(curve, u, 3, jet)) return false;
  terms = leading_terms(jet, 3);
  if (terms.a != 1 && curve.degree > 3) {
    if (!find_jet(curve, u, curve.degree, jet)) return false;
    terms = leading_terms(jet, curve.degree);
  }
  return terms.a != 0;
}

}  // namespace detail

// Nothing where there is no point (a zero denominator) or no tangent (a piece that is a single point). u: in the
// domain.
inline std::optional<FrenetFrame> frame(const Curve<double>& curve, double u) {
  detail::Jet jet;
  detail::LeadingTerms terms;
  if (!detail::find_leading_terms(curve, u, jet, terms)) return std::nullopt;
  const bool regular = terms.a == 1;

  FrenetFrame result;
  result.point = jet.C[0];
  result.tangent = terms.T;
  result.speed = regular ? terms.size_a : 0;
  result.curvature = detail::limit_of_curvature(terms);
  const bool turns = regular ? terms.b == 2 : terms.b != 0;
  if (turns) {
    result.normal = terms.N;
    result.binormal = terms.B;
    result.torsion = detail::limit_of_torsion(terms);
  }
  // From the left h is negative: C' ~ C^(a) h^(a-1) points along -C^(a) for an even a, and C' x C'' ~ h^(a+b-3).
  if (!regular && u == curve.domain_end()) {
    if (terms.a % 2 == 0) result.tangent = -result.tangent;
    if (turns && (terms.a + terms.b) % 2 == 0) result.binormal = -*result.binormal;
    if (turns) result.normal = glm::cross(*result.binormal, result.tangent);
  }
  if (curve.dimension == 2 && result.curvature) {
    const bool to_the_right = result.binormal && result.binormal->z < 0;
    result.signed_curvature = to_the_right ? -*result.curvature : *result.curvature;
  }
  return result;
}

// The circle that meets the curve to second order. Nothing on straight pieces, at inflections and at cusps.
inline std::optional<OsculatingCircle> osculating_circle(const FrenetFrame& at) {
  if (!at.normal || !at.curvature || !(*at.curvature > 0)) return std::nullopt;
  const double radius = 1 / *at.curvature;
  const Point<double> centre = at.point + *at.normal * radius;
  if (!is_finite(centre)) return std::nullopt;
  return OsculatingCircle{centre, radius, *at.binormal};
}

// The sphere that meets the curve to third order. Its centre M solves the first three derivatives of |C - M|^2 = 0:
//
//   (M - C).C' = 0,  (M - C).C'' = C'.C',  (M - C).C''' = 3 C'.C''
//
// On a circle every sphere through it does; then the one with the same centre is meant. Nothing where the torsion is
// zero otherwise (the sphere is a plane), nor where there is no osculating circle.
inline std::optional<OsculatingSphere> osculating_sphere(const Curve<double>& curve, double u) {
  detail::Jet jet;
  detail::LeadingTerms terms;
  if (!detail::find_leading_terms(curve, u, jet, terms) || terms.a != 1 || terms.b != 2) return std::nullopt;
  const auto& [C, noise] = jet;
  const double along_N = terms.size_a / terms.size_b * terms.size_a;
  const double left = 3 * glm::dot(C[1], C[2]);
  const double right = along_N * glm::dot(C[3], terms.N);
  double along_B = 0;
  if (terms.c == 3) {
    along_B = (left - right) / terms.size_c;
  } else {
    const double doubtful = 1e-9 * (std::abs(left) + std::abs(right)) + along_N * noise[3] +
                            3 * (terms.size_a * noise[2] + detail::length(C[2]) * noise[1]);
    if (std::abs(left - right) > doubtful) return std::nullopt;
  }
  const Point<double> to_centre = terms.N * along_N + terms.B * along_B;
  const OsculatingSphere sphere{C[0] + to_centre, detail::length(to_centre)};
  return is_finite(sphere.centre) && std::isfinite(sphere.radius) ? std::optional(sphere) : std::nullopt;
}

// The frames at many parameters: all that plots and combs of curvature, torsion and speed need.
inline void sample_frames(const Curve<double>& curve, std::span<const double> parameters,
                          std::vector<std::optional<FrenetFrame>>& frames) {
  frames.clear();
  for (const double u : parameters) frames.push_back(frame(curve, u));
}

namespace detail {

// The normal of `from`, carried on to a place with another tangent by two reflections: the first, across the plane
// halfway between the two points, and the second, which brings the reflected tangent to where it belongs, make a
// rotation (Wang, Juettler, Zheng, Liu, Computation of rotation minimizing frames, ACM TOG 27(1), 2008, table I).
inline Vector carried_normal(const MovingFrame& from, const Vector& point, const Vector& tangent) {
  const auto reflected = [](const Vector& v, const Vector& across_plane) {
    const double square = glm::dot(across_plane, across_plane);
    return square > 0 ? v - across_plane * (2 * glm::dot(across_plane, v) / square) : v;
  };
  Vector step = point - from.point;
  const double size = max_norm(step);
  // Between places that coincide any first plane does that contains the normal's turn; this one gives the least.
  step = size > 0 && std::isfinite(size) ? step / size : from.tangent;
  const Vector turn = tangent - reflected(from.tangent, step);
  // Rounding leaves a direction to a difference that should be zero; the reflection belonging to it would be any.
  const bool turned = max_norm(turn) > 1e-12;
  const Vector once = reflected(from.normal, step);
  const Vector normal = across(turned ? reflected(once, turn) : once, tangent);
  const double left = length(normal);
  return left > 0.5 ? normal / left : any_across(tangent);
}

}  // namespace detail

// Frames whose normal does not turn about the tangent, at ascending parameters, which should lie close together: the
// error falls with the fourth power of their distance. They pass through inflections, straight pieces and cusps (where
// tangent and binormal turn over). Without a start, the first normal is Frenet's, or any where that does not exist; in
// the plane it points to the left. Where a parameter has no frame() it has none here, and the next one carries on.
inline void rotation_minimising_frames(const Curve<double>& curve, std::span<const double> parameters,
                                       std::vector<std::optional<MovingFrame>>& frames,
                                       std::optional<Point<double>> start = std::nullopt) {
  frames.clear();
  const MovingFrame* last = nullptr;
  frames.reserve(parameters.size());  // so `last` stays where it is
  for (const double u : parameters) {
    const auto here = frame(curve, u);
    frames.emplace_back();
    if (!here) continue;
    Point<double> normal;
    if (last) {
      normal = detail::carried_normal(*last, here->point, here->tangent);
    } else {
      const Point<double> wanted = start                  ? *start
                                   : curve.dimension == 2 ? glm::cross(Point<double>(0, 0, 1), here->tangent)
                                                          : here->normal.value_or(Point<double>(0.0));
      const Point<double> part = detail::across(wanted, here->tangent);
      const double size = detail::length(part);
      normal = size > 1e-12 * detail::length(wanted) ? part / size : detail::any_across(here->tangent);
    }
    frames.back() = MovingFrame{here->point, here->tangent, normal, glm::cross(here->tangent, normal)};
    last = &*frames.back();
  }
}

}  // namespace blossom
