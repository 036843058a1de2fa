// The real window on a real display, with real keys and a real mouse. What it shows is compared with the picture that a
// script makes of the same doing without a window: both are the same application.
#include <algorithm>

#include "base/json.hpp"
#include "block_difference.hpp"
#include "play/screen.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr int width = 1280, height = 720;

// A script's pictures, and where its named things are.
class Rehearsal {
 public:
  explicit Rehearsal(const std::string& script) {
    const std::string file = scratch_.write("script.txt", script);
    const Ended ended =
        test::blossom({"play", "--headless-script", file, "--out", scratch_ / "out", "--state", scratch_ / "state"});
    SHOW(ended);
    REQUIRE(ended.status == 0);
  }
  Image picture(const std::string& name) const {
    auto image = read_png(scratch_ / ("out/" + name + ".png"));
    REQUIRE(image);
    return std::move(*image);
  }
  struct Place {
    double x, y;
  };
  Place middle(const std::string& list, const std::string& thing) const {
    const auto parsed = JsonDocument::parse("things", read_all(scratch_ / ("out/" + list + ".json")));
    REQUIRE(parsed);
    std::string text = read_all(scratch_ / ("out/" + list + ".json"));
    const std::string key = json_quote(thing) + ": [";
    const auto at = text.find(key);
    INFO("no " << thing << " in " << text);
    REQUIRE(at != std::string::npos);
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream numbers(text.substr(at + key.size()));
    double x = 0, y = 0, w = 0, h = 0;
    numbers >> x >> y >> w >> h;
    return {x + w / 2, y + h / 2};
  }

 private:
  Scratch scratch_;
};

class Window {
 public:
  explicit Window(const Screen& screen, const std::vector<std::string>& more = {}) : screen_(screen) {
    std::vector<std::string> arguments{(fs::path(BLOSSOM_BIN_DIR) / "blossom").string(), "play", "--state",
                                       scratch_ / "state"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    program.emplace(arguments, scratch_ / "errors");
    const bool there = wait_until([&] {
      const Ended found = run_program(*find_on_path("xdotool"), {"search", "--onlyvisible", "--name", "Blossom"});
      return program->has_ended() || found.status == 0;
    });
    INFO(program->error());
    REQUIRE(there);
    REQUIRE_FALSE(program->has_ended());
  }

  // Waits until the window shows this picture. If it does not, both are left beside the test's program.
  void check_shows(const Image& picture, const std::string& what) const {
    const Image wanted = screen_.without_pointer(picture);
    Image is;
    const bool shown = wait_until(
        [&] {
          is = screen_.without_pointer(screen_.picture());
          return difference(is, wanted).mean < 2 && block_difference(is, wanted) <= tolerated_difference;
        },
        20);
    if (!shown) {
      const std::string name = std::string(BLOSSOM_BIN_DIR) + "/../tests/window-test-" + what;
      write_png(name + "-is.png", is);
      write_png(name + "-wanted.png", wanted);
      INFO(what << ": mean difference " << difference(is, wanted).mean << ", largest of a block "
                << block_difference(is, wanted) << "; see " << name << "-is.png");
      CHECK(shown);
    }
  }
  std::string state_file(const std::string& name) const { return read_all(scratch_ / ("state/state/" + name)); }
  std::size_t autosaves() const {
    const fs::path folder = scratch_ / "state/state/autosave";
    return fs::exists(folder) ? static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {})) : 0;
  }

  std::optional<Running> program;

 private:
  const Screen& screen_;
  Scratch scratch_;
};

}  // namespace

TEST_CASE("The window opens, steps by real keys, pins and drags by a real mouse, and quits") {
  if (!Screen::possible()) return;
  // `wait` until what goes away by itself has gone.
  const Rehearsal rehearsal(R"(size 1280 720
open tests/play/data/22-de-boor.json
move "timeline position"
things opened
shot opened
key Right
key Right
key Right
key Right
shot fourth
click "tableau P[1][2]"
expect pinned P[1][2]
shot pinned
key T
shot dark
key T
key T
drag "viewport P[0][3]" by -60 40
expect edited yes
shot dragged
key Ctrl+Z
wait 6
shot undone
)");
  Screen screen(width, height);
  Window window(screen, {"tests/play/data/22-de-boor.json"});
  const auto neutral = rehearsal.middle("opened", "timeline position");
  screen.move(neutral.x, neutral.y);
  window.check_shows(rehearsal.picture("opened"), "opened");

  for (int i = 0; i < 4; ++i) screen.key("Right");
  window.check_shows(rehearsal.picture("fourth"), "fourth");
  for (const char* meaningless : {"F9", "y", "semicolon", "ctrl+k"}) screen.key(meaningless);
  window.check_shows(rehearsal.picture("fourth"), "fourth-still");

  const auto cell = rehearsal.middle("opened", "tableau P[1][2]");
  screen.move(cell.x, cell.y);
  screen.press();
  screen.release();
  window.check_shows(rehearsal.picture("pinned"), "pinned");
  screen.key("t");
  window.check_shows(rehearsal.picture("dark"), "dark");
  screen.key("t");
  screen.key("t");

  const auto point = rehearsal.middle("opened", "viewport P[0][3]");
  screen.move(point.x, point.y);
  screen.press();
  for (int i = 1; i <= 10; ++i) screen.move(point.x - 6 * i, point.y + 4 * i);
  screen.release();
  window.check_shows(rehearsal.picture("dragged"), "dragged");
  screen.key("ctrl+z");
  window.check_shows(rehearsal.picture("undone"), "undone");

  screen.key("ctrl+q");
  INFO(window.program->error());
  CHECK(window.program->end() == 0);
  CHECK(window.program->error().empty());
  const std::string progress = window.state_file("progress.json");
  INFO(progress);
  CHECK(contains(progress, "22-de-boor.json"));
  CHECK(contains(progress, "\"step\": 4"));
  CHECK(window.autosaves() == 0);
}

