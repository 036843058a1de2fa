#pragma once
// Scene files, blossom.scene/1 (lessons/scene.schema.json):
//
//   {"schema": "blossom.scene/1", "id"?: "vase", "title"?: "A vase", "summary"?: text,
//    "look"?: {"from"?: "space" | "xy" | "xz" | "yz", "azimuth"?, "elevation"? (degrees), "perspective"?: bool},
//    "objects": [
//      {"name": "profile", "curve": {...}, "color"?: 0..7, "hidden"?: bool, "shows"?: ["points", "polygon"],
//       "u"?: number, "v"?: number, "map"?: "gaussian"},
//      {"name": "vase", "made": {"algorithm": "revolution",
//                                "inputs": {"profile": {"object": "profile"}, "angle": 360}, "result"?: 0}},
//      {"name": "tube", "made": {"algorithm": "skinning", "inputs": {"profiles": [
//          {"object": "circle"}, {"object": "circle", "scale": [2, 2, 1], "turn": [0, 90, 0], "move": [4, 0, 1]}]}}}]}
//
// Instead of "curve": "surface", "points" ([[x, y], ...]) or "net" (rows of points). "scale" may be one number. Objects
// refer to earlier ones only. What is left out of "shows" is as usual_shows says; of "u" and "v" the middle of the
// domain. Beside "made" the geometry may stand that the thing had when it could be made last: while it cannot be made,
// that is what it is, and otherwise nobody needs it.

#include "base/json.hpp"
#include "studio/workspace.hpp"

namespace blossom {

// Every mistake at once; what is made is made (see remake.hpp), and what cannot be is a mistake at its place.
Checked<Workspace> read_scene(const JsonDocument&);
Checked<Workspace> load_scene(const std::filesystem::path&);
// The text of its file, indented to be read and edited by people. Reading it gives the same workspace.
std::string write_scene(const Workspace&);

// A value as a part of such a file: with decimals where they are exact.
Json json_of(const InputValue<Exact>&);

}  // namespace blossom
