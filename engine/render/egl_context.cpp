#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdlib>
#include <cstring>

#include "render/headless_context.hpp"

namespace blossom {
namespace {

class EglContext final : public HeadlessContext {
 public:
  EglContext(EGLDisplay display, EGLContext context) : display_(display), context_(context) {}
  ~EglContext() override {
    // The display is the process's own and may serve other contexts: it is left initialized.
    if (eglGetCurrentContext() == context_) {
      eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display_, context_);
  }

  bool make_current() override {
    return eglBindAPI(EGL_OPENGL_ES_API) == EGL_TRUE &&
           eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
  }
  void (*address_of(const char* function) const)() override { return eglGetProcAddress(function); }
  bool is_es() const override { return true; }

 private:
  EGLDisplay display_;
  EGLContext context_;
};

Checked<std::unique_ptr<HeadlessContext>> failure(const std::string& what) {
  return Diagnostics{{"", 0, 0, "", "EGL " + what + "; install the package libegl-mesa0"}};
}

bool has_extension(const char* extensions, const char* name) {
  return extensions != nullptr && std::strstr(extensions, name) != nullptr;
}

}  // namespace

Checked<std::unique_ptr<HeadlessContext>> make_egl_context() {
  setenv("EGL_LOG_LEVEL", "fatal", /*overwrite=*/0);  // Mesa's warnings go to standard error otherwise
  if (!has_extension(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless")) {
    return failure("has no platform without a surface");
  }
  const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE) {
    return failure("cannot be started without a surface");
  }
  if (!has_extension(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
    return failure("has no contexts without a surface");
  }
  constexpr std::array<EGLint, 5> wanted = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
  constexpr std::array<EGLint, 5> version = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint configs = 0;
  if (eglBindAPI(EGL_OPENGL_ES_API) != EGL_TRUE ||
      eglChooseConfig(display, wanted.data(), &config, 1, &configs) != EGL_TRUE || configs == 0) {
    return failure("knows no OpenGL ES 3.0");
  }
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
  if (context == EGL_NO_CONTEXT) return failure("makes no OpenGL ES 3.0 context");
  auto result = std::make_unique<EglContext>(display, context);
  if (!result->make_current()) return failure("does not make its context current");
  return std::unique_ptr<HeadlessContext>(std::move(result));
}

}  // namespace blossom
