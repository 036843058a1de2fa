#pragma once
// The studio's part of the state as words (see state.hpp).

#include <optional>
#include <string>
#include <vector>

#include "player/studio.hpp"

namespace blossom {

// Keys: title, file, kind (of the current thing), objects, current, chosen, selected, tool, u, v, shows, undo, redo,
// undos, unsaved, rejected, hidden, clicked, pane, gizmo, running, riding, held; "object NAME" is a thing's kind,
// "object NAME points" how many points it has, "object NAME made" by what, "object NAME problem", "point NAME 2" a
// place.
std::optional<std::string> studio_state_of(const Studio&, const std::string& key);
std::vector<std::string> studio_state_keys();
// "profile", "profile P[2]"
std::string thing_text(const Studio&, const Link&);

}  // namespace blossom
