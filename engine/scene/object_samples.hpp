#pragma once
// The geometry of one thing of a scene in doubles, sampled: made anew when its geometry changes, and read by everything
// that is drawn of it. What only some marks need is worked out when they first ask for it.

#include <memory>

#include "kernel/frame.hpp"
#include "kernel/tessellate.hpp"
#include "scene/display_list.hpp"
#include "scene/fit.hpp"
#include "studio/workspace.hpp"

namespace blossom {

using PlainGeometry = std::variant<Curve<double>, Surface<double>, PointRow<double>, PointNet<double>>;

inline glm::dvec3 plain(const Point<double>& p) { return {p.x, p.y, p.z}; }
// Nothing for a weight of 0.
std::optional<glm::dvec3> plain_place(const HPoint<double>&);

// A curve as polylines: few points where it is nearly straight, many where it bends.
struct CurveTrack {
  std::vector<double> u;
  std::vector<glm::dvec3> points;
  std::vector<std::size_t> pieces;  // the first point of each connected piece

  template <class Body>
  void for_each_piece(const Body& body) const {  // body(first, end)
    for (std::size_t i = 0; i < pieces.size(); ++i)
      body(pieces[i], i + 1 < pieces.size() ? pieces[i + 1] : points.size());
  }
};
CurveTrack track_of(const Curve<double>&);

// Frames at parameters along the whole curve, for combs, plots and rides.
struct CurveFrames {
  std::vector<double> u;
  std::vector<std::optional<FrenetFrame>> frames;
  std::vector<std::optional<MovingFrame>> moving;  // rotation-minimising, upright at the beginning where that can be
};

// A surface as a grid of vertices; a at [a * columns + b] belongs to (u[a], v[b]).
struct SurfaceTrack {
  std::vector<double> u, v;
  Mesh mesh;  // without the triangles at poles of the denominator
  SurfaceGrid grid;
  std::array<std::vector<std::size_t>, 2> isolines, knot_lines;  // rows a of constant u; columns b of constant v
  std::size_t columns() const { return v.size(); }

  // In pieces, where the surface has poles. direction 0: of constant u.
  std::vector<std::vector<glm::dvec3>> line(int direction, std::size_t at) const;
};

// Numbers over a surface, one per vertex: curvatures; of isophotes the number of the stripe.
struct SurfaceNumbers {
  std::vector<double> values;  // NaN where there is none
  double range = 0;            // what 95 in 100 of them do not exceed, absolutely
};

class ObjectSamples {
 public:
  explicit ObjectSamples(const Geometry&);
  // The same as made anew from `changed`; where only control points of a surface moved, in less time.
  void update(const Geometry& changed);

  const Geometry& exact() const { return exact_; }
  const PlainGeometry& geometry() const { return geometry_; }
  const Curve<double>* curve() const { return std::get_if<Curve<double>>(&geometry_); }
  const Surface<double>* surface() const { return std::get_if<Surface<double>>(&geometry_); }
  bool spatial() const { return spatial_; }
  int columns() const { return columns_; }  // of points: 0 for a row

  // ---- its control points ----
  const std::vector<std::optional<glm::dvec3>>& points() const { return points_; }
  const Bounds& bounds() const { return bounds_; }              // of points and samples
  const Bounds& shape_bounds() const { return shape_bounds_; }  // of samples alone, if there are any

  // ---- a curve ----
  const CurveTrack& track() const { return track_; }
  const std::vector<glm::dvec3>& knots() const { return knots_; }  // where the inner knots are on it
  const CurveFrames& frames() const;

  // ---- a surface ----
  const SurfaceTrack& mesh() const { return mesh_; }
  const SurfaceNumbers& numbers(SurfaceMap) const;

 private:
  void make();
  void sample();
  bool move_points(const Geometry& changed);
  void fill_vertices(const GridUpdate&);
  void fill_triangles();
  void find_bounds();

  Geometry exact_;
  PlainGeometry geometry_;
  bool spatial_ = false;
  int columns_ = 0;
  std::vector<std::optional<glm::dvec3>> points_;
  Bounds bounds_, shape_bounds_;
  CurveTrack track_;
  std::vector<glm::dvec3> knots_;
  SurfaceTrack mesh_;
  mutable std::unique_ptr<CurveFrames> frames_;
  mutable std::array<std::unique_ptr<SurfaceNumbers>, surface_map_count> numbers_;
};

// The rotation-minimising frame at u in the domain, carried on from the last of frames() before it.
std::optional<MovingFrame> moving_frame_at(const ObjectSamples&, double u);

}  // namespace blossom
