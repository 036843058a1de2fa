#pragma once
// The convex hull of some points as a view shows it: one can see through it.

#include <span>

#include "geometry/geometry.hpp"
#include "scene/display_list.hpp"

namespace blossom {

// In space its faces and edges; of points in a plane the polygon, on a line the segment. Nothing of a single point.
void add_hull(View&, std::span<const Point<double>> points);

}  // namespace blossom
