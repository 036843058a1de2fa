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
          {"file.open",
           "Open ...",
           {"Ctrl+O"},
           [](Player& p) { p.dialog = Dialog::open; },
           nullptr,
           nullptr,
           Where::both},
          {"file.new_scene",
           "New scene in the studio",
           {"Ctrl+N"},
           [](Player& p) { p.new_scene(); },
           nullptr,
           nullptr,
           Where::both},
          {"file.start",
           "Start page",
           {"Ctrl+W"},
           [](Player& p) { p.unless_unsaved([](Player& q) { q.close(); }); },
           [](const Player& p) { return is_open(p) || p.in_studio(); },
           nullptr,
           Where::both},
          {"file.save_scene", "Save", {"Ctrl+S"}, [](Player& p) { p.save_scene(); }, nullptr, nullptr, Where::studio},
          {"file.save_scene_as",
           "Save as ...",
           {"Ctrl+Shift+S"},
           [](Player& p) { p.dialog = Dialog::save_scene; },
           nullptr,
           nullptr,
           Where::studio},
          {"file.save_lesson",
           "Save as a lesson ...",
           {"Ctrl+S"},
           [](Player& p) { p.dialog = Dialog::save_lesson; },
           is_open},
          {"file.save_picture",
           "Save the picture ...",
           {"Ctrl+E"},
           [](Player& p) { p.dialog = Dialog::save_picture; },
           [](const Player& p) { return is_open(p) || p.in_studio(); },
           nullptr,
           Where::both},
          {"file.export_lesson",
           "Export the lesson ...",
           {"Ctrl+Shift+E"},
           [](Player& p) { p.dialog = Dialog::export_lesson; },
           [](const Player& p) { return is_open(p) && p.exporting() == nullptr; }},
          {"file.save_answers",
           "Save the answers ...",
           {"Ctrl+Shift+S"},
           [](Player& p) { p.dialog = Dialog::save_answers; },
           [](const Player& p) { return is_open(p) && p.session()->prediction() != nullptr; }},
          {"file.copy_tableau",
           "Copy the scheme as LaTeX",
           {"Ctrl+L"},
           [](Player& p) {
             if (p.hides("k")) return p.notice("The scheme can be copied when k is answered.");
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
             const bool given = link.id != absent && recording.graph().is_input(link.id);
             if (link.id == absent || (given && link != p.pinned()))
               return p.notice("This step makes no value. Click one to choose it.");
             if (p.veils(link.id)) return p.notice("That is still asked.");
             const std::string text = recording.source().value_text(link.id);
             p.desk().set_clipboard(text);
             p.notice("Copied: " + text);
           },
           is_open},
          {"file.recover",
           "Recover edits ...",
           {},
           [](Player& p) { p.dialog = Dialog::recover; },
           [](const Player& p) { return !p.lost_work().empty(); },
           nullptr,
           Where::both},
          {"file.quit",
           "Quit",
           {"Ctrl+Q"},
           [](Player& p) { p.unless_unsaved([](Player& q) { q.quit(); }); },
           nullptr,
           nullptr,
           Where::both},
      }};
  return group;
}

}  // namespace blossom
