// The page a student gets: what stands in it, what does not, and that nothing typed can change what it is.

#include <algorithm>
#include <regex>

#include "grader/page/student_page.hpp"
#include "helpers.hpp"
#include "trace/trace.hpp"

using namespace blossom;

namespace {

const char* const hostile = "</script><script>alert(\"1\")</script>'&\x01<!--";

Assignment assignment_of(const std::string& exercise, Feedback level) {
  auto document = JsonDocument::parse("exercise.json", exercise);
  INFO(to_string(document.diagnostics));
  REQUIRE(document);
  auto assignment = read_assignment(*document);
  INFO(to_string(assignment.diagnostics));
  REQUIRE(assignment);
  assignment->feedback = level;
  return std::move(*assignment);
}

struct Handed {
  std::string answers = {};  // an object; empty: nothing was handed in
  std::string text = {};     // instead: the whole file
  Student student = [] {
    Student ada;
    ada.id = "s17";
    ada.name = "Lovelace, Ada";
    return ada;
  }();
};

std::string page_of(const std::string& exercise, Feedback level, const Handed& handed) {
  Examiner examiner(assignment_of(exercise, level), "", *parse_time("2026-10-05T12:00:00Z"));
  std::vector<Submission> submissions;
  if (!handed.answers.empty() || !handed.text.empty()) {
    Submission submission;
    submission.source = "s17.json";
    submission.text = handed.text.empty() ? answers_text(handed.answers) : handed.text;
    submissions.push_back(std::move(submission));
  }
  return student_page(grade_student(examiner, handed.student, std::move(submissions)));
}

bool has(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

std::size_t count(const std::string& text, std::string_view part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// Numbers that appear nowhere by accident: no right value is a coordinate that is given, or of few digits.
const std::string exercise = exercise_text(
    "de_casteljau",
    R"({"curve": {"degree": 3, "points": [[1009, 2003], [3011, 5003], [7013, 11003], [13007, 17011]]}, "u": "3/7"})",
    R"([{"value": "P[1..2][*]", "points": 1}, {"value": "P[3][0]", "points": 2}])");

std::vector<std::string> right_texts(const Exercise& of) {
  std::vector<std::string> texts;
  for (const Part& part : of.parts)
    for (const Exact& x : part.right) {
      texts.push_back(x.to_string());
      // As a picture or a decimal would have it: its first five digits.
      texts.push_back(format_number(x.to_double()).substr(0, 6));
    }
  return texts;
}

// P[1][0] is right, P[1][1] is a digit off, P[2][0] follows from that, the others are not answered.
std::string some_answers(const Exercise& of) {
  const auto& right = of.parts[*of.part("P[1][0]")].right;
  return R"({"P[1][0]": [)" + json_quote(right[0].to_string()) + "," + json_quote(right[1].to_string()) +
         R"(], "P[1][1]": [4666, 7777], "P[2][0]": [1.5, 2.5]})";
}

}  // namespace

TEST_CASE("text in HTML is escaped, and what no page may hold is replaced", "[page]") {
  CHECK(html_escape("a < b && c > \"d\" 'e'") == "a &lt; b &amp;&amp; c &gt; &quot;d&quot; &#39;e&#39;");
  CHECK(html_escape("Bézier\nline\ttab") == "Bézier\nline\ttab");
  CHECK(html_escape(std::string("a\0b", 3)) ==
        "a\xEF\xBF\xBD"
        "b");
  CHECK(html_escape("\x1B[2J") == "\xEF\xBF\xBD[2J");
  CHECK(html_escape("\xC3") == "\xEF\xBF\xBD");
  CHECK(html_escape("\xED\xA0\x80") == "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");  // a lone surrogate
  CHECK(html_escape("\xE2\x80\xAE") == "\xEF\xBF\xBD");                          // turns the direction of what follows
}

TEST_CASE("a student's page needs nothing else and asks nobody", "[page]") {
  const auto grader = grader_of(exercise);
  const std::string page = page_of(exercise, Feedback::full, {some_answers(grader->exercise())});
  CHECK(page.starts_with("<!DOCTYPE html>\n<html lang=\"en\">"));
  CHECK(has(page,
            "content=\"default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:\""));
  CHECK(has(page, "<title>T – Lovelace, Ada (s17)</title>"));
  CHECK_FALSE(has(page, " src="));
  CHECK_FALSE(has(page, "<link"));
  CHECK_FALSE(has(page, "url("));
  CHECK_FALSE(has(page, "@import"));
  CHECK(count(page, "://") == count(page, "http://www.w3.org/2000/svg"));
}

TEST_CASE("at each level the page holds no right value but those that were typed", "[page]") {
  const auto grader = grader_of(exercise);
  const Exercise& of = grader->exercise();
  const std::string answers = some_answers(of);
  const Feedback level = GENERATE(Feedback::none, Feedback::verdict, Feedback::hint);
  const std::string page = page_of(exercise, level, {answers});
  CAPTURE(static_cast<int>(level), page);
  for (const Part& part : of.parts) {
    if (part.name == "P[1][0]") continue;
    for (const Exact& x : part.right) {
      CHECK_FALSE(has(page, x.to_string()));
      CHECK_FALSE(has(page, format_number(x.to_double()).substr(0, 6)));
    }
  }
  // The same search finds them where they are told: it can fail.
  const std::string full = page_of(exercise, Feedback::full, {answers});
  for (const std::string& text : right_texts(of))
    if (has(text, "/")) CHECK(has(full, text));
}

TEST_CASE("nor does one of a rational curve tell the weight that was not typed", "[page]") {
  const std::string rational = exercise_text(
      "de_casteljau",
      R"({"curve": {"degree": 2, "points": [[1009, 2003], [3011, 5003], [7013, 11003]], "weights": [1, 101, 13]},
          "u": "3/7"})",
      R"([{"value": "P[1][*]", "points": 1}, {"value": "C", "points": 1}])");
  const auto grader = grader_of(rational);
  const Exercise& of = grader->exercise();
  const auto& trace = of.run.trace;
  const std::string page = page_of(rational, Feedback::hint, {R"({"P[1][0]": [2950, 4900], "P[1][1]": [3100, 5200]})"});
  for (const Part& part : of.parts)
    for (const Exact& x : trace.numbers(part.value))
      if (!x.is_integer()) CHECK_FALSE(has(page, x.to_string()));
  CHECK(has(page, "(2950, 4900)"));
}

