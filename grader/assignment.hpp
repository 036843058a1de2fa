#pragma once
// An assignment: exercises with points, a date, and what students get to see when.
//
//   {"schema": "blossom.assignment/1", "id", "title",
//    "exercises": [{"file": "../exercises/22-de-boor.json", "points": 10}, ...],   points: else the exercise's own
//                  or {"exercise": the exercise itself, "points"?}; a lesson likewise
//    "due"?: time, "late"?: {"grace_minutes"?: n, "per_day"?: share, "at_most_days"?: n},
//    "attempts"?: "last" | "best" | "first",
//    "feedback"?: level, "full_feedback_from"?: time, "lms_id"?: "12345", "source"?, "$schema"?}
//
// exercises/assignment.schema.json describes every key. Files are looked for beside the assignment; ".." is allowed in
// them, for whoever writes the assignment is trusted.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "grader/exercise.hpp"
#include "grader/time.hpp"

namespace blossom {

// Which of several submissions counts: the last or first handed in (of the same second: by source), or the best.
enum class Attempts : std::uint8_t { last, best, first };

struct LatePolicy {
  int grace_minutes = 0;
  Exact per_day = 0;                // the share of the points lost for each day begun
  std::optional<int> at_most_days;  // later than that earns nothing

  // What is left of the points of a submission that came so long after the date: a share of 1. Days begun, too.
  int days_late(Time due, Time submitted) const;
  Exact share(int days_late) const;
};

struct Assignment {
  struct Item {
    JsonDocument document;  // of the exercise, as read; variants are made from it
    Exercise exercise;      // with its own (model) numbers
    Exact points = 0;       // in this assignment; the exercise's own points are scaled to it
  };
  std::string id;
  std::string title;
  std::string lms_id;  // of the assignment, for gradebooks: Canvas's `Title (id)`
  std::vector<Item> items;
  std::optional<Time> due;
  std::chrono::minutes offset{0};  // of the clocks that students are told times by: as the file writes "due"
  LatePolicy late;
  Attempts attempts = Attempts::last;
  std::optional<Feedback> feedback;        // instead of the exercises' own
  std::optional<Time> full_feedback_from;  // from then on everybody sees everything
  Exact max_points = 0;

  std::optional<std::size_t> item(std::string_view exercise_id) const;
  // The level of an exercise at a time.
  Feedback feedback_at(std::size_t item, Time now) const;
};

// An assignment, or an exercise alone: an assignment of that one with its own points. A lesson stands for its
// checkpoints (lesson_grader.hpp), said in a language. Every mistake at once, those of its exercises among them.
Checked<Assignment> read_assignment(const JsonDocument&, std::string_view language = {});
Checked<Assignment> load_assignment(const std::filesystem::path&, std::string_view language = {});

// What to say of an ID that names none of its exercises: those there are, or the one that was probably meant.
std::string no_exercise_of(const Assignment&, std::string_view id);

}  // namespace blossom
