// What holds for every output format, and the two that are for reading and for programs: text and json.

#include "grader/report_helpers.hpp"

using namespace blossom;
using blossom::test::Scratch;

namespace {

std::size_t times(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
  return count;
}

std::vector<StudentResult> class_of(Examiner& examiner, const std::vector<std::pair<std::string, std::string>>& who) {
  std::vector<StudentResult> results;
  for (const auto& [student, answers] : who) results.push_back(result_of(examiner, student, answers));
  return results;
}

}  // namespace

TEST_CASE("each file of the folder is a format, found by its name") {
  REQUIRE(report_formats().size() >= 10);
  for (const ReportFormat* known : report_formats()) {
    INFO(known->name);
    CHECK_FALSE(known->description.empty());
    CHECK_FALSE(known->extension.empty());
    CHECK(find_report_format(known->name) == known);
  }
  CHECK(find_report_format("xls") == nullptr);
}

TEST_CASE("what a format writes for a student depends on that student alone") {
  const Scratch folder;
  Examiner examiner = examiner_of_two(folder);
  std::vector<StudentResult> results;
  for (const char* id : {"a", "b", "c"}) {
    Student student;
    student.id = id;
    results.push_back(grade_student(examiner, student,
                                    {submission(answers_to("one", mixed_answers), "x.json", "2026-10-02T12:00:00Z"),
                                     submission(answers_to("two", id[0] == 'b' ? "{}" : right_answers), "y.json")}));
  }
  for (const ReportFormat* known : report_formats()) {
    INFO(known->name);
    const ReportContext context{&examiner.assignment(), 3, true};
    const auto in_order = known->open(context), backwards = known->open(context);
    std::vector<std::string> first(3), second(3);
    for (std::size_t i = 0; i < 3; ++i) in_order->add(results[i], first[i]);
    for (std::size_t i = 3; i-- > 0;) backwards->add(results[i], second[i]);
    CHECK(first == second);
    CHECK_FALSE(first[0].empty());
  }
}

TEST_CASE("what a level of feedback hides is in no file for students") {
  // C is missing; right would be (2, 2) by the rule (1 - u) P[1][0] + u P[1][1].
  const std::vector<std::string> solution{"(2, 2)", "1/2 (1, 2)"};
  for (const ReportFormat* known : report_formats()) {
    if (known->name == "json") continue;  // for whoever grades
    for (const std::string level : {"none", "verdict", "hint", "full"}) {
      Examiner examiner = examiner_of(report_exercise(level));
      const std::string out = report(*known, {result_of(examiner, "ann", answers_text(mixed_answers))});
      INFO(known->name << " at " << level << "\n" << out);
      const auto has = [&](const std::string& what) { return out.find(what) != std::string::npos; };
      const bool tells_parts = known->name != "canvas" && known->name != "nbgrader" && known->name != "html";
      if (level == "none") {
        CHECK_FALSE(has("slip"));
        CHECK_FALSE(has("P[1][1]"));
      } else if (tells_parts) {
        CHECK(has("slip"));
        CHECK(has("P[1][1]"));
      }
      if (level == "none" || level == "verdict") {
        CHECK_FALSE(has("The sign of x is wrong"));
      } else if (tells_parts) {
        CHECK(has("The sign of x is wrong."));
      }
      if (level != "full")
        for (const auto& right : solution) CHECK_FALSE(has(right));
      else if (tells_parts)
        CHECK(has("(2, 2)"));
    }
  }
}

TEST_CASE("nothing that a student or a learning platform names gets out of its place in a file") {
  const std::string evil = "=cmd|' /C calc'!A0<script>alert(1)</script>\"'&\x1b[2J\xEF\xBF\xBF\n";
  Examiner examiner = examiner_of(report_exercise("full"));
  Student student;
  student.id = student.name = student.email = student.section = student.login = evil;
  const StudentResult result = grade_student(
      examiner, student,
      {submission(answers_text(R"({"P[1][0]": "<script>alert(2)</script>", "<script>alert(3)</script>": 1})"), evil)});
  for (const ReportFormat* known : report_formats()) {
    const std::string out = report(*known, {result});
    INFO(known->name << "\n" << out);
    CHECK(out.find('\x1b') == std::string::npos);
    const std::string markup = known->name == "moodle" ? rows_of(out)[1].back() : out;  // the feedback
    if (known->extension == "html" || known->extension == "xml" || known->name == "moodle")
      for (const auto* n : {"1", "2", "3"}) CHECK(markup.find("<script>alert(" + std::string(n)) == std::string::npos);
    if (known->extension != "csv") continue;
    for (const auto& row : rows_of(out))
      for (const std::string& cell : row) {
        INFO(cell);
        const std::size_t first = cell.find_first_not_of(' ');
        const bool number = Exact::parse(cell).has_value();
        CHECK((number || cell == "-" || first == std::string::npos ||
               std::string("=+-@\t\r").find(cell[first]) == std::string::npos));
      }
  }
}

