#include "grader/assignment.hpp"

#include "grader/examiner.hpp"
#include "helpers.hpp"
#include "scratch.hpp"

using namespace blossom;
using blossom::test::Scratch;

namespace {

const std::string exercise_a = exercise_text("de_casteljau", de_casteljau_inputs,
                                             R"([{"value": "P[1][*]", "points": 2}])", R"(, "feedback": "verdict")");

std::string with_id(std::string text, const std::string& id) {
  const std::string was = R"("id": "test")";
  return text.replace(text.find(was), was.size(), R"("id": ")" + id + "\"");
}

Checked<Assignment> read(const Scratch& scratch, const std::string& members) {
  scratch.write("a.json", with_id(exercise_a, "a"));
  scratch.write("b.json", with_id(exercise_a, "b"));
  return load_assignment(
      scratch.write("course.json", R"({"schema": "blossom.assignment/1", "id": "c", "title": "C", )" + members + "}"));
}

std::string mistakes(const Checked<Assignment>& assignment) {
  REQUIRE(!assignment);
  return to_string(assignment.diagnostics);
}

Time at(const std::string& text) { return *parse_time(text); }

}  // namespace

TEST_CASE("an assignment's exercises are found beside it, worth what it says or what they say themselves") {
  const Scratch scratch;
  const auto assignment = read(scratch, R"("exercises": [{"file": "a.json", "points": 10}, {"file": "b.json"}])");
  INFO(to_string(assignment.diagnostics));
  REQUIRE(assignment);
  REQUIRE(assignment->items.size() == 2);
  CHECK(assignment->items[0].points == Exact(10));
  CHECK(assignment->items[1].points == Exact(6));  // three values of 2
  CHECK(assignment->max_points == Exact(16));
  CHECK(assignment->item("b") == 1u);
  CHECK(!assignment->item("c"));
}

TEST_CASE("a file of another kind is told in one sentence, not by all that it lacks") {
  const auto told = [](const std::string& text) {
    return read_assignment(*JsonDocument::parse("a.json", text)).diagnostics;
  };
  const auto answers = told(answers_text("{}"));
  REQUIRE(answers.size() == 1);
  CHECK(answers[0].message.starts_with("is an answers file, where an exercise, an assignment or a lesson is wanted"));
  const auto as_exercise = read_exercise(*JsonDocument::parse(
      "a.json", R"({"schema": "blossom.assignment/1", "id": "c", "title": "C", "exercises": []})"));
  REQUIRE(as_exercise.diagnostics.size() == 1);
  CHECK(as_exercise.diagnostics[0].message.starts_with("is an assignment, where an exercise is wanted"));
}

TEST_CASE("solutions are not shown before the date due") {
  const Scratch scratch;
  const std::string exercises = R"("exercises": [{"file": "a.json"}], "due": "2026-11-20T00:00:00Z", )";
  CHECK(mistakes(read(scratch, exercises + R"("full_feedback_from": "2026-01-15T00:00:00Z")"))
            .find("full_feedback_from: is before \"due\"") != std::string::npos);
  CHECK(read(scratch, exercises + R"("full_feedback_from": "2026-11-20T00:00:00Z")"));
}

TEST_CASE("an ID that no exercise has is told with those there are, or the one that it misspells") {
  const Scratch scratch;
  const auto assignment = read(scratch, R"("exercises": [{"file": "a.json"}, {"file": "b.json"}])");
  REQUIRE(assignment);
  CHECK(no_exercise_of(*assignment, "skinning") ==
        "\"skinning\" is no exercise of this assignment, which has \"a\", \"b\"");
  const auto alone = load_assignment(scratch.write("e.json", exercise_a));
  CHECK(no_exercise_of(*alone, "tset") == "\"tset\" is no exercise of this assignment; did you mean \"test\"?");
}

TEST_CASE("an exercise alone is an assignment of its own points") {
  const Scratch scratch;
  const auto assignment = load_assignment(scratch.write("e.json", exercise_a));
  REQUIRE(assignment);
  CHECK(assignment->id == "test");
  CHECK(assignment->max_points == Exact(6));
  CHECK(assignment->items.size() == 1);
}

TEST_CASE("an exercise may stand in the assignment itself, and its mistakes keep their places") {
  const Scratch scratch;
  CHECK(read(scratch, R"("exercises": [{"exercise": )" + exercise_a + "}]"));
  const auto text =
      mistakes(read(scratch, "\"exercises\": [\n  {\"points\": 1, \"exercise\":\n    " +
                                 with_id(exercise_a, "é").replace(0, 1, "{ \"extra\": 1,\n      ") + "}]"));
  CHECK(text.find("course.json:3:7: exercises[0].exercise") != std::string::npos);
  CHECK(text.find("course.json:4:") != std::string::npos);  // the id, behind two-byte characters
}

