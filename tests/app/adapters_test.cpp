// The folders of grader/adapters, run as Gradescope, PrairieLearn and Autolab run them: their folders, files and exit
// statuses, with submissions that mean well and others.

#include <sys/stat.h>

#include <algorithm>

#include "app/program.hpp"
#include "base/json.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

const fs::path adapters = fs::path(BLOSSOM_SOURCE_DIR) / "grader/adapters";
const fs::path exercise = fs::path(BLOSSOM_SOURCE_DIR) / "exercises/22-de-boor.json";
const fs::path demo = fs::path(BLOSSOM_SOURCE_DIR) / "exercises/demo-class";

JsonDocument json_file(const fs::path& path) {
  auto document = JsonDocument::load(path);
  INFO(to_string(document.diagnostics));
  REQUIRE(document);
  return std::move(*document);
}

double number(const Json& object, const std::string& key) {
  const Json* found = object.find(key);
  INFO(key);
  REQUIRE(found != nullptr);
  REQUIRE(found->kind == Json::Kind::number);
  return Exact::parse(found->text)->to_double();
}

std::string text(const Json& object, const std::string& key) {
  const Json* found = object.find(key);
  INFO(key);
  REQUIRE(found != nullptr);
  REQUIRE(found->kind == Json::Kind::string);
  return found->text;
}

void write(const fs::path& path, const std::string& content) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
}

void write_program(const fs::path& path, const std::string& script) {
  fs::remove(path);
  write(path, script);
  REQUIRE(chmod(path.c_str(), 0755) == 0);
}

// What a student may hand in, and must not harm.
struct Hostile {
  const char* name;
  void (*hand_in)(const fs::path& folder);
};
const Hostile hostile[] = {
    {"nothing", [](const fs::path&) {}},
    {"a link to /etc/passwd", [](const fs::path& f) { fs::create_symlink("/etc/passwd", f / "answers.json"); }},
    {"a link to itself", [](const fs::path& f) { fs::create_symlink(f / "answers.json", f / "answers.json"); }},
    {"a link to a folder", [](const fs::path& f) { fs::create_directory_symlink("/etc", f / "answers.json"); }},
    {"10 MB", [](const fs::path& f) { write(f / "answers.json", std::string(10u << 20, '[')); }},
    {"no JSON", [](const fs::path& f) { write(f / "answers.json", "root:x:0:0\n<script>alert(1)</script>"); }},
    {"another type of file", [](const fs::path& f) { write(f / "answers.txt", "{}"); }},
    {"a pipe", [](const fs::path& f) { REQUIRE(mkfifo((f / "answers.json").c_str(), 0600) == 0); }},
    {"a name with a line break", [](const fs::path& f) { write(f / "a\n{\"scores\": {\"de-boor\": 99}}.json", "{"); }},
};

// Gradescope's file hierarchy: the zip file in source/, run_autograder copied beside it.
class Gradescope {
 public:
  Gradescope() {
    for (const char* folder : {"source/course", "submission", "results"}) fs::create_directories(root() / folder);
    for (const char* file : {"setup.sh", "run_autograder"})
      fs::copy_file(adapters / "gradescope" / file, root() / "source" / file);
    fs::copy_file(fs::path(BLOSSOM_BIN_DIR) / "blossom-grade", root() / "source/blossom-grade");
    fs::copy_file(exercise, root() / "source/course/assignment.json");
    fs::copy_file(root() / "source/run_autograder", root() / "run_autograder");
    metadata("2026-10-01T12:00:00.123456-07:00");
  }

  fs::path root() const { return scratch_.path(); }
  Ended set_up() const { return run("bash", {(root() / "source/setup.sh").string()}); }
  Ended grade() const { return run((root() / "run_autograder").string(), {}); }
  JsonDocument results() const { return json_file(root() / "results/results.json"); }

