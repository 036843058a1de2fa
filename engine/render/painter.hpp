#pragma once
// Paints a scene: each view's camera takes world to pixels, the theme takes roles to looks, the labels find their
// places. Whatever a scene holds (NaN, infinities, points at 1e300, empty lists, indices out of range), what can be
// drawn is drawn and the rest is left out.

#include "render/canvas.hpp"
#include "render/font.hpp"
#include "render/theme.hpp"
#include "scene/display_list.hpp"

namespace blossom {

// Of a frame that a scene fills: page units times scale, rounded. A diagnostic when the page is not between 1 pixel and
// `largest` pixels wide and high, or more than 64 million pixels.
Checked<Frame> frame_of(const Scene&, const Theme&, double scale, int largest = 16384);

// Precondition: frame_of(scene, theme, scale) is a frame.
void paint(const Scene&, const Theme&, const Fonts&, Canvas&, double scale);

}  // namespace blossom
