// What one student has in an assignment: which submission counts, what lateness costs, and what is said of all others.
#include "grader/result.hpp"

#include "helpers.hpp"
#include "scratch.hpp"

using namespace blossom;
using blossom::test::Scratch;

namespace {

// Two exercises of one value worth 1, "a" and "b"; the right answer is 1.2 = (1 - 2/5) 0 + 2/5 3.
std::string exercise_of(const std::string& id, const std::string& more) {
  return R"({"schema": "blossom.exercise/1", "id": ")" + id +
         R"(", "title": "T", "prompt": "P", "algorithm": "de_casteljau",
           "inputs": {"curve": {"degree": 1, "points": [[0, 0], [1, 3]]}, "u": "2/5"},
           "ask": [{"value": "P[1][0]", "points": 1, "feedback": "Think of the weights."}])" +
         more + "}";
}

struct Course {
  explicit Course(const std::string& members = "", const std::string& of_exercise = "", bool both = true) {
    const std::string b = both ? R"(, {"exercise": )" + exercise_of("b", of_exercise) + R"(, "points": 6})" : "";
    auto document = JsonDocument::parse("course.json", R"({"schema": "blossom.assignment/1", "id": "c", "title": "C",
        "exercises": [{"exercise": )" + exercise_of("a", of_exercise) +
                                                           R"(, "points": 4})" + b + "]" + members + "}");
    REQUIRE(document);
    auto assignment = read_assignment(*document);
    INFO(to_string(assignment.diagnostics));
    REQUIRE(assignment);
    examiner.emplace(std::move(*assignment), "", *parse_time("2026-10-10T00:00:00Z"));
  }
  StudentResult grade(std::vector<Submission> submissions, Student student = {}) {
    if (student.id.empty()) student.id = "s1";
    return grade_student(*examiner, student, std::move(submissions));
  }
  std::optional<Examiner> examiner;
};

const std::string right = R"(["2/5", "6/5"])", wrong = "[7, 7]";

std::string answers(const std::string& exercise, const std::string& value, const std::string& more = "") {
  return R"({"schema": "blossom.answers/1", "exercise": ")" + exercise + R"(", "answers": {"P[1][0]": )" + value + "}" +
         more + "}";
}

Submission handed_in(const std::string& source, const std::string& text, const std::string& time = "") {
  return {source, time.empty() ? std::nullopt : parse_time(time), text, {}};
}

// "kind exercise source" of each.
std::vector<std::string> incidents(const StudentResult& result) {
  std::vector<std::string> lines;
  for (const Incident& incident : result.incidents)
    lines.push_back(std::string(incident_name(incident.kind)) + " " + incident.exercise + " " + incident.source);
  return lines;
}
using Lines = std::vector<std::string>;

const std::string due = R"(, "due": "2026-10-01T12:00:00Z", "late": {"per_day": 0.25, "at_most_days": 3})";

}  // namespace

TEST_CASE("points are scaled to the assignment's, and what is not handed in is missing") {
  Course course;
  const auto result = course.grade({handed_in("x.json", answers("b", right))});
  CHECK(result.points == Exact(6));
  CHECK(result.max_points == Exact(10));
  CHECK(result.score() == 0.6);
  REQUIRE(result.exercises.size() == 2);
  CHECK(!result.exercises[0].grade);
  CHECK(result.exercises[1].grade);
  CHECK(result.exercises[1].source == "x.json");
  CHECK(incidents(result) == Lines{"missing a "});
}

TEST_CASE("the last one counts, whatever the order in which they are found") {
  const auto old = handed_in("2.json", answers("a", right), "2026-09-01T10:00:00Z");
  const auto young = handed_in("1.json", answers("a", wrong), "2026-09-01T10:00:01Z");
  for (const auto& order : {std::vector{old, young}, std::vector{young, old}}) {
    const auto last = Course("", "", false).grade(order);
    CHECK(last.points == Exact(0));
    CHECK(last.exercises[0].source == "1.json");
    CHECK(incidents(last) == Lines{"duplicate a 2.json"});
    const auto first = Course(R"(, "attempts": "first")", "", false).grade(order);
    CHECK(first.points == Exact(4));
    CHECK(incidents(first) == Lines{"duplicate a 1.json"});
    const auto best = Course(R"(, "attempts": "best")", "", false).grade(order);
    CHECK(best.points == Exact(4));
    CHECK(incidents(best) == Lines{"duplicate a 1.json"});
  }
}

TEST_CASE("of the same second, or without a time, the source decides") {
  for (const auto* time : {"", "2026-09-01T10:00:00Z"}) {
    const auto result =
        Course("", "", false)
            .grade({handed_in("b.json", answers("a", right), time), handed_in("a.json", answers("a", wrong), time)});
    CHECK(result.exercises[0].source == "b.json");
    CHECK(result.points == Exact(4));
  }
}

