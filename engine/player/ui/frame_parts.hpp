#pragma once
// What the parts of one frame took, in seconds.

#include <time.h>

namespace blossom {

struct FrameParts {
  // Processor time of the player's own thread.
  double panels = 0;    // events, sheets and widgets
  double painting = 0;  // display lists made into triangles
  double changes = 0;   // what panels sent: moves, edits, recording anew
  // By the clock: the commands to OpenGL. A software rasteriser works on after them, in threads of its own.
  double drawing = 0;
  double own() const { return panels + painting + changes; }
};

class Stopwatch {
 public:
  // The processor time of this thread, unless another clock is named: what else the machine does is left out.
  explicit Stopwatch(clockid_t clock = CLOCK_THREAD_CPUTIME_ID) : clock_(clock), before_(now()) {}
  // Seconds since the last lap, or since it was made.
  double lap() {
    const double at = now(), seconds = at - before_;
    before_ = at;
    return seconds;
  }

 private:
  double now() const {
    timespec at{};
    clock_gettime(clock_, &at);
    return static_cast<double>(at.tv_sec) + static_cast<double>(at.tv_nsec) * 1e-9;
  }

  clockid_t clock_;
  double before_;
};

}  // namespace blossom
