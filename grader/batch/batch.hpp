#pragma once
// A class: all that was handed in, graded and written to a folder.
//
//   results.jsonl         a line for each student (blossom.result/1), in the order of the class; for the instructor
//   incidents.csv         all that is late, missing, duplicate, unreadable, unlisted, failed, refused; nothing is lost
//   summary.json          counts, means, figures of the class (blossom.summary/1)
//   class.html            the class as a page for the instructor (page/class_page.hpp); its further pages in class/
//   students/ID.json      what a student may see, and ID.html; in folders of two hexadecimal digits above 5000 students
//   gradebook.FORMAT.EXT  of each format asked for whose scope is the course; FORMAT/ID.EXT of the others
//   assignment.json       the assignment with its exercises as they were graded,
//   submissions.jsonl     what was handed in, and
//   roster.csv            the class as it was: all that regrading needs
//   run.json              what all this was made of (manifest.hpp)
//   .work/                while it runs: spooled submissions and finished portions
//
// It works in three stages: submissions are spooled by student (intake.hpp), portions of the class are graded by worker
// processes (grading.hpp), and what they made is put together (collate.hpp). Each finished portion is a file that is
// renamed into place; a run that was interrupted, however, finds the portions and goes on, and the result is the same
// bytes: nothing written depends on the order or number of workers, or on the clock (`now` is an argument, and is
// remembered for going on).

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "grader/batch/work_item.hpp"
#include "grader/batch/workers.hpp"
#include "grader/report/report.hpp"
#include "grader/roster.hpp"

namespace blossom {

struct BatchOptions {
  std::filesystem::path assignment;
  std::string submissions;                      // a folder, an archive, a .jsonl file, or "-"
  std::optional<std::filesystem::path> roster;  // without it: everybody who handed in, in the order of appearance
  std::filesystem::path out;
  std::optional<std::filesystem::path> secret;
  std::vector<const ReportFormat*> formats;
  std::optional<Time> now;
  bool pages = true;             // of students
  bool student_files = true;     // JSON and pages of students
  bool keep_submissions = true;  // submissions.jsonl
  bool file_times = false;       // a file's own time is when it was handed in; otherwise only lines say when
  bool fresh = false;            // results of another run that are in `out` are removed
  std::string program;           // its version: results of another one are not gone on with
  WorkerOptions workers;
};

struct BatchProgress {
  std::string_view stage;  // "reading", "grading", "writing"
  std::uint64_t done = 0;
  std::uint64_t all = 0;  // 0: not known
  std::string_view unit;  // "submissions", "students"
};

struct BatchSummary {
  std::uint64_t submissions = 0;
  std::uint64_t students = 0;
  IncidentCounts incidents{};
  double mean_score = 0;
  std::uint64_t untimed = 0;  // submissions that nobody says the time of, where there is a date due
  bool resumed = false;       // went on with what an interrupted run left
  bool was_finished = false;  // nothing was to be done: the results are there already
  std::string open_because;   // see Workers
};

// Nothing of `out` is touched when the assignment, roster or secret is at fault, or when `out` holds something else
// than a run of the same. Throws std::system_error when the machine is at fault (disk full).
Checked<BatchSummary> run_batch(const BatchOptions&, const std::function<void(const BatchProgress&)>& progress);

}  // namespace blossom
