// `blossom new`, `blossom list` by units, and what `blossom lint` finds in a course.

#include <algorithm>

#include "app/program.hpp"
#include "lesson/catalog.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

// A first-year instructor's own folder: no lessons are found around it.
Ended in_folder(const std::string& folder, std::vector<std::string> arguments) {
  return run_program("blossom", std::move(arguments), {.folder = folder});
}

std::string small_lesson(const std::string& id, const std::string& more = {}) {
  return R"({"schema": "blossom.lesson/1", "id": ")" + id + "\",\n\"title\": \"About " + id + "\", " + more +
         R"("algorithm": "de_casteljau",
"inputs": {"curve": {"degree": 1, "points": [[0, 0], [2, 4]]}, "u": "1/4"},
"beats": [{"at": "C", "say": "{C}"}]})";
}

}  // namespace

TEST_CASE("new writes a lesson and an exercise about every algorithm, and they are in order") {
  const Scratch scratch;
  for (const std::string& id : algorithm_ids())
    for (const std::string what : {"lesson", "exercise"}) {
      const std::string file = scratch / (what + "-" + id + ".json");
      const auto ended = blossom::test::blossom({"new", what, "--algorithm", id, "--out", file});
      SHOW(ended);
      CHECK(ended.status == 0);
      CHECK(contains(ended.out, "Written: "));
      CHECK(contains(ended.out, "blossom lint " + file));
    }
  const auto linted = blossom::test::blossom({"lint", scratch.path()});
  SHOW(linted);
  CHECK(linted.status == 0);
  CHECK(linted.out == std::to_string(2 * algorithm_ids().size()) + " files are in order\n");
}

#if BLOSSOM_PLAYER
TEST_CASE("what new writes can be drawn, for every algorithm") {
  const Scratch scratch;
  for (const std::string& id : algorithm_ids()) {
    const std::string file = scratch / (id + ".json");
    REQUIRE(blossom::test::blossom({"new", "lesson", "--algorithm", id, "--out", file}).status == 0);
    const auto ended = blossom::test::blossom({"render", file, "--svg", "--out", scratch / "pictures"});
    SHOW(ended);
    CHECK(ended.status == 0);
  }
  const auto pictures = std::distance(fs::directory_iterator(scratch / "pictures"), fs::directory_iterator());
  CHECK(static_cast<std::size_t>(pictures) == algorithm_ids().size());
}
#endif

TEST_CASE("a start can be traced and graded at once") {
  const Scratch scratch;
  const std::string lesson = scratch / "05-my-own.json";
  REQUIRE(blossom::test::blossom({"new", "lesson", "--algorithm", "de_boor", "--out", lesson}).status == 0);
  CHECK(contains(read_all(lesson), "\"id\": \"my-own\""));
  CHECK(blossom::test::blossom({"trace", lesson}).status == 0);
  const auto answers = scratch.write(
      "a.json", R"({"schema": "blossom.answers/1", "exercise": "my-own", "answers": {"first-question": 1000}})");
  const auto graded = run_program("blossom-grade", {lesson, answers, "--format", "json"});
  SHOW(graded);
  CHECK(graded.status == 0);
  CHECK(contains(graded.out, R"("exercise":"my-own")"));
  CHECK(contains(graded.out, R"({"value":"first-question","verdict":)"));
}

TEST_CASE("new never writes over a file, unless it is told to") {
  const Scratch scratch;
  const std::string file = scratch.write("mine.json", "mine");
  const std::vector<std::string> arguments{"new", "lesson", "--algorithm", "de_casteljau", "--out", file};
  const auto refused = blossom::test::blossom(arguments);
  SHOW(refused);
  CHECK(refused.status == 1);
  CHECK(contains(refused.err, "is there already; --force writes over it"));
  CHECK(read_all(file) == "mine");
  auto forced = arguments;
  forced.push_back("--force");
  CHECK(blossom::test::blossom(forced).status == 0);
  CHECK(read_all(file) != "mine");
}

TEST_CASE("without --out the file is named after the algorithm; - is standard output") {
  const Scratch scratch;
  CHECK(in_folder(scratch.path(), {"new", "lesson", "--algorithm", "knot_insertion"}).status == 0);
  CHECK(in_folder(scratch.path(), {"new", "exercise", "--algorithm", "knot_insertion"}).status == 0);
  CHECK(
      blossom::test::blossom({"lint", scratch / "my-knot-insertion.json", scratch / "my-knot-insertion-exercise.json"})
          .status == 0);
  const auto shown =
      in_folder(scratch.path(), {"new", "lesson", "--algorithm", "ruled", "--out", "-", "--language", "de"});
  SHOW(shown);
  CHECK(shown.status == 0);
  CHECK(contains(shown.out, "\"language\": \"de\""));
  CHECK(shown.out.starts_with("{\n  \"$comment\": "));
}

