#pragma once
// The canvas that writes SVG 1.1. Text stays text, set run by run; the scene's title and description become <title> and
// <desc>. The same scene gives the same bytes. What hides what is decided by render/hidden.hpp.

#include <string>

#include "render/canvas.hpp"
#include "render/hidden.hpp"

namespace blossom {

class SvgCanvas final : public Canvas {
 public:
  void begin(const Frame&) override;
  void begin_view(const PixelRect& clip, bool depth) override;
  void polyline(std::span<const PixelPoint>, bool closed, const Stroke&) override;
  void polygon(std::span<const PixelPoint>, Color) override;
  void marker(const PixelPoint&, Marker::Shape, const MarkerPaint&) override;
  void triangles(std::span<const PixelPoint>, std::span<const Color>, std::span<const std::uint32_t> indices,
                 double opacity) override;
  void text(std::span<const GlyphRun>, const TextPaint&) override;
  void finish() override;

  std::string take() && { return std::move(out_); }  // the file, after finish()

 private:
  void path(std::span<const PixelPoint>, bool closed, const Stroke&);
  void runs(std::span<const GlyphRun>);
  void end_view();

  std::string out_;
  Frame frame_;
  int views_ = 0;
  bool in_view_ = false;
  DepthCells cells_;
};

}  // namespace blossom
