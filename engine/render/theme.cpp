#include "render/theme.hpp"

#include <algorithm>
#include <cmath>

#include "scene/theme_list.hpp"

namespace blossom {
namespace {

using Shape = Marker::Shape;

constexpr Color rgb(std::uint32_t hex) {
  return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8), static_cast<std::uint8_t>(hex)};
}

// The shape of things is common to all themes; the order is that of Role.
struct Form {
  double line_width, dash, gap, marker_size;
  Shape shape;
  double text_size;
};
constexpr std::array<Form, role_count> forms = {{
    {1.0, 0, 0, 4, Shape::disc, 12},      // grid
    {1.3, 0, 0, 5, Shape::disc, 12},      // axis
    {2.8, 0, 0, 7, Shape::disc, 14},      // curve
    {3.6, 0, 0, 8, Shape::disc, 14},      // curve_result
    {1.5, 0, 0, 7, Shape::disc, 14},      // polygon
    {1.5, 0, 0, 9, Shape::disc, 14},      // control_point
    {1.2, 0, 0, 6, Shape::disc, 13},      // earlier
    {1.9, 0, 0, 8, Shape::disc, 14},      // level_a
    {1.9, 7, 4, 7.5, Shape::square, 14},  // level_b
    {1.9, 2, 4, 8, Shape::triangle, 14},  // level_c
    {2.6, 0, 0, 13, Shape::ring, 14},     // operand
    {4.0, 0, 0, 13, Shape::disc, 15},     // current
    {5.0, 0, 0, 8, Shape::disc, 13},      // ratio_near
    {2.6, 0, 0, 8, Shape::disc, 13},      // ratio_far
    {3.4, 0, 0, 14, Shape::diamond, 15},  // result
    {1.3, 0.1, 4, 8, Shape::cross, 13},   // retired
    {1.0, 0, 0, 6, Shape::disc, 13},      // surface
    {1.1, 0, 0, 6, Shape::disc, 13},      // isoline
    {1.0, 0, 0, 6, Shape::square, 13},    // panel
    {1.0, 0, 0, 6, Shape::disc, 13},      // rule_line
    {1.2, 0, 0, 6, Shape::disc, 14},      // text
    {1.0, 0, 0, 6, Shape::disc, 12.5},    // text_quiet
    {1.4, 0, 0, 6, Shape::disc, 17},      // text_strong
    {1.4, 0, 0, 6, Shape::disc, 14},      // text_current
    {4.5, 0, 0, 19, Shape::ring, 14},     // highlight
    {3.1, 0, 0, 11, Shape::disc, 14},     // right
    {3.1, 5, 3, 12, Shape::cross, 14},    // mistake
    {2.2, 0, 0, 12, Shape::square, 14},   // focus
    {2.3, 0, 0, 9, Shape::disc, 14},      // object_0
    {2.3, 0, 0, 9, Shape::disc, 14},      // object_1
    {2.3, 0, 0, 9, Shape::disc, 14},      // object_2
    {2.3, 0, 0, 9, Shape::disc, 14},      // object_3
    {2.3, 0, 0, 9, Shape::disc, 14},      // object_4
    {2.3, 0, 0, 9, Shape::disc, 14},      // object_5
    {2.3, 0, 0, 9, Shape::disc, 14},      // object_6
    {2.3, 0, 0, 9, Shape::disc, 14},      // object_7
}};

struct Paint {
  std::uint32_t color, ink;
};

Color mixed(Color a, Color b, double t) {
  const auto channel = [t](std::uint8_t x, std::uint8_t y) {
    return static_cast<std::uint8_t>(std::lround(x + t * (y - x)));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)};
}

