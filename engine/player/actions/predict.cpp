// Saying what a step will make before it is shown.
#include "player/action.hpp"
#include "player/player.hpp"

namespace blossom {
namespace {

bool is_open(const Player& p) { return p.session() != nullptr; }
bool predicts(const Player& p) { return is_open(p) && p.session()->prediction() != nullptr; }
bool can_show(const Player& p) {
  const auto question = p.asked();
  if (!question || p.session()->prediction()->mark(*question)) return false;
  const auto& attempt = p.session()->prediction()->attempt(*question);
  return !attempt || !attempt->shown;
}

}  // namespace

const ActionGroup& actions_predict() {
  static const ActionGroup group{
      "Predict",
      50,
      {
          {"predict.toggle",
           "Predict the steps",
           {"Ctrl+T"},
           [](Player& p) {
             if (predicts(p))
               p.stop_predicting();
             else
               p.start_predicting();
           },
           is_open,
           predicts},
          {"predict.show_me", "Show me", {"Ctrl+H"}, [](Player& p) { p.show_me(); }, can_show},
          {"predict.finish",
           "Finish and mark",
           {"Ctrl+Enter"},
           [](Player& p) { p.finish_predicting(); },
           [](const Player& p) { return predicts(p) && !p.session()->prediction()->finished(); }},
          {"predict.next", "Next question", {"Alt+PageDown"}, [](Player& p) { p.choose_next_question(1); }, predicts},
          {"predict.previous",
           "Previous question",
           {"Alt+PageUp"},
           [](Player& p) { p.choose_next_question(-1); },
           predicts},
      }};
  return group;
}

}  // namespace blossom
