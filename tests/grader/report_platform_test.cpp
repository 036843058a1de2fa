// Documents for the systems that show a student's result, against what those systems take.

#include <cmath>
#include <regex>

#include "base/utf8.hpp"
#include "grader/report_helpers.hpp"

using namespace blossom;
using blossom::test::Scratch;

namespace {

using Kind = Json::Kind;

void has_only(const Json& object, const std::vector<std::string>& allowed) {
  REQUIRE(object.kind == Kind::object);
  for (const std::string& key : object.keys) {
    INFO(key);
    CHECK(std::ranges::find(allowed, key) != allowed.end());
  }
}

void is_one_of(const Json& object, const std::string& key, const std::vector<std::string>& allowed) {
  if (object.find(key) == nullptr) return;
  const std::string& word = text(object, key);
  INFO(key << ": " << word);
  CHECK(std::ranges::find(allowed, word) != allowed.end());
}

// Gradescope's "Autograder Specifications": which members there are, which words they take, and that there is a score.
void check_gradescope(const Json& root) {
  const std::vector<std::string> visibility{"hidden", "after_due_date", "after_published", "visible"},
      formats{"text", "html", "simple_format", "md", "ansi"};
  has_only(root, {"score", "execution_time", "output", "output_format", "test_output_format", "test_name_format",
                  "visibility", "stdout_visibility", "extra_data", "tests", "leaderboard"});
  CHECK(std::isfinite(number(root, "score")));
  is_one_of(root, "visibility", visibility);
  is_one_of(root, "stdout_visibility", visibility);
  for (const char* key : {"output_format", "test_output_format", "test_name_format"}) is_one_of(root, key, formats);
  for (const Json& test : member(root, "tests", Kind::array).items) {
    has_only(test, {"score", "max_score", "status", "name", "name_format", "number", "output", "output_format", "tags",
                    "visibility", "extra_data"});
    CHECK(number(test, "score") <= number(test, "max_score"));
    is_one_of(test, "status", {"passed", "failed"});
    is_one_of(test, "visibility", visibility);
    text(test, "name");
  }
}

// PrairieLearn's "Grading results" and its processGradingResult.
void check_prairielearn(const std::string& document) {
  CHECK(document.size() <= 1u << 20);
  const JsonDocument read = json_of(document);
  const Json& root = read.root();
  if (!member(root, "gradable", Kind::boolean).boolean) {
    has_only(root, {"gradable", "format_errors"});
    CHECK_FALSE(member(root, "format_errors", Kind::array).items.empty());
    for (const Json& error : root.find("format_errors")->items) CHECK(error.kind == Kind::string);
    return;
  }
  has_only(root, {"gradable", "score", "message", "output", "tests"});
  CHECK(number(root, "score") >= 0);
  CHECK(number(root, "score") <= 1);
  for (const Json& test : member(root, "tests", Kind::array).items) {
    has_only(test, {"name", "description", "points", "max_points", "message", "output"});
    number(test, "points");  // without them no test's points are shown
    number(test, "max_points");
  }
}

// Autolab: the last line, with every word: in quotation marks, is parsed.
JsonDocument autolab_scores(const std::string& out) {
  const std::string text = out.substr(0, out.find_last_not_of("\r\n ") + 1);
  const std::string last = text.substr(text.rfind('\n') + 1);
  return json_of(std::regex_replace(last, std::regex("([a-zA-Z0-9]+):"), "\"$1\":"));
}

// Enough of XML 1.0 for one that has no comments, no CDATA and no DTD: the names of the elements in order, or why not.
struct Xml {
  struct Element {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string text;
  };
  std::vector<Element> elements;
  std::string problem;

  explicit Xml(const std::string& xml) {
    static const std::regex tag("<(/?)([a-z-]+)((?: [a-z]+=\"[^<>\"]*\")*)(/?)>"), pair(" ([a-z]+)=\"([^\"]*)\""),
        reference("&(?!(?:amp|lt|gt|quot|apos|#39|#x27|#34);)");
    std::vector<std::size_t> open;
    const std::string declaration = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    if (!xml.starts_with(declaration)) problem = "no declaration";
    std::size_t at = declaration.size();
    while (problem.empty() && at < xml.size()) {
      const std::size_t next = std::min(xml.find('<', at), xml.size());
      if (!open.empty()) elements[open.back()].text += xml.substr(at, next - at);
      if (next == xml.size()) break;
      std::smatch found;
      const std::string rest = xml.substr(next, xml.find('>', next) - next + 1);
      if (!std::regex_match(rest, found, tag)) {
        problem = "no tag: " + rest;
      } else if (found[1] == "/") {
        if (open.empty() || elements[open.back()].name != found[2])
          problem = "closes what is not open: " + rest;
        else
          open.pop_back();
      } else {
        Element element{found[2], {}, {}};
        const std::string attributes = found[3];
        for (std::sregex_iterator each(attributes.begin(), attributes.end(), pair), end; each != end; ++each)
          element.attributes[(*each)[1]] = (*each)[2];
        elements.push_back(std::move(element));
        if (found[4] != "/") open.push_back(elements.size() - 1);
      }
      at = next + rest.size();
    }
    if (problem.empty() && !open.empty()) problem = "never closed";
    if (problem.empty() && std::regex_search(xml, reference)) problem = "an & that is no reference";
    for (std::size_t i = 0; problem.empty() && i < xml.size();) {
      const std::size_t length = utf8_length(xml, i);
      const std::string c = xml.substr(i, length);
      if (length == 0 || (length == 1 && c[0] < 0x20 && c[0] != '\n' && c[0] != '\t' && c[0] != '\r') ||
          c == "\xEF\xBF\xBE" || c == "\xEF\xBF\xBF")
        problem = "a character that XML forbids";
      i += std::max<std::size_t>(length, 1);
    }
  }
};

StudentResult result_of_two(Examiner& examiner) {
  return grade_student(examiner, ada(),
                       {submission(answers_to("one", mixed_answers), "one.json", "2026-10-01T12:00:00Z")});
}

}  // namespace

