#pragma once
// An OpenGL context without a window or a display. Drawing goes to framebuffer objects.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"

namespace blossom {

class HeadlessContext {
 public:
  HeadlessContext() = default;
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;
  virtual ~HeadlessContext() = default;

  virtual bool make_current() = 0;  // for this thread
  virtual void (*address_of(const char* function) const)() = 0;
  virtual bool is_es() const = 0;  // OpenGL ES 3.0; otherwise OpenGL 3.3 core
};

// "osmesa": Mesa's off-screen interface, OpenGL 3.3 core; the default. "egl": EGL without a surface, OpenGL ES 3.0, for
// systems whose Mesa no longer has OSMesa (since 25.1).
std::vector<std::string> headless_context_names();
Checked<std::unique_ptr<HeadlessContext>> make_headless_context(std::string_view name = "osmesa");

// One per file.
Checked<std::unique_ptr<HeadlessContext>> make_osmesa_context();
Checked<std::unique_ptr<HeadlessContext>> make_egl_context();

}  // namespace blossom
