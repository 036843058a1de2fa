#include "lesson/colors.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/json_write.hpp"

namespace blossom {
namespace {

constexpr int channel(Rgb color, int shift) { return static_cast<int>(color >> shift & 0xFF); }

double luminance(Rgb color) {
  const auto linear = [&](int shift) {
    const double v = channel(color, shift) / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(16) + 0.7152 * linear(8) + 0.0722 * linear(0);
}

// n of 256 parts of the way to another colour.
Rgb toward(Rgb from, Rgb to, int n) {
  Rgb mixed = 0;
  for (const int shift : {16, 8, 0}) {
    const int a = channel(from, shift), b = channel(to, shift);
    mixed |= static_cast<Rgb>(a + (b - a) * n / 256) << shift;
  }
  return mixed;
}

std::string ratio_text(double ratio) {
  // Rounded down: 2.97 is not 3.
  char text[16];
  std::snprintf(text, sizeof text, "%.1f:1", std::floor(ratio * 10) / 10);
  return text;
}

std::optional<Rgb> read_rgb(const Cursor& at) {
  const auto text = at.string();
  if (!text) return std::nullopt;
  const auto color = parse_rgb(*text);
  if (!color) at.error("must be a colour such as \"#b00060\", not " + excerpt(*text));
  return color;
}

// A colour for some themes: where it cannot be seen on their backgrounds, that is told.
void check_contrast(const Cursor& at, Rgb color, const std::vector<ThemeBackground>& themes) {
  std::string poor;
  std::vector<Rgb> backgrounds;
  for (const auto& [theme, background] : themes) {
    backgrounds.push_back(background);
    const double ratio = contrast_of(color, background);
    if (ratio >= least_contrast) continue;
    poor += (poor.empty() ? "" : ", ") + ratio_text(ratio) + " on the background of the theme " + json_quote(theme);
  }
  if (poor.empty()) return;
  std::string message = "has too little contrast: " + poor + ", where 3:1 is the least";
  if (const auto better = nearest_readable(color, backgrounds))
    message += "; the nearest colour that can be seen is " + json_quote(write_rgb(*better));
  if (themes.size() > 1) message += R"(; or give one for each theme, {"light": ..., "dark": ..., "contrast": ...})";
  at.error(message);
}

void read_color(const Cursor& at, RoleColor& made) {
  const std::vector<ThemeBackground> all(theme_backgrounds.begin(), theme_backgrounds.end());
  if (!at.is(Json::Kind::object)) {
    const auto color = read_rgb(at);
    if (!color) return;
    made.by_theme.fill(color);
    check_contrast(at, *color, all);
    return;
  }
  std::vector<std::string> themes;
  for (const ThemeBackground& theme : all) themes.emplace_back(theme.theme);
  at.expect_object(themes);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (const auto here = at.optional(all[i].theme))
      if ((made.by_theme[i] = read_rgb(*here))) check_contrast(*here, *made.by_theme[i], {all[i]});
  if (at.size() == 0) at.error(R"(must have a colour for "light", "dark" or "contrast")");
}

}  // namespace

double contrast_of(Rgb a, Rgb b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

std::optional<Rgb> nearest_readable(Rgb color, const std::vector<Rgb>& backgrounds, double contrast) {
  for (int n = 0; n <= 256; ++n)
    for (const Rgb end : {0x000000u, 0xFFFFFFu}) {
      const Rgb mixed = toward(color, end, n);
      if (std::ranges::all_of(backgrounds, [&](Rgb b) { return contrast_of(mixed, b) >= contrast; })) return mixed;
    }
  return std::nullopt;
}

std::optional<Rgb> parse_rgb(std::string_view text) {
  if ((text.size() != 4 && text.size() != 7) || text[0] != '#') return std::nullopt;
  Rgb color = 0;
  for (const char c : text.substr(1)) {
    const Rgb digit = '0' <= c && c <= '9'   ? static_cast<Rgb>(c - '0')
                      : 'a' <= c && c <= 'f' ? static_cast<Rgb>(c - 'a' + 10)
                      : 'A' <= c && c <= 'F' ? static_cast<Rgb>(c - 'A' + 10)
                                             : 16u;
    if (digit == 16) return std::nullopt;
    color = text.size() == 4 ? color << 8 | digit << 4 | digit : color << 4 | digit;
  }
  return color;
}

std::string write_rgb(Rgb color) {
  char text[8];
  std::snprintf(text, sizeof text, "#%06x", static_cast<unsigned>(color & 0xFFFFFF));
  return text;
}

LessonColors read_colors(const Cursor& at) {
  LessonColors colors;
  if (!at.expect_object({colored_roles.begin(), colored_roles.end()})) return colors;
  for (const std::string_view role : colored_roles)
    if (const auto here = at.optional(role)) {
      RoleColor made{role, {}};
      read_color(*here, made);
      colors.push_back(made);
    }
  return colors;
}

Json write_colors(const LessonColors& colors) {
  std::vector<std::pair<std::string, Json>> members;
  for (const RoleColor& color : colors) {
    const auto& by_theme = color.by_theme;
    if (by_theme[0] && std::ranges::all_of(by_theme, [&](const auto& each) { return each == by_theme[0]; })) {
      members.emplace_back(color.role, json_string(write_rgb(*by_theme[0])));
      continue;
    }
    std::vector<std::pair<std::string, Json>> themes;
    for (std::size_t i = 0; i < by_theme.size(); ++i)
      if (by_theme[i]) themes.emplace_back(theme_backgrounds[i].theme, json_string(write_rgb(*by_theme[i])));
    members.emplace_back(color.role, json_object(std::move(themes)));
  }
  return json_object(std::move(members));
}

}  // namespace blossom
