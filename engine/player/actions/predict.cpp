// Saying what a step will make before it is shown.
#include "player/action.hpp"
#include "player/player.hpp"

namespace blossom {
namespace {

bool is_open(const Player& p) { return p.session() != nullptr; }
bool predicts(const Player& p) { return is_open(p) && p.session()->prediction() != nullptr; }

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
             if (predicts(p)) return p.session()->stop_prediction();
             if (auto wrong = p.session()->start_prediction(); !wrong.empty())
               return p.show_problems("There is nothing to predict here", std::move(wrong));
             p.tab = p.focus = "predict";
           },
           is_open,
           predicts},
          {"predict.show_me",
           "Show me",
           {"Ctrl+H"},
           [](Player& p) {
             Prediction& prediction = *p.session()->prediction();
             if (const auto question = prediction.open()) prediction.show_me(*question);
           },
           [](const Player& p) { return predicts(p) && p.session()->prediction()->open().has_value(); }},
          {"predict.finish",
           "Finish and mark",
           {},
           [](Player& p) { p.session()->prediction()->finish(); },
           [](const Player& p) { return predicts(p) && !p.session()->prediction()->finished(); }},
      }};
  return group;
}

}  // namespace blossom
