#include "render/lesson_theme.hpp"

#include <algorithm>

namespace blossom {
namespace {

constexpr std::array<Role, colored_roles.size()> roles{
    Role::curve,   Role::polygon, Role::control_point, Role::level_a,   Role::level_b, Role::level_c,
    Role::operand, Role::current, Role::result,        Role::highlight, Role::surface};
constexpr double least_text_contrast = 4.5;

Color to_color(Rgb rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8), static_cast<std::uint8_t>(rgb)};
}

}  // namespace

Theme with_colors(const Theme& theme, const LessonColors& colors) {
  Theme made = theme;
  const auto known = std::ranges::find(theme_backgrounds, theme.name, &ThemeBackground::theme);
  if (known == theme_backgrounds.end()) return made;
  for (const RoleColor& color : colors) {
    const auto& own = color.by_theme[static_cast<std::size_t>(known - theme_backgrounds.begin())];
    const auto role = std::ranges::find(colored_roles, color.role);
    if (!own || role == colored_roles.end()) continue;
    const Role drawn = roles[static_cast<std::size_t>(role - colored_roles.begin())];
    RoleStyle& style = made.roles[static_cast<std::size_t>(drawn)];
    style.color = style.face = to_color(*own);
    style.ink = to_color(nearest_readable(*own, {known->color}, least_text_contrast).value_or(*own));
  }
  return made;
}

}  // namespace blossom
