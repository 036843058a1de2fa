#include "render/math_fence.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace blossom {
namespace {

using Points = std::vector<TextStroke::Point>;

// A flat arc, open to the right: the middle of an ellipse, `deep` from its middle to its ends.
Points parenthesis(double top, double bottom, double deep) {
  constexpr int pieces = 24;
  constexpr double share = 0.96;  // of the ellipse's height, squared
  const double middle = (top + bottom) / 2;
  Points points;
  for (int i = 0; i <= pieces; ++i) {
    const double t = 2.0 * i / pieces - 1;
    const double across = (1 - std::sqrt(1 - share * t * t)) / (1 - std::sqrt(1 - share));
    points.push_back({deep * across, middle + t * (bottom - top) / 2});
  }
  return points;
}

// Four quarters of circles with straight lines between, open to the right.
Points brace(double top, double bottom, double deep) {
  const double r = deep / 2, middle = (top + bottom) / 2;
  Points points;
  const auto quarter = [&](double x, double y, double from, double to) {  // degrees, counterclockwise
    for (int i = 0; i <= 6; ++i) {
      const double angle = (from + (to - from) * i / 6) * std::numbers::pi / 180;
      points.push_back({x + r * std::cos(angle), y - r * std::sin(angle)});
    }
  };
  quarter(deep, top + r, 90, 180);
  quarter(0, middle - r, 0, -90);
  quarter(0, middle + r, 90, 0);
  quarter(deep, bottom - r, 180, 270);
  return points;
}

}  // namespace

TallFence tall_fence(char fence, double top, double bottom, double em) {
  const double thick = 0.078 * em, side = 0.09 * em, half = (bottom - top) / 2;
  top += thick / 2;
  bottom -= thick / 2;
  TallFence made;
  made.stroke.width = thick;
  double deep = 0;  // from its back to its ends
  if (fence == '(' || fence == ')') {
    deep = std::clamp(0.16 * half, 0.13 * em, 0.3 * em);
    made.stroke.points = parenthesis(top, bottom, deep);
  } else if (fence == '[' || fence == ']') {
    deep = 0.17 * em;
    made.stroke.points = {{deep, top}, {0, top}, {0, bottom}, {deep, bottom}};
  } else if (fence == '|') {
    made.stroke.points = {{0, top}, {0, bottom}};
  } else {
    deep = 0.28 * em;
    made.stroke.points = brace(top, bottom, deep);
  }
  const bool mirrored = fence == ')' || fence == ']' || fence == '}';
  for (auto& point : made.stroke.points) point.x = side + thick / 2 + (mirrored ? deep - point.x : point.x);
  made.width = deep + thick + 2 * side;
  return made;
}

}  // namespace blossom
