// Mistakes as the user of `blossom` meets them: at their place, on one line, in words that hold; and texts in columns.
#include <sys/stat.h>

#include <algorithm>

#include "app/program.hpp"
#include "base/utf8.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

Ended trace(const std::string& algorithm, const std::string& file, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"trace", "--algorithm", algorithm, "--inputs", file};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return blossom::test::blossom(arguments);
}

std::string small_lesson(const std::string& title, const std::string& say) {
  return R"({"schema": "blossom.lesson/1", "id": "small", "title": ")" + title + R"(", "algorithm": "de_casteljau",
 "inputs": {"curve": {"degree": 1, "points": [[0, 0], [2, 4]]}, "u": "1/4"},
 "beats": [{"at": "start", "say": ")" +
         say + "\"}]}";
}

}  // namespace

TEST_CASE("What turns out impossible on the way is named at its place in the file of inputs") {
  const Scratch scratch;
  const auto same = scratch.write("same.json", R"({"profiles": [
{"degree": 1, "points": [[0, 0, 0], [1, 0, 0]]},
 {"degree": 1, "points": [[0, 0, 0], [1, 0, 0]]},
{"degree": 1, "points": [[0, 0, 1], [1, 0, 1]]}], "degree_v": 1})");
  for (const std::vector<std::string>& exact : {std::vector<std::string>{}, {"--exact"}}) {
    const auto ended = trace("skinning", same, exact);
    SHOW(ended);
    CHECK(ended.status == 1);
    CHECK(ended.err ==
          same + ":3:2: profiles[1]: coincides with the profile before it: neighbouring profiles must differ\n");
  }
}

TEST_CASE("Numbers that overflow are said to, and not taken for profiles that coincide") {
  const Scratch scratch;
  const std::string inputs = R"({"degree_v": 1, "profiles": [
{"degree": 1, "points": [[1.7e308, 0, 0], [1, 0, 0]]},
{"degree": 1, "points": [[-1.7e308, 1, 1], [1, 0, 1]]},
{"degree": 1, "points": [[1.7e308, 1, 2], [1, 0, 1.7e308]]}]})";
  const auto file = scratch.write("big.json", inputs);
  const auto ended = trace("skinning", file);
  SHOW(ended);
  CHECK(ended.status == 1);
  CHECK(contains(ended.err, file + ":1:1: on the way numbers become too large for double precision"));
  CHECK_FALSE(contains(ended.err, "coincide"));
}

TEST_CASE("A lesson that overflows only in doubles says so at its inputs") {
  const Scratch scratch;
  const auto file = scratch.write(
      "lesson.json", R"({"schema": "blossom.lesson/1", "id": "big", "title": "Big", "algorithm": "degree_elevation",
 "inputs": {"curve": {"degree": 2, "knots": [0,1,10,10.1,20,21], "points": [[1.7e308,0],[-1.7e308,0],[1.7e308,0]]}},
 "beats": [{"at": "start", "say": "Here"}]})");
  CHECK(blossom::test::blossom({"trace", file, "--exact"}).status == 0);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"trace", file}, {"step", file, "--decimals"}}) {
    const auto ended = blossom::test::blossom(arguments);
    SHOW(ended);
    CHECK(ended.status == 1);
    CHECK(contains(ended.err, file + ":2:12: inputs: on the way numbers become too large for double precision"));
  }
}

TEST_CASE("A pipe as a file of inputs is refused with the way that works") {
  const Scratch scratch;
  REQUIRE(mkfifo((scratch / "pipe").c_str(), 0600) == 0);
  const auto ended = trace("de_casteljau", scratch / "pipe");
  SHOW(ended);
  CHECK(ended.status == 1);
  CHECK(contains(ended.err, "not a pipe; use - for standard input"));
}

TEST_CASE("Whatever is typed, messages are harmless lines") {
  const Scratch scratch;
  const std::string evil = "x\n\x1B[2J\xC2\x9B\xE2\x80\xAEy";
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{evil},
                                                    {"trace", evil},
                                                    {"trace", "22", "--format", evil},
                                                    {"trace", "22", "--" + evil},
                                                    {"trace", "--algorithm", evil, "--inputs", "-"},
                                                    {"trace", "--algorithm", "de_boor", "--inputs", evil},
                                                    {"lint", evil},
                                                    {"list", "--lessons", evil},
                                                    {"step", evil}}) {
    const auto ended = blossom::test::blossom(arguments);
    SHOW(ended);
    CHECK(ended.status != 0);
    const auto lines = lines_of(ended.err);
    CHECK(lines.size() <= 2);  // the second says how to get help
    CHECK(contains(lines.at(0), "\\x0A\\x1B[2J\\xC2\\x9B\\xE2\\x80\\xAEy"));
    for (const std::string& text : {ended.err, ended.out}) CHECK(text.find_first_of("\x1B\x9B") == std::string::npos);
  }
  const auto play = blossom::test::blossom({"step", "22"}, {.input = "\x1B[2J\nw \x1B]0;x\x07\nq\n"});
  SHOW(play);
  CHECK(play.status == 0);
  CHECK(contains(play.out, "no such command: \"\\x1B[2J\""));
  CHECK(play.out.find('\x1B') == std::string::npos);
  CHECK(play.out.find('\x07') == std::string::npos);
}