TEST_CASE("the id that new gives is made of the file's name, in letters that an id may have") {
  const Scratch scratch;
  for (const auto& [name, id] : std::vector<std::pair<std::string, std::string>>{
           {"Übung 1.json", "uebung-1"}, {"07-Élève_ß.json", "eleve-ss"}, {"曲線.json", "my-lesson"}}) {
    const std::string file = scratch / name;
    CHECK(blossom::test::blossom({"new", "lesson", "--algorithm", "ruled", "--out", file}).status == 0);
    CHECK(contains(read_all(file), "\"id\": \"" + id + "\""));
  }
}

// ---- describe -------------------------------------------------------------------------------------------------------

TEST_CASE("describe tells the inputs, names, phases, asks and misconceptions of every algorithm") {
  for (const Algorithm* algorithm : algorithms()) {
    const auto ended = blossom::test::blossom({"describe", std::string(algorithm->id)});
    SHOW(ended);
    CHECK(ended.status == 0);
    CHECK(ended.err.empty());
    for (const InputSpec& input : algorithm->inputs)
      CHECK(contains(ended.out, "\n  \"" + std::string(input.name) + "\": "));
    for (const std::string_view ask : algorithm->asks) CHECK(contains(ended.out, "\"" + std::string(ask) + "\""));
    for (const Misconception& known : algorithm->misconceptions)
      CHECK(contains(ended.out, "\n  " + std::string(known.id) + ": "));
  }
  const auto ended = blossom::test::blossom({"describe", "de_casteljau"});
  CHECK(contains(ended.out, "\n  P[0][0..3], P[1][0..2], P[2][0..1], P[3][0]: the point i of level r"));
  CHECK(contains(ended.out, "such as P[1][0] = (1 - u) P[0][0] + u P[0][1] = "));
  const auto mistyped = blossom::test::blossom({"describe", "de_bor"});
  CHECK(mistyped.status == 2);
  CHECK(contains(mistyped.err, "did you mean \"de_boor\"?"));
}

TEST_CASE("what new cannot make is wrong usage, with what may be meant") {
  const auto mistyped = blossom::test::blossom({"new", "lesson", "--algorithm", "de_bor"});
  SHOW(mistyped);
  CHECK(mistyped.status == 2);
  CHECK(contains(mistyped.err, "did you mean \"de_boor\"?"));
  CHECK(blossom::test::blossom({"new", "course", "--algorithm", "de_boor"}).status == 2);
  CHECK(blossom::test::blossom({"new", "lesson"}).status == 2);
  CHECK(blossom::test::blossom({"new", "lesson", "--algorithm", "de_boor", "--language", "English"}).status == 2);
}

// ---- list -----------------------------------------------------------------------------------------------------------

TEST_CASE("list goes by units, in the order of the course") {
  const Scratch scratch;
  scratch.write("1.json",
                small_lesson("one", "\"unit\": \"First unit\", \"minutes\": 50, \"exercises\": [\"x\", \"y\"], "));
  scratch.write("2.json", small_lesson("two", "\"unit\": \"Second unit\", \"exercises\": [\"x\"], "));
  scratch.write("3.json", small_lesson("three", "\"unit\": \"First unit\", \"minutes\": 25, "));
  scratch.write("4.json", small_lesson("four"));
  const auto ended = blossom::test::blossom({"list", "--lessons", scratch.path()});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(contains(ended.out,
                 "\nFirst unit (2 lessons, 1 h 15 min)\n  1  About one    50 min  2 exercises\n"
                 "  3  About three  25 min\n"));
  CHECK(contains(ended.out, "\nSecond unit (1 lesson)\n  2  About two    1 exercise\n"));
  CHECK(contains(ended.out, "\nOf no unit (1 lesson)\n"));
  CHECK(ended.out.find("First unit") < ended.out.find("Second unit"));

  const auto one = blossom::test::blossom({"list", "--lessons", scratch.path(), "--unit", "second"});
  SHOW(one);
  CHECK(contains(one.out, "Second unit"));
  CHECK_FALSE(contains(one.out, "First unit"));
  CHECK_FALSE(contains(one.out, "Algorithms"));
  const auto none = blossom::test::blossom({"list", "--lessons", scratch.path(), "--unit", "Thrid unit"});
  SHOW(none);
  CHECK(none.status == 2);
  CHECK(contains(none.err, "there is no unit \"Thrid unit\""));
}

