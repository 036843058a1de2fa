// `blossom-grade stream`, alone and spread by what spreads lines: its own shards, GNU parallel, Slurm.

#include <algorithm>

#include "program.hpp"

namespace blossom::test {
namespace {

const char* const exercise_text = R"({
  "schema": "blossom.exercise/1", "id": "halves", "title": "T", "prompt": "P", "algorithm": "de_casteljau",
  "inputs": {"curve": {"degree": 2, "points": [[0, 0], [2, 4], [6, 0]]}, "u": "1/2"},
  "ask": [{"value": "P[1][0]", "points": 1}, {"value": "P[1][1]", "points": 1}, {"value": "C", "points": 1}]})";

// Right and wrong answers, what is none, a line that is too long, and a last one without an end.
std::string submissions(int count) {
  std::string lines;
  for (int i = 0; i < count; ++i) {
    const std::string number = std::to_string(i);
    const std::string file = R"("schema": "blossom.answers/1", "exercise": "halves", "answers": {"P[1][0]": [1, 2], )"
                             R"("P[1][1]": [4, )" +
                             std::to_string(i % 5) + R"(], "C": ["5/2", 2], "x)" + std::string(i % 300, 'x') + "\": 1}";
    lines += i % 97 == 13      ? "no line " + number
             : i % 89 == 7     ? "{\"student\": \"s" + number + "\", \"submission\": {" + file + "}}"
             : i % 1999 == 500 ? std::string(300'000, 'x')
                               : "{\"student\": \"s" + number + "\", " + file + "}";
    if (i + 1 < count) lines += "\n";
  }
  return lines;
}

struct Class {
  explicit Class(int count)
      : exercise(scratch.write("exercise.json", exercise_text)),
        lines(scratch.write("lines.jsonl", submissions(count))) {}
  Scratch scratch;
  std::string exercise, lines;

  std::string one_process() const {
    const Ended ended = run_program("blossom-grade", {"stream", exercise, "--input", lines, "--jobs", "1"});
    SHOW(ended);
    REQUIRE(ended.status == 0);
    return ended.out;
  }
};

// A program of the system, found on the PATH by `env`.
Ended system_program(std::vector<std::string> arguments, const Setting& setting = {}) {
  return run_program("/usr/bin/env", std::move(arguments), setting);
}
bool has_program(const std::string& name) {
  return system_program({"sh", "-c", "PATH=$PATH:/usr/sbin:/sbin; command -v " + name}).status == 0;
}
std::string grader() { return (fs::path(BLOSSOM_BIN_DIR) / "blossom-grade").string(); }
std::string adapter(const std::string& name) {
  return (fs::path(BLOSSOM_SOURCE_DIR) / "grader/adapters/slurm" / name).string();
}

}  // namespace

TEST_CASE(
    "stream: a line for each line, in order, the same bytes from a file, a pipe, and on any number of processes") {
  const Class course(2500);
  const std::string expected = course.one_process();
  CHECK(std::count(expected.begin(), expected.end(), '\n') == 2500);
  CHECK(contains(expected.substr(0, expected.find('\n')), R"("student":"s0","score":)"));
  for (const char* const jobs : {"2", "3"}) {
    const Ended ended =
        run_program("blossom-grade", {"stream", course.exercise, "--jobs", jobs}, {.input = read_all(course.lines)});
    SHOW(ended);
    CHECK(ended.status == 0);
    CHECK((ended.out == expected));
    CHECK(contains(ended.err, "of 2500 lines could not be graded"));
  }
  const Ended open = run_program("blossom-grade", {"stream", course.exercise, "--input", course.lines, "--no-sandbox"});
  CHECK((open.out == expected));
  CHECK(run_program("blossom-grade", {"stream", course.exercise}).out.empty());
}

TEST_CASE("stream: the shards of a file, one after the other, are what one process writes") {
  const Class course(1000);
  const std::string expected = course.one_process();
  for (const int count : {1, 3, 8}) {
    std::string all;
    for (int i = 1; i <= count; ++i) {
      const std::string out = course.scratch / "out.jsonl";
      const Ended ended =
          run_program("blossom-grade", {"stream", course.exercise, "--input", course.lines, "--shard",
                                        std::to_string(i) + "/" + std::to_string(count), "--output", out, "-j1"});
      SHOW(ended);
      REQUIRE(ended.status == 0);
      CHECK(ended.out.empty());
      all += read_all(out);
    }
    CHECK((all == expected));
  }
  CHECK(course.scratch.count() == 3);  // nothing unfinished is left
}