TEST_CASE("each level of feedback shows what it is for", "[page]") {
  const auto grader = grader_of(exercise);
  const std::string answers = some_answers(grader->exercise());
  const std::string none = page_of(exercise, Feedback::none, {answers});
  CHECK(has(none, "<strong>1</strong> of 7 points"));
  CHECK_FALSE(has(none, "class=\"parts\""));
  CHECK_FALSE(has(none, "4666"));

  const std::string verdict = page_of(exercise, Feedback::verdict, {answers});
  CHECK(has(verdict, "(4666, 7777)"));
  CHECK(has(verdict, "</span> Wrong</span>"));
  CHECK_FALSE(has(verdict, "What to know"));
  CHECK_FALSE(has(verdict, "class=\"run\""));
  CHECK_FALSE(has(verdict, "<script"));

  const std::string hint = page_of(exercise, Feedback::hint, {answers});
  CHECK(has(hint, "What to know"));
  CHECK(has(hint, "Your run, step by step"));
  CHECK_FALSE(has(hint, "data-side=\"right\""));

  const std::string full = page_of(exercise, Feedback::full, {answers});
  CHECK(has(full, "Your run beside the right one"));
  CHECK(has(full, "data-side=\"right\""));
  CHECK(has(full, "data-side=\"own\""));
}

TEST_CASE("what is right throughout, or was not handed in, has one run to show", "[page]") {
  const auto grader = grader_of(exercise);
  const std::string right = page_of(exercise, Feedback::full, {all_answers(grader->exercise())});
  CHECK(has(right, "The run, step by step"));
  CHECK_FALSE(has(right, "data-side=\"own\""));
  const std::string missing = page_of(exercise, Feedback::hint, {});
  CHECK(has(missing, "Nothing was handed in"));
  CHECK_FALSE(has(missing, "class=\"run\""));
}

