#include "grader/batch/batch.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <random>

#include "classes.hpp"
#include "grader/batch/collate.hpp"
#include "grader/batch/folder_lock.hpp"
#include "grader/batch/grading.hpp"
#include "grader/batch/kept.hpp"
#include "grader/batch/newcomers.hpp"

using namespace blossom;

namespace {

std::size_t count_lines(const std::string& text) { return static_cast<std::size_t>(std::ranges::count(text, '\n')); }

std::uint64_t of(const BatchSummary& summary, Incident::Kind kind) {
  return summary.incidents[static_cast<std::size_t>(kind)];
}

}  // namespace

TEST_CASE("a class is graded into a folder: results in order, incidents, what each student sees") {
  const Scratch scratch;
  scratch.write("course.json", small_course());
  const auto lines = line_of_class("s2", small_answers("a", right_value)) +
                     line_of_class("s1", small_answers("a", right_value)) +
                     line_of_class("s1", small_answers("b", right_value)) + line_of_class("s2", "nonsense") +
                     line_of_class("=cmd()", small_answers("b", "[7, 7]"));
  auto options = class_options(scratch, scratch.write("class.jsonl", lines), "out");
  options.formats = {find_report_format("canvas"), find_report_format("gradescope")};
  const auto summary = grade_class(options);
  CHECK(summary.students == 3);
  CHECK(summary.submissions == 5);
  CHECK(summary.mean_score == Approx((0.4 + 1 + 0) / 3));
  CHECK(of(summary, Incident::Kind::missing) == 2);
  CHECK(of(summary, Incident::Kind::unreadable) == 1);
  CHECK(!summary.resumed);

  const auto files = files_of(options.out);
  const auto& results = files.at("results.jsonl");
  CHECK(count_lines(results) == 3);
  CHECK(results.find("\"s2\"") < results.find("\"s1\""));  // in the order of appearance
  CHECK(count_lines(files.at("incidents.csv")) == 4);
  CHECK(files.at("incidents.csv").find("\n'=cmd(),missing,a,") != std::string::npos);
  for (const auto* name :
       {"students/s1.json", "students/s1.html", "students/%3Dcmd%28%29.json", "class.html", "summary.json",
        "assignment.json", "submissions.jsonl", "gradebook.canvas.csv", "gradescope/s1.json"}) {
    INFO(name);
    CHECK(files.contains(name));
  }
  CHECK(!std::filesystem::exists(options.out / ".work"));
}

TEST_CASE("with a roster all of it are there, in its order, and who is not on it is told, not graded") {
  const Scratch scratch;
  scratch.write("course.json", small_course());
  auto options = class_options(scratch,
                               scratch.write("class.jsonl", line_of_class("ada", small_answers("a", right_value)) +
                                                                line_of_class("mallory", "{}") + "no line\n"),
                               "out");
  options.roster = scratch.write("roster.csv", "id,login,name\ns9,grace,Grace\ns1,ada,Ada\n");
  const auto summary = grade_class(options);
  CHECK(summary.students == 2);
  CHECK(summary.submissions == 3);
  CHECK(of(summary, Incident::Kind::unlisted) == 2);
  CHECK(of(summary, Incident::Kind::missing) == 3);
  const auto files = files_of(options.out);
  const auto& results = files.at("results.jsonl");
  CHECK(results.find("\"s9\"") < results.find("\"s1\""));
  const auto& incidents = files.at("incidents.csv");
  CHECK(incidents.find("mallory,unlisted,,,") != std::string::npos);
  CHECK(incidents.find("does not say whose it is") != std::string::npos);
  CHECK(!files.contains("students/mallory.json"));
  CHECK(files.at("roster.csv") == read_file(*options.roster));
}

TEST_CASE("the same class makes the same bytes on 1, 2 and 3 workers") {
  const Scratch scratch;
  scratch.write("course.json", small_course());
  auto options = class_options(scratch, scratch.write("class.jsonl", class_lines(300)), "one");
  options.formats = {find_report_format("canvas"), find_report_format("junit")};
  grade_class(options);
  const auto one = files_of(options.out);
  CHECK(count_lines(one.at("results.jsonl")) == 300);
  for (const unsigned jobs : {2u, 3u}) {
    options.out = scratch / std::to_string(jobs);
    options.workers.processes = jobs;
    options.workers.frame_items = 7;
    grade_class(options);
    check_same(one, files_of(options.out));
  }
}

