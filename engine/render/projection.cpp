#include "render/projection.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace blossom {
namespace {

constexpr double half_angle_tangent = 0.26;  // of the perspective's field of view: 29 degrees vertically
constexpr double farthest_page_unit = 1e6;

bool finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace

Projection::Projection(const View& view)
    : camera_(view.camera), x_(view.x), y_(view.y), width_(view.width), height_(view.height) {
  if (!(std::isfinite(camera_.height) && camera_.height > 0)) camera_.height = 1;
  if (!finite(camera_.centre)) camera_.centre = {};
  if (!std::isfinite(camera_.azimuth)) camera_.azimuth = 0;
  if (!std::isfinite(camera_.elevation)) camera_.elevation = 0;
  if (camera_.kind == Camera::Kind::page) return;
  units_ = height_ / camera_.height;
  if (camera_.kind == Camera::Kind::plane) return;

  const double ca = std::cos(camera_.azimuth), sa = std::sin(camera_.azimuth);
  const double ce = std::cos(camera_.elevation), se = std::sin(camera_.elevation);
  toward_ = {ce * ca, ce * sa, se};
  right_ = {-sa, ca, 0};
  up_ = {-se * ca, -se * sa, ce};
  eye_ = camera_.height / 2 / half_angle_tangent;

  bool any = false;
  const auto extend = [&](const auto& points) {
    for (const glm::dvec3& p : points) {
      const double z = glm::dot(p - camera_.centre, toward_);
      // What is absurdly far away must not use up the depth of the rest.
      if (!(std::abs(z) < 1e4 * camera_.height)) continue;
      nearest_ = any ? std::max(nearest_, z) : z;
      farthest_ = any ? std::min(farthest_, z) : z;
      any = true;
    }
  };
  for (const auto& mesh : view.meshes) extend(mesh.positions);
  for (const auto& polygon : view.polygons) extend(polygon.points);
  for (const auto& line : view.polylines) extend(line.points);
  for (const auto& marker : view.markers) extend(std::array{marker.position});
  const double margin = 0.1 * camera_.height;
  nearest_ += margin;
  farthest_ -= margin;
  if (camera_.perspective) nearest_ = std::min(nearest_, 0.98 * eye_);
}

double Projection::depth_of(double z) const {
  if (!camera_.perspective) return (nearest_ - z) / (nearest_ - farthest_);
  // Linear in 1/distance, hence along straight lines of the picture.
  const double near = eye_ - nearest_, far = std::max(eye_ - farthest_, near * 1.001), distance = eye_ - z;
  return far / (far - near) * (1 - near / distance);
}

glm::dvec3 Projection::to_viewer(const glm::dvec3& from) const {
  if (!has_depth() || !camera_.perspective) return toward_;
  const glm::dvec3 d = camera_.centre + eye_ * toward_ - from;
  const double length = glm::length(d);
  return length > 0 ? d / length : toward_;
}

std::optional<PagePoint> Projection::operator()(const glm::dvec3& p, double pull) const {
  PagePoint result;
  if (camera_.kind == Camera::Kind::page) {
    result = {x_ + p.x, y_ + p.y, 0};
  } else {
    const glm::dvec3 d = p - camera_.centre;
    const double z = glm::dot(d, toward_);
    double zoom = units_;
    if (has_depth()) {
      if (camera_.perspective) {
        if (!(z < nearest_)) return std::nullopt;
        zoom *= eye_ / (eye_ - z);
      }
      const double pulled = std::min(z + pull / 100 * camera_.height, nearest_);
      result.depth = std::clamp(depth_of(pulled), 0.0, 1.0);
    }
    result.x = x_ + width_ / 2 + zoom * glm::dot(d, right_);
    result.y = y_ + height_ / 2 - zoom * glm::dot(d, up_);
  }
  // Written so that a NaN fails.
  if (!(std::abs(result.x) < farthest_page_unit && std::abs(result.y) < farthest_page_unit)) return std::nullopt;
  return result;
}

}  // namespace blossom
