#include "render/picture.hpp"

#include <map>
#include <memory>

#include "render/gl_canvas.hpp"
#include "render/headless_context.hpp"
#include "render/painter.hpp"
#include "render/svg_canvas.hpp"

namespace blossom {
namespace {

struct Studio {
  std::unique_ptr<HeadlessContext> context;
  std::unique_ptr<GlCanvas> canvas;

  ~Studio() {
    if (context) context->make_current();  // the canvas frees what it has in its own context
    canvas.reset();
  }
  Studio() = default;
  Studio(Studio&&) noexcept = default;
  Studio& operator=(Studio&&) noexcept = default;
};

Checked<std::shared_ptr<const Fonts>> thread_fonts() {
  thread_local std::shared_ptr<const Fonts> fonts;
  if (!fonts) {
    auto loaded = Fonts::load();
    if (!loaded) return loaded;
    fonts = *loaded;
  }
  return fonts;
}

Checked<Studio> open_studio(std::string_view context_name, std::shared_ptr<const Fonts> fonts) {
  Studio studio;
  auto context = make_headless_context(context_name);
  if (!context) return context.diagnostics;
  studio.context = std::move(*context);
  const auto gl = load_gl_functions([&](const char* name) { return studio.context->address_of(name); });
  if (!gl) return gl.diagnostics;
  auto canvas = GlCanvas::create(*gl, studio.context->is_es(), std::move(fonts));
  if (!canvas) return canvas.diagnostics;
  studio.canvas = std::move(*canvas);
  return studio;
}

}  // namespace

Checked<Image> draw_image(const Scene& scene, const Theme& theme, double scale, std::string_view context) {
  const auto fonts = thread_fonts();
  if (!fonts) return fonts.diagnostics;
  thread_local std::map<std::string, Studio, std::less<>> studios;
  auto found = studios.find(context);
  if (found == studios.end()) {
    auto studio = open_studio(context, *fonts);
    if (!studio) return studio.diagnostics;
    found = studios.emplace(context, std::move(*studio)).first;
  }
  Studio& studio = found->second;
  if (!studio.context->make_current()) {
    return Diagnostics{{"", 0, 0, "", "the OpenGL context \"" + std::string(context) + "\" does not become current"}};
  }
  if (const auto frame = frame_of(scene, theme, scale, studio.canvas->max_size()); !frame) return frame.diagnostics;
  paint(scene, theme, **fonts, *studio.canvas, scale);
  return studio.canvas->read();
}

Checked<std::string> draw_svg(const Scene& scene, const Theme& theme) {
  const auto fonts = thread_fonts();
  if (!fonts) return fonts.diagnostics;
  if (const auto frame = frame_of(scene, theme, 1); !frame) return frame.diagnostics;
  SvgCanvas canvas;
  paint(scene, theme, **fonts, canvas, 1);
  return std::move(canvas).take();
}

}  // namespace blossom
