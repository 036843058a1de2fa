// What beats say and do: everywhere, sliders, cameras, pauses.

#include "lesson/beat.hpp"

#include "base/json_write.hpp"
#include "lesson_text.hpp"

using namespace blossom;
using namespace blossom::test;

TEST_CASE("a beat at every step of a kind stands where no other beat does") {
  const auto lesson = lesson_of(beat("{\"every\": \"P[*][*]\"}", "again {name}") + ", " + beat("\"start\"", "a") +
                                ", " + beat("\"P[1][1]\"", "b"));
  std::string said;
  for (const Beat& each : lesson.beats) said += std::to_string(each.step) + " " + each.say.own() + "; ";
  CHECK(said == "0 a; 1 again {name}; 2 b; 3 again {name}; ");
  const auto run = record<Exact>(*lesson.algorithm, lesson.inputs);
  const Narrator<Exact> narrator(*run);
  CHECK(lesson.narration(narrator, 1) == "again P[1][0]");
  CHECK(lesson.narration(narrator, 3) == "again P[2][0]");
  // Again, in the same run: the copies are one beat.
  CHECK(resolve_beats(lesson, run->trace).size() == lesson.beats.size());
}

TEST_CASE("a beat that is never shown is a mistake") {
  CHECK(mistakes(beat("\"P[1][0]\"") + ",\n" + beat("{\"every\": \"P[1][0]\"}")) ==
        "lesson.json:4:8: beats[1].at: is never shown: at each of its steps another beat stands\n");
  CHECK(mistakes(beat("{\"every\": \"P[1][*]\"}") + ",\n" + beat("{\"every\": \"P[1][1]\"}")) ==
        "lesson.json:4:8: beats[1].at: is never shown: at each of its steps another beat stands\n");
  CHECK(mistakes(beat("{\"every\": \"P[1][*]\"}") + ",\n" + beat("{\"every\": \"P[*][*]\"}")).empty());
}

TEST_CASE("what is said at every step of a kind must fit each of them, and is told once") {
  CHECK(mistakes(beat("{\"every\": \"P[1][*]\"}", "{P[1][1]}")) ==
        "lesson.json:3:47: beats[0].say: \"{P[1][1]}\" names nothing at step 1: it is made at step 2\n");
  CHECK(mistakes(beat("{\"every\": \"Q[*]\"}")) ==
        "lesson.json:3:28: beats[0].at.every: no value of this run is called \"Q[*]\"; the values of this run are u, "
        "P[0][0..2], P[1][0..1], P[2][0], C\n");
}

TEST_CASE("words are in a small part of Markdown, and what is not is told") {
  CHECK(mistakes(beat("\"start\"", "**Bold**, *emphasis* and $\\\\frac{1}{2}$.")).empty());
  CHECK_THAT(mistakes(beat("\"start\"", "# A heading")),
             Catch::StartsWith("lesson.json:3:34: beats[0].say: there are no headings here"));
  CHECK_THAT(mistakes(beat("\"start\"", "A $ formula that $\\\\unknowncommand{1}$")),
             Catch::StartsWith(
                 "lesson.json:3:34: beats[0].say: a $ with a blank before it or a digit behind it ends no formula"));
}

TEST_CASE("pauses, cameras and sliders are read as they are written") {
  const auto lesson = lesson_of(
      beat_with("\"start\"", R"("pause": "wait", "camera": {"fit": ["P[0][*]"], "zoom": 2})") + ", " +
      beat_with("\"P[1][0]\"", R"("pause": 2.5, "camera": {"azimuth": -30, "elevation": 20})") + ", " +
      beat_with("\"end\"", R"("sliders": [{"input": "curve.points[1][0]", "from": -2, "to": "7/2", "step": "1/2",
                                           "label": "the middle"}, {"input": "u", "from": 0, "to": 1}])"));
  REQUIRE(lesson.beats.size() == 3);
  CHECK(lesson.beats[0].waits);
  CHECK(lesson.beats[0].camera->fit == std::vector<std::string>{"P[0][*]"});
  CHECK(lesson.beats[0].camera->zoom == 2);
  CHECK_FALSE(lesson.beats[1].waits);
  CHECK(lesson.beats[1].seconds == 2.5);
  CHECK(lesson.beats[1].camera->azimuth == std::optional<double>(-30));
  REQUIRE(lesson.beats[2].sliders.size() == 2);
  CHECK(lesson.beats[2].sliders[0].to == Exact::ratio(7, 2));
  CHECK(lesson.beats[2].sliders[0].step == Exact::ratio(1, 2));
  CHECK(lesson.beats[2].sliders[0].label == "the middle");
  CHECK_FALSE(lesson.beats[2].sliders[1].step);

  // Written again they are what they were.
  std::string again;
  for (const Beat& each : lesson.beats)
    again += (again.empty() ? "" : ", ") + write_json(write_beat(each, lesson.languages));
  const auto twice = lesson_of(again);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(write_json(write_beat(twice.beats[i], {})) == write_json(write_beat(lesson.beats[i], {})));
    CHECK(twice.beats[i].camera == lesson.beats[i].camera);
    CHECK(twice.beats[i].step == lesson.beats[i].step);
  }
}

