// What is said at the step.
#include "player/ui/panel.hpp"
#include "player/ui/ui.hpp"

namespace blossom {
namespace {

constexpr double text_size = 1.12;

std::string prompt_of(const Session& session) {
  const bool asks = session.prediction() != nullptr && !session.prediction()->finished();
  return asks && session.document().grader ? session.document().grader->exercise().prompt : std::string();
}

void draw(Ui& ui) {
  const Session& session = *ui.player().session();
  const Session::Words words = session.words();
  const double width = ui.units(ImGui::GetContentRegionAvail().x);
  const auto say = [&](const auto& text, double size, Role role) {
    double height = 0;
    Sheet sheet = ui.flow(text, width, size, role, height);
    ui.sheet("narration", std::move(sheet), width, height);
  };
  std::string path;
  const TraceGraph& graph = session.recording().graph();
  for (const std::uint32_t phase : graph.phase_path(graph.step(session.step()).phase))
    path += (path.empty() ? "" : "  ›  ") + session.recording().source().phase_title(phase);
  if (!path.empty()) say(path, 0.9, Role::text_quiet);
  // An exercise says what it asks.
  if (const std::string prompt = prompt_of(session); !prompt.empty()) say(read_prose(prompt), 1, Role::text_strong);
  say(read_prose(words.text), text_size, Role::text);
  if (!words.lesson.empty()) {
    say(std::string("The lesson, written for its own numbers:"), 0.9, Role::text_quiet);
    say(read_prose(words.lesson), 0.9, Role::text_quiet);
  }
}

double wanted(const Ui& ui, double width) {
  const Session& session = *ui.player().session();
  double height = 18, part = 0;
  ui.flow(read_prose(session.words().text), width - 24, text_size, Role::text, part);
  height += part;
  if (const std::string prompt = prompt_of(session); !prompt.empty()) {
    ui.flow(read_prose(prompt), width - 24, 1, Role::text_strong, part);
    height += part;
  }
  if (session.recording().graph().phases().size() > 0) height += 20;
  if (!session.words().lesson.empty()) height += 44;
  // The picture above is not to jump with every step's words, where there is room for some more.
  const bool tight = ui.height() < 560 || !ui.player().sliders().empty();
  return tight ? height : std::max(height, 84.0);
}

}  // namespace

const Panel& panel_narration() {
  static const Panel panel{"narration", "Narration", Slot::foot, 10, draw, nullptr, wanted};
  return panel;
}

}  // namespace blossom
