#pragma once
// The two windows there are: a real one, and one off screen that plays a script. Both drive the same Player and Ui.

#include "player/player.hpp"
#include "player/script.hpp"
#include "player/window/frame_times.hpp"

namespace blossom {

// What is opened at the start.
using Start = std::function<void(Player&)>;

// Opens a window and stays until it is closed. A diagnostic when there is no display or no OpenGL.
// `times`, if given, is told what the start and every frame took.
Diagnostics play_in_window(const PlayerOptions&, const Start&, FrameTimes* times = nullptr);

// Plays the script; pictures and states go to `out`. Diagnostics name the line of the script where an expectation did
// not hold or a named thing was not there; it ends at the first.
Diagnostics play_script(const PlayerOptions&, const Start&, const std::string& script_name,
                        const std::vector<Instruction>&, const std::filesystem::path& out);

}  // namespace blossom
