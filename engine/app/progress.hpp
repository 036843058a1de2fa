#pragma once
// How far a long command is, on one line of standard error that is written over: percentage, bar, time left. Only on a
// terminal, and only from the second second on. Or, for a program that waits, as lines "progress DONE OF" on standard
// output.

#include <chrono>
#include <cstddef>
#include <mutex>

namespace blossom {

class Progress {
 public:
  enum class Form { bar, lines };
  explicit Progress(Form = Form::bar);
  ~Progress() { clear(); }
  Progress(const Progress&) = delete;

  // From any thread.
  void show(std::size_t done, std::size_t of);
  void clear();  // takes the line away

 private:
  using Clock = std::chrono::steady_clock;

  Form form_;
  std::mutex mutex_;
  Clock::time_point begun_ = Clock::now(), shown_ = begun_;
  std::size_t last_done_ = SIZE_MAX;
  bool on_terminal_, visible_ = false;
};

}  // namespace blossom
