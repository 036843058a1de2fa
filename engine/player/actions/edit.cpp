// Undo and redo, and how edits are made.
#include "algorithms/typeset.hpp"
#include "player/action.hpp"
#include "player/player.hpp"

namespace blossom {
namespace {

bool is_open(const Player& p) { return p.session() != nullptr; }
// While one predicts, undo is the answers'.
bool predicts(const Player& p) { return is_open(p) && p.session()->prediction() != nullptr && !p.session()->edited(); }

// "P[0][3] moved" with the name set as in books.
std::string in_words(const Player& p, const std::string& what) {
  return unicode_text(typeset_text(what, p.session()->algorithm()));
}

void undo_in_studio(Player& p) {
  Studio& studio = *p.studio();
  if (!studio.clicked().empty())
    studio.take_back_click();
  else if (studio.undo())
    p.notice("Undone: " + studio.history().redo_what());
}
void redo_in_studio(Player& p) {
  if (p.studio()->redo()) p.notice("Done again: " + p.studio()->history().undo_what());
}

bool has_point(const Player& p) { return p.chosen_point().has_value(); }
bool has_spatial_point(const Player& p) { return has_point(p) && p.session()->recording().source().spatial(); }

}  // namespace

const ActionGroup& actions_edit() {
  static const ActionGroup group{"Edit",
                                 20,
                                 {
                                     {"edit.undo",
                                      "Undo",
                                      {"Ctrl+Z"},
                                      [](Player& p) {
                                        if (p.in_studio())
                                          undo_in_studio(p);
                                        else if (predicts(p))
                                          p.take_back_answer();
                                        else if (p.session()->undo())
                                          p.notice("Undone: " + in_words(p, p.session()->history().redo_what()));
                                      },
                                      [](const Player& p) {
                                        if (p.in_studio()) return p.studio()->can_undo();
                                        return predicts(p) ? p.session()->prediction()->can_undo()
                                                           : is_open(p) && p.session()->history().can_undo();
                                      },
                                      nullptr,
                                      Where::both},
                                     {"edit.redo",
                                      "Redo",
                                      {"Ctrl+Y", "Ctrl+Shift+Z"},
                                      [](Player& p) {
                                        if (p.in_studio())
                                          redo_in_studio(p);
                                        else if (predicts(p))
                                          p.put_back_answer();
                                        else if (p.session()->redo())
                                          p.notice("Done again: " + in_words(p, p.session()->history().undo_what()));
                                      },
                                      [](const Player& p) {
                                        if (p.in_studio()) return p.studio()->history().can_redo();
                                        return predicts(p) ? p.session()->prediction()->can_redo()
                                                           : is_open(p) && p.session()->history().can_redo();
                                      },
                                      nullptr,
                                      Where::both},
                                     {"edit.revert",
                                      "Take back all edits",
                                      {},
                                      [](Player& p) { p.session()->revert(); },
                                      [](const Player& p) { return is_open(p) && p.session()->edited(); }},
                                     {"edit.nudge_left",
                                      "Move the point left",
                                      {"Shift+Left"},
                                      [](Player& p) {
                                        p.nudge({-1, 0, 0});
                                      },
                                      has_point},
                                     {"edit.nudge_right",
                                      "Move the point right",
                                      {"Shift+Right"},
                                      [](Player& p) {
                                        p.nudge({1, 0, 0});
                                      },
                                      has_point},
                                     {"edit.nudge_up",
                                      "Move the point up",
                                      {"Shift+Up"},
                                      [](Player& p) {
                                        p.nudge({0, 1, 0});
                                      },
                                      has_point},
                                     {"edit.nudge_down",
                                      "Move the point down",
                                      {"Shift+Down"},
                                      [](Player& p) {
                                        p.nudge({0, -1, 0});
                                      },
                                      has_point},
                                     {"edit.nudge_nearer",
                                      "Move the point nearer",
                                      {"Shift+PageDown"},
                                      [](Player& p) {
                                        p.nudge({0, 0, 1});
                                      },
                                      has_spatial_point},
                                     {"edit.nudge_farther",
                                      "Move the point away",
                                      {"Shift+PageUp"},
                                      [](Player& p) {
                                        p.nudge({0, 0, -1});
                                      },
                                      has_spatial_point},
                                     {"edit.insert_point",
                                      "Add a point behind",
                                      {"Insert"},
                                      [](Player& p) { p.add_point_behind(*p.chosen_point()); },
                                      has_point},
                                     {"edit.delete_point",
                                      "Delete this point",
                                      {"Delete"},
                                      [](Player& p) { p.remove_point(*p.chosen_point()); },
                                      has_point},
                                     {"edit.snap",
                                      "Snap to the grid",
                                      {"S"},
                                      [](Player& p) { p.settings.snap = !p.settings.snap; },
                                      nullptr,
                                      [](const Player& p) { return p.settings.snap; },
                                      Where::both},
                                 }};
  return group;
}

}  // namespace blossom
