// A gradebook to import into Canvas. The rules are those of its importer (app/models/gradebook_importer.rb of Canvas):
//
// - the header: Student, ID, SIS User ID, SIS Login ID, Section, then a column `Title (id)` for the assignment. Without
//   the assignment's own number (lms_id) Canvas looks for its title. A title with "Final Score", "Current Grade" or the
//   like in it is taken for one of Canvas's own columns and not read;
// - a row whose first cell has "Points Possible" in it gives the points, not a student; so no student's may;
// - a student is looked for by ID, then by SIS User ID, SIS Login ID, and name; who is not in the file is left as is;
// - Moodle's number of a participant would be somebody else's ID: it is left out;
// - decimals have a point, and no thousands;
// - an empty cell is no grade: it leaves who has none without one, but takes away a grade that is there. It is what
//   students who handed in nothing get, so that Canvas's own policy for missing work decides; a 0 would say that
//   somebody looked.

#include "grader/csv.hpp"
#include "grader/report/facts.hpp"

namespace blossom {
namespace {

class CanvasReport final : public Report {
 public:
  explicit CanvasReport(const ReportContext& context) : assignment_(context.assignment) {}

  void begin(std::string& out) override {
    std::string title = assignment_->title;
    if (!assignment_->lms_id.empty()) title += " (" + assignment_->lms_id + ")";
    write_csv_row({"Student", "ID", "SIS User ID", "SIS Login ID", "Section", csv_text(title)}, out);
    write_csv_row({"    Points Possible", "", "", "", "", points_text(assignment_->max_points)}, out);
  }

  void add(const StudentResult& result, std::string& out) override {
    const Student& student = result.student;
    const bool named = !student.name.empty() && student.name.find("Points Possible") == std::string::npos;
    const std::string number = student.is_participant ? std::string() : student.lms_id;
    const bool known = !number.empty() || !student.sis_id.empty() || !student.login.empty();
    bool handed_in = false;
    for (const ExerciseResult& exercise : result.exercises) handed_in = handed_in || exercise.grade.has_value();
    write_csv_row(
        {csv_text(named ? student.name : student.id), csv_text(number), csv_text(known ? student.sis_id : student.id),
         csv_text(student.login), csv_text(student.section), handed_in ? points_text(result.points) : std::string()},
        out);
  }

 private:
  const Assignment* assignment_;
};

}  // namespace

const ReportFormat& report_canvas() {
  static const ReportFormat format{
      "canvas", "a gradebook to import into Canvas (CSV)", "csv", ReportFormat::Scope::course,
      [](const ReportContext& context) -> std::unique_ptr<Report> { return std::make_unique<CanvasReport>(context); }};
  return format;
}

}  // namespace blossom