TEST_CASE("In the studio a real mouse drags a point, what is made of it follows, and real keys step it and come back") {
  if (!Screen::possible()) return;
  const Rehearsal rehearsal(R"(size 1280 720
open lessons/scenes/vase.json
move "menu Help"
things opened
shot opened
key [
expect current profile
things profile
shot profile
drag "view profile P[1]" by 60 0
expect undos 1
move "menu Help"
shot dragged
key Ctrl+Z
wait 6
shot undone
key ]
key F8
expect studio behind
wait 6
shot stepped
key F8
wait 6
shot back
)");
  Screen screen(width, height);
  Window window(screen, {"lessons/scenes/vase.json"});
  const auto neutral = rehearsal.middle("opened", "menu Help");
  screen.move(neutral.x, neutral.y);
  window.check_shows(rehearsal.picture("opened"), "studio-opened");
  screen.key("bracketleft");
  window.check_shows(rehearsal.picture("profile"), "studio-profile");
  const auto point = rehearsal.middle("profile", "view profile P[1]");
  screen.move(point.x, point.y);
  screen.press();
  for (int i = 1; i <= 10; ++i) screen.move(point.x + 6 * i, point.y);
  screen.release();
  screen.move(neutral.x, neutral.y);
  window.check_shows(rehearsal.picture("dragged"), "studio-dragged");
  screen.key("ctrl+z");
  window.check_shows(rehearsal.picture("undone"), "studio-undone");
  screen.key("bracketright");
  screen.key("F8");
  window.check_shows(rehearsal.picture("stepped"), "studio-stepped");
  screen.key("F8");
  window.check_shows(rehearsal.picture("back"), "studio-back");
  screen.key("ctrl+q");
  INFO(window.program->error());
  CHECK(window.program->end() == 0);
  CHECK(window.program->error().empty());
}

TEST_CASE("The window does nothing while nothing happens") {
  if (!Screen::possible()) return;
  const Rehearsal rehearsal(
      "size 1280 720\nopen tests/play/data/22-de-boor.json\nmove \"timeline position\"\nthings t\nshot s\n");
  Screen screen(width, height);
  Window window(screen, {"tests/play/data/22-de-boor.json"});
  const auto neutral = rehearsal.middle("t", "timeline position");
  screen.move(neutral.x, neutral.y);
  window.check_shows(rehearsal.picture("s"), "idle");
  std::this_thread::sleep_for(std::chrono::seconds(2));  // what is saved by and by is saved
  const double before = window.program->cpu_seconds();
  std::this_thread::sleep_for(std::chrono::seconds(3));
  const double idle = window.program->cpu_seconds() - before;
  CHECK(idle < 0.05 * 3);
  // It is not dead.
  screen.key("End");
  CHECK(wait_until([&] { return block_difference(screen.picture(), rehearsal.picture("s")) > tolerated_difference; }));
}

TEST_CASE("A window that the system ends keeps where one was, and what one has edited for the next start") {
  if (!Screen::possible()) return;
  const Rehearsal rehearsal(R"(size 1280 720
open tests/play/data/22-de-boor.json
move "timeline position"
things opened
shot opened
key Right
shot first
drag "viewport P[0][3]" by -60 40
shot dragged
)");
  Screen screen(width, height);
  Window window(screen, {"tests/play/data/22-de-boor.json"});
  const auto neutral = rehearsal.middle("opened", "timeline position");
  screen.move(neutral.x, neutral.y);
  window.check_shows(rehearsal.picture("opened"), "opened");
  screen.key("Right");
  window.check_shows(rehearsal.picture("first"), "first");
  const auto point = rehearsal.middle("opened", "viewport P[0][3]");
  screen.move(point.x, point.y);
  screen.press();
  for (int i = 1; i <= 10; ++i) screen.move(point.x - 6 * i, point.y + 4 * i);
  screen.release();
  window.check_shows(rehearsal.picture("dragged"), "dragged");
  window.program->signal(SIGTERM);
  CHECK(window.program->end() == 0);
  CHECK(contains(window.state_file("progress.json"), "\"step\": 1"));
  CHECK(window.autosaves() == 1);
}

TEST_CASE("Without a display the player says what to do instead") {
  const Environment display("DISPLAY", std::nullopt), wayland("WAYLAND_DISPLAY", std::nullopt);
  const Scratch scratch;
  const Ended ended = test::blossom({"play", "22", "--state", scratch / "state"});
  SHOW(ended);
  CHECK(ended.status == 3);
  CHECK(ended.out.empty());
  CHECK(contains(ended.err, "there is no display"));
  CHECK(contains(ended.err, "blossom step"));
}
