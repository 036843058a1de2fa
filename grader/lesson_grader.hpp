#pragma once
// The checkpoints of a lesson, graded. Together they are a sheet: an exercise of which each part is a checkpoint and
// stands under its id, so that whatever grades, collects and reports exercises does so with lessons:
//
//   {"schema": "blossom.answers/1", "exercise": id of the lesson, "answers": {"first-point": ["1/2", 1], "next": "b"}}
//
// A predicted value and a span are graded as an exercise asks for them (all of a scene together: what is wrong is
// carried on, misconceptions and slips are named); a line, an order and a choice are compared with the right one:
//
//   line     4                    the number of a line of the pseudo-code, from 1
//   order    "cab", ["c", "a", "b"]     the letters of the items as they are shown, in the right order
//   choice   "b"                  a letter

#include <string>
#include <string_view>
#include <vector>

#include "grader/grade.hpp"
#include "lesson/lesson.hpp"

namespace blossom {

// What a part of a sheet is about. `value` of such a part is absent.
struct Question {
  Checkpoint::Kind kind = Checkpoint::Kind::choice;
  std::size_t scene = 0;  // of the lesson
  std::size_t part = 0;   // of a value: the part of that scene's exercise
  std::string ask;        // filled in; prose.hpp reads it
  std::vector<std::string>
      options;            // likewise: choices, or items as they are shown; of a line the pseudo-code, as it is
  std::string right;      // of a line, an order, a choice: see right_letters
  std::size_t count = 0;  // how many letters there are, or lines
  std::vector<std::string> feedback;  // to each choice, plain text
  std::string praise, blame;          // "right" and "wrong" of the checkpoint, filled in, plain text
  bool is_value() const { return kind == Checkpoint::Kind::predict || kind == Checkpoint::Kind::span; }
};

// What an answer that is no value counts as.
struct LetterMark {
  Verdict verdict = Verdict::invalid;  // correct, wrong or invalid
  std::size_t choice = 0;              // which one was taken, of a choice or a line
  std::string problem;                 // why it is invalid: "must be one letter from a to c, not ..."
};
LetterMark mark_letters(const Question&, const Json& answer);

// The sheet of a lesson, with its texts in a language: for read_sheet one that the lesson is in; make_sheet takes its
// own where it lacks one. Every mistake of the lesson at once; a lesson without checkpoints is one.
Checked<Exercise> read_sheet(const JsonDocument& lesson, std::string_view language = {});
Checked<Exercise> make_sheet(const Lesson&, std::string_view language = {});

// One checkpoint alone, at once.
struct CheckpointMark {
  Verdict verdict = Verdict::invalid;
  Exact points = 0;
  std::string words;  // what the lesson says to this answer, filled in: prose.hpp reads it; may be empty
  std::string note;   // what the grader says of it, one line of plain text; empty of what is right
  std::string right;  // the right answer, as a sentence's end: "P[1][0] = (1/2, 1)", "b", "c, a, b", "line 4"
};
// In a run of the scene that may have other inputs than the lesson's; `step` is where the checkpoint stands in it.
CheckpointMark mark_checkpoint(const Run<Exact>&, std::uint32_t step, const Checkpoint&, const Json& answer,
                               std::string_view language = {});
// In the lesson's own. Precondition: the checkpoint is one of the scene's.
CheckpointMark mark_checkpoint(const Lesson&, std::size_t scene, const Checkpoint&, const Json& answer,
                               std::string_view language = {});

}  // namespace blossom
