#pragma once
// One worker of the pool, seen from outside: a forked process, the socket to it, and the word of shared memory in which
// it says how far it is. Internal to workers.cpp.
//
// To the worker: frames, each {count of items, bytes of them} and the items, each {length} and its bytes. From the
// worker: a hello {length} and the reason why it is not closed off; then an answer to each item in order, {length,
// kind} and its bytes. All numbers are 32 bits as this machine has them.

#include <sys/types.h>

#include <atomic>
#include <cstring>
#include <optional>
#include <string>

#include "grader/batch/workers.hpp"

namespace blossom {

using Word = std::uint32_t;

struct FrameHead {
  Word items = 0;
  Word bytes = 0;
};
struct AnswerHead {
  Word length = 0;
  Word kind = 0;  // 0: the answer; 1: Work failed, and why
};
inline constexpr std::size_t most_reason = 1000;  // bytes of why

template <class T>
void append_raw(std::string& to, const T& value) {
  to.append(reinterpret_cast<const char*>(&value), sizeof value);
}
template <class T>
T read_raw(const char* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

// What a worker says about itself without a system call: twice the number of items it has done since it was started,
// and one more while it works on the next. Alone in its line of the cache.
struct alignas(64) Progress {
  std::atomic<std::uint64_t> value{0};
};

class WorkerProcess {
 public:
  // Waits for the process to say that it is ready; `open_because` gets what it says. Throws std::system_error.
  WorkerProcess(const Workers::Work&, const WorkerOptions&, std::string& open_because);
  ~WorkerProcess();  // ends it if it has not ended
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  int socket() const { return socket_; }
  std::uint64_t progress() const { return progress_->value.load(std::memory_order_acquire); }
  double processor_seconds() const;  // that it has had
  // Ends it and says what it had died of before, if it had: "died of signal 11 (SIGSEGV)".
  std::string end();
  // After end(): whether SIGKILL ended it. It can bring that on itself only by using up the machine's memory.
  bool was_killed() const { return was_killed_; }

 private:
  std::optional<int> reap();  // ends it; its status

  pid_t pid_ = -1;
  bool was_killed_ = false;
  int socket_ = -1;
  Progress* progress_ = nullptr;
};

}  // namespace blossom
