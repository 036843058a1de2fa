#pragma once
// What the script of a student's page draws: the points of a run with their names, right and theirs, when each comes
// into being, and what connects them. As JSON:
//   {"box": [x0, y0, x1, y1], "right": bool, "own": bool, "curve"?: [[x, y, x, y, ...], ...],
//    "points": [{"n": [[text, level], ...], "s": step, "e"?: end, "l": level, "r"?: [x, y], "y"?: [x, y],
//                "w"?: [x, y] where the rule leads on their numbers, "k": standing}],
//    "lines": [[point, point, ...]],
//    "steps": [{"v"?: point, "o"?: [points], "c"?: [cells of the scheme]}]}
// Steps count those that the page tells. A level is -1 of what belongs to none, -2 of a point that stands alone.

#include <string>

#include "grader/page/student_run.hpp"

namespace blossom {

struct RunPicture {
  std::string json;    // empty when there is nothing to draw
  bool alike = false;  // all that is drawn of theirs is where it is in the right run
};
RunPicture picture_of(const StudentRun&);

}  // namespace blossom
