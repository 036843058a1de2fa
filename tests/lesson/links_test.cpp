// What lessons name in other files, and what sliders make of their inputs.

#include "lesson/links.hpp"

#include "lesson/slider_check.hpp"
#include "lesson_text.hpp"
#include "scratch.hpp"

using namespace blossom;
using namespace blossom::test;
namespace fs = std::filesystem;

namespace {

std::string lesson(const std::string& id, const std::string& more) {
  return R"({"schema": "blossom.lesson/1", "id": ")" + id + R"(", "title": "T",)" + "\n" + more +
         R"("algorithm": "de_casteljau",
"inputs": {"curve": {"degree": 1, "points": [[0, 0], [2, 4]]}, "u": "1/4"}, "beats": [{"at": "C", "say": "{C}"}]})";
}

Diagnostics checked(const std::string& file) {
  const auto document = JsonDocument::load(file);
  REQUIRE(document);
  CourseIndex index;
  index.add(file, *document);
  for (const fs::path& folder : folders_of_exercises(file)) index.add_folder(folder);
  Diagnostics found = check_links(*document, index);
  for (Diagnostic& diagnostic : found) diagnostic.file = fs::path(diagnostic.file).filename().string();
  return found;
}

}  // namespace

TEST_CASE("prerequisites and exercises that no file has are named, with what may be meant") {
  const Scratch folder;
  fs::create_directory(folder / "lessons");
  fs::create_directory(folder / "exercises");
  folder.write("lessons/01-a.json", lesson("first-steps", ""));
  folder.write("lessons/02-b.json",
               lesson("b",
                      "\"prerequisites\": [\"first-steps\", \"first-step\", \"nothing-like-it\"],\n"
                      "\"exercises\": [\"by-hand\", \"beside\", \"by-hnd\"],\n"));
  folder.write("exercises/1.json", R"({"schema": "blossom.exercise/1", "id": "by-hand"})");
  folder.write("lessons/x.json", R"({"schema": "blossom.exercise/1", "id": "beside"})");
  folder.write("lessons/broken.json", "{");
  CHECK(to_string(checked(folder / "lessons/02-b.json")) ==
        "02-b.json:2:34: prerequisites[1]: no lesson beside this file or in the course has the id \"first-step\"; did "
        "you mean "
        "\"first-steps\"?\n"
        "02-b.json:2:48: prerequisites[2]: no lesson beside this file or in the course has the id \"nothing-like-it\"\n"
        "02-b.json:3:36: exercises[2]: no exercise beside this file, in ../exercises or in the course has the id "
        "\"by-hnd\"; did you "
        "mean \"by-hand\"?\n");
  CHECK(checked(folder / "lessons/01-a.json").empty());
}

TEST_CASE("prerequisites that go in a circle are told in each lesson of it, and in no other") {
  const Scratch folder;
  const auto needing = [](const std::string& id, const std::string& others) {
    return lesson(id, "\"prerequisites\": [" + others + "],\n");
  };
  folder.write("a.json", needing("a", "\"c\""));
  folder.write("b.json", needing("b", "\"a\""));
  folder.write("c.json", needing("c", "\"d\", \"b\""));
  folder.write("d.json", lesson("d", ""));
  folder.write("e.json", needing("e", "\"a\""));
  CHECK(
      to_string(checked(folder / "a.json")) ==
      "a.json:2:19: prerequisites[0]: prerequisites go in a circle: \"a\" needs \"c\", which needs \"b\", which needs "
      "\"a\"\n");
  CHECK(
      to_string(checked(folder / "c.json")) ==
      "c.json:2:24: prerequisites[1]: prerequisites go in a circle: \"c\" needs \"b\", which needs \"a\", which needs "
      "\"c\"\n");
  CHECK(checked(folder / "e.json").empty());  // it leads into the circle
  CHECK(checked(folder / "d.json").empty());
}

// ---- sliders --------------------------------------------------------------------------------------------------------

TEST_CASE("numbers of inputs by their paths") {
  auto inputs =
      parsed(R"({"u": 1, "curve": {"points": [[1, 2], ["3/2", 4]]}, "profiles": [{"weights": [1, 7]}]})").root();
  CHECK(find_number(inputs, "u")->text == "1");
  CHECK(find_number(inputs, "curve.points[1][0]")->text == "3/2");
  CHECK(find_number(inputs, "profiles[0].weights[1]")->text == "7");
  for (const char* path : {"", "v", "curve", "curve.points[2][0]", "curve.points[0", "curve.points[x][0]", "u[0]",
                           "curve..points", ".", "curve.points[0][0].x"})
    CHECK(find_number(inputs, path) == nullptr);
}

TEST_CASE("a slider's ends at which the inputs are not valid are told, and which they are") {
  const auto told = [](const std::string& sliders) {
    const auto document =
        parsed(header + spline + "\n\"beats\": [" + beat_with("\"start\"", "\"sliders\": [" + sliders + "]") + "]}");
    const auto lesson = load_lesson(document);
    INFO(to_string(lesson.diagnostics));
    REQUIRE(lesson);
    return to_string(check_sliders(document));
  };
  CHECK(told(R"({"input": "u", "from": 0, "to": 2}, {"input": "curve.points[1][1]", "from": -9, "to": 9})").empty());
  CHECK(
      told(R"({"input": "u", "from": -1, "to": "5/2"},
{"input": "curve.knots[3]", "from": "1/2", "to": 3},
{"input": "curve.points[0][0]", "from": 0, "to": 1})") ==
      "lesson.json:5:36: beats[0].sliders[0].from: with u = -1 the inputs are not valid: u: must lie in the domain [0, "
      "2], not at -1\n"
      "lesson.json:5:46: beats[0].sliders[0].to: with u = 5/2 the inputs are not valid: u: must lie in the domain [0, "
      "2], not at 5/2\n"
      "lesson.json:6:50: beats[0].sliders[1].to: with curve.knots[3] = 3 the inputs are not valid: curve.knots[4]: "
      "knots must not decrease; 2 comes after 3\n");
  CHECK(told(R"({"input": "u", "from": 1, "to": 2})") ==
        "lesson.json:5:36: beats[0].sliders[0].from: leaves out the lesson's own number, u = 1/2\n");
}

TEST_CASE("links to files that are not beside the lesson, and ids that two files have") {
  const Scratch folder;
  folder.write("notes.txt", "");
  const auto says = [&](const std::string& name, const std::string& words) {
    const auto file = folder.write(name, R"({"schema": "blossom.lesson/1", "id": "same", "beats": [{"at": "end",)" +
                                             std::string("\n\"say\": \"") + words + "\"}]}");
    return *JsonDocument::load(file);
  };
  const auto first =
      says("a.json", "[here](notes.txt#top), [there](notes.html), [out](https://example.org/notes.html)");
  CHECK(to_string(check_addresses(first)) ==
        folder / "a.json:2:8: beats[0].say: there is no file \"notes.html\" beside this one\n");
  const auto second = says("b.json", "Look.");
  CourseIndex index;
  index.add(first.name(), first);
  index.add(second.name(), second);
  CHECK(check_id(first, index).empty());
  CHECK(to_string(check_id(second, index)) == folder / ("b.json:1:38: id: \"same\" is the id of " +
                                                        (folder / "a.json") + " already; each needs one of its own\n"));
}