TEST_CASE("stream: wrong usage and faulty input are said before anything is written") {
  const Class course(3);
  const std::string out = course.scratch / "out.jsonl";
  const auto status = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"stream", course.exercise, "--output", out});
    const Ended ended = run_program("blossom-grade", more, {.input = "{}\n"});
    SHOW(ended);
    CHECK((ended.status == 0 || !ended.err.empty()));
    return ended.status;
  };
  for (const char* const shard : {"0/3", "4/3", "1", "1/", "/3", "a/b", "1/3x", "-1/3", "1/0"})
    CHECK(status({"--input", course.lines, "--shard", shard}) == 2);
  CHECK(status({"--input", course.lines, "--jobs", "0"}) == 2);
  CHECK(status({"--input", course.lines, "--now", "yesterday"}) == 2);
  CHECK(status({"--input", "/dev/null", "--shard", "1/2"}) == 1);
  CHECK(status({"--input", course.scratch / "none.jsonl"}) == 1);
  CHECK(status({"--input", course.scratch.path()}) == 1);
  CHECK(status({"--secret-file", course.scratch / "none"}) == 1);
  CHECK(run_program("blossom-grade", {"stream", course.scratch / "none.json"}).status == 1);
  CHECK(run_program("blossom-grade", {"stream", course.exercise, "--input", course.lines}, {.output_to = "/dev/full"})
            .status == 3);
  CHECK_FALSE(fs::exists(out));
}

TEST_CASE("stream: GNU parallel writes the same bytes as one process") {
  if (!has_program("parallel")) {
    WARN("test skipped: GNU parallel is not installed");
    return;
  }
  const Class course(3000);
  const std::string expected = course.one_process();
  const Ended ended = system_program({"parallel", "--will-cite", "--pipe", "--keep-order", "--jobs", "3", "--block",
                                      "100k", grader(), "stream", course.exercise, "--jobs", "1"},
                                     {.input = read_all(course.lines)});
  INFO(ended.err);
  CHECK(ended.status == 0);
  CHECK((ended.out == expected));
}

TEST_CASE("stream: a Slurm job array and its merge write the same bytes as one process") {
  const Class course(1500);
  const std::string expected = course.one_process();
  const std::string parts = course.scratch / "parts", merged = course.scratch / "merged.jsonl";
  const Scratch cluster;
  const Ended ended =
      system_program({"BLOSSOM_GRADE=" + grader(), BLOSSOM_SOURCE_DIR "/tests/data/slurm.sh", cluster.path(), "sbatch",
                      "--wait", "--array=1-5", "--cpus-per-task=1", "--output=" + (cluster / "task-%a.out"),
                      adapter("grade.sbatch"), course.exercise, course.lines, parts});
  SHOW(ended);
  if (ended.status == 77) {
    WARN("test skipped: " << ended.err);
    return;
  }
  for (int i = 1; i <= 5; ++i) {
    const std::string task = cluster / ("task-" + std::to_string(i) + ".out");
    INFO((fs::exists(task) ? read_all(task) : task + " is missing"));
    CHECK(fs::exists(parts + "/grades-" + std::to_string(i) + "-of-5.jsonl"));
  }
  REQUIRE(ended.status == 0);
  const Ended merge = system_program({adapter("merge.sh"), parts, merged, course.lines});
  SHOW(merge);
  REQUIRE(merge.status == 0);
  CHECK((read_all(merged) == expected));
}

TEST_CASE(
    "stream: the array's script as Slurm would start it, and the merge names what is missing, broken or strange") {
  const Class course(300);
  const std::string expected = course.one_process();
  const std::string parts = course.scratch / "parts", merged = course.scratch / "merged.jsonl";
  const auto task = [&](const std::string& id, const std::string& more = "SLURM_ARRAY_TASK_COUNT=4") {
    return system_program({"BLOSSOM_GRADE=" + grader(), "SLURM_ARRAY_TASK_ID=" + id, more, adapter("grade.sbatch"),
                           course.exercise, course.lines, parts});
  };
  const auto merge = [&](const std::string& of = "") {
    std::vector<std::string> arguments{adapter("merge.sh"), parts, merged};
    if (!of.empty()) arguments.push_back(of);
    return system_program(arguments);
  };
  CHECK(contains(merge().err, "no part"));
  for (const char* const id : {"1", "2", "4"}) CHECK(task(id).status == 0);
  CHECK(task("5").status == 2);
  const Ended missing = merge();
  CHECK(missing.status == 1);
  CHECK(contains(missing.err, "SHARDS=4 sbatch --array=3"));
  CHECK_FALSE(fs::exists(merged));
  CHECK(task("3", "SHARDS=4").status == 0);
  CHECK(merge(course.lines).status == 0);
  CHECK((read_all(merged) == expected));

  fs::remove(merged);
  const std::string third = parts + "/grades-3-of-4.jsonl", whole = read_all(third);
  std::ofstream(third, std::ios::binary) << whole.substr(0, whole.size() - 5);
  CHECK(contains(merge().err, "ends within a line"));
  std::ofstream(third, std::ios::binary) << whole.substr(whole.find('\n') + 1);
  CHECK(contains(merge(course.lines).err, "299 grades for the 300 lines"));
  std::ofstream(third, std::ios::binary) << whole;
  std::ofstream(parts + "/grades-1-of-2.jsonl") << "";
  CHECK(contains(merge().err, "parts of an array of"));
  CHECK_FALSE(fs::exists(merged));
}

}  // namespace blossom::test
