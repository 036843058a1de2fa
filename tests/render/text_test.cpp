// Letters, and rich text set into lines.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>

#include "render/demo_scene.hpp"
#include "render/rich_text.hpp"

using namespace blossom;

namespace {

const Fonts& fonts() {
  static const auto loaded = Fonts::load();
  REQUIRE(loaded);
  return **loaded;
}

}  // namespace

TEST_CASE("UTF-8 is read as code points; what is invalid becomes U+FFFD") {
  CHECK(decode_utf8("aé−𝛼") == U"a\u00e9\u2212\U0001d6fc");
  CHECK(decode_utf8("a\xff"
                    "b") == U"a\ufffdb");
  CHECK(decode_utf8("\xc0\x80") == U"\ufffd\ufffd");            // overlong
  CHECK(decode_utf8("\xed\xa0\x80") == U"\ufffd\ufffd\ufffd");  // a surrogate
  CHECK(decode_utf8("\xe2\x88") == U"\ufffd\ufffd");            // cut short
  for (const char32_t c : {U'a', U'\u00e9', U'\u2212', U'\U0001d6fc'})
    CHECK(decode_utf8(encode_utf8(c)) == std::u32string{c});
}

TEST_CASE("Metrics are DejaVu's") {
  // From the font's own tables, in 2048ths of the em.
  CHECK(fonts().advance({}, U'P') == Approx(1235.0 / 2048));
  CHECK(fonts().advance({.italic = true}, U'P') == fonts().advance({}, U'P'));
  CHECK(fonts().advance({.monospace = true}, U'i') == fonts().advance({.monospace = true}, U'W'));
  CHECK(fonts().kerning({}, U'A', U'V') < 0);
  CHECK(fonts().width({}, "AV") ==
        Approx(fonts().advance({}, U'A') + fonts().advance({}, U'V') + fonts().kerning({}, U'A', U'V')));
}

TEST_CASE("A halo is the letter grown on every side") {
  const auto letter = fonts().bitmap({}, U'o', 20, 0, 0), halo = fonts().bitmap({}, U'o', 20, 0, 2);
  CHECK(halo.left <= letter.left - 1);
  CHECK(halo.top >= letter.top + 1);
  CHECK(halo.width >= letter.width + 3);
  CHECK(halo.height >= letter.height + 3);
  CHECK(fonts().bitmap({}, U' ', 20, 0, 0).coverage.empty());
}

TEST_CASE("A superscript after a subscript stands above it, at the same base") {
  const auto block = set_text(fonts(), point_name("P", "4", "(1)"), 20, TextAlign::left);
  REQUIRE(block.runs.size() == 3);
  const auto &base = block.runs[0], &sub = block.runs[1], &super = block.runs[2];
  CHECK(base.size == 20);
  CHECK(sub.size == Approx(14));
  CHECK(sub.x == Approx(fonts().advance({.italic = true}, U'P') * 20));
  CHECK(super.x == sub.x);
  CHECK(sub.baseline > 0);
  CHECK(super.baseline < 0);
  CHECK(block.width == Approx(sub.x + fonts().width({}, "(1)") * 14));
  SECTION("and what follows the pair starts after the wider of them") {
    auto text = point_name("P", "4", "(1)");
    text.push_back({"x"});
    CHECK(set_text(fonts(), text, 20, TextAlign::left).runs[3].x == Approx(block.width));
  }
}

TEST_CASE("A subscript and the superscript above it keep clear of each other") {
  for (const char* sub : {"4", "i", "12", "k-p+1"})
    for (const char* super : {"(1)", "2", "(r-1)"}) {
      INFO(sub << " below " << super);
      const auto block = set_text(fonts(), point_name("P", sub, super), 20, TextAlign::left);
      REQUIRE(block.runs.size() == 3);
      const auto &below = block.runs[1], &above = block.runs[2];
      double ink_of_below = 1e9, ink_of_above = -1e9;
      for (const char32_t c : decode_utf8(below.text))
        ink_of_below = std::min(ink_of_below, below.baseline - fonts().ink(below.style, c).top * below.size);
      for (const char32_t c : decode_utf8(above.text))
        ink_of_above = std::max(ink_of_above, above.baseline - fonts().ink(above.style, c).bottom * above.size);
      CHECK(ink_of_below - ink_of_above >= 0.18 * 20);
      CHECK(block.top <= above.baseline - Fonts::ascent * above.size);
      CHECK(block.bottom >= below.baseline + Fonts::descent * below.size);
    }
  // One alone stands where it always does.
  const auto alone =
      set_text(fonts(), {{"P", TextRun::Level::base, true}, {"4", TextRun::Level::sub}}, 20, TextAlign::left);
  CHECK(alone.runs[1].baseline == Approx(4.4));
}

TEST_CASE("Text is wrapped at blanks, and no line is wider than asked") {
  const std::string words =
      "Where the two parts meet, the polygon of the next level begins, and so on to the last point.";
  for (const double width : {60.0, 120.0, 300.0}) {
    const auto block = set_text(fonts(), plain(words), 14, TextAlign::left, width);
    INFO("width " << width);
    CHECK(block.width <= width);
    std::string joined;
    double baseline = -1;
    for (const auto& run : block.runs) {
      CHECK(run.x == 0);
      CHECK(run.baseline > baseline);
      baseline = run.baseline;
      joined += (joined.empty() ? "" : " ") + run.text;
    }
    CHECK(joined == words);
  }
}

TEST_CASE("A word longer than a line is broken; line feeds break; blanks in columns stay") {
  const auto broken = set_text(fonts(), plain(std::string(100, '9')), 14, TextAlign::left, 90);
  CHECK(broken.width <= 90);
  std::size_t letters = 0;
  for (const auto& run : broken.runs) letters += run.text.size();
  CHECK(letters == 100);

  const auto lines = set_text(fonts(), plain("a\n\nb"), 10, TextAlign::left);
  REQUIRE(lines.runs.size() == 2);
  CHECK(lines.runs[1].baseline == Approx(28));

  const RichText columns{{"a    b", TextRun::Level::base, false, false, true}};
  const auto row = set_text(fonts(), columns, 10, TextAlign::left);
  CHECK(row.width == Approx(6 * 10 * fonts().advance({.monospace = true}, U'a')));
}

TEST_CASE("Centred and right-aligned text stands about its anchor") {
  const double width = fonts().width({}, "abc") * 10;
  CHECK(set_text(fonts(), plain("abc"), 10, TextAlign::centre).runs[0].x == Approx(-width / 2));
  CHECK(set_text(fonts(), plain("abc"), 10, TextAlign::right).runs[0].x == Approx(-width));
}

TEST_CASE("A missing font is a diagnostic that names the package") {
  setenv("BLOSSOM_FONT_DIR", "/nonexistent", 1);
  const auto loaded = Fonts::load();
  unsetenv("BLOSSOM_FONT_DIR");
  REQUIRE_FALSE(loaded);
  CHECK(loaded.diagnostics.size() == 4);
  CHECK(loaded.diagnostics[0].message.find("fonts-dejavu-core") != std::string::npos);
}
