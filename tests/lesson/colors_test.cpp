// Colours of lessons: what can be told from a background, and what can't.

#include "lesson/colors.hpp"

#include "base/json_write.hpp"
#include "lesson_text.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

std::string told(const std::string& text, LessonColors* colors = nullptr) {
  const auto document = parsed(text, "c.json");
  Diagnostics diagnostics;
  const auto read = read_colors(Cursor(document, diagnostics));
  if (colors != nullptr) *colors = read;
  return to_string(diagnostics);
}

}  // namespace

TEST_CASE("contrast is that of WCAG 2.1") {
  CHECK(contrast_of(0x000000, 0xFFFFFF) == Approx(21));
  CHECK(contrast_of(0xFFFFFF, 0xFFFFFF) == Approx(1));
  // Known from the guideline's own examples of the least gray that passes.
  CHECK(contrast_of(0x767676, 0xFFFFFF) == Approx(4.54).margin(0.005));
  CHECK(contrast_of(0x949494, 0xFFFFFF) == Approx(3.03).margin(0.005));
  CHECK(contrast_of(0x777777, 0xFFFFFF) < 4.5);
  CHECK(contrast_of(0x336699, 0xFFEEDD) == contrast_of(0xFFEEDD, 0x336699));
}

TEST_CASE("colours are read as CSS writes them") {
  CHECK(parse_rgb("#b00060") == std::optional<Rgb>(0xB00060));
  CHECK(parse_rgb("#B0f") == std::optional<Rgb>(0xBB00FF));
  for (const char* text : {"", "#", "b00060", "#b0006", "#b0006g", "#b000601", "red"}) CHECK_FALSE(parse_rgb(text));
  CHECK(write_rgb(0x00AB0C) == "#00ab0c");
}

TEST_CASE("the nearest readable colour is readable, and no nearer one of its kind is") {
  for (const auto& [theme, background] : theme_backgrounds)
    for (const Rgb color : {0xFFFF00u, 0x0000FFu, 0x808080u, 0xFF0000u, 0x14181Fu, 0xFFFFFFu}) {
      INFO(theme << " " << write_rgb(color));
      const auto better = nearest_readable(color, {background});
      REQUIRE(better);
      CHECK(contrast_of(*better, background) >= least_contrast);
      if (contrast_of(color, background) >= least_contrast) {
        CHECK(*better == color);
      } else {
        CHECK(contrast_of(*better, background) < 1.1 * least_contrast);  // not more than it takes
      }
    }
  CHECK_FALSE(nearest_readable(0x123456, {0x000000, 0xFFFFFF}, 5));  // 21 = 4.58 x 4.58
}

TEST_CASE("a plain colour is for every theme, others for one") {
  LessonColors colors;
  CHECK(told(R"({"highlight": "#c2410c", "curve": {"light": "#003a85", "dark": "#8ab4ff"}})", &colors).empty());
  REQUIRE(colors.size() == 2);
  CHECK(colors[0].role == "curve");
  CHECK(colors[0].by_theme[0] == std::optional<Rgb>(0x003A85));
  CHECK(colors[0].by_theme[1] == std::optional<Rgb>(0x8AB4FF));
  CHECK_FALSE(colors[0].by_theme[2]);
  for (const auto& color : colors[1].by_theme) CHECK(color == std::optional<Rgb>(0xC2410C));
  LessonColors again;
  CHECK(told(write_json(write_colors(colors)), &again).empty());
  CHECK(write_json(write_colors(again)) == write_json(write_colors(colors)));
}

TEST_CASE("too little contrast is refused, with the ratio and the nearest colour that can be seen") {
  CHECK(told(R"({"highlight": {"light": "#ffff00", "dark": "#ffff00"},
"curve": "#003a85", "crve": 1,
"result": {}, "surface": "blue", "level_a": {"night": "#fff"}})") ==
        "c.json:1:25: highlight.light: has too little contrast: 1.0:1 on the background of the theme \"light\", where "
        "3:1 "
        "is the least; the nearest colour that can be seen is \"#9a9a00\"\n"
        "c.json:2:10: curve: has too little contrast: 1.6:1 on the background of the theme \"dark\", where 3:1 is the "
        "least; the nearest colour that can be seen is \"#3966a0\"; or give one for each theme, {\"light\": ..., "
        "\"dark\": "
        "..., \"contrast\": ...}\n"
        "c.json:2:21: unknown key \"crve\"; did you mean \"curve\"?\n"
        "c.json:3:11: result: must have a colour for \"light\", \"dark\" or \"contrast\"\n"
        "c.json:3:26: surface: must be a colour such as \"#b00060\", not \"blue\"\n"
        "c.json:3:46: level_a: unknown key \"night\"; did you mean \"light\"?\n");
}

TEST_CASE("a lesson has its colours") {
  const auto lesson = lesson_of(beat("\"start\""), parabola, header + "\"colors\": {\"curve\": \"#c2410c\"}, ");
  REQUIRE(lesson.colors.size() == 1);
  CHECK_THAT(
      mistakes(beat("\"start\""), parabola, header + "\"colors\": {\"curve\": \"#fff\"}, "),
      Catch::StartsWith("lesson.json:1:91: colors.curve: has too little contrast: 1.0:1 on the background of the "
                        "theme \"light\", 1.0:1 on the background of the theme \"contrast\""));
}
