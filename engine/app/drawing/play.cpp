// blossom play: the window.

#include <fstream>
#include <iostream>
#include <sstream>

#include "app/input.hpp"
#include "lesson/file_kind.hpp"
#include "player/window/window.hpp"
#include "studio/scene_file.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string file, algorithm, script, out = "out", state;
  bool times = false;
};

// A script is small; what is not is a mistake.
constexpr std::size_t longest_script = 1 << 20;

Checked<std::string> read_text_file(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text(longest_script + 1, '\0');
  if (!in || !fs::is_regular_file(file)) return Diagnostics{{file, 0, 0, "", "cannot be read"}};
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > longest_script) return Diagnostics{{file, 0, 0, "", "is longer than a megabyte"}};
  return text;
}

int run(const Options& options) {
  if (!options.algorithm.empty() && find_algorithm(options.algorithm) == nullptr) {
    std::string message = "there is no algorithm " + excerpt(options.algorithm);
    if (const auto near = did_you_mean(options.algorithm, algorithm_ids()))
      message += "; did you mean \"" + *near + "\"?";
    throw CLI::ValidationError("--algorithm", message);
  }
  PlayerOptions player;
  player.lessons = find_folder("lessons");
  player.exercises = find_folder("exercises");
  if (!options.state.empty())
    player.places = {fs::path(options.state) / "config", fs::path(options.state) / "state"};
  else if (options.script.empty())
    player.places = xdg_places();

  // What is wrong with the file is said here, before there is a window.
  std::shared_ptr<Document> document;
  const auto opened = [&]() -> Checked<Document> {
    if (options.file.empty()) return example_document(options.algorithm, player.lessons);
    const auto file = find_lesson(options.file);
    if (!file) return file.diagnostics;
    return open_document(*file, options.algorithm);
  };
  std::optional<fs::path> scene;
  if (const auto json = JsonDocument::load(options.file); json && file_kind(json->root()) == FileKind::scene) {
    if (const auto read = read_scene(*json); !read) return report(read.diagnostics);
    scene = fs::absolute(options.file);
  } else if (!options.file.empty() || !options.algorithm.empty()) {
    auto read = opened();
    if (!read) return report(read.diagnostics);
    document = std::make_shared<Document>(std::move(*read));
  }
  const Start start = [document, scene](Player& p) {
    if (document) p.open(std::move(*document));
    if (scene) p.open(*scene);
  };

  if (options.script.empty()) {
    FrameTimes times;
    const auto wrong = play_in_window(player, start, options.times ? &times : nullptr);
    if (options.times) std::cerr << times.report();
    report(wrong);
    return wrong.empty() ? done : machine_at_fault;
  }
  const auto text = read_text_file(options.script);
  if (!text) return report(text.diagnostics);
  const auto script = parse_script(options.script, *text);
  if (!script) return report(script.diagnostics);
  return report(play_script(player, start, options.script, *script, options.out));
}

void set_up(CLI::App& app, int& status) {
  auto options = std::make_shared<Options>();
  app.add_option(
      "FILE", options->file,
      "A lesson (a file, or the name or number of one in lessons/), an exercise, a scene, a trace, or inputs");
  app.add_option("--algorithm", options->algorithm,
                 "For a file of inputs: the algorithm. Alone: this algorithm with the inputs of a lesson about it");
  auto* script = app.add_option("--headless-script", options->script,
                                "Without a window: do what this file says, line by line; README.md tells how");
  app.add_option("--out", options->out, "The folder for the script's pictures")->needs(script)->capture_default_str();
  app.add_flag("--times", options->times, "Tell at the end what the first frame and all others took")->excludes(script);
  app.add_option("--state", options->state, "Keep settings, progress and autosaves in this folder, not in XDG's");
  app.footer(
      "Without FILE the start page shows the lessons and exercises. ? in the window lists the keys.\n"
      "Examples:\n"
      "  blossom play 22-de-boor\n"
      "  blossom play --algorithm knot_insertion\n"
      "  blossom play exercises/22-de-boor.json\n"
      "  blossom play lessons/scenes/vase.json\n"
      "  blossom play 22 --headless-script tour.txt --out pictures");
  app.callback([options, &status] { status = run(*options); });
}

}  // namespace

const Command& command_play() {
  static const Command command{"play", "Step through an algorithm in a window", 25, set_up};
  return command;
}

}  // namespace blossom
