#include "grader/exercise.hpp"

#include <fstream>

#include "grader/helpers.hpp"

using namespace blossom;

namespace {

Diagnostics mistakes(const std::string& text) {
  const auto document = JsonDocument::parse("e.json", text);
  REQUIRE(document);
  return read_exercise(*document).diagnostics;
}

bool says(const Diagnostics& diagnostics, const std::string& text) {
  return to_string(diagnostics).find(text) != std::string::npos;
}

}  // namespace

TEST_CASE("an exercise's parts are the values its selectors select, each with its points") {
  const auto exercise = load_exercise("tests/data/grader/de-boor-cubic.json");
  INFO(to_string(exercise.diagnostics));
  REQUIRE(exercise);
  CHECK(exercise->id == "de-boor-cubic");
  CHECK(exercise->parts.size() == 13);
  CHECK(exercise->max_points == Exact(19));
  const Part& p = exercise->parts[*exercise->part("P[1][2]")];
  CHECK(p.right == Numbers<Exact>{0, 16});
  CHECK(p.points == Exact(2));
  CHECK(p.formula == "P[1][2] = (1 - alpha[1][2]) P[0][1] + alpha[1][2] P[0][2]");
  CHECK(p.solution.starts_with(p.formula));
  CHECK(p.solution.ends_with("(0, 20) = (0, 16)"));
  CHECK(exercise->parts[*exercise->part("k")].tolerance.kind == Tolerance::Kind::exact);
  CHECK_FALSE(exercise->part("P[9][9]"));
}

TEST_CASE("an exercise is marked at its end unless it says otherwise") {
  const auto marked = [](const std::string& more) {
    return mistakes(exercise_text("de_boor", de_boor_inputs, R"([{"value": "C", "points": 1}])", more));
  };
  const std::string ask = R"([{"value": "C", "points": 1}])";
  CHECK(grader_of(exercise_text("de_boor", de_boor_inputs, ask))->exercise().marking == Marking::at_end);
  CHECK(grader_of(exercise_text("de_boor", de_boor_inputs, ask, R"(, "marking": "at-once")"))->exercise().marking ==
        Marking::at_once);
  CHECK(says(marked(R"(, "marking": "now")"), R"(marking: must be "at-once" or "at-end", not "now")"));
}

TEST_CASE("a selector leaves out what is given") {
  const auto grader = grader_of(exercise_text("de_boor", de_boor_inputs, R"([{"value": "P[*][*]", "points": 1}])"));
  CHECK(grader->exercise().parts.size() == 6);
  CHECK_FALSE(grader->exercise().part("P[0][1]"));
}

TEST_CASE("points of rational curves are affine, homogeneous or only weights") {
  const auto grader = grader_of(
      exercise_text("de_casteljau", rational_bezier_inputs,
                    R"([{"value": "P[1][0]", "points": 1}, {"value": "P[1][1]", "points": 1, "form": "homogeneous"},
                                                  {"value": "P[1][2]", "points": 1, "form": "weight"}])"));
  const auto& parts = grader->exercise().parts;
  // P0 = (1, 0) of weight 1, P1 = (1, 3) of weight 2, u = 2/5: w = 7/5, (7/5, 12/5).
  CHECK(parts[0].right == Numbers<Exact>{1, Exact::ratio(12, 7)});
  CHECK(parts[1].right == Numbers<Exact>{6, Exact::ratio(42, 5), Exact::ratio(12, 5)});
  CHECK(parts[2].right == Numbers<Exact>{Exact::ratio(11, 5)});
  CHECK(verdict(grade_answers(*grader, R"({"P[1][0]": [1, "12/7"]})"), "P[1][0]") == "correct");
  CHECK(verdict(grade_answers(*grader, R"({"P[1][1]": [6, 8.4, 2.4]})"), "P[1][1]") == "correct");
  CHECK(verdict(grade_answers(*grader, R"({"P[1][2]": 2.2})"), "P[1][2]") == "correct");
}

