#pragma once
// A panel of the window is one file of panels/ that defines `const Panel& panel_NAME()`. It reads the player, draws
// itself with Dear ImGui and with sheets (see Ui), and sends functions that change the player.

#include <string_view>
#include <vector>

namespace blossom {

class Player;
class Ui;

// Where it stands; see layout.hpp.
enum class Slot {
  bar,     // the top edge: menu and title
  main,    // the picture
  strip,   // below the picture, sharing its width
  side,    // at the right, one above the other
  tabs,    // at the right below those, one at a time
  foot,    // the bottom edge, over the whole width, one above the other
  page,    // the whole window while nothing is open
  float_,  // anywhere, over the rest: dialogs, lists of problems
};

struct Panel {
  std::string_view id;     // also what scripts call it
  std::string_view title;  // on its tab and in headings
  Slot slot;
  int order;                                            // in its slot
  void (*draw)(Ui&);                                    // inside its window
  bool (*relevant)(const Player&) = nullptr;            // nullptr: always (while something is open)
  double (*height)(const Ui&, double width) = nullptr;  // in a slot with several: how much it wants, in units
  double least = 0;      // in units: below this much it is left out (strip) or becomes a tab (side)
  bool widgets = false;  // made of Dear ImGui's widgets, which take arrow keys while the keyboard is in it
  bool studio = false;   // of the studio, not of the lessons
  // At the side, where there is too little room for all: how little it can do with, in units. nullptr: what it wants.
  double (*tight)(const Ui&, double width) = nullptr;
};

const std::vector<const Panel*>& panels();

}  // namespace blossom
