// Gradescope's results.json, as its autograder documentation has it ("Autograder Specifications", chapters "Output
// format", "Controlling test case visibility" and "Output string formatting", in gradescope/autograder_samples).
//
// The top-level score is what counts: it overrides the sum of the tests, which know nothing of lateness. A test's
// status is "passed" or "failed"; all texts are of the format "text", so nothing that a student typed is taken for
// markup. There is no execution_time, so that the same submission always gives the same bytes. What the grader prints
// is for instructors only.

#include "grader/report/facts.hpp"

namespace blossom {
namespace {

void add_member(std::string_view key, std::string_view text, std::string& out) {
  append_json_key(key, out);
  append_json_text(text, out);
}

void add_points(std::string_view key, const Exact& points, std::string& out) {
  append_json_key(key, out);
  out += points_text(points);
}

class GradescopeReport final : public Report {
 public:
  void add(const StudentResult& result, std::string& out) override {
    const ResultFacts facts = facts_of(result);
    out += '{';
    add_points("score", result.points, out);
    add_member("output", output(result, facts), out);
    add_member("output_format", "text", out);
    add_member("test_output_format", "text", out);
    add_member("test_name_format", "text", out);
    add_member("visibility", "visible", out);
    add_member("stdout_visibility", "hidden", out);
    append_json_key("tests", out);
    out += '[';
    for (std::size_t i = 0; i < facts.exercises.size(); ++i) add_tests(facts, i, out);
    out += "]}\n";
  }

 private:
  static std::string output(const StudentResult& result, const ResultFacts& facts) {
    std::string text = points_of(result.points, result.max_points) + ".";
    for (const std::string& note : facts.all_notes()) text += "\n" + note;
    return text;
  }

  static void open_test(const std::string& name, const std::string& number, std::string& out) {
    if (out.back() != '[') out += ',';
    out += '{';
    add_member("name", name, out);
    add_member("number", number, out);
  }

  // A test for each part, or for the exercise as a whole where parts are not shown.
  static void add_tests(const ResultFacts& facts, std::size_t index, std::string& out) {
    const ExerciseFacts& exercise = facts.exercises[index];
    const std::string number = std::to_string(index + 1);
    if (exercise.parts.empty()) {
      open_test(printable(exercise.title), number, out);
      add_points("score", exercise.before_late, out);
      add_points("max_score", exercise.max_points, out);
      add_member("visibility", "visible", out);
      out += '}';
      return;
    }
    for (std::size_t i = 0; i < exercise.parts.size(); ++i) {
      const PartFacts& part = exercise.parts[i];
      const std::string name(part.name);
      open_test(facts.exercises.size() > 1 ? printable(exercise.title) + ": " + name : name,
                number + "." + std::to_string(i + 1), out);
      add_points("score", part.points, out);
      add_points("max_score", part.max_points, out);
      add_member("status", part.passed ? "passed" : "failed", out);
      add_member("output", std::string(part.verdict) + (part.text.empty() ? "" : ": " + part.text), out);
      add_member("visibility", "visible", out);
      out += '}';
    }
  }
};

}  // namespace

const ReportFormat& report_gradescope() {
  static const ReportFormat format{
      "gradescope", "Gradescope's results.json, of one student", "json", ReportFormat::Scope::student,
      [](const ReportContext&) -> std::unique_ptr<Report> { return std::make_unique<GradescopeReport>(); }};
  return format;
}

}  // namespace blossom
