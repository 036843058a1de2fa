#pragma once
// How a camera sees and moves: from the world to the page and back. Everything here is a pure function of a camera and
// the size of its view in page units; "drag" lengths are page units, x right, y down. A camera with numbers that are
// not finite sees as one with those of Camera{}.

#include <optional>

#include "scene/display_list.hpp"

namespace blossom {

struct ViewSize {
  double width = 1, height = 1;
};

// Directions of the view in the world.
struct ViewAxes {
  glm::dvec3 right{1, 0, 0}, up{0, 1, 0}, toward{0, 0, 1};  // toward the viewer
};
ViewAxes axes_of(const Camera&);

// Of the field of view of a perspective: 29 degrees vertically.
inline constexpr double half_angle_tangent = 0.26;

// A camera made ready to see many points.
class Lens {
 public:
  Lens(const Camera&, ViewSize);

  struct Seen {
    double x = 0, y = 0;  // page units from the view's top left
    double z = 0;         // of the world, toward the viewer from the plane through the centre
  };
  std::optional<Seen> operator()(const glm::dvec3&) const;  // nothing behind the viewer
  // What is under `at` in the plane that faces the view at this z. Nothing behind the viewer.
  std::optional<glm::dvec3> back(glm::dvec2 at, double z) const;

  const Camera& camera() const { return camera_; }  // with finite numbers
  const ViewAxes& axes() const { return axes_; }
  bool perspective() const { return eye_ > 0; }
  double eye() const { return eye_; }                  // its distance from the centre, in perspective
  glm::dvec3 to_viewer(const glm::dvec3& from) const;  // unit
  double z_of(const glm::dvec3& p) const;

 private:
  bool before_eye(double z) const { return !perspective() || z < 0.98 * eye_; }

  Camera camera_;
  ViewSize size_;
  ViewAxes axes_;
  double units_ = 1;  // page units per world unit, at the centre
  double eye_ = 0;
};

Camera panned(const Camera&, ViewSize, glm::dvec2 drag);
// The world point under `at` (page units from the view's top left; in the plane through the centre) stays there.
// factor > 1 comes closer.
Camera zoomed(const Camera&, ViewSize, glm::dvec2 at, double factor);
// Turns an orbit camera: a whole width of the view is half a turn. Elevation stays within +-89 degrees.
Camera orbited(const Camera&, ViewSize, glm::dvec2 drag);

// The three planes: looking straight at them, in parallel projection.
enum class Plane { xy, xz, yz };
Camera facing(const Camera&, Plane);

// Where a world point is on the page (from the view's top left); nothing behind the viewer.
std::optional<glm::dvec2> to_page(const Camera&, ViewSize, const glm::dvec3&);
// The world point under `at` in the plane through `through` that faces the view. Nothing where there is none.
std::optional<glm::dvec3> to_world(const Camera&, ViewSize, glm::dvec2 at, const glm::dvec3& through);
// The point of the line through `through` along `direction` that is nearest to what is under `at`. Nothing when the
// line runs toward the viewer.
std::optional<glm::dvec3> to_line(const Camera&, ViewSize, glm::dvec2 at, const glm::dvec3& through,
                                  const glm::dvec3& direction);

// From one camera to another: t = 0..1, for moving there. Angles take the shorter way.
Camera between(const Camera&, const Camera&, double t);

}  // namespace blossom
