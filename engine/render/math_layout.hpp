#pragma once
// Formulas set in two dimensions, after the rules of Knuth, The TeXbook, appendix G, with the measures of DejaVu Sans:
// letters and signs as glyphs, bars, roots and tall fences as lines. In pixels, from the start of the formula's
// baseline, y down.

#include <vector>

#include "render/font.hpp"

namespace blossom {

// What is drawn beside the letters, in their colour.
struct TextBar {  // a filled rectangle
  double x = 0, y = 0, width = 0, height = 0;
};
struct TextStroke {  // with round joins and caps
  struct Point {
    double x = 0, y = 0;
  };
  std::vector<Point> points;
  double width = 0;
};

struct MathBox {
  std::vector<GlyphRun> runs;
  std::vector<TextBar> bars;
  std::vector<TextStroke> strokes;
  double width = 0;
  double height = 0, depth = 0;  // above and below the baseline
};

// `display`: as on a line of its own, with tall fractions and with limits above and below their operators.
MathBox lay_out(const Fonts&, const Math&, double size, bool display, bool bold = false);

}  // namespace blossom
