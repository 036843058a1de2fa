#pragma once
// What frames took, for `blossom play --times`.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "player/ui/frame_parts.hpp"

namespace blossom {

// Since this process was started, dynamic linking included; nothing where /proc does not tell. Linux keeps the start to
// the hundredth of a second.
std::optional<double> seconds_since_process_start();
double processor_seconds();  // of all threads of this process

class FrameTimes {
 public:
  // A part of the start is over; `what` it was.
  void started(const char* what);
  // A frame is on the screen. `before`: what the player did before it (motion, files); `presented`: from the frame's
  // last command to OpenGL until the window system had it.
  void presented(double before, const FrameParts&, double presented);
  std::string report() const;

 private:
  struct Part {
    const char* what;
    double until;  // since the process was started
  };
  struct Times {
    double changes, panels, painting, rasterising;
  };
  std::vector<Part> parts_;
  std::vector<Times> frames_;
  double first_frame_ = 0, first_frame_processor_ = 0;
};

}  // namespace blossom