TEST_CASE("list for programs is JSON") {
  const auto ended = blossom::test::blossom({"list", "--format", "json"});
  SHOW(ended);
  CHECK(ended.status == 0);
  const auto document = JsonDocument::parse("list", ended.out);
  REQUIRE(document);
  const Json* lessons = document->root().find("lessons");
  REQUIRE(lessons != nullptr);
  const Catalog catalog = load_catalog("lessons");
  REQUIRE(lessons->items.size() == catalog.lessons.size());
  for (std::size_t i = 0; i < catalog.lessons.size(); ++i) {
    CHECK(lessons->items[i].find("id")->text == catalog.lessons[i].lesson.id);
    CHECK(lessons->items[i].find("unit")->text == catalog.lessons[i].lesson.unit.own());
    CHECK(lessons->items[i].find("exercises")->items.size() == catalog.lessons[i].lesson.exercises.size());
  }
  CHECK(document->root().find("algorithms")->items.size() == algorithms().size());
}

// ---- lint -----------------------------------------------------------------------------------------------------------

TEST_CASE("lint finds what is wrong between the files of a course, in the order of the files") {
  const Scratch scratch;
  fs::create_directory(scratch / "lessons");
  fs::create_directory(scratch / "exercises");
  scratch.write("lessons/1.json", small_lesson("one", "\"prerequisites\": [\"two\"], "));
  scratch.write("lessons/2.json",
                small_lesson("two", "\"prerequisites\": [\"one\", \"oen\"], \"exercises\": [\"x\"], "));
  scratch.write("lessons/3.json", small_lesson("three", "\"colors\": {\"curve\": \"#ffffff\"}, "));
  scratch.write("lessons/4.json",
                R"({"schema": "blossom.lesson/1", "id": "four", "title": "T", "algorithm": "de_casteljau",
"inputs": {"curve": {"degree": 1, "points": [[0, 0], [2, 4]]}, "u": "1/4"},
"beats": [{"at": "C", "say": "{C}", "sliders": [{"input": "u", "from": 0,
"to": 2}]}]})");
  const auto ended = blossom::test::blossom({"lint", scratch / "lessons"});
  SHOW(ended);
  CHECK(ended.status == 1);
  CHECK(ended.out == "6 mistakes in 4 files\n");
  const std::string folder = scratch / "lessons/";
  const std::vector<std::string> told{
      folder +
          "1.json:2:41: prerequisites[0]: prerequisites go in a circle: \"one\" needs \"two\", which needs \"one\"",
      folder +
          "2.json:2:41: prerequisites[0]: prerequisites go in a circle: \"two\" needs \"one\", which needs \"two\"",
      folder +
          "2.json:2:48: prerequisites[1]: no lesson beside this file or in the course has the id \"oen\"; did you mean "
          "\"one\"?",
      folder +
          "2.json:2:70: exercises[0]: no exercise beside this file, in ../exercises or in the course has the id \"x\"",
      folder + "3.json:2:45: colors.curve: has too little contrast: 1.0:1",
      folder + "4.json:4:7: beats[0].sliders[0].to: with u = 2 the inputs are not valid: u: "};
  std::istringstream in(ended.err);
  for (const std::string& expected : told) {
    std::string line;
    REQUIRE(std::getline(in, line));
    CHECK_THAT(line, Catch::StartsWith(expected));
  }
}

