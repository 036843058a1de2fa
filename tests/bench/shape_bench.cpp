// What a studio does in every frame: curvature maps, frames along a curve, hulls, and the work of dragging a control
// point of a surface. Grids report the time per vertex as `per_vertex`.

#include <benchmark/benchmark.h>

#include <glm/vec3.hpp>
#include <random>
#include <vector>

#include "kernel/frame.hpp"
#include "kernel/hull.hpp"
#include "kernel/light_lines.hpp"
#include "kernel/surface_shape.hpp"
#include "kernel/tessellate.hpp"

namespace {

using namespace blossom;

std::vector<double> clamped_knots(int points, int p, std::mt19937& random) {
  std::uniform_real_distribution<double> step(0.5, 1.5);
  std::vector<double> U(static_cast<std::size_t>(p) + 1, 0.0);
  for (int i = p + 1; i <= points; ++i) U.push_back(U.back() + step(random));
  U.insert(U.end(), static_cast<std::size_t>(p), U.back());
  return U;
}

HPoint<double> control_point(double x, double y, std::mt19937& random) {
  std::uniform_real_distribution<double> height(-1, 1), weight(0.5, 2);
  const double w = weight(random);
  return {w * x, w * y, w * height(random), w};
}

// A bicubic NURBS surface of side x side control points.
Surface<double> surface_of(int side) {
  std::mt19937 random(2);
  Surface<double> surface;
  surface.degree = {3, 3};
  surface.knots = {clamped_knots(side, 3, random), clamped_knots(side, 3, random)};
  surface.rows = surface.columns = side;
  surface.rational = true;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) surface.points.push_back(control_point(i, j, random));
  }
  return surface;
}

std::vector<double> evenly(double end, int count) {
  std::vector<double> result;
  for (int i = 0; i < count; ++i) result.push_back(end * i / (count - 1));
  return result;
}

void per_vertex(benchmark::State& state, double vertices) {
  state.counters["per_vertex"] =
      benchmark::Counter(vertices, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void curvature_grid(benchmark::State& state) {
  const auto surface = surface_of(20);
  const auto u = evenly(surface.knots[0].back(), 256), v = evenly(surface.knots[1].back(), 256);
  CurvatureGrid made;
  for (auto _ : state) {
    evaluate_curvatures(surface, u, v, made);
    benchmark::DoNotOptimize(made.gaussian.data());
    benchmark::ClobberMemory();
  }
  per_vertex(state, 256 * 256);
}

// What is drawn: as the player's meshes.
struct Mesh {
  std::vector<glm::dvec3> positions, normals;
  std::vector<std::uint32_t> indices;
};

void convert(const SurfaceGrid& grid, Mesh& mesh) {
  mesh.positions.assign(grid.points.begin(), grid.points.end());
  mesh.normals.assign(grid.normals.begin(), grid.normals.end());
  mesh.indices.clear();
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  for (std::uint32_t a = 0; a + 1 < static_cast<std::uint32_t>(grid.rows); ++a) {
    for (std::uint32_t b = 0; b + 1 < columns; ++b) {
      const std::uint32_t at = a * columns + b;
      mesh.indices.insert(mesh.indices.end(), {at, at + columns, at + columns + 1, at, at + columns + 1, at + 1});
    }
  }
}

void convert(const SurfaceGrid& grid, const GridUpdate& update, Mesh& mesh) {
  const auto width = update.last_b + 1 - update.first_b;
  for (int a = update.first_a; a <= update.last_a; ++a) {
    const auto from = a * grid.columns + update.first_b;
    std::copy_n(grid.points.begin() + from, width, mesh.positions.begin() + from);
    std::copy_n(grid.normals.begin() + from, width, mesh.normals.begin() + from);
  }
}

enum class Drag { all, influenced };

// One frame: a control point in the middle moves, the surface of 128 x 128 vertices and its mesh follow.
void drag(benchmark::State& state, Drag what) {
  auto surface = surface_of(20);
  const auto u = evenly(surface.knots[0].back(), 128), v = evenly(surface.knots[1].back(), 128);
  SurfaceGrid grid;
  evaluate_grid(surface, u, v, true, grid);
  Mesh mesh;
  convert(grid, mesh);
  double turn = 0.001;
  for (auto _ : state) {
    surface.at(9, 10).z += turn = -turn;
    if (what == Drag::all) {
      evaluate_grid(surface, u, v, true, grid);
      convert(grid, mesh);
    } else {
      convert(grid, update_grid(surface, grid, 9, 10), mesh);
    }
    benchmark::DoNotOptimize(mesh.positions.data());
    benchmark::ClobberMemory();
  }
}

void light(benchmark::State& state, bool reflection) {
  const auto surface = surface_of(20);
  const auto u = evenly(surface.knots[0].back(), 256), v = evenly(surface.knots[1].back(), 256);
  SurfaceGrid grid;
  evaluate_grid(surface, u, v, true, grid);
  const auto lines = lines_above({0, 0, -1}, {20, 20, 1});
  VertexValues made;
  for (auto _ : state) {
    if (reflection) {
      reflection_lines(grid.points, grid.normals, {{0, -30, 20}}, lines, false, made);
    } else {
      isophotes(grid.normals, {1, 1, 3}, made);
    }
    benchmark::DoNotOptimize(made.values.data());
    benchmark::ClobberMemory();
  }
  per_vertex(state, 256 * 256);
}

Curve<double> curve_of(int points, int p) {
  std::mt19937 random(1);
  Curve<double> curve;
  curve.degree = p;
  curve.dimension = 3;
  curve.rational = true;
  curve.knots = clamped_knots(points, p, random);
  for (int i = 0; i < points; ++i) curve.points.push_back(control_point(i, i % 3, random));
  return curve;
}

void curve_frames(benchmark::State& state, bool rotation_minimising) {
  const auto curve = curve_of(10, 3);
  const auto u = evenly(curve.domain_end(), 500);
  std::vector<std::optional<FrenetFrame>> frames;
  std::vector<std::optional<MovingFrame>> moving;
  for (auto _ : state) {
    if (rotation_minimising) {
      rotation_minimising_frames(curve, u, moving);
    } else {
      sample_frames(curve, u, frames);
    }
    benchmark::DoNotOptimize(frames.data());
    benchmark::DoNotOptimize(moving.data());
    benchmark::ClobberMemory();
  }
  per_vertex(state, 500);
}

void hull_of(benchmark::State& state, int count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<Point<double>> points;
  for (int i = 0; i < count; ++i) {
    const double x = uniform(random), y = uniform(random);
    points.emplace_back(x, y, uniform(random));
  }
  for (auto _ : state) {
    auto hull = convex_hull(points);
    benchmark::DoNotOptimize(hull.triangles.data());
  }
}

const int registered = [] {
  using benchmark::RegisterBenchmark;
  RegisterBenchmark("bicubic_nurbs_curvature_grid/256x256", curvature_grid);
  RegisterBenchmark("drag_point_of_20x20/128x128/whole_surface", drag, Drag::all);
  RegisterBenchmark("drag_point_of_20x20/128x128/influenced_part", drag, Drag::influenced);
  RegisterBenchmark("isophotes/256x256", light, false);
  RegisterBenchmark("reflection_lines/256x256", light, true);
  RegisterBenchmark("curve_frames/500", curve_frames, false);
  RegisterBenchmark("rotation_minimising_frames/500", curve_frames, true);
  RegisterBenchmark("convex_hull/4", hull_of, 4);
  RegisterBenchmark("convex_hull/26", hull_of, 26);
  return 0;
}();

}  // namespace
