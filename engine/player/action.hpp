#pragma once
// Everything one can do by name: menus, the toolbar, shortcuts, the list of shortcuts and the command palette are all
// made from these tables. A file of actions/ defines one group, `const ActionGroup& actions_NAME()`.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace blossom {

class Player;

// Where an action is there at all: while one has something else before one it is neither in the menus nor on a key, so
// that a key means one thing wherever one is.
enum class Where : std::uint8_t {
  lessons,
  studio,
  both,
  stepped,  // what is stepped has come from the studio
};

struct Action {
  std::string_view id;     // "step.forward"
  std::string_view title;  // "Forward"
  // "Right", "Ctrl+Shift+Z", "?": a character stands for itself whatever keys make it. The first is shown in menus.
  std::vector<std::string_view> keys;
  void (*run)(Player&);
  bool (*enabled)(const Player&) = nullptr;  // nullptr: always
  bool (*checked)(const Player&) = nullptr;  // nullptr: nothing that is on or off
  Where where = Where::lessons;
};

struct ActionGroup {
  std::string_view title;  // of the menu: "Step"
  int order;
  std::vector<Action> actions;
};

const std::vector<const ActionGroup*>& action_groups();
std::vector<const ActionGroup*> ordered_action_groups();

const Action* find_action(std::string_view id);
bool is_here(const Player&, const Action&);  // of the place where one is
std::vector<const Action*> actions_here(const Player&, const ActionGroup&);
const Action* action_for_key(const Player&, std::string_view key);
// Does it if it is here and enabled.
bool perform(Player&, std::string_view id);

}  // namespace blossom
