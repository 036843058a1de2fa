#pragma once
// The first stage of a class: everything that was handed in is put by its student. What it leaves in the folder of
// work:
//
//   spool/             the submissions, by student (spool.hpp)
//   students           without a roster: who handed in, in the order of appearance
//   submissions.jsonl  the same submissions as one file in the order in which they came (source.hpp), to be kept
//   strays.csv         rows of incidents.csv about what is nobody's
//   read.json          how much there was; written last

#include <functional>

#include "grader/batch/batch.hpp"
#include "grader/batch/class_list.hpp"
#include "grader/batch/source.hpp"
#include "grader/batch/work_item.hpp"

namespace blossom {

struct Intake {
  std::uint64_t submissions = 0;  // all that came, refused entries apart
  std::uint64_t untimed = 0;      // those of them of which nobody says when
  IncidentCounts strays{};
  std::string digest;  // of all that came, where it was asked for
};

struct IntakeOptions {
  bool keep = true;   // submissions.jsonl is written
  bool times = true;  // what the source says of when something was handed in is believed
  bool digest = false;
};

// The class list is complete afterwards. Diagnostics when the source cannot be read on.
Checked<Intake> take_in(SubmissionSource&, ClassList&, const std::filesystem::path& work, const IntakeOptions&,
                        const std::function<void(const BatchProgress&)>&);
// The same digest, of another source, which is read to its end. Diagnostics as above.
Checked<std::string> digest_of(SubmissionSource&);
// Nothing if it was not finished.
std::optional<Intake> taken_in(const std::filesystem::path& work);

}  // namespace blossom
