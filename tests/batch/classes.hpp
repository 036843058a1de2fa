#pragma once
// What the tests of classes share: a small course, its submissions, and a folder of results as a map of its files.

#include <catch2/catch.hpp>
#include <map>
#include <sstream>

#include "grader/batch/batch.hpp"
#include "scratch.hpp"

namespace blossom {

using blossom::test::Scratch;

inline std::string read_file(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

// Every file below, by its path; but for those that say what a run was made of.
inline std::map<std::string, std::string> files_of(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename() != "run.json")
      files[entry.path().lexically_relative(folder).string()] = read_file(entry.path());
  return files;
}

// Says which file differs rather than printing all of them.
inline void check_same(const std::map<std::string, std::string>& a, const std::map<std::string, std::string>& b) {
  REQUIRE(!a.empty());
  for (const auto& [name, content] : a) {
    INFO(name);
    REQUIRE(b.contains(name));
    CHECK(b.at(name) == content);
  }
  CHECK(a.size() == b.size());
}

// An exercise of one value, 1.2 = (1 - 2/5) 0 + 2/5 3 in its second coordinate.
inline std::string small_exercise(const std::string& id, const std::string& ask = R"("points": 1)") {
  return R"({"schema": "blossom.exercise/1", "id": ")" + id +
         R"(", "title": "T", "prompt": "P", "algorithm": "de_casteljau",
           "inputs": {"curve": {"degree": 1, "points": [[0, 0], [1, 3]]}, "u": "2/5"},
           "ask": [{"value": "P[1][0]", )" +
         ask + "}]}";
}

inline std::string small_answers(const std::string& id, const std::string& value) {
  return R"({"schema": "blossom.answers/1", "exercise": ")" + id + R"(", "answers": {"P[1][0]": )" + value + "}}";
}

inline const char* const right_value = R"(["2/5", "6/5"])";

inline std::string small_course(const std::string& more = "", const std::string& ask = R"("points": 1)") {
  return R"({"schema": "blossom.assignment/1", "id": "c", "title": "C", "exercises": [{"exercise": )" +
         small_exercise("a", ask) + R"(, "points": 4}, {"exercise": )" + small_exercise("b") + R"(, "points": 6}])" +
         more + "}";
}

inline std::string line_of_class(const std::string& student, const std::string& text, const std::string& more = "") {
  return "{\"student\": " + json_quote(student) + more + ", \"submission\": " + json_quote(text) + "}\n";
}

// Answers of every kind, by the number of the student.
inline std::string class_lines(std::size_t students) {
  std::string lines;
  for (std::size_t i = 0; i < students; ++i) {
    const std::string id = "s" + std::to_string(i);
    const char* const values[] = {right_value, R"(["3/5", "9/5"])", "[0.4, -1.2]", "[7, 8]", "\"<b>\"", "[1]"};
    lines += line_of_class(id, small_answers("a", values[i % 6]));
    if (i % 3 != 0) lines += line_of_class(id, small_answers("b", values[i * 7 % 6]));
    if (i % 5 == 0) lines += line_of_class(id, small_answers("b", right_value));
    if (i % 7 == 0) lines += line_of_class(id, "{nonsense " + id);
    if (i % 11 == 0) lines += line_of_class(id, small_answers("z", right_value));
  }
  return lines;
}

inline BatchOptions class_options(const Scratch& scratch, const std::string& submissions, const std::string& out) {
  BatchOptions options;
  options.assignment = scratch / "course.json";
  options.submissions = submissions;
  options.out = scratch / out;
  options.now = parse_time("2026-10-10T00:00:00Z");
  options.workers.processes = 1;
  return options;
}

inline BatchSummary grade_class(const BatchOptions& options) {
  auto summary = run_batch(options, [](const BatchProgress&) {});
  INFO(to_string(summary.diagnostics));
  REQUIRE(summary);
  return std::move(*summary);
}

inline std::string refusal(const BatchOptions& options) {
  const auto summary = run_batch(options, [](const BatchProgress&) {});
  REQUIRE(!summary);
  return to_string(summary.diagnostics);
}

}  // namespace blossom
