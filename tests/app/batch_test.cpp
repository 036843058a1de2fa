// `blossom-grade batch` and `regrade` from end to end, on the course that is shipped; and killed again and again.
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <random>
#include <thread>

#include "app/program.hpp"
#include "sanitized.hpp"

using namespace blossom::test;

namespace {

const std::string demo = "exercises/demo-course/";

Ended batch(const std::string& submissions, const std::string& out, std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{
      "batch", demo + "course.json",  submissions, "--roster", demo + "roster.csv", "--out", out,
      "--now", "2026-10-10T00:00:00Z"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program("blossom-grade", arguments);
}

std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = read_all(entry.path());
  return files;
}

// Starts it and kills it after a while, if it has not ended by then: its status, 128 + 9 if it was killed.
int run_and_kill(std::vector<std::string> arguments, std::chrono::microseconds after) {
  arguments.insert(arguments.begin(), (fs::path(BLOSSOM_BIN_DIR) / "blossom-grade").string());
  std::vector<char*> argv;
  for (auto& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (const int fd : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, fd, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  REQUIRE(posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ) == 0);
  posix_spawn_file_actions_destroy(&actions);
  std::this_thread::sleep_for(after);
  kill(child, SIGKILL);
  int how = 0;
  REQUIRE(waitpid(child, &how, 0) == child);
  return WIFEXITED(how) ? WEXITSTATUS(how) : 128 + WTERMSIG(how);
}

}  // namespace

TEST_CASE("the course that is shipped is graded: each kind of student gets what they should") {
  const Scratch scratch;
  const auto ended = batch(demo + "submissions.jsonl", scratch / "out", {"--format", "canvas,gradescope"});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, "12 students, 34 submissions"));
  CHECK(contains(ended.out, "3 late, 6 missing, 1 duplicate, 1 unreadable, 1 misplaced, 3 foreign-id, 1 unlisted"));
  CHECK(contains(ended.out, "out/class.html"));
  const auto files = files_of(scratch / "out");
  const auto& results = files.at("results.jsonl");
  CHECK(std::ranges::count(results, '\n') == 12);
  const auto line = [&](const std::string& id) {
    const auto at = results.find("{\"id\":\"" + id + "\"");
    REQUIRE(at != std::string::npos);
    return results.substr(at, results.find('\n', at) - at);
  };
  CHECK(contains(line("s01"), R"("points":100,"max_points":100)"));
  CHECK(contains(line("s02"), R"("verdict":"carried")"));
  CHECK(contains(line("s03"), R"("misconception":"swapped-weights")"));
  CHECK(contains(line("s04"), R"("verdict":"slip")"));
  CHECK(contains(line("s05"), R"("points":80,)"));  // two days late at a tenth each
  CHECK(contains(line("s06"), R"("state":"missing")"));
  CHECK(contains(line("s10"), R"("source":"hypatia/de-boor.json")"));
  CHECK(!contains(line("s12"), "days_late"));  // an extension
  CHECK(contains(files.at("incidents.csv"), "visitor,unlisted,,visitor.json,"));
  CHECK(files.contains("gradebook.canvas.csv"));
  CHECK(files.contains("gradescope/s01.json"));
  CHECK(files.contains("students/s01.html"));

  const auto again = batch(demo + "submissions.jsonl", scratch / "out", {"--format", "canvas,gradescope"});
  SHOW(again);
  CHECK(again.status == 0);
  CHECK(contains(again.out, "Nothing was to be done"));
  const auto other = batch(demo + "submissions.jsonl", scratch / "out");
  SHOW(other);
  CHECK(other.status == 1);
  CHECK(contains(other.err, "--fresh"));
}

TEST_CASE("the folder that is shipped has the same submissions as the lines, without their times") {
  const Scratch scratch;
  CHECK(batch(demo + "submissions", scratch / "folder").status == 0);
  std::string lines = read_all(demo + "submissions.jsonl");
  for (std::size_t at; (at = lines.find("\"submitted\": \"")) != std::string::npos;)
    lines.erase(at, lines.find(", ", at) + 2 - at);
  CHECK(batch(scratch.write("class.jsonl", lines), scratch / "lines").status == 0);
  auto folder = files_of(scratch / "folder"), from_lines = files_of(scratch / "lines");
  for (auto* files : {&folder, &from_lines}) files->erase("run.json");  // which tells them apart
  CHECK(folder.size() > 20);
  CHECK(folder == from_lines);
}

