#include "scene/hull_shape.hpp"

#include "kernel/hull.hpp"
#include "scene/strokes.hpp"

namespace blossom {
namespace {

constexpr Role hull_role = Role::ratio_far;
constexpr double rim_width = 0.6, edge_width = 0.45;
constexpr double polygon_opacity = 0.22, flat_opacity = 0.25, faces_opacity = 0.3;

void add_polygon(View& view, Polyline rim) {
  if (rim.points.size() < 2) return;
  rim.closed = rim.points.size() > 2;
  if (rim.closed && view.camera.kind == Camera::Kind::plane) {
    view.polygons.push_back({rim.points, hull_role, polygon_opacity});
  } else if (rim.closed) {
    Mesh mesh;
    mesh.role = hull_role;
    mesh.opacity = flat_opacity;
    mesh.positions = rim.points;
    for (std::uint32_t i = 2; i < rim.points.size(); ++i) mesh.indices.insert(mesh.indices.end(), {0u, i - 1, i});
    view.meshes.push_back(std::move(mesh));
  }
  view.polylines.push_back(std::move(rim));
}

}  // namespace

void add_hull(View& view, std::span<const Point<double>> points) {
  const Hull hull = convex_hull(points);
  const auto at = [&](int i) {
    const Point<double>& P = points[static_cast<std::size_t>(i)];
    return glm::dvec3(P.x, P.y, P.z);
  };
  if (hull.triangles.empty()) {
    std::vector<glm::dvec3> corners;
    for (const int i : hull.polygon) corners.push_back(at(i));
    add_polygon(view, line(std::move(corners), hull_role, rim_width));
    return;
  }
  Mesh mesh;
  mesh.role = hull_role;
  mesh.opacity = faces_opacity;
  for (const auto& t : hull.triangles) {
    const glm::dvec3 corners[] = {at(t[0]), at(t[1]), at(t[2])};
    const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double size = glm::length(across);
    if (!(size > 0)) continue;
    for (const glm::dvec3& corner : corners) {
      mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
      mesh.positions.push_back(corner);
      mesh.normals.push_back(across / size);
    }
    for (std::size_t side = 0; side < 3; ++side)  // each edge once: its other triangle has it the other way round
      if (t[side] < t[(side + 1) % 3])
        view.polylines.push_back(line({corners[side], corners[(side + 1) % 3]}, hull_role, edge_width));
  }
  view.meshes.push_back(std::move(mesh));
}

}  // namespace blossom
