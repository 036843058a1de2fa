#pragma once
// Scripts for `blossom play --headless-script`: what a person would do, line by line.
//
//   size 1280 720 [2]           the window in units, and how many pixels a unit has
//   open lessons/22-de-boor.json
//   key Right | key Ctrl+Z | key ?
//   type 2/5                    text into what has the focus; OUT/NAME is a file in the folder of the pictures
//   focus NAME                  the keyboard's focus to a named thing
//   move NAME                   the mouse onto a named thing
//   click NAME [right|double|shift|ctrl]
//   drag NAME to NAME | drag NAME by 40 -25     in units; either with [shift|ctrl|alt|right|middle] behind it
//   wheel NAME -3
//   drop FILE                   as by drag and drop; OUT/NAME as above
//   wait 0.5                    seconds pass, frame by frame
//   shot NAME                   OUT/NAME.png of the window as it is
//   state NAME                  OUT/NAME.json: the player's state, as expect sees it
//   things NAME                 OUT/NAME.json: every named thing with its place
//   expect KEY VALUE            the state's KEY is VALUE, or the script fails: step, title, "value P[1][4]", ...
//   expect-near KEY NUMBER TOLERANCE
//   expect-thing NAME           a thing of that name is on the screen
//   expect-no-thing NAME
//   close
//
// What has blanks stands in double quotes, in which \" is a quote and \\ a backslash. A word that begins with # begins
// a comment; the key is "#". A file is written once. An empty script is a mistake.

#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"

namespace blossom {

struct Instruction {
  int line = 0;
  std::string verb;
  std::vector<std::string> words;  // as many as the verb takes, "to" and "by" among them; checked: Exact::parse takes
                                   // the numbers
};

// The keys that have names: Left, Enter, F5, ... Any other key is the character it makes. Before either there may be
// Ctrl+, Alt+ and Shift+, in any order.
const std::vector<std::string>& script_keys();

// Every mistake at once, as file:line:column; at most 10,000 lines of at most 4096 bytes.
Checked<std::vector<Instruction>> parse_script(const std::string& name, std::string_view text);

}  // namespace blossom