TEST_CASE("a class comes on standard input") {
  const Scratch scratch;
  const auto ended = run_program("blossom-grade", {"batch", demo + "course.json", "-", "--out", scratch / "out"},
                                 {.input = read_all(demo + "submissions.jsonl")});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, "12 students"));  // eleven who handed in, and the visitor: there is no roster
}

TEST_CASE("a run from standard input is gone on with only when the same comes again") {
  const Scratch scratch;
  const std::string lines = read_all(demo + "submissions.jsonl");
  const auto again = [&](const std::string& input) {
    return run_program("blossom-grade", {"batch", demo + "course.json", "-", "--out", scratch / "killed"},
                       {.input = input});
  };
  std::string many;
  for (int i = 0; i < 200; ++i) many += lines;
  const auto input = scratch.write("input", many);
  for (int attempt = 0; attempt < 60 && !fs::exists(scratch / "killed/.work/read.json"); ++attempt) {
    fs::remove_all(scratch / "killed");
    const pid_t child = fork();
    if (child == 0) {
      const int in = open(input.c_str(), O_RDONLY), null = open("/dev/null", O_WRONLY);
      dup2(in, 0);
      dup2(null, 1);
      const std::string program = (fs::path(BLOSSOM_BIN_DIR) / "blossom-grade").string(), out = scratch / "killed";
      execl(program.c_str(), program.c_str(), "batch", (demo + "course.json").c_str(), "-", "--out", out.c_str(),
            nullptr);
      _exit(127);
    }
    int status = 0;
    while (!fs::exists(scratch / "killed/.work/read.json") && waitpid(child, &status, WNOHANG) == 0)
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
  }
  REQUIRE(fs::exists(scratch / "killed/.work/read.json"));
  const auto other = again(lines);
  SHOW(other);
  CHECK(other.status == 1);
  CHECK(contains(other.err, "standard input has other submissions now"));
  const auto same = again(many);
  SHOW(same);
  CHECK(same.status == 0);
  CHECK(contains(same.out, "Went on"));
}

TEST_CASE("regrading after an exercise has changed says who, from what to what, and why") {
  const Scratch scratch;
  CHECK(batch(demo + "submissions.jsonl", scratch / "old").status == 0);
  fs::create_directory(scratch / "course");
  for (const auto* name : {"11-de-casteljau.json", "22-de-boor.json", "28-knot-insertion.json"})
    fs::copy_file(fs::path("exercises") / name, scratch / name);
  fs::copy_file(demo + "course.json", scratch / "course/course.json");
  std::string exercise = read_all("exercises/22-de-boor.json");
  const std::string points = R"("value": "k", "points": 1)";
  exercise.replace(exercise.find(points), points.size(), R"("value": "k", "points": 3)");
  scratch.write("22-de-boor.json", exercise);
  const auto ended = run_program("blossom-grade", {"regrade", scratch / "old", scratch / "course/course.json", "--out",
                                                   scratch / "new", "--now", "2026-10-10T00:00:00Z"});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(contains(ended.out, "  de-boor k: correct, 1 of 1 -> correct, 3 of 3 (points 1 -> 3)"));
  CHECK(contains(ended.out, "What has changed:\ns01: 100 of 100 as before\n"));
  CHECK(contains(read_all(scratch / "new/changes.csv"), "points 1 -> 3"));
  const auto same =
      run_program("blossom-grade", {"regrade", scratch / "old", demo + "course.json", "--out", scratch / "old"});
  SHOW(same);
  CHECK(same.status == 2);
}

TEST_CASE("mistakes: nothing is written, and what is wrong is said") {
  const Scratch scratch;
  const auto refused = [&](std::vector<std::string> arguments, int status, const std::string& said) {
    const auto ended = run_program("blossom-grade", arguments);
    SHOW(ended);
    CHECK(ended.status == status);
    CHECK(contains(ended.err, said));
    CHECK(!fs::exists(scratch / "out"));
  };
  const std::string out = scratch / "out", course = demo + "course.json", lines = demo + "submissions.jsonl";
  refused({"batch", course, lines}, 2, "--out");
  refused({"batch", course, lines, "--out", ""}, 2, "--out");
  refused({"batch", course, lines, "--out", out, "--jobs", "0"}, 2, "--jobs");
  refused({"batch", course, lines, "--out", out, "--format", "xls"}, 2, "--format");
  refused({"batch", course, lines, "--out", out, "--now", "today"}, 2, "--now");
  refused({"batch", "none.json", lines, "--out", out}, 1, "none.json");
  refused({"batch", course, "none", "--out", out}, 1, "none");
  refused({"batch", course, lines, "--out", out, "--roster", course}, 1, "course.json");
  refused({"regrade", scratch / "nowhere", course, "--out", out}, 1, "nowhere");
}

