#include "render/headless_context.hpp"

namespace blossom {

std::vector<std::string> headless_context_names() { return {"osmesa", "egl"}; }

Checked<std::unique_ptr<HeadlessContext>> make_headless_context(std::string_view name) {
  if (name == "osmesa") return make_osmesa_context();
  if (name == "egl") return make_egl_context();
  return Diagnostics{
      {"", 0, 0, "", "there is no OpenGL context \"" + std::string(name) + "\"; the kinds are osmesa and egl"}};
}

}  // namespace blossom
