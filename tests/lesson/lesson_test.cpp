#include "lesson_text.hpp"

using namespace blossom;
using namespace blossom::test;

TEST_CASE("a lesson is its run, and what is said at its steps") {
  const auto lesson =
      lesson_of(beat("\"start\"", "Where is u = {u}?") + "," + beat("\"P[1][*]\"", "{numbers} = {value}") + "," +
                beat("{\"step\": 3}", "Between {P[1][0]} and {P[1][1]}.") + "," + beat("\"end\"", "C = {C}"));
  CHECK(lesson.id == "a-lesson");
  CHECK(lesson.title == "A lesson");
  CHECK(lesson.algorithm == find_algorithm("de_casteljau"));
  CHECK(lesson.minutes == 0);

  const auto run = record<Exact>(*lesson.algorithm, lesson.inputs);
  REQUIRE(run);
  const Narrator<Exact> narrator(*run);
  REQUIRE(run->trace.step_count() == 5);
  CHECK(lesson.narration(narrator, 0) == "Where is u = 1/4?");
  CHECK(lesson.narration(narrator, 1) == "(1 - 1/4) (0, 0) + 1/4 (2, 4) = (1/2, 1)");
  CHECK(lesson.narration(narrator, 2) == narrator.text(2));  // no beat: the algorithm's own words
  CHECK(lesson.narration(narrator, 3) == "Between (1/2, 1) and (5/2, 3).");
  CHECK(lesson.narration(narrator, 4) == "C = (1, 3/2)");
}

TEST_CASE("the same lesson in doubles") {
  const auto lesson = lesson_of(beat("\"end\"", "C({u}) = {C}"));
  const auto run = record<double>(*lesson.algorithm, lesson.inputs);
  REQUIRE(run);
  CHECK(lesson.narration(Narrator<double>(*run), 4) == "C(0.25) = (1, 1.5)");
}

TEST_CASE("a beat at a selector stands where its first value is made") {
  const auto lesson = lesson_of(beat("\"P[1..2][*]\"") + "," + beat("\"P[2][0]\""));
  REQUIRE(lesson.beats.size() == 2);
  CHECK(lesson.beats[0].step == 1);
  CHECK(lesson.beats[1].step == 3);
  CHECK(lesson.beat_at(2) == nullptr);
  CHECK(lesson.beat_at(3) == &lesson.beats[1]);
}

TEST_CASE("a beat at a phase stands at the step that introduces it") {
  const auto lesson = lesson_of(beat("{\"phase\": \"elevate\"}") + "," + beat("{\"phase\": \"elevate.round[2]\"}") +
                                    "," + beat("{\"phase\": \"recompose\"}"),
                                raised);
  const auto run = record<Exact>(*lesson.algorithm, lesson.inputs);
  REQUIRE(run);
  REQUIRE(lesson.beats.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t phase = run->trace.introduced_by(lesson.beats[i].step);
    REQUIRE(phase != absent);
    CHECK(run->trace.phases()[phase].label() == std::vector<std::string>{"elevate", "round[2]", "recompose"}[i]);
  }
}

TEST_CASE("highlights are the values made so far, each once") {
  const auto lesson = lesson_of(R"({"at": "P[1][1]", "say": "Look.", "highlight": ["P[1][1]", "P[0..1][*]"]})");
  const auto run = record<Exact>(*lesson.algorithm, lesson.inputs);
  REQUIRE(run);
  std::vector<std::string> names;
  for (const ValueId v : lesson.beats[0].highlights) names.push_back(run->trace.name(v));
  CHECK(names == std::vector<std::string>{"P[0][0]", "P[0][1]", "P[0][2]", "P[1][0]", "P[1][1]"});
}

