// `blossom-grade` from end to end, on the made-up class that `./dev demo` shows.
#include <unistd.h>

#include <algorithm>

#include "app/program.hpp"
#include "base/json.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

const std::string exercise = "exercises/05-de-boor.json";
const std::vector<std::string> students{"perfect", "early-slip", "swapped-weights", "not-json", "empty"};

Ended grade(const std::vector<std::string>& more, const std::vector<std::string>& who = students) {
  std::vector<std::string> arguments{exercise};
  for (const auto& student : who) arguments.push_back("exercises/demo-class/" + student + ".json");
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program("blossom-grade", arguments);
}

struct Graded {
  double score = -1;
  std::vector<std::string> verdicts;
};

std::vector<Graded> read_grades(const std::string& lines) {
  std::vector<Graded> grades;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    const auto document = JsonDocument::parse("grade", line);
    INFO(line << "\n" << to_string(document.diagnostics));
    REQUIRE(document);
    const Json* schema = document->root().find("schema");
    const Json* score = document->root().find("score");
    const Json* parts = document->root().find("parts");
    REQUIRE(schema != nullptr);
    REQUIRE(score != nullptr);
    REQUIRE(parts != nullptr);
    CHECK(schema->text == "blossom.grade/1");
    grades.push_back({Exact::parse(score->text)->to_double(), {}});
    for (const Json& part : parts->items) grades.back().verdicts.push_back(part.find("verdict")->text);
  }
  return grades;
}

}  // namespace

TEST_CASE("The class is graded as its teacher would: in text, a block each and a table") {
  const auto ended = grade({});
  SHOW(ended);
  CHECK(ended.status == 1);  // two of them cannot be read
  for (const auto& student : students) CHECK(contains(ended.out, student));
  for (const auto* verdict : {"carried", "invalid"}) CHECK(contains(ended.out, verdict));
  const auto readable = grade({}, {"perfect", "early-slip", "swapped-weights"});
  SHOW(readable);
  CHECK(readable.status == 0);
  CHECK(readable.err.empty());
}

TEST_CASE("The class in JSON is one grade for each, in the order given") {
  const auto ended = grade({"--format", "json"});
  SHOW(ended);
  CHECK(ended.status == 1);
  const auto grades = read_grades(ended.out);
  REQUIRE(grades.size() == students.size());
  const auto count = [&](std::size_t student, const std::string& verdict) {
    return std::ranges::count(grades[student].verdicts, verdict);
  };
  const auto parts = static_cast<std::ptrdiff_t>(grades[0].verdicts.size());
  REQUIRE(parts > 5);

  CHECK(grades[0].score == 1);
  CHECK(count(0, "correct") == parts);
  // One wrong number early, the rest computed rightly from it: it costs its own points only.
  CHECK(count(1, "carried") > 0);
  CHECK(count(1, "correct") > 0);
  CHECK(count(1, "correct") + count(1, "carried") == parts - 1);
  CHECK(grades[1].score > 0.5);
  CHECK(grades[1].score < 1);
  CHECK(count(2, "misconception") > 0);
  CHECK(grades[2].score < grades[1].score);
  for (const std::size_t unreadable : {3u, 4u}) {
    CHECK(grades[unreadable].score == 0);
    CHECK(count(unreadable, "invalid") == parts);
  }
}

TEST_CASE("What one hands in changes nobody else's grade") {
  const auto all = grade({"--format", "json"});
  std::string one_by_one;
  for (const auto& student : students) one_by_one += grade({"--format", "json"}, {student}).out;
  CHECK(all.out == one_by_one);
}

TEST_CASE("A submission comes from standard input") {
  const auto ended = run_program("blossom-grade", {exercise, "-", "--format", "json"},
                                 {.input = read_all("exercises/demo-class/perfect.json")});
  SHOW(ended);
  CHECK(ended.status == 0);
  const auto grades = read_grades(ended.out);
  REQUIRE(grades.size() == 1);
  CHECK(grades[0].score == 1);
}

TEST_CASE("A missing submission is graded 0 and does not stop the others") {
  const auto ended = grade({"--format", "json"}, {"nobody", "perfect"});
  SHOW(ended);
  CHECK(ended.status == 1);
  const auto grades = read_grades(ended.out);
  REQUIRE(grades.size() == 2);
  CHECK(grades[0].score == 0);
  CHECK(grades[1].score == 1);
}

TEST_CASE("A faulty exercise grades nothing, wrong usage is 2, full disks are 3") {
  const Scratch scratch;
  const auto faulty =
      run_program("blossom-grade", {scratch.write("e.json", "{\"schema\": \"blossom.exercise/1\"}"), "-"});
  SHOW(faulty);
  CHECK(faulty.status == 1);
  CHECK(faulty.out.empty());
  CHECK(contains(faulty.err, "e.json:1:"));
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{}, {exercise}, {exercise, "-", "--format", "xml"}, {exercise, "-", "--grad"}}) {
    const auto ended = run_program("blossom-grade", arguments);
    SHOW(ended);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    CHECK(ended.err.starts_with("blossom-grade: "));
    CHECK(ended.err.ends_with("\nTry `blossom-grade --help`.\n"));
  }
  const auto help = run_program("blossom-grade", {"--help"});
  SHOW(help);
  CHECK(help.status == 0);
  CHECK(contains(help.out, "blossom-grade " + exercise + " "));
  if (access("/dev/full", W_OK) != 0) return;
  const auto full =
      run_program("blossom-grade", {exercise, "exercises/demo-class/perfect.json"}, {.output_to = "/dev/full"});
  SHOW(full);
  CHECK(full.status == 3);
  CHECK(contains(full.err, "cannot be written"));
}
