#include "player/export_job.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <utility>

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to programs to declare

namespace blossom {
namespace {

constexpr std::size_t most_text = 1 << 20;  // of what a process says

// "  12/60", "done 12 of 60": the first two whole numbers of a line that begins with "progress".
bool read_progress(std::string_view line, std::size_t& done, std::size_t& of) {
  if (!line.starts_with("progress")) return false;
  std::array<std::size_t, 2> numbers{};
  std::size_t count = 0;
  const char* at = line.data();
  const char* const end = at + line.size();
  while (at != end && count < 2) {
    const auto [next, error] = std::from_chars(at, end, numbers[count]);
    at = error == std::errc() ? (++count, next) : at + 1;
  }
  if (count < 2) return false;
  done = numbers[0];
  of = numbers[1];
  return true;
}

// "FILE:LINE:COLUMN: message", or a message alone.
Diagnostic read_complaint(const std::string& line) {
  for (std::size_t colon = line.find(':'); colon != std::string::npos; colon = line.find(':', colon + 1)) {
    int row = 0, column = 0;
    const char* const end = line.data() + line.size();
    const auto [after_row, no_row] = std::from_chars(line.data() + colon + 1, end, row);
    if (no_row != std::errc() || after_row == end || *after_row != ':') continue;
    const auto [after_column, no_column] = std::from_chars(after_row + 1, end, column);
    if (no_column != std::errc() || after_column == end || *after_column != ':') continue;
    const auto rest = static_cast<std::size_t>(after_column + 1 - line.data());
    return {line.substr(0, colon), row, column, "",
            line.substr(std::min(line.find_first_not_of(' ', rest), line.size()))};
  }
  return {"", 0, 0, "", line};
}

void close_pipe(int& pipe) {
  if (pipe >= 0) close(pipe);
  pipe = -1;
}

}  // namespace

ExportJob::ExportJob(const std::filesystem::path& program, std::vector<std::string> arguments,
                     std::filesystem::path out, std::filesystem::path scratch)
    : out_(std::move(out)), scratch_(std::move(scratch)) {
  std::array<int, 2> said{-1, -1}, complained{-1, -1};
  if (pipe2(said.data(), O_CLOEXEC) != 0 || pipe2(complained.data(), O_CLOEXEC) != 0) {
    wrong_.push_back({"", 0, 0, "", std::string("no process could be started: ") + std::strerror(errno)});
    for (int* end : {&said[0], &said[1]}) close_pipe(*end);
    return;
  }
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, said[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, complained[1], STDERR_FILENO);
  // In a group of its own: an encoder that it has started is stopped with it.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  std::string name = program.string();
  std::vector<char*> words{name.data()};
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  const int error = posix_spawn(&process_, name.c_str(), &actions, &attributes, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  close_pipe(said[1]);
  close_pipe(complained[1]);
  said_ = said[0];
  complained_ = complained[0];
  if (error == 0) {
    fcntl(said_, F_SETFL, O_NONBLOCK);
    fcntl(complained_, F_SETFL, O_NONBLOCK);
    return;
  }
  process_ = 0;
  close_pipe(said_);
  close_pipe(complained_);
  wrong_.push_back({"", 0, 0, "", name + " could not be started: " + std::strerror(error)});
}

ExportJob::ExportJob(ExportJob&& other) noexcept
    : process_(std::exchange(other.process_, 0)),
      said_(std::exchange(other.said_, -1)),
      complained_(std::exchange(other.complained_, -1)),
      said_text_(std::move(other.said_text_)),
      complaints_(std::move(other.complaints_)),
      out_(std::move(other.out_)),
      scratch_(std::exchange(other.scratch_, {})),
      done_(other.done_),
      of_(other.of_),
      stopped_(other.stopped_),
      wrong_(std::move(other.wrong_)),
      notes_(std::move(other.notes_)) {}

ExportJob::~ExportJob() {
  stop();
  std::error_code ignored;
  if (!scratch_.empty()) std::filesystem::remove(scratch_, ignored);
}

// True if there was something.
bool ExportJob::read_from(int& pipe, std::string& text) {
  std::array<char, 4096> buffer{};
  bool any = false;
  while (pipe >= 0) {
    const ssize_t count = ::read(pipe, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      if (count == 0) close_pipe(pipe);
      break;
    }
    any = true;
    if (text.size() < most_text) text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  return any;
}

void ExportJob::take_line(const std::string& line) {
  if (line.empty() || read_progress(line, done_, of_)) return;
  notes_.push_back(line);
}

bool ExportJob::poll() {
  if (process_ == 0) return false;
  bool news = read_from(said_, said_text_);
  news = read_from(complained_, complaints_) || news;
  // Progress may come on either of them.
  for (std::string* text : {&said_text_, &complaints_})
    for (std::size_t end = text->find('\n'); end != std::string::npos; end = text->find('\n')) {
      const std::string line = text->substr(0, end);
      text->erase(0, end + 1);
      if (text == &complaints_ && !line.starts_with("progress"))
        wrong_.push_back(read_complaint(line));
      else
        take_line(line);
    }
  int status = 0;
  if (waitpid(process_, &status, WNOHANG) == process_) {
    process_ = 0;
    read_from(said_, said_text_);
    read_from(complained_, complaints_);
    finish(status);
    return true;
  }
  return news;
}

void ExportJob::finish(int status) {
  for (std::string* text : {&said_text_, &complaints_}) {
    while (!text->empty()) {
      const std::size_t end = std::min(text->find('\n'), text->size());
      const std::string line = text->substr(0, end);
      text->erase(0, std::min(end + 1, text->size()));
      if (text == &complaints_ && !line.empty() && !line.starts_with("progress"))
        wrong_.push_back(read_complaint(line));
      else
        take_line(line);
    }
  }
  close_pipe(said_);
  close_pipe(complained_);
  const bool good = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (good) {
    // What it complained of and yet did is worth knowing.
    for (const Diagnostic& each : wrong_) notes_.push_back(each.message);
    wrong_.clear();
  } else if (wrong_.empty() && !stopped_) {
    wrong_.push_back({"", 0, 0, "", "the export ended without a word and wrote nothing"});
  }
}

void ExportJob::wait() {
  while (running()) {
    std::array<pollfd, 2> pipes{{{said_, POLLIN, 0}, {complained_, POLLIN, 0}}};
    ::poll(pipes.data(), pipes.size(), said_ < 0 && complained_ < 0 ? 5 : 50);
    poll();
  }
}

void ExportJob::stop() {
  if (process_ <= 0) return;
  stopped_ = true;
  // It is asked first, so that it removes what is half written; who does not listen is ended.
  kill(-process_, SIGTERM);
  for (int i = 0; i < 40 && running(); ++i) {
    usleep(5000);
    poll();
  }
  if (!running()) return;
  kill(-process_, SIGKILL);
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = 0;
  close_pipe(said_);
  close_pipe(complained_);
}

}  // namespace blossom
