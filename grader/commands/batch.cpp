// blossom-grade batch: grades a class.

#include "grader/commands/batch_options.hpp"

namespace blossom {
namespace {

constexpr const char* manual = R"(Examples:
  blossom-grade batch exercises/demo-course/course.json exercises/demo-course/submissions \
      --roster exercises/demo-course/roster.csv --out results
      A folder of submissions: STUDENT.json, or STUDENT/anything.json.
  blossom-grade batch course.json download.zip --roster roster.csv --out results --format canvas,moodle
      An archive (zip, tar, tar.gz, ...), and gradebooks to be uploaded.
  blossom-grade batch course.json - --out results < submissions.jsonl
      A line for each submission: {"student": "s17", "submitted": "2026-10-01T12:00:00Z", "submission": {...}}

The folder of results has results.jsonl (a line for each student), incidents.csv (all that is late, missing, duplicate,
unreadable or nobody's: nothing is dropped), class.html, summary.json, students/ (what each may see), and what regrading
needs. What is in a file about its author is only compared: whose it is goes by where it was handed in.

A run that was interrupted, however, is gone on with by the same command, and ends in the same bytes.

Exit status: 0 graded, incidents or not; 1 the assignment, roster, secret, submissions or folder of results is at fault;
2 wrong usage; 3 the machine is at fault (memory, disk).)";

void set_up(CLI::App& app, int& status) {
  auto words = std::make_shared<BatchWords>();
  app.add_option("assignment", words->assignment, "an assignment (schema blossom.assignment/1), or an exercise alone")
      ->required()
      ->option_text("ASSIGNMENT");
  app.add_option("submissions", words->submissions,
                 "a folder, an archive, a file of JSON Lines; - is JSON Lines on standard input")
      ->required()
      ->option_text("SUBMISSIONS");
  add_batch_options(app, *words);
  app.footer(manual);
  app.callback([words, &status] { status = run_and_tell(words->options()) ? done_if_told() : input_at_fault; });
}

}  // namespace

const GradeCommand& command_batch() {
  static const GradeCommand command{"batch", "Grade a class", 20, set_up};
  return command;
}

}  // namespace blossom
