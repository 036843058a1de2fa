#include "grader/helpers.hpp"

using namespace blossom;

namespace {

const ReportFormat& format(std::string_view name) {
  for (const ReportFormat* known : report_formats())
    if (known->name == name) return *known;
  FAIL("no such format");
  std::abort();
}

std::string report(const ReportFormat& format, const Grader& grader,
                   const std::vector<std::pair<std::string, std::string>>& class_) {
  const auto report = format.open(grader.exercise(), class_.size());
  std::string out;
  for (const auto& [student, answers] : class_)
    report->add(grader.grade(JsonDocument::parse(student, answers, submission_limits), student), out);
  report->finish(out);
  return out;
}

const char* const ask = R"([{"value": "P[1][*]", "points": 1}, {"value": "C", "points": "1/2"}])";
const char* const inputs = R"({"curve": {"degree": 2, "points": [[0, 0], [2, 4], [4, 0]]}, "u": "1/2"})";

}  // namespace

TEST_CASE("each file of the folder is a format") {
  REQUIRE(report_formats().size() >= 2);
  for (const ReportFormat* known : report_formats()) CHECK_FALSE(known->description.empty());
}

TEST_CASE("a grade as JSON has just the members of its schema") {
  const auto grader = grader_of(exercise_text("de_casteljau", inputs, ask, R"(, "feedback": "verdict")"));
  CHECK(
      report(format("json"), *grader, {{"ann", answers_text(R"({"P[1][0]": [1, 2], "P[1][1]": [-3, 2]})")}}) ==
      R"({"schema":"blossom.grade/1","exercise":"test","student":"ann","score":0.4,"points":1,"max_points":2.5,"parts":[)"
      R"({"value":"P[1][0]","verdict":"correct","points":1,"max_points":1,"feedback":""},)"
      R"({"value":"P[1][1]","verdict":"slip","points":0,"max_points":1,"feedback":""},)"
      R"({"value":"C","verdict":"missing","points":0,"max_points":0.5,"feedback":""}]})"
      "\n");
  CHECK(
      report(format("json"), *grader, {{"", "oops"}}) ==
      R"({"schema":"blossom.grade/1","exercise":"test","score":0,"points":0,"max_points":2.5,"parts":[)"
      R"({"value":"P[1][0]","verdict":"invalid","points":0,"max_points":1,"feedback":""},)"
      R"({"value":"P[1][1]","verdict":"invalid","points":0,"max_points":1,"feedback":""},)"
      R"({"value":"C","verdict":"invalid","points":0,"max_points":0.5,"feedback":""}],)"
      R"("reason":"line 1, column 1: unexpected \"oops\"; expected a value: a number, a \"string\", [...], {...}, true, false or null"})"
      "\n");
}

TEST_CASE("several grades are one JSON object per line, in the order given") {
  const auto grader = grader_of(exercise_text("de_casteljau", inputs, ask));
  const std::string out =
      report(format("json"), *grader, {{"b", answers_text("{}")}, {"a", "["}, {"c", all_answers(grader->exercise())}});
  std::vector<std::string> students;
  for (std::size_t at = 0, end = 0; (end = out.find('\n', at)) != std::string::npos; at = end + 1) {
    const auto line = JsonDocument::parse("line", out.substr(at, end - at));
    REQUIRE(line);
    students.push_back(line->root().find("student")->text);
  }
  CHECK(students == std::vector<std::string>{"b", "a", "c"});
}

TEST_CASE("grades as text: a block for each student, then a table of scores") {
  const auto grader = grader_of(exercise_text("de_casteljau", inputs, ask, R"(, "feedback": "hint")"));
  CHECK(report(format("text"), *grader,
               {{"ann", answers_text(all_answers(grader->exercise()))},
                {"Zo\u00eb", answers_text(R"({"P[1][0]": [2, 1], "C": "x", "k": 1})")},
                {"max", "?"}}) ==
        "ann: 100 % (2.5/2.5 points) in test\n"
        "  P[1][0]  correct      1/1\n"
        "  P[1][1]  correct      1/1\n"
        "  C        correct  0.5/0.5\n"
        "\n"
        "Zo\u00eb: 0 % (0/2.5 points) in test\n"
        "  P[1][0]  slip       0/1\n"
        "      Two numbers are exchanged: x and y.\n"
        "  P[1][1]  missing    0/1\n"
        "      No answer. The rule is P[1][1] = (1 - u) P[0][1] + u P[0][2].\n"
        "  C        invalid  0/0.5\n"
        "      The answer cannot be read: it must be an array of 2 numbers such as [1, \"2/5\"], not the text \"x\".\n"
        "  note: \"k\" is not asked and was ignored\n"
        "\n"
        "max: 0 % (0/2.5 points) in test\n"
        "  invalid: line 1, column 1: unexpected \"?\"; expected a value: a number, a \"string\", [...], {...}, true, "
        "false or null\n"
        "\n"
        "name  score   points  correct  carried  misconception  slip  wrong  missing  invalid\n"
        "ann   100 %  2.5/2.5        3        .              .     .      .        .        .\n"
        "Zo\u00eb     0 %    0/2.5        .        .              .     1      .        1        1\n"
        "max     0 %    0/2.5        .        .              .     .      .        .        3\n");
}

TEST_CASE("advice on a misconception is given once to a student, and named where it applies again") {
  const auto grader = grader_of(
      exercise_text("de_casteljau", R"({"curve": {"degree": 2, "points": [[0, 0], [4, 4], [8, 0]]}, "u": "1/4"})",
                    R"([{"value": "P[1][*]", "points": 1}])"));
  const std::string swapped = answers_text(R"({"P[1][0]": [3, 3], "P[1][1]": [7, 1]})");
  const std::string out = report(format("text"), *grader, {{"ann", swapped}, {"bob", swapped}});
  const auto times = [](const std::string& text, const std::string& what) {
    std::size_t count = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
    return count;
  };
  const std::string advice = "at u = 0 the result is the first point";
  INFO(out);
  CHECK(times(out, advice) == 2);  // once to each
  CHECK(times(out, "      As above: the weights are swapped. Right is P[1][1] = ") == 2);
  CHECK(times(report(format("json"), *grader, {{"ann", swapped}}), advice) == 2);  // each part stands alone there
}

TEST_CASE("without feedback only scores are written") {
  const auto grader = grader_of(exercise_text("de_casteljau", inputs, ask, R"(, "feedback": "none")"));
  CHECK(report(format("text"), *grader, {{"ann", answers_text("{}")}}) == "ann: 0 % (0/2.5 points) in test\n\n");
}
