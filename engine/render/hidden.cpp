#include "render/hidden.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/dash.hpp"

namespace blossom {

void DepthCells::begin_view(const PixelRect& clip, bool depth) {
  depth_ = depth;
  if (!depth) return;
  left_ = static_cast<int>(std::floor(clip.x));
  top_ = static_cast<int>(std::floor(clip.y));
  columns_ = std::max(1, static_cast<int>(std::ceil(clip.right())) - left_);
  rows_ = std::max(1, static_cast<int>(std::ceil(clip.bottom())) - top_);
  nearest_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 2.0f);
}

bool DepthCells::hidden(const PixelPoint& p) const {
  const float column = std::floor(p.x) - static_cast<float>(left_), row = std::floor(p.y) - static_cast<float>(top_);
  if (!depth_ || column < 0 || row < 0 || column >= static_cast<float>(columns_) || row >= static_cast<float>(rows_)) {
    return false;
  }
  return p.depth > nearest_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                            static_cast<std::size_t>(column)];
}

bool DepthCells::hidden_polygon(std::span<const PixelPoint> points) const {
  PixelPoint centre;
  for (const auto& p : points) {
    const auto n = static_cast<float>(points.size());
    centre = {centre.x + p.x / n, centre.y + p.y / n, centre.depth + p.depth / n};
  }
  return hidden(centre);
}

void DepthCells::fill(const PixelPoint& a, const PixelPoint& b, const PixelPoint& c) {
  const double area = (double{b.x} - a.x) * (double{c.y} - a.y) - (double{b.y} - a.y) * (double{c.x} - a.x);
  if (area == 0) return;
  const auto range = [](float low, float high, int origin, int limit) {
    return std::pair{std::max(0, static_cast<int>(std::floor(low)) - origin),
                     std::min(limit - 1, static_cast<int>(std::ceil(high)) - origin)};
  };
  const auto [x0, x1] = range(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), left_, columns_);
  const auto [y0, y1] = range(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), top_, rows_);
  for (int row = y0; row <= y1; ++row) {
    for (int column = x0; column <= x1; ++column) {
      const double x = left_ + column + 0.5, y = top_ + row + 0.5;
      const double wb = ((x - a.x) * (double{c.y} - a.y) - (y - a.y) * (double{c.x} - a.x)) / area;
      const double wc = ((double{b.x} - a.x) * (y - a.y) - (double{b.y} - a.y) * (x - a.x)) / area;
      if (wb < 0 || wc < 0 || wb + wc > 1) continue;
      auto& cell = nearest_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                            static_cast<std::size_t>(column)];
      cell = std::min(cell, static_cast<float>(a.depth + wb * (b.depth - a.depth) + wc * (c.depth - a.depth)));
    }
  }
}

void DepthCells::add(std::span<const PixelPoint> points, std::span<const std::uint32_t> indices) {
  if (!depth_) return;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    fill(points[indices[i]], points[indices[i + 1]], points[indices[i + 2]]);
}

std::vector<FlatTriangle> DepthCells::in_order(std::span<const PixelPoint> points, std::span<const Color> colors,
                                               std::span<const std::uint32_t> indices) const {
  const auto corner = [&](std::size_t triangle, std::size_t k) -> const PixelPoint& {
    return points[indices[3 * triangle + k]];
  };
  const auto mean_depth = [&](std::size_t t) {
    return (corner(t, 0).depth + corner(t, 1).depth + corner(t, 2).depth) / 3;
  };
  std::vector<std::size_t> order(indices.size() / 3);
  std::iota(order.begin(), order.end(), 0);
  if (depth_) {
    std::erase_if(order, [&](std::size_t t) {
      const auto &a = corner(t, 0), &b = corner(t, 1), &c = corner(t, 2);
      return hidden({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, mean_depth(t)});
    });
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return mean_depth(a) > mean_depth(b); });
  }
  std::vector<FlatTriangle> triangles;
  triangles.reserve(order.size());
  for (const std::size_t t : order) {
    int r = 0, g = 0, b = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Color c = colors[indices[3 * t + k]];
      r += c.r, g += c.g, b += c.b;
    }
    const auto third = [](int sum) { return static_cast<std::uint8_t>((sum + 1) / 3); };
    triangles.push_back({{corner(t, 0), corner(t, 1), corner(t, 2)}, {third(r), third(g), third(b)}});
  }
  return triangles;
}

std::vector<std::vector<PixelPoint>> DepthCells::seen(std::span<const PixelPoint> points, bool closed,
                                                      const Stroke& stroke) const {
  std::vector<std::vector<PixelPoint>> parts;
  if (stroke.gap > 0) {
    for (const auto& piece : split_dashes(points, closed, stroke.dash, stroke.gap)) add_seen(piece, parts);
    return parts;
  }
  std::vector<PixelPoint> line(points.begin(), points.end());
  if (closed) line.push_back(line.front());
  add_seen(line, parts);
  return parts;
}

void DepthCells::add_seen(std::span<const PixelPoint> points, std::vector<std::vector<PixelPoint>>& parts) const {
  std::vector<PixelPoint> part;
  const auto flush = [&] {
    if (part.size() > 1) parts.push_back(part);
    part.clear();
  };
  if (points.size() == 1 && !hidden(points[0])) part = {points[0], points[0]};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const PixelPoint a = points[i], b = points[i + 1];
    const int steps = std::max(1, static_cast<int>(std::ceil(std::hypot(b.x - a.x, b.y - a.y))));
    for (int k = i == 0 ? 0 : 1; k <= steps; ++k) {
      const float t = static_cast<float>(k) / static_cast<float>(steps);
      const PixelPoint p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.depth + t * (b.depth - a.depth)};
      if (hidden(p)) {
        flush();
        continue;
      }
      // Of a straight visible stretch only the ends are kept: an inner step replaces the one before it.
      if (k >= 2 && part.size() >= 2) {
        part.back() = p;
      } else {
        part.push_back(p);
      }
    }
  }
  flush();
}

}  // namespace blossom
