// Undo and redo, and how edits are made.
#include "player/action.hpp"
#include "player/player.hpp"

namespace blossom {
namespace {

bool is_open(const Player& p) { return p.session() != nullptr; }
// While one predicts, undo is the answers'.
bool predicts(const Player& p) { return is_open(p) && p.session()->prediction() != nullptr && !p.session()->edited(); }

}  // namespace

const ActionGroup& actions_edit() {
  static const ActionGroup group{
      "Edit",
      20,
      {
          {"edit.undo", "Undo", {"Ctrl+Z"},
           [](Player& p) {
             if (predicts(p))
               p.session()->prediction()->undo();
             else if (p.session()->undo())
               p.notice("Undone: " + p.session()->history().redo_what());
           },
           [](const Player& p) { return is_open(p) && (predicts(p) || p.session()->history().can_undo()); }},
          {"edit.redo", "Redo", {"Ctrl+Y", "Ctrl+Shift+Z"},
           [](Player& p) {
             if (predicts(p))
               p.session()->prediction()->redo();
             else if (p.session()->redo())
               p.notice("Done again: " + p.session()->history().undo_what());
           },
           [](const Player& p) { return is_open(p) && (predicts(p) || p.session()->history().can_redo()); }},
          {"edit.revert", "Take back all edits", {}, [](Player& p) { p.session()->revert(); },
           [](const Player& p) { return is_open(p) && p.session()->edited(); }},
          {"edit.snap", "Snap to the grid", {"S"}, [](Player& p) { p.settings.snap = !p.settings.snap; }, nullptr,
           [](const Player& p) { return p.settings.snap; }},
      }};
  return group;
}

}  // namespace blossom
