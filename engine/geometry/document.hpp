#pragma once
// Geometry in JSON files: {"degree", "knots"?, "points", "weights"?} for a curve (no knots: Bezier; no weights:
// polynomial), the same with pairs, rows and columns for a surface. Every mistake is named at its own place.

#include <optional>
#include <string>

#include "base/json.hpp"
#include "geometry/geometry.hpp"

namespace blossom {

// Nothing, with diagnostics, unless: degree 1..25; knots nondecreasing, their number n + p + 2, no multiplicity above
// p + 1, domain not empty; points all of 2 or all of 3 coordinates, at least p + 1; weights as many as points, none
// negative, the first and last of a clamped end positive (The NURBS Book 4.2: an inner weight of zero takes its point
// out of the curve), not all zero on any span. At most 65,536 control points.
std::optional<Curve<Exact>> read_curve(const Cursor&);
std::optional<Surface<Exact>> read_surface(const Cursor&);

// The JSON text of a curve or surface, on one line; numbers of an exact one as strings where they are no integers.
template <Scalar S>
std::string write_curve(const Curve<S>&);
template <Scalar S>
std::string write_surface(const Surface<S>&);

}  // namespace blossom
