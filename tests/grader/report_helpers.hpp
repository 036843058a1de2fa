#pragma once
// What the tests of the output formats share: results from text, and a report of them.

#include <algorithm>
#include <sstream>

#include "grader/csv.hpp"
#include "grader/helpers.hpp"
#include "scratch.hpp"

namespace blossom {

inline const ReportFormat& format(std::string_view name) {
  const ReportFormat* found = find_report_format(name);
  INFO(name);
  REQUIRE(found != nullptr);
  return *found;
}

// An examiner of an exercise, or of an assignment whose exercises lie in a scratch folder.
inline Examiner examiner_of(const std::string& text, const std::string& now = "2026-10-02T00:00:00Z") {
  auto document = JsonDocument::parse("exercise.json", text);
  REQUIRE(document);
  auto assignment = read_assignment(*document);
  INFO(to_string(assignment.diagnostics));
  REQUIRE(assignment);
  return Examiner(std::move(*assignment), {}, *parse_time(now));
}

inline Submission submission(std::string text, std::string source = {}, const std::string& time = {}) {
  Submission made;
  made.source = std::move(source);
  made.text = std::move(text);
  if (!time.empty()) made.submitted = parse_time(time);
  return made;
}

inline StudentResult result_of(Examiner& examiner, const std::string& student, const std::string& answers) {
  Student who;
  who.id = student;
  return grade_student(examiner, who, {submission(answers)});
}

inline std::string report(const ReportFormat& format, const std::vector<StudentResult>& results) {
  const auto report = format.open({results[0].assignment, results.size(), true});
  std::string out;
  report->begin(out);
  for (const StudentResult& result : results) report->add(result, out);
  report->finish(out);
  return out;
}

// The rows of a CSV file as its reader has them.
inline std::vector<std::vector<std::string>> rows_of(const std::string& csv) {
  std::istringstream in(csv);
  CsvReader reader("report.csv", in);
  std::vector<std::vector<std::string>> rows;
  for (std::vector<std::string> cells; reader.next(cells);) rows.push_back(cells);
  INFO(to_string(reader.diagnostics()));
  REQUIRE(reader.diagnostics().empty());
  return rows;
}

inline JsonDocument json_of(const std::string& text) {
  auto document = JsonDocument::parse("report", text);
  INFO(text << "\n" << to_string(document.diagnostics));
  REQUIRE(document);
  return std::move(*document);
}

// A member that must be there and of that kind.
inline const Json& member(const Json& object, std::string_view key, Json::Kind kind) {
  const Json* found = object.find(key);
  INFO(key);
  REQUIRE(found != nullptr);
  REQUIRE(found->kind == kind);
  return *found;
}
inline double number(const Json& object, std::string_view key) {
  return Exact::parse(member(object, key, Json::Kind::number).text)->to_double();
}
inline const std::string& text(const Json& object, std::string_view key) {
  return member(object, key, Json::Kind::string).text;
}

inline const char* const report_ask = R"([{"value": "P[1][*]", "points": 1}, {"value": "C", "points": "1/2"}])";
inline const char* const report_inputs = R"({"curve": {"degree": 2, "points": [[0, 0], [2, 4], [4, 0]]}, "u": "1/2"})";

// De Casteljau with three values, at a level of feedback.
inline std::string report_exercise(const std::string& level, const std::string& id = "test",
                                   const std::string& title = "T") {
  return R"({"schema": "blossom.exercise/1", "id": ")" + id + R"(", "title": )" + json_quote(title) +
         R"(, "prompt": "P", "algorithm": "de_casteljau", "inputs": )" + report_inputs + R"(, "ask": )" + report_ask +
         R"(, "feedback": ")" + level + R"("})";
}

inline std::string answers_to(const std::string& exercise, const std::string& answers) {
  return R"({"schema": "blossom.answers/1", "exercise": ")" + exercise + R"(", "answers": )" + answers + "}";
}

// Right, a slip, and nothing.
inline const char* const mixed_answers = R"({"P[1][0]": [1, 2], "P[1][1]": [-3, 2]})";
inline const char* const right_answers = R"({"P[1][0]": [1, 2], "P[1][1]": [3, 2], "C": [2, 2]})";

// Two exercises worth 10 and 5 points, due on 1 October, 20 % a day.
inline Examiner examiner_of_two(const test::Scratch& folder, const std::string& level = "full",
                                const std::string& title = "Homework") {
  folder.write("one.json", report_exercise(level, "one", "First curve"));
  folder.write("two.json", report_exercise(level, "two", "Second curve"));
  const auto path = folder.write("assignment.json", R"({"schema": "blossom.assignment/1", "id": "hw", "title": )" +
                                                        json_quote(title) + R"(, "lms_id": "4711",
          "exercises": [{"file": "one.json", "points": 10}, {"file": "two.json", "points": 5}],
          "due": "2026-10-01T00:00:00Z", "late": {"per_day": "1/5", "at_most_days": 4}})");
  auto assignment = load_assignment(path);
  INFO(to_string(assignment.diagnostics));
  REQUIRE(assignment);
  return Examiner(std::move(*assignment), {}, *parse_time("2026-10-09T00:00:00Z"));
}

inline Student ada() {
  Student student;
  student.id = "s17";
  student.name = "Lovelace, Ada";
  student.login = "ada";
  student.sis_id = "0017";
  student.lms_id = "903";
  student.email = "ada@example.edu";
  student.section = "CS3621-01";
  return student;
}

}  // namespace blossom
