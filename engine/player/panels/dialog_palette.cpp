// All commands by name.
#include <algorithm>

#include "player/action.hpp"
#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

struct Found {
  const ActionGroup* group;
  const Action* action;
  int rank;  // the lower the better
};

// The letters of the pattern in their order, somewhere.
bool has_letters(std::string_view text, std::string_view pattern) {
  std::size_t i = 0;
  for (const char c : text)
    if (i < pattern.size() && contains(std::string_view(&c, 1), pattern.substr(i, 1))) ++i;
  return i == pattern.size();
}

std::vector<Found> matching(const Player& player, const std::string& typed) {
  std::string pattern;
  for (const char c : typed)
    if (c != ' ') pattern += c;
  std::vector<Found> found;
  for (const ActionGroup* group : ordered_action_groups())
    for (const Action* here : actions_here(player, *group)) {
      const Action& action = *here;
      const std::string all = std::string(group->title) + " " + std::string(action.title);
      if (contains(action.title, typed))
        found.push_back(
            {group, &action, typed.empty() || contains(action.title.substr(0, typed.size()), typed) ? 0 : 1});
      else if (contains(all, typed))
        found.push_back({group, &action, 2});
      else if (has_letters(all, pattern))
        found.push_back({group, &action, 3});
    }
  std::ranges::stable_sort(found, {}, &Found::rank);
  return found;
}

void draw(Ui& ui) {
  static std::string text;
  static int chosen = 0;
  static bool to_field = false;
  if (!begin_dialog(ui, "All commands", 520)) return;
  if (dialog_opens()) text.clear(), chosen = 0;
  const std::string before = text;
  int moved = 0;
  if (std::exchange(to_field, false)) ImGui::SetKeyboardFocusHere();
  const bool entered = dialog_field(
      ui, "", "dialog command", text, true, "Type a part of its name", ImGuiInputTextFlags_CallbackHistory,
      [](ImGuiInputTextCallbackData* data) {
        *static_cast<int*>(data->UserData) = data->EventKey == ImGuiKey_UpArrow ? -1 : 1;
        return 0;
      },
      &moved);
  const auto found = matching(ui.player(), text);
  const auto count = static_cast<int>(found.size());
  if (text != before) chosen = 0;
  chosen = std::clamp(chosen + moved, 0, std::max(count - 1, 0));
  const auto run = [&](const Action& action) {
    ui.send([id = action.id](Player& player) {
      player.cancel_dialog();
      perform(player, id);
    });
  };
  const auto enabled = [&](const Action& action) { return action.enabled == nullptr || action.enabled(ui.player()); };
  ImGui::BeginChild("commands", {0, std::min(ui.px(360), dialog_room(ui, 0))}, false, ImGuiWindowFlags_NavFlattened);
  for (int i = 0; i < count; ++i) {
    const Found& one = found[static_cast<std::size_t>(i)];
    const std::string key(one.action->keys.empty() ? std::string_view() : one.action->keys.front());
    const bool scroll = i == chosen && (moved != 0 || text != before);
    if (choice(ui, std::string(one.group->title) + "  \u203A  " + std::string(one.action->title), key,
               "command " + std::string(one.action->id), i == chosen, enabled(*one.action), scroll))
      run(*one.action);
  }
  if (count == 0) quiet_text(ui, "No command is called so.");
  ImGui::EndChild();
  if (entered && count > 0) {
    const Action& action = *found[static_cast<std::size_t>(chosen)].action;
    if (enabled(action))
      run(action);
    else
      to_field = true;
  }
  end_dialog();
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::palette; }

}  // namespace

const Panel& panel_dialog_palette() {
  static const Panel panel{"palette", "All commands", Slot::float_, 56, draw, is_relevant};
  return panel;
}

}  // namespace blossom