  void metadata(const std::string& created_at) const {
    write(root() / "submission_metadata.json", R"({"id": 1, "created_at": ")" + created_at + R"(",
              "assignment": {"due_date": "2026-10-01T00:00:00.000000-07:00", "id": 2, "total_points": "11.0"},
              "users": [{"email": "ada@example.edu", "id": 1234, "name": "Ada",
                         "assignment": {"due_date": "2026-10-01T06:00:00.000000-07:00"}}],
              "previous_submissions": []})");
  }

 private:
  Ended run(const std::string& program, std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"BLOSSOM_AUTOGRADER=" + scratch_.path(), "BLOSSOM_SECONDS=20", program});
    return run_program("/usr/bin/env", arguments, {.folder = scratch_.path()});
  }

  Scratch scratch_;
};

}  // namespace

TEST_CASE("Gradescope: set up, then a submission is graded into results.json") {
  const Gradescope gradescope;
  const auto set_up = gradescope.set_up();
  SHOW(set_up);
  REQUIRE(set_up.status == 0);
  fs::copy_file(demo / "early-slip.json", gradescope.root() / "submission/early-slip.json");
  const auto ended = gradescope.grade();
  SHOW(ended);
  CHECK(ended.status == 0);
  const auto results = gradescope.results();
  CHECK(number(results.root(), "score") == 10);
  const auto& tests = results.root().find("tests")->items;
  REQUIRE(tests.size() == 10);
  CHECK(std::ranges::count_if(tests, [](const Json& test) { return text(test, "status") == "passed"; }) == 9);
  // Once more: the same bytes.
  const std::string before = read_all(gradescope.root() / "results/results.json");
  CHECK(gradescope.grade().status == 0);
  CHECK(read_all(gradescope.root() / "results/results.json") == before);
}

TEST_CASE("Gradescope: the time and the student's own date come from the metadata") {
  const Gradescope gradescope;
  const auto assignment = gradescope.root() / "source/course/assignment.json";
  fs::rename(assignment, gradescope.root() / "source/course/de-boor.json");
  write(assignment, R"({"schema": "blossom.assignment/1", "id": "hw", "title": "Homework",
    "exercises": [{"file": "de-boor.json", "points": 20}], "due": "2030-01-01T00:00:00Z", "late": {"per_day": "1/4"}})");
  fs::copy_file(demo / "perfect.json", gradescope.root() / "submission/perfect.json");
  const auto score_at = [&](const std::string& created_at) {
    gradescope.metadata(created_at);
    const auto ended = gradescope.grade();
    SHOW(ended);
    CHECK(ended.status == 0);
    return number(gradescope.results().root(), "score");
  };
  CHECK(score_at("2026-10-01T05:59:59.000000-07:00") == 20);
  CHECK(score_at("2026-10-01T12:00:00.000000-07:00") == 15);
  CHECK(score_at("2026-10-02T12:00:00.000000-07:00") == 10);
}

TEST_CASE("Gradescope: hostile submissions get a score of 0, and nothing that is not theirs") {
  for (const Hostile& each : hostile) {
    INFO(each.name);
    const Gradescope gradescope;
    each.hand_in(gradescope.root() / "submission");
    const auto ended = gradescope.grade();
    SHOW(ended);
    CHECK(ended.status == 0);
    const auto results = gradescope.results();
    CHECK(number(results.root(), "score") == 0);
    CHECK_FALSE(text(results.root(), "output").empty());
    CHECK_FALSE(contains(results.text(), "root:x:0:0:"));  // of /etc/passwd
    CHECK_FALSE(contains(results.text(), "The grader failed"));
    CHECK(results.text().size() < 1u << 16);
  }
}

