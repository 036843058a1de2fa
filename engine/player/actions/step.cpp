// Moving in the timeline.
#include "player/action.hpp"
#include "player/player.hpp"

namespace blossom {
namespace {

bool is_open(const Player& p) { return p.session() != nullptr; }
bool can_go_on(const Player& p) { return is_open(p) && !p.session()->timeline().at_end(); }
bool can_go_back(const Player& p) { return is_open(p) && p.session()->step() > 0; }

constexpr double speeds[] = {0.1, 0.2, 0.5, 1, 1.5, 2, 3, 5, 10};

void change_speed(Player& p, int by) {
  double chosen = by > 0 ? speeds[std::size(speeds) - 1] : speeds[0];
  if (by > 0)
    for (auto s = std::rbegin(speeds); s != std::rend(speeds) && *s > p.settings.speed * 1.001; ++s) chosen = *s;
  else
    for (const double s : speeds)
      if (s < p.settings.speed * 0.999) chosen = s;
  p.settings.speed = chosen;
}

}  // namespace

const ActionGroup& actions_step() {
  static const ActionGroup group{
      "Step",
      30,
      {
          {"step.forward",
           "Forward",
           {"Right", "N", "."},
           [](Player& p) { p.move([](Timeline& t) { return t.pause(), t.forward(); }); },
           can_go_on},
          {"step.back",
           "Back",
           {"Left", "B", ","},
           [](Player& p) { p.move([](Timeline& t) { return t.pause(), t.back(); }); },
           can_go_back},
          {"step.over",
           "Over the phase",
           {"Down", "O"},
           [](Player& p) { p.move([](Timeline& t) { return t.pause(), t.over(); }); },
           can_go_on},
          {"step.out",
           "Out of the phase",
           {"Up", "U"},
           [](Player& p) { p.move([](Timeline& t) { return t.pause(), t.out(); }); },
           can_go_on},
          {"step.next_mark",
           "Next beat or bookmark",
           {"PageDown", "]"},
           [](Player& p) { p.move([](Timeline& t) { return t.pause(), t.next_mark(); }); },
           [](const Player& p) {
             return is_open(p) && !p.session()->timeline().marks().empty() &&
                    p.session()->timeline().marks().back() > p.session()->step();
           }},
          {"step.previous_mark",
           "Previous beat or bookmark",
           {"PageUp", "["},
           [](Player& p) { p.move([](Timeline& t) { return t.pause(), t.previous_mark(); }); },
           [](const Player& p) {
             return is_open(p) && !p.session()->timeline().marks().empty() &&
                    p.session()->timeline().marks().front() < p.session()->step();
           }},
          {"step.first",
           "First step",
           {"Home"},
           [](Player& p) { p.move([](Timeline& t) { return t.pause(), t.seek(0); }); },
           can_go_back},
          {"step.last",
           "Last step",
           {"End"},
           [](Player& p) { p.move([](Timeline& t) { return t.pause(), t.seek(t.last()); }); },
           can_go_on},
          {"step.go_to",
           "Go to a step or value",
           {"G", "Ctrl+G"},
           [](Player& p) { p.dialog = Dialog::go_to; },
           is_open},
          {"step.play",
           "Play",
           {"Space"},
           [](Player& p) {
             p.session()->move([](Timeline& t) {
               if (t.playing())
                 t.pause();
               else
                 t.play();
               return true;
             });
           },
           is_open,
           [](const Player& p) { return is_open(p) && p.session()->timeline().playing(); }},
          {"step.faster", "Faster", {"+", "Ctrl+Up"}, [](Player& p) { change_speed(p, 1); }, is_open},
          {"step.slower", "Slower", {"-", "Ctrl+Down"}, [](Player& p) { change_speed(p, -1); }, is_open},
          {"step.bookmark",
           "Bookmark here",
           {"M"},
           [](Player& p) { p.session()->toggle_bookmark(); },
           is_open,
           [](const Player& p) {
             if (!is_open(p)) return false;
             const auto marks = p.session()->bookmarks();
             return std::find(marks.begin(), marks.end(), p.session()->step()) != marks.end();
           }},
          {"step.loop_from",
           "Loop from here",
           {"I"},
           [](Player& p) {
             p.session()->move([](Timeline& t) {
               t.set_loop(t.position(), t.loop() && t.loop()->second > t.position() ? t.loop()->second : t.last());
               return false;
             });
           },
           is_open},
          {"step.loop_to",
           "Loop to here",
           {"Shift+I"},
           [](Player& p) {
             p.session()->move([](Timeline& t) {
               t.set_loop(t.loop() && t.loop()->first < t.position() ? t.loop()->first : 0, t.position());
               return false;
             });
           },
           is_open},
          {"step.loop",
           "Loop the range",
           {"L"},
           [](Player& p) {
             p.session()->move([](Timeline& t) {
               if (t.loop())
                 t.clear_loop();
               else
                 t.set_loop(0, t.last());
               return false;
             });
           },
           is_open,
           [](const Player& p) { return is_open(p) && p.session()->timeline().loop().has_value(); }},
      }};
  return group;
}

}  // namespace blossom
