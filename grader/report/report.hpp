#pragma once
// Output formats of `blossom-grade`. One file per format in this folder: FORMAT.cpp defines
// `const ReportFormat& report_FORMAT()`; the table of all of them is written by the build.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "grader/grade.hpp"

namespace blossom {

// Writes one run's grades, as they come. All output is appended to `out`.
class Report {
 public:
  virtual ~Report() = default;
  virtual void add(const Grade&, std::string& out) = 0;
  virtual void finish(std::string& /*out*/) {}
};

struct ReportFormat {
  std::string_view name;
  std::string_view description;
  std::unique_ptr<Report> (*open)(const Exercise&, std::size_t submissions);
};

const std::vector<const ReportFormat*>& report_formats();

// One grade as one line of JSON, without the line's end.
void write_json(const Grade&, std::string& out);

}  // namespace blossom
