#pragma once
// Output formats of `blossom-grade`. One file per format in this folder: FORMAT.cpp defines
// `const ReportFormat& report_FORMAT()`; the table of all of them is written by the build.

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "grader/result.hpp"

namespace blossom {

struct ReportContext {
  const Assignment* assignment = nullptr;
  std::size_t students = 0;  // how many will be added; 0: not known
  bool has_roster = false;   // whether students are more than the name of a file
};

// Writes results as they come. All output is appended to `out`. What `add` writes depends on its arguments alone, so
// that many processes may each add some; `begin` and `finish` write what stands before and after.
class Report {
 public:
  virtual ~Report() = default;
  virtual void begin(std::string& /*out*/) {}
  virtual void add(const StudentResult&, std::string& out) = 0;
  virtual void finish(std::string& /*out*/) {}
};

struct ReportFormat {
  enum class Scope : std::uint8_t {
    student,  // a document for each student
    course,   // one for all
  };
  std::string_view name;
  std::string_view description;
  std::string_view extension;  // of its files, without the point
  Scope scope;
  std::unique_ptr<Report> (*open)(const ReportContext&);
};

// In the order of their names; one by name, or nullptr.
const std::vector<const ReportFormat*>& report_formats();
const ReportFormat* find_report_format(std::string_view name);

// One grade as one line of JSON, without the line's end.
void write_json(const Grade&, std::string& out);

}  // namespace blossom
