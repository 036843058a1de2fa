#pragma once
// What somebody gets who holds a misconception, and what a slip of the pen makes: the two kinds of mistakes that are
// known by what comes of them. Which of them an answer shows is decided in explain.hpp and grade.hpp.
//
// A misconception's predictions for an asked value are
//   - what its wrong rule gives there on the right operands;
//   - what comes of it when it made everything before as well;
//   - the same two on somebody's own operands (Replayed with the wrong rule in place of the right one).
// "What comes of it" is also where the right rule follows on values nobody asked that the wrong rule made (alpha wrong,
// only P asked). Of a misconception that can give several values (a span off by one either way) each counts, up to
// most_candidates.

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "grader/answers.hpp"
#include "grader/carry.hpp"

namespace blossom {

// A set of the algorithm's misconceptions, by their places in its list.
using Held = std::uint64_t;
inline constexpr std::size_t most_misconceptions = 64;
inline constexpr std::size_t most_candidates = 4;  // of one misconception for one value
inline Held held(std::size_t misconception) { return Held{1} << misconception; }

// A value with what somebody has for it and for all others. Where their values make one impossible, the right one
// stands.
class OwnSite final : public Site {
 public:
  OwnSite(const Exercise& exercise, const Replayed& replayed) : exercise_(&exercise), replayed_(&replayed) {}
  void go_to(ValueId v) { value_ = v; }
  // What somebody with this misconception makes of v.
  std::vector<Numbers<Exact>> candidates(const Misconception& misconception, ValueId v) {
    go_to(v);
    return misconception.wrong(*this);
  }

  const Trace<Exact>& trace() const override { return exercise_->run.trace; }
  const Inputs<Exact>& inputs() const override { return exercise_->run.inputs; }
  ValueId value() const override { return value_; }
  NumbersView<Exact> numbers(ValueId v) const override {
    const auto own = replayed_->own(v);
    return own.empty() ? trace().numbers(v) : own;
  }

 private:
  const Exercise* exercise_;
  const Replayed* replayed_;
  ValueId value_ = absent;
};

// Replays with one misconception or two, once for each choice of their candidates, and calls seen(part, traced) with
// all that they make of these parts. Where both apply the first makes the value, and then, in further replays, the
// second.
template <class Seen>
void replay_with(const Exercise& exercise, const std::vector<const Misconception*>& misconceptions, Replayed& replayed,
                 const std::vector<Given>& given, const std::vector<std::size_t>& parts, Seen&& seen) {
  OwnSite site(exercise, replayed);
  // All that any of them makes of v, the first one's first.
  const auto candidates_at = [&](ValueId v) {
    site.go_to(v);
    auto candidates = misconceptions.front()->wrong(site);
    for (std::size_t m = 1; m < misconceptions.size(); ++m)
      for (auto& candidate : misconceptions[m]->wrong(site)) candidates.push_back(std::move(candidate));
    return candidates;
  };
  std::size_t most = 1;
  for (std::size_t choice = 0; choice < most; ++choice) {
    replayed.run(given, [&](ValueId v) {
      auto candidates = candidates_at(v);
      if (candidates.empty()) return Numbers<Exact>();
      most = std::max(most, std::min(candidates.size(), most_candidates));
      return std::move(candidates[std::min(choice, candidates.size() - 1)]);
    });
    for (const std::size_t i : parts) {
      const ValueId v = exercise.parts[i].value;
      for (const auto& candidate : candidates_at(v)) seen(i, NumbersView<Exact>(candidate));
      seen(i, replayed.expected(v));
    }
  }
}

// How likely a number that somebody makes up hits another one: by the tolerance's width, in what the exercise's numbers
// of the kind span; and where a fraction is meant, by how many there are of its size or simpler: 1/2 is hit more easily
// than 8/15. Of n/d, there are about 0.3 d^2 + 0.7 d in each unit (3/pi^2 d^2: Farey's sequence). The larger of the
// two; of a whole number 1/4, since whoever is wrong there is wrong by little; never less than 2^-20, of numbers nobody
// guesses.
class Guessing {
 public:
  explicit Guessing(const Exercise&);
  double chance(const Part&, const Numbers<Exact>& typed) const;

 private:
  static std::pair<ValueKind, Form> kind_of(const Part&);
  std::map<std::pair<ValueKind, Form>, std::vector<double>> spans_;  // of each coordinate
};

// What one or two misconceptions make of each part where all that was answered before is right, or nothing is.
struct MistakenValue {
  Held held = 0;
  Numbers<Exact> typed;
  Window first;  // of its first number
  double chance = 0;
};

// All of them, worked out once, when first asked for: whoever has everything right needs none.
class MistakenValues {
 public:
  MistakenValues(const Exercise&, const ReplayPlan&);
  ~MistakenValues();

  // In the order of the algorithm's list; none that is the right value.
  const std::vector<std::vector<MistakenValue>>& of_singles() const;  // by part
  // Only what neither of the two predicts alone.
  const std::vector<std::vector<MistakenValue>>& of_pairs() const;
  // By value: which misconceptions apply to it. By part: which make something else of it than the right value.
  const std::vector<Held>& act_on() const;
  const std::vector<Held>& differ_at() const;
  const Guessing& guessing() const;

 private:
  struct Singles;
  const Singles& singles() const;
  void predict(Held, const std::vector<const Misconception*>&, std::vector<std::vector<MistakenValue>>&) const;

  const Exercise* exercise_;
  const ReplayPlan* plan_;
  mutable std::once_flag singles_made_, pairs_made_;
  mutable std::unique_ptr<Singles> singles_;
  mutable std::vector<std::vector<MistakenValue>> pairs_;
};

// Whether what was typed is what is predicted, within the part's tolerance.
bool agrees(const Part&, const MistakenValue&, const Numbers<Exact>& typed, double first_typed);

// A slip against the expected value: a sign, two coordinates exchanged, two digits transposed. What is meant must be
// within the tolerance; of transposed digits it must be the expected number itself, rounded to so many digits:
// otherwise any digit behind those that count could be exchanged with one that does.
struct Slip {
  std::string_view note;  // see PartGrade::note
  std::string text;       // a sentence
};
std::optional<Slip> find_slip(const Part&, NumbersView<Exact> expected, const Typed&);

// Whether it is the expected value rounded, or cut off, to the decimals that were typed: at least two digits of each
// number that is not within the tolerance, behind a decimal point where there is one.
bool is_rounded(const Part&, NumbersView<Exact> expected, const Typed&);

// The only coordinate of a point that is not the expected one, as a word; nothing unless there is exactly one.
std::optional<std::string> only_wrong_coordinate(const Part&, NumbersView<Exact> expected, const Typed&,
                                                 const std::vector<double>& widening);

}  // namespace blossom
