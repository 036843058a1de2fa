#pragma once
// The third stage of a class: what the portions hold is put together, in the order of the class, into the files of the
// folder of results.

#include <functional>

#include "grader/batch/grading.hpp"
#include "grader/batch/intake.hpp"

namespace blossom {

struct Collation {
  const BatchOptions* options = nullptr;
  const Assignment* assignment = nullptr;
  ReportContext context;
  Time now{};
  Intake intake;
  std::uint64_t students = 0;
};

// Everything but run.json; the counts are complete afterwards.
BatchSummary collate(const Collation&, const std::filesystem::path& work,
                     const std::function<void(const BatchProgress&)>&);

// From summary.json of results that are finished.
std::optional<BatchSummary> read_summary(const std::filesystem::path& out);

// The assignment with its exercises in it, as a file.
std::string write_assignment(const Assignment&, const JsonDocument& file);

}  // namespace blossom
