// `blossom` as a user at the terminal meets it: list, trace, lint, play, their help, and what happens to mistakes.
#include <unistd.h>

#include <algorithm>

#include "algorithms/trace_json.hpp"
#include "app/program.hpp"
#include "lesson/catalog.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr const char* parabola = R"({"curve": {"degree": 2, "points": [[0, 0], [1, 2], [2, 0]]}, "u": "1/3"})";

// Long lines are wrapped; the words are what counts.
std::string unwrapped(const std::string& text) {
  std::istringstream in(text);
  std::string words;
  for (std::string word; in >> word;) words += word + " ";
  return words;
}

int lines_in(const std::string& text) { return static_cast<int>(std::ranges::count(text, '\n')); }

}  // namespace

// ---- usage ----------------------------------------------------------------------------------------------------------

TEST_CASE("Each command has a manual with an example of itself") {
  for (const std::string command : {
         "list", "trace", "step", "new", "lint",
#if BLOSSOM_PLAYER
             "render"
#endif
       }) {
    const auto ended = blossom::test::blossom({command, "--help"});
    SHOW(ended);
    CHECK(ended.status == 0);
    CHECK(ended.err.empty());
    const auto example = ended.out.find("Example");
    REQUIRE(example != std::string::npos);
    CHECK(ended.out.find("blossom " + command, example) != std::string::npos);
  }
  const auto all = blossom::test::blossom({"--help"});
  SHOW(all);
  CHECK(all.status == 0);
  for (const auto* command : {"list", "trace", "step", "new", "lint"}) CHECK(contains(all.out, command));
}

TEST_CASE("Wrong usage is said on standard error, with status 2 and the way to the manual") {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{}, "subcommand"},
      {{"trac"}, "did you mean \"trace\"?"},
      {{"trace"}, "LESSON"},
      {{"step"}, "LESSON"},
      {{"trace", "11-de-casteljau", "--format", "xml"}, "xml"},
      {{"trace", "11-de-casteljau", "--exakt"}, "--exakt"},
      {{"trace", "--algorithm", "de_boor"}, "--inputs"},
      {{"trace", "11-de-casteljau", "--algorithm", "de_boor", "--inputs", "-"}, "excludes"},
      {{"trace", "--algorithm", "de_booor", "--inputs", "-"}, "did you mean \"de_boor\"?"},
      {{"list", "too", "many"}, "too"}};
  for (const auto& [arguments, words] : cases) {
    const auto ended = blossom::test::blossom(arguments);
    SHOW(ended);
    INFO("expected: " << words);
    CHECK(ended.status == 2);
    CHECK(ended.out.empty());
    CHECK(contains(ended.err, words));
    CHECK(contains(ended.err, "--help"));
  }
  CHECK(contains(blossom::test::blossom({"trace", "--exakt"}).err, "blossom trace --help"));
}

TEST_CASE("A file at fault has status 1 and its name in the message") {
  const Scratch scratch;
  const auto missing = blossom::test::blossom({"trace", scratch / "none.json"});
  SHOW(missing);
  CHECK(missing.status == 1);
  CHECK(missing.out.empty());
  CHECK(contains(missing.err, scratch / "none.json"));
  for (const std::string text : {"", "{", "[]", "{\"schema\": \"blossom.lesson/1\"}"}) {
    const auto ended = blossom::test::blossom({"trace", scratch.write("bad.json", text)});
    SHOW(ended);
    CHECK(ended.status == 1);
    CHECK(ended.out.empty());
    CHECK(contains(ended.err, "bad.json:1:"));
  }
  CHECK(blossom::test::blossom({"trace", scratch.path()}).status == 1);  // a folder is no lesson
}

TEST_CASE("Output that cannot be written has status 3") {
  if (access("/dev/full", W_OK) != 0) {
    WARN("not tested, there is no /dev/full here");
    return;
  }
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"list"}, {"trace", "11-de-casteljau"}, {"lint", "lessons"}, {"--help"}}) {
    const auto ended = blossom::test::blossom(arguments, {.output_to = "/dev/full"});
    SHOW(ended);
    INFO(arguments[0]);
    CHECK(ended.status == 3);
    CHECK(contains(ended.err, "cannot be written"));
  }
}

