// The checkpoints of lessons, graded.

#include "grader/lesson_grader.hpp"

#include <catch2/catch.hpp>

#include "base/json_write.hpp"
#include "grader/assignment.hpp"
#include "grader/report/report.hpp"
#include "lesson/catalog.hpp"

using namespace blossom;

namespace {

JsonDocument parsed(const std::string& text, const JsonLimits& limits = {}) {
  auto document = JsonDocument::parse("answers.json", text, limits);
  INFO(to_string(document.diagnostics));
  REQUIRE(document);
  return *std::move(document);
}

Json json(const std::string& text) { return parsed(text).root(); }

// A checkpoint of each kind, in two scenes and two languages.
const std::string lesson_text = R"({"schema": "blossom.lesson/1", "id": "all-kinds",
  "languages": ["de"], "language": "en", "summary": {"en": "S", "de": "Z"}, "title": {"en": "All", "de": "Alle"},
  "scenes": [
   {"id": "one", "title": {"en": "1", "de": "1"}, "algorithm": "de_boor",
    "inputs": {"curve": {"degree": 2, "knots": [0, 0, 0, 1, 2, 2, 2], "points": [[0, 0], [2, 4], [4, 0], [6, 2]]},
               "u": "1/2"},
    "beats": [
     {"at": "start", "say": {"en": "a", "de": "a"},
      "checkpoint": {"id": "which-span", "kind": "span", "points": 2, "ask": {"en": "?", "de": "?"},
                     "wrong": {"en": "Look at the knots: u = **{u}**.", "de": "Sieh die Knoten an."}}},
     {"at": "k", "say": {"en": "b", "de": "b"},
      "checkpoint": {"id": "first-point", "kind": "predict", "value": "P[1][1]", "ask": {"en": "?", "de": "?"}}},
     {"at": "P[1][1]", "say": {"en": "c", "de": "c"},
      "checkpoint": {"id": "the-point", "kind": "predict", "value": "C", "points": 3, "ask": {"en": "?", "de": "?"},
                     "right": {"en": "So it is.", "de": "So ist es."}}},
     {"at": "P[1][2]", "say": {"en": "d", "de": "d"},
      "checkpoint": {"id": "next-line", "kind": "line", "ask": {"en": "?", "de": "?"}}}]},
   {"id": "two", "title": {"en": "2", "de": "2"}, "algorithm": "de_casteljau",
    "inputs": {"curve": {"degree": 1, "points": [[0, 0], [4, 8]]}, "u": "1/4"},
    "beats": [
     {"at": "start", "say": {"en": "e", "de": "e"},
      "checkpoint": {"id": "why", "kind": "choice", "ask": {"en": "?", "de": "?"},
        "wrong": {"en": "No.", "de": "Nein."},
        "choices": [{"text": {"en": "x", "de": "x"}, "feedback": {"en": "Not x.", "de": "Nicht x."}},
                    {"text": {"en": "y", "de": "y"}, "right": true, "feedback": {"en": "Indeed.", "de": "Ja."}},
                    {"text": {"en": "z", "de": "z"}}]}},
     {"at": "end", "say": {"en": "f", "de": "f"},
      "checkpoint": {"id": "in-order", "kind": "order", "ask": {"en": "?", "de": "?"},
                     "items": [{"en": "1", "de": "1"}, {"en": "2", "de": "2"}, {"en": "3", "de": "3"}]}}]}]})";

Exercise sheet_of(const std::string& language = {}) {
  auto sheet = read_sheet(parsed(lesson_text), language);
  INFO(to_string(sheet.diagnostics));
  REQUIRE(sheet);
  return *std::move(sheet);
}

std::string answers_text(const std::string& answers, const std::string& id = "all-kinds") {
  return R"({"schema": "blossom.answers/1", "exercise": ")" + id + R"(", "answers": )" + answers + "}";
}