// What the faces of a scene's things are mixed with, so that their lines and points stand out on them.
struct Pale {
  std::uint32_t color;
  double share;
};
Theme make_theme(std::string_view name, std::uint32_t background, double width_factor, double text_factor, Pale pale,
                 const std::array<Paint, role_count>& paints) {
  Theme theme{std::string(name), rgb(background), {}};
  for (std::size_t i = 0; i < forms.size(); ++i) {
    const Form& form = forms[i];
    const bool object = i >= static_cast<std::size_t>(Role::object_0);
    theme.roles[i] = {rgb(paints[i].color),
                      mixed(rgb(paints[i].color), rgb(pale.color), object ? pale.share : 0),
                      rgb(paints[i].ink),
                      form.line_width * width_factor,
                      form.dash,
                      form.gap,
                      form.marker_size * std::sqrt(width_factor),
                      form.shape,
                      form.text_size * text_factor};
  }
  return theme;
}

const std::array<Theme, theme_list.size()>& themes() {
  static const std::array<Theme, theme_list.size()> all = {
      make_theme(theme_list[0].name, 0xFFFFFF, 1, 1, {0xFFFFFF, 0.5},
                 {{{0xE9ECF0, 0x5B6470}, {0xA3ABB6, 0x5B6470}, {0x20262E, 0x20262E}, {0x009E73, 0x00704F},
                   {0x8A93A0, 0x545D69}, {0x4A535F, 0x37404B}, {0xAAB2BD, 0x646D79}, {0x0072B2, 0x00669F},
                   {0xA8558A, 0x8F3F72}, {0x5E7A1E, 0x4F6A12}, {0x0072B2, 0x00669F}, {0xD55E00, 0xAD4700},
                   {0xE69F00, 0x8A5C00}, {0x56B4E9, 0x1B6C9C}, {0xC2185B, 0xB01250}, {0xB4BBC4, 0x646D79},
                   {0x9CC3E4, 0x2F5F86}, {0x4C7FA8, 0x2F5F86}, {0xF3F5F8, 0x37404B}, {0xD5DAE1, 0x5B6470},
                   {0x20262E, 0x20262E}, {0x5B6470, 0x5B6470}, {0x0E1318, 0x0E1318}, {0xAD4700, 0xAD4700},
                   {0x7B3FE4, 0x5F27BD}, {0x00875F, 0x00704F}, {0xB3261E, 0xA3201A}, {0x003A85, 0x003A85},
                   {0x0072B2, 0x00669F}, {0xD55E00, 0xAD4700}, {0x009E73, 0x00704F}, {0xB8598F, 0x8F3F72},
                   {0xD18F00, 0x8A5C00}, {0x3FA0DA, 0x1B6C9C}, {0x928600, 0x696000}, {0x5F6976, 0x454D58}}}),
      make_theme(theme_list[1].name, 0x14181F, 1, 1, {0x202B3A, 0.38},
                 {{{0x242A34, 0x9AA5B4}, {0x5A6577, 0x9AA5B4}, {0xF2F4F7, 0xF2F4F7}, {0x2FCB9B, 0x3DD6A7},
                   {0x7B8798, 0xA9B4C3}, {0xC3CBD6, 0xD5DBE4}, {0x59647A, 0x96A2B3}, {0x56B4E9, 0x6BBDEC},
                   {0xE08CC0, 0xE79CCB}, {0xB5CC55, 0xC0D46C}, {0x56B4E9, 0x6BBDEC}, {0xFF8A3D, 0xFF9A57},
                   {0xF0B429, 0xF2BE48}, {0x4C9BD0, 0x74B9E6}, {0xFF6FA5, 0xFF86B4}, {0x4B5568, 0x96A2B3},
                   {0x4F80AE, 0x9CC3E4}, {0x9CC3E4, 0x9CC3E4}, {0x1D232D, 0xD5DBE4}, {0x353E4C, 0x9AA5B4},
                   {0xE6EAF0, 0xE6EAF0}, {0x9AA5B4, 0x9AA5B4}, {0xFFFFFF, 0xFFFFFF}, {0xFF9A57, 0xFF9A57},
                   {0xFFE94A, 0xFFE94A}, {0x2FCB9B, 0x3DD6A7}, {0xFF6B5E, 0xFF8A7F}, {0x8AB4FF, 0x8AB4FF},
                   {0x4C93F0, 0x79B0FA}, {0xFF8A3D, 0xFF9A57}, {0x2FCB9B, 0x3DD6A7}, {0xE08CC0, 0xE79CCB},
                   {0xF0B429, 0xF2BE48}, {0x86D2FF, 0x86D2FF}, {0xE8DD4A, 0xEBE16A}, {0xAEB8C6, 0xC3CBD6}}}),
      // For projectors and tired eyes: black on white, strokes half as wide again, larger letters.
      make_theme(theme_list[2].name, 0xFFFFFF, 1.5, 1.12, {0xFFFFFF, 0.45},
                 {{{0xDEDEDE, 0x303030}, {0x505050, 0x303030}, {0x000000, 0x000000}, {0x00694C, 0x005A41},
                   {0x5A5A5A, 0x202020}, {0x000000, 0x000000}, {0x8A8A8A, 0x404040}, {0x0050A0, 0x004486},
                   {0x8A2C6C, 0x7A2460}, {0x3F5A00, 0x364E00}, {0x0050A0, 0x004486}, {0xC23B00, 0x962D00},
                   {0xD98600, 0x6E4300}, {0x1F86C8, 0x0B4A75}, {0xA00043, 0x8C003A}, {0x9A9A9A, 0x404040},
                   {0xB4D2EC, 0x143A5A}, {0x205A8A, 0x143A5A}, {0xF2F2F2, 0x000000}, {0x606060, 0x303030},
                   {0x000000, 0x000000}, {0x333333, 0x333333}, {0x000000, 0x000000}, {0x962D00, 0x962D00},
                   {0x6A1FD0, 0x45178F}, {0x00694C, 0x005A41}, {0x9C0A0A, 0x8C0000}, {0x002256, 0x002256},
                   {0x0050A0, 0x004486}, {0xC23B00, 0x962D00}, {0x00694C, 0x005A41}, {0x8A2C6C, 0x7A2460},
                   {0x9E6200, 0x6E4300}, {0x1F86C8, 0x0B4A75}, {0x6B6200, 0x524B00}, {0x3A3A3A, 0x202020}}})};
  return all;
}

