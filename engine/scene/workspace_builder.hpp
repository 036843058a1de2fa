#pragma once
// Draws the things of a scene into a view. Internal to the scene: WorkspaceScenes::view is the way in.

#include <glm/geometric.hpp>

#include "scene/object_samples.hpp"
#include "scene/strokes.hpp"
#include "scene/workspace_view.hpp"

namespace blossom {

// A thing as it is drawn now.
struct Thing {
  std::size_t index = 0;
  const SceneObject* object = nullptr;
  const ObjectSamples* samples = nullptr;
  bool current = false, chosen = false;
  Role role = Role::object_0;
  double u = 0, v = 0;  // in the domain
  bool shows(Show show) const { return object->shows[show]; }
};

// The names of points as books have them.
RichText point_name(const ObjectSamples&, std::size_t point);
std::string point_spot_name(const SceneObject&, const ObjectSamples&, std::size_t point);  // "profile P[1][2]"
RichText level_name(int level, const std::vector<int>& indices);                           // P with (r) and i, or i,j
RichText italic(std::string text);

// All points of de Boor's algorithm on the span of u, level by level: levels[r][j] is P[r][k - p + r + j].
struct NetLevels {
  int first = 0;  // k - p
  std::vector<std::vector<HPoint<double>>> levels;
};
NetLevels de_boor_levels(const std::vector<double>& knots, int degree, std::span<const HPoint<double>> in_force,
                         int span, double u);

// The derivative curve, shrunk by a factor when it is much larger than the curve itself.
struct Hodograph {
  double factor = 1;
  std::vector<std::vector<glm::dvec3>> lines;  // nothing: there is none
  std::vector<glm::dvec3> polygon;             // its control polygon, of a curve without weights
};
Hodograph hodograph_of(const ObjectSamples&);

// The B-spline (wx, wy, w) that a plane rational curve is the projection of from the origin, with the plane w = 1 at
// z = 0 and heights stretched to the size of the curve.
struct Lifted {
  double height = 1;     // of the plane w = 1 above the origin
  Curve<double> spline;  // in the space of the scene
  glm::dvec3 origin() const { return {0, 0, -height}; }
  glm::dvec3 place(const HPoint<double>& P) const { return {P.x, P.y, (P.w - 1) * height}; }
};
std::optional<Lifted> lifted(const ObjectSamples&);

class WorkspaceBuilder {
 public:
  // `view` has its size and its camera.
  WorkspaceBuilder(const WorkspaceLook& look, const Bounds& bounds, Sheet& sheet);

  void add_ground();
  // Faces first, for a canvas draws them first, and their spots lie below all others.
  void add_shape(const Thing&);
  void hide_ground_names();  // those behind the faces, when all shapes are there
  void add_points(const Thing&);
  void add_marks(const Thing&);
  void add_name(const Thing&);
  void add_gizmo();
  void finish();  // spots of points, nearest last

 private:
  // ---- marks of a curve ----
  void add_curve_marks(const Thing&, const Curve<double>&);
  void add_net(const Thing&, const Curve<double>&);
  void add_triad(const Thing&, const Curve<double>&);
  void add_circle(const Curve<double>&, double u, bool sphere);
  void add_comb(const Thing&);
  void add_hodograph(const Thing&, const Curve<double>&);
  void add_projection(const Thing&, const Curve<double>&);
  void add_traced_point(const glm::dvec3& at, RichText name, bool loud);
  // ---- marks of a surface ----
  void add_surface_marks(const Thing&, const Surface<double>&);
  void add_lines_through(const Surface<double>&, double u, double v);
  void add_surface_net(const Surface<double>&, double u, double v);
  void add_tangents(const Surface<double>&, double u, double v);
  void add_principal(const Surface<double>&, double u, double v);
  void add_faces(const Thing&);

  void add_lines(const std::vector<std::vector<glm::dvec3>>&, Role, double width);
  void add_arrow(const glm::dvec3& from, const glm::dvec3& along, double length, Role, RichText name);
  void find_nearest() const;
  bool hidden(const glm::dvec3&) const;  // behind faces
  void add_label(Label);                 // unless what it names is hidden
  void add_spot(const Link&, const glm::dvec3& at, double half, std::string name);
  bool flat() const { return view_.camera.kind == Camera::Kind::plane; }

  const WorkspaceLook& look_;
  const Bounds& bounds_;
  Sheet& sheet_;
  View& view_;
  Lens lens_;
  double unit_;  // of the page, in the world at the centre
  double mark_;  // the length of arrows, in the world
  struct PointSpot {
    Spot spot;
    double z;
  };
  std::vector<PointSpot> point_spots_;
  std::vector<Spot> shape_spots_, handle_spots_;
  // How near the faces are, cell by cell, when somebody first asks.
  mutable std::vector<float> nearest_;
  mutable int cell_columns_ = 0, cell_rows_ = 0;
  std::size_t opaque_ = 0;  // meshes of the view that are faces of surfaces
};

// The range of a map's colours: from -range to range (light lines have none: 0).
bool has_range(SurfaceMap);

}  // namespace blossom
