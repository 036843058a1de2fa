// What an Autolab autograder prints (docs/lab.md, "Writing Autograders", and AssessmentAutogradeCore#parseAutoresult in
// its sources): text for the student, and as the last line the autoresult
//   {"scores":{"de-boor":8,...},"scoreboard":[8,...]}
// The problems of the Autolab assessment must be named as the exercises' ids are. The scoreboard has the total first,
// then each exercise.
//
// Autolab puts quotation marks around every `word:` of that line before it parses it, also inside strings. So there are
// no strings in it but keys, which are followed by their own quotation mark.

#include "grader/report/facts.hpp"

namespace blossom {

const ReportFormat& report_text();

namespace {

class AutolabReport final : public Report {
 public:
  explicit AutolabReport(ReportContext context) : context_(context) { context_.students = 1; }

  void add(const StudentResult& result, std::string& out) override {
    report_text().open(context_)->add(result, out);
    const ResultFacts facts = facts_of(result);
    out += '{';
    append_json_key("scores", out);
    out += '{';
    for (const ExerciseFacts& exercise : facts.exercises) {
      append_json_key(exercise.id, out);
      out += points_text(exercise.points);
    }
    out += '}';
    append_json_key("scoreboard", out);
    out += '[' + points_text(result.points);
    for (const ExerciseFacts& exercise : facts.exercises) out += ',' + points_text(exercise.points);
    out += "]}\n";
  }

 private:
  ReportContext context_;
};

}  // namespace

const ReportFormat& report_autolab() {
  static const ReportFormat format{
      "autolab", "what an Autolab autograder prints: text, then a line of scores, of one student", "txt",
      ReportFormat::Scope::student,
      [](const ReportContext& context) -> std::unique_ptr<Report> { return std::make_unique<AutolabReport>(context); }};
  return format;
}

}  // namespace blossom