TEST_CASE("what students type stays text", "[page]") {
  const std::string typed = R"({"P[1][0]": )" + json_quote(std::string("</script><script>alert(1)</script>'&<!--")) +
                            R"(, "P[1][1]": [["deep", [1]]], "</script><b>": 1})";
  Handed handed{typed};
  handed.student.name = hostile;
  handed.student.id = "s17\"><script>";
  handed.student.section = hostile;
  const std::string page = page_of(exercise, Feedback::full, handed);
  // Only the page's own scripts: the data and the player.
  CHECK(count(page, "<script") == 2);
  CHECK(count(page, "</script") == 2);
  CHECK_FALSE(has(page, "<b>"));
  CHECK_FALSE(has(page, "<!--"));
  CHECK_FALSE(has(page, "\x01"));
  CHECK(has(page, "&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;"));
  CHECK(has(page, "a list of more than numbers"));
}

TEST_CASE("a file that cannot be read makes a page that says so", "[page]") {
  Handed handed;
  handed.text = "{\"answers\": <script>";
  const Feedback level = GENERATE(Feedback::none, Feedback::verdict, Feedback::hint, Feedback::full);
  const std::string page = page_of(exercise, level, handed);
  CHECK(has(page, "Not readable: s17.json: "));
  CHECK_FALSE(has(page, "class=\"parts\""));
  CHECK_FALSE(has(page, "data-side=\"own\""));
  CHECK_FALSE(has(page, "<script>\""));
}

TEST_CASE("who handed in what cannot be read is not told that nothing was handed in", "[page]") {
  auto assignment = assignment_of(exercise, Feedback::hint);
  assignment.items.push_back(assignment_of(exercise, Feedback::hint).items[0]);
  assignment.items[1].exercise.id = "another";
  Examiner examiner(std::move(assignment), "", *parse_time("2026-10-05T12:00:00Z"));
  Submission submission;
  submission.source = "s17/first.json";
  submission.text = "{";
  Student student;
  student.id = "s17";
  student.section = "2";
  const std::string page = student_page(grade_student(examiner, student, {submission}));
  CHECK(has(page, "s17 · section 2<"));
  CHECK(has(page, "Not readable: first.json: "));
  CHECK(count(page, "Nothing that can be read was handed in") == 2);
  CHECK_FALSE(has(page, "Nothing was handed in"));
}

TEST_CASE("a page has its dates in one form, and the points here beside the exercise's own", "[page]") {
  auto assignment = assignment_of(exercise, Feedback::verdict);
  assignment.due = *parse_time("2026-10-01T23:59:00+02:00");
  assignment.offset = std::chrono::hours{2};
  assignment.full_feedback_from = *parse_time("2026-10-20T00:00:30Z");
  assignment.items[0].points = assignment.max_points = 21;
  Examiner examiner(std::move(assignment), "", *parse_time("2026-10-05T12:00:00Z"));
  std::vector<Submission> submissions(2);
  const auto grader = grader_of(exercise);
  for (std::size_t i = 0; i < 2; ++i) {
    submissions[i].source = "s17/try-" + std::to_string(i) + ".json";
    submissions[i].text = answers_text(some_answers(grader->exercise()));
    submissions[i].submitted = *parse_time(i == 0 ? "2026-10-01T08:00:00Z" : "2026-10-01T09:00:00Z");
  }
  Student student;
  student.id = "s17";
  const std::string page = student_page(grade_student(examiner, student, submissions));
  CHECK(has(page, "Due 2026-10-01 23:59 (UTC+02:00)"));
  CHECK(has(page, "The right values will be told from 2026-10-20 02:00:30 (UTC+02:00) on"));
  CHECK(has(page, "Handed in 2026-10-01 11:00 (UTC+02:00)."));
  CHECK(has(page, "Handed in more than once: try-0.json does not count; the last one does"));
  CHECK(has(page, "of 2026-10-01 11:00 (UTC+02:00)."));
  CHECK(has(page, "Together 1 of 7, which is 3 of 21 points here."));
}