TEST_CASE("every mistake of an exercise is named at once, at its place") {
  const auto found = mistakes(R"({
  "schema": "blossom.exercise/1",
  "id": "De Boor",
  "title": "",
  "prompt": "P",
  "algorithm": "de_boor",
  "inputs": {"curve": {"degree": 2, "points": [[0, 0], [1, 1], [2, 0]]}, "u": "1/2"},
  "asks": [],
  "ask": [
    {"value": "P[1][*]", "points": 1},
    {"value": "P[1][1]", "points": 1},
    {"value": "P[2][9]", "points": -1},
    {"value": "alpha[", "points": 1},
    {"value": "u", "points": 1},
    {"value": "k", "pionts": 1},
    {"value": "C", "points": 1, "form": "weight"},
    {"value": "s", "points": 1, "as": "set", "tolerance": {"decimal": 3}}
  ],
  "tolerance": "exactly",
  "carried": 2,
  "feedback": "all"
})");
  const std::string all = to_string(found);
  INFO(all);
  for (const char* line :
       {"e.json:3:9: id:", "e.json:4:12: title:", "e.json:8:3: unknown key \"asks\"; did you mean \"ask\"?",
        "e.json:11:15: ask[1].value: \"P[1][1]\" is asked twice", "e.json:12:36: ask[2].points:",
        "e.json:12:15: ask[2].value: \"P[2][9]\" matches no value of this run; did you mean \"P[2][2]\"?",
        "e.json:13:15: ask[3].value: \"alpha[\" is no selector",
        "e.json:14:15: ask[4].value: \"u\" is given and cannot be asked",
        "unknown key \"pionts\"; did you mean \"points\"?", "missing key \"points\"",
        "ask[6].form: is for points of rational curves", "ask[7].as: is for lists",
        "unknown key \"decimal\"; did you mean \"decimals\"?", "e.json:19:16: tolerance: must be",
        "e.json:20:14: carried: must be a share from 0 to 1", "e.json:21:15: feedback: must be one of"})
    CHECK(says(found, line));
}

TEST_CASE("an unknown algorithm, impossible inputs, and an irrational value asked exactly are mistakes") {
  CHECK(says(mistakes(exercise_text("de_bor", de_boor_inputs, R"([{"value": "k", "points": 1}])")),
             "did you mean \"de_boor\"?"));
  CHECK(says(mistakes(exercise_text("de_boor", R"({"curve": {"degree": 1, "points": [[0, 0], [1, 1]]}, "u": 2})",
                                    R"([{"value": "k", "points": 1}])")),
             "inputs.u: must lie in the domain"));
  CHECK(says(mistakes(exercise_text("skinning", skinning_inputs, R"([{"value": "d[1][0]", "points": 1}])")),
             "irrational"));
  CHECK(says(mistakes(exercise_text("de_boor", de_boor_inputs, R"([{"value": "k", "points": 0}])")),
             "more than 0 points"));
}

TEST_CASE("a tolerance that accepts nearly everything is a mistake") {
  // The largest number asked is 20.
  const auto on_point = [](const std::string& tolerance, const std::string& own = "") {
    return mistakes(
        exercise_text("de_casteljau", R"({"curve": {"degree": 1, "points": [[0, 0], [32, -40]]}, "u": "1/2"})",
                      R"([{"value": "P[1][0]", "points": 1)" + own + "}]", R"(, "tolerance": )" + tolerance));
  };
  CHECK(says(on_point(R"({"relative": 1})"), "tolerance.relative: must be at least 0 and below 1"));
  CHECK(says(on_point(R"({"relative": "3/2"})"), "below 1, not \"3/2\""));
  CHECK(says(on_point(R"({"relative": -0.1})"), "must be at least 0 and below 1"));
  CHECK(on_point(R"({"relative": 0.99})").empty());
  CHECK(on_point(R"({"absolute": 2})").empty());
  CHECK(says(on_point(R"({"absolute": 2.01})"),
             "tolerance: accepts nearly everything: an absolute tolerance must be "
             "at most 2, a tenth of the largest number it is for"));
  CHECK(
      says(on_point("\"exact\"", R"(, "tolerance": {"absolute": 3})"), "ask[0].tolerance: accepts nearly everything"));
  for (const char* kind : {"decimals", "significant"}) {
    INFO(kind);
    CHECK(on_point(std::string("{\"") + kind + "\": 15}").empty());
    CHECK(says(on_point(std::string("{\"") + kind + "\": 16}"), "15"));
    CHECK_FALSE(on_point(std::string("{\"") + kind + "\": -1}").empty());
  }
  CHECK(on_point(R"({"decimals": 0})").empty());
  CHECK_FALSE(on_point(R"({"significant": 0})").empty());
}

TEST_CASE("a file that is none is a diagnostic") {
  CHECK_FALSE(load_exercise("tests/data/grader/missing.json"));
  CHECK_FALSE(load_exercise("tests/data/grader"));
}
