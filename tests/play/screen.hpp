#pragma once
// A real X display for tests, Xvfb's, with somebody at its keyboard and mouse, xdotool; and programs that run beside
// the test. What the display shows is read from the file that Xvfb keeps its frame buffer in (a dump as X11's xwd(1)
// makes them, XWDFile.h), so nothing is needed to take a picture.

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <thread>

#include "app/program.hpp"
#include "player/environment.hpp"
#include "render/image.hpp"

namespace blossom::test {

inline std::optional<std::string> find_on_path(const std::string& program) {
  std::istringstream path(getenv("PATH") != nullptr ? getenv("PATH") : "");
  for (std::string folder; std::getline(path, folder, ':');)
    if (const std::string file = folder + "/" + program; access(file.c_str(), X_OK) == 0) return file;
  return std::nullopt;
}

// True as soon as it holds; false after so many seconds.
inline bool wait_until(const std::function<bool()>& holds, double seconds = 30) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return true;
}

// A program that runs beside the test, and is ended with it.
class Running {
 public:
  // `inherited` becomes the program's descriptor 3.
  Running(std::vector<std::string> arguments, const std::string& error_file, int inherited = -1) : error_(error_file) {
    std::vector<char*> argv;
    for (auto& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, error_file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (inherited >= 0) posix_spawn_file_actions_adddup2(&actions, inherited, 3);
    const int failed = posix_spawn(&pid_, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    INFO("cannot start " << argv[0]);
    REQUIRE(failed == 0);
  }
  ~Running() {
    if (ended_) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  Running(const Running&) = delete;

  pid_t pid() const { return pid_; }
  void signal(int number) const { kill(pid_, number); }
  bool has_ended() {
    if (!ended_ && waitpid(pid_, &status_, WNOHANG) == pid_) ended_ = true;
    return ended_;
  }
  // The exit status; 128 + the signal's number if one ended it; -1 if it goes on.
  int end() {
    if (!wait_until([&] { return has_ended(); })) return -1;
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  }
  std::string error() const { return read_all(error_); }
  // Of all its threads, in seconds: utime and stime of proc(5).
  double cpu_seconds() const {
    std::string stat = read_all("/proc/" + std::to_string(pid_) + "/stat");
    std::istringstream fields(stat.substr(stat.rfind(')') + 2));
    std::string word;
    for (int i = 3; i < 14; ++i) fields >> word;
    double user = 0, system = 0;
    fields >> user >> system;
    return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
  }

 private:
  std::string error_;
  pid_t pid_ = 0;
  bool ended_ = false;
  int status_ = 0;
};

class Screen {
 public:
  // Whether there is what it takes. Where tests decide whether a change is taken (CI=true), there has to be.
  static bool possible() {
    for (const char* program : {"Xvfb", "xdotool"}) {
      if (find_on_path(program)) continue;
      const char* ci = getenv("CI");
      if (ci != nullptr && std::string(ci) == "true") FAIL(program << " is not installed");
      WARN("test skipped: " << program << " is not installed");
      return false;
    }
    return true;
  }

  Screen(int width, int height) {
    int ends[2];
    REQUIRE(pipe2(ends, O_CLOEXEC) == 0);
    const std::string size = std::to_string(width) + "x" + std::to_string(height) + "x24";
    server_.emplace(std::vector<std::string>{*find_on_path("Xvfb"), "-displayfd", "3", "-screen", "0", size, "-fbdir",
                                             scratch_.path(), "-nolisten", "tcp", "-noreset"},
                    scratch_ / "errors", ends[1]);
    ::close(ends[1]);
    std::string number;
    pollfd readable{ends[0], POLLIN, 0};
    for (char c = 0; poll(&readable, 1, 30000) == 1 && read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
    ::close(ends[0]);
    INFO(server_->error());
    REQUIRE_FALSE(number.empty());
    display_.emplace("DISPLAY", ":" + number);
    wayland_.emplace("WAYLAND_DISPLAY", std::nullopt);
    // What X11's and Mesa's drivers leave behind has no name that could be suppressed: they are unloaded by then. Leaks
    // of our own are found by the scripts, which drive the same window off screen.
    leaks_.emplace("ASAN_OPTIONS", "detect_leaks=0");
  }

  // What xdotool does and says.
  std::string xdotool(std::vector<std::string> arguments) const {
    const Ended ended = run_program(*find_on_path("xdotool"), std::move(arguments));
    SHOW(ended);
    CHECK(ended.status == 0);
    return ended.out;
  }
  void key(const std::string& name) const { xdotool({"key", name}); }
  void move(double x, double y) {
    pointer_ = {static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y))};
    xdotool({"mousemove", std::to_string(pointer_.x), std::to_string(pointer_.y)});
  }
  // Takes out of a picture where the display draws the mouse's pointer.
  Image without_pointer(Image image) const {
    constexpr int size = 24;
    for (int y = std::max(pointer_.y - size, 0); y < std::min(pointer_.y + size, image.height); ++y)
      for (int x = std::max(pointer_.x - size, 0); x < std::min(pointer_.x + size, image.width); ++x)
        image.set(x, y, {0, 0, 0, 255});
    return image;
  }
  void press() const { xdotool({"mousedown", "1"}); }
  void release() const { xdotool({"mouseup", "1"}); }

  // All that the display shows.
  Image picture() const {
    const std::string bytes = read_all(scratch_ / "Xvfb_screen0");
    const auto word = [&](std::size_t i) {  // of the header, the most significant byte first
      std::uint32_t value = 0;
      for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes.at(4 * i + k));
      return value;
    };
    const std::uint32_t header = word(0), width = word(4), height = word(5), line = word(12), colors = word(19);
    REQUIRE(word(1) == 7);    // the version of the format
    REQUIRE(word(11) == 32);  // bits of a pixel
    REQUIRE(word(7) == 0);    // the least significant byte of a pixel first
    const std::size_t first = header + std::size_t{12} * colors;
    REQUIRE(bytes.size() >= first + std::size_t{line} * height);
    Image image(static_cast<int>(width), static_cast<int>(height));
    for (std::uint32_t y = 0; y < height; ++y)
      for (std::uint32_t x = 0; x < width; ++x) {
        const std::size_t at = first + std::size_t{y} * line + 4 * x;
        const auto byte = [&](std::size_t k) { return static_cast<std::uint8_t>(bytes[at + k]); };
        image.set(static_cast<int>(x), static_cast<int>(y), {byte(2), byte(1), byte(0), 255});
      }
    return image;
  }

 private:
  Scratch scratch_;
  std::optional<Running> server_;
  std::optional<Environment> display_, wayland_, leaks_;
  struct {
    int x = 0, y = 0;
  } pointer_;
};

}  // namespace blossom::test
