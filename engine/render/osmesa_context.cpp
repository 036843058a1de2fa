#include <GL/osmesa.h>

#include <array>
#include <cstdint>

#include "render/headless_context.hpp"

namespace blossom {
namespace {

class OsMesaContext final : public HeadlessContext {
 public:
  explicit OsMesaContext(OSMesaContext context) : context_(context) {}
  ~OsMesaContext() override { OSMesaDestroyContext(context_); }

  bool make_current() override {
    return OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, size, size) == GL_TRUE;
  }
  void (*address_of(const char* function) const)() override { return OSMesaGetProcAddress(function); }
  bool is_es() const override { return false; }

 private:
  static constexpr int size = 4;  // OSMesa insists on a buffer of its own; nothing is drawn there
  OSMesaContext context_;
  std::array<std::uint8_t, 4 * size * size> buffer_{};
};

}  // namespace

Checked<std::unique_ptr<HeadlessContext>> make_osmesa_context() {
  constexpr std::array<int, 13> attributes = {OSMESA_FORMAT,
                                              OSMESA_RGBA,
                                              OSMESA_DEPTH_BITS,
                                              0,
                                              OSMESA_STENCIL_BITS,
                                              0,
                                              OSMESA_PROFILE,
                                              OSMESA_CORE_PROFILE,
                                              OSMESA_CONTEXT_MAJOR_VERSION,
                                              3,
                                              OSMESA_CONTEXT_MINOR_VERSION,
                                              3,
                                              0};
  OSMesaContext context = OSMesaCreateContextAttribs(attributes.data(), nullptr);
  if (context == nullptr) {
    return Diagnostics{{"", 0, 0, "", "OSMesa makes no OpenGL 3.3 context; install the package libosmesa6"}};
  }
  auto result = std::make_unique<OsMesaContext>(context);
  if (!result->make_current()) return Diagnostics{{"", 0, 0, "", "OSMesa does not make its context current"}};
  return std::unique_ptr<HeadlessContext>(std::move(result));
}

}  // namespace blossom