TEST_CASE("lateness costs its share of the points; a student's own date stands for the assignment's") {
  Course course(due, "", false);
  const auto points = [&](const std::string& time, const std::string& own = "") {
    Student student;
    student.id = "s1";
    if (!own.empty()) student.due = parse_time(own);
    const auto result = course.grade({handed_in("x.json", answers("a", right), time)}, student);
    CHECK(incidents(result) == (result.points == Exact(4) ? Lines{} : Lines{"late a x.json"}));
    return result.points;
  };
  CHECK(points("2026-10-01T12:00:00Z") == Exact(4));
  CHECK(points("2026-10-01T12:00:01Z") == Exact(3));
  CHECK(points("2026-10-03T12:00:00Z") == Exact(2));
  CHECK(points("2026-10-04T12:00:01Z") == Exact(0));
  CHECK(points("2026-10-04T12:00:01Z", "2026-10-04T12:00:00Z") == Exact(3));
  CHECK(points("2026-09-20T12:00:00Z", "2026-09-19T12:00:00Z") == Exact(3));
}

TEST_CASE("the best is the best after what lateness costs") {
  Course course(due + R"(, "attempts": "best")", R"(, "carried": 1)", false);
  const auto result = course.grade({handed_in("early.json", answers("a", right), "2026-10-01T11:00:00Z"),
                                    handed_in("late.json", answers("a", right), "2026-10-02T11:00:00Z")});
  CHECK(result.exercises[0].source == "early.json");
  CHECK(result.points == Exact(4));
  CHECK(incidents(result) == Lines{"duplicate a late.json"});
}

TEST_CASE("what cannot be read is told, and counts only where nothing else does") {
  Course one("", "", false);
  const auto garbage = handed_in("z.json", "{nonsense");
  const auto alone = one.grade({garbage});
  REQUIRE(alone.exercises[0].grade);
  CHECK(alone.exercises[0].grade->reason.find("line 1") == 0);
  CHECK(alone.exercises[0].grade->parts[0].verdict == Verdict::invalid);
  CHECK(incidents(alone) == Lines{"unreadable a z.json"});

  const auto beside = one.grade({handed_in("a.json", answers("a", right)), garbage});
  CHECK(beside.points == Exact(4));
  CHECK(incidents(beside) == Lines{"unreadable a z.json"});

  // Of two exercises it may be for either.
  const auto either = Course().grade({garbage});
  CHECK(!either.exercises[0].grade);
  CHECK(incidents(either) == Lines{"unreadable  z.json", "missing a ", "missing b "});

  // This one says which it is for.
  const auto named = Course().grade({handed_in("y.json", R"({"schema": "x", "exercise": "b", "answers": {}})")});
  REQUIRE(named.exercises[1].grade);
  CHECK(named.exercises[1].grade->reason.find("\"schema\" must be") == 0);
  CHECK(incidents(named) == Lines{"unreadable b y.json", "missing a "});

  Submission unread = handed_in("link.json", "");
  unread.problem = "is a symbolic link";
  const auto link = one.grade({unread});
  CHECK(link.exercises[0].grade->reason == "is a symbolic link");
}

TEST_CASE("hostile submissions are unreadable, not more") {
  Course course("", "", false);
  for (const std::string& text : {std::string(70'000, ' ') + "{}", std::string(30'000, '['), std::string("\0", 1),
                                  std::string("\xff\xfe"), std::string(), std::string("[]"), std::string("3")}) {
    const auto result = course.grade({handed_in("x", text)});
    CHECK(result.points == Exact(0));
    CHECK(incidents(result) == Lines{"unreadable a x"});
  }
}

TEST_CASE("answers to something else are misplaced") {
  const auto result = Course("", "", false).grade({handed_in("x.json", answers("other", right))});
  CHECK(incidents(result) == Lines{"misplaced  x.json", "missing a "});
  CHECK(result.incidents[0].text.find("\"other\"") != std::string::npos);
}

TEST_CASE("whose a file says it is decides nothing, and is told when it is somebody else's") {
  Course course("", "", false);
  Student ada;
  ada.id = "s17";
  ada.login = "lovelace";
  ada.email = "ada@example.edu";
  for (const auto* known : {"s17", "S17", "lovelace", "Ada@Example.edu"}) {
    const auto result =
        course.grade({handed_in("x", answers("a", right, R"(, "student": ")" + std::string(known) + "\""))}, ada);
    CHECK(result.points == Exact(4));
    CHECK(incidents(result).empty());
    CHECK(result.exercises[0].grade->notes.empty());
  }
  const auto foreign = course.grade({handed_in("x", answers("a", right, R"(, "student": "s18")"))}, ada);
  CHECK(foreign.points == Exact(4));
  CHECK(foreign.student.id == "s17");
  CHECK(incidents(foreign) == Lines{"foreign-id a x"});
}

