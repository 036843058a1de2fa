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

// One view into a frame that somebody else has begun. `origin`: where the origin of the view's page is, in pixels,
// rounded to whole ones so that text stays crisp. Nothing is painted outside of `clip` (pixels), nor outside of the
// view's rectangle when the view clips; labels find their places inside of both. Precondition: scale > 0.
void paint_view(const View&, const Theme&, const Fonts&, Canvas&, double scale, glm::dvec2 origin,
                const PixelRect& clip);

// A whole frame. Precondition: frame_of(scene, theme, scale) is a frame.
void paint(const Scene&, const Theme&, const Fonts&, Canvas&, double scale);

}  // namespace blossom