// ---- list -----------------------------------------------------------------------------------------------------------

TEST_CASE("list names every lesson and every algorithm") {
  const auto ended = blossom::test::blossom({"list"});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  const Catalog catalog = load_catalog("lessons");
  REQUIRE(catalog.lessons.size() >= 8);
  for (const auto& entry : catalog.lessons) {
    CHECK(contains(ended.out, entry.file.stem().string()));
    CHECK(contains(ended.out, entry.lesson.title.own()));
  }
  for (const Algorithm* algorithm : algorithms()) CHECK(contains(ended.out, std::string(algorithm->summary)));
}

TEST_CASE("list of a folder with a faulty lesson lists the others and names the fault") {
  const Scratch scratch;
  fs::copy("lessons/11-de-casteljau.json", scratch / "11-de-casteljau.json");
  scratch.write("02-broken.json", "{\"schema\": \"blossom.lesson/1\",\n \"id\": \"x\"}");
  const auto ended = blossom::test::blossom({"list", "--lessons", scratch.path()});
  SHOW(ended);
  CHECK(ended.status == 1);
  CHECK(contains(ended.out, "11-de-casteljau"));
  CHECK(contains(ended.err, "02-broken.json:1:"));
  CHECK(blossom::test::blossom({"list", "--lessons", scratch / "none"}).status == 1);
}

// ---- trace ----------------------------------------------------------------------------------------------------------

TEST_CASE("trace as text tells each step once, numbers filled in") {
  for (const auto& entry : load_catalog("lessons").lessons) {
    const auto run = record<Exact>(*entry.lesson.algorithm, entry.lesson.inputs);
    REQUIRE(run);
    const Narrator<Exact> narrator(*run, 6);  // digits, as in pictures
    const auto ended = blossom::test::blossom({"trace", entry.file.string(), "--exact"});
    INFO(entry.file);
    CHECK(ended.status == 0);
    CHECK(ended.err.empty());
    CHECK(contains(ended.out, entry.lesson.title.own()));
    const std::string words = unwrapped(ended.out);
    for (std::uint32_t step = 0; step < run->trace.step_count(); ++step) {
      const std::string said = plain_text(read_prose(entry.lesson.narration(narrator, step)));
      INFO("step " << step << ": " << said);
      CHECK(contains(words, unwrapped(said)));
    }
    CHECK_FALSE(contains(ended.out, "nan"));
  }
}

TEST_CASE("A lesson is found by number, name, id or file") {
  const auto by_file = blossom::test::blossom({"trace", "lessons/22-de-boor.json"});
  REQUIRE(by_file.status == 0);
  for (const std::string name : {"22", "22-de-boor", "de-boor"}) {
    const auto ended = blossom::test::blossom({"trace", name});
    SHOW(ended);
    CHECK(ended.status == 0);
    CHECK(ended.out == by_file.out);
  }
  const auto unknown = blossom::test::blossom({"trace", "22-de-bor"});
  SHOW(unknown);
  CHECK(unknown.status == 1);
  CHECK(contains(unknown.err, "22-de-boor"));
}

TEST_CASE("trace as JSON is a trace file that reads back as the run") {
  for (const auto& entry : load_catalog("lessons").lessons) {
    INFO(entry.file);
    for (const bool exact : {true, false}) {
      std::vector<std::string> arguments{"trace", entry.file.string(), "--format", "json"};
      if (exact) arguments.push_back("--exact");
      const auto ended = blossom::test::blossom(arguments);
      CHECK(ended.status == 0);
      CHECK(ended.err.empty());
      const auto document = JsonDocument::parse("trace", ended.out);
      INFO(to_string(document.diagnostics));
      REQUIRE(document);
      const auto stored = read_trace(*document);
      INFO(to_string(stored.diagnostics));
      REQUIRE(stored);
      if (exact)
        CHECK(std::get<Run<Exact>>(*stored).trace ==
              record<Exact>(*entry.lesson.algorithm, entry.lesson.inputs)->trace);
      else
        CHECK(std::get<Run<double>>(*stored).trace ==
              record<double>(*entry.lesson.algorithm, entry.lesson.inputs)->trace);
    }
  }
}

