#include "grader/batch/regrade.hpp"

#include <algorithm>

#include "classes.hpp"
#include "grader/batch/revision.hpp"

using namespace blossom;

namespace {

struct Again {
  explicit Again(const std::string& lines) : submissions(scratch.write("class.jsonl", lines)) {}

  void grade(const std::string& out, const std::string& course) {
    scratch.write("course.json", course);
    auto options = class_options(scratch, submissions, out);
    options.student_files = false;
    grade_class(options);
  }

  // "student exercise part: was -> now (why)" of each.
  std::vector<std::string> changes() {
    std::vector<std::string> lines;
    const auto found = find_changes(scratch / "old", scratch / "new", [&](const Change& change) {
      lines.push_back(change.student + " " + change.exercise + " " + change.part + ": " + change.was + " -> " +
                      change.now + (change.why.empty() ? "" : " (" + change.why + ")"));
    });
    INFO(to_string(found.diagnostics));
    REQUIRE(found);
    summary = *found;
    return lines;
  }

  Scratch scratch;
  std::string submissions;
  Changes summary;
};

using Lines = std::vector<std::string>;

const std::string near = "[0.4005, 1.2]";

std::string three_students() {
  return line_of_class("s1", small_answers("a", right_value)) + line_of_class("s2", small_answers("a", near)) +
         line_of_class("s3", small_answers("a", "[7, 8]"));
}

}  // namespace

TEST_CASE("grading the same again changes nothing") {
  Again again(three_students());
  again.grade("old", small_course());
  again.grade("new", small_course());
  CHECK(again.changes().empty());
  CHECK(again.summary.students == 3);
  CHECK(again.summary.better + again.summary.worse + again.summary.otherwise == 0);
  CHECK(again.summary.mean_was == again.summary.mean_now);
}

TEST_CASE("a tolerance that is relaxed changes who was near, and says so") {
  Again again(three_students());
  again.grade("old", small_course());
  again.grade("new", small_course("", R"("points": 1, "tolerance": {"absolute": 0.001})"));
  const auto changes = again.changes();
  REQUIRE(changes.size() == 3);
  CHECK(changes[0] == "s2  : 0 of 10 -> 4 of 10");
  CHECK(changes[1] == "s2 a : 0 of 4 -> 4 of 4 (its values below)");
  CHECK(changes[2].find("s2 a P[1][0]: ") == 0);
  CHECK(changes[2].find("-> correct, 1 of 1 (tolerance exact -> 0.001)") != std::string::npos);
  CHECK(again.summary.better == 1);
  CHECK(again.summary.mean_was == Approx(4.0 / 30));
  CHECK(again.summary.mean_now == Approx(8.0 / 30));
}

TEST_CASE("a part's points scale nothing where it is the only one, and are told") {
  Again again(three_students());
  again.grade("old", small_course());
  again.grade("new", small_course("", R"("points": 2)"));
  const auto changes = again.changes();
  CHECK(std::ranges::count(changes, "s1  : 4 of 10 -> 4 of 10") == 1);
  CHECK(std::ranges::count(changes, "s1 a P[1][0]: correct, 1 of 1 -> correct, 2 of 2 (points 1 -> 2)") == 1);
  CHECK(again.summary.otherwise == 3);
}

TEST_CASE("another date changes what is late, and only that") {
  Again again(line_of_class("s1", small_answers("a", right_value), R"(, "submitted": "2026-10-02T00:00:00Z")") +
              line_of_class("s2", small_answers("a", right_value), R"(, "submitted": "2026-09-02T00:00:00Z")"));
  const auto course = [](const std::string& due) {
    return small_course(R"(, "late": {"per_day": 0.5}, "due": ")" + due + "\"");
  };
  again.grade("old", course("2026-10-01T12:00:00Z"));
  again.grade("new", course("2026-10-03T12:00:00Z"));
  CHECK(again.changes() == Lines{"s1  : 2 of 10 -> 4 of 10",
                                 "s1 a : 2 of 4 -> 4 of 4 (due 2026-10-01T12:00:00Z -> 2026-10-03T12:00:00Z)"});
}

