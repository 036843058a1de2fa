#pragma once
// Undo and redo without limit, for any value.

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace blossom {

template <class T>
class History {
 public:
  explicit History(T first) { states_.push_back({std::move(first), {}, {}}); }

  const T& current() const { return states_[at_].value; }

  // A new state. `what` is said in "Undo ..."; pushes with the same `gesture` (not empty: one drag, one slider held)
  // one after the other are one state.
  void push(T value, std::string what, std::string gesture = {}) {
    if (!gesture.empty() && at_ > 0 && at_ + 1 == states_.size() && states_[at_].gesture == gesture) {
      states_[at_].value = std::move(value);
      states_[at_].what = std::move(what);
      return;
    }
    states_.resize(at_ + 1, states_.front());
    states_.push_back({std::move(value), std::move(what), std::move(gesture)});
    ++at_;
  }
  // The gesture is over: the next push is a state of its own.
  void end_gesture() { states_[at_].gesture.clear(); }

  // The state of a gesture that is not over goes, as if it had never been. False: there is none.
  bool cancel_gesture() {
    if (at_ == 0 || at_ + 1 != states_.size() || states_[at_].gesture.empty()) return false;
    states_.resize(at_, states_.front());
    --at_;
    return true;
  }

  bool can_undo() const { return at_ > 0; }
  bool can_redo() const { return at_ + 1 < states_.size(); }
  std::string undo_what() const { return can_undo() ? states_[at_].what : std::string(); }
  std::string redo_what() const { return can_redo() ? states_[at_ + 1].what : std::string(); }
  bool undo() {
    if (!can_undo()) return false;
    end_gesture();
    --at_;
    return true;
  }
  bool redo() {
    if (!can_redo()) return false;
    ++at_;
    return true;
  }
  std::size_t size() const { return states_.size(); }
  std::size_t at() const { return at_; }  // which of the states is the current one
  const T& state(std::size_t i) const { return states_[i].value; }

 private:
  struct State {
    T value;
    std::string what, gesture;
  };
  std::vector<State> states_;
  std::size_t at_ = 0;
};

}  // namespace blossom
