#pragma once
// Compiles and links the canvas's programs.

#include <array>

#include "base/diagnostics.hpp"
#include "render/gl_functions.hpp"
#include "render/gl_shaders.hpp"

namespace blossom {

struct ProgramSource {
  const char* name;
  const char* vertex;
  const char* fragment;
};

// In the order of GlCanvas::Program.
inline constexpr std::array<ProgramSource, 5> program_sources = {{
    {"triangle", shaders::triangle_vertex, shaders::triangle_fragment},
    {"stroke", shaders::stroke_vertex, shaders::stroke_fragment},
    {"marker", shaders::marker_vertex, shaders::marker_fragment},
    {"glyph", shaders::glyph_vertex, shaders::glyph_fragment},
    {"image", shaders::image_vertex, shaders::image_fragment},
}};

// The diagnostic holds what the driver's compiler said.
Checked<GLuint> make_program(const GlFunctions&, bool is_es, const ProgramSource&);

}  // namespace blossom
