#pragma once
// A dashed line as the pieces of it that carry ink, for canvases that only know solid lines.

#include <span>
#include <vector>

#include "render/canvas.hpp"

namespace blossom {

// Pieces of length `dash` with pauses of length `gap`, measured along the line in pixels, starting with ink.
// Precondition: dash >= 0, gap > 0. Periods shorter than a pixel are stretched to one.
std::vector<std::vector<PixelPoint>> split_dashes(std::span<const PixelPoint>, bool closed, float dash, float gap);

}  // namespace blossom
