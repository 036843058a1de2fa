#include "player/action.hpp"

#include "player/player.hpp"

#include <algorithm>

namespace blossom {

std::vector<const ActionGroup*> ordered_action_groups() {
  auto groups = action_groups();
  std::stable_sort(groups.begin(), groups.end(), [](const auto* a, const auto* b) { return a->order < b->order; });
  return groups;
}

const Action* find_action(std::string_view id) {
  for (const ActionGroup* group : action_groups())
    for (const Action& action : group->actions)
      if (action.id == id) return &action;
  return nullptr;
}

bool is_here(const Player& player, const Action& action) {
  if (action.where == Where::stepped) return player.stepping_from_studio();
  return action.where == Where::both || (action.where == Where::studio) == player.in_studio();
}

std::vector<const Action*> actions_here(const Player& player, const ActionGroup& group) {
  std::vector<const Action*> here;
  for (const Action& action : group.actions)
    if (is_here(player, action)) here.push_back(&action);
  return here;
}

const Action* action_for_key(const Player& player, std::string_view key) {
  for (const ActionGroup* group : action_groups())
    for (const Action& action : group->actions)
      if (is_here(player, action) && std::ranges::find(action.keys, key) != action.keys.end()) return &action;
  return nullptr;
}

bool perform(Player& player, std::string_view id) {
  const Action* action = find_action(id);
  if (action == nullptr || !is_here(player, *action) || (action->enabled != nullptr && !action->enabled(player)))
    return false;
  action->run(player);
  return true;
}

}  // namespace blossom
