#pragma once
// What the subcommands that grade a class have in common: their options, their progress, and what they say at the end.

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "grader/batch/batch.hpp"
#include "grader/command.hpp"

namespace blossom {

// The options as they are typed.
struct BatchWords {
  std::string assignment, submissions, roster, out, secret_file, now;
  std::vector<std::string> formats;
  unsigned jobs = 0;
  bool no_pages = false, class_only = false, no_copy = false, file_times = false, fresh = false, no_sandbox = false;

  BatchOptions options() const {
    BatchOptions options;
    options.assignment = assignment;
    options.submissions = submissions;
    if (!roster.empty()) options.roster = roster;
    options.out = out;
    if (!secret_file.empty()) options.secret = secret_file;
    for (const std::string& format : formats) options.formats.push_back(find_report_format(format));
    if (!now.empty()) options.now = parse_time(now);
    options.pages = !no_pages && !class_only;
    options.student_files = !class_only;
    options.keep_submissions = !no_copy;
    options.file_times = file_times;
    options.fresh = fresh;
    options.program = BLOSSOM_VERSION;
    options.workers.processes = jobs;
    options.workers.sandboxed = !no_sandbox;
    return options;
  }
};

inline void add_batch_options(CLI::App& app, BatchWords& words) {
  std::vector<std::string> formats;
  std::string help = "gradebooks to be written beside the results; several with commas";
  for (const ReportFormat* known : report_formats()) {
    formats.emplace_back(known->name);
    help += "\n" + std::string(known->name) + ": " + std::string(known->description);
  }
  app.add_option("-r,--roster", words.roster, "the class, a CSV file with a header row")->option_text("FILE");
  app.add_option("-o,--out", words.out, "the folder of results")
      ->required()
      ->check([](const std::string& text) { return text.empty() ? "must have a name" : std::string(); })
      ->option_text("DIR");
  app.add_option("-f,--format", words.formats, help)
      ->delimiter(',')
      ->check(is_one_of(formats))
      ->option_text("FORMAT,...");
  app.add_option("--secret-file", words.secret_file, "the course's secret, which variants are drawn with")
      ->option_text("FILE");
  app.add_option("--now", words.now, "the time that decides what students may see yet, such as 2026-10-01T12:00:00Z")
      ->check(is_time)
      ->option_text("TIME (default: the clock's)");
  app.add_option("-j,--jobs", words.jobs, "worker processes")
      ->check(CLI::Range(1u, 1024u))
      ->option_text("N (default: one for each core)");
  app.add_flag("--no-pages", words.no_pages, "students get no pages, only their results as JSON");
  app.add_flag("--class-only", words.class_only, "nothing is written for each student");
  app.add_flag("--no-copy", words.no_copy, "submissions.jsonl, what was handed in, is not kept for regrading");
  app.add_flag("--file-times", words.file_times,
               "a file's own time is when it was handed in; otherwise files of folders and archives have none");
  app.add_flag("--fresh", words.fresh, "results of another run in DIR are removed first");
  app.add_flag("--no-sandbox", words.no_sandbox, "workers are not closed off; for debugging the grader");
}

// On a terminal, and only when it takes longer than a second.
class ProgressLine {
 public:
  void operator()(const BatchProgress& progress) {
    if (!terminal_) return;
    const auto now = std::chrono::steady_clock::now();
    if (now < next_) return;
    next_ = now + std::chrono::milliseconds(200);
    shown_ = true;
    std::fprintf(stderr, "\r\033[K%.*s: %llu", static_cast<int>(progress.stage.size()), progress.stage.data(),
                 static_cast<unsigned long long>(progress.done));
    if (progress.all > 0)
      std::fprintf(stderr, " of %llu", static_cast<unsigned long long>(std::max(progress.all, progress.done)));
    std::fprintf(stderr, " %.*s", static_cast<int>(progress.unit.size()), progress.unit.data());
    std::fflush(stderr);
  }
  void clear() const {
    if (shown_) std::fputs("\r\033[K", stderr);
  }

