// blossom-grade regrade: grades a class again and says what has changed.

#include "grader/batch/regrade.hpp"
#include "grader/batch/output.hpp"
#include "grader/commands/batch_options.hpp"

namespace blossom {
namespace {

constexpr std::uint64_t most_told = 50;  // students; all are in changes.csv

constexpr const char* manual = R"(Examples:
  blossom-grade regrade results course.json --out results-2
      After an exercise has changed: what was handed in, and the roster, are taken from the old folder of results.
  blossom-grade regrade results course.json submissions --roster roster.csv --out results-2
      The same with what is there now.

Prints who has changed, from what to what, and why: a tolerance, the points of a part, a part voided, another right value,
another date, another submission. results-2/changes.csv has all of it.

Exit status: 0 graded, changes or not; 1 an input is at fault; 2 wrong usage; 3 the machine is at fault (memory, disk).)";

void tell(const Change& change) {
  const std::string was = change.was.empty() ? "nothing" : change.was,
                    now = change.now.empty() ? "nothing" : change.now;
  if (change.exercise.empty() && was == now)
    std::printf("%s: %s as before", printable(change.student).c_str(), now.c_str());
  else if (change.exercise.empty())
    std::printf("%s: %s -> %s", printable(change.student).c_str(), was.c_str(), now.c_str());
  else
    std::printf("  %s%s%s: %s -> %s", change.exercise.c_str(), change.part.empty() ? "" : " ", change.part.c_str(),
                was.c_str(), now.c_str());
  std::printf(change.why.empty() ? "\n" : " (%s)\n", change.why.c_str());
}

int regrade(const std::string& old_results, BatchWords words) {
  namespace fs = std::filesystem;
  const fs::path old_folder(old_results);
  std::error_code error;
  if (words.submissions.empty()) {
    words.submissions = (old_folder / "submissions.jsonl").string();
    if (words.roster.empty() && fs::exists(old_folder / "roster.csv", error))
      words.roster = (old_folder / "roster.csv").string();
  }
  if (fs::equivalent(old_folder, words.out, error)) {
    std::fputs("blossom-grade: the old results and the new ones must be in different folders\n", stderr);
    return wrong_usage;
  }
  const BatchOptions options = words.options();
  if (const auto other = other_secret(old_folder, options); !other.empty()) {
    std::fputs(to_string(other).c_str(), stderr);
    return input_at_fault;
  }
  if (!run_and_tell(options)) return input_at_fault;

  std::puts("\nWhat has changed:");
  const fs::path unfinished = options.out / "changes.csv.unfinished";
  OutputFile file(unfinished);
  file.write(change_header());
  std::uint64_t told = 0;
  std::string row;
  const auto changes = find_changes(old_folder, options.out, [&](const Change& change) {
    row.clear();
    write_change(change, row);
    file.write(row);
    if (change.exercise.empty()) ++told;
    if (told <= most_told) tell(change);
  });
  file.close();
  if (!changes) {
    fs::remove(unfinished);
    std::fputs(to_string(changes.diagnostics).c_str(), stderr);
    return input_at_fault;
  }
  move_file(unfinished, options.out / "changes.csv");
  if (told > most_told) std::printf("... and %s more\n", counted(told - most_told, "student", "students").c_str());
  std::printf("%s of %llu: %llu with more points, %llu with fewer",
              counted(changes->better + changes->worse + changes->otherwise, "student", "students").c_str(),
              static_cast<unsigned long long>(changes->students), static_cast<unsigned long long>(changes->better),
              static_cast<unsigned long long>(changes->worse));
  if (changes->otherwise > 0)
    std::printf(", %llu with as many as before, for other values", static_cast<unsigned long long>(changes->otherwise));
  if (changes->come + changes->gone > 0)
    std::printf("; %llu are new, %llu gone", static_cast<unsigned long long>(changes->come),
                static_cast<unsigned long long>(changes->gone));
  std::printf("; mean score %.1f %% -> %.1f %%\n", 100 * changes->mean_was, 100 * changes->mean_now);
  std::printf("  %s/changes.csv: all changes\n", printable(options.out.string()).c_str());
  return done_if_told();
}

void set_up(CLI::App& app, int& status) {
  auto words = std::make_shared<BatchWords>();
  auto old_results = std::make_shared<std::string>();
  app.add_option("old", *old_results, "the folder of results of the first time")->required()->option_text("OLD");
  app.add_option("assignment", words->assignment, "the assignment as it is now")->required()->option_text("ASSIGNMENT");
  app.add_option("submissions", words->submissions, "what was handed in; if it is left out, what OLD has kept of it")
      ->option_text("[SUBMISSIONS]");
  add_batch_options(app, *words);
  app.footer(manual);
  app.callback([words, old_results, &status] { status = regrade(*old_results, *words); });
}

}  // namespace

const GradeCommand& command_regrade() {
  static const GradeCommand command{"regrade", "Grade a class again and say what has changed", 30, set_up};
  return command;
}

}  // namespace blossom
