#pragma once
// Where one is in a trace: the step, the values alive at it, the phases around it; and how to move. No clock, no input
// or output: who owns a clock calls advance() with the seconds that passed.

#include <optional>
#include <utility>
#include <vector>

#include "trace/trace.hpp"

namespace blossom {

// What there is at one step. Moving by one step changes only what that step makes and retires.
struct TimelineState {
  std::uint32_t step = 0;
  std::vector<ValueId> alive;         // in ascending order
  std::vector<std::uint32_t> phases;  // around the step, from the outermost

  bool is_alive(ValueId) const;
  bool operator==(const TimelineState&) const = default;
};

class Timeline {
 public:
  // The trace must live as long as the timeline and have at least one step. Starts at step 0, paused, one step a
  // second.
  explicit Timeline(const TraceGraph&);

  const TimelineState& state() const { return state_; }
  std::uint32_t position() const { return state_.step; }
  std::uint32_t last() const { return trace_->step_count() - 1; }
  bool at_end() const { return position() == last(); }

  // Moves; a place beyond the last step is the last step. True if the position changed. Each of them begins the step it
  // arrives at anew (see fraction()).
  bool seek(std::uint32_t step);
  bool forward();
  bool back();
  bool over();  // forward, but from a step that introduces a phase to the first one behind that phase
  bool out();   // to the last step of the phase one is in; from there, of the phase around it; at last to the end

  // Steps of note, such as the beats of a lesson.
  void set_marks(std::vector<std::uint32_t> steps);
  const std::vector<std::uint32_t>& marks() const { return marks_; }  // ascending, each once
  bool next_mark();
  bool previous_mark();

  // Playing. At the end it pauses, unless a range is repeated: from behind its last step play goes on at its first.
  void play();  // at the end (of the range): from the beginning
  void pause() { playing_ = false; }
  bool playing() const { return playing_; }
  void set_speed(double steps_per_second);  // above 0
  double speed() const { return speed_; }
  void set_loop(std::uint32_t first, std::uint32_t last);  // one step only: no loop
  void clear_loop() { loop_.reset(); }
  std::optional<std::pair<std::uint32_t, std::uint32_t>> loop() const { return loop_; }
  bool advance(double seconds);                  // while playing; true if the position changed
  double fraction() const { return fraction_; }  // how much of the time of this step has passed, in [0, 1)

 private:
  void step_forward();
  void step_back();
  void rebuild(std::uint32_t step);
  std::uint32_t end_of_play() const { return loop_ ? loop_->second : last(); }

  const TraceGraph* trace_;
  std::vector<std::pair<std::uint32_t, ValueId>> retired_;  // by the step at which they go
  TimelineState state_;
  std::vector<std::uint32_t> marks_;
  std::optional<std::pair<std::uint32_t, std::uint32_t>> loop_;
  double speed_ = 1;
  double fraction_ = 0;
  bool playing_ = false;
};

}  // namespace blossom
