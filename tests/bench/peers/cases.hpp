#pragma once
// The work of every row: the same curves, surfaces and parameters for all.

#include <algorithm>
#include <array>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "geometry/geometry.hpp"

namespace peers {

using blossom::Curve;
using blossom::HPoint;
using blossom::Surface;

inline constexpr std::size_t parameter_count = 4096;  // a power of two: the next one is a mask away
inline constexpr int grid_side = 256;
inline constexpr int grid_vertices = grid_side * grid_side;

inline constexpr const char* surface_point_row = "bicubic_nurbs_point/20x20";
inline constexpr const char* surface_normal_row = "bicubic_nurbs_point_and_unit_normal/20x20";
inline constexpr const char* grid_row = "bicubic_nurbs_grid/256x256/per_vertex";
inline constexpr const char* grid_normal_row = "bicubic_nurbs_grid_with_unit_normals/256x256/per_vertex";
inline constexpr const char* insertion_row = "insert_one_knot/cubic/100";
inline constexpr const char* elevation_row = "elevate_degree/cubic/100";
inline constexpr const char* skinning_row = "skin_profiles/20x30";

// Points (or derivatives) of one curve.
struct CurveRow {
  std::string name;
  Curve<double> curve;
  std::vector<double> u;  // parameter_count of them
};

struct Work {
  std::vector<CurveRow> points;  // C(u)
  CurveRow derivatives;          // C(u), C'(u), C''(u)
  CurveRow bezier;               // C(u), of degree 10
  Surface<double> surface;       // S(u_i, v_i), and with the unit normal
  std::vector<double> u, v;
  std::array<std::vector<double>, 2> grid;  // the parameters of a grid, in both directions
  Curve<double> curve;                      // of 100 points, for one knot more and for one degree more
  double knot = 0;
  std::vector<Curve<double>> profiles;  // over one knot vector, for one bicubic surface through all
};

// Clamped, with unequal spans: a uniform knot vector would flatter any search.
inline std::vector<double> clamped_knots(int points, int p, std::mt19937& random) {
  std::uniform_real_distribution<double> step(0.5, 1.5);
  std::vector<double> U(static_cast<std::size_t>(p) + 1, 0.0);
  for (int i = p + 1; i <= points; ++i) U.push_back(U.back() + step(random));
  U.insert(U.end(), static_cast<std::size_t>(p), U.back());
  return U;
}

inline HPoint<double> control_point(double x, double y, bool rational, std::mt19937& random) {
  std::uniform_real_distribution<double> height(-1, 1);
  std::uniform_real_distribution<double> weight(0.5, 2);
  const double w = rational ? weight(random) : 1;
  return {w * x, w * y, w * height(random), w};
}

inline Curve<double> curve_of(int points, int p, bool rational) {
  std::mt19937 random(1);
  Curve<double> curve;
  curve.degree = p;
  curve.dimension = 3;
  curve.rational = rational;
  curve.knots = points == p + 1 ? blossom::bezier_knots<double>(p) : clamped_knots(points, p, random);
  for (int i = 0; i < points; ++i) curve.points.push_back(control_point(i, i % 3, rational, random));
  return curve;
}

inline std::vector<double> parameters(const std::vector<double>& knots, bool in_sequence, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(knots.front(), knots.back());
  std::vector<double> u(parameter_count);
  for (double& value : u) value = uniform(random);
  if (in_sequence) std::sort(u.begin(), u.end());
  return u;
}

inline const Work& work() {
  static const Work all = [] {
    Work made;
    for (const bool rational : {false, true}) {
      for (const int points : {10, 1000}) {
        for (const bool in_sequence : {false, true}) {
          const std::string name = std::string(rational ? "cubic_nurbs_point/" : "cubic_bspline_point/") +
                                   std::to_string(points) + (in_sequence ? "/in_sequence" : "/random");
          const auto curve = curve_of(points, 3, rational);
          made.points.push_back({name, curve, parameters(curve.knots, in_sequence, 3)});
        }
      }
    }
    const auto nurbs = curve_of(10, 3, true);
    made.derivatives = {"cubic_nurbs_two_derivatives/10/random", nurbs, parameters(nurbs.knots, false, 3)};
    const auto bezier = curve_of(11, 10, false);
    made.bezier = {"bezier_point/degree_10", bezier, parameters(bezier.knots, false, 3)};

    constexpr int side = 20;
    std::mt19937 random(2);
    auto& surface = made.surface;
    surface.degree = {3, 3};
    surface.knots = {clamped_knots(side, 3, random), clamped_knots(side, 3, random)};
    surface.rows = surface.columns = side;
    surface.rational = true;
    for (int i = 0; i < side; ++i) {
      for (int j = 0; j < side; ++j) surface.points.push_back(control_point(i, j, true, random));
    }
    made.u = parameters(surface.knots[0], false, 3);
    made.v = parameters(surface.knots[1], false, 4);
    for (const std::size_t direction : {0u, 1u}) {
      const double end = surface.knots[direction].back();
      for (int i = 0; i < grid_side; ++i) made.grid[direction].push_back(end * i / (grid_side - 1));
    }

    made.curve = curve_of(100, 3, false);
    made.knot = 43.21;

    const auto knots = clamped_knots(30, 3, random);
    for (int l = 0; l < 20; ++l) {
      Curve<double> profile;
      profile.degree = 3;
      profile.dimension = 3;
      profile.knots = knots;
      for (int i = 0; i < 30; ++i) profile.points.push_back(control_point(i, 10 * l, false, random));
      made.profiles.push_back(profile);
    }
    return made;
  }();
  return all;
}

// Where a skinned surface is read to be compared: at these u on every profile.
inline std::vector<double> skinning_parameters() {
  constexpr int count = 50;
  std::vector<double> u;
  const double end = work().profiles[0].knots.back();
  for (int i = 0; i <= count; ++i) u.push_back(end * i / count);
  return u;
}

// A curve as numbers: its affine control points, then its knots.
inline std::vector<double> numbers(const Curve<double>& curve) {
  std::vector<double> all;
  for (const auto& P : curve.points) all.insert(all.end(), {P.x / P.w, P.y / P.w, P.z / P.w});
  all.insert(all.end(), curve.knots.begin(), curve.knots.end());
  return all;
}

}  // namespace peers