 private:
  bool terminal_ = ::isatty(STDERR_FILENO) == 1;
  bool shown_ = false;
  std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + std::chrono::seconds(1);
};

inline std::string counted(std::uint64_t n, std::string_view one, std::string_view many) {
  return std::to_string(n) + " " + std::string(n == 1 ? one : many);
}

// What does not stop a run, but is seldom meant.
inline void warn(const BatchOptions& options, const BatchSummary& summary) {
  const auto say = [](const std::string& text) { std::fprintf(stderr, "blossom-grade: %s\n", text.c_str()); };
  const std::string submissions = options.submissions == "-" ? "standard input" : printable(options.submissions);
  const std::uint64_t unlisted = summary.incidents[static_cast<std::size_t>(Incident::Kind::unlisted)];
  if (summary.submissions == 0) say("there is no submission in " + submissions);
  if (options.roster && 2 * unlisted > summary.submissions)
    say(std::to_string(unlisted) + " of " + counted(summary.submissions, "submission", "submissions") +
        " are of nobody on the roster: is " + submissions + " all of this class, and " +
        printable(options.roster->string()) + " its roster? incidents.csv says by what name each was looked for");
  if (summary.untimed > 0)
    say("nobody says when " + counted(summary.untimed, "submission was", "submissions were") +
        " handed in, and none of those counts as late; --file-times takes the files' own times, and JSON Lines have " +
        "\"submitted\"");
}

// Runs it and says how it went.
inline Checked<BatchSummary> run_and_tell(const BatchOptions& options) {
  ProgressLine line;
  auto summary = run_batch(options, [&](const BatchProgress& progress) { line(progress); });
  line.clear();
  if (!summary) {
    std::fputs(to_string(summary.diagnostics).c_str(), stderr);
    return summary;
  }
  const std::string out = printable(options.out.string());
  if (summary->was_finished) std::printf("Nothing was to be done: %s has these results already.\n", out.c_str());
  if (summary->resumed) std::printf("Went on with what an interrupted run had left in %s.\n", out.c_str());
  if (!summary->open_because.empty())
    std::fprintf(stderr, "blossom-grade: the workers are not wholly closed off: %s\n",
                 printable(summary->open_because).c_str());
  std::printf("%s, %s, mean score %.1f %%\n", counted(summary->students, "student", "students").c_str(),
              counted(summary->submissions, "submission", "submissions").c_str(), 100 * summary->mean_score);
  warn(options, *summary);
  std::uint64_t all = 0;
  std::string kinds;
  for (std::size_t i = 0; i < incident_kinds; ++i) {
    all += summary->incidents[i];
    if (summary->incidents[i] > 0)
      kinds += (kinds.empty() ? "" : ", ") + std::to_string(summary->incidents[i]) + " " +
               std::string(incident_name(static_cast<Incident::Kind>(i)));
  }
  std::printf("%s\n\nTo look at:\n",
              kinds.empty() ? "nothing late, missing, unreadable or out of order" : kinds.c_str());
  std::printf("  %s/class.html: the class\n", out.c_str());
  if (all > 0) std::printf("  %s/incidents.csv: what is late, missing, unreadable or out of order\n", out.c_str());
  for (const ReportFormat* format : options.formats) {
    const std::string name(format->name), extension(format->extension);
    const bool of_student = format->scope == ReportFormat::Scope::student;
    const std::string file = of_student ? name + "/ID." + extension : "gradebook." + name + "." + extension;
    std::printf("  %s/%s: %.*s\n", out.c_str(), file.c_str(), static_cast<int>(format->description.size()),
                format->description.data());
  }
  if (options.student_files) std::printf("  %s/students/: what each student may see\n", out.c_str());
  return summary;
}

// The status at the end: what was said must have been written, too.
inline int done_if_told() {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return done;
  std::fputs("blossom-grade: the output cannot be written\n", stderr);
  return machine_at_fault;
}

}  // namespace blossom
