#pragma once
// The run of an exercise as its page tells it: the right one beside the student's, as far as the level of feedback
// allows. Nothing else on the page reads numbers of the run, so what is not told here is not in the file.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/narrate.hpp"
#include "grader/result.hpp"

namespace blossom {

// How a value stands with the student.
enum class Standing : std::uint8_t { given, made, right, carried, wrong, missing, unreadable };
Standing standing_of(Verdict);

// What was typed for a value, on one line, of bounded length.
std::string typed_text(const Json&);

class StudentRun {
 public:
  explicit StudentRun(const ExerciseResult&);
  StudentRun(const StudentRun&) = delete;
  StudentRun& operator=(const StudentRun&) = delete;

  const Exercise& exercise() const { return *exercise_; }
  const Trace<Exact>& trace() const { return exercise_->run.trace; }
  const Narrator<Exact>& narrator() const { return right_; }

  bool tells_right() const { return tells_right_; }  // level full
  bool tells_own() const { return tells_own_; }      // there is something of theirs that is told, and not simply right
  bool any_told() const { return tells_right_ || tells_own_; }

  // What was typed for each part; nullptr: nothing, or the level hides even that it was read.
  const std::vector<const Json*>& typed() const { return answers_; }

  // The steps worth telling, in order, the first (what is given) among them, and how many were left out.
  const std::vector<std::uint32_t>& steps() const { return steps_; }
  std::size_t left_out() const { return left_out_; }

  Standing standing(ValueId v) const { return standing_[v]; }
  // Whether their value is told; then own() and own_text() are theirs.
  bool knows(ValueId v) const { return known_[v] != 0; }
  // Whether it may stand in a picture: a point typed without its weight may, and yet no formula.
  bool shows(ValueId v) const { return known_[v] != 0 || shown_[v] != 0; }
  bool differs(ValueId v) const { return differs_[v] != 0; }  // from the right value
  NumbersView<Exact> own(ValueId v) const { return own_trace_->numbers(v); }
  std::string own_text(ValueId v) const;
  std::string right_text(ValueId v) const;  // only to be told where tells_right()
  // The formula with their numbers in it; empty where some of them are not told.
  std::string own_numbers(ValueId v) const;
  // What the right rule gives on their numbers, where they have something else; level full alone.
  const std::string& expected_text(ValueId v) const { return expected_text_[v]; }
  NumbersView<Exact> expected(ValueId v) const { return expected_[v]; }

 private:
  class OwnTrace;
  void read_answers(const ExerciseResult&);
  void replay();
  void put_in(const OwnTrace& own);
  std::string text_of(const Narrator<Exact>&, ValueId v) const;
  void choose_steps();

  const Exercise* exercise_;
  const Grade* grade_ = nullptr;
  Narrator<Exact> right_;
  bool tells_right_ = false, tells_own_ = false;
  ReplayPlan plan_;
  std::vector<char> needed_;
  std::vector<const Json*> answers_;
  std::vector<Typed> typed_;
  std::vector<std::uint32_t> steps_;
  std::size_t left_out_ = 0;
  std::vector<Standing> standing_;
  std::vector<char> known_, shown_, differs_, decimal_;
  std::vector<Numbers<Exact>> expected_;
  std::vector<std::string> expected_text_;
  std::unique_ptr<Run<Exact>> own_run_;
  const Trace<Exact>* own_trace_ = nullptr;
  std::optional<Narrator<Exact>> own_;
};

}  // namespace blossom
