#pragma once
// What may be said of a result to whom it is about. The level of feedback decides it here, once for all formats: at
// `none` there are no parts, at `verdict` parts have no text, so no format can show what it is not given.

#include <string>
#include <string_view>
#include <vector>

#include "grader/report/report.hpp"

namespace blossom {

struct PartFacts {
  std::string_view name;
  std::string_view verdict;
  bool passed = false;   // correct or carried, or it counts for nobody
  Exact points = 0;      // in the assignment's points, before lateness
  Exact max_points = 0;  // likewise
  std::string text;      // what is said of it, on one line; of what is correct nothing
  std::string typed;     // what was typed for it, on one line; of what is correct nothing
};

struct ExerciseFacts {
  std::string_view id;
  std::string_view title;
  const Grade* grade = nullptr;    // nothing where nothing was handed in
  std::vector<PartFacts> parts;    // none where the level of feedback is `none` or nothing could be read
  Exact points = 0;                // that count
  Exact max_points = 0;            // in the assignment
  Exact before_late = 0;           // points without what lateness costs
  std::vector<std::string> notes;  // sentences on the exercise as a whole, each on one line: why it cannot be read, ...
};

struct ResultFacts {
  std::vector<ExerciseFacts> exercises;
  std::vector<std::string> notes;  // on no exercise in particular
  bool readable = false;           // whether anything that was handed in could be read

  // All notes, those on an exercise with its title where there are several.
  std::vector<std::string> all_notes() const;
};

ResultFacts facts_of(const StudentResult&);

// "2.5", at most four digits behind the point: as JSON and every spreadsheet read it.
std::string points_text(const Exact&);
// "2.5 of 4 points"
std::string points_of(const Exact& points, const Exact& max_points);

// Appends a quoted text. What a terminal would obey is escaped, too, not only what JSON wants to be.
void append_json_text(std::string_view, std::string& out);
// Appends `,"key":`, without the comma behind an opening brace.
void append_json_key(std::string_view key, std::string& out);

}  // namespace blossom
