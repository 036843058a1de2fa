#pragma once
// Lines and markers in one expression.

#include <utility>

#include "scene/display_list.hpp"

namespace blossom {

inline Polyline line(std::vector<glm::dvec3> points, Role role, double width = 1, bool dashed = false) {
  Polyline made;
  made.points = std::move(points);
  made.role = role;
  made.width_scale = width;
  made.dashed = dashed;
  return made;
}

inline Marker marker(const glm::dvec3& at, Role role, double size = 1, Marker::Shape shape = Marker::Shape::disc) {
  return {at, role, shape, size};
}

inline Polyline arrow(const glm::dvec3& from, const glm::dvec3& to, Role role, double width = 1) {
  Polyline made = line({from, to}, role, width);
  made.arrow = true;
  return made;
}

inline Label label_around(const glm::dvec3& at, RichText text, Role role, int priority, bool optional = true,
                          double size = 1) {
  Label made;
  made.anchor = at;
  made.text = std::move(text);
  made.role = role;
  made.size_scale = size;
  made.placement = Label::Placement::around;
  made.priority = priority;
  made.optional = optional;
  return made;
}

}  // namespace blossom
