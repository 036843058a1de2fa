// Files nobody can trust: each gets its grade object, score 0 and a reason, and no other grade is touched.

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "grader/report_helpers.hpp"

using namespace blossom;
namespace fs = std::filesystem;

namespace {

std::unique_ptr<Grader> grader_of_class() {
  return grader_of(
      exercise_text("de_boor", de_boor_inputs, R"([{"value": "k", "points": 1}, {"value": "C", "points": 1}])"));
}

void check_invalid(const Grade& grade, const std::string& reason) {
  INFO("reason: " << grade.reason);
  CHECK(grade.reason.find(reason) != std::string::npos);
  CHECK(grade.score() == 0);
  REQUIRE(grade.parts.size() == 2);
  for (const PartGrade& p : grade.parts) CHECK(p.verdict == Verdict::invalid);
  // The grade object is JSON of its own schema, whatever was in the file.
  std::string out;
  write_json(grade, out);
  const auto written = JsonDocument::parse("grade", out);
  INFO(out);
  REQUIRE(written);
  CHECK(written->root().find("score")->text == "0");
  CHECK(written->root().find("reason") != nullptr);
}

}  // namespace

TEST_CASE("documents that are no answers are invalid as a whole, with the reason") {
  const auto grader = grader_of_class();
  const auto check = [&](const std::string& text, const std::string& reason) {
    INFO(text.substr(0, 60));
    check_invalid(grade_text(*grader, text), reason);
  };
  check("", "empty");
  check("   ", "empty");
  check("not json", "unexpected");
  check("[]", "must be an object");
  check("null", "must be an object");
  check("{}", "\"schema\" must be");
  check(R"({"schema": "blossom.answers/2", "exercise": "test", "answers": {}})", "not \"blossom.answers/2\"");
  check(R"({"schema": "blossom.answers/1", "exercise": "other", "answers": {}})",
        "\"exercise\" must be \"test\", not \"other\"");
  check(R"({"schema": "blossom.answers/1", "answers": {}})", "\"exercise\" must be");
  check(R"({"schema": "blossom.answers/1", "exercise": "test"})", "\"answers\" is missing");
  check(R"({"schema": "blossom.answers/1", "exercise": "test", "answers": [4]})", "\"answers\" must be an object");
  check(R"({"schema": 1, "exercise": "test", "answers": {}})", "\"schema\" must be");
}

TEST_CASE("what a JSON reader may let pass is refused") {
  const auto grader = grader_of_class();
  const auto check = [&](const std::string& text, const std::string& reason) {
    INFO(text.substr(0, 60));
    check_invalid(grade_text(*grader, text), reason);
  };
  check(answers_text(R"({"k": 3, "k": 4})"), "duplicate key");
  check(R"({"schema": "blossom.answers/1", "exercise": "test", "answers": {}, "answers": {"k": 4}})", "duplicate key");
  check(answers_text(R"({"k": 4})") + std::string(1, '\0'), "NUL");
  check(answers_text(R"({"k": 4})") + "x", "expected the end");
  check(answers_text(R"({"k": 1e400})"), "too large");
  check(answers_text(R"({"k": NaN})"), "unexpected");
  check(answers_text("{\"k\": \"\xff\"}"), "UTF-8");
  check(answers_text("{\"k\": \"\\ud800\"}"), "surrogate");
  check(answers_text("{\"k\": \"\n\"}"), "line break");
}

TEST_CASE("numbers at the limits of double are read as what they are") {
  const auto grader = grader_of(exercise_text(
      "de_casteljau", R"({"curve": {"degree": 1, "points": [[0, 0], ["1e-400", 18446744073709551617]]}, "u": 1})",
      R"([{"value": "P[1][0]", "points": 1}])"));
  // Past 64 bits, and below the smallest double.
  CHECK(verdict(grade_answers(*grader, R"({"P[1][0]": [1e-400, 18446744073709551617]})"), "P[1][0]") == "correct");
  CHECK(verdict(grade_answers(*grader, R"({"P[1][0]": [0, 18446744073709551617]})"), "P[1][0]") != "correct");
  CHECK(verdict(grade_answers(*grader, R"({"P[1][0]": [1e-400, 18446744073709551616]})"), "P[1][0]") != "correct");
}

TEST_CASE("limits: 64 KiB, 32 levels, 4096 values") {
  const auto grader = grader_of_class();
  const std::string good = answers_text(R"({"k": 4})");
  const std::string full = good + std::string((64u << 10) - good.size(), ' ');
  CHECK(verdict(grade_text(*grader, full), "k") == "correct");
  check_invalid(grade_text(*grader, full + " "), "too large; at most 65536 bytes");

  const auto nested = [](int levels) {  // the two objects around it are levels, too
    return answers_text("{\"k\": " + std::string(static_cast<std::size_t>(levels), '[') +
                        std::string(static_cast<std::size_t>(levels), ']') + "}");
  };
  CHECK(verdict(grade_text(*grader, nested(30)), "k") == "invalid");
  CHECK(grade_text(*grader, nested(30)).reason.empty());
  check_invalid(grade_text(*grader, nested(31)), "nested too deep; at most 32 levels");
  check_invalid(grade_text(*grader, nested(30000)), "nested too deep");

  const auto many = [](int count) {
    std::string text = "{\"k\": [0";
    for (int i = 1; i < count; ++i) text += ",0";
    return answers_text(text + "]}");
  };
  CHECK(grade_text(*grader, many(4096 - 5)).reason.empty());  // the root, schema, exercise, answers and the array
  check_invalid(grade_text(*grader, many(4096 - 4)), "too many values; at most 4096");
}