TEST_CASE("every mistake of a lesson at once, each at its line and column") {
  const auto lesson = load_lesson(parsed(R"({
  "schema": "blossom.lesson/2",
  "id": "No id",
  "titel": "A lesson",
  "title": " ",
  "minutes": "ten",
  "algorithm": "de_casteljau",
  "inputs": {"curve": {"degree": 2, "points": [[0, 0], [2, 4], [4, 0]]}, "u": "1/4"},
  "beats": [
    {"at": "P[1][0]", "say": "From {Q[0][0]} to {P[0][1]}, then {P[2][0]}."},
    {"at": "start", "says": "Look."},
    {"at": "P[1][7]", "say": "Look."},
    {"at": "P[1", "say": ""},
    {"at": {"step": 5}, "say": "A { is left open."},
    {"at": {"phase": "elevate"}, "say": "Look."},
    {"at": {"step": 1, "phase": "elevate"}, "say": "Look."},
    {"at": 3, "say": "Look.", "highlight": []},
    {"at": "P[2][0]", "say": "Look.", "highlight": ["C", "P[1][*]", "R[1]"]},
    {"at": "P[2][0]", "say": "Look."}
  ]
})"));
  CHECK_FALSE(lesson);
  CHECK(
      to_string(lesson.diagnostics) ==
      R"(lesson.json:2:13: schema: must be "blossom.lesson/1", not "blossom.lesson/2"; this program does not know that version
lesson.json:3:9: id: must be 1 to 64 of a-z, 0-9 and -, such as "de-boor-2", not "No id"
lesson.json:4:3: unknown key "titel"; did you mean "title"?
lesson.json:5:12: title: must not be empty
lesson.json:6:14: minutes: must be a whole number from 1 to 600, not "ten"
lesson.json:10:30: beats[0].say: "{Q[0][0]}" names nothing at step 1; did you mean "P[0][0]"?
lesson.json:10:30: beats[0].say: "{P[2][0]}" names nothing at step 1: it is made at step 3
lesson.json:11:5: beats[1]: missing key "say"
lesson.json:11:12: beats[1].at: stands at step 0, but the beat before at step 1: beats go in the order of the steps
lesson.json:11:21: beats[1]: unknown key "says"; did you mean "say"?
lesson.json:12:12: beats[2].at: no value of this run is called "P[1][7]"; there are P[0][0..2], P[1][0..1], P[2][0]
lesson.json:13:12: beats[3].at: is no selector: the bracket at character 2 is not closed
lesson.json:13:26: beats[3].say: must not be empty
lesson.json:14:21: beats[4].at.step: must be a whole number from 0 to 4, not 5
lesson.json:14:32: beats[4].say: a { has no } behind it, at "{ is left open."
lesson.json:15:22: beats[5].at.phase: no phase of this run is called "elevate"; this algorithm runs in one piece
lesson.json:16:21: beats[6].at.step: must be the only key of its place
lesson.json:17:12: beats[7].at: must be a selector such as "P[1][0]", "start", "end", or an object such as {"phase": "parameters"} or {"step": 3}
lesson.json:17:44: beats[7].highlight: must have at least 1 item, not 0
lesson.json:18:53: beats[8].highlight[0]: nothing of it is made yet at step 3; the first comes at step 4
lesson.json:18:69: beats[8].highlight[2]: no value of this run is called "R[1]"; the values of this run are u, P[0][0..2], P[1][0..1], P[2][0], C
lesson.json:19:12: beats[9].at: stands at step 3 as the beat before does; one beat for each step
)");
}

TEST_CASE("a phase that is misspelled") {
  CHECK(mistakes(beat("{\"phase\": \"recompos\"}"), raised) ==
        "lesson.json:3:28: beats[0].at.phase: no phase of this run is called \"recompos\"; did you mean "
        "\"recompose\"?\n");
}

