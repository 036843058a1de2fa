#include "grader/batch/worker_process.hpp"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <exception>
#include <new>
#include <system_error>

#include "grader/batch/sandbox.hpp"

namespace blossom {
namespace {

constexpr std::size_t flush_from = 128u << 10;  // bytes of answers that are sent before the frame is done
constexpr int socket_buffer = 512 << 10;

[[noreturn]] void fail(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

bool read_all(int from, char* to, std::size_t count) {
  while (count > 0) {
    const ssize_t got = read(from, to, count);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    to += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

bool write_all(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t put = write(to, bytes.data(), bytes.size());
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(put));
  }
  return true;
}

// What happens in the worker's process.
class Worker {
 public:
  Worker(const Workers::Work& work, const WorkerOptions& options, Progress& progress)
      : work_(work), options_(options), progress_(progress) {}

  // noexcept: what is thrown here must not reach what the parent was doing when it forked.
  [[noreturn]] void live(int socket, pid_t parent) noexcept {
    leave_parent(socket, parent);
    const std::string open = options_.sandboxed ? enter_sandbox(options_.memory_bytes) : "";
    append_raw(answers_, static_cast<Word>(open.size()));
    answers_ += open;
    bool goes_on = flush();
    while (goes_on) goes_on = serve();
    _exit(0);
  }

 private:
  static constexpr int socket_ = 3;

  // Nothing of the parent's is left to it but the socket and memory, and it does not outlive the parent.
  static void leave_parent(int socket, pid_t parent) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent) _exit(0);
    // Of the terminal: the parent decides. The parent's handlers are not for here, but for a sanitizer's.
    for (int number = 1; number < NSIG; ++number)
      if (!sanitized || (number != SIGSEGV && number != SIGBUS && number != SIGFPE && number != SIGILL))
        signal(number, number == SIGINT || number == SIGQUIT ? SIG_IGN : SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);

    // Where memory runs out, the system is to end a worker and not the parent.
    if (const int score = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC); score >= 0) {
      if (write(score, "1000", 4) < 0) errno = 0;
      close(score);
    }
    const int kept = fcntl(socket, F_DUPFD, socket_ + 1);
    if (kept < 0 || dup2(kept, socket_) < 0) _exit(errno);
    const int nothing = open("/dev/null", O_RDWR);
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
      if (standard != STDERR_FILENO || !sanitized) dup2(nothing, standard);
    close_range(socket_ + 1, ~0u, 0);
  }

  bool flush() {
    const bool sent = write_all(socket_, answers_);
    answers_.clear();
    return sent;
  }

  // A frame. False when there are no more.
  bool serve() {
    FrameHead head;
    if (!read_all(socket_, reinterpret_cast<char*>(&head), sizeof head)) return false;
    items_.resize(head.bytes);
    if (!read_all(socket_, items_.data(), items_.size())) return false;
    std::string_view rest = items_;
    for (Word i = 0; i < head.items; ++i) {
      const Word length = read_raw<Word>(rest.data());
      answer(rest.substr(sizeof length, length));
      rest.remove_prefix(sizeof length + length);
      if (answers_.size() >= flush_from && !flush()) return false;
    }
    return flush();
  }

  void answer(std::string_view item) {
    Word kind = 0;
    answer_.clear();
    const std::uint64_t before = progress_.value.load(std::memory_order_relaxed);
    progress_.value.store(before + 1, std::memory_order_release);
    try {
      work_(item, answer_);
      if (answer_.size() > options_.answer_bytes) {
        kind = 1;
        answer_ = "the grader said too much about it";
      }
    } catch (const std::bad_alloc&) {
      kind = 1;
      answer_ = "the grader ran out of memory";
    } catch (const std::exception& error) {
      kind = 1;
      answer_ = std::string("the grader failed: ") + error.what();
      answer_.resize(std::min(answer_.size(), most_reason));
    }
    append_raw(answers_, AnswerHead{static_cast<Word>(answer_.size()), kind});
    answers_ += answer_;
    progress_.value.store(before + 2, std::memory_order_release);
  }

  const Workers::Work& work_;
  const WorkerOptions& options_;
  Progress& progress_;
  std::string items_;
  std::string answer_;
  std::string answers_;
};

std::string how_it_ended(int status) {
  if (WIFEXITED(status)) return "ended with status " + std::to_string(WEXITSTATUS(status));
  const int number = WTERMSIG(status);
  if (number == SIGSYS) return "tried what is not allowed (SIGSYS)";
  const char* name = sigabbrev_np(number);
  return "died of signal " + std::to_string(number) + (name != nullptr ? " (SIG" + std::string(name) + ")" : "");
}

}  // namespace

WorkerProcess::WorkerProcess(const Workers::Work& work, const WorkerOptions& options, std::string& open_because) {
  void* shared = mmap(nullptr, sizeof(Progress), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (shared == MAP_FAILED) fail("no memory for a worker");
  progress_ = new (shared) Progress;
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
    munmap(shared, sizeof(Progress));
    fail("no socket for a worker");
  }
  for (const int end : ends) setsockopt(end, SOL_SOCKET, SO_SNDBUF, &socket_buffer, sizeof socket_buffer);
  socket_ = ends[0];
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) Worker(work, options, *progress_).live(ends[1], parent);
  const int error = errno;
  close(ends[1]);
  Word length = 0;
  const bool ready = pid_ > 0 && read_all(socket_, reinterpret_cast<char*>(&length), sizeof length);
  open_because.assign(ready ? length : 0, '\0');
  if (ready && read_all(socket_, open_because.data(), length)) return;
  close(socket_);
  munmap(shared, sizeof(Progress));
  if (pid_ < 0) throw std::system_error(error, std::generic_category(), "no process for a worker");
  const auto status = reap();
  // Before it is ready it ends of nothing but what the system refuses it, and with that error as its status.
  if (status && WIFEXITED(*status) && WEXITSTATUS(*status) != 0)
    throw std::system_error(WEXITSTATUS(*status), std::generic_category(), "a worker cannot be started");
  throw std::system_error(ECHILD, std::generic_category(), "a worker " + (status ? how_it_ended(*status) : "died"));
}

WorkerProcess::~WorkerProcess() {
  end();
  close(socket_);
  munmap(progress_, sizeof(Progress));
}

double WorkerProcess::processor_seconds() const {
  clockid_t clock;
  timespec had{};
  if (clock_getcpuclockid(pid_, &clock) != 0 || clock_gettime(clock, &had) != 0) return 0;
  return static_cast<double>(had.tv_sec) + 1e-9 * static_cast<double>(had.tv_nsec);
}

std::string WorkerProcess::end() {
  if (pid_ <= 0) return {};
  const auto status = reap();
  return status ? how_it_ended(*status) : "died";
}

std::optional<int> WorkerProcess::reap() {
  // One that has died already keeps what it died of.
  kill(pid_, SIGKILL);
  int status = 0;
  pid_t ended;
  while ((ended = waitpid(pid_, &status, 0)) < 0 && errno == EINTR) continue;
  const bool known = ended == pid_;
  was_killed_ = known && WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL;
  pid_ = 0;
  return known ? std::optional(status) : std::nullopt;
}

}  // namespace blossom