// The right answer to a part as a file has it.
Json right_answer(const Part& part) {
  if (part.question != nullptr && !part.question->is_value()) return json_string(part.question->right);
  std::vector<Json> numbers;
  for (const Exact& x : part.right) numbers.push_back(json_string(x.to_string()));
  if (part.is_single()) return numbers.front();
  return json_array(std::move(numbers));
}

// Another answer of the same form.
Json wrong_answer(const Part& part) {
  if (part.question != nullptr && !part.question->is_value()) {
    const Question& question = *part.question;
    if (question.kind == Checkpoint::Kind::order)
      return json_string(std::string(question.right.rbegin(), question.right.rend()));
    if (question.kind == Checkpoint::Kind::choice) return json_string(question.right == "a" ? "b" : "a");
    return json_number(question.right == "1" ? "2" : "1");
  }
  Json answer = right_answer(part);
  Json& number = answer.kind == Json::Kind::array ? answer.items.back() : answer;
  number = json_string((*Exact::parse(number.text) + Exact(17)).to_string());
  return answer;
}

Json answers_json(const Exercise& sheet, const std::string& changed = {}) {
  std::vector<std::pair<std::string, Json>> answers;
  for (const Part& part : sheet.parts)
    answers.emplace_back(part.name, part.name == changed ? wrong_answer(part) : right_answer(part));
  return json_object({{"schema", json_string("blossom.answers/1")},
                      {"exercise", json_string(sheet.id)},
                      {"answers", json_object(std::move(answers))}});
}

std::string verdicts(const Grade& grade) {
  std::string text;
  for (std::size_t i = 0; i < grade.parts.size(); ++i)
    text +=
        (i > 0 ? " " : "") + grade.exercise->parts[i].name + ":" + std::string(verdict_name(grade.parts[i].verdict));
  return text;
}

}  // namespace

TEST_CASE("a sheet has a part for each checkpoint, in the order of the lesson, under its id") {
  const auto sheet = sheet_of();
  std::string names;
  for (const Part& part : sheet.parts) names += part.name + " ";
  CHECK(names == "which-span first-point the-point next-line why in-order ");
  CHECK(sheet.id == "all-kinds");
  CHECK(sheet.title == "All");
  CHECK(sheet_of("de").title == "Alle");
  CHECK(sheet.max_points == Exact(9));
}

TEST_CASE("answers of each kind are marked, and the lesson's own words are said") {
  const Grader grader(sheet_of());
  const auto grade = grader.grade(json(answers_text(
      R"({"which-span": 3, "first-point": ["3/2", 3], "the-point": [2.25, "9/4"], "next-line": 1, "why": "a",
          "in-order": ["a", "b", "c"], "else": 1})")));
  CHECK(grade.parts[0].verdict != Verdict::correct);
  CHECK(grade.parts[3].verdict == Verdict::wrong);
  CHECK(grade.parts[4].verdict == Verdict::wrong);
  CHECK(grade.parts[4].feedback == "Not x. No. Right is b.");
  CHECK(grade.parts[5].verdict == Verdict::wrong);
  REQUIRE(grade.notes.size() == 1);
  CHECK_THAT(grade.notes[0], Catch::Contains("\"else\" is not asked"));

  const auto right = grader.grade(answers_json(grader.exercise()));
  CHECK(verdicts(right) ==
        "which-span:correct first-point:correct the-point:correct next-line:correct why:correct in-order:correct");
  CHECK(right.points == Exact(9));
  CHECK(right.parts[0].feedback == "Correct.");
  CHECK(right.parts[2].feedback == "So it is.");
  CHECK(right.parts[4].feedback == "Indeed.");

  const Grader in_german(sheet_of("de"));
  CHECK(in_german.grade(answers_json(in_german.exercise())).parts[2].feedback == "So ist es.");
  CHECK_THAT(in_german.grade(answers_json(in_german.exercise(), "why")).parts[4].feedback,
             Catch::StartsWith("Nicht x. Nein."));
}

TEST_CASE("what is wrong is carried on, and words of the lesson are plain text") {
  const Grader grader(sheet_of());
  // A wrong first point, and the result of it: only the first is wrong.
  const auto& trace = grader.exercise().scenes[0].run.trace;
  const Narrator<Exact> narrator(grader.exercise().scenes[0].run);
  const auto number = [&](const char* name) { return trace.numbers(*trace.find(name)); };
  const Exact alpha = number("alpha[2][2]")[0];
  const Exact x = number("P[1][1]")[0] + Exact(5), y = number("P[1][1]")[1];
  const auto later = number("P[1][2]");
  const Exact cx = (Exact(1) - alpha) * x + alpha * later[0], cy = (Exact(1) - alpha) * y + alpha * later[1];
  const auto grade = grader.grade(
      json(answers_text(R"({"which-span": 99, "first-point": [")" + x.to_string() + "\", \"" + y.to_string() +
                        R"("], "the-point": [")" + cx.to_string() + "\", \"" + cy.to_string() + "\"]}")));
  CHECK(verdicts(grade) ==
        "which-span:wrong first-point:wrong the-point:carried next-line:missing why:missing in-order:missing");
  CHECK(grade.points == Exact(3));
  CHECK_THAT(grade.parts[0].feedback, Catch::StartsWith("Look at the knots: u = 1/2."));
}

