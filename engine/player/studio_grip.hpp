#pragma once
// What hands do in the studio: looking around, dragging control points, u, or a handle for moving, turning and scaling,
// and the box that chooses points. From where a thing was taken and where the mouse is to the scene that is meant;
// every edit of a drag starts from the scene as it was when it began, so that on the way back all is as it was.
//
// Lengths are page units of the pane in which the drag is.

#include <memory>

#include "player/grip.hpp"
#include "studio/edit_workspace.hpp"

namespace blossom {

enum class StudioPane : std::uint8_t { space, xy, xz, yz };
inline constexpr int pane_count = 4;
std::string_view pane_name(StudioPane);  // "space", "xy", ...

// What a handle does, by the id of its Link.
enum class Handle : std::uint8_t { move_x, move_y, move_z, move, turn_x, turn_y, turn_z, scale };

struct StudioGrip {
  enum class Kind : std::uint8_t { look, points, parameter, handle, box };
  Kind kind = Kind::look;
  StudioPane pane = StudioPane::space;
  Camera camera;
  ViewSize size;
  glm::dvec2 start{};
  double grid = 0;                          // the distance of its lines
  bool turns = false;                       // look: the view turns, otherwise it is shifted
  PointRef held;                            // points: the one under the mouse
  std::vector<PointRef> points;             // points, handle: what moves along
  std::vector<std::size_t> objects;         // handle: where no points move
  std::size_t object = 0;                   // parameter
  Handle handle = Handle::move;             // handle
  Point<Exact> centre;                      // handle
  std::shared_ptr<const Workspace> before;  // set when it is taken
};

// The line of sight under `at` where it meets the plane through `through`; nothing where it runs along the plane.
std::optional<glm::dvec3> on_plane(const Camera&, ViewSize, glm::dvec2 at, const glm::dvec3& through,
                                   const glm::dvec3& normal);

// How far the held points go. Along one axis with Shift, onto the grid with Ctrl.
Point<Exact> displacement(const StudioGrip&, glm::dvec2 mouse, const GripKeys&);
// What a handle does to what it holds. With Ctrl in steps of the grid, of 15 degrees, of a quarter.
Placement placement(const StudioGrip&, glm::dvec2 mouse, const GripKeys&);
// The scene that is meant, of points and handles; `quick` while the mouse moves.
Worked dragged(const StudioGrip&, glm::dvec2 mouse, const GripKeys&, bool quick);
// The control points in the box from `start` to the mouse, of the things that show theirs.
std::vector<PointRef> boxed(const Workspace&, const StudioGrip&, glm::dvec2 mouse);

// "P[2]", of a surface or a net "P[1][3]"
std::string point_name(const Geometry&, std::size_t point);
glm::dvec3 in_world(const Point<Exact>&);

}  // namespace blossom
