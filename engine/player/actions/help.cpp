// Finding one's way.
#include "player/action.hpp"
#include "player/player.hpp"

namespace blossom {
namespace {

bool is_open(const Player& p) { return p.session() != nullptr; }

void show(Player& p, const char* tab) { p.tab = p.focus = tab; }

// What the question is about: what has the keyboard, is pinned, or is made by the step.
std::optional<ValueId> asked_value(const Player& p) {
  for (const Link& link : {p.focused, p.hovered(), p.pinned()})
    if (link.kind == Link::Kind::value) return link.id;
  const ValueId main = p.session()->recording().graph().main_value(p.session()->step());
  return main == absent ? std::nullopt : std::optional(main);
}

}  // namespace

const ActionGroup& actions_help() {
  static const ActionGroup group{
      "Help",
      60,
      {
          {"help.why",
           "Why this value?",
           {"W"},
           [](Player& p) {
             if (const auto v = asked_value(p)) p.ask_why(*v);
           },
           [](const Player& p) { return is_open(p) && asked_value(p).has_value(); }},
          {"help.pin",
           "Pin what has the focus",
           {"Enter"},
           [](Player& p) { p.pin(p.focused); },
           [](const Player& p) { return is_open(p) && static_cast<bool>(p.focused); }},
          {"help.scheme", "Show the scheme", {"Ctrl+1"}, [](Player& p) { show(p, "tableau"); }, is_open},
          {"help.inputs", "Show the inputs", {"Ctrl+2"}, [](Player& p) { show(p, "inputs"); }, is_open},
          {"help.phases", "Show the phases", {"Ctrl+3"}, [](Player& p) { show(p, "phases"); }, is_open},
          {"help.why_panel", "Show the reasons", {"Ctrl+4"}, [](Player& p) { show(p, "why"); }, is_open},
          {"help.predict_panel", "Show the predictions", {"Ctrl+5"}, [](Player& p) { show(p, "predict"); }, is_open},
          {"help.palette",
           "All commands ...",
           {"Ctrl+P", "/"},
           [](Player& p) { p.dialog = Dialog::palette; },
           nullptr,
           nullptr,
           Where::both},
          {"help.shortcuts",
           "Keyboard shortcuts",
           {"?", "F1"},
           [](Player& p) { p.dialog = Dialog::shortcuts; },
           nullptr,
           nullptr,
           Where::both},
      }};
  return group;
}

}  // namespace blossom
