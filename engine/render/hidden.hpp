#pragma once
// What hides what, for canvases that write files and have no depth buffer of their own: triangles are painted from back
// to front, and cells of one pixel each that remember the nearest triangle decide which parts of lines, and which
// markers, are hidden behind them.

#include <array>
#include <span>
#include <vector>

#include "render/canvas.hpp"

namespace blossom {

struct FlatTriangle {
  std::array<PixelPoint, 3> corners;
  Color color;  // opaque
};

class DepthCells {
 public:
  void begin_view(const PixelRect& clip, bool depth);  // empty cells; none without depth

  bool hidden(const PixelPoint&) const;
  bool hidden_polygon(std::span<const PixelPoint>) const;  // by its centre

  // What is to be painted of these triangles, in this order, each in the mean of its colours: without depth as they
  // are; with depth from back to front, without those that stand behind earlier ones.
  std::vector<FlatTriangle> in_order(std::span<const PixelPoint>, std::span<const Color>,
                                     std::span<const std::uint32_t> indices) const;
  void add(std::span<const PixelPoint>, std::span<const std::uint32_t> indices);  // from now on they hide

  // Calls paint(points, closed, stroke) for every part of the line that is seen. With depth, dashes are pieces by
  // themselves, for a part must not begin its dashes anew.
  template <class Paint>
  void visible_parts(std::span<const PixelPoint> points, bool closed, const Stroke& stroke, Paint&& paint) const {
    if (points.size() < 2) return;
    if (!depth_) return paint(points, closed, stroke);
    Stroke solid = stroke;
    solid.dash = solid.gap = 0;
    for (const auto& part : seen(points, closed, stroke)) paint(std::span<const PixelPoint>(part), false, solid);
  }

 private:
  std::vector<std::vector<PixelPoint>> seen(std::span<const PixelPoint>, bool closed, const Stroke&) const;
  void add_seen(std::span<const PixelPoint>, std::vector<std::vector<PixelPoint>>& parts) const;
  void fill(const PixelPoint&, const PixelPoint&, const PixelPoint&);

  bool depth_ = false;
  int left_ = 0, top_ = 0, columns_ = 0, rows_ = 0;
  std::vector<float> nearest_;
};

}  // namespace blossom
