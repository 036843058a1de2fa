#include "exchange/exchange_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "kernel/tessellate.hpp"

namespace blossom::exchange {
namespace {

glm::dvec3 plain(const Point<double>& p) { return {p.x, p.y, p.z}; }

template <class Body>
void for_each_place(const Geometry& geometry, const Body& body) {
  std::visit(
      [&](const auto& g) {
        for (const HPoint<Exact>& P : g.points) {
          const double w = P.w.to_double();
          if (w == 0) continue;
          body(glm::dvec3{P.x.to_double() / w, P.y.to_double() / w, P.z.to_double() / w});
        }
      },
      geometry);
}

// Steps in each span so that the chords keep within the tolerance: of a curve with second derivative M, a chord over
// the parameter h is at most h^2 M / 8 away (Filip, Magedson, Markot 1986). M is measured on the finest grid.
int steps_for(const std::vector<glm::dvec3>& fine, int fine_steps, double tolerance) {
  double most = 0;
  for (std::size_t i = 1; i + 1 < fine.size(); ++i)
    most = std::max(most, glm::length(fine[i - 1] - 2.0 * fine[i] + fine[i + 1]) / 8);
  if (!(most > 0) || !(tolerance > 0)) return most > 0 ? fine_steps : 1;
  return std::clamp(static_cast<int>(std::ceil(fine_steps * std::sqrt(most / tolerance))), 1, 64);
}

constexpr int probe_steps = 16, most_lines = 512;

int spans_of(const std::vector<double>& U, int p) {
  int count = 0;
  for (std::size_t k = static_cast<std::size_t>(p); k + static_cast<std::size_t>(p) + 1 < U.size(); ++k)
    count += U[k] < U[k + 1] ? 1 : 0;
  return std::max(count, 1);
}

}  // namespace

std::vector<const SceneObject*> chosen(const Workspace& scene, const ExportOptions& options) {
  std::vector<const SceneObject*> objects;
  for (const std::size_t i : options.objects)
    if (i < scene.objects.size()) objects.push_back(&scene.objects[i]);
  if (options.objects.empty())
    for (const SceneObject& object : scene.objects)
      if (!object.hidden) objects.push_back(&object);
  return objects;
}

double length_of(const std::vector<const SceneObject*>& objects, double share) {
  glm::dvec3 low(1e300), high(-1e300);
  for (const SceneObject* object : objects)
    for_each_place(object->geometry, [&](const glm::dvec3& at) {
      low = glm::min(low, at);
      high = glm::max(high, at);
    });
  return low.x <= high.x ? share * glm::length(high - low) : share;
}

TriangleMesh mesh_of(const SceneObject& object, const Surface<double>& surface, double tolerance) {
  TriangleMesh mesh{object.name, object.color, {}, {}, {}};
  std::array<std::vector<double>, 2> at;
  SurfaceGrid grid;
  // A probing grid says how fine it must be in each direction.
  for (std::size_t d = 0; d < 2; ++d) {
    const int spans = spans_of(surface.knots[d], surface.degree[d]);
    span_parameters(surface.knots[d], surface.degree[d], std::clamp(most_lines / spans, 1, probe_steps), at[d]);
  }
  evaluate_grid(surface, at[0], at[1], false, grid);
  std::array<int, 2> steps{1, 1};
  for (std::size_t d = 0; d < 2; ++d) {
    const int lines = d == 0 ? grid.columns : grid.rows, along = d == 0 ? grid.rows : grid.columns;
    const int spans = spans_of(surface.knots[d], surface.degree[d]);
    const int fine = std::clamp(most_lines / spans, 1, probe_steps);
    for (int line = 0; line < lines; ++line) {
      std::vector<glm::dvec3> row;
      for (int i = 0; i < along; ++i)
        row.push_back(
            plain(grid.points[static_cast<std::size_t>(d == 0 ? i * grid.columns + line : line * grid.columns + i)]));
      steps[d] = std::max(steps[d], steps_for(row, fine, tolerance / 2));
    }
    steps[d] = std::clamp(steps[d], 1, std::max(1, most_lines / spans));
    span_parameters(surface.knots[d], surface.degree[d], steps[d], at[d]);
  }
  evaluate_grid(surface, at[0], at[1], true, grid);
  for (const auto& P : grid.points) mesh.positions.push_back(plain(P));
  for (const auto& N : grid.normals) mesh.normals.push_back(plain(N));
  std::vector<bool> undefined(mesh.positions.size());
  for (const int vertex : grid.undefined) undefined[static_cast<std::size_t>(vertex)] = true;
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (undefined[a] || undefined[b] || undefined[c]) return;
    const auto area = glm::cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    if (glm::dot(area, area) > 0) mesh.triangles.push_back({a, b, c});
  };
  for (int a = 0; a + 1 < grid.rows; ++a)
    for (int b = 0; b + 1 < grid.columns; ++b) {
      const auto i = static_cast<std::uint32_t>(a * grid.columns + b),
                 next = i + static_cast<std::uint32_t>(grid.columns);
      add(i, next, next + 1);
      add(i, next + 1, i + 1);
    }
  return mesh;
}

std::vector<Path> paths_of(const SceneObject& object, const Curve<double>& curve, double tolerance) {
  CurveSamples samples;
  const int spans = spans_of(curve.knots, curve.degree);
  const int fine = std::clamp(4096 / spans, 1, probe_steps);
  sample_curve(curve, fine, samples);
  std::vector<glm::dvec3> points;
  for (const auto& P : samples.points) points.push_back(plain(P));
  sample_curve(curve, std::clamp(steps_for(points, fine, tolerance), 1, std::max(1, 8192 / spans)), samples);
  std::vector<Path> paths;
  for (std::size_t piece = 0; piece < samples.pieces.size(); ++piece) {
    const std::size_t end = piece + 1 < samples.pieces.size() ? samples.pieces[piece + 1] : samples.points.size();
    Path path{object.name, object.color, {}};
    for (std::size_t i = samples.pieces[piece]; i < end; ++i) path.points.push_back(plain(samples.points[i]));
    if (path.points.size() > 1) paths.push_back(std::move(path));
  }
  return paths;
}

std::array<std::uint8_t, 3> rgb_of(int color) {
  static constexpr std::array<std::array<std::uint8_t, 3>, object_colors> all{{{0x00, 0x72, 0xB2},
                                                                               {0xD5, 0x5E, 0x00},
                                                                               {0x00, 0x9E, 0x73},
                                                                               {0xCC, 0x79, 0xA7},
                                                                               {0xE6, 0x9F, 0x00},
                                                                               {0x56, 0xB4, 0xE9},
                                                                               {0x8A, 0x80, 0x00},
                                                                               {0x60, 0x60, 0x60}}};
  return all[static_cast<std::size_t>(std::clamp(color, 0, object_colors - 1))];
}

std::string decimal(double x, int digits) {
  if (digits >= 17) return format_number(x);  // the shortest that reads back as the same double
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*g", std::clamp(digits, 1, 17), x);
  return text.data();
}

}  // namespace blossom::exchange