TEST_CASE("below hints a kind of mistake is not named", "[page]") {
  // The weights exchanged: (1/3) (0, 0) + (2/3) (3, 9) = (2, 6).
  const std::string text =
      exercise_text("de_casteljau", R"({"curve": {"degree": 1, "points": [[0, 0], [3, 9]]}, "u": "1/3"})",
                    R"([{"value": "P[1][0]", "points": 1}])");
  for (const Feedback level : {Feedback::verdict, Feedback::hint}) {
    Examiner examiner(assignment_of(text, level), "", *parse_time("2026-10-05T12:00:00Z"));
    Submission submission;
    submission.text = answers_text(R"({"P[1][0]": [2, 6]})");
    Student student;
    student.id = "s17";
    const auto result = grade_student(examiner, student, {submission});
    REQUIRE(result.exercises[0].grade->parts[0].verdict == Verdict::misconception);
    CHECK(has(student_page(result), "</span> Wrong</span>"));
    CHECK_FALSE(has(student_page(result), "Misconception"));
    std::string theirs, instructors;
    write_json(result, Audience::student, theirs);
    write_json(result, Audience::instructor, instructors);
    CHECK(has(theirs, R"("verdict":"misconception")") == (level == Feedback::hint));
    CHECK(has(theirs, R"("verdict":"wrong")") == (level == Feedback::verdict));
    CHECK(has(instructors, R"("verdict":"misconception")"));
  }
}

TEST_CASE("a page on a lesson has its questions, what there was to choose from, and each scene's numbers", "[page]") {
  const std::string lesson = R"({"schema": "blossom.lesson/1", "id": "asked", "title": "Asked", "scenes": [
    {"id": "one", "title": "First", "algorithm": "de_casteljau",
     "inputs": {"curve": {"degree": 1, "points": [[0, 0], [31, 8]]}, "u": "1/4"},
     "beats": [{"at": "start", "say": "a", "checkpoint": {"id": "why", "kind": "choice",
       "ask": "Why is u = {u} **there**?", "choices": [{"text": "since < P[0][1]"}, {"text": "so", "right": true}]}}]},
    {"id": "two", "title": "Second", "algorithm": "de_casteljau",
     "inputs": {"curve": {"degree": 1, "points": [[0, 0], [47, 8]]}, "u": "1/2"},
     "beats": [{"at": "start", "say": "b",
                "checkpoint": {"id": "sort", "kind": "order", "ask": "Sort.", "items": ["uno", "due", "tre"]}},
               {"at": "P[1][0]", "say": "c", "checkpoint": {"id": "next", "kind": "line", "ask": "Next?"}}]}]})";
  const auto page = [&](Feedback level) {
    return page_of(
        lesson, level,
        {"", R"({"schema": "blossom.answers/1", "exercise": "asked", "answers": {"why": "a", "sort": "abc"}})"});
  };
  const std::string full = page(Feedback::full);
  CHECK(has(full, "<p>Why is <i>u</i> = 1/4 <strong>there</strong>?</p>"));
  CHECK(has(full, "since &lt; "));
  CHECK(count(full, "</span> Yours</span>") == 1);
  CHECK(count(full, "</span> Right</span>") == 2);  // of the choice and of the line that nobody took
  CHECK(count(full, "<span class=\"quiet\">place ") == 3);
  CHECK(has(full, "<h3>First</h3>"));
  CHECK(has(full, "(31, 8)"));
  CHECK(has(full, "(47, 8)"));

  const std::string hint = page(Feedback::hint);
  CHECK(count(hint, "</span> Yours</span>") == 1);
  CHECK_FALSE(has(hint, "</span> Right</span>"));
  CHECK_FALSE(has(hint, "place "));
}

TEST_CASE("who handed in nothing sees the numbers of their own", "[page]") {
  auto document = JsonDocument::load("exercises/11-own-de-casteljau.json");
  REQUIRE(document);
  auto assignment = read_assignment(*document);
  REQUIRE(assignment);
  Examiner examiner(std::move(*assignment), "a secret of 16 bytes", *parse_time("2026-10-05T12:00:00Z"));
  Student student;
  student.id = "s17";
  const std::string page = student_page(grade_student(examiner, student, {}));
  CHECK(has(page, "Nothing was handed in"));
  CHECK(has(page, "The numbers of this exercise"));
  CHECK_FALSE(has(page, "class=\"run\""));
}

