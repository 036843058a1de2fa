#pragma once
// What geometry stands on: coordinate grids with their numbers.

#include "scene/display_list.hpp"
#include "scene/fit.hpp"

namespace blossom {

// 1, 2 or 5 times a power of ten: about `count` steps over `length`.
double nice_step(double length, double count);

// How far apart the lines are of either grid.
double plane_grid_step(const Camera&, double width, double height);
double ground_grid_step(const Bounds&);

// Of a camera that looks straight at a plane of two axes: all over the view, wherever it is; the numbers stand at its
// left and lower edge. `depth`: where the lines are toward the viewer.
void add_plane_grid(View&, double depth = 0);

// Of an orbit camera: a piece of a plane z = constant under the bounds, with arrows for x, y and z.
void add_ground_grid(View&, const Bounds&);

}  // namespace blossom