TEST_CASE("Inputs come from a file or from standard input") {
  const Scratch scratch;
  const std::vector<std::string> common{"trace", "--algorithm", "de_casteljau", "--exact", "--inputs"};
  auto from_file = common, from_input = common;
  from_file.push_back(scratch.write("parabola.json", parabola));
  from_input.push_back("-");
  const auto file = blossom::test::blossom(from_file), input = blossom::test::blossom(from_input, {.input = parabola});
  SHOW(file);
  CHECK(file.status == 0);
  CHECK(contains(file.out, "(2/3, 8/9)"));  // ((1-u)^2, 2u(1-u), u^2) = (4, 4, 1)/9 at u = 1/3
  CHECK(input.out == file.out);

  const auto wrong =
      blossom::test::blossom(from_input, {.input = R"({"curve": {"degree": 2, "points": [[0, 0], [1, 2]]}, "v": 2})"});
  SHOW(wrong);
  CHECK(wrong.status == 1);
  CHECK(wrong.out.empty());
  CHECK(contains(wrong.err, "curve.points"));
  CHECK(contains(wrong.err, "\"v\""));
  CHECK(contains(wrong.err, "\"u\""));
  CHECK(blossom::test::blossom(from_input, {.input = ""}).status == 1);
}

TEST_CASE("A whole lesson comes from standard input") {
  const auto ended = blossom::test::blossom({"trace", "-", "--exact"}, {.input = read_all("lessons/22-de-boor.json")});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(ended.out == blossom::test::blossom({"trace", "22", "--exact"}).out);
}

// ---- lint -----------------------------------------------------------------------------------------------------------

TEST_CASE("lint finds the shipped files in order") {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"lint"},
                                                    {"lint", "lessons"},
                                                    {"lint", "lessons", "exercises"},
                                                    {"lint", "lessons/22-de-boor.json"}}) {
    const auto ended = blossom::test::blossom(arguments);
    SHOW(ended);
    CHECK(ended.status == 0);
    CHECK(ended.err.empty());
    CHECK(contains(ended.out, "in order"));
  }
}

TEST_CASE("lint names five mistakes of different kinds at once, each at its line and column") {
  const Scratch scratch;
  const auto file = scratch.write("five.json", R"({
  "schema": "blossom.lesson/1",
  "id": "Five Mistakes",
  "title": "Five mistakes",
  "algorithm": "de_boor",
  "inputs": {
    "curve": {
      "degree": 2,
      "knots": [0, 0, 0, 0.5, 0.25, 1, 1],
      "points": [[0, 0], [1, "two"], [2, 0], [3, 1]],
      "wieghts": [1, 1, 1, 1]
    },
    "u": "1/0"
  },
  "beats": [{"at": "start", "say": "Here"}]
})");
  const auto ended = blossom::test::blossom({"lint", file});
  SHOW(ended);
  CHECK(ended.status == 1);
  CHECK(contains(ended.err, file + ":3:9: id"));
  CHECK(contains(ended.err, file + ":9:31: inputs.curve.knots[4]"));
  CHECK(contains(ended.err, file + ":10:30: inputs.curve.points[1][1]"));
  CHECK(contains(ended.err, file + ":11:7: inputs.curve: unknown key \"wieghts\""));
  CHECK(contains(ended.err, "did you mean \"weights\"?"));
  CHECK(contains(ended.err, file + ":13:10: inputs.u"));
  CHECK(lines_in(ended.err) == 5);
  CHECK(contains(ended.out, "5 mistakes"));
}