TEST_CASE("Gradescope: when the grader fails, results.json says so") {
  const Gradescope gradescope;
  fs::copy_file(demo / "perfect.json", gradescope.root() / "submission/perfect.json");
  const auto fails = [&] {
    const auto ended = gradescope.grade();
    SHOW(ended);
    CHECK(ended.status == 0);
    const auto results = gradescope.results();
    CHECK(number(results.root(), "score") == 0);
    CHECK(contains(text(results.root(), "output"), "The grader failed"));
    CHECK(results.root().find("tests")->items.empty());
  };
  SECTION("it ends early") { write_program(gradescope.root() / "source/blossom-grade", "#!/bin/sh\nexit 3\n"); }
  SECTION("it is killed") { write_program(gradescope.root() / "source/blossom-grade", "#!/bin/sh\nkill -9 $$\n"); }
  SECTION("it is not there") { fs::remove(gradescope.root() / "source/blossom-grade"); }
  SECTION("the assignment has mistakes") { write(gradescope.root() / "source/course/assignment.json", "{}"); }
  SECTION("the metadata has another form") { write(gradescope.root() / "submission_metadata.json", "[]"); }
  SECTION("an old result is left over") {
    write(gradescope.root() / "results/results.json", "{\"score\": 11, \"output\": \"\", \"tests\": [1]}");
    fs::remove(gradescope.root() / "source/blossom-grade");
  }
  fails();
}

TEST_CASE("Gradescope: an assignment with mistakes, or no program, fails when the image is made") {
  const Gradescope gradescope;
  const auto fails = [&](const std::string& why) {
    const auto ended = gradescope.set_up();
    SHOW(ended);
    CHECK(ended.status != 0);
    CHECK(contains(ended.err, why));
  };
  SECTION("mistakes") {
    write(gradescope.root() / "source/course/assignment.json", "{\"schema\": \"blossom.exercise/1\"}");
    fails("assignment.json");
  }
  SECTION("no program") {
    fs::remove(gradescope.root() / "source/blossom-grade");
    fails("neither blossom-grade nor blossom/ is in the zip file");
  }
}

namespace {

// The grading container: no results folder yet, the course's and the question's files in place.
class PrairieLearn {
 public:
  PrairieLearn() {
    for (const char* folder : {"student", "data", "serverFilesCourse"}) fs::create_directories(root() / folder);
    fs::copy(adapters / "prairielearn/questions/de-boor/tests", root() / "tests", fs::copy_options::recursive);
    fs::copy(adapters / "prairielearn/serverFilesCourse/blossom", root() / "serverFilesCourse/blossom",
             fs::copy_options::recursive);
    fs::copy_file(fs::path(BLOSSOM_BIN_DIR) / "blossom-grade", program());
    write(root() / "data/data.json", "{\"variant_seed\": \"1\"}");
  }

  fs::path root() const { return scratch_.path(); }
  fs::path program() const { return root() / "serverFilesCourse/blossom/blossom-grade"; }
  Ended grade() const {
    return run_program("/usr/bin/env", {"BLOSSOM_GRADE_ROOT=" + scratch_.path(), "BLOSSOM_SECONDS=20",
                                        (root() / "serverFilesCourse/blossom/run.sh").string()});
  }
  JsonDocument results() const { return json_file(root() / "results/results.json"); }

 private:
  Scratch scratch_;
};

}  // namespace

TEST_CASE("PrairieLearn: the question's folder is complete, and asks what its exercise asks") {
  const fs::path question = adapters / "prairielearn/questions/de-boor";
  const auto info = json_file(question / "info.json");
  for (const char* key : {"uuid", "title", "topic", "type"}) CHECK_FALSE(text(info.root(), key).empty());
  CHECK(text(info.root(), "gradingMethod") == "External");
  const Json* options = info.root().find("externalGradingOptions");
  REQUIRE(options != nullptr);
  CHECK(options->find("enabled")->boolean);
  CHECK(text(*options, "entrypoint") == "/grade/serverFilesCourse/blossom/run.sh");
  CHECK(options->find("serverFilesCourse")->items.at(0).text == "blossom/");
  const std::string html = read_all(question / "question.html");
  for (const char* element : {"<pl-file-editor file-name=\"answers.json\"", "<pl-external-grader-results>"})
    CHECK(contains(html, element));
  CHECK(read_all(question / "tests/assignment.json") == read_all(exercise));
  // The template has just the names that are right answers to the exercise.
  const auto answers = json_file(question / "answers.json"), perfect = json_file(demo / "perfect.json");
  CHECK(answers.root().find("answers")->keys == perfect.root().find("answers")->keys);
}

