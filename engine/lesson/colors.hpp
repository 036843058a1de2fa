#pragma once
// The colours a lesson asks for, instead of those of the theme it is shown in:
//
//   "colors": {"highlight": "#b00060", "curve": {"light": "#0a5", "dark": "#4fd8a5", "contrast": "#00553a"}}
//
// A plain colour is for every theme. What cannot be told from a theme's background is refused: WCAG 2.1 (success
// criterion 1.4.11) asks of what has to be seen in a picture a contrast of 3:1 at least.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/json.hpp"

namespace blossom {

using Rgb = std::uint32_t;  // 0xRRGGBB

struct ThemeBackground {
  std::string_view theme;
  Rgb color;
};
inline constexpr std::array<ThemeBackground, 3> theme_backgrounds{
    {{"light", 0xFFFFFF}, {"dark", 0x14181F}, {"contrast", 0xFFFFFF}}};

// What may have a colour of its own.
inline constexpr std::array<std::string_view, 11> colored_roles{"curve",   "polygon",   "control_point", "level_a",
                                                                "level_b", "level_c",   "operand",       "current",
                                                                "result",  "highlight", "surface"};

struct RoleColor {
  std::string_view role;                                              // one of colored_roles
  std::array<std::optional<Rgb>, theme_backgrounds.size()> by_theme;  // nothing: the theme's own
  bool operator==(const RoleColor&) const = default;
};
using LessonColors = std::vector<RoleColor>;  // a role at most once

inline constexpr double least_contrast = 3;

// (L1 + 0.05) / (L2 + 0.05) of the relative luminances, 1 to 21.
double contrast_of(Rgb, Rgb);
// The colour nearest to this one, of its hue, that has so much contrast on each of these backgrounds; nothing if there
// is none.
std::optional<Rgb> nearest_readable(Rgb, const std::vector<Rgb>& backgrounds, double contrast = least_contrast);

std::optional<Rgb> parse_rgb(std::string_view text);  // "#rrggbb" or "#rgb"
std::string write_rgb(Rgb);                           // "#rrggbb"

// The object of colours. Every mistake is told.
LessonColors read_colors(const Cursor&);
// As it stands in a file.
Json write_colors(const LessonColors&);

}  // namespace blossom
