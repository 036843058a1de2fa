#pragma once
// What the mouse does in a pane of the studio, and the words beside it.

#include "player/panels/mouse.hpp"

namespace blossom {

// A pane on the screen, as it is drawn in this frame.
struct PaneOnScreen {
  StudioPane pane = StudioPane::space;
  Mouse mouse;
  std::vector<Spot> spots;
  ImVec2 low, high;  // where words may stand
};

void handle_pane_mouse(Ui&, const PaneOnScreen&);
// The point that a click would draw, with a line from the last one.
void add_rubber_line(View&, const Ui&, StudioPane, const Mouse&);
// What is held, or what the tool does.
void draw_pane_words(Ui&, const PaneOnScreen&);
// What can be done with what was clicked by the right button.
void draw_studio_menu(Ui&);

}  // namespace blossom
