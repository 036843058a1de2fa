#pragma once
// A scene of the studio, drawn: the things with what each shows. Sampling is kept between frames and done anew only for
// what changed (while a control point of a surface is dragged, only where it has influence).

#include <memory>

#include "scene/camera.hpp"
#include "scene/display_list.hpp"
#include "scene/spot.hpp"
#include "studio/edit_workspace.hpp"

namespace blossom {

struct WorkspaceLook {
  std::size_t current = SIZE_MAX;   // the thing one works on: brighter, thicker, with its points
  std::vector<std::size_t> chosen;  // chosen with it
  std::vector<PointRef> selected;   // control points
  std::optional<PointRef> hovered;
  std::optional<Camera> camera;  // otherwise fitted
  bool grid = true, axes = true;
  bool handles = true;              // false: only the shapes, as for a picture
  std::optional<double> u, v;       // of the current thing, while it is animated
  double comb_scale = 1;            // of the curvature comb's length
  double map_range = 0;             // of a curvature map: colours from -range to range; 0: from the surface's own
  std::optional<glm::dvec3> gizmo;  // where the handles for moving, turning and scaling stand
};

class WorkspaceScenes {
 public:
  WorkspaceScenes();
  ~WorkspaceScenes();

  // What is seen, as a view of this size at (0, 0). Spots: points on curves and surfaces (Link::Kind::object, named as
  // the thing), over them control points ("profile P[2]", "vase P[1][2]"), nearest to the viewer last, and then the
  // parts of the gizmo (Link::Kind::handle: "move x", "turn z", "scale"). Which curve or surface is under the mouse,
  // and where, parameter_at says exactly.
  Sheet view(const Workspace&, double width, double height, const WorkspaceLook&) const;
  // From where a scene is looked at when it is opened: as its file says; otherwise a plane one straight from above.
  Camera usual(const Workspace&, double width, double height) const;
  Camera fitted(const Workspace&, double width, double height, const Camera& look) const;
  // A picture of the scene with its title, the legend of a map, and what the marks mean.
  Scene page(const Workspace&, const WorkspaceLook&, double width, double height) const;
  // Where on the curve (or surface) `object` the mouse is, if within `reach` units of it: its u (and v).
  std::optional<glm::dvec2> parameter_at(const Workspace&, std::size_t object, const Camera&, ViewSize, glm::dvec2 at,
                                         double reach) const;
  // What the colours of a map go up to: look.map_range, or what 95 in 100 of the surface's values do not exceed. 0 for
  // stripes, and where all values are 0.
  double map_range(const Workspace&, std::size_t object, const WorkspaceLook&) const;
  // The camera that rides along a curve: just above it at u, looking along the tangent, upright by the
  // rotation-minimising frame that begins upright.
  std::optional<Camera> riding(const Workspace&, std::size_t object, double u) const;

 private:
  struct Cache;
  std::unique_ptr<Cache> cache_;
};

// The legend of a map: the band of colours with its numbers (from -range to range, see map_range), and what they mean.
// Its height; 0 of a thing without a map.
inline constexpr double map_legend_width = 210;
// The thing whose map is explained: the current one if it has a map that is seen, otherwise the first that has.
std::optional<std::size_t> mapped_object(const Workspace&, std::size_t current);
double add_map_legend(Sheet&, const SceneObject&, double range, double x, double y, double width);

// Plots over u, one below the other, with a mark at u: speed, curvature (signed in the plane), torsion (in space).
enum class CurvePlot : std::uint8_t { speed, curvature, torsion };
double add_curve_plots(Sheet&, const Curve<double>&, double u, const std::vector<CurvePlot>&, double x, double y,
                       double width, double height);

// The unit square of a surface: the knots with their multiplicities on its sides, the isoparametric lines through
// (u, v), and the point to be dragged. Spots: the point (Link::Kind::parameter), the knots of both sides
// (Link::Kind::knot; part 0: in u, 1: in v).
struct DomainSquare {
  double left = 0, top = 0, side = 0;  // page units; u runs to the right, v upwards
  glm::dvec2 first{0, 0}, last{1, 1};  // (u, v) of the lower left and the upper right corner
  glm::dvec2 place(glm::dvec2 uv) const;
  glm::dvec2 parameter(glm::dvec2 at) const;
};
DomainSquare add_domain_square(Sheet&, const Surface<double>&, glm::dvec2 uv, double x, double y, double size);

// The knots of a curve as multiplicity(value) on a line, those of a closed curve that follow from others quieter, and
// u. Spots: the knots (Link::Kind::knot), u.
double add_object_knots(Sheet&, const Curve<double>&, double u, double x, double y, double width);

// The partition of unity at u, or (u, v): a bar in as many parts as there are functions in force, each as long as its
// value, with its name. Its height.
double add_partition_bar(Sheet&, const Geometry&, double u, double v, double x, double y, double width);

}  // namespace blossom
