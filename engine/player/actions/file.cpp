// What is open, and what is saved.
#include "player/action.hpp"
#include "player/player.hpp"
#include "scene/panels.hpp"

namespace blossom {
namespace {

bool is_open(const Player& p) { return p.session() != nullptr; }

}  // namespace

const ActionGroup& actions_file() {
  static const ActionGroup group{
      "File",
      10,
      {
          {"file.open", "Open ...", {"Ctrl+O"}, [](Player& p) { p.dialog = Dialog::open; }},
          {"file.start",
           "Start page",
           {"Ctrl+W"},
           [](Player& p) { p.unless_unsaved([](Player& q) { q.close(); }); },
           is_open},
          {"file.save_lesson",
           "Save as a lesson ...",
           {"Ctrl+S"},
           [](Player& p) { p.dialog = Dialog::save_lesson; },
           is_open},
          {"file.save_picture",
           "Save the picture ...",
           {"Ctrl+E"},
           [](Player& p) { p.dialog = Dialog::save_picture; },
           is_open},
          {"file.save_answers",
           "Save the answers ...",
           {"Ctrl+Shift+S"},
           [](Player& p) { p.dialog = Dialog::save_answers; },
           [](const Player& p) { return is_open(p) && p.session()->prediction() != nullptr; }},
          {"file.copy_tableau",
           "Copy the scheme as LaTeX",
           {"Ctrl+L"},
           [](Player& p) {
             const auto text = latex_tableau(p.session()->recording().source(), p.session()->step());
             if (text.empty()) return p.notice("This step has no triangular scheme.");
             p.desk().set_clipboard(text);
             p.notice("The scheme is on the clipboard as LaTeX.");
           },
           is_open},
          {"file.copy_value",
           "Copy the step's value",
           {"Ctrl+C"},
           [](Player& p) {
             const Recording& recording = p.session()->recording();
             Link link = p.pinned();
             if (link.kind != Link::Kind::value)
               link = {Link::Kind::value, recording.graph().main_value(p.session()->step())};
             if (link.id == absent) return p.notice("This step makes no value.");
             const std::string text = recording.source().value_text(link.id);
             p.desk().set_clipboard(text);
             p.notice("Copied: " + text);
           },
           is_open},
          {"file.recover",
           "Recover edits ...",
           {},
           [](Player& p) { p.dialog = Dialog::recover; },
           [](const Player& p) { return !p.lost_work().empty(); }},
          {"file.quit", "Quit", {"Ctrl+Q"}, [](Player& p) { p.unless_unsaved([](Player& q) { q.quit(); }); }},
      }};
  return group;
}

}  // namespace blossom
