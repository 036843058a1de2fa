#pragma once
// What went wrong with a value that is neither right nor carried: a misconception, which is a wrong rule of the
// algorithm's own list, or a slip of the pen.
//
// A misconception is looked for with one replay in which its wrong rule makes every value it applies to, while answered
// values are what was answered: then a cell shows it when it is what the wrong rule gives there, or what the right rule
// gives on values that nobody asked and the wrong rule made (alpha wrong, only P asked).

#include <optional>
#include <string>

#include "grader/answers.hpp"
#include "grader/carry.hpp"

namespace blossom {

// What each misconception makes of each part where everything answered before is right, or nothing is: worked out once.
class KnownMistakes {
 public:
  KnownMistakes(const Exercise&, const ReplayPlan&);
  const Misconception* find(std::size_t part, const Numbers<Exact>& typed) const;

 private:
  struct Mistake {
    const Misconception* misconception;
    Numbers<Exact> typed;
  };
  const Exercise* exercise_;
  std::vector<std::vector<Mistake>> of_part_;
};

// The same on somebody's own values: tries every misconception on the parts that are still open, in one or a few
// replays each.
class OwnMistakes {
 public:
  OwnMistakes(const Exercise& exercise, const ReplayPlan& plan) : exercise_(&exercise), plan_(&plan) {}
  // By part: the misconception, or nullptr. `typed` of a part is empty where there is nothing to explain.
  std::vector<const Misconception*> find(const std::vector<Given>& given,
                                         const std::vector<Numbers<Exact>>& typed) const;

 private:
  const Exercise* exercise_;
  const ReplayPlan* plan_;
};

// A slip against the expected value: a sign, two coordinates exchanged, two digits transposed. In words. What is meant
// must be within the tolerance; of transposed digits it must be the expected number itself, rounded to so many digits:
// otherwise any digit behind those that count could be exchanged with one that does.
std::optional<std::string> find_slip(const Part&, NumbersView<Exact> expected, const Typed&);

}  // namespace blossom
