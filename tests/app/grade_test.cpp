// `blossom-grade` from end to end, on the made-up class that `./dev demo` shows.
#include <unistd.h>

#include <algorithm>

#include "app/program.hpp"
#include "base/json.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

const std::string exercise = "exercises/22-de-boor.json";
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
    CHECK(ended.err.ends_with(arguments.empty() ? "\nTry `blossom-grade --help`.\n"
                                                : "\nTry `blossom-grade grade --help`.\n"));
  }
  const auto help = run_program("blossom-grade", {"grade", "--help"});
  SHOW(help);
  CHECK(help.status == 0);
  CHECK(contains(help.out, "blossom-grade " + exercise + " "));
  CHECK(contains(run_program("blossom-grade", {"--help"}).out, "grade"));
  if (access("/dev/full", W_OK) != 0) return;
  const auto full =
      run_program("blossom-grade", {exercise, "exercises/demo-class/perfect.json"}, {.output_to = "/dev/full"});
  SHOW(full);
  CHECK(full.status == 3);
  CHECK(contains(full.err, "cannot be written"));
}

TEST_CASE("With --student all files are one student's, from a folder too, and only one of them counts") {
  const Scratch scratch;
  const auto first = grade({"--student", "s17", "--format", "json"}, {"perfect", "early-slip"});
  SHOW(first);
  CHECK(first.status == 0);
  const auto grades = read_grades(first.out);
  REQUIRE(grades.size() == 1);
  CHECK(contains(first.out, "\"student\":\"s17\""));
  fs::create_directories(scratch / "in/below");
  fs::copy_file(fs::path(BLOSSOM_SOURCE_DIR) / "exercises/demo-class/perfect.json", scratch / "in/below/a.json");
  const auto folder = run_program("blossom-grade", {exercise, scratch / "in", "--student", "s17"});
  SHOW(folder);
  CHECK(folder.status == 0);
  CHECK(folder.out.starts_with("s17: 100 % (11/11 points) in de-boor\n"));
  fs::create_directories(scratch / "empty");
  const auto nothing = run_program("blossom-grade", {exercise, scratch / "empty", "--student", "s17"});
  SHOW(nothing);
  CHECK(nothing.status == 0);
  CHECK(contains(nothing.out, "Missing: nothing was handed in."));
}

TEST_CASE("An assignment: each file against the exercise that it names, and lateness by --submitted") {
  const Scratch scratch;
  for (const char* name : {"22-de-boor", "11-de-casteljau"})
    fs::copy_file(fs::path(BLOSSOM_SOURCE_DIR) / "exercises" / (std::string(name) + ".json"),
                  scratch / (std::string(name) + ".json"));
  const auto assignment = scratch.write("hw.json", R"({"schema": "blossom.assignment/1", "id": "hw", "title": "H",
      "exercises": [{"file": "22-de-boor.json", "points": 8}, {"file": "11-de-casteljau.json", "points": 2}],
      "due": "2026-10-01T00:00:00Z", "late": {"per_day": "1/2"}})");
  const std::string perfect = "exercises/demo-class/perfect.json";
  const auto other =
      scratch.write("ann.json", R"({"schema": "blossom.answers/1", "exercise": "other", "answers": {}})");
  const auto files = run_program("blossom-grade", {assignment, perfect, other});
  SHOW(files);
  CHECK(files.status == 1);
  CHECK(contains(files.out, "perfect: 100 % (8/8 points) in de-boor\n"));
  CHECK_FALSE(contains(files.out, "in de-casteljau"));
  CHECK(contains(
      files.out,
      "ann: 0 % (0/0 points) in all\n  Not part of this assignment: \"other\" is no exercise of this assignment"));

  const auto late = run_program("blossom-grade",
                                {assignment, perfect, "--student", "s17", "--submitted", "2026-10-01T10:00:00+02:00"});
  SHOW(late);
  CHECK(late.status == 0);
  CHECK(contains(late.out, "s17: 50 % (4/8 points) in de-boor\n"));
  CHECK(contains(late.out, "s17: 40 % (4/10 points) in all\n"));
}

TEST_CASE("What is graded as one student's needs to be told whose it is") {
  for (const std::vector<std::string>& given :
       {std::vector<std::string>{"exercises/22-de-boor.json", "exercises"},
        {"exercises/11-own-de-casteljau.json", "exercises/demo-class/perfect.json"}}) {
    const auto ended = run_program("blossom-grade", given);
    SHOW(ended);
    CHECK(ended.status == 2);
    CHECK(ended.out == "");
    CHECK(contains(ended.err, "with --student ID or --metadata"));
  }
}

TEST_CASE(
    "A report that goes to a file with --out is written whole, or leaves the file as it was; --now decides what is "
    "shown") {
  const Scratch scratch;
  const auto out = scratch.write("report", "old");
  const std::string perfect = "exercises/demo-class/perfect.json", slip = "exercises/demo-class/early-slip.json";
  const auto faulty = run_program("blossom-grade", {scratch.write("e.json", "{}"), perfect, "--out", out});
  SHOW(faulty);
  CHECK(faulty.status == 1);
  CHECK(read_all(out) == "old");
  const auto whole = run_program("blossom-grade", {exercise, slip, "--format", "junit", "--out", out});
  SHOW(whole);
  CHECK(whole.status == 0);
  CHECK(whole.out.empty());
  CHECK(read_all(out) == run_program("blossom-grade", {exercise, slip, "--format", "junit"}).out);
  const auto nowhere = run_program("blossom-grade", {exercise, slip, "--out", scratch / "no/folder/report"});
  SHOW(nowhere);
  CHECK(nowhere.status == 3);

  fs::copy_file(fs::path(BLOSSOM_SOURCE_DIR) / exercise, scratch / "e5.json");
  const auto assignment = scratch.write("hw.json", R"({"schema": "blossom.assignment/1", "id": "hw", "title": "H",
      "exercises": [{"file": "e5.json"}], "feedback": "verdict", "full_feedback_from": "2026-10-05T00:00:00Z"})");
  const auto at = [&](const std::string& now) {
    return run_program("blossom-grade", {assignment, slip, "--now", now}).out;
  };
  CHECK_FALSE(contains(at("2026-10-04T23:59:59Z"), "Right is"));
  CHECK(contains(at("2026-10-05T00:00:00Z"), "Right is"));
}

TEST_CASE("What is mistyped on the command line is told with what was probably meant") {
  struct Case {
    std::vector<std::string> arguments;
    std::string says;
  };
  for (const Case& each :
       {Case{{"btch", "a.json", "b"}, "there is no command or file \"btch\"; did you mean \"batch\"?"},
        Case{{"batch", "a.json", "b", "--out", "c", "--rooster", "canvas.csv"},
             "not expected: --rooster canvas.csv; did you mean --roster?"},
        Case{{exercise, "a.json", "--format", "canvass"}, "; did you mean canvas?"},
        Case{{"batch", "a.json", "b", "--out", "c", "--format", "canvass"}, "; did you mean canvas?"}}) {
    const auto ended = run_program("blossom-grade", each.arguments);
    SHOW(ended);
    CHECK(ended.status == 2);
    CHECK(contains(ended.err, each.says));
  }
}

TEST_CASE("What does not go together is wrong usage") {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{exercise, "a.json", "b.json", "--format", "gradescope"},
        {exercise, "a.json", "--submitted", "2026-10-01T00:00:00Z"},
        {exercise, "a.json", "--student", "s17", "--submitted", "yesterday"},
        {exercise, "a.json", "--now", "2026-10-01"}}) {
    const auto ended = run_program("blossom-grade", arguments);
    SHOW(ended);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
  }
}