double relative_luminance(Color c) {
  const auto linear = [](std::uint8_t channel) {
    const double v = channel / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

}  // namespace

std::vector<std::string> theme_names() {
  std::vector<std::string> names;
  for (const auto& theme : themes()) names.push_back(theme.name);
  return names;
}

Checked<const Theme*> find_theme(std::string_view name) {
  for (const auto& theme : themes()) {
    if (theme.name == name) return &theme;
  }
  std::string message = "there is no theme \"" + std::string(name) + "\"; the themes are";
  for (const auto& known : theme_names()) message += (known == theme_names().front() ? " " : ", ") + known;
  if (const auto meant = did_you_mean(name, theme_names())) message += "; did you mean \"" + *meant + "\"?";
  return Diagnostics{{"", 0, 0, "", message}};
}

const Theme& light_theme() { return themes()[0]; }

Color map_color(ColorMap map, double t) {
  static constexpr std::array diverging = {0x033E7Du, 0x1E6F9Du, 0x71A8C4u, 0xC9DDE7u, 0xF1EDEAu,
                                           0xEACEBDu, 0xD39774u, 0xBE6533u, 0x8B2706u};
  static constexpr std::array sequential = {0x440154u, 0x482878u, 0x3E4A89u, 0x31688Eu, 0x26828Eu,
                                            0x1F9E89u, 0x35B779u, 0x6DCD59u, 0xB4DE2Cu, 0xFDE725u};
  static constexpr std::array bands = {0x37424Fu, 0xF3F5F7u};
  const auto along = [t](const auto& stops) {
    const double place = (std::isfinite(t) ? std::clamp(t, 0.0, 1.0) : 0.5) * static_cast<double>(stops.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(place), stops.size() - 2);
    return mixed(rgb(stops[i]), rgb(stops[i + 1]), place - static_cast<double>(i));
  };
  switch (map) {
    case ColorMap::diverging:
      return along(diverging);
    case ColorMap::sequential:
      return along(sequential);
    case ColorMap::bands:
    case ColorMap::none:
      break;
  }
  return along(bands);
}

double contrast_ratio(Color a, Color b) {
  const double la = relative_luminance(a), lb = relative_luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

}  // namespace blossom