TEST_CASE("lint of answers to a lesson's checkpoints knows its questions") {
  const Scratch scratch;
  fs::create_directory(scratch / "lessons");
  scratch.write("lessons/1.json",
                R"({"schema": "blossom.lesson/1", "id": "asking", "title": "T", "algorithm": "de_casteljau",
"inputs": {"curve": {"degree": 1, "points": [[0, 0], [2, 4]]}, "u": "1/4"},
"beats": [{"at": "start", "say": "Look.", "checkpoint": {"id": "why", "kind": "choice", "ask": "?",
  "choices": [{"text": "a", "right": true}, {"text": "b"}]}}]})");
  // An exercise may have the id of a lesson: what is answered tells them apart.
  fs::create_directory(scratch / "exercises");
  scratch.write("exercises/1.json", R"({"schema": "blossom.exercise/1", "id": "asking", "title": "T", "prompt": "P",
"algorithm": "de_casteljau", "inputs": {"curve": {"degree": 1, "points": [[0, 0], [2, 4]]}, "u": "1/4"},
"ask": [{"value": "C", "points": 1}]})");
  scratch.write("point.json", R"({"schema": "blossom.answers/1", "exercise": "asking", "answers": {"C": ["1/2", 1]}})");
  CHECK(in_folder(scratch.path(), {"lint", "point.json"}).status == 0);
  scratch.write("good.json", R"({"schema": "blossom.answers/1", "exercise": "asking", "answers": {"why": "B"}})");
  scratch.write("bad.json",
                R"({"schema": "blossom.answers/1", "exercise": "asking", "answers": {"why": "c", "wy": "a"}})");
  CHECK(in_folder(scratch.path(), {"lint", "good.json"}).status == 0);
  const auto ended = in_folder(scratch.path(), {"lint", "bad.json"});
  SHOW(ended);
  CHECK(ended.status == 1);
  CHECK(contains(ended.err, "bad.json:1:74: answers.why: must be one letter from a to b, not \"c\"\n"));
  CHECK(contains(ended.err, "the exercise does not ask for \"wy\""));
}

TEST_CASE("lint says the same in the same order however often it is asked") {
  const auto once = blossom::test::blossom({"lint"});
  SHOW(once);
  for (int i = 0; i < 3; ++i) {
    const auto again = blossom::test::blossom({"lint"});
    CHECK(again.out == once.out);
    CHECK(again.err == once.err);
  }
}

TEST_CASE("lint of no files checks one's own where there is no course") {
  const Scratch scratch;
  scratch.write("mine.json", small_lesson("mine"));
  scratch.write("other.json", R"({"name": "package", "version": 1})");
  const auto ended = in_folder(scratch.path(), {"lint"});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(ended.out == "1 file is in order\n");
  fs::create_directory(scratch / "lessons");
  fs::create_directory(scratch / "exercises");
  scratch.write("lessons/1.json", small_lesson("one"));
  scratch.write("lessons/2.json", small_lesson("one"));
  scratch.write("exercises/1.json", R"({"schema": "blossom.exercise/1"})");
  const auto course = in_folder(scratch.path(), {"lint", "lessons"});
  SHOW(course);
  CHECK(course.out == "1 file is in order, 1 mistake in 1 other\n");
  CHECK(contains(course.err, "2.json:1:38: id: \"one\" is the id of lessons/1.json already"));
}

TEST_CASE("lint tells the mistakes of an exercise once, also where its assignment is checked, too") {
  const Scratch scratch;
  scratch.write("own.json", R"({"schema": "blossom.exercise/1", "id": "own", "title": "T", "prompt": "# P",
"algorithm": "de_casteljau", "inputs": {"curve": {"degree": 1, "points": [[0, 0], [2, 4]]}, "u": "1/4"},
"ask": [{"value": "D", "points": 1}]})");
  scratch.write("course.json", R"({"schema": "blossom.assignment/1", "id": "a", "title": "T",
"exercises": [{"file": "own.json", "points": 10}]})");
  const auto ended = in_folder(scratch.path(), {"lint", "own.json", "course.json"});
  SHOW(ended);
  CHECK(contains(ended.err, "own.json:1:71: prompt: there are no headings here"));
  CHECK(contains(ended.out, ", 2 mistakes in 1 other\n"));
  CHECK(contains(in_folder(scratch.path(), {"lint", "course.json"}).out, "2 mistakes in 1 file\n"));
}

TEST_CASE("trace says which scene of a lesson it shows, and that there are others") {
  const Scratch scratch;
  const std::string scene = R"("title": "T", "algorithm": "de_casteljau",
"inputs": {"curve": {"degree": 1, "points": [[0, 0], [2, 4]]}, "u": "1/4"}, "beats": [{"at": "C", "say": "{C}"}]})";
  const auto file = scratch.write(
      "two.json", R"({"schema": "blossom.lesson/1", "id": "two", "title": "Two", "scenes": [{"id": "one", )" + scene +
                      R"(, {"id": "other", )" + scene + "]}");
  CHECK(contains(blossom::test::blossom({"trace", file, "--scene", "other"}).out,
                 "Scene 2 of 2: T. --scene NUMBER shows another: 1 (one), 2 (other)\n"));
}
