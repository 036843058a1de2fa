// Lessons' colours in the themes.

#include "render/lesson_theme.hpp"

#include <catch2/catch.hpp>

using namespace blossom;

namespace {

Rgb rgb_of(Color c) { return static_cast<Rgb>(c.r << 16 | c.g << 8 | c.b); }

}  // namespace

TEST_CASE("the backgrounds that lessons' colours are checked against are the themes' own") {
  REQUIRE(theme_names().size() == theme_backgrounds.size());
  for (std::size_t i = 0; i < theme_backgrounds.size(); ++i) {
    INFO(theme_backgrounds[i].theme);
    CHECK(theme_names()[i] == theme_backgrounds[i].theme);
    const Theme& theme = **find_theme(theme_backgrounds[i].theme);
    CHECK(rgb_of(theme.background) == theme_backgrounds[i].color);
    for (const RoleStyle& style : theme.roles)
      CHECK(contrast_of(rgb_of(style.ink), rgb_of(theme.background)) ==
            Approx(contrast_ratio(style.ink, theme.background)).margin(0.02));
  }
}

TEST_CASE("a lesson's colour is that of its role in its theme, with text that can be read, and nothing else changes") {
  LessonColors colors;
  for (const std::string_view role : colored_roles) {
    RoleColor color{role, {}};
    color.by_theme[0] = 0x00888Fu;
    color.by_theme[1] = 0xC2410Cu;
    colors.push_back(color);
  }
  const Theme light = with_colors(light_theme(), colors);
  const Theme& dark_before = **find_theme("dark");
  const Theme dark = with_colors(dark_before, colors);
  for (const Role role : {Role::curve, Role::polygon, Role::control_point, Role::level_a, Role::level_b, Role::level_c,
                          Role::operand, Role::current, Role::result, Role::highlight, Role::surface}) {
    CHECK(rgb_of(light[role].color) == 0x00888F);
    CHECK(rgb_of(dark[role].color) == 0xC2410C);
    CHECK(contrast_ratio(light[role].ink, light.background) >= 4.49);
    CHECK(contrast_ratio(dark[role].ink, dark.background) >= 4.49);
    CHECK(light[role].line_width == light_theme()[role].line_width);
  }
  CHECK(light[Role::text].ink == light_theme()[Role::text].ink);
  CHECK(dark[Role::grid].color == dark_before[Role::grid].color);
  const Theme contrast = with_colors(**find_theme("contrast"), colors);
  CHECK(contrast[Role::curve].color == (**find_theme("contrast"))[Role::curve].color);
  CHECK(with_colors(light_theme(), {})[Role::curve].color == light_theme()[Role::curve].color);
}
