#pragma once
// The canvas that writes SVG 1.1. Text stays text, set run by run; the scene's title and description become <title> and
// <desc>. The same scene gives the same bytes. Depth: triangles are painted from back to front, and a depth buffer of
// one cell per pixel decides which parts of lines, and which markers, are hidden behind them.

#include <string>
#include <vector>

#include "render/canvas.hpp"

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
  bool hidden(float x, float y, float depth) const;
  void fill_depth(const PixelPoint&, const PixelPoint&, const PixelPoint&);
  void visible_parts(std::span<const PixelPoint>, const Stroke&);
  void path(std::span<const PixelPoint>, bool closed, const Stroke&);
  void runs(std::span<const GlyphRun>);
  void end_view();

  std::string out_;
  Frame frame_;
  int views_ = 0;
  bool in_view_ = false;
  bool depth_ = false;
  int left_ = 0, top_ = 0, columns_ = 0, rows_ = 0;  // of the depth buffer
  std::vector<float> nearest_;
};

}  // namespace blossom