TEST_CASE("lint resolves the names in a lesson and in an exercise") {
  const Scratch scratch;
  auto lesson = read_all("lessons/22-de-boor.json");
  const auto at = lesson.find("\"at\": \"P[1][2]\"");
  REQUIRE(at != std::string::npos);
  lesson.replace(at, 15, "\"at\": \"Q[1][2]\"");
  const auto line = 1 + std::ranges::count(lesson.substr(0, at), '\n');
  const auto ended = blossom::test::blossom({"lint", scratch.write("lesson.json", lesson)});
  SHOW(ended);
  CHECK(ended.status == 1);
  CHECK(contains(ended.err, "lesson.json:" + std::to_string(line) + ":"));
  CHECK(contains(ended.err, "Q[1][2]"));
  CHECK(contains(ended.err, "did you mean"));
}

TEST_CASE("lint of a folder goes through its files; what is none of Blossom's is named") {
  const Scratch scratch;
  scratch.write("a-curve.json", R"({"degree": 1, "points": [[0, 0], [1, 1]]})");
  scratch.write("b-other.json", R"({"name": "package", "version": 1})");
  scratch.write("c-text.json", "no JSON");
  scratch.write("notes.txt", "no JSON either, and not looked at");
  const auto ended = blossom::test::blossom({"lint", scratch.path()});
  SHOW(ended);
  CHECK(ended.status == 1);
  CHECK(contains(ended.out, "1 file is in order"));
  CHECK(contains(ended.err, "b-other.json:1:1"));
  CHECK(contains(ended.err, "c-text.json:1:"));
  CHECK_FALSE(contains(ended.err, "notes.txt"));
  CHECK_FALSE(contains(ended.err, "a-curve"));
}

TEST_CASE("lint knows traces and surfaces, too") {
  const Scratch scratch;
  const auto trace = blossom::test::blossom({"trace", "11", "--format", "json", "--exact"}).out;
  scratch.write("trace.json", trace);
  scratch.write("surface.json", R"({"degree": [1, 1], "points": [[[0,0,0],[0,1,0]],[[1,0,0],[1,1,1]]]})");
  const auto good = blossom::test::blossom({"lint", scratch.path()});
  SHOW(good);
  CHECK(good.status == 0);
  CHECK(contains(good.out, "2 files are in order"));
  auto broken = trace;
  const auto rule = broken.find("\"rule\": \"blend\"");
  REQUIRE(rule != std::string::npos);
  broken.replace(rule, 15, "\"rule\": \"blond\"");
  const auto ended = blossom::test::blossom({"lint", scratch.write("trace.json", broken)});
  SHOW(ended);
  CHECK(ended.status == 1);
  CHECK(contains(ended.err, "blond"));
}