TEST_CASE("where another submission counts, that is why; who has come and gone is told") {
  Again again(three_students());
  again.grade("old", small_course());
  again.scratch.write("class.jsonl", line_of_class("s0", small_answers("b", right_value)) +
                                         line_of_class("s3", small_answers("a", right_value)) +
                                         line_of_class("s1", small_answers("a", right_value)));
  again.grade("new", small_course());
  const auto changes = again.changes();
  REQUIRE(changes.size() == 5);
  CHECK(changes[0] == "s0  :  -> 6 of 10 (not among the old results)");
  CHECK(changes[1] == "s3  : 0 of 10 -> 4 of 10");
  CHECK(changes[2] == "s3 a : 0 of 4 -> 4 of 4 (its values below; another submission counts)");
  CHECK(changes[3] == "s3 a P[1][0]: wrong, 0 of 1 -> correct, 1 of 1 (another submission counts)");
  CHECK(changes[4] == "s2  : 0 of 10 ->  (not among the new results)");
  CHECK(again.summary.come == 1);
  CHECK(again.summary.gone == 1);
  CHECK(again.summary.better == 1);
}

TEST_CASE("all that differs between two versions of a part is named") {
  const auto course = [](const std::string& more, const std::string& ask) {
    auto document = JsonDocument::parse("course.json", small_course(more, ask));
    REQUIRE(document);
    auto assignment = read_assignment(*document);
    INFO(to_string(assignment.diagnostics));
    REQUIRE(assignment);
    return std::move(*assignment);
  };
  const Revision revision(course("", R"("points": 1)"),
                          course(R"(, "attempts": "best")", R"("points": 3, "tolerance": {"decimals": 2})"));
  CHECK(revision.of_part("a", "P[1][0]") == "points 1 -> 3; tolerance exact -> 2 decimals");
  CHECK(revision.of_part("b", "P[1][0]").empty());
  CHECK(revision.of_attempts() == "attempts last -> best");
  CHECK(revision.of_lateness().empty());
  CHECK(revision.touches("a"));
  CHECK(!revision.touches("b"));
}

TEST_CASE("where a part is voided, that alone is why") {
  Again again(three_students());
  again.grade("old", small_course());
  again.grade("new", small_course("", R"("points": 1, "tolerance": {"decimals": 2}, "void": "credit")"));
  const auto changes = again.changes();
  REQUIRE(changes.size() > 2);
  CHECK(changes[2].ends_with("(voided: everybody whose answers could be read gets its points)"));
}

TEST_CASE("another secret than that of the old results is told where numbers are students' own") {
  const Scratch scratch;
  const std::string varied = "exercises/11-own-de-casteljau.json";
  auto options = class_options(scratch, scratch.write("class.jsonl", line_of_class("s1", "{}")), "old");
  options.assignment = varied;
  options.secret = scratch.write("secret", "the secret of this course, long enough");
  grade_class(options);
  CHECK(other_secret(scratch / "old", options).empty());
  options.secret = scratch.write("other", "the secret of another course, as long");
  CHECK(to_string(other_secret(scratch / "old", options)).find("is not the secret of") != std::string::npos);
  scratch.write("course.json", small_course());
  options.assignment = scratch / "course.json";  // nothing varies: any secret will do
  CHECK(other_secret(scratch / "old", options).empty());
}

TEST_CASE("who comes onto the roster later is found by any name that was handed in under") {
  const Scratch scratch;
  scratch.write("course.json", small_course());
  std::filesystem::create_directories(scratch / "class");
  scratch.write("class/bobb_17_99_answers.json", small_answers("a", right_value));
  auto options = class_options(scratch, scratch / "class", "old");
  options.roster = scratch.write("roster.csv", "id,name,lms id\nz,Zoe,5\n");
  CHECK(grade_class(options).mean_score == 0);
  options.submissions = scratch / "old/submissions.jsonl";
  options.out = scratch / "new";
  options.roster = scratch.write("later.csv", "id,name,lms id\nb,Bob,17\n");
  CHECK(grade_class(options).mean_score == Approx(0.4));
}

TEST_CASE("changes are rows that a spreadsheet reads and does not run") {
  std::string rows = change_header();
  write_change({"=x", "a", "P[1][0]", "wrong, 0 of 1", "correct, 1 of 1", "tolerance"}, rows);
  CHECK(rows ==
        "student,exercise,part,was,now,why\r\n'=x,a,P[1][0],\"wrong, 0 of 1\",\"correct, 1 of 1\",tolerance\r\n");
}