TEST_CASE("a grade as JSON has just the members of its schema") {
  Examiner examiner = examiner_of(report_exercise("verdict"));
  const std::string out = report(format("json"), {result_of(examiner, "ann", answers_text(mixed_answers))});
  const JsonDocument grade = json_of(out);
  CHECK(text(grade.root(), "schema") == "blossom.grade/1");
  CHECK(text(grade.root(), "exercise") == "test");
  CHECK(text(grade.root(), "student") == "ann");
  CHECK(number(grade.root(), "score") == 0.4);
  CHECK(number(grade.root(), "points") == 1);
  CHECK(number(grade.root(), "max_points") == 2.5);
  std::vector<std::string> parts;
  for (const Json& part : member(grade.root(), "parts", Json::Kind::array).items) {
    CHECK(text(part, "feedback").empty());
    parts.push_back(text(part, "value") + " " + text(part, "verdict") + " " + part.find("points")->text + "/" +
                    part.find("max_points")->text);
  }
  CHECK(parts == std::vector<std::string>{"P[1][0] correct 1/1", "P[1][1] slip 0/1", "C missing 0/0.5"});
  CHECK(
      report(format("json"), {result_of(examiner, "", "oops")}) ==
      R"({"schema":"blossom.grade/1","exercise":"test","score":0,"points":0,"max_points":2.5,"parts":[)"
      R"({"value":"P[1][0]","verdict":"invalid","points":0,"max_points":1,"feedback":""},)"
      R"({"value":"P[1][1]","verdict":"invalid","points":0,"max_points":1,"feedback":""},)"
      R"({"value":"C","verdict":"invalid","points":0,"max_points":0.5,"feedback":""}],)"
      R"("reason":"line 1, column 1: unexpected \"oops\"; expected a value: a number, a \"string\", [...], {...}, true, false or null"})"
      "\n");
}

TEST_CASE("several grades are one JSON object per line, in the order given") {
  Examiner examiner = examiner_of(report_exercise("full"));
  const std::string out = report(
      format("json"), class_of(examiner, {{"b", answers_text("{}")}, {"a", "["}, {"c", answers_text(right_answers)}}));
  std::vector<std::string> students;
  for (std::size_t at = 0, end = 0; (end = out.find('\n', at)) != std::string::npos; at = end + 1)
    students.push_back(text(json_of(out.substr(at, end - at)).root(), "student"));
  CHECK(students == std::vector<std::string>{"b", "a", "c"});
}

TEST_CASE("grades as text: a block for each student, then a table of scores") {
  Examiner examiner = examiner_of(report_exercise("hint"));
  CHECK(
      report(format("text"), class_of(examiner, {{"ann", answers_text(right_answers)},
                                                 {"Zo\u00eb", answers_text(R"({"P[1][0]": [2, 1], "C": "x", "k": 1})")},
                                                 {"max", "?"}})) ==
      "ann: 100 % (2.5/2.5 points) in test\n"
      "  P[1][0]  correct      1/1\n"
      "  P[1][1]  correct      1/1\n"
      "  C        correct  0.5/0.5\n"
      "\n"
      "Zo\u00eb: 0 % (0/2.5 points) in test\n"
      "  P[1][0]  slip       0/1  typed (2, 1)\n"
      "      Two numbers are exchanged: x and y.\n"
      "  P[1][1]  missing    0/1\n"
      "      No answer. The rule is P[1][1] = (1 - u) P[0][1] + u P[0][2].\n"
      "  C        invalid  0/0.5  typed x\n"
      "      The answer cannot be read: it must be an array of 2 numbers such as [1, \"2/5\"], not the text \"x\".\n"
      "  Note: \"k\" is not asked and was ignored.\n"
      "\n"
      "max: 0 % (0/2.5 points) in test\n"
      "  Invalid: line 1, column 1: unexpected \"?\"; expected a value: a number, a \"string\", [...], {...}, true, "
      "false or null.\n"
      "\n"
      "name  score   points  correct  carried  misconception  slip  wrong  missing  invalid\n"
      "ann   100 %  2.5/2.5        3        .              .     .      .        .        .\n"
      "Zo\u00eb     0 %    0/2.5        .        .              .     1      .        1        1\n"
      "max     0 %    0/2.5        .        .              .     .      .        .        3\n");
}

