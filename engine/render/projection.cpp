#include "render/projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace blossom {
namespace {

constexpr double farthest_page_unit = 1e6;

}  // namespace

Projection::Projection(const View& view) : lens_(view.camera, {view.width, view.height}), x_(view.x), y_(view.y) {
  if (!has_depth()) return;
  const double height = lens_.camera().height;
  bool any = false;
  const auto extend = [&](const auto& points) {
    for (const glm::dvec3& p : points) {
      const double z = lens_.z_of(p);
      // What is absurdly far away must not use up the depth of the rest.
      if (!(std::abs(z) < 1e4 * height)) continue;
      nearest_ = any ? std::max(nearest_, z) : z;
      farthest_ = any ? std::min(farthest_, z) : z;
      any = true;
    }
  };
  for (const auto& mesh : view.meshes) extend(mesh.positions);
  for (const auto& polygon : view.polygons) extend(polygon.points);
  for (const auto& line : view.polylines) extend(line.points);
  for (const auto& marker : view.markers) extend(std::array{marker.position});
  const double margin = 0.1 * height;
  nearest_ += margin;
  farthest_ -= margin;
  if (lens_.perspective()) nearest_ = std::min(nearest_, 0.98 * lens_.eye());
}

double Projection::depth_of(double z) const {
  if (!lens_.perspective()) return (nearest_ - z) / (nearest_ - farthest_);
  // Linear in 1/distance, hence along straight lines of the picture.
  const double eye = lens_.eye();
  const double near = eye - nearest_, far = std::max(eye - farthest_, near * 1.001), distance = eye - z;
  return far / (far - near) * (1 - near / distance);
}

std::optional<PagePoint> Projection::operator()(const glm::dvec3& p, double pull) const {
  const auto seen = lens_(p);
  if (!seen) return std::nullopt;
  PagePoint result{x_ + seen->x, y_ + seen->y, 0};
  if (has_depth()) {
    const double pulled = std::min(seen->z + pull / 100 * lens_.camera().height, nearest_);
    result.depth = std::clamp(depth_of(pulled), 0.0, 1.0);
  }
  // Written so that a NaN fails.
  if (!(std::abs(result.x) < farthest_page_unit && std::abs(result.y) < farthest_page_unit)) return std::nullopt;
  return result;
}

}  // namespace blossom
