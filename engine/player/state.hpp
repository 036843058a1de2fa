#pragma once
// The player's state as words, for scripts and tests: what a person could read off the window.

#include "player/player.hpp"

namespace blossom {

// Keys: open, title, kind, step, last, line, narration, phase, edited, unsaved, undo, redo, rejected, exact, theme,
// text-scale, motion, hovered, pinned, focus, focused, lit, shares, tab, dialog, problems, notice, clipboard, playing,
// speed, loop, bookmarks, camera, question, answered, marks, score, shown, undos, u, degree, points, knots,
// kind-of-curve, studio ("yes", "no", "behind" what is stepped; see studio_state.hpp); "value NAME" is a value's text
// and "point NAME" its place in the picture, in units. Nothing for a key that there is not (now).
std::optional<std::string> state_of(Player&, const std::string& key);
std::vector<std::string> state_keys();

}  // namespace blossom
