// What a window asks of the OpenGL canvas: a user interface's textured triangles between our own views, in one frame
// that goes to the window's framebuffer.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/demo_scene.hpp"
#include "render/gl_canvas.hpp"
#include "render/headless_context.hpp"
#include "render/painter.hpp"

using namespace blossom;

namespace {

constexpr Color white{255, 255, 255, 255}, red{255, 0, 0, 255}, blue{0, 0, 255, 255}, green{0, 255, 0, 255};

struct Easel {
  std::unique_ptr<HeadlessContext> context;
  GlFunctions gl;
  std::shared_ptr<const Fonts> fonts;
  std::unique_ptr<GlCanvas> canvas;

  explicit Easel(const std::string& name) {
    auto made = make_headless_context(name);
    if (!made) return;
    context = std::move(*made);
    const auto functions = load_gl_functions([&](const char* function) { return context->address_of(function); });
    REQUIRE(functions);
    gl = *functions;
    fonts = *Fonts::load();
    auto created = GlCanvas::create(gl, context->is_es(), fonts);
    REQUIRE(created);
    canvas = std::move(*created);
  }
  ~Easel() {
    if (context) context->make_current();
  }

  template <class Draw>
  Image picture(int width, int height, Draw&& draw) {
    REQUIRE(context->make_current());
    canvas->begin({width, height, white, {}, {}});
    draw(*canvas);
    canvas->finish();
    auto image = canvas->read();
    INFO(to_string(image.diagnostics));
    REQUIRE(image);
    return *image;
  }
};

// `body(easel)` under OpenGL 3.3 core and under OpenGL ES 3.0, where there is one.
template <class Body>
void on_every_context(Body&& body) {
  for (const auto& name : headless_context_names()) {
    INFO(name);
    Easel easel(name);
    if (easel.context) {
      body(easel);
    } else {
      WARN("not tested: no context " << name);
      REQUIRE(name != "osmesa");
    }
  }
}

void image_box(GlCanvas& canvas, const PixelRect& box, Color color, const PixelRect& clip) {
  const auto x0 = static_cast<float>(box.x), y0 = static_cast<float>(box.y), x1 = static_cast<float>(box.right()),
             y1 = static_cast<float>(box.bottom());
  const ImageVertex corners[] = {
      {x0, y0, 0, 0, color}, {x1, y0, 1, 0, color}, {x1, y1, 1, 1, color}, {x0, y1, 0, 1, color}};
  const std::uint16_t indices[] = {0, 1, 2, 0, 2, 3};
  canvas.image_triangles(corners, indices, clip);
}

void polygon_box(Canvas& canvas, float x0, float y0, float x1, float y1, Color color) {
  const PixelPoint corners[] = {{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}};
  canvas.polygon(corners, color);
}

void mesh_triangle(Canvas& canvas, std::array<PixelPoint, 3> corners, Color color) {
  const Color colors[] = {color, color, color};
  const std::uint32_t indices[] = {0, 1, 2};
  canvas.triangles(corners, colors, indices, 1);
}

constexpr PixelRect everywhere{0, 0, 1000, 1000};
constexpr std::uint8_t full[] = {255};

}  // namespace

TEST_CASE("Image triangles have the vertices' colour, as opaque as the texture says") {
  on_every_context([](Easel& easel) {
    const std::uint8_t coverage[] = {0, 51, 102, 255, 255, 204, 153, 0};
    easel.canvas->set_texture(4, 2, coverage);
    for (const int alpha : {255, 128}) {
      const Color color{255, 0, 0, static_cast<std::uint8_t>(alpha)};
      const Image image = easel.picture(20, 20, [&](GlCanvas& c) { image_box(c, {10, 12, 4, 2}, color, everywhere); });
      for (int i = 0; i < 8; ++i) {
        const Color pixel = image.at(10 + i % 4, 12 + i / 4);
        INFO("texel " << i << ", alpha " << alpha);
        CHECK(pixel.r == 255);
        CHECK(std::abs(pixel.g - (255 - coverage[i] * alpha / 255)) <= 1);
      }
      CHECK(image.at(9, 12) == white);
      CHECK(image.at(14, 13) == white);
      CHECK(image.at(13, 11) == white);
      CHECK(image.at(10, 14) == white);
    }
    SECTION("between texels it is interpolated") {
      const std::uint8_t ramp[] = {0, 255};
      easel.canvas->set_texture(2, 1, ramp);
      const Image image = easel.picture(100, 4, [](GlCanvas& c) { image_box(c, {0, 0, 100, 4}, red, everywhere); });
      CHECK(image.at(10, 2) == white);
      CHECK(std::abs(image.at(50, 2).g - 128) <= 3);
      CHECK(image.at(90, 2) == red);
    }
    SECTION("and full before there is any texture") {
      Easel fresh(easel.context->is_es() ? "egl" : "osmesa");
      const Image image = fresh.picture(8, 8, [](GlCanvas& c) { image_box(c, {0, 0, 8, 8}, red, everywhere); });
      CHECK(image.at(4, 4) == red);
    }
  });
}

