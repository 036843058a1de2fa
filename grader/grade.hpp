#pragma once
// Grading: one exercise, many submissions. A Grader works out once what it can, and is then asked for each submission;
// several threads may share it.
//
// Points are a matter of each value for itself: right, carried, one misconception on right or own values, a slip. The
// explanation of the whole answer may then give a wrong value another name (see explain.hpp), so that one name stands
// where one misconception was at work; that never raises its points: it earns the lesser of both shares. A
// misconception that fits a value while the rest of the answer speaks against it is not asserted: the value is wrong
// for no known reason, with the points it has for itself.
//
// Of a voided part everybody gets the points ("credit"), whatever their answer is or lacks, or nobody ("drop": it is
// worth none). A submission that cannot be read at all is none, and earns nothing.

#include <memory>

#include "grader/answers.hpp"
#include "grader/carry.hpp"
#include "grader/diagnose.hpp"
#include "grader/explain.hpp"

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

// Whether this level of feedback tells a student the notes and the explanation; a Grade always holds them, and who
// writes it for a student asks here.
inline bool shows_notes(Feedback level) { return level == Feedback::hint || level == Feedback::full; }

// What is said of a misconception: its title and its advice, as sentences.
std::string advice_of(const Misconception&);

// What goes on for a typed value. A number of many digits does so in double precision: what is made of it must not grow
// from step to step.
Numbers<Exact> to_carry_on(const Typed&);
// A list stands in for a right one only if it has its form: as many numbers, in ascending order.
bool can_carry_on(const Part&, const Typed&);

struct PartGrade {
  Verdict verdict = Verdict::missing;
  Exact points = 0;
  std::string feedback;              // as much as the exercise allows
  std::string_view misconception{};  // its id, if that is the verdict
  // What happened, in one stable word that reports count: a misconception's id; sign, all-signs, coordinates, digits,
  // rounded (the right or carried value in fewer digits than are asked), arithmetic (one number off where the rule was
  // right), trivial, letter-case (missing under its own name), unknown; empty where the verdict says it all.
  std::string_view note{};
};

struct Grade {
  const Exercise* exercise = nullptr;
  std::string student;           // who handed it in; may be empty
  std::vector<PartGrade> parts;  // one for each of the exercise's
  Exact points = 0;
  std::string reason;                      // why the whole is invalid; empty if it is not
  std::vector<std::string> notes;          // what was ignored
  std::optional<Explanation> explanation;  // of all that is wrong, together; nothing where nothing is wrong

  double score() const;  // points / max_points
};

class Grader {
 public:
  explicit Grader(Exercise exercise);
  Grader(const Grader&) = delete;
  Grader& operator=(const Grader&) = delete;

  const Exercise& exercise() const { return exercise_; }
  Grade grade(const Checked<JsonDocument>& answers, std::string student = {}) const;
  Grade grade(const Json& answers, std::string student = {}) const;  // the answers file, a part of another document

 private:
  struct Open;
  void leave_out_strange_names();
  Grade grade(Answers&&, std::string student) const;
  void grade_sheet(const Answers&, Grade&) const;
  void look_closer(const Answers&, Grade&) const;
  void judge(const Open&, Grade&) const;
  void settle_carried(const Open&, const Replayed& meant, const Replayed* written, std::vector<char>& left,
                      Grade&) const;
  void settle_rounded(const Open&, const Replayed& meant, std::vector<char>& left, Grade&) const;
  void settle_slips(const Symptoms&, Explainer::Case&, Grade&) const;
  void settle_explained(const Symptoms&, Explainer::Case&, Grade&) const;
  void settle_arithmetic(const Symptoms&, Grade&) const;
  void settle_contradicted(const Symptoms&, const Explainer::Case&, Grade&) const;
  void settle_other_span(const Answers&, Grade&) const;
  void settle(Grade&, std::size_t part, Verdict, Exact points, std::string_view what, std::string_view note) const;
  void settle_voided(Grade&) const;
  std::string feedback(const Part&, Verdict, std::string_view what) const;

  Exercise exercise_;
  ReplayPlan plan_;
  Explainer explainer_;
  std::vector<char> right_is_trivial_;  // by part: the exercise itself leaves nothing to compute there
  bool any_voided_ = false;
  std::vector<std::unique_ptr<const Grader>> scenes_;  // of a sheet
};

}  // namespace blossom
