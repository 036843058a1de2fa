#include "render/gl_functions.hpp"

#include <string>

namespace blossom {

Checked<GlFunctions> load_gl_functions(const GlLoader& loader) {
  GlFunctions gl;
  Diagnostics missing;
  const auto load = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(loader(name));
    if (function == nullptr) {
      missing.push_back(
          {"", 0, 0, "", std::string("this OpenGL has no ") + name + "; version 3.3, or OpenGL ES 3.0, is needed"});
    }
  };
#define BLOSSOM_GL_LOAD(type, name) load(gl.name, "gl" #name);
  BLOSSOM_GL_FUNCTIONS(BLOSSOM_GL_LOAD)
#undef BLOSSOM_GL_LOAD
  if (!missing.empty()) return missing;
  return gl;
}

}  // namespace blossom