TEST_CASE("every mistake in what a beat does, each at its line and column") {
  CHECK(mistakes(beat_with("\"start\"", R"("pause": "long",
"camera": {"fit": ["Q[*]"], "azimut": 1, "elevation": 90, "zoom": "no"},
"sliders": [
{"input": "v", "from": 0, "to": 1},
{"input": "curve.points[3][0]", "from": 0, "to": 1},
{"input": "curve", "from": 0, "to": 1},
{"input": "curve..degree", "from": 1, "to": 1, "step": 3, "label": " "}])") +
                 ",\n" + beat_with("\"end\"", R"("pause": 61, "sliders": [])")) ==
        "lesson.json:4:10: beats[0].pause: must be \"wait\" or a number of seconds above 0, up to 60\n"
        "lesson.json:5:20: beats[0].camera.fit[0]: no value of this run is called \"Q[*]\"; the values of this run are "
        "u, P[0][0..2], P[1][0..1], P[2][0], C\n"
        "lesson.json:5:29: beats[0].camera: unknown key \"azimut\"; did you mean \"azimuth\"?\n"
        "lesson.json:5:55: beats[0].camera.elevation: must be from -89 to 89\n"
        "lesson.json:5:67: beats[0].camera.zoom: must be a number or an exact string such as \"2/5\", not \"no\"\n"
        "lesson.json:7:11: beats[0].sliders[0].input: the inputs have no \"v\"; there is \"curve\", \"u\"\n"
        "lesson.json:8:11: beats[0].sliders[1].input: the inputs have no such place, in \"curve.points[3][0]\"\n"
        "lesson.json:9:11: beats[0].sliders[2].input: must lead to one number of the inputs, in \"curve\"\n"
        "lesson.json:10:11: beats[0].sliders[3].input: must be a path such as \"u\" or \"curve.points[1][0]\", in "
        "\"curve..degree\"\n"
        "lesson.json:10:45: beats[0].sliders[3].to: must be above \"from\"\n"
        "lesson.json:10:56: beats[0].sliders[3].step: must be above 0 and at most \"to\" - \"from\"\n"
        "lesson.json:10:68: beats[0].sliders[3].label: must not be empty\n"
        "lesson.json:12:10: beats[1].pause: must be \"wait\" or a number of seconds above 0, up to 60\n"
        "lesson.json:12:25: beats[1].sliders: must have at least 1 item, not 0\n");
}

TEST_CASE("hulls are of points; an empty list ends them") {
  const auto lesson =
      lesson_of(beat_with("\"start\"", R"("hull": ["P[0][*]"])") + ", " + beat_with("\"end\"", R"("hull": [])"));
  CHECK(lesson.beats[0].hulls == std::vector<std::string>{"P[0][*]"});
  REQUIRE(lesson.beats[1].hulls);
  CHECK(lesson.beats[1].hulls->empty());
  const std::string again = write_json(write_beat(lesson.beats[0], {}));
  CHECK(again.find(R"("hull": ["P[0][*]"])") != std::string::npos);
  CHECK(mistakes(beat_with("\"start\"", R"("hull": ["u", "P[9][*]"])")) ==
        "lesson.json:4:10: beats[0].hull[0]: must select points, not u\n"
        "lesson.json:4:15: beats[0].hull[1]: no value of this run is called \"P[9][*]\"; there are P[0][0..2], "
        "P[1][0..1], "
        "P[2][0]\n");
}

TEST_CASE("a placeholder that names nothing says what may be meant") {
  const auto said = [](const std::string& at, const std::string& say) {
    const std::string told = mistakes(beat(at, say));
    return told.substr(std::min(told.find("say: "), told.size()));
  };
  CHECK(said("\"P[1][0]\"", "{valeu}") == "say: \"{valeu}\" names nothing at step 1; did you mean \"value\"?\n");
  CHECK(said("\"P[1][0]\"", "{Value}") == "say: \"{Value}\" names nothing at step 1; did you mean \"value\"?\n");
  CHECK(said("\"P[1][0]\"", "{ u }") == "say: \"{ u }\" names nothing at step 1; did you mean \"u\"?\n");
  CHECK(said("\"P[1][0]\"", "{P[7][0]}") ==
        "say: \"{P[7][0]}\" names nothing at step 1; there are P[0][0..2], P[1][0..1], P[2][0]\n");
  CHECK(said("\"P[1][0]\"", "$\\\\value{nope}$") ==
        "say: \"{nope}\" names nothing at step 1; the values of this run are u, P[0][0..2], P[1][0..1], P[2][0], C\n");
  CHECK(
      said("\"start\"", "{value}") ==
      "say: \"{value}\" is about the value that a step makes, and the start makes none; name the one you mean, such as "
      "\"{u}\"\n");
}

TEST_CASE("a brace that is to be seen is written with a backslash") {
  const auto lesson = lesson_of(beat("\"P[1][0]\"", "The set \\\\{{u}\\\\}, and $\\\\{1\\\\}$."));
  const auto run = record<Exact>(*lesson.algorithm, lesson.inputs);
  CHECK(plain_text(read_prose(lesson.narration(Narrator<Exact>(*run), 1))) == "The set {1/4}, and {1}.");
}

TEST_CASE("sliders and cameras that cannot be meant so") {
  CHECK(mistakes(beat_with("\"start\"", R"("camera": {"fit": ["u"]}, "sliders": [
{"input": "u", "from": 0, "to": 1},
{"input": "curve.points[1][1]", "from": 0, "to": 5},
{"input": "curve.points[1][1]", "from": 0, "to": 6}])")) ==
        "lesson.json:4:20: beats[0].camera.fit[0]: must select points, which are to be seen\n"
        "lesson.json:7:11: beats[0].sliders[2].input: \"curve.points[1][1]\" has a slider here already\n");
}

TEST_CASE("counts are no texts, and seconds may be") {
  CHECK(mistakes(beat("\"end\""), parabola, header + "\"minutes\": \"5\", \"$schema\": 5, ") ==
        "lesson.json:1:82: minutes: is a count, and stands without quotation marks: 5\n"
        "lesson.json:1:98: [\"$schema\"]: must be a string, not 5\n");
  CHECK(lesson_of(beat_with("\"start\"", R"("pause": "3/2")")).beats[0].seconds == 1.5);
}
