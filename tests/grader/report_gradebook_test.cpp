// Gradebooks: what Canvas, Moodle and scripts for nbgrader read, against what their importers do.

#include <regex>

#include "grader/report_helpers.hpp"

using namespace blossom;
using blossom::test::Scratch;

namespace {

StudentResult late_result(Examiner& examiner) {
  return grade_student(examiner, ada(),
                       {submission(answers_to("one", right_answers), "one.json", "2026-10-01T12:00:00Z"),
                        submission(answers_to("two", mixed_answers), "two.json", "2026-09-30T12:00:00Z")});
}

// Canvas reads a pure number, whatever its separators, and leaves all else as it is.
std::optional<double> canvas_number(const std::string& cell) {
  if (!std::regex_match(cell, std::regex("-?[0-9.,]+%?"))) return std::nullopt;
  return std::stod(cell);
}

}  // namespace

TEST_CASE("Canvas: header, points possible, and a row that its importer finds the student by") {
  const Scratch folder;
  Examiner examiner = examiner_of_two(folder, "full", "Curves, part 1");
  Student nobody = ada();
  nobody.id = nobody.login = "s18";
  nobody.name = "Points Possible";
  const auto rows = rows_of(report(format("canvas"), {late_result(examiner), grade_student(examiner, nobody, {})}));
  REQUIRE(rows.size() == 4);
  for (const auto& row : rows) CHECK(row.size() == rows[0].size());
  // GradebookImporter#row_has_student_headers?, #update_column_count, #last_student_info_column
  CHECK(rows[0][0].find("Student") != std::string::npos);
  CHECK(rows[0][1].find("ID") != std::string::npos);
  CHECK(std::regex_search(rows[0][2], std::regex("SIS\\s+User\\s+ID")));
  CHECK(std::regex_search(rows[0][3], std::regex("SIS\\s+Login\\s+ID")));
  CHECK(rows[0][4].find("Section") != std::string::npos);
  // Assignment.title_and_id
  CHECK(rows[0][5] == "Curves, part 1 (4711)");
  // #check_for_non_student_row: that row, and no other
  CHECK(rows[1][0] == "    Points Possible");
  for (std::size_t i = 2; i < rows.size(); ++i) CHECK(rows[i][0].find("Points Possible") == std::string::npos);
  CHECK(canvas_number(rows[1][5]) == 15);
  CHECK(rows[2] == std::vector<std::string>{"Lovelace, Ada", "903", "0017", "ada", "CS3621-01", "10"});  // 8 + 2
  // Who handed in nothing has no grade, rather than a 0.
  CHECK(rows[3][0] == "s18");
  CHECK(rows[3][5].empty());
}

TEST_CASE("Canvas: the number of a participant in Moodle is nobody's ID") {
  Examiner examiner = examiner_of(report_exercise("full"));
  Student student = ada();
  student.is_participant = true;
  const auto rows = rows_of(report(format("canvas"), {grade_student(examiner, student, {})}));
  CHECK(rows[2][1].empty());
  CHECK(rows[2][2] == "0017");
}

TEST_CASE("Moodle: feedback has no code words") {
  Examiner examiner = examiner_of(report_exercise("full"));
  const std::string text = R"({"schema": "blossom.answers/1", "exercise": "test", "student": "s99", "answers": {}})";
  const auto rows =
      rows_of(report(format("moodle"), {grade_student(examiner, ada(), {submission(text, "circle.json")})}));
  CHECK(rows[1].back().find("oreign-id") == std::string::npos);
  CHECK(rows[1].back().find("Another name in the file (circle.json)") != std::string::npos);
}

TEST_CASE("Canvas: fractions are decimals with a point") {
  Examiner examiner = examiner_of(report_exercise("full"));
  Student student;
  student.id = "s17";
  const auto rows = rows_of(
      report(format("canvas"), {grade_student(examiner, student, {submission(answers_text(R"({"C": [2, 2]})"))})}));
  REQUIRE(rows.size() == 3);
  CHECK(rows[0][5] == "T");  // no number of its own: Canvas looks for the title
  CHECK(rows[2] == std::vector<std::string>{"s17", "", "s17", "", "", "0.5"});
}

TEST_CASE("Moodle: the columns its importer wants, participants, grades and feedback as HTML") {
  const Scratch folder;
  Examiner examiner = examiner_of_two(folder, "hint");
  Student nobody = ada();
  nobody.lms_id = "Participant 12";
  const auto rows = rows_of(report(format("moodle"), {late_result(examiner), grade_student(examiner, nobody, {})}));
  REQUIRE(rows.size() == 3);
  const auto column = [&](const std::string& heading) {
    const auto found = std::ranges::find(rows[0], heading);
    INFO(heading);
    REQUIRE(found != rows[0].end());
    return static_cast<std::size_t>(found - rows[0].begin());
  };
  // assignfeedback_offline_grade_importer#init; a feedback column at index 0 would count as absent.
  const std::size_t id = column("Identifier"), grade = column("Grade"), modified = column("Last modified (grade)"),
                    feedback = column("Feedback comments");
  CHECK(feedback > 0);
  for (const auto& row : rows) CHECK(row.size() == rows[0].size());
  // #next: the number behind "Participant "
  CHECK(rows[1][id].substr(std::string("Participant ").size()) == "903");
  CHECK(rows[2][id].substr(std::string("Participant ").size()) == "12");
  CHECK(std::stod(rows[1][grade]) == 10);
  CHECK(std::stod(rows[1][grade]) <= std::stod(rows[1][column("Maximum Grade")]));
  CHECK(rows[2][grade].empty());  // leaves the grade as it is
  CHECK(rows[1][modified] == "-");
  CHECK(rows[1][feedback].starts_with("<p><strong>First curve</strong>: 8 of 10 points</p>"));
  CHECK(rows[1][feedback].find("<li>P[1][1]: slip. ") != std::string::npos);
  CHECK(rows[1][feedback].find("it costs 20 % of the points") != std::string::npos);
}

TEST_CASE("nbgrader: its columns, raw score, penalty, score, and dates in UTC") {
  const Scratch folder;
  Examiner examiner = examiner_of_two(folder);
  Student nobody;
  nobody.id = "s18";
  nobody.name = "Plato";
  Student extended = ada();
  extended.due = parse_time("2026-10-02T02:00:00+02:00");
  const StudentResult in_time = grade_student(
      examiner, extended, {submission(answers_to("one", right_answers), "one.json", "2026-10-01T12:00:00Z")});
  const auto rows =
      rows_of(report(format("nbgrader"), {late_result(examiner), grade_student(examiner, nobody, {}), in_time}));
  REQUIRE(rows.size() == 4);
  CHECK(rows[0] == std::vector<std::string>{"assignment", "duedate", "timestamp", "student_id", "last_name",
                                            "first_name", "email", "raw_score", "late_submission_penalty", "score",
                                            "max_score"});
  CHECK(rows[1] == std::vector<std::string>{"hw", "2026-10-01 00:00:00", "2026-10-01 12:00:00", "s17", "Lovelace",
                                            "Ada", "ada@example.edu", "12", "2", "10", "15"});
  CHECK(rows[2] ==
        std::vector<std::string>{"hw", "2026-10-01 00:00:00", "", "s18", "Plato", "", "", "0", "0", "0", "15"});
  CHECK(rows[3][1] == "2026-10-02 00:00:00");
  CHECK(rows[3][8] == "0");
}