TEST_CASE("a folder, an archive, lines, and what was kept of them make the same bytes") {
  const Scratch scratch;
  scratch.write("course.json", small_course());
  std::filesystem::create_directories(scratch / "class/s1");
  std::filesystem::create_directories(scratch / "class/s2");
  const std::pair<std::string, std::string> handed[] = {{"s1/a.json", small_answers("a", right_value)},
                                                        {"s1/b.json", small_answers("b", "[7, 7]")},
                                                        {"s2/a.json", "\xff\xfe broken"},
                                                        {"s2/b.json", small_answers("b", right_value)},
                                                        {"s3.json", "{\"x\": \"\\u00e9\\n\"}"}};
  for (const auto& [name, text] : handed) scratch.write("class/" + name, text);
  const auto grade = [&](const std::string& submissions, const std::string& out) {
    auto options = class_options(scratch, submissions, out);
    grade_class(options);
    return files_of(options.out);
  };
  const auto from_folder = grade(scratch / "class", "from-folder");
  CHECK(count_lines(from_folder.at("results.jsonl")) == 3);
  const std::string tar =
      "tar --sort=name -cf " + (scratch / "class.tar") + " -C " + (scratch / "class") + " s1 s2 s3.json";
  REQUIRE(std::system(tar.c_str()) == 0);
  check_same(from_folder, grade(scratch / "class.tar", "from-archive"));
  check_same(from_folder, grade(scratch / "from-folder/submissions.jsonl", "from-kept"));

  std::filesystem::remove(scratch / "class/s2/a.json");  // lines are UTF-8
  const auto readable = grade(scratch / "class", "readable");
  std::string lines;
  for (const auto& [name, text] : handed)
    if (name != "s2/a.json") lines += line_of_class(name.substr(0, 2), text, ", \"source\": " + json_quote(name));
  check_same(readable, grade(scratch.write("class.jsonl", lines), "from-lines"));
}

TEST_CASE("a file's own time is believed only where somebody asks for it") {
  const Scratch scratch;
  scratch.write("course.json", small_course(R"(, "due": "2020-01-01T00:00:00Z")"));
  std::filesystem::create_directories(scratch / "class");
  scratch.write("class/s1.json", small_answers("a", right_value));
  auto options = class_options(scratch, scratch / "class", "out");
  CHECK(of(grade_class(options), Incident::Kind::late) == 0);
  options.file_times = true;
  options.out = scratch / "times";
  CHECK(of(grade_class(options), Incident::Kind::late) == 1);
}

TEST_CASE("a run of something else in the folder is refused, a finished one of the same is left alone") {
  const Scratch scratch;
  scratch.write("course.json", small_course());
  auto options = class_options(scratch, scratch.write("class.jsonl", class_lines(5)), "out");
  grade_class(options);
  const auto before = files_of(options.out);
  const auto again = grade_class(options);
  CHECK(again.was_finished);
  CHECK(again.students == 5);
  CHECK(again.mean_score > 0);

  const auto check_refused = [&](const std::string& reason, const BatchOptions& other) {
    CHECK(refusal(other).find(reason) != std::string::npos);
    check_same(before, files_of(options.out));
  };
  scratch.write("class.jsonl", class_lines(6));
  check_refused("the submissions have changed", options);
  scratch.write("course.json", small_course(R"(, "feedback": "none")"));
  check_refused("the assignment or one of its exercises has changed", options);
  auto other = options;
  other.roster = scratch.write("roster.csv", "id\ns1\n");
  options.fresh = other.fresh = true;
  other.roster = scratch.write("roster.csv", "name\nAda\n");
  check_refused("roster.csv", other);  // at fault: nothing is touched, not even to begin anew
  other.roster = scratch.write("roster.csv", "id\ns1\n");
  CHECK(grade_class(other).students == 1);
  CHECK(!files_of(other.out).contains("students/s2.json"));

  std::filesystem::create_directories(scratch / "mine");
  scratch.write("mine/thesis.tex", "x");
  options.out = scratch / "mine";
  CHECK(refusal(options).find("is no folder of results") != std::string::npos);
  CHECK(read_file(scratch / "mine/thesis.tex") == "x");
}

