#pragma once
// The labels of one view: measured, placed, and painted with a halo that keeps them readable over lines.

#include "render/canvas.hpp"
#include "render/font.hpp"
#include "render/page_map.hpp"
#include "render/projection.hpp"
#include "render/theme.hpp"

namespace blossom {

// `visible` is the part of the page the view may paint, in page units.
void paint_labels(const View&, const Projection&, const PixelRect& visible, const Theme&, const Fonts&, Canvas&,
                  const PageMap&);

}  // namespace blossom
