#pragma once
// From page units to pixels: where a view's page lies in the frame.

#include <glm/vec2.hpp>

#include "render/canvas.hpp"

namespace blossom {

struct PageMap {
  double scale = 1;         // pixels per page unit
  glm::dvec2 origin{0, 0};  // pixels, whole ones: letters stand on whole pixels, and so must all that stands by them

  PixelPoint operator()(double x, double y, double depth) const {
    return {static_cast<float>(x * scale + origin.x), static_cast<float>(y * scale + origin.y),
            static_cast<float>(depth)};
  }
  PixelRect operator()(const PixelRect& box) const {
    return {box.x * scale + origin.x, box.y * scale + origin.y, box.width * scale, box.height * scale};
  }
  PixelRect back(const PixelRect& box) const {
    return {(box.x - origin.x) / scale, (box.y - origin.y) / scale, box.width / scale, box.height / scale};
  }
};

}  // namespace blossom
