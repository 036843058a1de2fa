#pragma once
// Predicting: before a step is shown the student says what it will make. Questions are the asked values of an exercise,
// or those a lesson (or its algorithm) asks; answers are texts as typed, a place that was clicked, or a picked span or
// line; marking is the grader's, at once or at the end; undo and "show me" are helps that are counted.

#include <memory>

#include "grader/grade.hpp"
#include "lesson/document.hpp"
#include "scene/source.hpp"

namespace blossom {

struct AskedValue {
  ValueId value = absent;  // of the trace
  std::string name;        // "P[1][4]"
  std::uint32_t step = 0;  // which makes it
  std::size_t part = 0;    // of the exercise
  ValueKind kind = ValueKind::scalar;
  std::size_t size = 1;  // how many numbers are typed; 0: any number of them
  Form form = Form::affine;
};

struct Attempt {
  std::vector<std::string> numbers;  // as typed; of a list: its elements
  bool shown = false;                // by "show me": earns nothing
  std::optional<PartGrade> mark;     // when it was marked
};

// What the student is asked for a step besides its value, for practice: not part of the answers file.
struct LineGuess {
  int picked = 0;
  int right = 0;
};

class Prediction {
 public:
  // `grader` is the exercise's own, or for a lesson one that practice_exercise() made.
  Prediction(std::shared_ptr<const Grader> grader, Marking marking, const TraceGraph&);

  // After the run was recorded anew: the same questions in the new trace. False: one of them is no longer there.
  bool rebind(const TraceGraph&);
  // Takes over what was answered and counted by one whose exercise asks the same.
  void carry_over(const Prediction&);

  const Exercise& exercise() const { return grader_->exercise(); }
  Marking marking() const { return marking_; }
  const std::vector<AskedValue>& questions() const { return questions_; }  // by step
  const std::optional<Attempt>& attempt(std::size_t question) const { return attempts_[question]; }
  // The first question that is not answered; nothing when all are.
  std::optional<std::size_t> open() const;
  std::size_t answered() const;  // how many, shown ones among them
  // Whether going to this step would show the answer to an open question; of those marked at the end, to any.
  bool veiled(std::uint32_t step) const;

  // Answers are taken as typed: "2/5", "-0.4"; what has not the question's shape is refused with the reason, and
  // nothing changes. An answer replaces an earlier one of the same question that is not marked yet; both count in
  // the history. A marked one stands, for the mark may have told what is right: undo takes it back, counted.
  std::optional<std::string> answer(std::size_t question, std::vector<std::string> numbers);
  // The right value as the answer; counted, and worth nothing, nor is what is answered there afterwards.
  void show_me(std::size_t question);
  void guess_line(std::size_t question, int picked, int right);
  const std::optional<LineGuess>& line_guess(std::size_t question) const { return line_guesses_[question]; }

  // Takes back the last answer (or line, or "show me"; that it was shown stays counted), and puts it back.
  bool undo();
  bool redo();
  bool can_undo() const { return at_ > 0; }
  bool can_redo() const { return at_ < moves_.size(); }
  std::size_t undo_question() const { return moves_[at_ - 1].question; }  // if there is something to undo
  std::string undo_what() const;                                          // "the answer to P[1][2]"
  int undos() const { return undos_; }
  int shown() const { return shown_; }

  // What one is told now: at once each answer's mark; at the end all of them when the last is given (or `finish` was
  // called), as far as the exercise's feedback allows. An answer that was shown has no mark.
  void finish();
  bool finished() const;
  std::optional<PartGrade> mark(std::size_t question) const;
  std::optional<Grade> grade() const;  // when finished and the feedback allows it

  // The file to hand in: {"schema": "blossom.answers/1", "exercise": id, "answers": {...}}, answered values only, shown
  // ones left out. blossom-grade accepts it.
  std::string answers_file() const;

 private:
  struct Move {
    std::size_t question = 0;
    std::optional<Attempt> before, after;
    std::optional<LineGuess> line_before, line_after;
  };
  void make(Move);
  void mark_all();
  Grade grade_now() const;
  // The answers file; where `instead` is a question, with this text as its answer.
  std::string answers_text(std::optional<std::size_t> instead, const std::string& text) const;

  std::shared_ptr<const Grader> grader_;
  Marking marking_;
  std::vector<AskedValue> questions_;
  std::vector<std::optional<Attempt>> attempts_;
  std::vector<std::optional<LineGuess>> line_guesses_;
  std::vector<char> was_shown_;  // by question: also when it was taken back
  std::vector<Move> moves_;
  std::size_t at_ = 0;  // moves_[0, at_) are done
  int undos_ = 0, shown_ = 0;
  bool finished_ = false;
  Grade grade_;  // of the answers as they are
};

// In words: "What is P[1][2]? It is the point 2 of level 1."; "P[1][2] = (0, 16)"; why it is that, with the formula, or
// nothing where there is none that is short.
std::string asked_words(const AskedValue&, const StepSource&);
std::string answer_words(const AskedValue&, const std::vector<std::string>& numbers);
std::string reason_words(const AskedValue&, const StepSource&);
// "0, 1/2 1" or "(0, 1/2, 1)": its numbers.
std::vector<std::string> split_numbers(const std::string& text);

// The numbers of a clicked place, rounded as finely as one pixel, `unit` in the world, can mean. Empty where a click is
// no answer: numbers, lists, homogeneous coordinates.
std::vector<std::string> prefilled(const AskedValue&, const glm::dvec3& clicked, double unit);

// How far from the right place a click may be, in the world: 2 % of the picture's size.
double click_tolerance(const Inputs<Exact>&);

// An exercise about a run that comes from no exercise file: the values that `asks` selects (by default what the
// algorithm's exercises usually ask, at most 40), with a tolerance of 2 % of the picture's size, so that a click
// counts; of other numbers 0.01. Of `asks` what selects nothing is left out; nothing at all is a diagnostic.
Checked<std::shared_ptr<const Grader>> practice_exercise(const Algorithm&, const Inputs<Exact>&,
                                                         const std::vector<std::string>& asks, const std::string& id,
                                                         const std::string& title);

}  // namespace blossom