TEST_CASE("names and texts with control characters come out harmless") {
  Examiner examiner = examiner_of(
      exercise_text("de_boor", de_boor_inputs, R"([{"value": "k", "points": 1}, {"value": "C", "points": 1}])"));
  const StudentResult result =
      result_of(examiner, "bob\x1b[2J\n", answers_text(R"({"k": "\u001b[31m4", "\u0007\u009b2J": 1})"));
  for (const ReportFormat* known : report_formats()) {
    const std::string out = report(*known, {result});
    INFO(known->name << "\n" << out);
    CHECK(out.find('\x1b') == std::string::npos);
    CHECK(out.find('\x07') == std::string::npos);
    CHECK(out.find("\xc2\x9b") == std::string::npos);
    if (known->name == "text") CHECK(out.find("bob\\x1B[2J\\x0A") != std::string::npos);
    if (known->extension != "jsonl" && known->extension != "json") continue;
    CHECK(std::count(out.begin(), out.end(), '\n') == 1);
    json_of(out);
  }
}

TEST_CASE("long numbers are judged, and carried on in double precision") {
  const auto grader = grader_of(exercise_text(
      "de_casteljau",
      R"({"curve": {"degree": 25, "points": [[0,0],[1,3],[2,1],[3,5],[4,2],[5,2],[6,7],[7,1],[8,4],[9,9],[10,1],[11,3],[12,6],
      [13,5],[14,3],[15,1],[16,2],[17,8],[18,2],[19,4],[20,6],[21,1],[22,3],[23,7],[24,1],[25,0]]}, "u": "1/3"})",
      R"([{"value": "P[1][*]", "points": 1}, {"value": "C", "points": 1}])"));
  std::string answers = "{";
  for (int i = 0; i < 25; ++i) {
    const std::string digits = std::string(180, static_cast<char>('1' + i % 9));
    answers += "\"P[1][" + std::to_string(i) + "]\": [\"" + digits + "/" + digits.substr(7) + "1\", \"1e" +
               std::to_string(200 + i) + "\"], ";
  }
  const Grade grade = grade_answers(*grader, answers + R"("C": [1, 2]})");
  CHECK(verdict(grade, "C") == "wrong");
  CHECK(grade.reason.empty());
}

TEST_CASE("random answers never break a replay, and earn no more than there is") {
  const unsigned seed = 4711;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  const std::string huge = "\"" + std::string(200, '9') + "/" + std::string(190, '7') + "\"";
  const std::vector<std::string> numbers{
      "0",       "1",         "-1", "0.5",         "\"1/3\"",  "1e300", "-1e300", "1e-300", huge,   "12345.678901",
      "\"2/5\"", "\"1e308\"", "-0", "\"-1e-400\"", "\"-1/7\"", "1e-15", "3",      "2",      "null", "\"x\""};
  const auto number = [&] { return numbers[random() % numbers.size()]; };
  for (const Standard& s : standards) {
    const auto grader = grader_of(exercise_text(s.algorithm, s.inputs, s.ask, R"(, "tolerance": {"decimals": 6})"));
    const Exercise& exercise = grader->exercise();
    for (int n = 0; n < 60; ++n) {
      std::map<std::string, std::string> other;
      for (const Part& asked : exercise.parts) {
        if (random() % 3 == 0) continue;
        std::string text;
        const std::size_t count = asked.size() != 0 ? asked.size() : asked.right.size() + random() % 2;
        for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + number();
        other[asked.name] = asked.is_single() ? text : "[" + text + "]";
      }
      const Grade grade = grade_answers(*grader, all_answers(exercise, other));
      INFO(s.algorithm << " " << n);
      CHECK(grade.reason.empty());
      CHECK(grade.score() >= 0);
      CHECK(grade.score() <= 1);
    }
  }
}

TEST_CASE("paths that are no files are invalid submissions") {
  const auto grader = grader_of_class();
  const fs::path folder = fs::temp_directory_path() / ("blossom-hostile-" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const auto good = folder / "good.json";
  std::ofstream(good) << answers_text(R"({"k": 4})");
  const auto load = [&](const fs::path& path) {
    return grader->grade(JsonDocument::load(path, submission_limits), path.stem().string());
  };
  check_invalid(load(folder / "missing.json"), "cannot be read");
  check_invalid(load(folder), "not a folder");
  check_invalid(load("/dev/zero"), "not a device");
  const auto pipe = folder / "pipe.json";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  check_invalid(load(pipe), "not a pipe");
  const auto dangling = folder / "dangling.json", loop = folder / "loop.json", link = folder / "link.json";
  fs::create_symlink(folder / "nowhere", dangling);
  fs::create_symlink(loop, loop);
  fs::create_symlink(good, link);
  check_invalid(load(dangling), "cannot be read");
  check_invalid(load(loop), "cannot be read");
  CHECK(verdict(load(link), "k") == "correct");  // after all of that
  CHECK(load(folder / "missing.json").reason.find(folder.string()) == std::string::npos);
  fs::remove_all(folder);
}
