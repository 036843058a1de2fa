// What the OpenGL canvas puts on which pixels.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

#include "render/dash.hpp"
#include "render/gl_canvas.hpp"
#include "render/headless_context.hpp"

using namespace blossom;

namespace {

constexpr Color white{255, 255, 255, 255}, red{255, 0, 0, 255}, blue{0, 0, 255, 255}, green{0, 255, 0, 255};

// One context and canvas for all tests of this file: a frame must not depend on the frames before it.
struct Easel {
  std::unique_ptr<HeadlessContext> context;
  std::unique_ptr<GlCanvas> canvas;

  Easel() {
    auto made = make_headless_context("osmesa");
    REQUIRE(made);
    context = std::move(*made);
    const auto gl = load_gl_functions([&](const char* name) { return context->address_of(name); });
    REQUIRE(gl);
    auto created = GlCanvas::create(*gl, context->is_es(), *Fonts::load());
    REQUIRE(created);
    canvas = std::move(*created);
  }
};

template <class Draw>
Image picture(int width, int height, Draw&& draw, bool depth = false) {
  static Easel easel;
  REQUIRE(easel.context->make_current());
  easel.canvas->begin({width, height, white, {}, {}});
  easel.canvas->begin_view({0, 0, double(width), double(height)}, depth);
  draw(*easel.canvas);
  easel.canvas->finish();
  auto image = easel.canvas->read();
  REQUIRE(image);
  return *image;
}

// How much red there is, in pixels, on a white ground.
double redness(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) sum += (255 - image.at(x, y).g) / 255.0;
  }
  return sum;
}

}  // namespace

TEST_CASE("A red line five pixels wide covers five pixels, with smooth edges") {
  SECTION("on the raster: exactly") {
    const PixelPoint line[] = {{10, 20.5, 0}, {50, 20.5, 0}};
    const Image image = picture(60, 40, [&](Canvas& c) { c.polyline(line, false, {red, 5, 0, 0}); });
    for (int y = 0; y < 40; ++y) CHECK(image.at(30, y) == (y >= 18 && y <= 22 ? red : white));
    CHECK(image.at(4, 20) == white);
    CHECK(image.at(55, 20) == white);
    CHECK(image.at(8, 20) == red);  // the round cap
  }
  SECTION("between: its edges are half covered") {
    const PixelPoint line[] = {{10, 20, 0}, {50, 20, 0}};
    const Image image = picture(60, 40, [&](Canvas& c) { c.polyline(line, false, {red, 5, 0, 0}); });
    for (const int y : {17, 22}) {
      CHECK(std::abs(image.at(30, y).g - 128) <= 1);
      CHECK(image.at(30, y).r == 255);
    }
    for (int y = 18; y < 22; ++y) CHECK(image.at(30, y) == red);
  }
  SECTION("at a slant: its area is its length times its width") {
    const PixelPoint line[] = {{12, 17, 0}, {83, 66, 0}};
    const Image image = picture(100, 90, [&](Canvas& c) { c.polyline(line, false, {red, 5, 0, 0}); });
    CHECK(redness(image) == Approx(std::hypot(71, 49) * 5 + 3.14159 * 2.5 * 2.5).epsilon(0.01));
  }
}

TEST_CASE("A line of many short segments looks like the same line of one") {
  const PixelPoint one[] = {{12, 17, 0}, {83, 66, 0}};
  std::vector<PixelPoint> many;
  for (int i = 0; i <= 200; ++i) {
    const float t = static_cast<float>(i) / 200;
    many.push_back({12 + 71 * t, 17 + 49 * t, 0});
  }
  const Color translucent{255, 0, 0, 128};
  const auto draw = [&](std::span<const PixelPoint> line) {
    return picture(100, 90, [&](Canvas& c) { c.polyline(line, false, {translucent, 6, 0, 0}); });
  };
  CHECK(difference(draw(one), draw(many)).max <= 2);
}

TEST_CASE("A closed line is closed, and a line of one place is a dot") {
  const PixelPoint corners[] = {{10.5, 10.5, 0}, {30.5, 10.5, 0}, {30.5, 30.5, 0}, {10.5, 30.5, 0}};
  const Image closed = picture(40, 40, [&](Canvas& c) { c.polyline(corners, true, {red, 3, 0, 0}); });
  const Image open = picture(40, 40, [&](Canvas& c) { c.polyline(corners, false, {red, 3, 0, 0}); });
  CHECK(closed.at(10, 20) == red);
  CHECK(open.at(10, 20) == white);
  const PixelPoint twice[] = {{20, 20, 0}, {20, 20, 0}};
  CHECK(redness(picture(40, 40, [&](Canvas& c) {
          c.polyline(twice, false, {red, 8, 0, 0});
        })) == Approx(3.14159 * 16).epsilon(0.03));
}

TEST_CASE("Dashes and pauses have their lengths") {
  const PixelPoint line[] = {{0, 5, 0}, {40, 5, 0}, {100, 5, 0}};
  const auto pieces = split_dashes(line, false, 10, 5);
  REQUIRE(pieces.size() == 7);
  for (std::size_t i = 0; i < 6; ++i) {
    CHECK(pieces[i].front().x == Approx(15.0 * static_cast<double>(i)));
    CHECK(pieces[i].back().x == Approx(15.0 * static_cast<double>(i) + 10));
  }
  CHECK(pieces[6].back().x == Approx(100));
  const Image image = picture(100, 10, [&](Canvas& c) { c.polyline(line, false, {red, 2, 10, 8}); });
  CHECK(image.at(5, 5).g == 0);
  CHECK(image.at(14, 5) == white);
  CHECK(image.at(22, 5).g == 0);
}

