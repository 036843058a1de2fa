#pragma once
// Cutting to a rectangle, in page units and double precision, so that what reaches a canvas fits its floats.

#include <vector>

#include "render/canvas.hpp"
#include "render/projection.hpp"

namespace blossom {

inline bool contains(const PixelRect& box, double x, double y) {
  return x >= box.x && y >= box.y && x <= box.right() && y <= box.bottom();
}
PixelRect intersection(const PixelRect&, const PixelRect&);  // width or height 0 when there is none

struct ClippedLine {
  std::vector<PagePoint> points;
  bool closed = false;
};

// The pieces of the projected line that are inside. A point that cannot be projected ends a piece.
std::vector<ClippedLine> clip_line(const Projection&, const Polyline&, double pull, const PixelRect& box);

// Of a convex polygon (Sutherland and Hodgman, 1974).
std::vector<PagePoint> clip_polygon(std::vector<PagePoint>, const PixelRect& box);

}  // namespace blossom