TEST_CASE("A title of two lines stays in its row") {
  const Scratch scratch;
  const auto file = scratch.write("01.json", small_lesson("One\\nTwo three", "Look."));
  CHECK(contains(blossom::test::blossom({"list", "--lessons", scratch.path()}).out, "One\\x0ATwo "));
  CHECK(blossom::test::blossom({"trace", file}).out.starts_with("One\\x0ATwo "));
}

// ---- lint, list -----------------------------------------------------------------------------------------------------

TEST_CASE("lint passes over JSON Schemas that the shell has listed") {
  const Scratch scratch;
  scratch.write("a.json", R"({"$schema": "https://json-schema.org/draft/2020-12/schema", "ask": 1})");
  scratch.write("b.schema.json", R"({"ask": 1})");
  for (const std::vector<std::string>& files : {std::vector<std::string>{scratch / "a.json", scratch / "b.schema.json"},
                                                {"exercises/exercise.schema.json", "lessons/lesson.schema.json"}}) {
    auto arguments = files;
    arguments.insert(arguments.begin(), "lint");
    const auto ended = blossom::test::blossom(arguments);
    SHOW(ended);
    CHECK(ended.status == 0);
    CHECK(ended.err.empty());
  }
  const auto broken = blossom::test::blossom({"lint", scratch.write("c.schema.json", "{")});
  SHOW(broken);
  CHECK(broken.status == 1);  // it must be JSON
}

TEST_CASE("lint of a folder without files says so") {
  const Scratch scratch;
  scratch.write("notes.txt", "");
  const auto ended = blossom::test::blossom({"lint", scratch.path()});
  SHOW(ended);
  CHECK(ended.status == 1);
  CHECK(ended.err == scratch.path() + ": there are no *.json files in this folder\n");
  CHECK(ended.out.empty());
}

TEST_CASE("list without a folder of lessons lists the algorithms and says what to do") {
  const Scratch scratch;
  fs::copy_file(fs::path(BLOSSOM_BIN_DIR) / "blossom", scratch / "blossom");
  const auto ended = run_program(scratch / "blossom", {"list"}, {.folder = scratch.path()});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  CHECK(contains(ended.out, "no folder `lessons`"));
  CHECK(contains(ended.out, "--lessons"));
  CHECK(contains(ended.out, "de_casteljau"));
}

// ---- columns --------------------------------------------------------------------------------------------------------

TEST_CASE("Columns and underlines are measured in characters") {
  const auto list = lines_of(blossom::test::blossom({"list"}).out);
  // The number of exercises ends each row of a lesson; within a unit it begins at the same character in all of them.
  std::vector<std::size_t> columns;
  std::size_t rows = 0;
  bool accented = false;
  for (const auto& line : list) {
    const bool is_row = line.size() > 4 && '0' <= line[2] && line[2] <= '9';
    if (!is_row) columns.clear();
    const auto exercises = line.rfind(" exercise");
    if (!is_row || exercises == std::string::npos) continue;
    ++rows;
    columns.push_back(utf8_count(line.substr(0, line.rfind(' ', exercises - 1))));
    accented = accented || contains(line, "B\xC3\xA9zier");
    INFO(line);
    CHECK(columns.back() == columns.front());
  }
  CHECK(rows >= 30);
  CHECK(accented);

  for (const std::string command : {"trace", "step"}) {
    const auto lines = lines_of(blossom::test::blossom({command, "11-de-casteljau"}).out);
    REQUIRE(lines.size() > 2);
    CHECK(contains(lines[0], "B\xC3\xA9zier"));
    CHECK(lines[1] == std::string(utf8_count(lines[0]), '='));
  }
}

TEST_CASE("Narration is wrapped by trace and by step, at its characters and its own paragraphs") {
  const Scratch scratch;
  std::string say;
  for (int i = 0; i < 60; ++i) say += "B\xC3\xA9zier ";  // 6 characters of 7 bytes, and a blank
  const auto file = scratch.write("lesson.json", small_lesson("T", say + "end.\\n\\nA line of its own"));
  for (const std::string command : {"trace", "step"}) {
    const auto ended = blossom::test::blossom({command, file});
    SHOW(ended);
    CHECK(ended.status == 0);
    std::size_t widest = 0;
    bool own_line = false;
    for (const auto& line : lines_of(ended.out)) {
      if (contains(line, "B\xC3\xA9zier B\xC3\xA9zier")) widest = std::max(widest, utf8_count(line));
      own_line = own_line || line.find_first_not_of(' ') == line.find("A line of its own");
    }
    CHECK(widest > 110 - 7);
    CHECK(widest <= 110);
    CHECK(own_line);
  }
}