TEST_CASE("a lesson stands in an assignment for its checkpoints") {
  const Scratch scratch;
  scratch.write("lesson.json",
                R"({"schema": "blossom.lesson/1", "id": "asks", "title": "T", "algorithm": "de_casteljau",
    "inputs": {"curve": {"degree": 1, "points": [[0, 0], [2, 4]]}, "u": "1/4"},
    "beats": [{"at": "start", "say": "Look.",
               "checkpoint": {"id": "where", "kind": "predict", "value": "C", "points": 3, "ask": "Where?"}}]})");
  const auto assignment = read(scratch, R"("exercises": [{"file": "lesson.json", "points": 5}, {"file": "a.json"}])");
  INFO(to_string(assignment.diagnostics));
  REQUIRE(assignment);
  CHECK(assignment->item("asks") == std::optional<std::size_t>(0));
  CHECK(assignment->items[0].points == Exact(5));
  CHECK(assignment->items[0].exercise.parts[0].name == "where");
}

TEST_CASE("every mistake of an assignment is told at once") {
  const Scratch scratch;
  scratch.write("bad.json", "{\n \"schema\": \"blossom.exercise/1\"}");
  scratch.write("scene.json", R"({"schema": "blossom.scene/1"})");
  const auto text = mistakes(read(scratch, R"("exercises": [{"file": "a.json", "points": -1}, {"file": "b.json"},
      {"file": "none.json"}, {"file": "bad.json"}, {"file": "scene.json"}, {}, {"file": "b.json", "exercise": {}}],
      "due": "tomorrow", "late": {"per_day": 2, "grace": 1}, "attempts": "worst", "feedback": "loud", "lms_id": 7)"));
  INFO(text);
  for (const auto* each : {"exercises[0].points: must be from 0", "exercises[2].file: \"none.json\"", "bad.json:1:1",
                           "exercises[4].file: must be the path of an exercise", "exercises[5]", "exercises[6]",
                           "due: ", "late.per_day: must be a share", "unknown key \"grace\"",
                           "attempts: must be one of", "feedback: must be one of", "lms_id: must be a string"}) {
    INFO(each);
    CHECK(text.find(each) != std::string::npos);
  }
}

TEST_CASE("the same exercise twice, no points at all, and lateness without a date are mistakes") {
  const Scratch scratch;
  CHECK(mistakes(read(scratch, R"("exercises": [{"file": "a.json"}, {"file": "a.json"}])")).find("already") !=
        std::string::npos);
  CHECK(mistakes(read(scratch, R"("exercises": [{"file": "a.json", "points": 0}])")).find("more than 0 points") !=
        std::string::npos);
  CHECK(mistakes(read(scratch, R"("exercises": [])")).find("exercises: ") != std::string::npos);
  CHECK(mistakes(read(scratch, R"("exercises": [{"file": "a.json"}], "late": {"per_day": 0.1})"))
            .find("means nothing without \"due\"") != std::string::npos);
}

TEST_CASE("days of lateness are those begun since the date, once the grace is over") {
  LatePolicy late;
  late.grace_minutes = 60;
  const Time due = at("2026-10-01T12:00:00Z");
  CHECK(late.days_late(due, at("2026-09-01T12:00:00Z")) == 0);
  CHECK(late.days_late(due, due) == 0);
  CHECK(late.days_late(due, at("2026-10-01T13:00:00Z")) == 0);
  CHECK(late.days_late(due, at("2026-10-01T13:00:01Z")) == 1);
  CHECK(late.days_late(due, at("2026-10-02T12:00:00Z")) == 1);
  CHECK(late.days_late(due, at("2026-10-02T12:00:01Z")) == 2);
  CHECK(late.days_late(due, at("2027-10-01T12:00:00Z")) == 365);
}

TEST_CASE("each day late costs its share, never more than all, and nothing is left after the last day") {
  LatePolicy late;
  late.per_day = Exact::ratio(3, 10);
  CHECK(late.share(0) == Exact(1));
  CHECK(late.share(1) == Exact::ratio(7, 10));
  CHECK(late.share(3) == Exact::ratio(1, 10));
  CHECK(late.share(4) == Exact(0));
  late.at_most_days = 2;
  CHECK(late.share(2) == Exact::ratio(4, 10));
  CHECK(late.share(3) == Exact(0));
}

TEST_CASE("the level of feedback is the assignment's, else the exercise's, until everybody may see everything") {
  const Scratch scratch;
  const Time before = at("2026-10-31T23:59:59Z"), from = at("2026-11-01T00:00:00Z");
  const auto own = read(scratch, R"("exercises": [{"file": "a.json"}], "full_feedback_from": "2026-11-01T00:00:00Z")");
  REQUIRE(own);
  CHECK(own->feedback_at(0, before) == Feedback::verdict);
  CHECK(own->feedback_at(0, from) == Feedback::full);
  const auto none = read(scratch, R"("exercises": [{"file": "a.json"}], "feedback": "none")");
  REQUIRE(none);
  CHECK(none->feedback_at(0, from) == Feedback::none);

  Examiner examiner(*own, {}, before);
  const auto grader = examiner.grader(0, "s1");
  REQUIRE(grader);
  CHECK((*grader)->exercise().feedback == Feedback::verdict);
  CHECK(*grader == *examiner.grader(0, "s2"));  // nothing varies: one for all
}
