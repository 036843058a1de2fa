#pragma once
// The canvas that writes PDF, through cairo: every frame is a page. Lines, faces and letters stay vectors, and text can
// be searched and copied: its letters are shown from the font files of render/font.hpp, of which the file holds those
// that are used. The same frames give the same bytes, for the file has a fixed date. What hides what is decided by
// render/hidden.hpp.

#include <memory>
#include <string>

#include "render/canvas.hpp"
#include "render/font.hpp"
#include "render/hidden.hpp"

namespace blossom {

class CairoCanvas final : public Canvas {
 public:
  // A pixel of a frame is this many points (1/72 inch) on paper.
  static Checked<std::unique_ptr<CairoCanvas>> create(std::shared_ptr<const Fonts>, double points_per_pixel);
  ~CairoCanvas() override;

  void begin(const Frame&) override;  // the title of the first frame is the file's
  void begin_view(const PixelRect& clip, bool depth) override;
  void polyline(std::span<const PixelPoint>, bool closed, const Stroke&) override;
  void polygon(std::span<const PixelPoint>, Color) override;
  void marker(const PixelPoint&, Marker::Shape, const MarkerPaint&) override;
  void triangles(std::span<const PixelPoint>, std::span<const Color>, std::span<const std::uint32_t> indices,
                 double opacity) override;
  void text(std::span<const GlyphRun>, const TextPaint&) override;
  void finish() override;

  // An entry of the reader's table of contents, leading to this height of the page that is being painted.
  void bookmark(const std::string& title, double y);

  // The file, after the last finish().
  Checked<std::string> take() &&;

 private:
  struct Pdf;
  explicit CairoCanvas(std::unique_ptr<Pdf>);
  void path(std::span<const PixelPoint>, bool closed);
  void end_view();

  std::unique_ptr<Pdf> pdf_;
  bool in_view_ = false;
  DepthCells cells_;
};

}  // namespace blossom
