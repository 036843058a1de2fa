#include "render/clip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace blossom {
namespace {

PagePoint between(const PagePoint& a, const PagePoint& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.depth + t * (b.depth - a.depth)};
}

// The parameters between which a..b is inside (Liang and Barsky, 1984).
std::optional<std::pair<double, double>> inside(const PagePoint& a, const PagePoint& b, const PixelRect& box) {
  double enter = 0, leave = 1;
  const auto cut = [&](double from, double along, double low, double high) {
    if (along == 0) return from >= low && from <= high;
    double first = (low - from) / along, last = (high - from) / along;
    if (first > last) std::swap(first, last);
    enter = std::max(enter, first);
    leave = std::min(leave, last);
    return enter <= leave;
  };
  if (!cut(a.x, b.x - a.x, box.x, box.right()) || !cut(a.y, b.y - a.y, box.y, box.bottom())) return std::nullopt;
  return std::pair{enter, leave};
}

}  // namespace

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  const double x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  return {x, y, std::max(0.0, std::min(a.right(), b.right()) - x), std::max(0.0, std::min(a.bottom(), b.bottom()) - y)};
}

std::vector<ClippedLine> clip_line(const Projection& project, const Polyline& line, double pull, const PixelRect& box) {
  std::vector<ClippedLine> pieces;
  const std::size_t n = line.points.size();
  if (n < 2) return pieces;
  std::vector<std::optional<PagePoint>> points;
  points.reserve(n);
  bool whole = true;
  for (const auto& p : line.points) {
    points.push_back(project(p, pull));
    whole = whole && points.back() && contains(box, points.back()->x, points.back()->y);
  }
  if (whole) {
    pieces.push_back({{}, line.closed && n > 2});
    for (const auto& p : points) pieces.back().points.push_back(*p);
    return pieces;
  }
  bool open = false;  // the last piece ends where the next segment starts
  for (std::size_t i = 0; i < n - (line.closed && n > 2 ? 0 : 1); ++i) {
    const auto &a = points[i], &b = points[(i + 1) % n];
    const auto part = a && b ? inside(*a, *b, box) : std::nullopt;
    if (!part) {
      open = false;
      continue;
    }
    const auto [enter, leave] = *part;
    if (!open || enter > 0) pieces.push_back({{between(*a, *b, enter)}, false});
    pieces.back().points.push_back(between(*a, *b, leave));
    open = leave == 1;
  }
  return pieces;
}

std::vector<PagePoint> clip_polygon(std::vector<PagePoint> polygon, const PixelRect& box) {
  // Signed distances to the four sides, positive inside.
  const auto distance = [&](const PagePoint& p, int side) {
    const std::array distances = {p.x - box.x, box.right() - p.x, p.y - box.y, box.bottom() - p.y};
    return distances[static_cast<std::size_t>(side)];
  };
  for (int side = 0; side < 4; ++side) {
    std::vector<PagePoint> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const PagePoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double da = distance(a, side), db = distance(b, side);
      if (da >= 0) kept.push_back(a);
      if ((da >= 0) != (db >= 0)) kept.push_back(between(a, b, da / (da - db)));
    }
    polygon = std::move(kept);
  }
  return polygon;
}

}  // namespace blossom
