// SISL: s1221 and s1227 (a point of a curve, from the right and from the left), s1421 and s1424 (of a surface), s1506
// (a grid), s1017 and s1018 (insertion), s1750 (elevation), s1538 (skinning). Its normals are not of length 1; that is
// done here.

#include <sisl.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "comparison.hpp"

namespace {

using peers::CurveRow;
using peers::work;

constexpr int polynomial = 1, rational = 2, copy = 1, dimension = 3;

using CurvePointer = std::shared_ptr<SISLCurve>;
using SurfacePointer = std::shared_ptr<SISLSurf>;
using OwnedCurve = std::unique_ptr<SISLCurve, decltype(&freeCurve)>;

CurvePointer sisl_curve(const peers::Curve<double>& curve) {
  auto knots = curve.knots;
  std::vector<double> points;
  for (const auto& P : curve.points) {
    points.insert(points.end(), {P.x, P.y, P.z});
    if (curve.rational) points.push_back(P.w);
  }
  return {newCurve(static_cast<int>(curve.points.size()), curve.degree + 1, knots.data(), points.data(),
                   curve.rational ? rational : polynomial, dimension, copy),
          freeCurve};
}

// Its first direction runs fastest.
SurfacePointer sisl_surface(const peers::Surface<double>& surface) {
  auto knots = surface.knots;
  std::vector<double> points;
  for (int j = 0; j < surface.columns; ++j) {
    for (int i = 0; i < surface.rows; ++i) {
      const auto& P = surface.at(i, j);
      points.insert(points.end(), {P.x, P.y, P.z, P.w});
    }
  }
  return {newSurf(surface.rows, surface.columns, surface.degree[0] + 1, surface.degree[1] + 1, knots[0].data(),
                  knots[1].data(), points.data(), rational, dimension, copy),
          freeSurf};
}

template <std::size_t N, class Evaluate>
void add_curve(const CurveRow& row, const char* who, Evaluate evaluate) {
  peers::add_jobs<N>(row.name, who,
                     [&u = row.u, curve = sisl_curve(row.curve), span = 0, evaluate](
                         std::size_t i, std::array<double, N>& out) mutable {
                       int status;
                       evaluate(curve.get(), static_cast<int>(N) / dimension - 1, u[i], &span, out.data(), &status);
                     });
}

void add_curves() {
  for (const CurveRow& row : work().points) {
    add_curve<3>(row, "SISL s1221", s1221);
    add_curve<3>(row, "SISL s1227", s1227);
  }
  add_curve<3>(work().bezier, "SISL s1221", s1221);
  add_curve<3>(work().bezier, "SISL s1227", s1227);
  add_curve<9>(work().derivatives, "SISL s1221", s1221);
  add_curve<9>(work().derivatives, "SISL s1227", s1227);
}

void normalize(double* n) {
  const double scale = 1 / std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  for (int c = 0; c < dimension; ++c) n[c] *= scale;
}

struct Places {
  int u = 0, v = 0;
};

// The points of a grid and, if asked for, the normals; the first direction runs fastest.
struct Grid {
  std::vector<double> values, normals;
  int numbers_per_vertex = 0;
};

std::vector<double> numbers(const Grid* grid) {
  std::vector<double> all;
  for (int i = 0; i < peers::grid_side; ++i) {
    for (int j = 0; j < peers::grid_side; ++j) {
      const std::ptrdiff_t vertex = j * peers::grid_side + i;
      const auto point = grid->values.begin() + vertex * grid->numbers_per_vertex;
      all.insert(all.end(), point, point + dimension);
      if (grid->normals.empty()) continue;
      const auto normal = grid->normals.begin() + vertex * dimension;
      all.insert(all.end(), normal, normal + dimension);
    }
  }
  return all;
}

void add_surfaces() {
  const auto surface = sisl_surface(work().surface);
  const auto& u = work().u;
  const auto& v = work().v;
  peers::add_jobs<3>(peers::surface_point_row, "SISL s1421",
                     [&u, &v, surface, at = Places()](std::size_t i, auto& out) mutable {
                       double parameter[2] = {u[i], v[i]}, normal[3];
                       int status;
                       s1421(surface.get(), 0, parameter, &at.u, &at.v, out.data(), normal, &status);
                     });
  peers::add_jobs<3>(peers::surface_point_row, "SISL s1424",
                     [&u, &v, surface, at = Places()](std::size_t i, auto& out) mutable {
                       double parameter[2] = {u[i], v[i]};
                       int status;
                       s1424(surface.get(), 0, 0, parameter, &at.u, &at.v, out.data(), &status);
                     });
  peers::add_jobs<6>(peers::surface_normal_row, "SISL s1421",
                     [&u, &v, surface, at = Places()](std::size_t i, auto& out) mutable {
                       double parameter[2] = {u[i], v[i]}, derivatives[9];
                       int status;
                       s1421(surface.get(), 1, parameter, &at.u, &at.v, derivatives, out.data() + 3, &status);
                       std::copy_n(derivatives, 3, out.data());
                       normalize(out.data() + 3);
                     });

  for (const int order : {0, 1}) {
    const auto grid = std::make_shared<Grid>();
    grid->numbers_per_vertex = dimension * (order + 1) * (order + 2) / 2;
    grid->values.resize(static_cast<std::size_t>(peers::grid_vertices * grid->numbers_per_vertex));
    if (order > 0) grid->normals.resize(peers::grid_vertices * dimension);
    const auto fill = [surface, grid, order, at = work().grid]() mutable {
      int status;
      s1506(surface.get(), order, peers::grid_side, at[0].data(), peers::grid_side, at[1].data(), grid->values.data(),
            grid->normals.data(), &status);
      for (std::size_t i = 0; i < grid->normals.size(); i += dimension) normalize(grid->normals.data() + i);
      return static_cast<const Grid*>(grid.get());
    };
    peers::add_whole(order > 0 ? peers::grid_normal_row : peers::grid_row, "SISL s1506", peers::grid_vertices, fill,
                     numbers);
  }
}

std::vector<double> read_curve(const OwnedCurve& curve) {
  std::vector<double> all(curve->ecoef, curve->ecoef + curve->in * dimension);
  all.insert(all.end(), curve->et, curve->et + curve->in + curve->ik);
  return all;
}

struct Skin {
  std::unique_ptr<SISLSurf, decltype(&freeSurf)> surface;
  std::unique_ptr<double[], decltype(&std::free)> parameters;  // of the profiles, across
};

void add_algorithms() {
  const auto curve = sisl_curve(work().curve);
  peers::add_whole(
      peers::insertion_row, "SISL s1017", 1,
      [curve] {
        SISLCurve* made = nullptr;
        int status;
        s1017(curve.get(), &made, work().knot, &status);
        return OwnedCurve(made, freeCurve);
      },
      read_curve);
  peers::add_whole(
      peers::insertion_row, "SISL s1018", 1,
      [curve] {
        SISLCurve* made = nullptr;
        double knot = work().knot;
        int status;
        s1018(curve.get(), &knot, 1, &made, &status);
        return OwnedCurve(made, freeCurve);
      },
      read_curve);
  peers::add_whole(
      peers::elevation_row, "SISL s1750", 1,
      [curve] {
        SISLCurve* made = nullptr;
        int status;
        s1750(curve.get(), curve->ik + 1, &made, &status);
        return OwnedCurve(made, freeCurve);
      },
      read_curve);

  std::vector<CurvePointer> profiles;
  for (const auto& profile : work().profiles) profiles.push_back(sisl_curve(profile));
  peers::add_whole(
      peers::skinning_row, "SISL s1538", 1,
      [profiles] {
        std::vector<SISLCurve*> curves;
        for (const auto& profile : profiles) curves.push_back(profile.get());
        std::vector<int> ordinary(curves.size(), 1);
        constexpr int open = 1, order = 4;
        SISLSurf* surface = nullptr;
        double* parameters = nullptr;
        int status;
        s1538(static_cast<int>(curves.size()), curves.data(), ordinary.data(), 0.0, open, order, 0, &surface,
              &parameters, &status);
        return Skin{{surface, freeSurf}, {parameters, std::free}};
      },
      [](const Skin& skin) {
        std::vector<double> all;
        Places at;
        for (std::size_t l = 0; l < work().profiles.size(); ++l) {
          for (const double u : peers::skinning_parameters()) {
            double parameter[2] = {u, skin.parameters[l]}, point[3], normal[3];
            int status;
            s1421(skin.surface.get(), 0, parameter, &at.u, &at.v, point, normal, &status);
            all.insert(all.end(), point, point + dimension);
          }
        }
        return all;
      });
}

[[maybe_unused]] const bool added = (add_curves(), add_surfaces(), add_algorithms(), true);

}  // namespace
