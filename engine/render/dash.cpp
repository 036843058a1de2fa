#include "render/dash.hpp"

#include <algorithm>
#include <cmath>

namespace blossom {

std::vector<std::vector<PixelPoint>> split_dashes(std::span<const PixelPoint> points, bool closed, float dash,
                                                  float gap) {
  std::vector<std::vector<PixelPoint>> pieces;
  if (points.size() < 2) return pieces;
  const double stretch = std::max(1.0, 1.0 / (double{dash} + gap));
  const double on = dash * stretch, off = gap * stretch;
  bool ink = true;
  double left = on;  // until ink and pause change
  pieces.push_back({points[0]});
  const std::size_t segments = points.size() - (closed ? 0 : 1);
  for (std::size_t i = 0; i < segments; ++i) {
    const PixelPoint a = points[i], b = points[(i + 1) % points.size()];
    const double length = std::hypot(double{b.x} - a.x, double{b.y} - a.y);
    double done = 0;
    while (done + left < length) {
      done += left;
      const auto t = static_cast<float>(done / length);
      const PixelPoint p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.depth + t * (b.depth - a.depth)};
      if (ink) {
        pieces.back().push_back(p);
      } else {
        pieces.push_back({p});
      }
      ink = !ink;
      left = ink ? on : off;
    }
    left -= length - done;
    if (ink) pieces.back().push_back(b);
  }
  return pieces;
}

}  // namespace blossom
