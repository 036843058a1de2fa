#pragma once
// The shapes of markers as circles and lines, for canvases that write them so. All of one visual weight.

#include <vector>

#include "render/canvas.hpp"

namespace blossom {

struct MarkerForm {
  // A circle of this radius around the place, or else lines: closed ones to be filled, open ones to be stroked.
  float circle = 0;
  std::vector<std::vector<PixelPoint>> lines;
  float stroke = 0;  // width of the stroke, with flat ends; 0: filled
};

// The rim of outline_width lies under the form and reaches out of it on all sides.
MarkerForm marker_form(const PixelPoint& at, Marker::Shape, float radius);

}  // namespace blossom