TEST_CASE("Calls that share vertices draw their own triangles") {
  on_every_context([](Easel& easel) {
    easel.canvas->set_texture(1, 1, full);
    const auto corner = [](float x, float y, Color color) { return ImageVertex{x, y, 0, 0, color}; };
    const ImageVertex shared[] = {corner(0, 0, red),    corner(20, 0, red),   corner(0, 20, red),
                                  corner(40, 40, blue), corner(20, 40, blue), corner(40, 20, blue)};
    const std::uint16_t first[] = {0, 1, 2}, second[] = {5, 4, 3};
    const Image image = easel.picture(40, 40, [&](GlCanvas& c) {
      c.image_triangles(shared, second, everywhere);
      polygon_box(c, 18, 18, 22, 22, green);
      c.image_triangles(shared, first, everywhere);
      c.image_triangles(shared, second, {0, 0, 40, 30});
    });
    CHECK(image.at(3, 3) == red);
    CHECK(image.at(36, 36) == blue);
    CHECK(image.at(20, 20) == green);
    CHECK(image.at(36, 3) == white);
  });
}

TEST_CASE("Image triangles are cut to their own box, and leave the view's alone") {
  on_every_context([](Easel& easel) {
    easel.canvas->set_texture(1, 1, full);
    const Image image = easel.picture(40, 30, [](GlCanvas& c) {
      c.begin_view({20, 0, 10, 30}, false);
      image_box(c, {0, 0, 40, 30}, red, {5, 6, 10, 8});
      image_box(c, {0, 0, 40, 30}, red, {50, 6, 10, 8});  // outside of the frame
      polygon_box(c, 0, 20, 40, 30, blue);                // in the view
    });
    for (int y = 0; y < 30; ++y) {
      for (int x = 0; x < 40; ++x) {
        const bool in_clip = x >= 5 && x < 15 && y >= 6 && y < 14, in_view = x >= 20 && x < 30 && y >= 20;
        INFO(x << ", " << y);
        CHECK(image.at(x, y) == (in_clip ? red : in_view ? blue : white));
      }
    }
  });
}

TEST_CASE("Polygons, text and image triangles are painted in the order of the calls") {
  on_every_context([](Easel& easel) {
    easel.canvas->set_texture(1, 1, full);
    const GlyphRun block{"\u2588", 2, 24, 14, {}};  // a full block: ink all over
    const Image image = easel.picture(40, 40, [&](GlCanvas& c) {
      polygon_box(c, 0, 0, 40, 10, red);
      image_box(c, {10, 0, 30, 40}, blue, everywhere);
      polygon_box(c, 20, 0, 40, 10, green);
      image_box(c, {30, 0, 10, 10}, red, everywhere);
      c.text({&block, 1}, {green, white, 0});
      image_box(c, {0, 22, 40, 5}, red, everywhere);
    });
    CHECK(image.at(5, 5) == red);
    CHECK(image.at(15, 38) == blue);
    CHECK(image.at(25, 5) == green);
    CHECK(image.at(35, 5) == red);
    CHECK(image.at(6, 20) == green);
    CHECK(image.at(6, 23) == red);
    CHECK(image.at(15, 23) == red);
  });
}

TEST_CASE("Around a mesh everything is painted in order, and image triangles know no depth") {
  on_every_context([](Easel& easel) {
    easel.canvas->set_texture(1, 1, full);
    const PixelPoint behind[] = {{0, 35, .9f}, {60, 35, .9f}}, before[] = {{0, 45, .1f}, {60, 45, .1f}};
    const Image image = easel.picture(80, 60, [&](GlCanvas& c) {
      polygon_box(c, 0, 0, 80, 60, green);              // under the mesh and around it
      image_box(c, {40, 0, 10, 60}, blue, everywhere);  // likewise
      c.begin_view({0, 0, 60, 60}, true);
      mesh_triangle(c, {{{10, 10, .5f}, {10, 55, .5f}, {55, 55, .5f}}}, red);
      image_box(c, {0, 50, 80, 4}, blue, everywhere);  // over the mesh and beyond the view
      c.polyline(behind, false, {white, 4, 0, 0});     // the view goes on: hidden by the mesh
      c.polyline(before, false, {white, 4, 0, 0});
      c.begin_view({60, 0, 20, 60}, true);
      mesh_triangle(c, {{{50, 0, .5f}, {100, 0, .5f}, {75, 20, .5f}}}, red);  // a second view with a mesh
      image_box(c, {62, 0, 6, 3}, blue, everywhere);
    });
    CHECK(image.at(30, 12) == green);  // in the box around the mesh, not on it
    CHECK(image.at(45, 12) == blue);
    CHECK(image.at(20, 40) == red);
    CHECK(image.at(20, 52) == blue);
    CHECK(image.at(75, 52) == blue);
    CHECK(image.at(20, 35) == red);
    CHECK(image.at(5, 35) == white);
    CHECK(image.at(45, 35) == white);
    CHECK(image.at(20, 45) == white);
    CHECK(image.at(58, 45) == white);
    CHECK(image.at(62, 45) == green);
    CHECK(image.at(75, 5) == red);
    CHECK(image.at(58, 2) == green);
    CHECK(image.at(64, 1) == blue);
    // The slanted edge is smooth: some pixels are neither the mesh's nor the ground's.
    int mixed = 0;
    for (int y = 14; y < 30; ++y) {
      const Color pixel = image.at(y, y);
      mixed += pixel.r > 40 && pixel.r < 215 && pixel.g > 40 && pixel.g < 215;
    }
    CHECK(mixed > 10);
  });
}

