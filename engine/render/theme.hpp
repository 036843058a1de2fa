#pragma once
// Looks: what each role is drawn with. The hues are those of Okabe and Ito ("Color Universal Design", 2008), told apart
// with every common colour blindness; and no two roles that meet in one picture differ by colour alone: width, dash or
// marker shape differ too.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"
#include "render/canvas.hpp"

namespace blossom {

struct RoleStyle {  // lengths in page units
  Color color;      // of lines, fills and markers
  Color face;       // of meshes: what the headlight shines on
  Color ink;        // of text in this role: contrast at least 4.5:1 on the background and on panels
  double line_width = 1;
  double dash = 0, gap = 0;                          // gap 0: solid
  double marker_size = 8;                            // diameter
  Marker::Shape marker_shape = Marker::Shape::disc;  // drawn where the scene leaves the shape at `disc`
  double text_size = 14;                             // of the em
};

struct Theme {
  std::string name;
  Color background;
  std::array<RoleStyle, role_count> roles;

  const RoleStyle& operator[](Role role) const { return roles[static_cast<std::size_t>(role)]; }
};

std::vector<std::string> theme_names();  // light, dark, contrast
Checked<const Theme*> find_theme(std::string_view name);
const Theme& light_theme();

// The colour at t = 0..1 of a map, the same in all themes, for a legend is compared with its picture. Diverging: "vik"
// of Crameri, "Scientific colour maps" (2018), without its ends, which are too dark to be shaded; sequential: "viridis"
// of Smith and van der Walt (2015). Both are told apart with every common colour blindness. What is not a number is in
// the middle.
Color map_color(ColorMap, double t);

// WCAG 2.1 contrast ratio, 1 to 21, of opaque colours: (L1 + 0.05) / (L2 + 0.05), L the relative luminance.
double contrast_ratio(Color, Color);

}  // namespace blossom