TEST_CASE("Each marker shape has its own outline, and comparable weight") {
  const auto draw = [](Marker::Shape shape) {
    return picture(60, 60, [&](Canvas& c) { c.marker({30, 30, 0}, shape, {12, red, white, 0}); });
  };
  using Shape = Marker::Shape;
  const Shape shapes[] = {Shape::disc, Shape::ring, Shape::square, Shape::diamond, Shape::triangle, Shape::cross};
  for (const Shape a : shapes) {
    const double area = redness(draw(a));
    INFO("shape " << static_cast<int>(a) << " covers " << area);
    CHECK(area > 200);
    CHECK(area < 500);
    for (const Shape b : shapes) {
      if (a != b) CHECK(difference(draw(a), draw(b)).mean > 2);
    }
  }
  CHECK(redness(draw(Shape::disc)) == Approx(3.14159 * 144).epsilon(0.01));
  CHECK(redness(draw(Shape::square)) == Approx(std::pow(2 * 0.86 * 12, 2)).epsilon(0.01));
  CHECK(draw(Shape::ring).at(30, 30) == white);
  CHECK(draw(Shape::cross).at(30, 30) == red);
}

TEST_CASE("A marker's rim lies around its fill") {
  const Image image = picture(40, 40, [&](Canvas& c) {
    c.marker({20, 20, 0}, Marker::Shape::disc, {8, red, blue, 3});
  });
  CHECK(image.at(20, 20) == red);
  CHECK(image.at(29, 20) == blue);
  CHECK(image.at(33, 20) == white);
}

TEST_CASE("A polygon on the raster has crisp edges, a slanted one its area") {
  const PixelPoint box[] = {{10, 10, 0}, {30, 10, 0}, {30, 25, 0}, {10, 25, 0}};
  const Image image = picture(40, 40, [&](Canvas& c) { c.polygon(box, red); });
  CHECK(redness(image) == Approx(300));
  CHECK(image.at(10, 10) == red);
  CHECK(image.at(9, 10) == white);
  const PixelPoint kite[] = {{20, 3, 0}, {37, 20, 0}, {20, 37, 0}, {3, 20, 0}};
  CHECK(redness(picture(40, 40, [&](Canvas& c) { c.polygon(kite, red); })) == Approx(578).epsilon(0.02));
}

TEST_CASE("Triangles hide what is behind them, whatever the order") {
  const auto square = [](Canvas& c, float depth, Color color, double opacity = 1) {
    const PixelPoint corners[] = {{5, 5, depth}, {35, 5, depth}, {35, 35, depth}, {5, 35, depth}};
    const Color colors[] = {color, color, color, color};
    const std::uint32_t indices[] = {0, 1, 2, 0, 2, 3};
    c.triangles(corners, colors, indices, opacity);
  };
  const PixelPoint behind[] = {{0, 20.5, 0.9f}, {40, 20.5, 0.9f}}, before[] = {{0, 10.5, 0.1f}, {40, 10.5, 0.1f}};
  const Image image = picture(
      40, 40,
      [&](Canvas& c) {
        square(c, 0.5f, blue);
        square(c, 0.7f, red);
        c.polyline(behind, false, {green, 3, 0, 0});
        c.polyline(before, false, {green, 3, 0, 0});
      },
      true);
  CHECK(image.at(20, 30) == blue);
  CHECK(image.at(20, 20) == blue);
  CHECK(image.at(2, 20) == green);
  CHECK(image.at(20, 10) == green);
  SECTION("of translucent ones only the nearest layer is seen") {
    const Image veil = picture(
        40, 40,
        [&](Canvas& c) {
          const PixelPoint both[] = {{5, 5, .5f},  {35, 5, .5f},  {35, 35, .5f},  {5, 35, .5f},
                                     {5, 5, .25f}, {35, 5, .25f}, {35, 35, .25f}, {5, 35, .25f}};
          const Color colors[] = {red, red, red, red, blue, blue, blue, blue};
          const std::uint32_t indices[] = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
          c.triangles(both, colors, indices, 0.5);
        },
        true);
    CHECK(std::abs(veil.at(20, 20).r - 127) <= 1);
    CHECK(std::abs(veil.at(20, 20).g - 127) <= 1);
    CHECK(veil.at(20, 20).b == 255);
  }
}

TEST_CASE("Nothing is painted outside of a view") {
  static Easel easel;
  REQUIRE(easel.context->make_current());
  easel.canvas->begin({40, 40, white, {}, {}});
  easel.canvas->begin_view({10, 10, 20, 20}, false);
  const PixelPoint all[] = {{0, 0, 0}, {40, 0, 0}, {40, 40, 0}, {0, 40, 0}};
  easel.canvas->polygon(all, red);
  easel.canvas->finish();
  CHECK(redness(*easel.canvas->read()) == Approx(400));
}

TEST_CASE("Text is painted at its baseline, its halo below it") {
  const GlyphRun run{"H", 10, 30, 20, {}};
  const Image plain_text = picture(40, 40, [&](Canvas& c) { c.text({&run, 1}, {red, blue, 0}); });
  int lowest = 0, leftmost = 40;
  for (int y = 0; y < 40; ++y) {
    for (int x = 0; x < 40; ++x) {
      if (plain_text.at(x, y).g < 128) lowest = std::max(lowest, y), leftmost = std::min(leftmost, x);
    }
  }
  CHECK(lowest == 29);
  CHECK(std::abs(leftmost - 12) <= 1);
  const Image with_halo = picture(40, 40, [&](Canvas& c) { c.text({&run, 1}, {red, blue, 2}); });
  CHECK(with_halo.at(leftmost, 31).b > 200);
  CHECK(with_halo.at(leftmost, 31).r < 100);
}