TEST_CASE("a run that stops anywhere is gone on with, and ends in the same bytes") {
  const Scratch scratch;
  scratch.write("course.json", small_course());
  auto options = class_options(scratch, scratch.write("class.jsonl", class_lines(600)), "whole");
  options.formats = {find_report_format("canvas")};
  options.pages = false;
  std::uint64_t steps = 0;
  REQUIRE(run_batch(options, [&](const BatchProgress&) { ++steps; }));
  const auto whole = files_of(options.out);
  std::mt19937 random(17);
  INFO("seed 17");
  struct Stop {};
  std::size_t resumed = 0;
  for (int round = 0; round < 4; ++round) {
    options.out = scratch / ("stopped-" + std::to_string(round));
    bool finished = false;
    for (int attempt = 0; !finished && attempt < 100; ++attempt) {
      std::uint64_t left = std::uniform_int_distribution<std::uint64_t>(1, steps)(random);
      try {
        const auto summary = run_batch(options, [&](const BatchProgress&) {
          if (--left == 0) throw Stop();
        });
        REQUIRE(summary);
        resumed += summary->resumed ? 1 : 0;
        finished = true;
      } catch (const Stop&) {
      }
    }
    REQUIRE(finished);
    check_same(whole, files_of(options.out));
  }
  CHECK(resumed > 0);
}

TEST_CASE("a portion that is torn is graded again, a spool that is torn is told") {
  const Scratch scratch;
  scratch.write("course.json", small_course());
  auto options = class_options(scratch, scratch.write("class.jsonl", class_lines(600)), "whole");
  options.pages = false;
  grade_class(options);
  const auto whole = files_of(options.out);
  struct Stop {};
  const auto stop_after = [&](const std::string& out, std::uint64_t graded) {
    options.out = scratch / out;
    CHECK_THROWS_AS(run_batch(options,
                              [&](const BatchProgress& progress) {
                                if (progress.stage == "grading" && progress.done == graded) throw Stop();
                              }),
                    Stop);
  };
  stop_after("torn", 590);
  const auto portion = portion_file(options.out / ".work", 1);
  REQUIRE(std::filesystem::exists(portion));
  std::filesystem::resize_file(portion, std::filesystem::file_size(portion) - 1);
  CHECK(grade_class(options).resumed);
  check_same(whole, files_of(options.out));

  stop_after("spool", 10);
  std::filesystem::resize_file(options.out / ".work/spool/000.part", 1000);
  CHECK(refusal(options).find("000.part") != std::string::npos);
  options.fresh = true;
  grade_class(options);
  check_same(whole, files_of(options.out));
}

