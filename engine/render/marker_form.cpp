#include "render/marker_form.hpp"

#include <array>
#include <initializer_list>

namespace blossom {

MarkerForm marker_form(const PixelPoint& at, Marker::Shape shape, float radius) {
  const float r = radius;
  const auto filled = [&](std::initializer_list<std::array<float, 2>> corners) {
    MarkerForm form;
    form.lines.emplace_back();
    for (const auto& [x, y] : corners) form.lines.back().push_back({at.x + x, at.y + y, at.depth});
    return form;
  };
  const float side = 0.86f * r, corner = 1.2162f * r, arm = 0.7778f * r;
  switch (shape) {
    case Marker::Shape::disc:
      return {r, {}, 0};
    case Marker::Shape::ring:
      return {0.8f * r, {}, 0.4f * r};
    case Marker::Shape::square:
      return filled({{-side, -side}, {side, -side}, {side, side}, {-side, side}});
    case Marker::Shape::diamond:
      return filled({{0, -corner}, {corner, 0}, {0, corner}, {-corner, 0}});
    case Marker::Shape::triangle:
      return filled({{0, -1.3f * r}, {1.1258f * r, 0.65f * r}, {-1.1258f * r, 0.65f * r}});
    case Marker::Shape::cross: {
      const auto bar = [&](float dx, float dy) {
        return std::vector<PixelPoint>{{at.x - dx, at.y - dy, at.depth}, {at.x + dx, at.y + dy, at.depth}};
      };
      return {0, {bar(arm, arm), bar(arm, -arm)}, 0.48f * r};
    }
  }
  return {};
}

}  // namespace blossom