TEST_CASE("an algorithm that does not exist does not hide what else is wrong") {
  const std::string run = R"("algorithm": "de_bor", "inputs": {}, )";
  CHECK(mistakes(beat("\"P[1][0]\"", "{nobody checks this}") + "," + beat("\"P[\""), run) ==
        "lesson.json:1:84: algorithm: there is no algorithm \"de_bor\"; did you mean \"de_boor\"?\n"
        "lesson.json:2:67: beats[1].at: is no selector: the bracket at character 2 is not closed\n");
  std::string all;
  for (const std::string& id : algorithm_ids()) all += (all.empty() ? "" : ", ") + id;
  CHECK(mistakes(beat("\"start\""), R"("algorithm": "bresenham", "inputs": {}, )") ==
        "lesson.json:1:84: algorithm: there is no algorithm \"bresenham\"; the algorithms are " + all + "\n");
}

TEST_CASE("inputs that are wrong, and inputs that turn out impossible on the way, are named where they stand") {
  CHECK(mistakes(beat("\"start\""), R"("algorithm": "de_boor",
"inputs": {"curve": {"degree": 1, "points": [[0, 0], [1, 1, 1]]}, "u": 2, "v": 3}, )") ==
        "lesson.json:2:54: inputs.curve.points[1]: must have 2 coordinates, as the first point has, not 3\n"
        "lesson.json:2:75: inputs: unknown key \"v\"; the keys here are \"curve\" and \"u\"\n");
  CHECK(
      mistakes(beat("\"start\""), R"("algorithm": "skinning",
"inputs": {"profiles": [
{"degree": 1, "points": [[0, 0, 0], [1, 0, 0]]},
{"degree": 1, "points": [[0, 0, 0], [1, 0, 0]]},
{"degree": 1, "points": [[0, 0, 1], [1, 0, 1]]}], "degree_v": 1}, )") ==
      "lesson.json:4:1: inputs.profiles[1]: coincides with the profile before it: neighbouring profiles must differ\n");
}

TEST_CASE("numbers that overflow are said to, and not taken for profiles that coincide") {
  CHECK(mistakes(beat("\"start\""), R"("algorithm": "skinning",
"inputs": {"profiles": [
{"degree": 1, "points": [[1.7e308, 0, 0], [1, 0, 0]]},
{"degree": 1, "points": [[-1.7e308, 1, 1], [1, 0, 1]]},
{"degree": 1, "points": [[1.7e308, 1, 2], [1, 0, 1.7e308]]}], "degree_v": 1}, )") ==
        "lesson.json:2:11: inputs: on the way numbers become too large for double precision (above 1.8e308): scale the "
        "input down (exact arithmetic has square roots in double precision)\n");
}

TEST_CASE("a parameter is a knot in exact arithmetic if and only if it is one in doubles") {
  const std::string curve =
      R"({"degree": 2, "knots": [0, 0, 0, "1/3", 1, 1, 1], "points": [[0, 0], [1, 1], [2, 0], [3, 1]]})";
  const auto with = [&](const std::string& algorithm, const std::string& u) {
    return mistakes(beat("\"start\""),
                    R"("algorithm": ")" + algorithm + R"(", "inputs": {"curve": )" + curve + R"(, "u": )" + u + "}, ");
  };
  for (const std::string algorithm : {"de_boor", "knot_insertion"}) {
    INFO(algorithm);
    for (const std::string u :
         {R"("333333333333333333333333/1000000000000000000000000")", R"("0.33333333333333333333")"})
      CHECK_THAT(with(algorithm, u),
                 Catch::Contains("inputs.u: differs from the knot u_3 = 1/3 by less than a double can tell"));
    CHECK_THAT(with(algorithm, "1e-350"), Catch::Contains("differs from the knot u_0 = 0 by less"));
    for (const std::string u : {"\"1/3\"", "0.3333333333333", "0.5"}) CHECK(with(algorithm, u).empty());
    // Outside the domain, however little, and said in few digits.
    CHECK_THAT(with(algorithm, "1e300"), Catch::EndsWith("inputs.u: must lie in the domain [0, 1], not at 1e+300\n"));
    CHECK_THAT(with(algorithm, "\"1000000000000000000000001/1000000000000000000000000\""),
               Catch::EndsWith("inputs.u: must lie in the domain [0, 1]; it lies just outside\n"));
  }
}