TEST_CASE("the digest is that of the bytes") {
  const auto result = Course("", "", false).grade({handed_in("x", "abc")});
  CHECK(result.exercises[0].digest == "ba7816bf8f01cfea");  // FIPS 180-4's example
}

namespace {

std::string json_of(const StudentResult& result, Audience audience) {
  std::string line;
  write_json(result, audience, line);
  const auto document = JsonDocument::parse("result", line);
  INFO(line << to_string(document.diagnostics));
  REQUIRE(document);
  CHECK(line.find('\n') == std::string::npos);
  return line;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("a student's JSON has no more than the level of feedback; the instructor's has all, as it was typed") {
  const std::string swapped = R"(["3/5", "9/5"])";  // a misconception, with advice
  for (const std::string level : {"none", "verdict", "hint", "full"}) {
    INFO(level);
    Course course(R"(, "feedback": ")" + level + "\"", "", false);  // which the result points into
    const auto result = course.grade({handed_in("x", answers("a", swapped))});
    const auto student = json_of(result, Audience::student);
    CHECK(has(student, R"("points":0)"));
    CHECK(has(student, R"("verdict":"misconception")") == (level == "hint" || level == "full"));
    CHECK(has(student, "swapped-weights") == (level == "hint" || level == "full"));
    CHECK(has(student, "weights are swapped") == (level == "hint" || level == "full"));
    CHECK(has(student, "6/5") == (level == "full"));
    CHECK(!has(student, R"("answer")"));
    CHECK(!has(student, R"("explanation")") == (level == "none" || level == "verdict"));
    const auto instructor = json_of(result, Audience::instructor);
    CHECK(has(instructor, R"("answer":["3/5","9/5"])"));
    CHECK(has(instructor, "swapped-weights"));
  }
}

TEST_CASE("whatever was typed for an answer is in the instructor's JSON, and is JSON") {
  Course course("", "", false);
  for (const std::string& value :
       {std::string(R"({"set":[1,{"a":null}],"x":true})"), std::string(R"("</script>\u0000\"")"),
        std::string(R"([[[[[[1e3]]]]]])"), std::string("-0.10")}) {
    const auto result = course.grade({handed_in("x", answers("a", value))});
    const auto line = json_of(result, Audience::instructor);
    CHECK(has(line, "\"answer\":"));
    if (value[0] != '"') CHECK(has(line, "\"answer\":" + value));
  }
}

TEST_CASE("without times the last one is the last by name, as people and systems number files") {
  Course course("", "", false);
  const Lines in_order = {"s1/2/answers.json",    "s1/10/answers.json",  "s1/answers.json",   "s1/answers (1).json",
                          "s1/answers (2).json",  "s1/answers-1.json",   "s1/answers-2.json", "s1/answers-10.json",
                          "s1/answers-010a.json", "s1/answers-10b.json", "s1/b/answers.json", "s1/b-2/answers.json"};
  for (std::size_t last = 1; last < in_order.size(); ++last)
    for (std::size_t i = 0; i < last; ++i) {
      const auto result =
          course.grade({handed_in(in_order[last], answers("a", right)), handed_in(in_order[i], answers("a", wrong))});
      INFO(in_order[i] << ", " << in_order[last]);
      CHECK(result.exercises[0].source == in_order[last]);
    }
}

TEST_CASE("an ID makes a file name that is safe, readable, and its own") {
  CHECK(file_name_of("s17") == "s17");
  CHECK(file_name_of("ada.lovelace@x-y_z") == "ada.lovelace@x-y_z");
  CHECK(file_name_of("../../etc") == "%2E.%2F..%2Fetc");
  CHECK(file_name_of(".") == "%2E");
  CHECK(file_name_of("a b") == "a%20b");
  CHECK(file_name_of("%41") == "%2541");
  CHECK(file_name_of("Bézier") == "B%C3%A9zier");
  CHECK(file_name_of("") != "");
  for (const char* device : {"con", "AUX", "nul.1", "Com3", "lpt9.x"}) CHECK(file_name_of(device)[0] == '%');
  for (const char* plain : {"conny", "com", "com10", "x.con"}) CHECK(file_name_of(plain) == plain);
  CHECK(file_name_of("aux.json") == "%61ux.json");
  const std::string one = file_name_of(std::string(300, 'x') + "1"), two = file_name_of(std::string(300, 'x') + "2");
  CHECK(one.size() <= 200);
  CHECK(one != two);
}
