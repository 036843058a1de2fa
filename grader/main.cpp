// blossom-grade: grades answers files against an exercise.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>
#include <new>

#include "grader/report/report.hpp"

namespace {

using namespace blossom;

constexpr int done = 0, input_at_fault = 1, usage = 2, machine = 3;

constexpr const char* manual = R"(Examples:
  blossom-grade exercises/05-de-boor.json alice.json bob.json
      A block for each student, and a table of scores.
  blossom-grade exercises/05-de-boor.json answers/*.json --format json > grades.jsonl
      One JSON object per submission and line, in the order of the files.
  cat answers.json | blossom-grade exercises/05-de-boor.json - --format json
      One submission from standard input.

An answers file:
  {"schema": "blossom.answers/1", "exercise": "de-boor",
   "answers": {"k": 4, "alpha[1][3]": "2/5", "P[1][3]": ["-3/2", -0.1]}}

Each asked value gets a verdict: correct; carried (the right rule on the student's own earlier value); misconception (a
known wrong rule, named, with advice); slip (a sign, exchanged coordinates, transposed digits); wrong; missing; invalid.

A submission that cannot be read is graded too: score 0, every part invalid, and the reason. At most 64 KiB, 32 levels
and 4096 values are read of it.

Exit status: 0 all graded; 1 the exercise or a submission is at fault (a faulty exercise grades nothing); 2 wrong usage;
3 the machine is at fault (memory, output).)";

bool print(std::string& out) {
  const bool written = std::fwrite(out.data(), 1, out.size(), stdout) == out.size();
  out.clear();
  return written;
}

int grade_all(const std::string& exercise_file, const std::vector<std::string>& files, const ReportFormat& format) {
  auto exercise = load_exercise(exercise_file);
  if (!exercise) {
    std::fputs(to_string(exercise.diagnostics).c_str(), stderr);
    return input_at_fault;
  }
  const Grader grader(std::move(*exercise));
  const auto report = format.open(grader.exercise(), files.size());
  bool all_read = true;
  std::string out;
  for (const std::string& file : files) {
    const auto answers = JsonDocument::load(file, submission_limits);
    const Grade grade =
        grader.grade(answers, file == "-" ? std::string() : std::filesystem::path(file).stem().string());
    all_read = all_read && grade.reason.empty();
    report->add(grade, out);
    if (!print(out)) break;
  }
  report->finish(out);
  if (!print(out) || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    std::fputs("blossom-grade: the output cannot be written\n", stderr);
    return machine;
  }
  return all_read ? done : input_at_fault;
}

int run(int argc, char** argv) {
  CLI::App app("blossom-grade grades answers to an exercise on a CAGD algorithm.", "blossom-grade");
  std::string exercise;
  std::vector<std::string> answers;
  std::string format = "text";
  std::vector<std::string> formats;
  std::string formats_help = "how the grades are written";
  for (const ReportFormat* known : report_formats()) {
    formats.emplace_back(known->name);
    formats_help += "\n" + std::string(known->name) + ": " + std::string(known->description);
  }
  app.add_option("exercise", exercise, "the exercise, a JSON file (schema blossom.exercise/1)")
      ->required()
      ->option_text("EXERCISE");
  app.add_option("answers", answers, "what was handed in, JSON files (schema blossom.answers/1); - is standard input")
      ->required()
      ->option_text("ANSWERS...");
  app.add_option("-f,--format", format, formats_help)
      ->check(CLI::IsMember(formats))
      ->option_text("FORMAT (default: text)");
  app.footer(manual);
  app.failure_message([](const CLI::App*, const CLI::Error& error) {
    return "blossom-grade: " + std::string(error.what()) + "\nTry `blossom-grade --help`.\n";
  });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? done : usage;
  }
  for (const ReportFormat* known : report_formats())
    if (known->name == format) return grade_all(exercise, answers, *known);
  return usage;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    std::fputs("blossom-grade: out of memory\n", stderr);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "blossom-grade: %s\n", error.what());
  }
  return machine;
}
