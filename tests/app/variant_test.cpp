// blossom-grade variant, as an instructor starts it.

#include <algorithm>

#include "app/program.hpp"

using namespace blossom::test;

namespace {

const std::string exercise = "exercises/40-own-rational.json";

Ended variant(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "variant");
  return run_program("blossom-grade", std::move(arguments));
}

std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace

TEST_CASE("variant prints one student's exercise, the same each time") {
  const Scratch scratch;
  const auto secret = scratch.write("secret", "correct horse battery\n");
  const auto first = variant({exercise, "--student", "s17", "--secret-file", secret});
  SHOW(first);
  CHECK(first.status == 0);
  CHECK(first.err.empty());
  CHECK(contains(first.out, "\"id\": \"own-rational\""));
  CHECK_FALSE(contains(first.out, "\"vary\""));
  CHECK(variant({exercise, "--student", "s17", "--secret-file", secret}).out == first.out);
  CHECK(variant({exercise, "--student", "s18", "--secret-file", secret}).out != first.out);
  const auto other = scratch.write("other", "incorrect horse battery\n");
  CHECK(variant({exercise, "--student", "s17", "--secret-file", other}).out != first.out);

  const std::string file = scratch / "s17.json";
  const auto to_file = variant({exercise, "--student", "s17", "--secret-file", secret, "--out", file});
  CHECK(to_file.status == 0);
  CHECK(to_file.out.empty());
  CHECK(read_all(file) == first.out);
  CHECK(run_program("blossom-grade", {file, "tests/data/grader/no-such-file.json"}).status == 1);
}

TEST_CASE("variant makes a whole class's exercises and a sheet to print") {
  const Scratch scratch;
  const auto secret = scratch.write("secret", "correct horse battery");
  const auto roster =
      scratch.write("roster.csv", "id,name,section\ns17,\"Lovelace, Ada\",1\n../s18,\"<script>alert(1)</script>\",B\n");
  const std::string out = scratch / "own";
  const auto made = variant({exercise, "--roster", roster, "--secret-file", secret, "--out", out});
  SHOW(made);
  REQUIRE(made.status == 0);
  CHECK(made.out == "2 students, 2 different variants\n");
  CHECK(made.err.empty());
  const auto names = files_in(out);
  REQUIRE(names.size() == 3);
  CHECK(std::ranges::find(names, "s17.json") != names.end());
  CHECK(std::ranges::find(names, "sheet.html") != names.end());
  CHECK(read_all(fs::path(out) / "s17.json") == variant({exercise, "--student", "s17", "--secret-file", secret}).out);

  const std::string sheet = read_all(fs::path(out) / "sheet.html");
  CHECK(count_of(sheet, "<section class=\"sheet\">") == 2);
  CHECK(contains(sheet, "Lovelace, Ada"));
  CHECK(contains(sheet, "section 1 · ID s17"));
  CHECK(contains(sheet, "&lt;script&gt;alert(1)&lt;/script&gt;"));
  CHECK_FALSE(contains(sheet, "<script"));
  CHECK_FALSE(contains(sheet, "{P["));
  CHECK(contains(sheet, "<code>P[1][0]</code>"));
  // Nothing stands in the boxes.
  CHECK(count_of(sheet, "<code>P[1][0]</code></th><td></td><td></td><td></td></tr>") == 2);
  // How to hand in, with the exercise's ID, and where to compute.
  CHECK(count_of(sheet, "&quot;exercise&quot;: &quot;own-rational&quot;") == 2);
  CHECK(count_of(sheet, "<div class=\"room\">") == 2);

  CHECK(count_of(sheet, "Nobody else in your class has these numbers.") == 2);

  SECTION("and the solutions, on sheets of their own") {
    const auto again = variant({exercise, "--roster", roster, "--secret-file", secret, "--out", out, "--answers"});
    SHOW(again);
    REQUIRE(again.status == 0);
    CHECK(files_in(out).size() == 4);
    CHECK(read_all(fs::path(out) / "sheet.html") == sheet);
    const std::string solutions = read_all(fs::path(out) / "solutions.html");
    CHECK(count_of(solutions, "<section class=\"sheet\">") == 2);
    CHECK_FALSE(contains(solutions, "<td></td><td></td>"));
  }
}