TEST_CASE("their run has what they typed, and by the right rule what follows from it", "[page]") {
  // Level 1 wrong in one point, and nothing else answered: P[2][1] of the right run is (10, 38/3) at u = 1/3.
  const std::string text =
      exercise_text("de_casteljau", R"({"curve": {"degree": 2, "points": [[0, 0], [3, 9], [9, 15]]}, "u": "1/3"})",
                    R"([{"value": "P[1][*]", "points": 1}, {"value": "P[2][0]", "points": 1}])");
  const std::string page = page_of(text, Feedback::full, {R"({"P[1][0]": [1, 3], "P[1][1]": [8, 11]})"});
  CHECK(has(page, "(1 - 1/3) (1, 3) + 1/3 (5, 11)"));  // right
  CHECK(has(page, "(1 - 1/3) (1, 3) + 1/3 (8, 11)"));  // theirs
  CHECK(has(page, "(10/3, 17/3)"));                    // what follows: (2/3 + 8/3, 2 + 11/3)
  CHECK(has(page, "This would follow from your values."));
}

TEST_CASE("what they typed in decimals goes on in decimals", "[page]") {
  const std::string text =
      exercise_text("de_casteljau", R"({"curve": {"degree": 2, "points": [[0, 0], [3, 9], [9, 15]]}, "u": "1/3"})",
                    R"([{"value": "P[1][*]", "points": 1}, {"value": "P[2][0]", "points": 1}])");
  const std::string page = page_of(text, Feedback::full, {R"({"P[1][0]": [1, 3], "P[1][1]": [8.25, 11]})"});
  CHECK(has(page, "(8.25, 11)"));
  CHECK(has(page, "(3.416667, 5.666667)"));
}

TEST_CASE("a longer run is told by what is asked", "[page]") {
  auto exercise = load_exercise("exercises/67-skinning-hull.json");
  REQUIRE(exercise);
  const auto steps = exercise->run.trace.step_count();
  REQUIRE(steps > 80);
  const Grader grader(std::move(*exercise));
  auto document = JsonDocument::load("exercises/67-skinning-hull.json");
  REQUIRE(document);
  Handed handed;
  handed.text = R"({"schema": "blossom.answers/1", "exercise": "skinning-hull", "answers": {"v[1]": 0.25}})";
  const std::string page = page_of(document->text(), Feedback::full, handed);
  CHECK(has(page, "The whole run has " + std::to_string(steps) + " steps."));
  CHECK(count(page, "<tr><th scope=\"row\">") < steps);
  CHECK(page.size() < 300'000);
}

TEST_CASE("the same result makes the same bytes", "[page]") {
  const auto grader = grader_of(exercise);
  const std::string answers = some_answers(grader->exercise());
  const Feedback level = GENERATE(Feedback::none, Feedback::verdict, Feedback::hint, Feedback::full);
  CHECK(page_of(exercise, level, {answers}) == page_of(exercise, level, {answers}));
}

TEST_CASE("every shipped exercise makes a page at every level", "[page]") {
  for (const auto& entry : std::filesystem::directory_iterator("exercises")) {
    const auto document = JsonDocument::load(entry.path());
    const Json* schema = document ? document->root().find("schema") : nullptr;
    if (schema == nullptr || schema->text != "blossom.exercise/1") continue;
    auto loaded = load_exercise(entry.path());
    if (!loaded) continue;
    std::map<std::string, std::string> wrong;
    for (std::size_t i = 0; i < loaded->parts.size(); i += 2)
      wrong[loaded->parts[i].name] = loaded->parts[i].is_single() ? "77777" : "[77777, 88888]";
    Handed handed;
    handed.text = R"({"schema": "blossom.answers/1", "exercise": ")" + loaded->id + R"(", "answers": )" +
                  all_answers(*loaded, wrong) + "}";
    for (const Feedback level : {Feedback::none, Feedback::verdict, Feedback::hint, Feedback::full}) {
      CAPTURE(entry.path(), static_cast<int>(level));
      auto assignment = read_assignment(*document);
      REQUIRE(assignment);
      assignment->feedback = level;
      Examiner examiner(std::move(*assignment), "a secret of 16 bytes", *parse_time("2026-10-05T12:00:00Z"));
      Submission submission;
      submission.text = handed.text;
      const std::string page = student_page(grade_student(examiner, handed.student, {submission}));
      CHECK(page.size() < 300'000);
      CHECK(has(page, "77777") == (level != Feedback::none));
      CHECK(count(page, "<span") == count(page, "</span>"));
      CHECK(count(page, "<p") - count(page, "<path") - count(page, "<polyline") == count(page, "</p>"));
    }
  }
}