TEST_CASE("Gradescope: results.json by its specification, the score after lateness") {
  const Scratch folder;
  for (const std::string level : {"none", "verdict", "hint", "full"}) {
    Examiner examiner = examiner_of_two(folder, level);
    const std::string out = report(format("gradescope"), {result_of_two(examiner)});
    INFO(out);
    const JsonDocument document = json_of(out);
    const Json& root = document.root();
    check_gradescope(root);
    CHECK(root.find("execution_time") == nullptr);  // the same bytes each time
    CHECK(text(root, "stdout_visibility") == "hidden");
    CHECK(number(root, "score") == Approx(3.2));  // 4 of 10, less 20 %
    CHECK(text(root, "output").find("1 day late") != std::string::npos);
    double points = 0, most = 0;
    bool any_status = false;
    for (const Json& test : root.find("tests")->items) {
      points += number(test, "score");
      most += number(test, "max_score");
      any_status = any_status || test.find("status") != nullptr;
    }
    CHECK(points == Approx(4));
    CHECK(most == Approx(15));
    CHECK(any_status == (level != "none"));
  }
}

TEST_CASE("Gradescope: passed is correct or carried, an unreadable file says why") {
  Examiner examiner = examiner_of(report_exercise("verdict"));
  const JsonDocument document = json_of(
      report(format("gradescope"),
             {result_of(examiner, "s17", answers_text(R"({"P[1][0]": [1, 3], "P[1][1]": [3, 2], "C": [2, "5/2"]})"))}));
  std::vector<std::string> status;
  for (const Json& test : document.root().find("tests")->items)
    status.push_back(text(test, "output") + " " + text(test, "status"));
  CHECK(status == std::vector<std::string>{"wrong failed", "correct passed", "carried passed"});

  const JsonDocument unreadable = json_of(report(format("gradescope"), {result_of(examiner, "s17", "oops")}));
  check_gradescope(unreadable.root());
  CHECK(number(unreadable.root(), "score") == 0);
  CHECK(text(unreadable.root(), "output").find("Invalid: line 1, column 1: unexpected \"oops\"") != std::string::npos);
}

TEST_CASE("PrairieLearn: results.json by its documentation") {
  const Scratch folder;
  for (const std::string level : {"none", "verdict", "hint", "full"}) {
    Examiner examiner = examiner_of_two(folder, level);
    const std::string out = report(format("prairielearn"), {result_of_two(examiner)});
    INFO(out);
    check_prairielearn(out);
    const JsonDocument document = json_of(out);
    CHECK(number(document.root(), "score") == Approx(3.2 / 15));
  }
}

