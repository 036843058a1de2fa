// Moodle's offline grading worksheet, to upload into an assignment. The rules are those of its importer (in Moodle's
// sources mod/assign/feedback/offline/importgradeslib.php and locallib.php):
//
// - columns are known by their English headings; Identifier, Grade and Last modified (grade) must be there, and
// Feedback
//   comments is read when that kind of feedback is switched on;
// - an Identifier is "Participant " and the participant's number, which is the roster's lms_id; others are skipped;
// - an empty grade leaves the grade as it is, and so does one beyond the assignment's maximum;
// - a grade that Moodle changed later than "Last modified (grade)" says is only replaced if "Allow updating records
// that
//   have been modified more recently in Moodle than in the spreadsheet" is ticked at the upload: always, for it is "-";
// - feedback comments are HTML.

#include <algorithm>

#include "grader/csv.hpp"
#include "grader/page/student_page.hpp"
#include "grader/report/facts.hpp"

namespace blossom {
namespace {

constexpr std::string_view participant = "Participant ";

std::string identifier(const Student& student) {
  if (student.lms_id.empty()) return student.id;
  const bool number = std::ranges::all_of(student.lms_id, [](char c) { return '0' <= c && c <= '9'; });
  return number ? std::string(participant) + student.lms_id : student.lms_id;
}

std::string feedback(const ExerciseFacts& exercise) {
  std::string html = "<p><strong>" + html_escape(exercise.title) +
                     "</strong>: " + points_of(exercise.points, exercise.max_points) + "</p>";
  for (const std::string& note : exercise.notes) html += "<p>" + html_escape(note) + "</p>";
  if (exercise.parts.empty()) return html;
  html += "<ul>";
  for (const PartFacts& part : exercise.parts) {
    html += "<li>" + html_escape(part.name) + ": " + std::string(part.verdict);
    if (!part.text.empty()) html += ". " + html_escape(part.text);
    html += "</li>";
  }
  return html + "</ul>";
}

class MoodleReport final : public Report {
 public:
  void begin(std::string& out) override {
    write_csv_row({"Identifier", "Full name", "Email address", "Status", "Grade", "Maximum Grade",
                   "Grade can be changed", "Last modified (submission)", "Last modified (grade)", "Feedback comments"},
                  out);
  }

  void add(const StudentResult& result, std::string& out) override {
    const ResultFacts facts = facts_of(result);
    bool handed_in = false;
    std::optional<Time> submitted;
    std::string html;
    for (std::size_t i = 0; i < facts.exercises.size(); ++i) {
      const ExerciseResult& exercise = result.exercises[i];
      handed_in = handed_in || exercise.grade.has_value();
      submitted = std::max(submitted, exercise.submitted);
      html += feedback(facts.exercises[i]);
    }
    for (const std::string& note : facts.notes) html += "<p>" + html_escape(note) + "</p>";
    const Student& student = result.student;
    write_csv_row(
        {csv_text(identifier(student)), csv_text(student.name), csv_text(student.email),
         handed_in ? "Submitted for grading" : "No submission", handed_in ? points_text(result.points) : std::string(),
         points_text(result.max_points), "Yes", submitted ? format_time(*submitted) : "-", "-", csv_text(html)},
        out);
  }
};

}  // namespace

const ReportFormat& report_moodle() {
  static const ReportFormat format{
      "moodle", "Moodle's offline grading worksheet, with feedback (CSV)", "csv", ReportFormat::Scope::course,
      [](const ReportContext&) -> std::unique_ptr<Report> { return std::make_unique<MoodleReport>(); }};
  return format;
}

}  // namespace blossom
