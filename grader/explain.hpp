#pragma once
// One explanation of all that is wrong in an answer: the misconception, or the pair of them, that a student holds
// throughout, told from mere slips and from chance.
//
// The idea is that of BUGGY and DEBUGGY (Brown and Burton, 1978; Burton, 1982): known wrong rules, alone and two at a
// time, are run on the whole exercise, and the smallest set that reproduces the most of the answer is the diagnosis.
// VanLehn (Mind Bugs, 1990) adds what is observed there ever since: besides bugs there are slips, which come and go, so
// a diagnosis must not demand that a rule is broken everywhere, and must not take for a bug what a slip does as well.
//
// A value is wrong here if it is neither right nor carried; voided parts do not count. A misconception covers a wrong
// value that is one of its predictions (diagnose.hpp). A pair covers what either covers and what comes of both
// together. Of all that can be claimed, the explanation is the one that
//   covers the most wrong values; of these
//   the smaller; then
//   the one with fewer values that are right although the wrong rule would have made something else; then
//   the first of the algorithm's list.
//
// What can be claimed: what chance does not do as well. Each misconception must stand by itself: it is judged by those
// values only that stay uncovered without it. A value that is covered tells -log2 q bits, q being the chance that a
// number somebody makes up is one of the predictions (Guessing in diagnose.hpp). The distribution of the bits that
// accidental hits among the wrong values would tell is a small convolution, so the chance of at least as many is known
// exactly (up to rounding: half bits, 40 at most). Times the misconceptions that make something else than the right
// value of what is covered (squared where only both together make it), this is how many would fit so well by accident.
// It must be below 1/40 for single ones and for pairs, so that of a class that hands in nothing but noise at most every
// twentieth gets a name. Otherwise the explanation is unknown, though a value may still be named for itself.
//
// Nor is claimed what the answer contradicts. A wrong value denies a misconception that acts there and would make
// something else, neither this value nor, in a pair, left to the other one. Once may be a slip; from two on, those that
// deny it must not be more than those that it covers: neither of all, nor of those whose operands are right, where no
// earlier mistake of their own can be what made the difference. (Another student's answers fit a misconception in their
// last levels, if that turns one's parameter into the other's, but not in the first.) Values that are right do not
// count in this, since bugs come and go; but of one value alone, where two or more others remain unexplained, two
// values of any kind at which the misconception would show and does not are enough.
//
// Slip or misconception, where a value can be either: it is the misconception if that covers another value too, or if
// it is the only value where it can show; it is the slip if the student had the chance to break the rule elsewhere, and
// did not.

#include <cstddef>
#include <string_view>
#include <vector>

#include "grader/diagnose.hpp"

namespace blossom {

struct Explanation {
  std::vector<const Misconception*> misconceptions;  // one or two; none: unknown
  std::size_t covered = 0;                           // values that are wrong and explained, of
  std::size_t wrong = 0;                             // all that are neither right nor carried
  double chance = 1;                                 // how many hypotheses would fit so well by accident
};

// An answer as far as it is judged: all by part.
struct Symptoms {
  const std::vector<Given>* given = nullptr;  // as meant
  const Replayed* meant = nullptr;            // replays of it, as meant
  const Replayed* written = nullptr;          // and as written down; may be null
  const std::vector<Typed>* typed = nullptr;  // of those that are open
  std::vector<char> fine;                     // right or carried
  std::vector<std::size_t> open;              // the parts that are to be explained
};

class Explainer {
 public:
  Explainer(const Exercise&, const ReplayPlan&);
  class Case;

 private:
  const Exercise* exercise_;
  const ReplayPlan* plan_;
  MistakenValues predictions_;
};

// One answer. `k` counts its open parts.
class Explainer::Case {
 public:
  Case(const Explainer&, const Symptoms&);

  // The misconception that explains this value for itself, on the right or on their own operands; or nullptr.
  const Misconception* alone(std::size_t k) const;
  // Whether a slip would be the better explanation of it, if it is one.
  bool may_be_slip(std::size_t k) const;
  // It is one: no misconception covers it.
  void is_slip(std::size_t k);

  // Of all together, after the slips are known; nothing where no part counts.
  std::optional<Explanation> explain();
  // Whether the wrong values that are not its own speak against it.
  bool is_contradicted(std::size_t m) const;
  // Which misconception of that explanation acts here; nullptr where it covers nothing.
  const Misconception* acts_at(std::size_t k) const;

 private:
  struct Hypothesis {
    Held held = 0;
    std::vector<char> covers;            // by k
    std::vector<double> chance_jointly;  // by k, of a pair: to hit what comes of both together
    bool jointly = false;                // whether that covers any
    std::size_t covered = 0;
    std::size_t contradicted = 0;
  };
  // What a misconception is to an open part.
  struct Fit {
    bool known = false;      // one of its predictions on right operands
    bool own = false;        // or on their own, within the tolerance
    bool covered = false;    // either, or within what rounding does
    std::uint8_t tries = 0;  // predictions on their own operands
  };

  const Part& part(std::size_t k) const { return exercise_->parts[symptoms_->open[k]]; }
  const Numbers<Exact>& typed(std::size_t k) const { return (*symptoms_->typed)[symptoms_->open[k]].numbers; }
  bool counts(std::size_t k) const { return part(k).voided == Voided::no; }
  Fit& fit(std::size_t m, std::size_t k) { return fits_[m * size_ + k]; }
  const Fit& fit(std::size_t m, std::size_t k) const { return fits_[m * size_ + k]; }

  void compare_with_known();
  void find_what_is_hidden();
  void compare_with_own();
  void compare_with_own(std::size_t m, std::size_t k, NumbersView<Exact> traced, bool strictly);
  bool is_near(std::size_t k, const Numbers<Exact>& predicted) const;
  std::vector<Hypothesis> singles() const;
  void add_pairs(std::vector<Hypothesis>&);
  // Whether both can have made what comes before part k, or one that and the other the value, so that only a replay
  // with both tells what comes of it.
  bool may_act_jointly(Held pair, std::size_t k) const;
  void replay_pair(Hypothesis&);
  std::size_t contradicted(Held) const;
  bool is_denied(std::size_t m, const std::vector<char>& explained) const;
  double chance(const Hypothesis&) const;
  double chance_by_itself(const Hypothesis&, std::size_t m) const;
  double guess(std::size_t m, std::size_t k) const;

  const MistakenValues* predictions_;
  const Exercise* exercise_;
  const ReplayPlan* plan_;
  const Symptoms* symptoms_;
  std::size_t size_;   // open parts
  std::size_t count_;  // misconceptions
  std::vector<Fit> fits_;
  std::vector<double> first_typed_;            // by k
  std::vector<std::vector<double>> widening_;  // by k
  std::vector<Held> hidden_;                   // by k: who acts on values before it that were not answered
  std::vector<char> on_own_;                   // by k: whether its predictions may not be the known ones
  std::optional<Replayed> scratch_;
  std::optional<Hypothesis> best_;
};

}  // namespace blossom
