#pragma once
// A camera that shows all of something.

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/camera.hpp"

namespace blossom {

struct Bounds {
  glm::dvec3 low{1e300}, high{-1e300};
  void add(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void add(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  bool empty() const { return !(low.x <= high.x); }
  glm::dvec3 centre() const { return (low + high) * 0.5; }
  double diagonal() const { return empty() ? 0 : glm::length(high - low); }
};

// Kind, azimuth, elevation, roll and perspective are kept. `for_each(see)` calls see(place) for all that is to be seen;
// it may be nothing. With a margin for labels.
template <class ForEach>
Camera fitted_camera(Camera camera, double width, double height, const Bounds& bounds, const ForEach& for_each) {
  constexpr double margin = 1.18;
  if (camera.kind == Camera::Kind::page || bounds.empty()) return camera;
  camera.centre = bounds.centre();
  if (camera.kind == Camera::Kind::plane) {
    const glm::dvec3 size = bounds.high - bounds.low;
    camera.height = std::max({size.y, size.x * height / width, 1e-9}) * margin;
    return camera;
  }
  const ViewAxes axes = axes_of(camera);
  const glm::dvec3 middle = camera.centre;
  glm::dvec2 low{1e300}, high{-1e300};
  const auto see = [&](const glm::dvec3& at) {
    const glm::dvec2 seen{glm::dot(at - middle, axes.right), glm::dot(at - middle, axes.up)};
    low = glm::min(low, seen);
    high = glm::max(high, seen);
  };
  for_each(see);
  if (!(low.x <= high.x)) see(bounds.low);
  camera.centre += 0.5 * (low.x + high.x) * axes.right + 0.5 * (low.y + high.y) * axes.up;
  camera.height = std::max({high.y - low.y, (high.x - low.x) * height / width, 1e-9}) * margin;
  if (!camera.perspective) return camera;
  // A point (x, y, z) of the view is seen at y e / (e - z), where the eye's distance e = height / (2 tangent); that
  // this is within height / (2 margin) is linear in the height.
  double needed = 1e-9;
  for_each([&](const glm::dvec3& at) {
    const glm::dvec3 d = at - camera.centre;
    const double x = std::abs(glm::dot(d, axes.right)) * height / width, y = std::abs(glm::dot(d, axes.up));
    needed = std::max(needed, 2 * (margin * std::max(x, y) + half_angle_tangent * glm::dot(d, axes.toward)));
  });
  camera.height = needed;
  return camera;
}

}  // namespace blossom
