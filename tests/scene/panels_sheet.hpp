#pragma once
// What every panel's sheet is held to.

#include <algorithm>
#include <set>

#include "scene/panels.hpp"
#include "scene/shipped_lessons.hpp"

namespace blossom::test {

inline const Spot* spot_named(const Sheet& sheet, const std::string& name) {
  const auto found = std::ranges::find(sheet.spots, name, &Spot::name);
  return found == sheet.spots.end() ? nullptr : &*found;
}

inline bool shows(const Sheet& sheet, const std::string& text) {
  return std::ranges::any_of(sheet.view.labels, [&](const Label& label) { return plain_text(label.text) == text; });
}

// The spots are inside of 0..width x 0..height, have names of their own and do not overlap each other.
inline void check_spots(const Sheet& sheet, double width, double height) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < sheet.spots.size(); ++i) {
    const Spot& a = sheet.spots[i];
    if (!names.insert(a.name).second) FAIL_CHECK("two spots are called " << a.name);
    if (!a.link) FAIL_CHECK(a.name << " stands for nothing");
    if (!(a.x >= -1e-9 && a.y >= -1e-9 && a.x + a.width <= width + 1e-9 && a.y + a.height <= height + 1e-9))
      FAIL_CHECK(a.name << " at (" << a.x << ", " << a.y << "), " << a.width << " x " << a.height << " leaves " << width
                        << " x " << height);
    if (!(a.width > 0 && a.height > 0)) FAIL_CHECK(a.name << " is empty");
    for (std::size_t j = 0; j < i; ++j) {
      const Spot& b = sheet.spots[j];
      if (std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x) > 1e-9 &&
          std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y) > 1e-9)
        FAIL_CHECK(a.name << " overlaps " << b.name);
    }
  }
}

inline int count_role(const View& view, Role role) {
  return static_cast<int>(std::ranges::count(view.polygons, role, &Polygon::role) +
                          std::ranges::count(view.polylines, role, &Polyline::role) +
                          std::ranges::count(view.markers, role, &Marker::role));
}

}  // namespace blossom::test
