#pragma once
// What reading and writing scene files share.

#include <array>
#include <numbers>

#include "studio/workspace.hpp"

namespace blossom {

inline constexpr std::string_view scene_schema = "blossom.scene/1";

constexpr std::string_view look_from_name(Look::From from) {
  constexpr std::array<std::string_view, 4> names{"space", "xy", "xz", "yz"};
  return names[static_cast<std::size_t>(from)];
}

// Rounded once, so that radians written as degrees read back as the same double.
inline double radians_of(const Exact& degrees) {
  const double high = degrees.to_double();
  const long double low = (degrees - Exact(high)).to_double();
  return static_cast<double>((high + low) * std::numbers::pi_v<long double> / 180);
}

}  // namespace blossom
