#pragma once
// The convex hull of a few points: in space triangles, in a plane a polygon, on a line a segment. For the control
// points in force at u (at most max_degree + 1), whose hull contains C(u) when their weights are positive.
//
// The points are first put on a grid of 2^40 steps over their extent, a millionth of a millionth of it; there
// orientations are integers, computed without rounding, so that no arrangement of points leads to a hull that is not
// closed or not convex. In space the hull grows point by point (O'Rourke, Computational Geometry in C, section 4.3):
// the triangles that a point sees strictly are replaced by those of the point with the edges of their rim. A triangle
// whose plane the point lies in stays; no new triangle is degenerate, as a point in line with an edge of the rim would
// not see the triangle inside of it. In a plane: Andrew's monotone chain (1979). O(n^2) and O(n log n).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "geometry/geometry.hpp"

namespace blossom {

// Everything is indices into the points. Of points that coincide one is taken; points inside of the hull, of its edges
// or of its faces need not occur.
struct Hull {
  // All points coincide: 1 index; all on a line: the 2 ends; in a plane: the corners in order, counterclockwise where
  // the plane is parallel to the xy-plane; in space: none.
  std::vector<int> polygon;
  std::vector<std::array<int, 3>> triangles;  // in space: counterclockwise from outside; some may be slivers
};

namespace detail {

struct GridPoint {
  std::int64_t x = 0, y = 0, z = 0;
  auto operator<=>(const GridPoint&) const = default;
};

// Twice the area of abc in the xy-plane, positive when counterclockwise; six times the volume of abcd, positive when d
// sees abc counterclockwise. Differences have 41 bits: 126 are enough for both.
__extension__ using Wide = __int128;
inline Wide turn(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  return Wide(b.x - a.x) * (c.y - a.y) - Wide(b.y - a.y) * (c.x - a.x);
}
inline Wide volume(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  const Wide bx = b.x - a.x, by = b.y - a.y, bz = b.z - a.z;
  const Wide cx = c.x - a.x, cy = c.y - a.y, cz = c.z - a.z;
  const Wide dx = d.x - a.x, dy = d.y - a.y, dz = d.z - a.z;
  return dx * (by * cz - bz * cy) + dy * (bz * cx - bx * cz) + dz * (bx * cy - by * cx);
}

// Coordinates in [-1, 1] on the grid.
inline GridPoint on_grid(const Point<double>& P) {
  constexpr double steps = 1LL << 39;
  return {std::llround(P.x * steps), std::llround(P.y * steps), std::llround(P.z * steps)};
}

// The corners of the hull of points in the xy-plane, not all in a line, counterclockwise from the leftmost one.
inline void chain_around(const std::vector<GridPoint>& points, std::vector<int>& polygon) {
  std::vector<int> order(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  std::ranges::sort(order, {}, [&](int i) { return points[i]; });
  polygon.clear();
  for (int side = 0; side < 2; ++side) {  // the lower chain, and back the upper one
    const std::size_t begin = polygon.size();
    for (const int i : order) {
      while (polygon.size() >= begin + 2 && turn(points[polygon.end()[-2]], points[polygon.back()], points[i]) <= 0) {
        polygon.pop_back();
      }
      polygon.push_back(i);
    }
    polygon.pop_back();  // it begins the other chain
    std::ranges::reverse(order);
  }
}

// `simplex`: four points that span a volume.
inline void grow_around(const std::vector<GridPoint>& points, std::array<int, 4> simplex,
                        std::vector<std::array<int, 3>>& triangles) {
  auto [a, b, c, d] = simplex;
  if (volume(points[a], points[b], points[c], points[d]) > 0) std::swap(b, c);
  triangles = {{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};

  const auto count = static_cast<int>(points.size());
  std::vector<std::array<int, 3>> seen;
  for (int i = 0; i < count; ++i) {
    const auto sees = [&](const std::array<int, 3>& t) {
      return volume(points[t[0]], points[t[1]], points[t[2]], points[i]) > 0;
    };
    seen.clear();
    std::erase_if(triangles, [&](const auto& t) {
      if (!sees(t)) return false;
      seen.push_back(t);
      return true;
    });
    // An edge of the rim belongs to one triangle that is seen; all others to two, in opposite directions.
    const auto inner = [&](int from, int to) {
      return std::ranges::any_of(seen, [&](const auto& t) {
        return (t[0] == from && t[1] == to) || (t[1] == from && t[2] == to) || (t[2] == from && t[0] == to);
      });
    };
    for (const auto& t : seen) {
      for (int side = 0; side < 3; ++side) {
        const int from = t[side], to = t[(side + 1) % 3];
        if (!inner(to, from)) triangles.push_back({from, to, i});
      }
    }
  }
}

// The index of the point where `size` is largest.
template <class Size>
int farthest(std::span<const Point<double>> points, Size&& size) {
  return static_cast<int>(std::ranges::max_element(points, {}, size) - points.begin());
}

}  // namespace detail

// Any number of points, their coordinates finite; an empty hull of none. What is thinner than a thousand-millionth of
// the extent counts as flat, or straight.
inline Hull convex_hull(std::span<const Point<double>> given) {
  constexpr double flat = 1e-9;
  Hull hull;
  if (given.empty()) return hull;

  // Moved and scaled into [-1, 1]; halves first, as the difference of two doubles may overflow.
  Point<double> low = given[0], high = given[0];
  for (const auto& P : given) low = glm::min(low, P), high = glm::max(high, P);
  const Point<double> middle = low * 0.5 + high * 0.5;
  const Point<double> half = high * 0.5 - low * 0.5;
  const double extent = std::max({half.x, half.y, half.z});
  if (!(extent > 0)) {
    hull.polygon = {0};
    return hull;
  }
  std::vector<Point<double>> points;
  for (const auto& P : given) points.push_back((P - middle) / extent);

  // Four points that are as far as can be from point, line and plane of those before them.
  const int a = detail::farthest(points, [&](const auto& P) { return glm::length(P); });
  const int b = detail::farthest(points, [&](const auto& P) { return glm::length(P - points[a]); });
  const Point<double> along = glm::normalize(points[b] - points[a]);
  const auto from_line = [&](const auto& P) { return glm::length(glm::cross(P - points[a], along)); };
  const int c = detail::farthest(points, from_line);
  if (from_line(points[c]) <= flat) {
    hull.polygon = {std::min(a, b), std::max(a, b)};
    return hull;
  }
  Point<double> across = glm::normalize(glm::cross(along, points[c] - points[a]));
  const auto from_plane = [&](const auto& P) { return std::abs(glm::dot(P - points[a], across)); };
  const int d = detail::farthest(points, from_plane);

  std::vector<detail::GridPoint> grid;
  if (from_plane(points[d]) <= flat) {
    if (across.z < 0) across = -across;
    const Point<double> upwards = glm::cross(across, along);
    // Half as large, for the diagonal is longer than the sides.
    for (const auto& P : points) {
      grid.push_back(detail::on_grid(Point<double>(glm::dot(P, along), glm::dot(P, upwards), 0) * 0.5));
    }
    detail::chain_around(grid, hull.polygon);
  } else {
    for (const auto& P : points) grid.push_back(detail::on_grid(P));
    detail::grow_around(grid, {a, b, c, d}, hull.triangles);
  }
  return hull;
}

}  // namespace blossom
