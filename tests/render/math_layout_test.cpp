// Formulas set in two dimensions: what stands above what, and on which line.
#include <algorithm>
#include <catch2/catch.hpp>

#include "render/rich_text.hpp"

using namespace blossom;

namespace {

const Fonts& fonts() {
  static const auto loaded = Fonts::load();
  REQUIRE(loaded);
  return **loaded;
}

Math formula(std::string_view tex) {
  MathMistake mistake;
  const auto made = parse_math(tex, mistake);
  INFO(tex << ": " << mistake.what);
  REQUIRE(made);
  return *made;
}

MathBox box(std::string_view tex, bool display = false) { return lay_out(fonts(), formula(tex), 20, display); }

const GlyphRun& run(const MathBox& box, std::string_view text) {
  const auto found = std::ranges::find(box.runs, text, &GlyphRun::text);
  REQUIRE(found != box.runs.end());
  return *found;
}

RichText with_formula(std::string before, std::string_view tex, std::string after, bool display = false) {
  TextRun math{plain_math(formula(tex))};
  math.math = std::make_shared<const Math>(formula(tex));
  math.display = display;
  return {{std::move(before)}, math, {std::move(after)}};
}

}  // namespace

TEST_CASE("A fraction's line stands on the axis, its halves above and below it, in the middle", "[math]") {
  for (const bool display : {false, true}) {
    const MathBox half = box("\\frac{1}{2}", display);
    REQUIRE(half.bars.size() == 1);
    const TextBar& bar = half.bars[0];
    const auto plus = fonts().ink({}, U'+');
    CHECK(bar.y + bar.height / 2 == Approx(-(plus.top + plus.bottom) / 2 * 20));
    const GlyphRun &above = run(half, "1"), &below = run(half, "2");
    CHECK(above.baseline < bar.y);
    CHECK(below.baseline - fonts().ink({}, U'2').top * below.size > bar.y + bar.height);
    CHECK(above.size == Approx(display ? 20 : 14));
    CHECK(half.height > half.depth);
    const MathBox wide = box("\\frac{1}{2 + x}", display);
    const double middle = wide.bars[0].x + wide.bars[0].width / 2;
    CHECK(run(wide, "1").x + fonts().width({}, "1") * run(wide, "1").size / 2 == Approx(middle));
  }
  CHECK(box("\\binom{n}{i}").bars.empty());
}

TEST_CASE("Scripts stand where those of names do", "[math]") {
  const RichText name{{"P", TextRun::Level::base, true}, {"4", TextRun::Level::sub}};
  const RichText power{{"P", TextRun::Level::base, true}, {"2", TextRun::Level::super}};
  const MathBox low = box("P_{4}"), high = box("P^{2}"), both = box("P_{4}^{2}");
  const TextBlock low_name = set_text(fonts(), name, 20, TextAlign::left);
  CHECK(run(low, "4").baseline == Approx(low_name.runs[1].baseline));
  CHECK(run(low, "4").size == Approx(low_name.runs[1].size));
  CHECK(run(high, "2").baseline == Approx(set_text(fonts(), power, 20, TextAlign::left).runs[1].baseline));
  CHECK(run(low, "P").style.italic);
  CHECK_FALSE(run(low, "4").style.italic);
  // Two of them keep clear of each other.
  const double upper = run(both, "2").baseline, lower = run(both, "4").baseline - fonts().ink({}, U'4').top * 14;
  CHECK(upper < lower - 1);
  // A subscript of a subscript is smaller still, and lower.
  const MathBox deep = box("x_{y_{z}}");
  CHECK(run(deep, "z").size < run(deep, "y").size);
  CHECK(run(deep, "z").baseline > run(deep, "y").baseline);
}

TEST_CASE("Primes stand at the letter in its own size", "[math]") {
  CHECK(run(box("f'"), "′").size == 20);
  CHECK(run(box("f'"), "′").baseline == 0);
  CHECK(box("f''").runs.size() == 3);
}

TEST_CASE("Limits stand above and below a sum on a line of its own, beside it in text", "[math]") {
  const MathBox alone = box("\\sum_{i}^{n}", true), inside = box("\\sum_{i}^{n}");
  const GlyphRun& sum = run(alone, "∑");
  CHECK(run(alone, "i").baseline > sum.baseline + 0.2 * sum.size);
  CHECK(run(alone, "n").baseline < sum.baseline - 0.7 * sum.size);
  CHECK(run(alone, "i").x < sum.x + fonts().width({}, "∑") * sum.size);
  CHECK(run(inside, "i").x >= fonts().width({}, "∑") * run(inside, "∑").size);
  CHECK(sum.size > run(inside, "∑").size);
  // Those of an integral stand beside it always.
  const MathBox integral = box("\\int_{0}^{1}", true);
  CHECK(run(integral, "0").x > run(integral, "∫").x);
  CHECK(run(integral, "1").x > run(integral, "0").x);
}

