#include "scene/color_bands.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace blossom {
namespace {

constexpr int most_cuts = 12;  // through one triangle

struct Corner {
  glm::dvec3 position, normal;
  double number;
};

Corner between(const Corner& a, const Corner& b, double number) {
  const double t = (number - a.number) / (b.number - a.number);
  const glm::dvec3 normal = a.normal + t * (b.normal - a.normal);
  const double length = glm::length(normal);
  return {a.position + t * (b.position - a.position), length > 0 ? normal / length : a.normal, number};
}

// What of a convex polygon lies on one side of a number.
void keep(const std::vector<Corner>& polygon, double number, bool above, std::vector<Corner>& kept) {
  kept.clear();
  const auto inside = [&](const Corner& c) { return above ? c.number >= number : c.number <= number; };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (inside(a)) kept.push_back(a);
    if ((a.number < number && b.number > number) || (a.number > number && b.number < number))
      kept.push_back(between(a, b, number));
  }
}

}  // namespace

Mesh banded(const Mesh& mesh, const std::vector<double>& numbers) {
  Mesh made;
  made.role = mesh.role;
  made.opacity = mesh.opacity;
  made.map = ColorMap::bands;
  const auto add = [&](const std::vector<Corner>& polygon, float value) {
    if (polygon.size() < 3) return;
    const auto first = static_cast<std::uint32_t>(made.positions.size());
    for (const Corner& c : polygon) {
      made.positions.push_back(c.position);
      made.normals.push_back(c.normal);
      made.values.push_back(value);
    }
    for (std::uint32_t i = 2; i < polygon.size(); ++i)
      made.indices.insert(made.indices.end(), {first, first + i - 1, first + i});
  };
  std::vector<Corner> triangle, rest, stripe;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    triangle.clear();
    double low = 1e300, high = -1e300;
    bool known = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t at = mesh.indices[i + k];
      const double number = at < numbers.size() ? numbers[at] : 0;
      known = known && std::isfinite(number) && std::abs(number) < 1e9;
      triangle.push_back({mesh.positions[at], at < mesh.normals.size() ? mesh.normals[at] : glm::dvec3(0), number});
      low = std::min(low, number);
      high = std::max(high, number);
    }
    if (!known) {
      add(triangle, 0);
      continue;
    }
    const double first = std::floor(low), last = std::floor(high);
    if (last - first > most_cuts) {
      add(triangle, 0.5F);
      continue;
    }
    for (double whole = first; whole <= last; ++whole) {
      keep(triangle, whole, true, rest);
      keep(rest, whole + 1, false, stripe);
      add(stripe, std::fmod(std::abs(whole), 2) == 0 ? 0.0F : 1.0F);
    }
  }
  return made;
}

}  // namespace blossom