TEST_CASE("a lesson says what is predicted, and when predictions are marked") {
  const auto with = [](const std::string& predict) {
    return load_lesson(
        parsed(header + parabola + "\n\"beats\": [" + beat("\"start\"") + "], \"predict\": " + predict + "}"));
  };
  CHECK(lesson_of(beat("\"start\"")).asks.empty());
  CHECK(lesson_of(beat("\"start\"")).marking == Marking::at_once);
  const auto lesson = with(R"({"ask": ["P[1][*]", "C"], "marking": "at-end"})");
  REQUIRE(lesson);
  CHECK(lesson->asks == std::vector<std::string>{"P[1][*]", "C"});
  CHECK(lesson->marking == Marking::at_end);
  REQUIRE(with("{}"));
  CHECK(with("{}")->asks.empty());
  CHECK(to_string(with(R"({"asks": 1,
"ask": ["P[1", "P[3][0]", "P[0][*]", "P[*][*]", 7], "marking": "later"})")
                      .diagnostics) ==
        "lesson.json:3:57: predict: unknown key \"asks\"; did you mean \"ask\"?\n"
        "lesson.json:4:9: predict.ask[0]: is no selector: the bracket at character 2 is not closed\n"
        "lesson.json:4:16: predict.ask[1]: no value of this run is called \"P[3][0]\"; there are P[0][0..2], "
        "P[1][0..1], P[2][0]\n"
        "lesson.json:4:27: predict.ask[2]: \"P[0][*]\" is given: there is nothing to predict\n"
        "lesson.json:4:49: predict.ask[4]: must be a string, not 7\n"
        "lesson.json:4:64: predict.marking: must be \"at-once\" or \"at-end\", not \"later\"\n");
  CHECK(to_string(with(R"({"ask": []})").diagnostics) ==
        "lesson.json:3:64: predict.ask: must have at least 1 item, not 0\n");
}

TEST_CASE("the beats of a lesson in a run with other inputs: those whose place is there, in the order of its steps") {
  const auto lesson =
      lesson_of(beat("\"start\"") + R"(, {"at": "P[1][0]", "say": "a", "highlight": ["P[0][*]", "P[1][*]"]}, )" +
                beat("\"P[1][1]\"", "b") + ", " + beat("\"P[2][0]\"", "c") + ", " + beat("\"C\"", "d"));
  const auto beats_of = [&](const std::string& points) {
    const auto document = parsed(R"({"curve": {"degree": )" + points + R"(}, "u": "1/2"})");
    Diagnostics diagnostics;
    const auto read = read_inputs(*lesson.algorithm, Cursor(document, diagnostics));
    REQUIRE(read);
    const auto run = record<double>(*lesson.algorithm, *read);
    REQUIRE(run);
    std::string said;
    std::uint32_t before = 0;
    for (const Beat& each : resolve_beats(lesson, run->trace)) {
      CHECK((said.empty() || each.step > before));
      before = each.step;
      said += each.say.own() + "@" + std::to_string(each.step) + " ";
      for (const ValueId v : each.highlights) said += run->trace.name(v) + " ";
    }
    return said;
  };
  CHECK(beats_of("2, \"points\": [[0, 0], [2, 4], [4, 0]]") ==
        "Look.@0 a@1 P[0][0] P[0][1] P[0][2] P[1][0] b@2 c@3 d@4 ");
  CHECK(beats_of("1, \"points\": [[0, 0], [2, 4]]") == "Look.@0 a@1 P[0][0] P[0][1] P[1][0] d@2 ");
  CHECK(beats_of("3, \"points\": [[0, 0], [2, 4], [4, 0], [5, 0]]") ==
        "Look.@0 a@1 P[0][0] P[0][1] P[0][2] P[0][3] P[1][0] b@2 c@4 d@7 ");
}