TEST_CASE("PrairieLearn: a submission is graded into results.json, whose folder is made") {
  const PrairieLearn prairielearn;
  fs::copy_file(demo / "early-slip.json", prairielearn.root() / "student/answers.json");
  const auto ended = prairielearn.grade();
  SHOW(ended);
  CHECK(ended.status == 0);
  const auto results = prairielearn.results();
  CHECK(results.root().find("gradable")->boolean);
  CHECK(number(results.root(), "score") == Approx(10.0 / 11));
  CHECK(results.root().find("tests")->items.size() == 10);
}

TEST_CASE("PrairieLearn: hostile submissions are not gradable, and it is said why") {
  for (const Hostile& each : hostile) {
    INFO(each.name);
    const PrairieLearn prairielearn;
    each.hand_in(prairielearn.root() / "student");
    const auto ended = prairielearn.grade();
    SHOW(ended);
    CHECK(ended.status == 0);
    const auto results = prairielearn.results();
    CHECK_FALSE(results.root().find("gradable")->boolean);
    REQUIRE_FALSE(results.root().find("format_errors")->items.empty());
    CHECK_FALSE(contains(results.text(), "The grader failed"));
    CHECK_FALSE(contains(results.text(), "root:x:0:0:"));
    CHECK(results.text().size() < 1u << 16);
  }
}

TEST_CASE("PrairieLearn: when the grader fails the submission is not gradable, and the job ends well") {
  const PrairieLearn prairielearn;
  fs::copy_file(demo / "perfect.json", prairielearn.root() / "student/answers.json");
  SECTION("it ends early") { write_program(prairielearn.program(), "#!/bin/sh\nexit 3\n"); }
  SECTION("the exercise has mistakes") { write(prairielearn.root() / "tests/assignment.json", "{}"); }
  const auto ended = prairielearn.grade();
  SHOW(ended);
  CHECK(ended.status == 0);
  const auto results = prairielearn.results();
  CHECK_FALSE(results.root().find("gradable")->boolean);
  CHECK(contains(results.root().find("format_errors")->items.at(0).text, "The grader failed"));
}

TEST_CASE("Autolab: make in an instance of the three files ends in the autoresult") {
  const Scratch packed, instance;
  fs::create_directories(packed / "course");
  fs::copy_file(exercise, packed / "course/assignment.json");
  fs::copy_file(fs::path(BLOSSOM_BIN_DIR) / "blossom-grade", packed / "blossom-grade");
  REQUIRE(
      run_program("/bin/tar", {"cf", instance / "autograde.tar", "blossom-grade", "course"}, {.folder = packed.path()})
          .status == 0);
  fs::copy_file(adapters / "autolab/autograde-Makefile", instance / "Makefile");
  fs::copy_file(demo / "early-slip.json", instance / "answers.json");
  const auto ended = run_program("/usr/bin/make", {}, {.folder = instance.path()});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(ended.out.starts_with("autolab: 90.9 % (10/11 points) in de-boor\n"));
  CHECK(ended.out.ends_with("\n{\"scores\":{\"de-boor\":10},\"scoreboard\":[10,10]}\n"));
  // What cannot be read has a score, too, though the program ends with 1.
  std::ofstream(instance / "answers.json") << "{";
  const auto unreadable = run_program("/usr/bin/make", {}, {.folder = instance.path()});
  SHOW(unreadable);
  CHECK(unreadable.out.ends_with("\n{\"scores\":{\"de-boor\":0},\"scoreboard\":[0,0]}\n"));
}
