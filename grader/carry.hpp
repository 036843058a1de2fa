#pragma once
// Error carried forward: the graph of a run with somebody's own values put in. A value that was answered is what was
// answered; every other one is made again by its rule, from what its operands are now. So `expected` of an answered
// value is what the right rule gives on that person's own operands.
//
// The same replay with some rules replaced by wrong ones is what comes of misconceptions: see diagnose.hpp.

#include <algorithm>
#include <vector>

#include "grader/exercise.hpp"

namespace blossom {

// Which values of an exercise's run matter: the asked ones and all they are made from, in the order they are made.
struct ReplayPlan {
  explicit ReplayPlan(const Exercise&);
  static constexpr std::int32_t not_asked = -1;

  std::vector<ValueId> order;         // without the inputs
  std::vector<std::int32_t> part_of;  // by value; not_asked
};

// What is put in for a part.
struct Given {
  enum class Kind : std::uint8_t { nothing, right, typed };
  Kind kind = Kind::nothing;
  Numbers<Exact> numbers = {};        // as typed
  std::vector<double> rounding = {};  // how far the number meant may be from the one typed; empty: not at all
};

class Replayed {
 public:
  // Following the rounding of operands costs more than the values themselves.
  enum class Rounding : std::uint8_t { followed, ignored };
  Replayed(const Exercise& exercise, const ReplayPlan& plan, Rounding rounding = Rounding::followed);

  // Puts `given` in, one for each part, and makes the rest again. wrong(v) may make a value that is not given in place
  // of its rule; it returns no numbers where it does not apply.
  template <class Wrong>
  void run(const std::vector<Given>& given, Wrong&& wrong);
  void run(const std::vector<Given>& given) {
    run(given, [](ValueId) { return Numbers<Exact>(); });
  }

  // What that person has for v; empty where their values make it impossible (a division by zero).
  NumbersView<Exact> own(ValueId v) const { return own_[v]; }
  // What v's rule gives on their operands; empty likewise.
  NumbersView<Exact> expected(ValueId v) const { return expected_[v]; }
  // Whether they have something else than the right value.
  bool changed(ValueId v) const { return changed_[v] != 0; }
  bool operands_changed(ValueId v) const;
  // By value: whether their operands leave nothing to be done there.
  //   A point or a number: an operand of its own kind, copied, would pass for it (they are all equal, or the ratio is 0
  //     or 1); or all of them are zero; or all are trivial themselves and were not answered, so that what these were
  //     made from decides.
  //   A list: fewer different numbers than the right one has (a parameter that fell on an end or on its neighbour); or
  //     every operand that changed is trivial and was not answered.
  // What passes and what is different is up to the part's tolerance; where nothing is asked, to the exercise's.
  std::vector<char> trivial() const;
  // How far each typed number of a part may be from `expected` because of its operands' rounding. First order.
  std::vector<double> widening(const Part&) const;

 private:
  struct Made {
    Numbers<Exact> own;
    Numbers<Exact> expected;
    std::vector<double> rounding;           // of own
    std::vector<double> expected_rounding;  // of expected
  };
  void start();
  bool make(ValueId v, Numbers<Exact>& made);
  void put_in(ValueId v, const Part& part, const Given& given);
  bool is_trivial(ValueId v, const std::vector<char>& trivial) const;
  bool is_trivial_list(ValueId v, const std::vector<char>& trivial) const;
  const Tolerance& tolerance(ValueId v) const;
  std::vector<double> rounding_through_rule(ValueId v) const;

  const Exercise* exercise_;
  const ReplayPlan* plan_;
  Rounding rounding_;
  std::vector<NumbersView<Exact>> own_;
  std::vector<NumbersView<Exact>> expected_;
  std::vector<char> changed_;
  std::vector<char> given_;
  std::vector<Made> made_;
  std::vector<NumbersView<Exact>> operands_;
};

template <class Wrong>
void Replayed::run(const std::vector<Given>& given, Wrong&& wrong) {
  const auto& trace = exercise_->run.trace;
  start();
  for (const ValueId v : plan_->order) {
    Made& made = made_[v];
    const bool from_changed = operands_changed(v);
    if (from_changed) {
      if (!make(v, made.expected)) made.expected.clear();
      expected_[v] = made.expected;
      if (rounding_ == Rounding::followed) made.expected_rounding = rounding_through_rule(v);
    }
    const std::int32_t part = plan_->part_of[v];
    const Given* own = part == ReplayPlan::not_asked ? nullptr : &given[static_cast<std::size_t>(part)];
    if (own != nullptr && own->kind != Given::Kind::nothing) {
      given_[v] = 1;
      if (own->kind == Given::Kind::typed) put_in(v, exercise_->parts[static_cast<std::size_t>(part)], *own);
      continue;
    }
    if (auto replaced = wrong(v); !replaced.empty()) {
      made.own = std::move(replaced);
      made.rounding.clear();
      own_[v] = made.own;
    } else if (from_changed) {
      made.rounding = made.expected_rounding;
      own_[v] = expected_[v];
    }
    changed_[v] = std::ranges::equal(own_[v], trace.numbers(v)) ? 0 : 1;
  }
}

}  // namespace blossom