TEST_CASE("of beats that come to stand at one step, or in another order, the first of each step stays") {
  const auto lesson =
      lesson_of(beat("\"P[1][0]\"", "a") + ", " + beat("\"P[2][0]\"", "b") + ", " + beat("{\"step\": 4}", "c"));
  const auto document = parsed(R"({"curve": {"degree": 3, "points": [[0, 0], [2, 4], [4, 0], [5, 0]]}, "u": "1/2"})");
  Diagnostics diagnostics;
  const auto inputs = read_inputs(*lesson.algorithm, Cursor(document, diagnostics));
  REQUIRE(inputs);
  const auto run = record<Exact>(*lesson.algorithm, *inputs);
  REQUIRE(run);
  const auto beats = resolve_beats(lesson, run->trace);  // P[2][0] is made at step 4 of this run
  REQUIRE(beats.size() == 2);
  CHECK(beats[1].say == "b");
  CHECK(beats[1].step == 4);
}

TEST_CASE("what a lesson must have") {
  const auto nothing = load_lesson(parsed("{}"));
  CHECK(to_string(nothing.diagnostics) ==
        "lesson.json:1:1: missing key \"schema\"\n"
        "lesson.json:1:1: missing key \"id\"\n"
        "lesson.json:1:1: missing key \"title\"\n"
        "lesson.json:1:1: missing key \"algorithm\"\n"
        "lesson.json:1:1: missing key \"inputs\"\n"
        "lesson.json:1:1: missing key \"beats\"\n");
  const auto list = load_lesson(parsed("[]"));
  CHECK(list.diagnostics.size() == 1);
}

TEST_CASE("a comment may stand in every object") {
  const auto lesson = load_lesson(parsed(R"({
    "$comment": "the whole", "schema": "blossom.lesson/1", "id": "a", "title": {"en": "T", "$comment": 1},
    "algorithm": "de_casteljau",
    "inputs": {"$comment": [], "curve": {"$comment": {}, "degree": 1, "points": [[0, 0], [2, 4]]}, "u": "1/4"},
    "colors": {"$comment": "", "curve": {"$comment": "", "light": "#000"}},
    "beats": [{"$comment": null, "at": {"$comment": "", "step": 0}, "say": "Look.", "camera": {"$comment": ""},
               "sliders": [{"$comment": "", "input": "u", "from": 0, "to": 1}],
               "checkpoint": {"$comment": "", "id": "c", "kind": "choice", "ask": "Which?",
                              "choices": [{"$comment": "", "text": "a", "right": true}, {"text": "b"}]}}],
    "predict": {"$comment": ""}})"));
  CHECK(to_string(lesson.diagnostics).empty());
}

TEST_CASE("what a lesson says of its place in a course") {
  const auto lesson = load_lesson(parsed(R"({"schema": "blossom.lesson/1", "id": "b", "title": "T", "minutes": 20,
    "objectives": ["Know it.", "Do it."], "prerequisites": ["a"], "exercises": ["x", "y"], )" +
                                         parabola + "\"beats\": [" + beat("\"start\"") + "]}"));
  REQUIRE(lesson);
  CHECK(lesson->minutes == 20);
  REQUIRE(lesson->objectives.size() == 2);
  CHECK(lesson->objectives[1] == "Do it.");
  CHECK(lesson->prerequisites == std::vector<std::string>{"a"});
  CHECK(lesson->exercises == std::vector<std::string>{"x", "y"});

  CHECK(mistakes(beat("\"start\""), parabola, R"({"schema": "blossom.lesson/1", "id": "b", "title": "T",
"objectives": [], "prerequisites": ["a", "b", "a", "No id"], "exercises": "x", "minutes": 601, )") ==
        "lesson.json:2:15: objectives: must have at least 1 item, not 0\n"
        "lesson.json:2:36: prerequisites: a lesson cannot be its own prerequisite\n"
        "lesson.json:2:47: prerequisites[2]: \"a\" stands here already\n"
        "lesson.json:2:52: prerequisites[3]: must be 1 to 64 of a-z, 0-9 and -, such as \"de-boor-2\", not \"No id\"\n"
        "lesson.json:2:75: exercises: must be an array, not \"x\"\n"
        "lesson.json:2:91: minutes: must be a whole number from 1 to 600, not 601\n");
}

