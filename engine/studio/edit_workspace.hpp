#pragma once
// Edits of a scene: pure functions from a workspace to a new one with everything made anew that follows from it, or to
// what is wrong. A made thing whose own points, weights, knots or degree are edited is given from then on. Given
// geometry is always such as a file can hold: exact and valid. Paths of diagnostics begin with the thing's name
// ("vase.knots[4]"), those of recipes at their inputs ("profiles[2]").

#include <functional>

#include "studio/edit_curve.hpp"
#include "studio/remake.hpp"

namespace blossom {

using Worked = Checked<Workspace>;

// A control point (of a surface or net: i * columns + j) of a thing.
struct PointRef {
  std::size_t object = 0, point = 0;
  auto operator<=>(const PointRef&) const = default;
};

// The place of a point, not multiplied with its weight; nothing for one of weight 0.
std::optional<Point<Exact>> place_of(const Geometry&, std::size_t point);

namespace edit {

// ---- things ----
Worked add(Workspace, SceneObject);                               // at the end, with a free name
Worked add_made(Workspace, const Recipe&);                        // each piece of its result, named after the algorithm
Worked set_recipe(Workspace, std::size_t object, const Recipe&);  // other parameters, other sources before it
Worked remove(Workspace, const std::vector<std::size_t>& objects);      // what is made from them is given from then on
Worked duplicate(Workspace, const std::vector<std::size_t>& objects);   // moved on a little
Worked rename(Workspace, std::size_t object, const std::string& name);  // recipes follow
Worked move_to(Workspace, std::size_t object, std::size_t place);       // refused before what it is made from
Worked detach(Workspace, std::size_t object);                           // given from now on
Worked set_color(Workspace, std::size_t object, int color);
Worked set_hidden(Workspace, const std::vector<std::size_t>& objects, bool hidden);
Worked set_show(Workspace, const std::vector<std::size_t>& objects, Show, bool on);
Worked set_map(Workspace, std::size_t object, SurfaceMap);
Worked look_at(Workspace, std::size_t object, const Exact& u, const Exact& v);  // clamped to the domain

// ---- points ----
// All of them by the same way. `quick`: what follows is made in doubles (while one drags).
Worked move_points(Workspace, const std::vector<PointRef>&, const Point<Exact>& by, bool quick = false);
Worked set_place(Workspace, const PointRef&, const Point<Exact>& to, bool quick = false);
Worked set_weight(Workspace, const PointRef&, const Exact& weight, bool quick = false);
Worked insert_point(Workspace, const PointRef& behind, const Point<Exact>& at);  // a curve's or a row's
Worked delete_points(Workspace, const std::vector<PointRef>&);

// ---- any edit of one curve or surface ----
Worked change(Workspace, std::size_t object, const std::function<EditedCurve(Curve<Exact>)>&, bool quick = false);
Worked change(Workspace, std::size_t object, const std::function<EditedSurface(Surface<Exact>)>&, bool quick = false);

// ---- placing ----
// Whole things, or only some points, about a centre. A made thing that is placed is given from then on.
Worked place(Workspace, const std::vector<std::size_t>& objects, const Placement&, const Point<Exact>& centre,
             bool quick = false);
Worked place(Workspace, const std::vector<PointRef>&, const Placement&, const Point<Exact>& centre, bool quick = false);
// An instance of a recipe: the `which`-th reference of an input.
Worked place_instance(Workspace, std::size_t object, std::string_view input, std::size_t which, const Placement&,
                      bool quick = false);

}  // namespace edit

}  // namespace blossom
