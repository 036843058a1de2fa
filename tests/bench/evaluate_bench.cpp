// Evaluation and tessellation: nanoseconds per point. Every benchmark is one point (or, for grids, reports the time per
// vertex as `per_vertex`), at parameters drawn beforehand, random or in sequence. `plain` functions compute everything
// afresh; evaluators keep what depends on the knots only.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>
#include <vector>

#include "kernel/derivatives.hpp"
#include "kernel/evaluate.hpp"
#include "kernel/evaluator.hpp"
#include "kernel/tessellate.hpp"

namespace {

using namespace blossom;

enum class Order { random, sequential };

constexpr std::size_t parameter_count = 4096;  // a power of two: the next one is a mask away

std::vector<double> parameters(double begin, double end, Order order, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(begin, end);
  std::vector<double> u(parameter_count);
  for (double& value : u) value = uniform(random);
  if (order == Order::sequential) std::sort(u.begin(), u.end());
  return u;
}

// Clamped, with unequal spans: a uniform knot vector would flatter any search.
std::vector<double> clamped_knots(int points, int p, std::mt19937& random) {
  std::uniform_real_distribution<double> step(0.5, 1.5);
  std::vector<double> U(static_cast<std::size_t>(p) + 1, 0.0);
  for (int i = p + 1; i <= points; ++i) U.push_back(U.back() + step(random));
  U.insert(U.end(), static_cast<std::size_t>(p), U.back());
  return U;
}

HPoint<double> control_point(double x, double y, bool rational, std::mt19937& random) {
  std::uniform_real_distribution<double> height(-1, 1);
  std::uniform_real_distribution<double> weight(0.5, 2);
  const double w = rational ? weight(random) : 1;
  return {w * x, w * y, w * height(random), w};
}

Curve<double> curve_of(int points, int p, bool rational) {
  std::mt19937 random(1);
  Curve<double> curve;
  curve.degree = p;
  curve.dimension = 3;
  curve.rational = rational;
  curve.knots = clamped_knots(points, p, random);
  for (int i = 0; i < points; ++i) curve.points.push_back(control_point(i, i % 3, rational, random));
  return curve;
}

Surface<double> surface_of(int side, int p, bool rational) {
  std::mt19937 random(2);
  Surface<double> surface;
  surface.degree = {p, p};
  surface.knots = {clamped_knots(side, p, random), clamped_knots(side, p, random)};
  surface.rows = surface.columns = side;
  surface.rational = rational;
  for (int i = 0; i < side; ++i) {
    for (int j = 0; j < side; ++j) surface.points.push_back(control_point(i, j, rational, random));
  }
  return surface;
}

// Runs evaluate(u) for one parameter after the other.
template <class F>
void each_parameter(benchmark::State& state, const std::vector<double>& u, F&& evaluate) {
  std::size_t i = 0;
  for (auto _ : state) {
    auto result = evaluate(u[i]);
    benchmark::DoNotOptimize(result);
    i = (i + 1) & (parameter_count - 1);
  }
}

template <class F>
void each_pair(benchmark::State& state, const std::vector<double>& u, const std::vector<double>& v, F&& evaluate) {
  std::size_t i = 0;
  for (auto _ : state) {
    auto result = evaluate(u[i], v[i]);
    benchmark::DoNotOptimize(result);
    i = (i + 1) & (parameter_count - 1);
  }
}

void curve_point(benchmark::State& state, int points, int p, bool rational, Order order) {
  const Curve<double> curve = curve_of(points, p, rational);
  const auto u = parameters(curve.domain_begin(), curve.domain_end(), order, 3);
  each_parameter(state, u, [&](double x) { return point(curve, x); });
}

void curve_evaluator(benchmark::State& state, int points, int p, bool rational, Order order) {
  const Curve<double> curve = curve_of(points, p, rational);
  const CurveEvaluator evaluator(curve);
  const auto u = parameters(curve.domain_begin(), curve.domain_end(), order, 3);
  each_parameter(state, u, [&](double x) { return evaluator.point(x); });
}

void curve_two_derivatives(benchmark::State& state, bool with_evaluator) {
  const Curve<double> curve = curve_of(10, 3, true);
  const CurveEvaluator evaluator(curve);
  const auto u = parameters(curve.domain_begin(), curve.domain_end(), Order::random, 3);
  each_parameter(state, u, [&](double x) {
    std::array<Point<double>, 3> C;
    const bool exists = with_evaluator ? evaluator.derivatives(x, 2, C) : derivatives(curve, x, 2, C);
    benchmark::DoNotOptimize(exists);
    return C;
  });
}

void surface_point(benchmark::State& state, bool with_evaluator) {
  const Surface<double> surface = surface_of(20, 3, true);
  const SurfaceEvaluator evaluator(surface);
  const auto u = parameters(0, surface.knots[0].back(), Order::random, 3);
  const auto v = parameters(0, surface.knots[1].back(), Order::random, 4);
  if (with_evaluator) {
    each_pair(state, u, v, [&](double x, double y) { return evaluator.point(x, y); });
  } else {
    each_pair(state, u, v, [&](double x, double y) { return point(surface, x, y); });
  }
}

void surface_point_and_normal(benchmark::State& state) {
  const Surface<double> surface = surface_of(20, 3, true);
  const SurfaceEvaluator evaluator(surface);
  const auto u = parameters(0, surface.knots[0].back(), Order::random, 3);
  const auto v = parameters(0, surface.knots[1].back(), Order::random, 4);
  each_pair(state, u, v, [&](double x, double y) { return evaluator.point_and_normal(x, y); });
}

void grid_256(benchmark::State& state, bool with_normals) {
  constexpr int side = 256;
  const Surface<double> surface = surface_of(20, 3, true);
  std::array<std::vector<double>, 2> at;
  for (int direction : {0, 1}) {
    const double end = surface.knots[direction].back();
    for (int i = 0; i < side; ++i) at[direction].push_back(end * i / (side - 1));
  }
  SurfaceGrid grid;
  for (auto _ : state) {
    evaluate_grid(surface, at[0], at[1], with_normals, grid);
    benchmark::DoNotOptimize(grid.points.data());
    benchmark::DoNotOptimize(grid.normals.data());
    benchmark::ClobberMemory();
  }
  // "12.3n": seconds per vertex.
  state.counters["per_vertex"] =
      benchmark::Counter(side * side, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void curve_samples(benchmark::State& state) {
  const Curve<double> curve = curve_of(10, 3, false);
  CurveSamples samples;
  for (auto _ : state) {
    sample_curve(curve, 64, samples);
    benchmark::DoNotOptimize(samples.points.data());
    benchmark::ClobberMemory();
  }
  state.counters["per_point"] =
      benchmark::Counter(static_cast<double>(samples.points.size()),
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

const int registered = [] {
  using benchmark::RegisterBenchmark;
  struct Curves {
    const char* name;
    int points, degree;
    bool rational;
  };
  for (const auto& [name, points, degree, rational] :
       {Curves{"cubic_bspline_point/10", 10, 3, false}, Curves{"cubic_bspline_point/1000", 1000, 3, false},
        Curves{"cubic_nurbs_point/10", 10, 3, true}, Curves{"cubic_nurbs_point/1000", 1000, 3, true},
        Curves{"quintic_nurbs_point/10", 10, 5, true}}) {
    for (const Order order : {Order::random, Order::sequential}) {
      const std::string suffix = order == Order::random ? "/random" : "/sequential";
      RegisterBenchmark((name + suffix).c_str(), curve_point, points, degree, rational, order);
      RegisterBenchmark((name + suffix + "/evaluator").c_str(), curve_evaluator, points, degree, rational, order);
    }
  }
  RegisterBenchmark("cubic_nurbs_two_derivatives/10/random", curve_two_derivatives, false);
  RegisterBenchmark("cubic_nurbs_two_derivatives/10/random/evaluator", curve_two_derivatives, true);
  RegisterBenchmark("bicubic_nurbs_point/20x20/random", surface_point, false);
  RegisterBenchmark("bicubic_nurbs_point/20x20/random/evaluator", surface_point, true);
  RegisterBenchmark("bicubic_nurbs_point_and_normal/20x20/random/evaluator", surface_point_and_normal);
  RegisterBenchmark("bicubic_nurbs_grid/256x256", grid_256, false);
  RegisterBenchmark("bicubic_nurbs_grid_with_normals/256x256", grid_256, true);
  RegisterBenchmark("cubic_bspline_samples/10", curve_samples);
  return 0;
}();

}  // namespace
