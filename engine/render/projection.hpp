#pragma once
// World to page, for one view: page units and a depth of 0 (near) to 1 (far).

#include <optional>

#include "scene/camera.hpp"

namespace blossom {

struct PagePoint {
  double x = 0, y = 0;  // page units, on the page
  double depth = 0;
};

class Projection {
 public:
  explicit Projection(const View&);

  bool has_depth() const { return lens_.camera().kind == Camera::Kind::orbit; }
  // Unit vector towards the viewer.
  glm::dvec3 to_viewer(const glm::dvec3& from) const { return lens_.to_viewer(from); }

  // Nothing for what is behind the viewer, not finite, or more than 1e6 page units away. `pull` moves the depth (not
  // the place) toward the viewer, in hundredths of the camera's height, so that lines on a surface stand before it.
  std::optional<PagePoint> operator()(const glm::dvec3&, double pull = 0) const;

 private:
  double depth_of(double z) const;

  Lens lens_;
  double x_ = 0, y_ = 0;
  double nearest_ = 1, farthest_ = -1;  // z toward the viewer, about the centre, of all that is in the view
};

}  // namespace blossom