TEST_CASE("A presented frame is the frame, the right way up") {
  on_every_context([](Easel& easel) {
    const Image frame = easel.picture(64, 40, [](GlCanvas& c) {
      polygon_box(c, 0, 0, 20, 10, red);
      c.begin_view({30, 5, 30, 30}, true);
      mesh_triangle(c, {{{30, 5, .5f}, {60, 5, .5f}, {45, 35, .5f}}}, blue);
    });
    REQUIRE(frame.at(3, 3) == red);
    const auto& gl = easel.gl;
    for (const int factor : {1, 2}) {
      INFO("factor " << factor);
      const int width = 64 * factor, height = 40 * factor;
      GLuint framebuffer = 0, color = 0;
      gl.GenFramebuffers(1, &framebuffer);
      gl.GenRenderbuffers(1, &color);
      gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
      gl.BindRenderbuffer(GL_RENDERBUFFER, color);
      gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
      gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
      gl.Scissor(0, 0, 1, 1);
      gl.Enable(GL_SCISSOR_TEST);  // whatever others have left behind
      easel.canvas->present(framebuffer, width, height);
      Image window(width, height);
      gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
      gl.ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, window.pixels.data());
      CHECK(gl.GetError() == GL_NO_ERROR);
      int differing = 0;
      for (int y = 0; y < height; ++y) {
        // OpenGL's first row is the window's lowest.
        for (int x = 0; x < width; ++x) {
          if (factor == 1) differing += window.at(x, height - 1 - y) != frame.at(x, y);
        }
      }
      CHECK(differing == 0);
      CHECK(window.at(3 * factor, height - 1 - 3 * factor) == red);
      CHECK(window.at(3 * factor, 3 * factor) == white);
      gl.DeleteFramebuffers(1, &framebuffer);
      gl.DeleteRenderbuffers(1, &color);
    }
    CHECK(*easel.canvas->read() == frame);  // it is still there
  });
}

TEST_CASE("A view painted at an origin looks as on a page at that place") {
  on_every_context([](Easel& easel) {
    const Theme& theme = light_theme();
    for (const double scale : {1.0, 1.5, 2.0}) {
      for (const View& view : demo_scene().views) {
        Scene page;
        page.width = 1200, page.height = 900;
        page.views = {view};
        page.views[0].x += 124, page.views[0].y += 86;
        const auto frame = frame_of(page, theme, scale);
        REQUIRE(frame);
        const glm::dvec2 origin{124 * scale, 86 * scale};
        REQUIRE(easel.context->make_current());
        paint(page, theme, *easel.fonts, *easel.canvas, scale);
        const auto expected = easel.canvas->read();
        REQUIRE(expected);
        for (const double off : {0.0, 0.4, -0.4}) {
          const Image here = easel.picture(frame->width, frame->height, [&](GlCanvas& c) {
            paint_view(view, theme, *easel.fonts, c, scale, origin + off, {0, 0, 1200 * scale, 900 * scale});
          });
          INFO("scale " << scale << ", view at " << view.x << ", " << view.y << ", off by " << off);
          // A letter exactly between two quarters of a pixel may fall to either.
          CHECK(difference(*expected, here).mean < 0.002);
        }
      }
    }
  });
}

TEST_CASE("A view is cut to the clip it is painted with, and to its own rectangle when it clips") {
  on_every_context([](Easel& easel) {
    Theme theme = light_theme();
    theme.roles[static_cast<std::size_t>(Role::current)].color = red;
    View view;
    view.x = 10, view.y = 20, view.width = 30, view.height = 20;  // page camera: x right, y down, from its top left
    view.polygons.push_back({{{-50, -50, 0}, {90, -50, 0}, {90, 90, 0}, {-50, 90, 0}}, Role::current, 1});
    for (const bool own : {true, false}) {
      view.clip = own;
      const Image image = easel.picture(100, 80, [&](GlCanvas& c) {
        polygon_box(c, 0, 0, 100, 80, white);
        paint_view(view, theme, *easel.fonts, c, 2, {6, 4}, {30, 10, 40, 60});
        image_box(c, {0, 0, 100, 5}, blue, everywhere);
      });
      // The view's rectangle is (26, 44) to (86, 84) in pixels.
      for (int y = 0; y < 80; ++y) {
        for (int x = 0; x < 100; ++x) {
          const bool inside = x >= 30 && x < 70 && y >= (own ? 44 : 10) && y < 70;
          INFO(x << ", " << y << ", own " << own);
          CHECK(image.at(x, y) == (y < 5 ? blue : inside ? red : white));
        }
      }
    }
  });
}
