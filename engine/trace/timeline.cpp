#include "trace/timeline.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace blossom {

bool TimelineState::is_alive(ValueId v) const { return std::binary_search(alive.begin(), alive.end(), v); }

Timeline::Timeline(const TraceGraph& trace) : trace_(&trace) {
  assert(trace.step_count() > 0);
  for (ValueId v = 0; v < trace.value_count(); ++v)
    if (const std::uint32_t step = trace.retired_at(v); step != absent) retired_.emplace_back(step, v);
  std::sort(retired_.begin(), retired_.end());
  rebuild(0);
}

void Timeline::rebuild(std::uint32_t step) {
  state_.step = step;
  state_.alive.clear();
  const ValueId end = trace_->values_of(step).second;
  for (ValueId v = 0; v < end; ++v)
    if (trace_->alive(v, step)) state_.alive.push_back(v);
  state_.phases = trace_->phase_path(trace_->step(step).phase);
}

void Timeline::step_forward() {
  const std::uint32_t step = ++state_.step;
  const auto [first, end] = trace_->values_of(step);
  for (ValueId v = first; v < end; ++v) state_.alive.push_back(v);
  const auto gone = std::equal_range(retired_.begin(), retired_.end(), std::pair(step, ValueId{0}),
                                     [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto it = gone.first; it != gone.second; ++it) {
    const auto place = std::lower_bound(state_.alive.begin(), state_.alive.end(), it->second);
    if (place != state_.alive.end() && *place == it->second) state_.alive.erase(place);
  }
  if (trace_->step(step).phase != trace_->step(step - 1).phase)
    state_.phases = trace_->phase_path(trace_->step(step).phase);
}

void Timeline::step_back() {
  const std::uint32_t step = state_.step--;
  const ValueId first = trace_->values_of(step).first;
  while (!state_.alive.empty() && state_.alive.back() >= first) state_.alive.pop_back();
  const auto gone = std::equal_range(retired_.begin(), retired_.end(), std::pair(step, ValueId{0}),
                                     [](const auto& a, const auto& b) { return a.first < b.first; });
  for (auto it = gone.first; it != gone.second; ++it)
    if (it->second < first)
      state_.alive.insert(std::lower_bound(state_.alive.begin(), state_.alive.end(), it->second), it->second);
  if (trace_->step(step).phase != trace_->step(step - 1).phase)
    state_.phases = trace_->phase_path(trace_->step(step - 1).phase);
}

bool Timeline::seek(std::uint32_t step) {
  step = std::min(step, last());
  fraction_ = 0;
  if (step == position()) return false;
  // Near ones are reached step by step; a far one costs no more than a look at every value.
  constexpr std::uint32_t near = 16;
  if (step > position() ? step - position() > near : position() - step > near) {
    rebuild(step);
  } else {
    while (position() < step) step_forward();
    while (position() > step) step_back();
  }
  return true;
}

bool Timeline::forward() { return seek(position() + 1); }

bool Timeline::back() { return position() > 0 && seek(position() - 1); }

bool Timeline::over() {
  const std::uint32_t phase = trace_->introduced_by(position());
  return seek((phase == absent ? position() : trace_->phases()[phase].last_step) + 1);
}

bool Timeline::out() {
  for (auto phase = state_.phases.rbegin(); phase != state_.phases.rend(); ++phase)
    if (const std::uint32_t end = trace_->phases()[*phase].last_step; end > position()) return seek(end);
  return seek(last());
}

void Timeline::set_marks(std::vector<std::uint32_t> steps) {
  marks_ = std::move(steps);
  std::erase_if(marks_, [&](std::uint32_t step) { return step > last(); });
  std::sort(marks_.begin(), marks_.end());
  marks_.erase(std::unique(marks_.begin(), marks_.end()), marks_.end());
}

bool Timeline::next_mark() {
  const auto mark = std::upper_bound(marks_.begin(), marks_.end(), position());
  return mark != marks_.end() && seek(*mark);
}

bool Timeline::previous_mark() {
  const auto mark = std::lower_bound(marks_.begin(), marks_.end(), position());
  return mark != marks_.begin() && seek(*(mark - 1));
}

void Timeline::play() {
  playing_ = true;
  const std::uint32_t first = loop_ ? loop_->first : 0;
  if (position() >= end_of_play() || position() < first) seek(first);
}

void Timeline::set_speed(double steps_per_second) {
  if (steps_per_second > 0 && std::isfinite(steps_per_second)) speed_ = steps_per_second;
}

void Timeline::set_loop(std::uint32_t first, std::uint32_t last_step) {
  first = std::min(first, last());
  last_step = std::min(last_step, last());
  if (first > last_step) std::swap(first, last_step);
  if (first == last_step) return clear_loop();  // one step is nothing to repeat
  loop_.emplace(std::min(first, last_step), last_step);
}

bool Timeline::advance(double seconds) {
  const double time = fraction_ + seconds * speed_;
  if (!playing_ || !(seconds > 0) || !std::isfinite(time)) return false;
  const double whole = std::floor(time);
  const std::uint32_t from = position();
  double target = from + whole;
  if (target > end_of_play() && loop_) {
    const double length = loop_->second - loop_->first + 1.0;
    target = loop_->first + std::fmod(target - loop_->first, length);
  }
  if (target > end_of_play()) {
    seek(last());
    playing_ = false;
  } else {
    seek(static_cast<std::uint32_t>(target));
    fraction_ = time - whole;
  }
  return position() != from;
}

}  // namespace blossom
