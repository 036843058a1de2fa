#pragma once
// Where pictures are drawn, in pixels: x right, y down, from the top left corner of the frame. A canvas knows nothing
// of worlds, roles or themes; the painter has turned them into positions, colours and widths. Things are painted in the
// order of the calls.
//
// Depth: 0 is nearest, 1 farthest. In a view with depth, triangles hide what is drawn later behind them; lines,
// markers and polygons are hidden by triangles and hide nothing; text is never hidden.

#include <cstdint>
#include <span>
#include <string>

#include "scene/display_list.hpp"

namespace blossom {

struct Color {  // sRGB, not premultiplied
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Color&) const = default;
};

struct PixelPoint {
  float x = 0, y = 0, depth = 0;
};

struct PixelRect {
  double x = 0, y = 0, width = 0, height = 0;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
};

struct Frame {
  int width = 0, height = 0;  // pixels
  Color background;
  std::string title, description;  // for screen readers and file metadata
};

struct Stroke {  // round joins, round caps
  Color color;
  float width = 1;
  float dash = 0, gap = 0;  // lengths of ink and of pause, caps not counted; gap 0: solid
};

struct MarkerPaint {
  float radius = 4;  // of the disc of the same visual weight
  Color fill;
  Color outline;
  float outline_width = 0;  // around the fill, outside of it
};

struct FontStyle {
  bool bold = false, italic = false, monospace = false;
  bool operator==(const FontStyle&) const = default;
};

struct GlyphRun {  // UTF-8 on one baseline in one style
  std::string text;
  double x = 0, baseline = 0;
  double size = 0;  // of the em
  FontStyle style;
};

struct TextPaint {
  Color color;
  Color halo;
  float halo_width = 0;  // how far the halo reaches around the letters
};

class Canvas {
 public:
  Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  virtual ~Canvas() = default;

  virtual void begin(const Frame&) = 0;
  // Until the next begin_view: nothing is painted outside of the rectangle; with `depth`, a fresh depth buffer.
  virtual void begin_view(const PixelRect& clip, bool depth) = 0;
  virtual void polyline(std::span<const PixelPoint>, bool closed, const Stroke&) = 0;
  virtual void polygon(std::span<const PixelPoint>, Color) = 0;  // convex
  virtual void marker(const PixelPoint&, Marker::Shape, const MarkerPaint&) = 0;
  // A colour per vertex, three indices per triangle. Opacity < 1: only the nearest layer of these triangles is seen,
  // and what lies behind shines through.
  virtual void triangles(std::span<const PixelPoint>, std::span<const Color>, std::span<const std::uint32_t> indices,
                         double opacity) = 0;
  virtual void text(std::span<const GlyphRun>, const TextPaint&) = 0;  // all halos first, then the letters
  virtual void finish() = 0;
};

}  // namespace blossom
