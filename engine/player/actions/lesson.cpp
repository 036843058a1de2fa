// What a lesson offers besides its steps: scenes, languages, questions.
#include "player/action.hpp"
#include "player/player.hpp"

namespace blossom {
namespace {

bool has_questions(const Player& p) { return p.session() != nullptr && !p.checkpoints().items().empty(); }
bool has_languages(const Player& p) { return p.languages().size() > 1; }

}  // namespace

const ActionGroup& actions_lesson() {
  static const ActionGroup group{"Lesson",
                                 45,
                                 {
                                     {"lesson.next_scene",
                                      "Next scene",
                                      {"Ctrl+PageDown"},
                                      [](Player& p) { p.show_scene(p.scene() + 1); },
                                      [](const Player& p) { return p.scene() + 1 < p.scene_count(); }},
                                     {"lesson.previous_scene",
                                      "Previous scene",
                                      {"Ctrl+PageUp"},
                                      [](Player& p) { p.show_scene(p.scene() - 1); },
                                      [](const Player& p) { return p.scene() > 0; }},
                                     {"lesson.questions",
                                      "Questions and answers",
                                      {"Q"},
                                      [](Player& p) { p.tab = p.focus = "checkpoint"; },
                                      has_questions},
                                     {"lesson.skip",
                                      "Skip the question",
                                      {"Ctrl+Right"},
                                      [](Player& p) { p.skip_checkpoint(); },
                                      [](const Player& p) {
                                        const auto item = p.checkpoint();
                                        return item && p.checkpoints().item(*item).open();
                                      }},
                                     {"lesson.save_checkpoints",
                                      "Save the answers to the questions ...",
                                      {"Ctrl+Shift+A"},
                                      [](Player& p) { p.dialog = Dialog::save_checkpoints; },
                                      has_questions},
                                     {"lesson.language",
                                      "Next language",
                                      {"Ctrl+Shift+L"},
                                      [](Player& p) { p.choose_next_language(); },
                                      has_languages},
                                 }};
  return group;
}

}  // namespace blossom
