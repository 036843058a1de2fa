// JUnit XML, which continuous integration shows: a suite for each student and exercise, a test case for each part, and
// a failure for each part that is neither correct nor carried. Elements and attributes are those of the schema that
// Jenkins and pytest test against (junit-10.xsd of the Jenkins xUnit plugin): of a suite its name, tests, failures and
// errors, of a test case its name. Of the characters that XML 1.0 forbids (section 2.2), control characters are written
// as \xNN and noncharacters as U+FFFD.

#include <algorithm>

#include "grader/page/student_page.hpp"
#include "grader/report/facts.hpp"

namespace blossom {
namespace {

std::string xml(std::string_view text) {
  std::string allowed = printable(text);
  for (const std::string_view forbidden : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})  // U+FFFE, U+FFFF
    for (std::size_t at = 0; (at = allowed.find(forbidden, at)) != std::string::npos;)
      allowed.replace(at, forbidden.size(), "\xEF\xBF\xBD");
  return html_escape(allowed);
}

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + xml(value) + "\"";
}

class JunitReport final : public Report {
 public:
  void begin(std::string& out) override {
    out += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"blossom-grade\">\n";
  }

  void add(const StudentResult& result, std::string& out) override {
    const ResultFacts facts = facts_of(result);
    const std::string student = result.student.id.empty() ? "standard input" : result.student.id;
    for (const ExerciseFacts& exercise : facts.exercises) add_suite(student, exercise, facts.notes, out);
  }

  void finish(std::string& out) override { out += "</testsuites>\n"; }

 private:
  static void add_case(std::string_view student, std::string_view exercise, std::string_view name, bool passed,
                       const std::string& type, const std::string& message, std::string& out) {
    out += "    <testcase" + attribute("classname", std::string(student) + "." + std::string(exercise)) +
           attribute("name", name);
    out += passed ? "/>\n" : "><failure" + attribute("type", type) + attribute("message", message) + "/></testcase>\n";
  }

  static void add_suite(const std::string& student, const ExerciseFacts& exercise, const std::vector<std::string>& more,
                        std::string& out) {
    const bool whole = exercise.parts.empty();  // one case for the whole exercise, where parts are not shown
    const bool full = exercise.before_late == exercise.max_points;
    const auto failed = whole ? static_cast<std::ptrdiff_t>(!full)
                              : std::ranges::count_if(exercise.parts, [](const PartFacts& p) { return !p.passed; });
    out += "  <testsuite" + attribute("name", student + " " + std::string(exercise.id)) +
           attribute("tests", std::to_string(whole ? 1 : exercise.parts.size())) +
           attribute("failures", std::to_string(failed)) + attribute("errors", "0") + ">\n";
    if (whole)
      add_case(student, exercise.id, exercise.title, full, exercise.grade == nullptr ? "missing" : "points",
               points_of(exercise.before_late, exercise.max_points), out);
    for (const PartFacts& part : exercise.parts)
      add_case(student, exercise.id, part.name, part.passed, std::string(part.verdict),
               part.text.empty() ? std::string(part.verdict) : part.text, out);
    std::string text = points_of(exercise.points, exercise.max_points) + ".\n";
    for (const auto* notes : {&exercise.notes, &more})
      for (const std::string& note : *notes) text += xml(note) + "\n";
    out += "    <system-out>" + text + "</system-out>\n  </testsuite>\n";
  }
};

}  // namespace

const ReportFormat& report_junit() {
  static const ReportFormat format{
      "junit", "JUnit XML: a test case for each part", "xml", ReportFormat::Scope::course,
      [](const ReportContext&) -> std::unique_ptr<Report> { return std::make_unique<JunitReport>(); }};
  return format;
}

}  // namespace blossom
