#include "export/export_encoder.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <system_error>

#include "base/text_file.hpp"

namespace blossom {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_waiting = 3;
constexpr auto look_up = std::chrono::milliseconds(50);

Diagnostics machine(const std::string& message) { return {{"", 0, 0, "", message}}; }

// The last lines of what ffmpeg said; it names the cause at the end.
std::string last_words(const fs::path& log) {
  const auto text = read_text(log, 1 << 20);
  if (!text) return {};
  std::vector<std::string> lines(1);
  for (const char c : *text) {
    if (c != '\n')
      lines.back() += c;
    else if (!lines.back().empty())
      lines.emplace_back();
  }
  std::string words;
  for (std::size_t i = lines.size() > 4 ? lines.size() - 4 : 0; i < lines.size(); ++i)
    if (!lines[i].empty()) words += (words.empty() ? "" : "; ") + lines[i];
  return words;
}

}  // namespace

Checked<fs::path> find_ffmpeg() {
  const char* path = std::getenv("PATH");
  std::string_view rest = path != nullptr ? path : "";
  while (!rest.empty()) {
    const auto colon = rest.find(':');
    const fs::path program = fs::path(rest.substr(0, colon)) / "ffmpeg";
    std::error_code error;
    if (program.is_absolute() && fs::is_regular_file(program, error) && ::access(program.c_str(), X_OK) == 0)
      return program;
    rest.remove_prefix(colon == std::string_view::npos ? rest.size() : colon + 1);
  }
  return machine(
      "the program ffmpeg, which encodes films, is not on the PATH. Install it (Debian, Ubuntu: apt-get install "
      "ffmpeg; "
      "Fedora: dnf install ffmpeg-free; Arch: pacman -S ffmpeg; macOS: brew install ffmpeg), or choose what needs no "
      "encoder: --to html plays by itself in a browser, --to png writes the pictures");
}

Checked<std::unique_ptr<Encoder>> Encoder::start(const std::vector<std::string>& arguments, const fs::path& log) {
  const auto program = find_ffmpeg();
  if (!program) return program.diagnostics;
  int ends[2];
  // Closed in every other process that is started meanwhile: or else ffmpeg would wait for the end of its input.
  if (::pipe2(ends, O_CLOEXEC) != 0) return machine("no pipe to ffmpeg: " + std::generic_category().message(errno));
  ::fcntl(ends[1], F_SETPIPE_SZ, 1 << 20);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  // A group of its own: Ctrl+C at the terminal is for us, who then end it.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);

  std::vector<std::string> texts{"ffmpeg"};
  texts.insert(texts.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& text : texts) argv.push_back(text.data());
  argv.push_back(nullptr);
  pid_t pid = 0;
  const int failed = posix_spawn(&pid, program->c_str(), &actions, &attributes, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  ::close(ends[0]);
  if (failed != 0) {
    ::close(ends[1]);
    return machine(program->string() + " does not start: " + std::generic_category().message(failed));
  }
  return std::unique_ptr<Encoder>(new Encoder(pid, ends[1], log));
}

Encoder::Encoder(int pid, int pipe, fs::path log) : pid_(pid), pipe_(pipe), log_(std::move(log)) {
  feeder_ = std::thread([this] { feed(); });
}

Encoder::~Encoder() {
  if (pid_ > 0) ::kill(pid_, SIGKILL);  // and so its end of the pipe is closed: the feeder does not wait
  {
    const std::lock_guard lock(mutex_);
    drop_ = true;
  }
  close_queue();
  if (pid_ > 0) ::waitpid(pid_, nullptr, 0);
}

void Encoder::close_queue() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
  if (feeder_.joinable()) feeder_.join();
}

void Encoder::feed() {
  // A program that has ended is told by write, not by a signal that would end this one, too.
  sigset_t pipes;
  sigemptyset(&pipes);
  sigaddset(&pipes, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &pipes, nullptr);
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [&] { return closed_ || !waiting_.empty(); });
    if (waiting_.empty() || broken_ || drop_) break;
    const std::vector<std::uint8_t> pixels = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    changed_.notify_all();
    bool fed = true;
    for (std::size_t at = 0; fed && at < pixels.size();) {
      const ssize_t put = ::write(pipe_, pixels.data() + at, pixels.size() - at);
      fed = put > 0 || (put < 0 && errno == EINTR);
      at += static_cast<std::size_t>(std::max<ssize_t>(put, 0));
    }
    lock.lock();
    broken_ = !fed;
    if (broken_) break;
  }
  lock.unlock();
  changed_.notify_all();
  ::close(pipe_);
}

bool Encoder::put(std::vector<std::uint8_t> pixels, const GoOn& go_on) {
  std::unique_lock lock(mutex_);
  while (!broken_ && waiting_.size() >= most_waiting) {
    changed_.wait_for(lock, look_up);
    if (!go_on()) return false;
  }
  if (broken_) return false;
  waiting_.push_back(std::move(pixels));
  lock.unlock();
  changed_.notify_all();
  return true;
}

Checked<bool> Encoder::finish(const GoOn& go_on) {
  // Joining the feeder could take as long as encoding all that waits, so it is asked first.
  {
    std::unique_lock lock(mutex_);
    closed_ = true;
    changed_.notify_all();
    while (!broken_ && !waiting_.empty()) {
      changed_.wait_for(lock, look_up);
      if (!go_on()) return false;
    }
  }
  int how = 0;
  for (pid_t ended = 0; ended == 0;) {
    ended = ::waitpid(pid_, &how, WNOHANG);
    if (ended == 0) {
      if (!go_on()) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  pid_ = 0;
  close_queue();
  if (WIFEXITED(how) && WEXITSTATUS(how) == 0 && !broken_) return true;
  const std::string words = last_words(log_);
  return machine("ffmpeg could not encode this" +
                 (words.empty() ? std::string(WIFSIGNALED(how) ? ": a signal ended it" : "") : ": " + words));
}

}  // namespace blossom
