#pragma once
// The canvas that writes TikZ: one tikzpicture that stands in a LaTeX document whose preamble has TikzCanvas::preamble
// of the pictures' colours. Lines and points are \draw and \fill in page units (the picture's x and y, to be changed
// there), text is set by TeX: names as formulas, $P_{1}^{(2)}$, in the middle of the place that they have elsewhere.
// What hides what is decided by render/hidden.hpp.
//
// Compiling stays quick: lines keep the points that are seen (a tenth of a page unit), and two triangles with one edge
// in common are one face, drawn without TikZ's parser.

#include <memory>
#include <set>
#include <string>

#include "render/canvas.hpp"
#include "render/font.hpp"
#include "render/hidden.hpp"

namespace blossom {

class TikzCanvas final : public Canvas {
 public:
  TikzCanvas(std::shared_ptr<const Fonts>, double points_per_pixel);

  void begin(const Frame&) override;
  void begin_view(const PixelRect& clip, bool depth) override;
  void polyline(std::span<const PixelPoint>, bool closed, const Stroke&) override;
  void polygon(std::span<const PixelPoint>, Color) override;
  void marker(const PixelPoint&, Marker::Shape, const MarkerPaint&) override;
  void triangles(std::span<const PixelPoint>, std::span<const Color>, std::span<const std::uint32_t> indices,
                 double opacity) override;
  void text(std::span<const GlyphRun>, const TextPaint&) override;
  void finish() override;

  const std::string& picture() const { return out_; }  // after finish()

  using Colors = std::set<std::string>;             // RRGGBB
  const Colors& colors() const { return colors_; }  // that its pictures use, of all of them
  static std::string preamble(const Colors&);       // behind \usepackage{tikz}

 private:
  std::string color(Color);  // its name
  std::string options(const char* key, Color);
  std::string length(double pixels) const;
  void end_view();

  std::shared_ptr<const Fonts> fonts_;
  double points_;  // per pixel
  std::string out_;
  Colors colors_;
  bool in_view_ = false;
  DepthCells cells_;
};

// The runs of one call as lines of LaTeX, each with the place of its middle: letters with scripts are formulas.
struct LatexLine {
  std::string text;
  double x = 0, baseline = 0, size = 0;
};
std::vector<LatexLine> latex_lines(const Fonts&, std::span<const GlyphRun>);

}  // namespace blossom
