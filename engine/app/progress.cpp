#include "app/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>

namespace blossom {
namespace {

constexpr double first_after = 1, again_after = 0.1;  // seconds
constexpr std::size_t bar_width = 30;

double seconds_between(std::chrono::steady_clock::time_point from, std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

std::string time_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  return whole < 100 ? std::to_string(whole) + " s" : std::to_string((whole + 59) / 60) + " min";
}

}  // namespace

Progress::Progress(Form form) : form_(form), on_terminal_(isatty(STDERR_FILENO) != 0) {}

void Progress::clear() {
  const std::lock_guard lock(mutex_);
  if (visible_) std::cerr << "\r\x1b[K" << std::flush;
  visible_ = false;
}

void Progress::show(std::size_t done, std::size_t of) {
  const std::lock_guard lock(mutex_);
  if (of == 0) return;
  if (form_ == Form::lines) {
    if (done != last_done_) std::cout << "progress " << done << " " << of << std::endl;
    last_done_ = done;
    return;
  }
  const auto now = Clock::now();
  const double passed = seconds_between(begun_, now);
  if (!on_terminal_ || passed < first_after || (visible_ && seconds_between(shown_, now) < again_after)) return;
  const double share = static_cast<double>(done) / static_cast<double>(of);
  const auto full = static_cast<std::size_t>(share * static_cast<double>(bar_width));
  const std::string percent = std::to_string(static_cast<int>(100 * share));
  std::string line = std::string(3 - std::min<std::size_t>(percent.size(), 3), ' ') + percent + "% [" +
                     std::string(full, '=') + std::string(bar_width - full, ' ') + "]";
  if (done > 0 && done < of) line += " " + time_text(passed * (1 - share) / share) + " left";
  std::cerr << "\r" << line << "\x1b[K" << std::flush;
  visible_ = true;
  shown_ = now;
}

}  // namespace blossom
