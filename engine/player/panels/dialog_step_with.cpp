// Which algorithm is to run, step by step, on what is chosen in the studio.
#include <algorithm>

#include "player/ui/dialog.hpp"
#include "player/ui/panel.hpp"

namespace blossom {
namespace {

struct Search {
  std::string text;
  std::vector<const Algorithm*> fitting;  // what is chosen does not change while the dialog stands
  int chosen = 0;
  bool to_field = false;
};

std::string_view family_title(Family family) {
  switch (family) {
    case Family::evaluation:
      return "a point";
    case Family::curve_technique:
      return "a curve from it";
    case Family::fitting:
      return "through points";
    case Family::surface_technique:
      return "a surface from it";
    case Family::construction:
      return "a surface from curves";
  }
  return {};
}

std::string names_of_chosen(const Studio& studio) {
  std::string names;
  for (const std::size_t i : studio.chosen()) names += (names.empty() ? "" : ", ") + studio.workspace().objects[i].name;
  return names;
}

void draw(Ui& ui) {
  static Search search;
  const Player& player = ui.player();
  if (!player.in_studio() || !player.studio()->current()) return close_dialog(ui);
  const Studio& studio = *player.studio();
  if (!begin_dialog(ui, "Step an algorithm", 560)) return;
  if (dialog_opens()) {
    search = {};
    search.fitting = algorithms_for(studio.workspace(), studio.chosen());
  }
  quiet_text(ui,
             "What is to be done with " + names_of_chosen(studio) + "? It runs step by step; nothing changes here.");
  const std::string before = search.text;
  int moved = 0;
  if (std::exchange(search.to_field, false)) ImGui::SetKeyboardFocusHere();
  const bool entered = dialog_field(
      ui, "", "dialog algorithm", search.text, true, "Type a part of its name", ImGuiInputTextFlags_CallbackHistory,
      [](ImGuiInputTextCallbackData* data) {
        *static_cast<int*>(data->UserData) = data->EventKey == ImGuiKey_UpArrow ? -1 : 1;
        return 0;
      },
      &moved);
  std::vector<const Algorithm*> found;
  for (const Algorithm* algorithm : search.fitting)
    if (contains(algorithm->title, search.text) || contains(algorithm->id, search.text)) found.push_back(algorithm);
  const auto count = static_cast<int>(found.size());
  if (search.text != before) search.chosen = 0;
  search.chosen = std::clamp(search.chosen + moved, 0, std::max(count - 1, 0));
  const auto step = [&](const Algorithm* algorithm) {
    ui.send([algorithm](Player& p) {
      p.cancel_dialog();
      p.step_with(*algorithm);
    });
  };
  const float below = ImGui::GetFrameHeightWithSpacing() + ui.px(12);
  ImGui::BeginChild("algorithms", {0, std::min(ui.px(320), dialog_room(ui, below))}, false,
                    ImGuiWindowFlags_NavFlattened);
  for (int i = 0; i < count; ++i) {
    const Algorithm& algorithm = *found[static_cast<std::size_t>(i)];
    const bool scroll = i == search.chosen && (moved != 0 || search.text != before);
    if (choice(ui, std::string(algorithm.title), std::string(family_title(algorithm.family)),
               "algorithm " + std::string(algorithm.id), i == search.chosen, true, scroll))
      step(&algorithm);
  }
  if (search.fitting.empty())
    dialog_warning(ui, "No algorithm takes just these things. Choose others, or several in the order that it wants.");
  else if (count == 0)
    quiet_text(ui, "None of the " + std::to_string(search.fitting.size()) + " that can be done is called so.");
  else
    quiet_text(ui, std::string(found[static_cast<std::size_t>(search.chosen)]->summary));
  ImGui::EndChild();
  const bool pressed = dialog_buttons(ui, "Step", count > 0);
  if ((entered || pressed) && count > 0)
    step(found[static_cast<std::size_t>(search.chosen)]);
  else if (entered)
    search.to_field = true;
  end_dialog();
}

bool is_relevant(const Player& player) { return player.dialog == Dialog::step_with; }

}  // namespace

const Panel& panel_dialog_step_with() {
  static const Panel panel{"step-with", "Step an algorithm", Slot::float_, 60, draw, is_relevant};
  return panel;
}

}  // namespace blossom
