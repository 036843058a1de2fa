// What one does in the studio.
#include "player/action.hpp"
#include "player/player.hpp"

namespace blossom {
namespace {

bool has_thing(const Player& p) { return p.in_studio() && p.studio()->current().has_value(); }
bool has_things(const Player& p) { return p.in_studio() && !p.studio()->workspace().objects.empty(); }
bool has_choice(const Player& p) { return has_thing(p) || (p.in_studio() && !p.studio()->selected().empty()); }
bool has_curve(const Player& p) {
  return has_thing(p) && std::holds_alternative<Curve<Exact>>(p.studio()->object()->geometry);
}
bool has_parameter(const Player& p) {
  if (!has_thing(p)) return false;
  const Range range = domain_of(p.studio()->object()->geometry);
  return range.last.x > range.first.x;
}

// The thing or the point that has the keyboard.
void choose_focused(Player& p) {
  Studio& studio = *p.studio();
  if (studio.finish_drawing()) return;
  if (p.focused.kind != Link::Kind::object) return;
  if (p.focused.part == 0)
    studio.choose(p.focused.id);
  else
    studio.select({{p.focused.id, p.focused.part - 1}});
}

template <Tool tool>
void take_tool(Player& p) {
  p.studio()->set_tool(tool);
}
template <Tool tool>
bool has_tool(const Player& p) {
  return p.in_studio() && p.studio()->tool() == tool;
}

template <StudioPane pane>
void see(Player& p) {
  p.studio()->show_pane(pane);
}
template <StudioPane pane>
bool sees(const Player& p) {
  return p.in_studio() && !p.studio()->four_panes && p.studio()->pane == pane;
}

template <int x, int y, int z>
void nudge(Player& p) {
  p.studio()->nudge({x, y, z});
}

constexpr Where here = Where::studio;

}  // namespace

const ActionGroup& actions_studio() {
  static const ActionGroup group{
      "Studio",
      25,
      {
          {"studio.step", "Step this ...", {"F8"}, [](Player& p) { p.step_chosen(); }, has_thing, nullptr, here},
          {"studio.step_with",
           "Step with an algorithm ...",
           {"Shift+F8"},
           [](Player& p) { p.dialog = Dialog::step_with; },
           has_thing,
           nullptr,
           here},
          {"studio.back",
           "Back to the studio",
           {"F8"},
           [](Player& p) { p.back_to_studio(); },
           nullptr,
           nullptr,
           Where::stepped},
          {"studio.choose", "Choose and drag", {"C"}, take_tool<Tool::choose>, nullptr, has_tool<Tool::choose>, here},
          {"studio.draw", "Draw a curve", {"D"}, take_tool<Tool::draw>, nullptr, has_tool<Tool::draw>, here},
          {"studio.insert", "Insert points", {"I"}, take_tool<Tool::insert>, has_things, has_tool<Tool::insert>, here},
          {"studio.erase", "Erase points", {"E"}, take_tool<Tool::erase>, has_things, has_tool<Tool::erase>, here},
          {"studio.enter",
           "Choose what has the focus",
           {"Enter"},
           choose_focused,
           [](const Player& p) {
             return p.in_studio() && (p.focused.kind == Link::Kind::object || !p.studio()->clicked().empty());
           },
           nullptr,
           here},
          {"studio.gizmo",
           "Handles to move, turn and scale",
           {"M"},
           [](Player& p) { p.studio()->gizmo = !p.studio()->gizmo; },
           nullptr,
           [](const Player& p) { return p.in_studio() && p.studio()->gizmo; },
           here},
          {"studio.next",
           "Next thing",
           {"]", "N"},
           [](Player& p) { p.studio()->choose_next(1); },
           has_things,
           nullptr,
           here},
          {"studio.previous",
           "Previous thing",
           {"[", "B"},
           [](Player& p) { p.studio()->choose_next(-1); },
           has_things,
           nullptr,
           here},
          {"studio.all_points",
           "Select all points",
           {"Ctrl+A"},
           [](Player& p) { p.studio()->select_all_points(); },
           has_thing,
           nullptr,
           here},
          {"studio.delete", "Delete", {"Delete"}, [](Player& p) { p.studio()->remove(); }, has_choice, nullptr, here},
          {"studio.duplicate",
           "Duplicate",
           {"Ctrl+D"},
           [](Player& p) { p.studio()->duplicate(); },
           has_thing,
           nullptr,
           here},
          {"studio.hide", "Hide or show", {"H"}, [](Player& p) { p.studio()->hide(); }, has_thing, nullptr, here},
          {"studio.show_all",
           "Show all that is hidden",
           {"Shift+H"},
           [](Player& p) { p.studio()->show_all(); },
           has_things,
           nullptr,
           here},
          {"studio.left", "Move left", {"Left"}, nudge<-1, 0, 0>, has_choice, nullptr, here},
          {"studio.right", "Move right", {"Right"}, nudge<1, 0, 0>, has_choice, nullptr, here},
          {"studio.up", "Move up", {"Up"}, nudge<0, 1, 0>, has_choice, nullptr, here},
          {"studio.down", "Move down", {"Down"}, nudge<0, -1, 0>, has_choice, nullptr, here},
          {"studio.nearer", "Move nearer", {"PageDown"}, nudge<0, 0, 1>, has_choice, nullptr, here},
          {"studio.farther", "Move away", {"PageUp"}, nudge<0, 0, -1>, has_choice, nullptr, here},
          {"studio.run",
           "Run u along it",
           {"Space"},
           [](Player& p) { p.studio()->run(!p.studio()->running()); },
           has_parameter,
           [](const Player& p) { return p.in_studio() && p.studio()->running(); },
           here},
          {"studio.ride",
           "Ride along the curve",
           {"R"},
           [](Player& p) { p.studio()->ride(!p.studio()->riding()); },
           has_curve,
           [](const Player& p) { return p.in_studio() && p.studio()->riding(); },
           here},
          {"studio.smooth",
           "Keep shared borders smooth (C1)",
           {"K"},
           [](Player& p) { p.studio()->keep_smooth = !p.studio()->keep_smooth; },
           has_things,
           [](const Player& p) { return p.in_studio() && p.studio()->keep_smooth; },
           here},
          {"studio.xy", "From above (xy)", {"1"}, see<StudioPane::xy>, nullptr, sees<StudioPane::xy>, here},
          {"studio.xz", "From the front (xz)", {"2"}, see<StudioPane::xz>, nullptr, sees<StudioPane::xz>, here},
          {"studio.yz", "From the side (yz)", {"3"}, see<StudioPane::yz>, nullptr, sees<StudioPane::yz>, here},
          {"studio.space", "In space", {"4"}, see<StudioPane::space>, nullptr, sees<StudioPane::space>, here},
          {"studio.four",
           "All four views",
           {"5", "Q"},
           [](Player& p) { p.studio()->four_panes = !p.studio()->four_panes; },
           nullptr,
           [](const Player& p) { return p.in_studio() && p.studio()->four_panes; },
           here},
          {"studio.perspective",
           "Perspective",
           {"P"},
           [](Player& p) { p.studio()->set_perspective(!p.studio()->perspective); },
           nullptr,
           [](const Player& p) { return p.in_studio() && p.studio()->perspective; },
           here},
          {"studio.import",
           "Import ...",
           {"Ctrl+I"},
           [](Player& p) { p.dialog = Dialog::import_file; },
           nullptr,
           nullptr,
           here},
          {"studio.export",
           "Export ...",
           {"Ctrl+Shift+E"},
           [](Player& p) { p.dialog = Dialog::export_file; },
           has_things,
           nullptr,
           here},
      }};
  return group;
}

}  // namespace blossom
