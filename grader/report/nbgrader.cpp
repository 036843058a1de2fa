// The CSV that `nbgrader export` writes (CsvExportPlugin in nbgrader/plugins/export.py), so that scripts made for it go
// on working: one row for each student, all columns, and who handed in nothing has zeros and no timestamp. Dates are as
// nbgrader's are, UTC without an offset. Other than there, cells are quoted where they must be.

#include "grader/csv.hpp"
#include "grader/report/facts.hpp"

namespace blossom {
namespace {

// 2026-10-01 21:59:00
std::string date(const std::optional<Time>& time) {
  if (!time) return {};
  std::string text = format_time(*time);
  text[text.find('T')] = ' ';
  text.pop_back();
  return text;
}

// "Lovelace, Ada" has a first name; of other names nobody can tell which part it is.
std::pair<std::string, std::string> last_and_first(const std::string& name) {
  const std::size_t comma = name.find(',');
  if (comma == std::string::npos) return {name, {}};
  const std::size_t first = name.find_first_not_of(' ', comma + 1);
  return {name.substr(0, comma), first == std::string::npos ? std::string() : name.substr(first)};
}

class NbgraderReport final : public Report {
 public:
  void begin(std::string& out) override {
    write_csv_row({"assignment", "duedate", "timestamp", "student_id", "last_name", "first_name", "email", "raw_score",
                   "late_submission_penalty", "score", "max_score"},
                  out);
  }

  void add(const StudentResult& result, std::string& out) override {
    const ResultFacts facts = facts_of(result);
    Exact raw = 0;
    std::optional<Time> submitted;
    for (std::size_t i = 0; i < facts.exercises.size(); ++i) {
      raw += facts.exercises[i].before_late;
      submitted = std::max(submitted, result.exercises[i].submitted);
    }
    const Student& student = result.student;
    const auto [last, first] = last_and_first(student.name);
    write_csv_row(
        {csv_text(result.assignment->id), date(student.due ? student.due : result.assignment->due), date(submitted),
         csv_text(student.id), csv_text(last), csv_text(first), csv_text(student.email), points_text(raw),
         points_text(raw - result.points), points_text(result.points), points_text(result.max_points)},
        out);
  }
};

}  // namespace

const ReportFormat& report_nbgrader() {
  static const ReportFormat format{
      "nbgrader", "the table that `nbgrader export` writes (CSV)", "csv", ReportFormat::Scope::course,
      [](const ReportContext&) -> std::unique_ptr<Report> { return std::make_unique<NbgraderReport>(); }};
  return format;
}

}  // namespace blossom
