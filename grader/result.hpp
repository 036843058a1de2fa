#pragma once
// What one student has in an assignment: of each exercise the submission that counts, its grade, and what else there is
// to say (late, missing, duplicate, unreadable).
//
// As JSON (schema blossom.result/1, one line each in results.jsonl):
//   {"schema", "assignment", "student": {"id", "name"?, "section"?}, "score", "points", "max_points",
//    "exercises": [{"exercise", "points", "max_points", "state": "graded" | "missing",
//                   "source"?, "submitted"?, "days_late"?, "digest"?, "varies"?: true, "grade"?: blossom.grade/1 with
//                   "answer" (what was typed) in each part}],
//    "incidents": [{"kind", "exercise"?, "source"?, "text"}]}

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "grader/examiner.hpp"
#include "grader/student.hpp"
#include "grader/submission.hpp"

namespace blossom {

struct Incident {
  enum class Kind : std::uint8_t {
    late,
    missing,
    duplicate,   // another submission to the same exercise counts
    unreadable,  // no answers file
    misplaced,   // answers to an exercise that the assignment does not have
    foreign_id,  // the file says that it is somebody else's
    unlisted,    // from nobody on the roster
    failed,      // the grader itself failed on it
    refused,     // an entry of an archive or folder that is not read
  };
  Kind kind;
  std::string exercise;  // may be empty
  std::string source;    // likewise
  std::string text;      // a sentence
};
// The text with a full stop behind it, unless it ends in a question.
std::string as_sentence(std::string text);
// Whether it is the student's to know: who else's a file may be, and what else lay beside it, is the instructor's.
bool concerns_student(Incident::Kind);
std::string_view incident_name(Incident::Kind);  // "late", "foreign-id", ...

struct ExerciseResult {
  std::size_t item = 0;                  // of the assignment
  std::shared_ptr<const Grader> grader;  // keeps what the grade points to; null where it is missing and nothing varies
  std::shared_ptr<const JsonDocument> answers;  // what was handed in; null: nothing, or nothing that can be read
  std::optional<Grade> grade;                   // nothing: missing
  std::string source;
  std::optional<Time> submitted;
  std::string digest;   // of its bytes: the first 16 hexadecimal digits of SHA-256
  bool varies = false;  // the numbers are this student's own
  int days_late = 0;
  Exact points = 0;  // in the assignment's points, after what lateness costs
  Exact max_points = 0;
};

struct StudentResult {
  const Assignment* assignment = nullptr;
  Student student;
  std::vector<ExerciseResult> exercises;  // one for each item
  std::vector<Incident> incidents;
  Exact points = 0;
  Exact max_points = 0;

  double score() const;  // points / max_points
};

// Grades all that one student handed in. What a file says of its author is only compared with the student.
StudentResult grade_student(Examiner&, const Student&, std::vector<Submission>);

// Who the JSON is for: a student's says no more than each exercise's level of feedback allows; an instructor's says
// all, with the answers as they were typed.
enum class Audience : std::uint8_t { student, instructor };
void write_json(const StudentResult&, Audience, std::string& out);  // one line, without its end

// An ID as a file name: letters, digits, _ - and @, and points but at the start stay, other bytes become %XX.
// A long one is cut, and ends in ~ and a digest of the ID. Of a name that Windows takes for a device (con, aux.1) the
// first letter is such a byte, too.
std::string file_name_of(std::string_view id);

}  // namespace blossom
