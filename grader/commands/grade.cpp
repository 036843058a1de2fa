// blossom-grade grade: grades answers files, each as a student's, or all as one student's.

#include <cstdio>
#include <filesystem>
#include <functional>
#include <stdexcept>
#include <utility>

#include "base/json.hpp"
#include "base/text_file.hpp"
#include "grader/batch/bytes.hpp"
#include "grader/batch/stream.hpp"
#include "grader/batch/workers.hpp"
#include "grader/command.hpp"
#include "grader/handed_in.hpp"
#include "grader/report/report.hpp"
#include "grader/variant.hpp"

namespace blossom {
namespace {

constexpr const char* manual = R"(Examples:
  blossom-grade exercises/22-de-boor.json alice.json bob.json
      A block for each student, and a table of scores.
  blossom-grade exercises/22-de-boor.json answers/*.json --format json > grades.jsonl
      One JSON object per submission and line, in the order of the files.
  cat answers.json | blossom-grade exercises/22-de-boor.json - --format json
      One submission from standard input.
  blossom-grade homework.json handed-in/s17 --student s17 --secret-file course.secret --format html --out s17.html
      All that one student handed in, from a folder; the numbers may be the student's own.
  blossom-grade homework.json submission --metadata submission_metadata.json --format gradescope --out results.json
      The same as Gradescope's autograder has it: the student, the time and the date due are in the metadata.
  blossom-grade lessons/11-de-casteljau.json alice.json
      The checkpoints of a lesson. Its id is the "exercise" of the answers, and what is answered stands under the ids
      of the checkpoints: {"first-point": ["1/2", 1], "which-line": 4, "in-order": "cab", "why": "b"}

An answers file:
  {"schema": "blossom.answers/1", "exercise": "de-boor",
   "answers": {"k": 4, "alpha[1][3]": "2/5", "P[1][3]": ["-3/2", -0.1]}}

Each asked value gets a verdict: correct; carried (the right rule on the student's own earlier value); misconception (a
known wrong rule, named, with advice); slip (a sign, exchanged coordinates, transposed digits); wrong; missing; invalid.

Without --student and --metadata every file is a student of that name; of an assignment with several exercises it is
graded against the one that it names. For a whole class see `blossom-grade batch`.

A submission that cannot be read is graded too: score 0, every part invalid, and the reason. At most 64 KiB, 32 levels
and 4096 values are read of it.

Exit status: 0 all graded; 1 the exercise or a submission is at fault (a faulty exercise grades nothing); 2 wrong usage;
3 the machine is at fault (memory, output).)";

struct Given {
  std::string exercise;
  std::vector<std::string> answers;
  std::string format = "text";
  std::string out;
  std::string student;
  std::string submitted;
  std::string secret_file;
  std::string now;
  std::string metadata;
  std::string language;
};

int complain(const Diagnostics& diagnostics) {
  std::fputs(to_string(diagnostics).c_str(), stderr);
  return input_at_fault;
}

// Where the report goes: standard output as it comes, or a file that is there only when it is whole.
class Output {
 public:
  explicit Output(const std::string& path) : path_(path) {}

  std::string text;

  bool pass_on() {
    if (!path_.empty()) return true;
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    text.clear();
    return written;
  }
  int close() {
    if (!path_.empty()) {
      const auto written = write_file(path_, text);
      if (written) return done;
      std::fputs(to_string(written.diagnostics).c_str(), stderr);
      return machine_at_fault;
    }
    if (pass_on() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return done;
    std::fputs("blossom-grade: the output cannot be written\n", stderr);
    return machine_at_fault;
  }

 private:
  std::string path_;
};

bool is_readable(const StudentResult& result) {
  for (const ExerciseResult& exercise : result.exercises)
    if (exercise.grade && !exercise.grade->reason.empty()) return false;
  for (const Incident& incident : result.incidents)
    if (incident.kind == Incident::Kind::unreadable || incident.kind == Incident::Kind::misplaced ||
        incident.kind == Incident::Kind::failed)
      return false;
  return true;
}

Time read_now(const std::string& text) {
  if (const auto time = parse_time(text)) return *time;
  return std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
}

// The exercise that a file is for: the only one, or the one that it names.
std::optional<std::size_t> item_of(const Assignment& assignment, const Checked<JsonDocument>& answers) {
  if (assignment.items.size() == 1) return 0;
  const Json* id = answers ? answers->root().find("exercise") : nullptr;
  return id != nullptr && id->kind == Json::Kind::string ? assignment.item(id->text) : std::nullopt;
}

// A file as it was read, against that exercise alone, whose numbers are the same for everybody.
StudentResult grade_file(Examiner& examiner, const std::string& file, Checked<std::string> text) {
  const Assignment& assignment = examiner.assignment();
  StudentResult result;
  result.assignment = &assignment;
  if (file != "-") result.student.id = std::filesystem::path(file).stem().string();
  auto answers = text ? JsonDocument::parse(file_title(file), std::move(*text), submission_limits)
                      : Checked<JsonDocument>(std::move(text.diagnostics));
  const auto item = item_of(assignment, answers);
  if (!item) {
    const Json* id = answers ? answers->root().find("exercise") : nullptr;
    result.incidents.push_back({Incident::Kind::misplaced,
                                {},
                                {},
                                id != nullptr && id->kind == Json::Kind::string
                                    ? no_exercise_of(assignment, id->text)
                                    : "it names no exercise of this assignment"});
    return result;
  }
  ExerciseResult& only = result.exercises.emplace_back();
  only.item = *item;
  only.grader = *examiner.grader(*item, result.student.id);
  only.grade = only.grader->grade(answers, result.student.id);
  if (answers) only.answers = std::make_shared<const JsonDocument>(std::move(*answers));
  only.max_points = assignment.items[*item].points;
  only.points = only.grade->points / only.grader->exercise().max_points * only.max_points;
  result.points = only.points;
  result.max_points = only.max_points;
  return result;
}

// A process in the sandbox, which turns what was read into a piece of the report. One only, for a report may gather
// something of every piece.
class Closed {
 public:
  // Of a file or student: its piece of the report, and whether it could be read.
  using Piece = std::function<bool(std::string_view item, std::string& piece)>;

  Closed(Examiner& examiner, const Piece& piece)
      : workers_([piece](std::string_view item, std::string& answer) { answer += piece(item, answer) ? 'y' : 'n'; },
                 prepared(examiner)) {
    if (!workers_.open_because().empty())
      std::fprintf(stderr, "blossom-grade: the grader is not wholly closed off: %s\n",
                   printable(workers_.open_because()).c_str());
  }

  // The names are those of the items, in order. Throws std::runtime_error where an item ends the process: what it had
  // gathered is lost with it.
  void run(const std::vector<std::string>& names, const Workers::Next& next,
           const std::function<void(std::string_view piece, bool readable)>& take) {
    std::size_t at = 0;
    workers_.run(next, [&](std::string_view, std::string_view answer, const Lost* lost) {
      const std::size_t item = at++;
      if (lost != nullptr) throw std::runtime_error((item < names.size() ? names[item] + ": " : "") + lost->text);
      take(answer.substr(0, answer.size() - 1), answer.back() == 'y');
    });
  }

 private:
  static WorkerOptions prepared(Examiner& examiner) {
    prepare_for_workers(examiner);
    WorkerOptions options;
    options.processes = 1;
    return options;
  }

  Workers workers_;
};

// An item is the number of a file and what it holds; the last one is empty and asks for the report's end.
int grade_files(Examiner& examiner, const Given& given, const ReportFormat& format) {
  const auto report = format.open({&examiner.assignment(), given.answers.size(), false});
  Output out(given.out);
  report->begin(out.text);
  Closed closed(examiner, [&](std::string_view item, std::string& piece) {
    if (item.empty()) {
      report->finish(piece);
      return true;
    }
    ByteReader in(item);
    const std::string& file = given.answers[in.number<std::uint64_t>()];
    const bool has_text = in.number<char>() != 0;
    std::string text(in.text());
    const StudentResult result =
        grade_file(examiner, file,
                   has_text ? Checked<std::string>(std::move(text)) : Diagnostics{{file_title(file), 0, 0, "", text}});
    report->add(result, piece);
    return is_readable(result);
  });
  bool all_read = true, listened_to = true;
  std::size_t next = 0;
  const auto read = [&](std::string& item) {
    item.clear();
    if (next > given.answers.size() || !listened_to) return false;
    if (next < given.answers.size()) {
      const auto text = read_text(given.answers[next], submission_limits.bytes);
      ByteWriter writer(item);
      writer.number(static_cast<std::uint64_t>(next));
      writer.number(static_cast<char>(text ? 1 : 0));
      writer.text(text ? *text : text.diagnostics.front().message);
    }
    ++next;
    return true;
  };
  closed.run(given.answers, read, [&](std::string_view piece, bool readable) {
    all_read = all_read && readable;
    out.text += piece;
    listened_to = listened_to && out.pass_on();
  });
  const int status = out.close();
  return status != done ? status : all_read ? done : input_at_fault;
}

int grade_one_student(Examiner& examiner, const Given& given, const ReportFormat& format,
                      const SubmissionMetadata& who) {
  HandedIn handed_in = read_handed_in(given.answers);
  for (Submission& submission : handed_in.submissions) submission.submitted = who.submitted;
  Closed closed(examiner, [&](std::string_view, std::string& piece) {
    StudentResult result = grade_student(examiner, who.student, handed_in.submissions);
    result.incidents.insert(result.incidents.end(), handed_in.refused.begin(), handed_in.refused.end());
    const auto report = format.open({&examiner.assignment(), 1, true});
    report->begin(piece);
    report->add(result, piece);
    report->finish(piece);
    return is_readable(result);
  });
  Output out(given.out);
  bool all_read = true, asked = false;
  closed.run(
      {who.student.id}, [&](std::string&) { return !std::exchange(asked, true); },
      [&](std::string_view piece, bool readable) {
        out.text = piece;
        all_read = readable;
      });
  const int status = out.close();
  return status != done ? status : all_read ? done : input_at_fault;
}

[[noreturn]] void ask_for_student(const std::string& why) {
  throw CLI::ValidationError(why +
                             "; say whose answers they are with --student ID or --metadata, or grade a class "
                             "with `blossom-grade batch`");
}

void refuse_folders(const std::vector<std::string>& paths) {
  std::error_code ignored;
  for (const std::string& path : paths)
    if (path != "-" && std::filesystem::is_directory(path, ignored))
      ask_for_student(printable(path) + " is a folder, which is graded as one student's");
}

void refuse_variants(const Examiner& examiner) {
  for (std::size_t i = 0; i < examiner.assignment().items.size(); ++i)
    if (examiner.varies(i))
      ask_for_student(examiner.assignment().items[i].exercise.id + " has numbers of each student's own");
}

int grade_all(const Given& given) {
  const ReportFormat& format = *find_report_format(given.format);
  const bool one_student = !given.student.empty() || !given.metadata.empty();
  if (!one_student && !given.submitted.empty()) throw CLI::ValidationError("--submitted needs --student or --metadata");
  if (!one_student && given.answers.size() > 1 && format.scope == ReportFormat::Scope::student)
    throw CLI::ValidationError("--format " + given.format +
                               " is for one student; give one file, or say whose they are with --student");
  if (!one_student) refuse_folders(given.answers);
  auto assignment = load_assignment(given.exercise, given.language);
  if (!assignment) return complain(assignment.diagnostics);
  std::string secret;
  if (!given.secret_file.empty()) {
    auto read = load_secret(given.secret_file);
    if (!read) return complain(read.diagnostics);
    secret = std::move(*read);
  }
  SubmissionMetadata who;
  if (!given.metadata.empty()) {
    const auto document = JsonDocument::load(given.metadata);
    if (!document) return complain(document.diagnostics);
    auto read = read_submission_metadata(*document);
    if (!read) return complain(read.diagnostics);
    who = std::move(*read);
  }
  if (!given.student.empty()) who.student.id = given.student;
  if (!given.submitted.empty()) who.submitted = parse_time(given.submitted);
  const bool has_secret = !secret.empty();
  Examiner examiner(std::move(*assignment), std::move(secret), read_now(given.now));
  if (!one_student) refuse_variants(examiner);
  for (std::size_t i = 0; i < examiner.assignment().items.size(); ++i)
    if (!has_secret && examiner.varies(i)) return complain(examiner.grader(i, "nobody").diagnostics);
  return one_student ? grade_one_student(examiner, given, format, who) : grade_files(examiner, given, format);
}

void set_up(CLI::App& app, int& status) {
  auto given = std::make_shared<Given>();
  std::vector<std::string> formats;
  std::string formats_help = "how the grades are written";
  for (const ReportFormat* known : report_formats()) {
    formats.emplace_back(known->name);
    formats_help += "\n" + std::string(known->name) + ": " + std::string(known->description);
  }
  app.add_option("exercise", given->exercise,
                 "the exercise, an assignment of several, or a lesson with checkpoints (JSON, schema "
                 "blossom.exercise/1, blossom.assignment/1 or blossom.lesson/1)")
      ->required()
      ->option_text("EXERCISE");
  app.add_option("answers", given->answers,
                 "what was handed in, JSON files (schema blossom.answers/1); - is standard input; of one student a "
                 "folder, too")
      ->required()
      ->option_text("ANSWERS...");
  app.add_option("-f,--format", given->format, formats_help)
      ->check(is_one_of(formats))
      ->option_text("FORMAT (default: text)");
  app.add_option("-o,--out", given->out, "the file to write, instead of standard output")->option_text("FILE");
  app.add_option("--student", given->student, "all answers are this student's")->option_text("ID");
  app.add_option("--submitted", given->submitted, "when they were handed in: 2026-10-01T23:59:00+02:00")
      ->check(is_time)
      ->option_text("TIME");
  app.add_option("--metadata", given->metadata,
                 "Gradescope's submission_metadata.json: all answers are that student's, handed in at that time")
      ->option_text("FILE");
  app.add_option("--language", given->language, "of a lesson in several languages: which one, such as de")
      ->option_text("LANGUAGE");
  app.add_option("--secret-file", given->secret_file, "the course's secret, which variants are drawn with")
      ->option_text("FILE");
  app.add_option("--now", given->now, "the time that decides which level of feedback is given, instead of the clock's")
      ->check(is_time)
      ->option_text("TIME");
  app.footer(manual);
  app.callback([given, &status] { status = grade_all(*given); });
}

}  // namespace

const GradeCommand& command_grade() {
  static const GradeCommand command{"grade", "Grade answers files against an exercise", 10, set_up};
  return command;
}

}  // namespace blossom