TEST_CASE("of an assignment the text has a block for each exercise, in its points, and what happened") {
  const Scratch folder;
  Examiner examiner = examiner_of_two(folder, "verdict");
  Student student;
  student.id = "ann";
  CHECK(
      report(format("text"),
             {grade_student(examiner, student,
                            {submission(answers_to("one", mixed_answers), "a.json", "2026-10-02T12:00:00Z"),
                             submission(answers_to("three", "{}"), "b.json")})}) ==
      "ann: 24 % (2.4/10 points) in one\n"
      "  P[1][0]  correct  4/4\n"
      "  P[1][1]  slip     0/4  typed (-3, 2)\n"
      "  C        missing  0/2\n"
      "  Late (a.json): 2 days late, handed in at 2026-10-02T12:00:00Z and due at 2026-10-01T00:00:00Z; it costs 40 % "
      "of the points.\n"
      "\n"
      "ann: 0 % (0/5 points) in two\n"
      "  Missing: nothing was handed in.\n"
      "\n"
      "ann: 16 % (2.4/15 points) in all\n"
      "  Not part of this assignment (b.json): \"three\" is no exercise of this assignment, which has "
      "\"one\", \"two\".\n"
      "\n");
}

TEST_CASE("advice on a misconception is given once to a student, and named where it applies again") {
  Examiner examiner = examiner_of(
      exercise_text("de_casteljau", R"({"curve": {"degree": 2, "points": [[0, 0], [4, 4], [8, 0]]}, "u": "1/4"})",
                    R"([{"value": "P[1][*]", "points": 1}])"));
  const std::string swapped = answers_text(R"({"P[1][0]": [3, 3], "P[1][1]": [7, 1]})");
  const std::string out = report(format("text"), class_of(examiner, {{"ann", swapped}, {"bob", swapped}}));
  const std::string advice = "at u = 0 the result is the first point";
  INFO(out);
  CHECK(times(out, advice) == 2);  // once to each
  CHECK(times(out, "      As above: the weights are swapped. Right is P[1][1] = ") == 2);
  CHECK(times(report(format("json"), class_of(examiner, {{"ann", swapped}})), advice) == 2);  // each part stands alone
}

TEST_CASE("without feedback only scores are written") {
  Examiner examiner = examiner_of(report_exercise("none"));
  CHECK(report(format("text"), class_of(examiner, {{"ann", answers_text("{}")}})) ==
        "ann: 0 % (0/2.5 points) in test\n\n");
}

TEST_CASE("the right value of a rule that is said in words comes before the words") {
  const auto solution = [](const char* algorithm, const char* inputs, const std::string& value) {
    const auto grader = grader_of(
        exercise_text(algorithm, inputs, R"([{"value": ")" + value + R"(", "points": 1}])", R"(, "feedback": "full")"));
    return part(grade_answers(*grader, "{}"), value).feedback;
  };
  CHECK(solution("de_boor", de_boor_inputs, "k") ==
        "No answer. Right is k = 4, the index k of the span of U that holds u.");
  CHECK(solution("de_boor", de_boor_inputs, "s") == "No answer. Right is s = 0, how many knots of U equal u.");
  // Symbols come first, and nothing twice.
  CHECK(solution("de_casteljau", report_inputs, "C") == "No answer. Right is C = P[2][0] = (2, 2).");
  CHECK(solution("de_casteljau", report_inputs, "P[1][0]") ==
        "No answer. Right is P[1][0] = (1 - u) P[0][0] + u P[0][1] = (1 - 1/2) (0, 0) + 1/2 (2, 4) = (1, 2).");
}