TEST_CASE("Signs between two things stand apart, signs of one thing do not", "[math]") {
  const auto distance = [](const MathBox& set, std::string_view a, std::string_view b, bool italic) {
    return run(set, b).x - run(set, a).x - fonts().width({.italic = italic}, a) * run(set, a).size;
  };
  CHECK(distance(box("x-1"), "−", "1", false) == Approx(0.2 * 20));
  CHECK(distance(box("-1"), "−", "1", false) == Approx(0).margin(1e-9));
  CHECK(distance(box("x=-1"), "−", "1", false) == Approx(0).margin(1e-9));
  CHECK(distance(box("x=1"), "=", "1", false) > distance(box("x-1"), "−", "1", false));
  CHECK(distance(box("x_{i-1}"), "−", "1", false) == Approx(0).margin(1e-9));  // and none do in scripts
}

TEST_CASE("Roots and fences are as tall as what they hold", "[math]") {
  const MathBox root = box("\\sqrt{\\frac{a}{b}}", true), inside = box("\\frac{a}{b}", true);
  REQUIRE(root.strokes.size() == 1);
  CHECK(root.height > inside.height);
  CHECK(root.depth > inside.depth);
  double top = 0, bottom = 0, right = 0;
  for (const auto& point : root.strokes[0].points) {
    top = std::min(top, point.y);
    bottom = std::max(bottom, point.y);
    right = std::max(right, point.x);
  }
  CHECK(-top > inside.height);
  CHECK(bottom > inside.depth);
  CHECK(right <= root.width);
  for (const std::string fences : {"()", "[]", "||"}) {
    const std::string left = "\\left" + fences.substr(0, 1), end = "\\right" + fences.substr(1);
    CHECK(box(left + "x" + end).strokes.empty());  // a letter is enough
    const MathBox tall = box(left + "\\frac{a}{b}" + end, true);
    CHECK(tall.strokes.size() == 2);
    CHECK(tall.height >= inside.height);
    CHECK(tall.depth >= inside.depth);
  }
  CHECK(box("\\bar{U}").bars.size() == 1);
  CHECK(box("\\bar{U}").height > box("U").height);
}

TEST_CASE("A formula in text is one word on the text's baseline, and lines make room for it", "[math]") {
  const TextBlock block = set_text(fonts(), with_formula("so ", "x+1", " is"), 20, TextAlign::left);
  for (const GlyphRun& glyphs : block.runs) CHECK(glyphs.baseline == 0);
  const double words = fonts().width({}, "so") + 2 * fonts().width({}, " ") + fonts().width({}, "is");
  CHECK(block.width == Approx(words * 20 + box("x+1").width));
  const auto lines = [](std::string_view tex, bool display) {
    RichText text = with_formula("one\n", tex, "\nthree", display);
    return set_text(fonts(), text, 20, TextAlign::left);
  };
  const auto baseline_of = [](const TextBlock& set, std::string_view letters) {
    return std::ranges::find(set.runs, letters, &GlyphRun::text)->baseline;
  };
  CHECK(baseline_of(lines("x", false), "three") == Approx(2 * 1.4 * 20));
  const TextBlock tall = lines("\\frac{\\frac{a}{b}}{c}", true);
  CHECK(baseline_of(tall, "three") > 2 * 1.4 * 20 + 5);
  const MathBox formula_box = box("\\frac{\\frac{a}{b}}{c}", true);
  // Its highest ink is below what hangs from the line before, its lowest above the letters of the next.
  const double own = baseline_of(tall, "c") - run(formula_box, "c").baseline;
  CHECK(own - formula_box.height > Fonts::descent * 20);
  CHECK(own + formula_box.depth < baseline_of(tall, "three") - Fonts::ascent * 20);
  // It is never broken, however narrow the place is.
  const TextBlock narrow = set_text(fonts(), with_formula("aaa ", "x + y + z", " bbb"), 20, TextAlign::left, 50);
  std::vector<double> baselines;
  for (const GlyphRun& glyphs : narrow.runs)
    if (glyphs.text == "x" || glyphs.text == "z") baselines.push_back(glyphs.baseline);
  REQUIRE(baselines.size() == 2);
  CHECK(baselines[0] == baselines[1]);
}

TEST_CASE("Lines go on below the last tab", "[math]") {
  const TextBlock item = set_text(fonts(), {{"• \tone two three four five six"}}, 20, TextAlign::left, 120);
  std::vector<double> starts;
  double last = -1;
  for (const GlyphRun& glyphs : item.runs) {
    if (glyphs.baseline != last && glyphs.text[0] >= 0) starts.push_back(glyphs.x);
    if (glyphs.text[0] >= 0) last = glyphs.baseline;
  }
  REQUIRE(starts.size() >= 2);
  for (std::size_t i = 1; i < starts.size(); ++i) CHECK(starts[i] == Approx(starts[1]));
  CHECK(starts[1] > 10);
}
