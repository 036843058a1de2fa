#pragma once
// Surface interrogation by light: a number for each point of a surface, whose bands are drawn as stripes. In double.
//
//   isophotes         the angle between the normal and the direction of the light (Poeschl 1984)
//   reflection lines  where the ray from the eye, reflected by the surface, meets a plane of parallel lines (Klass,
//                     Correction of local surface irregularities using reflection lines, CAD 12(2), 1980)
//
// Both see the normals only: a surface that is C^k has stripes that are C^(k-1), so a break in the tangent planes tears
// them, a jump of the curvature bends them sharply, and a bump that shading hides makes them wave (Farin, Curves and
// Surfaces for CAGD, section 23.2).

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <vector>

#include "geometry/geometry.hpp"
#include "kernel/evaluate.hpp"

namespace blossom {

// The angle between two vectors, 0..pi; nothing where one of them is zero. The arcus cosine would lose half of the
// digits near both ends.
inline std::optional<double> angle_between(const Point<double>& a, const Point<double>& b) {
  const Point<double> cross = glm::cross(a, b);
  const double sine = std::hypot(cross.x, cross.y, cross.z), cosine = glm::dot(a, b);
  return sine == 0 && cosine == 0 ? std::nullopt : std::optional(std::atan2(sine, cosine));
}

// Of any lengths: `light` points to the light. 0 where the surface faces it, pi/2 on the silhouette seen from it.
inline std::optional<double> isophote(const Point<double>& normal, const Point<double>& light) {
  return angle_between(normal, light);
}

// The parallel lines in a plane: through `origin`, along `direction`, their neighbours at distances along `across`,
// which is perpendicular to it, both of length 1.
struct LightLines {
  Point<double> origin, direction, across;
};

// The lines above the box of a surface, at twice its height, going along y: what a tunnel of lamps over a car is. For a
// surface without extent, too.
inline LightLines lines_above(const Point<double>& low, const Point<double>& high) {
  const Point<double> half = high * 0.5 - low * 0.5, middle = low + half;
  const double size = std::max({half.x, half.y, half.z});
  return {middle + Point<double>(0, 0, 2 * half.z + (size > 0 ? size : 1)), {0, 1, 0}, {1, 0, 0}};
}

// Where somebody looks from: a place, or infinitely far away (parallel projection).
struct Eye {
  Point<double> place;  // or, infinitely far, the direction towards it
  bool infinitely_far = false;

  Point<double> ray_to(const Point<double>& point) const { return infinitely_far ? -place : point - place; }
};

// The ray mirrored by a surface with a normal of length 1, whichever of the two sides it comes from.
inline Point<double> reflected(const Point<double>& ray, const Point<double>& normal) {
  return ray - normal * (2 * glm::dot(ray, normal));
}

// How far from the line through the origin, along `across`, the reflected ray meets the plane of the lines; nothing
// where it runs away from the plane or along it, and without a normal.
inline std::optional<double> reflection_line(const Point<double>& point, const Point<double>& normal, const Eye& eye,
                                             const LightLines& lines) {
  const Point<double> ray = reflected(eye.ray_to(point), normal);
  const Point<double> upright = glm::cross(lines.across, lines.direction);
  const double height = glm::dot(lines.origin - point, upright), climb = glm::dot(ray, upright);
  if (normal == Point<double>(0.0) || !(height * climb > 0)) return std::nullopt;
  const double value = glm::dot(point - lines.origin, lines.across) + height / climb * glm::dot(ray, lines.across);
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

// The same with lines infinitely far away all around, where the reflected ray counts by its direction: the angle around
// the direction of the lines, -pi..pi, 0 towards upright = across x direction. It exists nearly everywhere; it jumps
// from pi to -pi straight down, which stripes hide when a whole number of them goes around. Nothing where the ray runs
// along the lines.
inline std::optional<double> reflection_angle(const Point<double>& point, const Point<double>& normal, const Eye& eye,
                                              const LightLines& lines) {
  const Point<double> ray = reflected(eye.ray_to(point), normal);
  const double side = glm::dot(ray, lines.across), up = glm::dot(ray, glm::cross(lines.across, lines.direction));
  if (normal == Point<double>(0.0) || (side == 0 && up == 0)) return std::nullopt;
  return std::atan2(side, up);
}

// Stripes of equal width, dark and bright in turns; the one from 0 to width is bright.
inline bool is_dark_stripe(double value, double width) {
  const double pair = value / (2 * width);
  return pair - std::floor(pair) >= 0.5;
}

// One value for each vertex of a grid; those without one, ascending, have 0.
struct VertexValues {
  std::vector<double> values;
  std::vector<int> undefined;
};

namespace detail {

template <class Value>
void fill_values(std::size_t count, VertexValues& made, Value&& value) {
  made.values.resize(count);
  made.undefined.clear();
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<double> found = value(i);
    if (!found) made.undefined.push_back(static_cast<int>(i));
    made.values[i] = found.value_or(0);
  }
}

}  // namespace detail

inline void isophotes(std::span<const Point<double>> normals, const Point<double>& light, VertexValues& made) {
  detail::fill_values(normals.size(), made, [&](std::size_t i) { return isophote(normals[i], light); });
}

// `points` and `normals` of the same grid; all_around: by reflection_angle.
inline void reflection_lines(std::span<const Point<double>> points, std::span<const Point<double>> normals,
                             const Eye& eye, const LightLines& lines, bool all_around, VertexValues& made) {
  detail::fill_values(normals.size(), made, [&](std::size_t i) {
    return all_around ? reflection_angle(points[i], normals[i], eye, lines)
                      : reflection_line(points[i], normals[i], eye, lines);
  });
}

}  // namespace blossom
