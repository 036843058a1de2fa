#pragma once
// Rich text set into lines: runs with their places relative to the start of the first baseline (y down).

#include <vector>

#include "render/math_layout.hpp"

namespace blossom {

struct TextBlock {
  std::vector<GlyphRun> runs;
  std::vector<TextBar> bars;        // of formulas
  std::vector<TextStroke> strokes;  // likewise
  double left = 0, width = 0;       // the widest line's extent; left is negative unless the alignment is left
  double top = 0, bottom = 0;       // extent about the first baseline: top < 0 < bottom
};

enum class TextAlign { left, centre, right };

// Sub- and superscripts are set at 0.7 of the size, lowered and raised; a superscript directly after a subscript (or
// the other way round) stands above it, at the same base: P with 4 and (1). Lines break at '\n' and, when max_width >
// 0, at blanks; a word longer than a line is broken where it must, and begins below the line's last tab, if it has one.
// Lines are 1.4 sizes apart, or more where a formula is higher. A formula is one word, which is never broken; what
// stands beside it without a blank stays at its side.
TextBlock set_text(const Fonts&, const RichText&, double size, TextAlign, double max_width = 0);

// The block moved and then scaled about the origin: how it is painted.
TextBlock placed(TextBlock, double dx, double dy, double scale = 1);
// Paints it: the halo of everything first, if there is one.
void paint_text(Canvas&, const TextBlock&, const TextPaint&);

}  // namespace blossom