TEST_CASE("letters are read as people write them, and nothing else is") {
  Question choice;
  choice.right = "b";
  choice.count = 3;
  const auto of = [](const Question& question, const std::string& text) { return mark_letters(question, json(text)); };
  for (const char* text : {"\"b\"", "\"B\"", "\" b \"", "[\"b\"]"}) CHECK(of(choice, text).verdict == Verdict::correct);
  CHECK(of(choice, "\"c\"").verdict == Verdict::wrong);
  CHECK(of(choice, "\"c\"").choice == 2);
  for (const char* text :
       {"\"d\"", "\"\"", "\"ab\"", "\"é\"", "2", "null", "true", "{}", "[]", "[[\"b\"]]", "\"b1\""}) {
    INFO(text);
    CHECK(of(choice, text).verdict == Verdict::invalid);
    CHECK_THAT(of(choice, text).problem, Catch::StartsWith("must be one letter from a to c, not "));
  }
  Question order;
  order.kind = Checkpoint::Kind::order;
  order.right = "cab";
  order.count = 3;
  for (const char* text : {"\"cab\"", "\"C A B\"", "\"c, a, b\"", "[\"c\", \"a\", \"b\"]"})
    CHECK(of(order, text).verdict == Verdict::correct);
  CHECK(of(order, "\"abc\"").verdict == Verdict::wrong);
  for (const char* text : {"\"ca\"", "\"caa\"", "\"cabd\"", "\"cad\"", "3", "[\"c\", 1, \"b\"]", "[[]]"})
    CHECK(of(order, text).verdict == Verdict::invalid);
  Question line;
  line.kind = Checkpoint::Kind::line;
  line.right = "4";
  line.count = 9;
  for (const char* text : {"4", "\"4\"", "4.0", "\"8/2\""}) CHECK(of(line, text).verdict == Verdict::correct);
  for (const char* text : {"3", "9"}) CHECK(of(line, text).verdict == Verdict::wrong);
  for (const char* text : {"0", "10", "4.5", "\"four\"", "[4]", "1e300", "-1"})
    CHECK(of(line, text).verdict == Verdict::invalid);
}

