// Scene files: what they say, every mistake at its place, and what hostile ones cost.

#include "studio/scene_file.hpp"

#include "lesson/catalog.hpp"
#include "scenes.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Checked<Workspace> read(const std::string& text) {
  const auto document = JsonDocument::parse("scene.json", text);
  if (!document) return document.diagnostics;
  return read_scene(*document);
}

std::string said(const std::string& objects) {
  return to_string(read("{\"schema\": \"blossom.scene/1\", \"objects\": [\n" + objects + "\n]}").diagnostics);
}

constexpr auto arc = R"({"name": "arc", "curve": {"degree": 2, "points": [[0, 0], [1, 2], [2, 0]]}})";

}  // namespace

TEST_CASE("what is written is read back as the same scene") {
  const unsigned seed = GENERATE(range(1u, 41u));
  INFO("seed " << seed);
  RandomScenes random(seed);
  const Workspace scene = random.scene(random.whole(0, 5), random.whole(0, 4));
  const Workspace again = read_back(scene);
  CHECK(again == scene);
  CHECK(write_scene(again) == write_scene(scene));
}

TEST_CASE("a scene says of a thing only what is not usual") {
  const Workspace scene = scene_of(arc);
  CHECK(scene.objects[0].u == Exact::ratio(1, 2));
  CHECK(scene.objects[0].shows == usual_shows(scene.objects[0].geometry));
  CHECK(write_scene(scene) == R"({
  "schema": "blossom.scene/1",
  "objects": [
    {
      "name": "arc",
      "curve": {"degree": 2, "points": [[0, 0], [1, 2], [2, 0]]}
    }
  ]
}
)");
}

TEST_CASE("every shipped scene can be made, has an id and a title, and is written as the same scene") {
  Diagnostics diagnostics;
  const auto files = json_files("lessons/scenes", diagnostics);
  REQUIRE(diagnostics.empty());
  REQUIRE(files.size() >= 3);
  for (const auto& file : files) {
    const auto scene = load_scene(file);
    INFO(file.string() << "\n" << to_string(scene.diagnostics));
    REQUIRE(scene);
    CHECK(scene->id == file.stem().string());
    CHECK(!scene->title.empty());
    CHECK(read_back(*scene) == *scene);
    for (const SceneObject& object : scene->objects) CHECK(object.problem.empty());
  }
}

TEST_CASE("angles are degrees in files and come back as the same radians") {
  Workspace scene;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> radians(-4, 4);
  for (int i = 0; i < 200; ++i) {
    scene.look = Look{Look::From::space, radians(random), radians(random), true};
    CHECK(read_back(scene) == scene);
  }
  scene.look = Look{Look::From::xz, 0.0, 0.0, false};
  CHECK_THAT(write_scene(scene),
             Catch::Contains(R"({"from": "xz", "azimuth": 0, "elevation": 0, "perspective": false})"));
}

TEST_CASE("all mistakes are said at once, each where it is") {
  CHECK(said(R"({"name": "a", "curve": {"degree": 0, "points": [[0, 0], [1, 1]]}, "color": 9, "shows": ["pionts"]},
{"name": "", "curve": {"degree": 1, "points": [[0, 0], [1, 1]]}},
{"name": "b", "surface": {"degree": [1, 1], "points": []}, "map": "mein", "size": 1},
{"name": "c"},
{"name": "d", "points": [[0, 0]], "u": 1})") ==
        R"(scene.json:2:35: objects[0].curve.degree: must be a whole number from 1 to 25, not 0
scene.json:2:76: objects[0].color: must be a whole number from 0 to 7, not 9
scene.json:2:89: objects[0].shows[0]: must be one of "points", "indices", "polygon", "knots", "point", "hull", "net", "triad", "transport", "circle", "sphere", "comb", "hodograph", "projection", "isolines", "principal", "faces"; did you mean "points"?
scene.json:3:10: objects[1].name: must have 1 to 64 characters
scene.json:4:55: objects[2].surface.points: must have at least 1 item, not 0
scene.json:4:67: objects[2].map: must be one of "none", "gaussian", "mean", "largest", "smallest", "isophotes", "reflection"; did you mean "mean"?
scene.json:4:75: objects[2]: unknown key "size"; the keys here are "name", "curve", "surface", "points", "net", "made", "color", "hidden", "shows", "u", "v" and "map"
scene.json:5:1: objects[3]: must have one of "curve", "surface", "points", "net" and "made"
scene.json:6:40: objects[4].u: there is no u on points
)");
}