TEST_CASE("lint checks the form of answers, and their names against the exercise") {
  const auto good = blossom::test::blossom({"lint", "exercises/demo-class/perfect.json"});
  SHOW(good);
  CHECK(good.status == 0);
  const Scratch scratch;
  const auto ended = blossom::test::blossom({"lint", scratch.write("answers.json", R"({
  "schema": "blossom.answers/1",
  "exercise": "de-boor",
  "answers": {
    "k": true,
    "P[1][2]": [0, "1/0"],
    "p[3][4]": [0, 1],
    "alpha[1][2]": {"sett": [0, 1]},
    "P[1][3]": [0, "1/2"]
  },
  "name": "Ada"
})")});
  SHOW(ended);
  CHECK(ended.status == 1);
  for (const auto* place : {":5:10: ", ":6:20: ", ":7:5: ", ":8:20: ", ":11:3: "})
    CHECK(contains(ended.err, "answers.json" + std::string(place)));
  CHECK(contains(ended.err, "does not ask for \"p[3][4]\"; did you mean \"P[3][4]\"?"));
  CHECK_FALSE(contains(ended.err, "answers.json:9"));
}

// ---- play -----------------------------------------------------------------------------------------------------------

namespace {

// What play answers to these lines: one piece for each, after the first picture of the start.
std::vector<std::string> play(const std::string& script, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"step", "22-de-boor"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const auto ended = blossom::test::blossom(arguments, {.input = script});
  SHOW(ended);
  CHECK(ended.status == 0);
  CHECK(ended.err.empty());
  std::vector<std::string> answers;
  for (std::size_t at = ended.out.find("\n> "); at != std::string::npos;) {
    const auto next = ended.out.find("\n> ", at + 1);
    answers.push_back(ended.out.substr(at + 3, next == std::string::npos ? next : next - at - 3));
    at = next;
  }
  return answers;
}

}  // namespace

TEST_CASE("play goes forward, back and anywhere") {
  const auto answers = play("n\n\nb\ng 4\nf\nl\nq\n");
  REQUIRE(answers.size() == 7);
  CHECK(contains(answers[0], "step 1 / 15"));
  CHECK(contains(answers[1], "step 2 / 15"));
  CHECK(contains(answers[2], "step 1 / 15"));
  CHECK(answers[2] == answers[0]);  // a step back is the same step
  CHECK(contains(answers[3], "step 4 / 15"));
  CHECK(contains(answers[3], "P[1][2] = "));
  CHECK(contains(answers[3], "b(0, 1/4, 2/5)"));
  CHECK(contains(answers[4], "step 0 / 15"));
  CHECK(contains(answers[5], "step 15 / 15"));
  CHECK(answers[6].empty());  // q says nothing and ends it
}

TEST_CASE("play follows the beats of the lesson") {
  const Catalog catalog = load_catalog("lessons");
  const auto* entry = catalog.find("de-boor");
  REQUIRE(entry != nullptr);
  REQUIRE(entry->lesson.beats.size() > 3);
  const auto answers = play("]\n]\n[\nq\n");
  const auto step = [&](std::size_t beat) { return "step " + std::to_string(entry->lesson.beats[beat].step) + " / "; };
  REQUIRE(answers.size() == 4);
  CHECK(contains(answers[0], step(1)));
  CHECK(contains(answers[1], step(2)));
  CHECK(contains(answers[2], step(1)));
}

TEST_CASE("play says why a value is what it is, down to the inputs") {
  const auto answers = play("l\nw P[1][2]\nw P[9][9]\nw P[1]2\nw\ng 1\nw P[1][2]\nq\n");
  REQUIRE(answers.size() == 8);
  CHECK(contains(answers[1], "P[1][2] = (0, 16)"));
  CHECK(contains(answers[1], "alpha[1][2] = 4/5"));
  CHECK(contains(answers[1], "P[0][1] = (0, 0)   (given)"));
  CHECK(contains(answers[2], "there is no value \"P[9][9]\""));
  CHECK(contains(answers[3], "there is no value"));
  CHECK(contains(answers[4], "there is no value"));
  CHECK(contains(answers[6], "there is no value \"P[1][2]\" yet"));  // it is made at step 4
}

TEST_CASE("play shows the scheme and the code") {
  const auto answers = play("g 4\nt\nc\n?\nq\n");
  REQUIRE(answers.size() == 5);
  CHECK(contains(answers[1], "P[1][2] = (0, 16)"));
  CHECK_FALSE(contains(answers[1], "P[1][3]"));  // not made yet
  CHECK(contains(answers[2], "=> 6"));
  CHECK(contains(answers[3], "next step"));
}

TEST_CASE("play takes garbage with patience") {
  const auto answers = play("xyzzy\ng\ng 16\ng -1\ng 1.5\ng 99999999999999999999\nb\nl\nn\n\xff\xfe\x01\n" +
                            std::string(100000, 'n') + "\nq\n");
  REQUIRE(answers.size() == 12);
  CHECK(contains(answers[0], "no such command"));
  for (const int i : {1, 2, 3, 4, 5}) CHECK(contains(answers[static_cast<std::size_t>(i)], "from 0 to 15"));
  CHECK_FALSE(contains(answers[6], "step"));  // there is nothing before the start
  CHECK(contains(answers[8], "last step"));
  CHECK(contains(answers[9], "no such command"));
  CHECK(answers[10].size() < 200);
}

TEST_CASE("play ends with its input") {
  CHECK(play("").size() == 1);
  CHECK(play("n\nn").size() == 3);
  const auto decimals = play("g 4\nq\n", {"--decimals"});
  REQUIRE(decimals.size() == 2);
  CHECK(contains(decimals[0], "0.8"));
  CHECK_FALSE(contains(decimals[0], "4/5"));
}