TEST_CASE("two runs do not work in one folder at the same time") {
  const Scratch scratch;
  scratch.write("course.json", small_course());
  auto options = class_options(scratch, scratch.write("class.jsonl", class_lines(300)), "out");
  std::string said;
  bool asked = false;
  REQUIRE(run_batch(options, [&](const BatchProgress&) {
    if (std::exchange(asked, true)) return;
    // Locks are a process's: another one asks.
    const std::string file = scratch / "said";
    const pid_t child = fork();
    if (child == 0) {
      const auto other = run_batch(options, [](const BatchProgress&) {});
      std::ofstream(file) << to_string(other.diagnostics);
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    said = read_file(file);
  }));
  CHECK(said.find("another run is at work") != std::string::npos);
}

TEST_CASE("the lock of a folder is one process's, though its file comes and goes") {
  const Scratch scratch;
  const std::filesystem::path out = scratch / "out", work = out / ".work";
  // Whoever has the file open when it is removed must not take the lock of a file that is none any more.
  for (int round = 0; round < 50; ++round) {
    const FolderLock lock(out, work);
    REQUIRE(lock.held());
    lock.clear_work();
    CHECK(std::filesystem::exists(work / "lock"));
  }
  CHECK(!std::filesystem::exists(out));

  std::vector<pid_t> children;
  for (int child = 0; child < 4; ++child) {
    children.push_back(fork());
    if (children.back() != 0) continue;
    for (int round = 0; round < 300; ++round) {
      const FolderLock lock(out, work);
      if (!lock.held()) continue;
      // Only one at a time can make this file.
      const int mark = open((work / "mark").c_str(), O_CREAT | O_EXCL | O_WRONLY, 0600);
      if (mark < 0) _exit(1);
      close(mark);
      lock.clear_work();
    }
    _exit(0);
  }
  for (const pid_t child : children) {
    int status = 0;
    waitpid(child, &status, 0);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
  }
}

TEST_CASE("no input lies in the folder of results, which is not among the submissions either") {
  const Scratch scratch;
  scratch.write("course.json", small_course());
  std::filesystem::create_directories(scratch / "class");
  scratch.write("class/s1.json", small_answers("a", right_value));
  auto options = class_options(scratch, scratch / "class", "out");
  grade_class(options);
  options.fresh = true;
  auto other = options;
  other.roster = scratch.write("out/roster.csv", "id\ns1\n");
  CHECK(refusal(other).find("holds the roster") != std::string::npos);
  CHECK(read_file(*other.roster) == "id\ns1\n");
  std::filesystem::create_symlink(scratch / "out/roster.csv", scratch / "link.csv");
  other.roster = scratch / "link.csv";
  CHECK(refusal(other).find("holds the roster") != std::string::npos);
  other = options;
  other.submissions = scratch / "out/submissions.jsonl";
  CHECK(refusal(other).find("holds the submissions") != std::string::npos);
  other = options;
  other.out = scratch / "class/results";
  CHECK(refusal(other).find("is inside the submissions") != std::string::npos);
  CHECK(!std::filesystem::exists(other.out));
  other.out.clear();
  CHECK(refusal(other).find("has no name") != std::string::npos);
}

TEST_CASE(
    "what is no archive is found out before anything is removed, and a removal that is interrupted is gone on with") {
  const Scratch scratch;
  scratch.write("course.json", small_course());
  auto options = class_options(scratch, scratch.write("class.jsonl", class_lines(5)), "out");
  grade_class(options);
  const auto before = files_of(options.out);
  auto damaged = options;
  damaged.submissions = scratch.write("class.zip", "no archive");
  damaged.fresh = true;
  refusal(damaged);
  check_same(before, files_of(options.out));
  damaged.out = scratch / "new";
  refusal(damaged);
  CHECK(!std::filesystem::exists(damaged.out));

  // As it is left when it is killed while old results are removed.
  std::string manifest = read_file(options.out / "run.json");
  manifest.replace(manifest.find("finished"), 8, "running");
  scratch.write("out/run.json", manifest);
  std::filesystem::remove(options.out / "results.jsonl");
  grade_class(options);
  check_same(before, files_of(options.out));
}

TEST_CASE("an assignment with a date due tells how many submissions have no time") {
  const Scratch scratch;
  const auto options = class_options(
      scratch,
      scratch.write("class.jsonl", line_of_class("s1", "{}") + line_of_class("s2", "{}") +
                                       line_of_class("s3", "{}", R"(, "submitted": "2026-10-02T00:00:00Z")")),
      "out");
  scratch.write("course.json", small_course());
  CHECK(grade_class(options).untimed == 0);
  auto due = options;
  due.out = scratch / "due";
  scratch.write("course.json", small_course(R"(, "due": "2026-10-01T00:00:00Z")"));
  CHECK(grade_class(due).untimed == 2);
}

TEST_CASE("one student's flood does not drown the others, and is told") {
  const Scratch scratch;
  scratch.write("course.json", small_course());
  std::string lines = line_of_class("calm", small_answers("a", right_value));
  for (int i = 0; i < 1200; ++i) lines += line_of_class("flood", small_answers("a", "[1, 1]"));
  const auto options = class_options(scratch, scratch.write("class.jsonl", lines), "out");
  const auto summary = grade_class(options);
  CHECK(summary.submissions == 1201);
  CHECK(of(summary, Incident::Kind::duplicate) == 999);
  CHECK(of(summary, Incident::Kind::refused) == 1);
  CHECK(read_file(options.out / "incidents.csv").find("200 more submissions of this student were not read") !=
        std::string::npos);
}

namespace {

// Workers whose grader dies of some texts, as one with a mistake in it would.
struct Harmful {
  explicit Harmful(const Scratch& scratch, const std::string& lines)
      : options(class_options(scratch, scratch.write("class.jsonl", lines), "out")), work(options.out / ".work") {
    scratch.write("course.json", small_course());
    std::filesystem::create_directories(work);
    ClassList list(Newcomers::begin(work / "students"));
    auto source = open_submissions(options.submissions);
    REQUIRE(source);
    REQUIRE(take_in(**source, list, work, {}, [](const BatchProgress&) {}));
    auto assignment = load_assignment(options.assignment);
    REQUIRE(assignment);
    Examiner examiner(std::move(*assignment), "", *options.now);
    const ReportContext context{&examiner.assignment(), static_cast<std::size_t>(list.size()), false};
    Desk desk(examiner, {{}, context, true, true});
    Workers workers(
        [&](std::string_view item, std::string& answer) {
          const std::string all(item);
          if (all.find("deadly") != std::string::npos) std::raise(SIGKILL);
          if (all.find("half") != std::string::npos && all.find("other") != std::string::npos) std::raise(SIGKILL);
          desk.work(item, answer);
        },
        options.workers);
    const auto spool = SpoolReader::open(work / "spool");
    REQUIRE(spool);
    Grading grading(options, list, *spool, work);
    REQUIRE(grading.run(workers, [](const BatchProgress&) {}));
    content = read_portion(portion_file(work, 0));
  }
  BatchOptions options;
  std::filesystem::path work;
  PortionContent content;
};

}  // namespace

TEST_CASE("a submission that kills the grader is lost alone, and reported") {
  const Scratch scratch;
  const Harmful harmful(scratch, line_of_class("s1", small_answers("a", right_value)) +
                                     line_of_class("s2", small_answers("a", right_value)) +
                                     line_of_class("s2", "deadly", R"(, "source": "bad.json")") +
                                     line_of_class("s2", small_answers("b", right_value)) +
                                     line_of_class("s3", "deadly") +
                                     line_of_class("s4", small_answers("b", right_value)));
  const auto& content = harmful.content;
  CHECK(content.students == 4);
  CHECK(content.counts[static_cast<std::size_t>(Incident::Kind::failed)] == 2);
  CHECK(content.incidents.find("s2,failed,,bad.json,") != std::string::npos);
  CHECK(content.incidents.find("SIGKILL") != std::string::npos);
  CHECK(content.score == Approx(0.4 + 1 + 0 + 0.6));
  CHECK(count_lines(content.results) == 4);
}

TEST_CASE("submissions that kill the grader only together are lost together") {
  const Scratch scratch;
  const Harmful harmful(scratch, line_of_class("s1", "half") + line_of_class("s1", "the other") +
                                     line_of_class("s2", small_answers("b", right_value)));
  CHECK(harmful.content.counts[static_cast<std::size_t>(Incident::Kind::failed)] == 2);
  CHECK(harmful.content.score == Approx(0.6));
}

TEST_CASE("newcomers have the numbers of their first appearance, and keep them") {
  const Scratch scratch;
  const std::filesystem::path file = scratch / "students";
  std::mt19937 random(5);
  INFO("seed 5");
  std::vector<std::string> order;
  std::map<std::string, std::uint64_t> known;
  {
    auto newcomers = Newcomers::begin(file);
    for (int i = 0; i < 40'000; ++i) {
      const std::string id(std::to_string(random() % 15'000));
      const auto [at, is_new] = known.emplace(id, order.size());
      if (is_new) order.push_back(id);
      REQUIRE(newcomers.index_of(id) == at->second);
    }
    newcomers.finish();
  }
  const auto opened = Newcomers::open(file);
  REQUIRE(opened.size() == order.size());
  for (std::size_t i = 0; i < order.size(); ++i) REQUIRE(opened.id(i) == order[i]);
}

TEST_CASE("what is kept of a submission reads as the same again") {
  const Scratch scratch;
  const Time time = *parse_time("2026-10-01T12:00:00Z");
  const Found found[] = {{{{"s1"}}, {"a.json", time, "{\"x\": \"\\n\"}", ""}, false},
                         {{{"s2"}}, {"", {}, std::string("\xff\x00\n", 3), ""}, false},
                         {{{"s3"}}, {"b \"c\".json", {}, "", "is too large"}, false},
                         {{{"s4"}}, {"link", {}, "", "is a symbolic link"}, true},
                         {{{"s5"}}, {"", {}, "\"problem\":\"refused\":\"", ""}, false},
                         {{}, {"nobody.json", {}, "", "missing key"}, false}};
  std::string lines;
  for (const Found& each : found) write_kept(each.keys.empty() ? "" : each.keys[0].text, each, lines);
  const auto source = open_kept(scratch.write("submissions.jsonl", lines));
  REQUIRE(source);
  for (const Found& each : found) {
    Found again;
    REQUIRE((*source)->next(again));
    CHECK(again.keys == each.keys);
    CHECK(again.refused == each.refused);
    CHECK(again.submission.source == each.submission.source);
    CHECK(again.submission.submitted == each.submission.submitted);
    CHECK(again.submission.text == each.submission.text);
    CHECK(again.submission.problem == each.submission.problem);
  }
  Found none;
  CHECK(!(*source)->next(none));
}
