#pragma once
// The front door: a scene in, a picture out.

#include <string>
#include <string_view>

#include "render/image.hpp"
#include "render/theme.hpp"
#include "scene/display_list.hpp"

namespace blossom {

// Pixels are page units times scale. The same scene gives the same bytes. The OpenGL context, its programs and the
// glyphs are made at a thread's first picture and kept for its next ones; `context` is a name of
// headless_context_names().
Checked<Image> draw_image(const Scene&, const Theme&, double scale = 1, std::string_view context = "osmesa");

// A whole SVG file, one pixel per page unit.
Checked<std::string> draw_svg(const Scene&, const Theme&);

}  // namespace blossom
