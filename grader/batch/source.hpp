#pragma once
// Where submissions come from: a folder, an archive (zip, tar, tar.gz, ...), or JSON Lines. They come one by one,
// always in the same order, and nothing they hold can lead outside or cost more than its limit.
//
// In a folder or archive, the first part of the path says whose it is: STUDENT.json, STUDENT/anything.json,
// STUDENT/deeper/anything.json. Names as Canvas and Moodle give them on download are known, too, by the number in them
// that the student has no hand in: 4711 of Canvas's file lovelaceada_LATE_4711_99_a.json, of Moodle's file or folder
// "Ada Lovelace_4711_assignsubmission_file_". What can be read both ways, or in two places, says nothing.
//
// What systems leave in folders by themselves (is_litter) is passed over; other hidden files are refused. Times in a
// zip archive that has them only in the old form, which knows no time zone, are read as UTC.
//
// JSON Lines, one submission a line, made by whoever runs the course, who is trusted about "student":
//   {"student": "s17", "submitted"?: time, "source"?: text, "submission": the answers file, object or string}
//   {"student": "s17", "submitted"?: time, "source"?: text, "schema": "blossom.answers/1", "exercise", "answers"}
// Of the second form the text is the line itself, with blanks where "student", "submitted" and "source" stood.

#include <filesystem>
#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"
#include "grader/student.hpp"
#include "grader/submission.hpp"

namespace blossom {

struct SourceLimits {
  std::size_t submission_bytes = 64u << 10;  // more is a problem; a line may have twice as many and 4 KiB
  std::size_t entries = 4'000'000;           // of a folder or archive
  int depth = 8;                             // of folders
  std::uint64_t total_bytes = 64ull << 30;   // of an archive, unpacked
};

struct Found {
  std::vector<StudentKey> keys;  // whose it may be, likeliest first: "s17"; none: nobody's
  Submission submission;
  bool refused = false;  // no submission: a link, a device, a name that leads outside (its problem says what)
};

class SubmissionSource {
 public:
  virtual ~SubmissionSource() = default;
  // False at the end, and when it cannot be read on: then `failure` says why.
  virtual bool next(Found&) = 0;
  const std::string& failure() const { return failure_; }
  // How much of all has been read, of 0..1; nothing where that is not known.
  virtual std::optional<double> progress() const { return std::nullopt; }
  // Why what unpacks an archive is not (wholly) closed off, as far as it has said so; empty if it is.
  const std::string& open_because() const { return open_because_; }

 protected:
  std::string failure_;
  std::string open_because_;
};

// "-" is JSON Lines on standard input; a file that ends in .jsonl is JSON Lines, too. Archives are unpacked in a
// process of their own, in the sandbox.
Checked<std::unique_ptr<SubmissionSource>> open_submissions(const std::filesystem::path&, const SourceLimits& = {});

// One line of JSON Lines. A line that is none of the above has no keys and a problem. Used by `stream`, too. The
// answers themselves are not parsed here: whoever grades them does that, and a line costs one parse, not two.
Found read_line(std::string_view line, const SourceLimits& = {});

}  // namespace blossom
