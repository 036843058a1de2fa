// Blossom's own entries. "Blossom" is the function that computes everything afresh, or the algorithm run without
// recording; "evaluator" keeps what depends on the knots only.

#include <memory>

#include "comparison.hpp"
#include "kernel/de_casteljau.hpp"
#include "kernel/derivatives.hpp"
#include "kernel/evaluate.hpp"
#include "kernel/evaluator.hpp"
#include "kernel/skinning.hpp"
#include "kernel/tessellate.hpp"

namespace {

using namespace blossom;
using peers::add_jobs;
using peers::add_whole;
using peers::blossom_evaluator;
using peers::blossom_plain;
using peers::CurveRow;
using peers::work;

template <std::size_t N>
void store(const Point<double>& P, std::array<double, N>& out, std::size_t at = 0) {
  out[at] = P.x;
  out[at + 1] = P.y;
  out[at + 2] = P.z;
}

// One evaluator for the copies of a function that holds it.
template <class Evaluator, class Geometry>
auto shared(const Geometry& geometry) {
  return std::make_shared<const Evaluator>(geometry);
}

void add_evaluator_points(const CurveRow& row) {
  add_jobs<3>(
      row.name, blossom_evaluator,
      [&u = row.u, e = shared<CurveEvaluator>(row.curve)](std::size_t i, auto& out) { store(*e->point(u[i]), out); });
}

void add_curves() {
  for (const CurveRow& row : work().points) {
    add_jobs<3>(row.name, blossom_plain, [&row](std::size_t i, auto& out) { store(*point(row.curve, row.u[i]), out); });
    add_evaluator_points(row);
  }

  const CurveRow& bezier = work().bezier;
  add_jobs<3>(bezier.name, blossom_plain, [&bezier](std::size_t i, auto& out) {
    NoRecorder<double> none;
    const auto C = de_casteljau(bezier.curve, bezier.u[i], none);
    store(Point<double>(C.x, C.y, C.z), out);
  });
  add_evaluator_points(bezier);

  const CurveRow& row = work().derivatives;
  const auto derivatives_by = [](auto compute) {
    return [compute](std::size_t i, std::array<double, 9>& out) {
      std::array<Point<double>, 3> C;
      benchmark::DoNotOptimize(compute(i, C));
      for (std::size_t j = 0; j < 3; ++j) store(C[j], out, 3 * j);
    };
  };
  add_jobs<9>(row.name, blossom_plain,
              derivatives_by([&row](std::size_t i, auto& C) { return derivatives(row.curve, row.u[i], 2, C); }));
  add_jobs<9>(row.name, blossom_evaluator,
              derivatives_by([&row, e = shared<CurveEvaluator>(row.curve)](std::size_t i, auto& C) {
                return e->derivatives(row.u[i], 2, C);
              }));
}

void add_surfaces() {
  const auto& surface = work().surface;
  const auto& u = work().u;
  const auto& v = work().v;
  const auto evaluator = shared<SurfaceEvaluator>(surface);
  add_jobs<3>(peers::surface_point_row, blossom_plain,
              [&](std::size_t i, auto& out) { store(*point(surface, u[i], v[i]), out); });
  add_jobs<3>(peers::surface_point_row, blossom_evaluator,
              [&u, &v, evaluator](std::size_t i, auto& out) { store(*evaluator->point(u[i], v[i]), out); });
  const auto normals_by = [](auto compute) {
    return [compute](std::size_t i, std::array<double, 6>& out) {
      const auto found = compute(i);
      store(found->point, out);
      store(*found->normal, out, 3);
    };
  };
  add_jobs<6>(peers::surface_normal_row, blossom_plain,
              normals_by([&](std::size_t i) { return point_and_normal(surface, u[i], v[i]); }));
  add_jobs<6>(peers::surface_normal_row, blossom_evaluator,
              normals_by([&u, &v, evaluator](std::size_t i) { return evaluator->point_and_normal(u[i], v[i]); }));

  for (const bool with_normals : {false, true}) {
    const auto fill = [with_normals, grid = std::make_shared<SurfaceGrid>()] {
      evaluate_grid(work().surface, work().grid[0], work().grid[1], with_normals, *grid);
      return grid.get();
    };
    const auto read = [with_normals](const SurfaceGrid* grid) {
      std::vector<double> all;
      for (std::size_t vertex = 0; vertex < grid->points.size(); ++vertex) {
        const auto& P = grid->points[vertex];
        all.insert(all.end(), {P.x, P.y, P.z});
        if (!with_normals) continue;
        const auto& N = grid->normals[vertex];
        all.insert(all.end(), {N.x, N.y, N.z});
      }
      return all;
    };
    add_whole(with_normals ? peers::grid_normal_row : peers::grid_row, blossom_plain, peers::grid_vertices, fill, read);
  }
}

// The chord-length parameters of the profiles (The NURBS Book 10.8), for reading a skinned surface at them.
std::vector<double> chord_parameters(const std::vector<Curve<double>>& profiles) {
  const std::size_t K = profiles.size() - 1;
  const std::size_t columns = profiles[0].points.size();
  std::vector<double> v(K + 1, 0.0);
  for (std::size_t i = 0; i < columns; ++i) {
    std::vector<double> along(K + 1, 0.0);
    for (std::size_t l = 1; l <= K; ++l)
      along[l] = along[l - 1] + Distance::apply(profiles[l].points[i], profiles[l - 1].points[i]);
    for (std::size_t l = 1; l <= K; ++l) v[l] += along[l] / along[K] / static_cast<double>(columns);
  }
  v[K] = 1;
  return v;
}

void add_algorithms() {
  add_whole(
      peers::insertion_row, blossom_plain, 1,
      [] {
        NoRecorder<double> none;
        return knot_insertion(work().curve, work().knot, 1, none);
      },
      peers::numbers);
  add_whole(
      peers::elevation_row, blossom_plain, 1,
      [] {
        NoRecorder<double> none;
        return degree_elevation(work().curve, 1, none);
      },
      peers::numbers);
  add_whole(
      peers::skinning_row, blossom_plain, 1,
      [] {
        NoRecorder<double> none;
        return skinning(work().profiles, 3, Parametrization::chord, none);
      },
      [](const Surface<double>& surface) {
        std::vector<double> all;
        for (const double v : chord_parameters(work().profiles)) {
          for (const double u : peers::skinning_parameters()) {
            const auto P = *point(surface, u, v);
            all.insert(all.end(), {P.x, P.y, P.z});
          }
        }
        return all;
      });
}

[[maybe_unused]] const bool added = (add_curves(), add_surfaces(), add_algorithms(), true);

}  // namespace
