#include "player/window/frame_times.hpp"

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace blossom {
namespace {

double seconds_of(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

std::string line(const char* format, auto... numbers) {
  char text[160];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

}  // namespace

std::optional<double> seconds_since_process_start() {
  // proc(5): the 22nd field is the start in clock ticks since the system was started; the second, in parentheses, may
  // hold blanks.
  std::ifstream file("/proc/self/stat");
  std::string text;
  std::getline(file, text);
  const std::size_t behind_name = text.rfind(')');
  if (behind_name == std::string::npos) return std::nullopt;
  std::istringstream rest(text.substr(behind_name + 1));
  std::string field;
  for (int i = 3; i <= 22; ++i) rest >> field;
  const double ticks = std::strtod(field.c_str(), nullptr);
  if (!rest || !(ticks > 0)) return std::nullopt;
  return seconds_of(CLOCK_BOOTTIME) - ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double processor_seconds() { return seconds_of(CLOCK_PROCESS_CPUTIME_ID); }

void FrameTimes::started(const char* what) { parts_.push_back({what, processor_seconds()}); }

void FrameTimes::presented(double before, const FrameParts& parts, double presented) {
  if (frames_.empty()) {
    first_frame_ = seconds_since_process_start().value_or(0);
    first_frame_processor_ = processor_seconds();
  }
  frames_.push_back({before + parts.changes, parts.panels, parts.painting, parts.drawing + presented});
}

std::string FrameTimes::report() const {
  if (frames_.empty()) return "no frame was shown\n";
  std::string text = line("first frame: %.0f ms after the start of the process (processor time %.0f ms)\n",
                          first_frame_ * 1e3, first_frame_processor_ * 1e3);
  double before = 0;
  for (const Part& part : parts_) {
    text += line("  %-28s %6.1f ms of processor time\n", part.what, (part.until - before) * 1e3);
    before = part.until;
  }
  text += line("  %-28s %6.1f ms of processor time\n", "the frame itself", (first_frame_processor_ - before) * 1e3);
  text += line("frames: %zu\n", frames_.size());
  const auto told = [&](const char* what, auto&& of) {
    std::vector<double> all;
    for (const Times& times : frames_) all.push_back(of(times));
    std::ranges::sort(all);
    text += line("  %-28s median %7.2f ms, slowest %7.2f ms\n", what, all[all.size() / 2] * 1e3, all.back() * 1e3);
  };
  told("changes", [](const Times& t) { return t.changes; });
  told("panels", [](const Times& t) { return t.panels; });
  told("painting", [](const Times& t) { return t.painting; });
  told("own work, all three", [](const Times& t) { return t.changes + t.panels + t.painting; });
  told("rasterising, presenting", [](const Times& t) { return t.rasterising; });
  return text;
}

}  // namespace blossom
