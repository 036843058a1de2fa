#pragma once
// What grading the same class again has changed: who, from what to what, and why. Made from two folders of results
// (batch.hpp), line by line.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "base/diagnostics.hpp"
#include "grader/batch/batch.hpp"

namespace blossom {

struct Change {
  std::string student;
  std::string exercise;  // empty: the student as a whole
  std::string part;      // empty: the exercise as a whole
  std::string was, now;  // "wrong, 0 of 1"; as a whole "71.5 of 100"; empty: nothing
  std::string why;       // for a part or an exercise
};

struct Changes {
  std::uint64_t students = 0;  // of the new results
  std::uint64_t better = 0, worse = 0;
  std::uint64_t otherwise = 0;  // the same points, other verdicts
  std::uint64_t come = 0, gone = 0;
  double mean_was = 0, mean_now = 0;
};

// Each change is told in the order of the new results, the student's own first; those who are gone last. Differences of
// the exercises that matter are found by comparing the assignments that both folders keep.
Checked<Changes> find_changes(const std::filesystem::path& old_results, const std::filesystem::path& new_results,
                              const std::function<void(const Change&)>& each);

// Where students have numbers of their own, those of the old results must be those of the new ones: why they are not,
// as far as both can be read.
Diagnostics other_secret(const std::filesystem::path& old_results, const BatchOptions& wanted);

// Changes as rows of a file, which is written to be changes.csv.
std::string change_header();
void write_change(const Change&, std::string& out);

}  // namespace blossom
