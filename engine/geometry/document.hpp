#pragma once
// Geometry in JSON files: {"degree", "knots"?, "points", "weights"?} for a curve (no knots: Bezier; no weights:
// polynomial), the same with pairs, rows and columns for a surface. Every mistake is named at its own place.

#include <optional>
#include <string>

#include "base/json.hpp"
#include "geometry/geometry.hpp"

namespace blossom {

// Nothing, with diagnostics, unless: degree 1..25; knots nondecreasing, their number n + p + 2, no multiplicity above
// p + 1, domain not empty, no two different knots the same double; points all of 2 or all of 3 coordinates, at least
// p + 1 of them (without knots exactly p + 1), at most 65,536; weights as many as points, none negative.
//
// A weight may be zero (The NURBS Book 4.2: it takes its point out of the curve, and the point's place in the file is
// not kept) as long as the denominator stays positive in the whole domain. It does when it is positive at every knot of
// the domain, because inside a span more points have influence than at its ends: at a knot u_f = ... = u_l of
// multiplicity s <= p these are P_{l-p}..P_{f-1}; where s = p + 1 (a clamped end, a jump) P_f to its right and P_{f-1}
// to its left. On a surface: the block of points of each pair of knots.
std::optional<Curve<Exact>> read_curve(const Cursor&);
std::optional<Surface<Exact>> read_surface(const Cursor&);

// [[x, y], ...]: all of 2 or all of 3 coordinates, `at_least` to `at_most` of them.
std::optional<PointRow<Exact>> read_points(const Cursor&, std::size_t at_least, std::size_t at_most);
// [[[x, y, z], ...], ...]: rows of equally many points, at least 2 x 2, at most 65,536 in all; of 3 coordinates, or of
// 2 (then z = 0).
std::optional<PointNet<Exact>> read_net(const Cursor&);

// The JSON text of a curve or surface, on one line: affine points, with weights if it is rational, without knots if it
// is a Bezier one. Numbers of an exact one are strings. A point of weight 0 is written with
// its homogeneous coordinates, which are 0 when it was read from a file. Reading the text gives the same value (of
// doubles, up to the rounding of w x / w).
template <Scalar S>
std::string write_curve(const Curve<S>&);
template <Scalar S>
std::string write_surface(const Surface<S>&);
template <Scalar S>
std::string write_points(const PointRow<S>&);
template <Scalar S>
std::string write_net(const PointNet<S>&);

}  // namespace blossom
