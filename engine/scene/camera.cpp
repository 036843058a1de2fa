#include "scene/camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace blossom {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double steepest = 89 * pi / 180;
constexpr double least_height = 1e-9, most_height = 1e12;

bool finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

Camera in_numbers(Camera camera) {
  if (!(std::isfinite(camera.height) && camera.height > 0)) camera.height = 1;
  if (!finite(camera.centre)) camera.centre = {};
  if (!std::isfinite(camera.azimuth)) camera.azimuth = 0;
  if (!std::isfinite(camera.elevation)) camera.elevation = 0;
  if (!std::isfinite(camera.roll)) camera.roll = 0;
  return camera;
}

// The same turn within (-pi, pi].
double wrapped(double angle) {
  const double turned = std::remainder(angle, 2 * pi);
  return turned <= -pi ? turned + 2 * pi : turned;
}

}  // namespace

ViewAxes axes_of(const Camera& camera) {
  switch (camera.kind) {
    case Camera::Kind::page:
      return {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
    case Camera::Kind::plane:
      return {};
    case Camera::Kind::orbit:
      break;
  }
  const double ca = std::cos(camera.azimuth), sa = std::sin(camera.azimuth);
  const double ce = std::cos(camera.elevation), se = std::sin(camera.elevation);
  const ViewAxes upright{{-sa, ca, 0}, {-se * ca, -se * sa, ce}, {ce * ca, ce * sa, se}};
  if (camera.roll == 0) return upright;
  const double cr = std::cos(camera.roll), sr = std::sin(camera.roll);
  return {cr * upright.right + sr * upright.up, cr * upright.up - sr * upright.right, upright.toward};
}

Lens::Lens(const Camera& camera, ViewSize size) : camera_(in_numbers(camera)), size_(size), axes_(axes_of(camera_)) {
  if (camera_.kind == Camera::Kind::page) return;
  units_ = size_.height / camera_.height;
  if (camera_.kind == Camera::Kind::orbit && camera_.perspective) eye_ = camera_.height / 2 / half_angle_tangent;
}

double Lens::z_of(const glm::dvec3& p) const { return glm::dot(p - camera_.centre, axes_.toward); }

std::optional<Lens::Seen> Lens::operator()(const glm::dvec3& p) const {
  if (camera_.kind == Camera::Kind::page) return Seen{p.x, p.y, p.z};
  const glm::dvec3 d = p - camera_.centre;
  const double z = glm::dot(d, axes_.toward);
  if (!before_eye(z)) return std::nullopt;
  const double zoom = perspective() ? units_ * (eye_ / (eye_ - z)) : units_;
  return Seen{size_.width / 2 + zoom * glm::dot(d, axes_.right), size_.height / 2 - zoom * glm::dot(d, axes_.up), z};
}

std::optional<glm::dvec3> Lens::back(glm::dvec2 at, double z) const {
  if (camera_.kind == Camera::Kind::page) return glm::dvec3{at.x, at.y, z};
  if (!before_eye(z)) return std::nullopt;
  const double zoom = perspective() ? units_ * (eye_ / (eye_ - z)) : units_;
  return camera_.centre + (at.x - size_.width / 2) / zoom * axes_.right - (at.y - size_.height / 2) / zoom * axes_.up +
         z * axes_.toward;
}

glm::dvec3 Lens::to_viewer(const glm::dvec3& from) const {
  if (!perspective()) return axes_.toward;
  const glm::dvec3 d = camera_.centre + eye_ * axes_.toward - from;
  const double length = glm::length(d);
  return length > 0 ? d / length : axes_.toward;
}

Camera panned(const Camera& camera, ViewSize size, glm::dvec2 drag) {
  if (camera.kind == Camera::Kind::page) return camera;
  const Lens lens(camera, size);
  const double unit = lens.camera().height / size.height;
  Camera moved = lens.camera();
  moved.centre += unit * (drag.y * lens.axes().up - drag.x * lens.axes().right);
  return moved;
}

Camera zoomed(const Camera& camera, ViewSize size, glm::dvec2 at, double factor) {
  if (camera.kind == Camera::Kind::page || !(factor > 0)) return camera;
  const Lens lens(camera, size);
  Camera moved = lens.camera();
  // A picture that is larger or smaller than that by itself may come back, but go no further.
  moved.height =
      std::clamp(moved.height / factor, std::min(least_height, moved.height), std::max(most_height, moved.height));
  // The plane through the centre is seen without perspective, and is scaled about the point.
  const glm::dvec3 still = *lens.back(at, 0);
  moved.centre = still + moved.height / lens.camera().height * (moved.centre - still);
  return moved;
}

Camera orbited(const Camera& camera, ViewSize size, glm::dvec2 drag) {
  if (camera.kind != Camera::Kind::orbit) return camera;
  Camera moved = in_numbers(camera);
  moved.azimuth = wrapped(moved.azimuth - drag.x / size.width * pi);
  moved.elevation = std::clamp(moved.elevation + drag.y / size.width * pi, -steepest, steepest);
  return moved;
}

Camera facing(const Camera& camera, Plane plane) {
  if (camera.kind == Camera::Kind::page) return camera;
  Camera turned = camera;
  turned.perspective = false;
  turned.roll = 0;
  if (camera.kind == Camera::Kind::plane && plane == Plane::xy) return turned;
  turned.kind = Camera::Kind::orbit;
  turned.azimuth = plane == Plane::yz ? 0 : -pi / 2;
  turned.elevation = plane == Plane::xy ? pi / 2 : 0;
  return turned;
}

std::optional<glm::dvec2> to_page(const Camera& camera, ViewSize size, const glm::dvec3& p) {
  const auto seen = Lens(camera, size)(p);
  if (!seen) return std::nullopt;
  return glm::dvec2{seen->x, seen->y};
}

std::optional<glm::dvec3> to_world(const Camera& camera, ViewSize size, glm::dvec2 at, const glm::dvec3& through) {
  const Lens lens(camera, size);
  return lens.back(at, camera.kind == Camera::Kind::page ? through.z : lens.z_of(through));
}

std::optional<glm::dvec3> to_line(const Camera& camera, ViewSize size, glm::dvec2 at, const glm::dvec3& through,
                                  const glm::dvec3& direction) {
  const Lens lens(camera, size);
  const double length = glm::length(direction);
  const auto start = lens.back(at, 0);
  if (!(length > 0) || !start) return std::nullopt;
  const glm::dvec3 d = direction / length, ray = -lens.to_viewer(*start);
  // The nearest points of two lines; where the sine of their angle is small, a pixel would be a long way.
  const double cosine = glm::dot(d, ray), sine_squared = 1 - cosine * cosine;
  if (sine_squared < 1e-3) return std::nullopt;
  const glm::dvec3 offset = *start - through;
  const glm::dvec3 found = through + (glm::dot(offset, d) - cosine * glm::dot(offset, ray)) / sine_squared * d;
  if (!lens(found)) return std::nullopt;
  return found;
}

Camera between(const Camera& from, const Camera& to, double t) {
  if (!(t > 0) || from.kind == Camera::Kind::page || to.kind == Camera::Kind::page) return t > 0 ? to : from;
  if (t >= 1) return to;
  // A plane camera looks straight down.
  const auto turning = [](Camera camera) {
    if (camera.kind == Camera::Kind::orbit) return camera;
    camera.kind = Camera::Kind::orbit;
    return facing(camera, Plane::xy);
  };
  const bool flat = from.kind == Camera::Kind::plane && to.kind == Camera::Kind::plane;
  const Camera a = flat ? from : turning(from), b = flat ? to : turning(to);
  Camera made = b;
  made.centre = a.centre + t * (b.centre - a.centre);
  made.height = a.height * std::pow(b.height / a.height, t);
  made.azimuth = wrapped(a.azimuth + t * wrapped(b.azimuth - a.azimuth));
  made.elevation = a.elevation + t * (b.elevation - a.elevation);
  made.roll = wrapped(a.roll + t * wrapped(b.roll - a.roll));
  return made;
}

}  // namespace blossom