TEST_CASE("of what a thing is made: names before it, inputs of the algorithm, and nothing else") {
  const auto made = [](const std::string& recipe) {
    return said(std::string(arc) + ",\n{\"name\": \"made\", \"made\": " + recipe + "},\n" +
                R"({"name": "later", "curve": {"degree": 1, "points": [[0, 0], [1, 1]]}})");
  };
  CHECK(made(R"({"algorithm": "de_casteljau", "inputs": {"curve": {"object": "arc"}, "u": 0.5}})").empty());
  CHECK_THAT(made(R"({"algorithm": "de_casteljau", "inputs": {"curve": {"object": "ark"}, "u": 0.5}})"),
             Catch::EndsWith("objects[1].made.inputs.curve.object: there is no object \"ark\" before this one; did you "
                             "mean \"arc\"?\n"));
  CHECK_THAT(made(R"({"algorithm": "de_casteljau", "inputs": {"curve": {"object": "later"}, "u": 0.5}})"),
             Catch::EndsWith("\"later\" comes later: an object can only be made from those before it\n"));
  CHECK_THAT(made(R"({"algorithm": "de_casteljau", "inputs": {"curve": {"object": "made"}, "u": 0.5}})"),
             Catch::EndsWith("\"made\" comes later: an object can only be made from those before it\n"));
  CHECK_THAT(made(R"({"algorithm": "de_casteljau", "inputs": {"curve": {"object": "arc"}, "u": 2}})"),
             Catch::EndsWith("objects[1].made.inputs.u: must lie in the domain [0, 1], not at 2\n"));
  CHECK_THAT(made(R"({"algorithm": "de_casteljau", "inputs": {"curve": {"object": "arc"}}})"),
             Catch::Contains("objects[1].made.inputs: is missing: The parameter"));
  CHECK_THAT(made(R"({"algorithm": "de_casteljou", "inputs": {}})"), Catch::Contains("did you mean \"de_casteljau\"?"));
  CHECK_THAT(made(R"({"algorithm": "skinning", "inputs": {"profiles": [{"object": "arc"}], "degree_v": 1}})"),
             Catch::EndsWith("objects[1].made.inputs.profiles: needs at least 2 curves, not 1\n"));
  CHECK_THAT(made(R"({"algorithm": "degree_elevation", "inputs": {"curve": {"object": "arc", "scale": 0}}})"),
             Catch::EndsWith("inputs.curve.scale: must not be 0, which would leave nothing of it\n"));
  CHECK_THAT(made(R"({"algorithm": "degree_elevation", "inputs": {"curve": {"object": "arc"}}, "result": 1})"),
             Catch::EndsWith("objects[1].made.inputs: there are 1 pieces, none of number 1\n"));
}

TEST_CASE("what is made of something with a mistake is not blamed for it") {
  CHECK(said(R"({"name": "a", "curve": {"degree": 1, "points": [[0, 0], [1, "x"]]}},
{"name": "b", "made": {"algorithm": "degree_elevation", "inputs": {"curve": {"object": "a"}}}},
{"name": "c", "made": {"algorithm": "degree_elevation", "inputs": {"curve": {"object": "b"}}}})") ==
        "scene.json:2:61: objects[0].curve.points[1][1]: must be a number or an exact string such as \"2/5\", not "
        "\"x\"\n");
}

TEST_CASE("a name stands once") {
  CHECK_THAT(said(std::string(arc) + "," + arc),
             Catch::EndsWith("objects[1].name: \"arc\" is the name of an object before this one already\n"));
}

TEST_CASE("curves may stand in a recipe themselves") {
  const Workspace scene = scene_of(
      R"({"name": "up", "made": {"algorithm": "degree_elevation", "inputs": {
        "curve": {"degree": 1, "points": [[0, 0], [2, 2]]}, "times": 2}}})");
  CHECK(curve_in(scene, "up").degree == 3);
  CHECK(read_back(scene) == scene);
}

TEST_CASE("an instance is placed as the file says") {
  const Workspace scene = scene_of(std::string(arc) + R"(,
    {"name": "there", "made": {"algorithm": "de_casteljau", "inputs": {
      "curve": {"object": "arc", "scale": 2, "turn": [90, 0, 0], "move": [0, 0, 1]}, "u": "1/2"}}})");
  CHECK(place_of(scene.objects[1].geometry, 0) == Point<Exact>(2, 0, 3));
}

TEST_CASE("what is not a scene says so") {
  CHECK(
      to_string(read("{\"schema\": \"blossom.scene/2\", \"objects\": []}").diagnostics) ==
      "scene.json:1:12: schema: must be \"blossom.scene/1\", not \"blossom.scene/2\"; this program does not know that "
      "version\n");
  CHECK(!read("[]"));
  CHECK(!read("{\"objects\": 1}"));
  CHECK(!load_scene("lessons/scenes/there-is-no-such.json"));
}

TEST_CASE("hostile scenes are refused before they cost much") {
  std::string many = arc;
  for (int i = 0; i < 1000; ++i) many += R"(,{"name": ")" + std::to_string(i) + R"(", "points": [[0, 0]]})";
  CHECK_THAT(said(many), Catch::Contains("at most 1000"));

  // Each doubles the points of the one before.
  std::string doubling = arc;
  std::string before = "arc";
  for (int i = 0; i < 40; ++i) {
    const std::string name = "p" + std::to_string(i);
    doubling += R"(,{"name": ")" + name +
                R"(", "made": {"algorithm": "degree_elevation", "inputs": {"curve": {"object": ")" + before +
                R"("}, "times": 22}}})";
    before = name;
  }
  CHECK(!said(doubling).empty());

  std::string row = "[[0, 0]";
  for (int i = 0; i < 65'000; ++i) row += ", [1, 1]";
  row += "]";
  std::string rows;
  for (int i = 0; i < 5; ++i)
    rows += std::string(i > 0 ? "," : "") + R"({"name": "r)" + std::to_string(i) + R"(", "points": )" + row + "}";
  CHECK_THAT(said(rows), Catch::Contains("a scene has at most 262144 control points in all"));
}