namespace {

// The most memory a process of such a run takes, in KiB.
long memory_of_class(std::size_t students) {
  const Scratch scratch;
  std::string lines;
  for (std::size_t i = 0; i < students; ++i)
    lines += "{\"student\": \"s" + std::to_string(i) +
             R"(", "schema": "blossom.answers/1", "exercise": "de-boor", "answers": {"k": 4, "P[1][3]": [16, 20]}})" +
             "\n";
  std::vector<std::string> arguments{(fs::path(BLOSSOM_BIN_DIR) / "blossom-grade").string(),
                                     "batch",
                                     "exercises/22-de-boor.json",
                                     scratch.write("class.jsonl", lines),
                                     "--class-only",
                                     "--out",
                                     scratch / "out"};
  std::vector<char*> argv;
  for (auto& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  REQUIRE(posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ) == 0);
  posix_spawn_file_actions_destroy(&actions);
  int how = 0;
  rusage used{};
  REQUIRE(wait4(child, &how, 0, &used) == child);
  REQUIRE(WIFEXITED(how));
  REQUIRE(WEXITSTATUS(how) == 0);
  return used.ru_maxrss;
}

}  // namespace

TEST_CASE("ten times the class takes no more memory than a little") {
  if (sanitized) {
    WARN("test skipped: the sanitizer keeps what is freed");
    return;
  }
  const long small = memory_of_class(1500), large = memory_of_class(15'000);
  INFO(small << " and " << large << " KiB");
  CHECK(large < small + 8 * 1024);
}

TEST_CASE("killed at any moment and started again, it ends in the same bytes as if nothing had been") {
  const Scratch scratch;
  std::string lines;
  {
    std::istringstream in(read_all(demo + "submissions.jsonl"));
    std::vector<std::string> models;
    for (std::string line; std::getline(in, line);) models.push_back(line.substr(line.find(", \"submission\"")));
    for (std::size_t i = 0; i < 2000; ++i)
      lines += "{\"student\": \"s" + std::to_string(i / 2) + "\"" + models[i * 31 % models.size()] + "\n";
  }
  const std::string submissions = scratch.write("class.jsonl", lines);
  const auto arguments = [&](const std::string& out) {
    return std::vector<std::string>{"batch", demo + "course.json",   submissions, "--out", out, "--format", "canvas",
                                    "--now", "2026-10-10T00:00:00Z", "--jobs",    "2"};
  };
  const auto begin = std::chrono::steady_clock::now();
  REQUIRE(run_program("blossom-grade", arguments(scratch / "whole")).status == 0);
  const auto whole_time =
      std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin);
  const auto whole = files_of(scratch / "whole");
  REQUIRE(whole.size() > 2000);

  const unsigned seed = 4711;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 3; ++round) {
    const std::string out = scratch / ("killed-" + std::to_string(round));
    int status = 128 + SIGKILL, kills = 0;
    // Whatever is done in the mean time is kept, so that it ends; the last run has all the time it wants. The first
    // kill comes before anybody can be done, whatever else the machine does.
    while (status == 128 + SIGKILL && kills < 12) {
      const long latest = kills == 0 ? 2000 : whole_time.count() / 2;
      status = run_and_kill(arguments(out),
                            std::chrono::microseconds(std::uniform_int_distribution<long>(1000, latest)(random)));
      kills += status == 128 + SIGKILL ? 1 : 0;
    }
    if (status != 0) status = run_program("blossom-grade", arguments(out)).status;
    INFO("round " << round << ", killed " << kills << " times");
    CHECK(status == 0);
    CHECK(kills > 0);
    const auto files = files_of(out);
    CHECK(files.size() == whole.size());
    for (const auto& [name, content] : whole) {
      INFO(name);
      REQUIRE(files.contains(name));
      REQUIRE((files.at(name) == content));
    }
  }
}