// ---- several scenes -------------------------------------------------------------------------------------------------

namespace {

std::string scene(const std::string& id, const std::string& rest) {
  return "{\"id\": \"" + id + "\", \"title\": \"Scene " + id + "\", " + rest + "}";
}

}  // namespace

TEST_CASE("a lesson of several scenes runs one after the other") {
  const auto lesson = load_lesson(parsed(
      header + "\"scenes\": [" + scene("one", parabola + "\"beats\": [" + beat("\"end\"", "{C}") + "]") + ", " +
      scene("two", raised + "\"predict\": {\"marking\": \"at-end\"}, \"beats\": [" + beat("\"start\"") + "]") + "]}"));
  INFO(to_string(lesson.diagnostics));
  REQUIRE(lesson);
  REQUIRE(lesson->scene_count() == 2);
  CHECK(lesson->algorithm == find_algorithm("de_casteljau"));  // a lesson is its first scene
  CHECK(lesson->scene_at(0).scene == "one");
  CHECK(lesson->scene_at(1).heading == "Scene two");
  CHECK(lesson->scene_at(1).algorithm == find_algorithm("degree_elevation"));
  CHECK(lesson->scene_at(1).marking == Marking::at_end);
  CHECK(lesson->find_scene("two") == std::optional<std::size_t>(1));
  CHECK(lesson->find_scene("1") == std::optional<std::size_t>(0));
  CHECK_FALSE(lesson->find_scene("3"));
  CHECK_FALSE(lesson->find_scene(""));
}

TEST_CASE("mistakes in each scene are told together, and a lesson has scenes or a run, not both") {
  const auto lesson = load_lesson(parsed(header + "\n\"beats\": [],\n\"scenes\": [" +
                                         scene("one", parabola + "\n\"beats\": [" + beat("\"P[9][9]\"") + "]") + ",\n" +
                                         scene("one", parabola + "\n\"beats\": []") + ",\n7, {}]}"));
  CHECK(to_string(lesson.diagnostics) ==
        "lesson.json:2:1: \"beats\" belongs into a scene once there are \"scenes\"\n"
        "lesson.json:5:18: scenes[0].beats[0].at: no value of this run is called \"P[9][9]\"; there are P[0][0..2], "
        "P[1][0..1], P[2][0]\n"
        "lesson.json:6:8: scenes[1].id: \"one\" is the id of an earlier scene already\n"
        "lesson.json:8:10: scenes[1].beats: must have at least 1 item, not 0\n"
        "lesson.json:9:1: scenes[2]: must be an object with keys among \"id\", \"title\", \"algorithm\", \"inputs\", "
        "\"beats\" and \"predict\", not 7\n"
        "lesson.json:9:4: scenes[3]: missing key \"id\"\n"
        "lesson.json:9:4: scenes[3]: missing key \"title\"\n"
        "lesson.json:9:4: scenes[3]: missing key \"algorithm\"\n"
        "lesson.json:9:4: scenes[3]: missing key \"inputs\"\n"
        "lesson.json:9:4: scenes[3]: missing key \"beats\"\n");
}

TEST_CASE("no two checkpoints of a lesson have one id, in whatever scenes they stand") {
  const std::string asks = R"("checkpoint": {"id": "c", "kind": "line", "ask": "Which line?"})";
  const auto lesson = load_lesson(
      parsed(header + "\"scenes\": [" + scene("one", parabola + "\"beats\": [" + beat_with("\"start\"", asks) + "]") +
             ",\n" + scene("two", parabola + "\"beats\": [" + beat_with("\"start\"", asks) + "]") + "]}"));
  CHECK(to_string(lesson.diagnostics) ==
        "lesson.json:6:22: scenes[1].beats[0].checkpoint.id: \"c\" is the id of an earlier checkpoint already; each "
        "needs "
        "one of its own\n");
}
