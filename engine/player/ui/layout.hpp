#pragma once
// Which panel stands where in a window of some size. In a small window (or with large text, which is the same thing in
// units) the panels at the side become tabs, then the strip below the picture goes.

#include <functional>

#include "player/ui/panel.hpp"
#include "render/canvas.hpp"

namespace blossom {

struct Placed {
  const Panel* panel = nullptr;
  PixelRect rect;  // in units
};

struct Layout {
  std::vector<Placed> placed;        // every panel that has a window, but for the tabbed ones
  std::vector<const Panel*> tabbed;  // the tabs, in their order
  PixelRect tabs;                    // of the tabs with their bar; empty: none
  double side_x = 0;                 // where the picture ends and the panels begin; 0: no side
  double lower_y = 0;                // where the tabs begin
  PixelRect side;                    // all of it
};

struct LayoutWish {
  double width = 1280, height = 720;  // units
  double side_share = 0.4, lower_share = 0.55;
  bool page = false;  // nothing is open
  // One has put the border above the tabs where it is; otherwise they have what the panels above leave, too.
  bool lower_fixed = false;
  std::string_view tab = {};  // the id of the one that is open
};

// `wanted` says how high a panel wants to be at a width, and `tight` with how little it can do; `relevant` which panels
// there are.
Layout lay_out(const LayoutWish&, const std::vector<const Panel*>& panels,
               const std::function<bool(const Panel&)>& relevant,
               const std::function<double(const Panel&, double width)>& wanted,
               const std::function<double(const Panel&, double width)>& tight = {});

}  // namespace blossom