TEST_CASE("hostile answers are graded, and nothing of them is large in the grade") {
  const Grader grader(sheet_of());
  const std::string longest(60'000, 'a');
  std::string many = "[";
  for (int i = 0; i < 4000; ++i) many += "\"a\",";
  many += "\"a\"]";
  for (const std::string& answer : {std::string("null"), std::string("{}"), "\"" + longest + "\"", many,
                                    std::string("[[[[[[]]]]]]"), std::string("1e308"), std::string("\"\\u0000\"")}) {
    for (const Part& part : grader.exercise().parts) {
      const auto document =
          JsonDocument::parse("a", answers_text("{\"" + part.name + "\": " + answer + "}"), submission_limits);
      const auto grade = grader.grade(document);
      CHECK(grade.points == Exact(0));
      std::string line;
      write_json(grade, line);
      CHECK(line.size() < 8000);
    }
  }
  const auto other = grader.grade(json(answers_text("{}", "another")));
  CHECK_THAT(other.reason, Catch::Contains("\"exercise\" must be \"all-kinds\""));
  for (const PartGrade& part : other.parts) CHECK(part.verdict == Verdict::invalid);
}

TEST_CASE("what may not be told is not told") {
  Exercise sheet = sheet_of();
  sheet.feedback = Feedback::verdict;
  const Grader quiet(std::move(sheet));
  for (const std::string changed : {"", "why", "the-point", "in-order"})
    for (const PartGrade& part : quiet.grade(answers_json(quiet.exercise(), changed)).parts)
      CHECK(part.feedback.empty());
  Exercise hinting = sheet_of();
  hinting.feedback = Feedback::hint;
  const Grader hints(std::move(hinting));
  const auto grade = hints.grade(answers_json(hints.exercise(), "why"));
  CHECK(grade.parts[4].feedback == "Not x. No.");
}

TEST_CASE("every report can be written of a lesson's grades") {
  const auto assignment = read_assignment(parsed(lesson_text));
  INFO(to_string(assignment.diagnostics));
  REQUIRE(assignment);
  Examiner examiner(*assignment, {}, Time());
  for (const ReportFormat* format : report_formats()) {
    INFO(format->name);
    for (const std::string changed : {"", "which-span", "why"}) {
      const Exercise& sheet = (*examiner.grader(0, ""))->exercise();
      Submission submission;
      submission.source = "a.json";
      submission.text = write_json(answers_json(sheet, changed));
      Student student;
      student.id = "s1";
      const StudentResult result = grade_student(examiner, student, {submission});
      CHECK((result.points == result.max_points) == changed.empty());
      std::string out;
      const auto report = format->open({&examiner.assignment(), 1, true});
      report->begin(out);
      report->add(result, out);
      report->finish(out);
      CHECK(out.size() > 10);
    }
  }
}

TEST_CASE("a lesson without checkpoints cannot be graded") {
  const auto sheet = read_sheet(parsed(R"({"schema": "blossom.lesson/1", "id": "a", "title": "T",
    "algorithm": "de_casteljau", "inputs": {"curve": {"degree": 1, "points": [[0, 0], [2, 4]]}, "u": "1/4"},
    "beats": [{"at": "C", "say": "{C}"}]})"));
  CHECK(to_string(sheet.diagnostics) ==
        "answers.json:1:1: has no checkpoints, so there is nothing to grade: give a beat a \"checkpoint\"\n");
}

// ---- one at a time --------------------------------------------------------------------------------------------------

TEST_CASE("a checkpoint is marked at once, with the words of the lesson and those of the grader") {
  const auto lesson = load_lesson(parsed(lesson_text));
  REQUIRE(lesson);
  const auto mark = [&](std::size_t scene, std::size_t beat, const std::string& answer,
                        const std::string& language = {}) {
    return mark_checkpoint(*lesson, scene, *lesson->scene_at(scene).beats[beat].checkpoint, json(answer), language);
  };
  const auto span = mark(0, 0, "2");
  CHECK(span.verdict == Verdict::correct);
  CHECK(span.points == Exact(2));
  CHECK(span.words.empty());
  CHECK(span.note.empty());
  CHECK(span.right == "k = 2");
  CHECK(mark(0, 0, "77").words == "Look at the knots: u = **1/2**.");  // for prose.hpp
  CHECK(mark(0, 0, "77", "de").words == "Sieh die Knoten an.");
  CHECK(mark(0, 0, "\"two\"").verdict == Verdict::invalid);
  CHECK(mark(0, 0, "\"two\"").words.empty());
  CHECK_THAT(mark(0, 0, "\"two\"").note, Catch::Contains("which is no number"));
  const auto choice = mark(1, 0, "\"a\"");
  CHECK(choice.verdict == Verdict::wrong);
  CHECK(choice.words == "Not x.\n\nNo.");
  CHECK(choice.right == "b");
  CHECK(choice.points == Exact(0));
  CHECK(mark(1, 0, "\"b\"", "de").words == "Ja.");
  CHECK(mark(1, 1, "\"abc\"").verdict == Verdict::wrong);
}

TEST_CASE("what the grader says of a value has names as books write them, and none from a run within the run") {
  const auto lesson = load_lesson(parsed(lesson_text));
  REQUIRE(lesson);
  CHECK(mark_checkpoint(*lesson, 0, *lesson->beats[1].checkpoint, json("[9, 9]")).note ==
        "Not the right value. The rule is P₁⁽¹⁾ = (1 - α₁⁽¹⁾) P₀ + α₁⁽¹⁾ P₁.");
  const auto removal =
      load_lesson(*JsonDocument::load(std::filesystem::path(BLOSSOM_SOURCE_DIR) / "lessons/34-knot-removal.json"));
  REQUIRE(removal);
  for (const Beat& beat : removal->beats) {
    if (!beat.checkpoint || beat.checkpoint->value != "removal[1].L[1]") continue;
    const auto mark = mark_checkpoint(*removal, 0, *beat.checkpoint, json("[99, 98]"));
    CHECK(mark.note == "Not the right value.");
    CHECK(mark.right == "(0, 6)");
  }
}

TEST_CASE("a language that the lesson lacks is a mistake") {
  CHECK(read_sheet(parsed(lesson_text), "de"));
  CHECK(read_sheet(parsed(lesson_text), "en"));
  CHECK_THAT(to_string(read_sheet(parsed(lesson_text), "fr").diagnostics),
             Catch::Contains("is not in the language \"fr\"; it is in en, de"));
}

TEST_CASE("in another run a checkpoint is about that run's values") {
  const auto lesson = load_lesson(parsed(lesson_text));
  REQUIRE(lesson);
  Inputs<Exact> moved = lesson->inputs;
  moved.values["u"] = Exact::ratio(3, 2);
  const auto run = record<Exact>(*lesson->algorithm, moved);
  REQUIRE(run);
  const auto mark = mark_checkpoint(*run, 0, *lesson->beats[0].checkpoint, json("3"));
  CHECK(mark.verdict == Verdict::correct);
  CHECK(mark.right == "k = 3");
}

// ---- the shipped lessons --------------------------------------------------------------------------------------------

TEST_CASE("right answers to the checkpoints of the shipped lessons earn all points, and no changed one does") {
  const auto catalog = load_catalog(std::filesystem::path(BLOSSOM_SOURCE_DIR) / "lessons");
  for (const auto& [file, lesson] : catalog.lessons) {
    INFO(file.string());
    const auto sheet = make_sheet(lesson);
    REQUIRE(sheet);
    if (sheet->parts.empty()) continue;
    const Grader grader(*sheet);
    const auto right = grader.grade(answers_json(*sheet));
    INFO(verdicts(right));
    CHECK(right.points == sheet->max_points);
    for (const Part& part : sheet->parts) {
      INFO(part.name);
      const auto changed = grader.grade(answers_json(*sheet, part.name));
      CHECK(changed.points < sheet->max_points);
      const Question& question = *part.question;
      const LessonScene& scene = lesson.scene_at(question.scene);
      for (const Beat& beat : scene.beats)
        if (beat.checkpoint && beat.checkpoint->id == part.name) {
          CHECK(mark_checkpoint(lesson, question.scene, *beat.checkpoint, right_answer(part)).verdict ==
                Verdict::correct);
          CHECK(mark_checkpoint(lesson, question.scene, *beat.checkpoint, wrong_answer(part)).verdict !=
                Verdict::correct);
        }
    }
  }
}
