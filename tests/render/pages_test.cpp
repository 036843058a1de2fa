// Every page of every shipped lesson, as it is really painted: no text leaves the page or is cut by its panel, and no
// panel's text runs into another's.
#include <algorithm>
#include <set>

#include "render/font.hpp"
#include "render/painter.hpp"
#include "scene/shipped_lessons.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

struct PaintedText {
  std::string words;
  int view = 0;
  PixelRect box;  // of the letters, without the halo
};

// Keeps what is written where, and within which view.
class TextRecorder final : public Canvas {
 public:
  explicit TextRecorder(const Fonts& fonts) : fonts_(fonts) {}
  void begin(const Frame&) override {}
  void begin_view(const PixelRect& clip, bool) override { views.push_back(clip); }
  void polyline(std::span<const PixelPoint>, bool, const Stroke&) override {}
  void polygon(std::span<const PixelPoint>, Color) override {}
  void marker(const PixelPoint&, Marker::Shape, const MarkerPaint&) override {}
  void triangles(std::span<const PixelPoint>, std::span<const Color>, std::span<const std::uint32_t>, double) override {
  }
  void text(std::span<const GlyphRun> runs, const TextPaint&) override {
    for (const GlyphRun& run : runs) {
      double right = run.x;
      for_each_glyph(fonts_, run,
                     [&](char32_t c, double pen) { right = pen + fonts_.advance(run.style, c) * run.size; });
      texts.push_back({run.text,
                       static_cast<int>(views.size()) - 1,
                       {run.x, run.baseline - Fonts::ascent * run.size, right - run.x,
                        (Fonts::ascent + Fonts::descent) * run.size}});
    }
  }
  void finish() override {}

  std::vector<PixelRect> views;
  std::vector<PaintedText> texts;

 private:
  const Fonts& fonts_;
};

bool inside(const PixelRect& box, const PixelRect& of, double slack) {
  return box.x >= of.x - slack && box.y >= of.y - slack && box.right() <= of.right() + slack &&
         box.bottom() <= of.bottom() + slack;
}

// Boxes that share more than a sliver: `slack` units in both directions.
bool overlap(const PixelRect& a, const PixelRect& b, double slack) {
  return std::min(a.right(), b.right()) - std::max(a.x, b.x) > slack &&
         std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y) > slack;
}

constexpr std::pair<double, double> sizes[] = {{480, 360}, {640, 480}, {1120, 700}, {1920, 1080}};

// Every mistake of a kind once per lesson, size and words: a thousand steps often share one.
template <class Check>
void for_each_painted_page(std::string_view theme, Check&& check) {
  const auto fonts = Fonts::load();
  REQUIRE(fonts);
  for (const auto& entry : shipped_lessons().lessons) {
    const auto lesson = prepare<double>(entry);
    for (const auto& [width, height] : sizes) {
      std::set<std::string> told;
      for (std::uint32_t step = 0; step < lesson->step_count(); ++step) {
        TextRecorder canvas(**fonts);
        const Scene scene = lesson->page(step, width, height);
        INFO(lesson->name << ", step " << step << ", " << width << " x " << height << ", " << theme);
        paint(scene, **find_theme(theme), **fonts, canvas, 1);
        REQUIRE(canvas.views.size() == scene.views.size());
        check(scene, canvas, told);
      }
    }
  }
}

}  // namespace

TEST_CASE("No text of a page is cut off") {
  const auto theme = GENERATE(from_range(theme_names()));
  for_each_painted_page(theme, [](const Scene&, const TextRecorder& canvas, std::set<std::string>& told) {
    for (const auto& text : canvas.texts) {
      const auto& view = canvas.views[static_cast<std::size_t>(text.view)];
      if (inside(text.box, view, 1) || !told.insert(text.words).second) continue;
      FAIL_CHECK("\"" << text.words << "\" at (" << text.box.x << ", " << text.box.y << ") to (" << text.box.right()
                      << ", " << text.box.bottom() << ") leaves its view (" << view.x << ", " << view.y << ") to ("
                      << view.right() << ", " << view.bottom() << ")");
    }
  });
}

TEST_CASE("The text of a panel runs into no other text") {
  const auto theme = GENERATE(from_range(theme_names()));
  for_each_painted_page(theme, [](const Scene& scene, const TextRecorder& canvas, std::set<std::string>& told) {
    for (std::size_t a = 0; a < canvas.texts.size(); ++a) {
      for (std::size_t b = a + 1; b < canvas.texts.size(); ++b) {
        const auto &first = canvas.texts[a], &second = canvas.texts[b];
        // Names in the picture may touch where points are crowded; the painter places them as well as it can.
        const auto on_page = [&](const PaintedText& text) {
          return scene.views[static_cast<std::size_t>(text.view)].camera.kind == Camera::Kind::page;
        };
        if (first.view == second.view && !on_page(first)) continue;
        // A sub- and a superscript, and the descenders of one line with the ascenders of the next, share a sliver.
        if (!overlap(first.box, second.box, 3.5) || !told.insert(first.words + "|" + second.words).second) continue;
        FAIL_CHECK("\"" << first.words << "\" (view " << first.view << ") and \"" << second.words << "\" (view "
                        << second.view << ") at (" << second.box.x << ", " << second.box.y << ")");
      }
    }
  });
}

TEST_CASE("What a step makes is named on the picture") {
  const auto fonts = Fonts::load();
  REQUIRE(fonts);
  for_each_step<double>([&](const auto& lesson, std::uint32_t step) {
    View view = lesson.scenes.viewport(step, 560, 420);
    std::erase_if(view.labels, [](const Label& label) { return label.optional; });
    std::size_t letters = 0;
    for (const auto& label : view.labels) letters += plain_text(label.text).size();
    Scene scene;
    scene.width = 560, scene.height = 420;
    scene.views.push_back(std::move(view));
    TextRecorder canvas(**fonts);
    paint(scene, light_theme(), **fonts, canvas, 1);
    std::size_t painted = 0;
    for (const auto& text : canvas.texts) painted += text.words.size();
    CHECK(painted == letters);
  });
}