TEST_CASE("PrairieLearn: what cannot be read is not gradable, and says why; nothing handed in, too") {
  Examiner examiner = examiner_of(report_exercise("full"));
  for (const std::string answers : {"oops", "", "[]", "{\"schema\": \"blossom.answers/1\"}"}) {
    const std::string out = report(format("prairielearn"), {result_of(examiner, "s17", answers)});
    INFO(out);
    check_prairielearn(out);
    CHECK(out.starts_with(R"({"gradable":false,"format_errors":["Invalid: )"));
  }
  Student student;
  student.id = "s17";
  const std::string missing = report(format("prairielearn"), {grade_student(examiner, student, {})});
  check_prairielearn(missing);
  CHECK(missing == "{\"gradable\":false,\"format_errors\":[\"Missing: nothing was handed in.\"]}\n");
}

TEST_CASE("PrairieLearn: above 1 MiB feedback is cut, never scores or names") {
  std::string ask, answers;
  for (int i = 0; i < 24; ++i) {
    const std::string name = "P[1][" + std::to_string(i) + "]";
    std::string words;
    while (words.size() < 100'000) words += "\u00fc" + std::to_string(i) + "\\\" ";
    ask +=
        (i > 0 ? ", " : "") + (R"({"value": ")" + name + R"(", "points": 1, "feedback": )" + json_quote(words) + "}");
    answers += (i > 0 ? ", " : "") + ("\"" + name + "\": [" + (i == 0 ? "\"1/2\"" : "77") + ", 1]");
  }
  std::string points;
  for (int i = 0; i < 25; ++i)
    points += (i > 0 ? ", [" : "[") + std::to_string(i) + ", " + std::to_string(i % 2 + 1 - (i < 2 ? i : 0)) + "]";
  Examiner examiner = examiner_of(
      exercise_text("de_casteljau", R"({"curve": {"degree": 24, "points": [)" + points + R"(]}, "u": "1/2"})",
                    "[" + ask + "]", R"(, "feedback": "hint")"));
  const std::string out =
      report(format("prairielearn"), {result_of(examiner, "s17", answers_text("{" + answers + "}"))});
  check_prairielearn(out);
  CHECK(out.size() > 1u << 18);  // as much as fits
  const JsonDocument document = json_of(out);
  const auto& tests = document.root().find("tests")->items;
  REQUIRE(tests.size() == 24);
  double earned = 0;
  for (const Json& test : tests) earned += number(test, "points");
  CHECK(earned == Approx(number(document.root(), "score") * 24));
  CHECK(text(tests[23], "output").ends_with("(cut: PrairieLearn takes 1 MiB at most)"));
}

TEST_CASE("Autolab: the last line has a score for each problem, and survives the quotation marks put into it") {
  const Scratch folder;
  Examiner examiner = examiner_of_two(folder, "full", "word: \"other:\"");
  const std::string out =
      report(format("autolab"), {grade_student(examiner, ada(),
                                               {submission(answers_to("one", mixed_answers), "scores: {a:1}\n.json"),
                                                submission(answers_to("two", right_answers), "two.json")})});
  INFO(out);
  const JsonDocument autoresult = autolab_scores(out);
  const Json& scores = member(autoresult.root(), "scores", Kind::object);
  CHECK(scores.keys == std::vector<std::string>{"one", "two"});  // names of problems
  CHECK(number(scores, "one") == 4);
  CHECK(number(scores, "two") == 5);
  std::vector<std::string> scoreboard;
  for (const Json& column : member(autoresult.root(), "scoreboard", Kind::array).items)
    scoreboard.push_back(column.text);
  CHECK(scoreboard == std::vector<std::string>{"9", "4", "5"});
  CHECK(out.find("s17: 40 % (4/10 points) in one\n") == 0);  // before it, what the student reads
}

TEST_CASE("JUnit XML: well-formed, with the members that its readers need, whatever stands in names and answers") {
  const Scratch folder;
  Examiner examiner = examiner_of_two(folder, "full", "a < b & \"c\"");
  Student odd;
  odd.id = "<&>\"'\x01\x1b[0m \xEF\xBF\xBF \xEF\xBF\xBE \xff ]]> \u2028 \U0001F600";
  const std::string out =
      report(format("junit"),
             {result_of_two(examiner),
              grade_student(examiner, odd,
                            {submission(answers_to("one", R"({"C": "<&>\u0000\uffff\u001b"})"), "]]>&<.json")})});
  INFO(out);
  const Xml xml(out);
  REQUIRE(xml.problem.empty());
  REQUIRE(xml.elements[0].name == "testsuites");
  // junit-10.xsd: the attributes that a suite and a case must have; and that the counts are true
  std::size_t suites = 0, cases = 0, failures = 0, said_cases = 0, said_failures = 0;
  for (const auto& element : xml.elements) {
    if (element.name == "testsuite") {
      ++suites;
      for (const char* needed : {"name", "tests", "failures", "errors"}) CHECK(element.attributes.contains(needed));
      said_cases += std::stoul(element.attributes.at("tests"));
      said_failures += std::stoul(element.attributes.at("failures"));
    } else if (element.name == "testcase") {
      ++cases;
      CHECK(element.attributes.contains("name"));
      CHECK(element.attributes.contains("classname"));
    } else if (element.name == "failure") {
      ++failures;
      CHECK_FALSE(element.attributes.at("message").empty());
    }
  }
  CHECK(suites == 4);
  CHECK(cases == said_cases);
  CHECK(failures == said_failures);
  CHECK(cases == 8);     // three values, nothing handed in; twice
  CHECK(failures == 7);  // all but one
}

TEST_CASE("HTML: one document for the student, complete") {
  Examiner examiner = examiner_of(report_exercise("hint"));
  const std::string out = report(format("html"), {result_of(examiner, "s17", answers_text(mixed_answers))});
  CHECK(out.starts_with("<!"));
  CHECK(out.find("</html>") != std::string::npos);
  CHECK(format("html").scope == ReportFormat::Scope::student);
}