TEST_CASE("a sheet claims no more of its numbers than is true of the class") {
  const Scratch scratch;
  const auto secret = scratch.write("secret", "correct horse battery");
  const auto roster = scratch.write("roster.csv", "id\na\nb\nc\nd\ne\n");
  const auto sheet_of = [&](const std::string& choose, const std::string& says) {
    const auto file = scratch.write("x.json",
                                    R"({"schema": "blossom.exercise/1", "id": "x", "title": "X", "prompt": "u = {u}",
          "algorithm": "de_casteljau", "inputs": {"curve": {"degree": 1, "points": [[0, 0], [30, 60]]}, "u": "1/4"},
          "ask": [{"value": "P[1][0]", "points": 1}], "vary": {"inputs": [{"at": "u", "choose": )" +
                                        choose + "}]}}");
    const auto made = variant({file, "--roster", roster, "--secret-file", secret, "--out", scratch / "own"});
    SHOW(made);
    CHECK(made.status == 0);
    CHECK(contains(made.out, says));
    return read_all(fs::path(scratch / "own") / "sheet.html");
  };
  const std::string alike = sheet_of(R"(["1/4"])", "5 students, 1 different variant: some have the same numbers");
  CHECK_FALSE(contains(alike, "in your class"));
  const std::string two = sheet_of(R"(["1/4", "1/3"])", "5 students, 2 different variants: some have the same numbers");
  CHECK(count_of(two, "Others in your class have other numbers.") + count_of(two, "Nobody else in your class") == 5);
  CHECK(count_of(two, "Nobody else in your class") < 2);
}

TEST_CASE("a sheet has points as points, and a surface's knots under their own letters") {
  const Scratch scratch;
  const auto secret = scratch.write("secret", "correct horse battery");
  const auto roster = scratch.write("roster.csv", "id\ns17\n");
  const auto sheet_of = [&](const std::string& name) {
    const std::string out = scratch / name;
    CHECK(variant({"exercises/" + name + ".json", "--roster", roster, "--secret-file", secret, "--out", out}).status ==
          0);
    return read_all(fs::path(out) / "sheet.html");
  };
  for (const char* name : {"71-own-interpolation", "75-own-surface-least-squares", "13-own-variation"}) {
    const std::string sheet = sheet_of(name);
    CHECK(contains(sheet, "<span class=\"whole\">("));
    CHECK_FALSE(contains(sheet, "[["));
    CHECK_FALSE(contains(sheet, "[&quot;"));
  }
  CHECK(contains(sheet_of("52-own-knot-in-a-surface"), "<i>v</i><sub>0</sub>"));
}

TEST_CASE("variant says what is wrong with what it is given") {
  const Scratch scratch;
  const auto secret = scratch.write("secret", "correct horse battery");
  const auto roster = scratch.write("roster.csv", "id\ns17\n");
  struct Case {
    std::vector<std::string> arguments;
    int status;
    std::string says;
  };
  const std::vector<Case> cases{
      {{exercise, "--student", "s17"}, 2, "--secret-file"},
      {{exercise, "--secret-file", secret}, 2, "--student or --roster"},
      {{exercise, "--secret-file", secret, "--student", "a", "--roster", roster}, 2, "excludes"},
      {{exercise, "--secret-file", secret, "--roster", roster}, 2, "--out"},
      {{exercise, "--secret-file", secret, "--student", "a", "--answers"}, 2, "--roster"},
      {{exercise, "--secret-file", scratch.write("short", "too short\n"), "--student", "a"}, 1, "at least 16 bytes"},
      {{exercise, "--secret-file", scratch / "none", "--student", "a"}, 1, "none: "},
      {{scratch.write("x.json", "{"), "--secret-file", secret, "--student", "a"}, 1, "x.json:1:"},
      {{scratch / "y.json", "--secret-file", secret, "--student", "a"}, 1, "y.json: "},
      {{exercise, "--secret-file", secret, "--roster", scratch.write("bad.csv", "name\nAda\n"), "--out", scratch / "o"},
       1,
       "bad.csv:1:"},
      {{exercise, "--secret-file", secret, "--student", "a", "--out", scratch / "no/such/folder.json"},
       3,
       "folder.json"},
  };
  for (const Case& wrong : cases) {
    const auto ended = variant(wrong.arguments);
    SHOW(ended);
    INFO("expected: " << wrong.says);
    CHECK(ended.status == wrong.status);
    CHECK(contains(ended.err, wrong.says));
    CHECK(ended.out.empty());
  }
}

TEST_CASE("variant of an exercise where nothing varies says so") {
  const Scratch scratch;
  const auto secret = scratch.write("secret", "correct horse battery");
  const auto ended = variant({"exercises/11-de-casteljau.json", "--student", "s17", "--secret-file", secret});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(contains(ended.err, "everybody has the same numbers"));
  CHECK(ended.out == read_all("exercises/11-de-casteljau.json"));
}
