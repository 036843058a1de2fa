#pragma once
// Grading: one exercise, many submissions. A Grader works out once what it can, and is then asked for each submission;
// it is not changed by that, so several threads may share it.

#include "grader/answers.hpp"
#include "grader/carry.hpp"
#include "grader/diagnose.hpp"

namespace blossom {

enum class Verdict : std::uint8_t {
  correct,        // the right value, within the tolerance
  carried,        // the right rule on their own earlier values, which do not make it trivial
  misconception,  // a wrong rule of the algorithm's list on the right or their own values
  slip,           // right but for a sign, exchanged coordinates or transposed digits
  wrong,
  missing,
  invalid,  // not of the part's shape, or the whole submission cannot be read
};
inline constexpr std::size_t verdict_count = 7;
std::string_view verdict_name(Verdict);

// What is said of a misconception: its title and its advice, as sentences.
std::string advice_of(const Misconception&);

struct PartGrade {
  Verdict verdict = Verdict::missing;
  Exact points = 0;
  std::string feedback;              // as much as the exercise allows
  std::string_view misconception{};  // its id, if that is the verdict
};

struct Grade {
  const Exercise* exercise = nullptr;
  std::string student;           // who handed it in; may be empty
  std::vector<PartGrade> parts;  // one for each of the exercise's
  Exact points = 0;
  std::string reason;              // why the whole is invalid; empty if it is not
  std::vector<std::string> notes;  // what was ignored

  double score() const;  // points / max_points
};

class Grader {
 public:
  explicit Grader(Exercise exercise);
  Grader(const Grader&) = delete;
  Grader& operator=(const Grader&) = delete;

  const Exercise& exercise() const { return exercise_; }
  Grade grade(const Checked<JsonDocument>& answers, std::string student = {}) const;

 private:
  struct Open;
  void explain(const Answers&, Grade&) const;
  void judge(const Open&, Grade&) const;
  std::string feedback(const Part&, Verdict, std::string_view what) const;

  Exercise exercise_;
  ReplayPlan plan_;
  KnownMistakes known_mistakes_;
  OwnMistakes own_mistakes_;
  std::vector<char> right_is_trivial_;  // by part: the exercise itself leaves nothing to compute there
};

}  // namespace blossom
