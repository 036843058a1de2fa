// Edits of a scene: what follows from what, and that every scene they make is one a file can hold.

#include "studio/edit_workspace.hpp"

#include "kernel/evaluate.hpp"
#include "scenes.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr auto a_curve_and_a_point = R"(
  {"name": "arc", "curve": {"degree": 2, "points": [[0, 0], [1, 2], [2, 0]]}},
  {"name": "point", "made": {"algorithm": "de_casteljau", "inputs": {"curve": {"object": "arc"}, "u": "1/2"}}},
  {"name": "longer", "made": {"algorithm": "degree_elevation", "inputs": {"curve": {"object": "arc"}}}})";

Point<Exact> only_point(const Workspace& workspace, std::string_view name) {
  return *place_of(workspace.find(name)->geometry, 0);
}

std::string said(const Worked& worked) { return to_string(worked.diagnostics); }

// Every made thing is what its recipe gives of the things as they are now.
void check_that_all_is_made(const Workspace& workspace) {
  for (std::size_t i = 0; i < workspace.objects.size(); ++i) {
    const SceneObject& object = workspace.objects[i];
    if (!object.recipe || !object.problem.empty()) continue;
    const auto pieces = made_by(workspace, *object.recipe, i);
    INFO(object.name << ": " << to_string(pieces.diagnostics));
    REQUIRE(pieces);
    CHECK((*pieces)[object.recipe->which] == object.geometry);
  }
}

double difference(const Geometry& a, const Geometry& b) {
  REQUIRE(a.index() == b.index());
  REQUIRE(point_count(a) == point_count(b));
  double largest = 0;
  for (std::size_t i = 0; i < point_count(a); ++i) {
    const auto P = place_of(a, i), Q = place_of(b, i);
    REQUIRE(P.has_value() == Q.has_value());
    if (P) largest = std::max(largest, distance(rounded(*P), rounded(*Q)));
  }
  return largest;
}

}  // namespace

TEST_CASE("any scene that edits make is one a file can hold, with everything in it made of what it says") {
  const unsigned seed = GENERATE(range(1u, 25u));
  INFO("seed " << seed);
  RandomScenes random(seed);
  Workspace workspace = random.scene(4, 3);
  std::string history;
  int refused = 0;
  for (int i = 0; i < 60; ++i) {
    const Workspace before = workspace;
    auto [what, worked] = random.next(workspace);
    CHECK(workspace == before);
    history += what + (worked ? "" : " (refused)") + "\n";
    INFO(history);
    if (!worked) {
      CHECK(!worked.diagnostics.empty());
      ++refused;
      continue;
    }
    workspace = std::move(*worked);
    if (i % 10 == 9) {
      CHECK(read_back(workspace) == workspace);
      check_that_all_is_made(workspace);
    }
  }
  CHECK(refused < 50);
}

TEST_CASE("what is made follows what it is made from, and is undone by keeping the scene before") {
  const Workspace before = scene_of(a_curve_and_a_point);
  CHECK(only_point(before, "point") == Point<Exact>(1, 1, 0));
  const Workspace after = taken(edit::move_points(before, {{0, 1}}, {Exact(0), Exact(2), Exact(0)}));
  CHECK(only_point(after, "point") == Point<Exact>(1, 2, 0));
  CHECK(curve_in(after, "longer").points[1] == HPoint<Exact>(Exact::ratio(2, 3), Exact::ratio(8, 3), 0, 1));
  CHECK(before == scene_of(a_curve_and_a_point));
}

TEST_CASE("a made thing that is edited itself is given from then on") {
  const Workspace scene = scene_of(a_curve_and_a_point);
  const Workspace moved = taken(edit::set_place(scene, {2, 0}, {Exact(-1), Exact(0), Exact(0)}));
  CHECK(!moved.find("longer")->recipe);
  CHECK(moved.find("point")->recipe);
  const Workspace later = taken(edit::move_points(moved, {{0, 1}}, {Exact(5), Exact(5), Exact(0)}));
  CHECK(curve_in(later, "longer") == curve_in(moved, "longer"));
}

TEST_CASE("what loses its source keeps its shape and is given") {
  const Workspace scene = scene_of(a_curve_and_a_point);
  const Workspace rest = taken(edit::remove(scene, {0}));
  REQUIRE(rest.objects.size() == 2);
  CHECK(!rest.objects[0].recipe);
  CHECK(!rest.objects[1].recipe);
  CHECK(curve_in(rest, "longer") == curve_in(scene, "longer"));
  CHECK(read_back(rest) == rest);
}

TEST_CASE("recipes follow a new name; a name stands once") {
  const Workspace scene = scene_of(a_curve_and_a_point);
  const Workspace renamed = taken(edit::rename(scene, 0, "Bogen"));
  CHECK(sources_of(*renamed.find("point")->recipe) == std::vector<std::string>{"Bogen"});
  CHECK(taken(edit::move_points(renamed, {{0, 1}}, {Exact(0), Exact(2), Exact(0)})).find("point")->problem.empty());
  CHECK(said(edit::rename(scene, 0, "point")) == "name: \"point\" is the name of another thing\n");
  CHECK(said(edit::rename(scene, 0, "")) == "name: must have 1 to 64 characters\n");
  CHECK(said(edit::rename(scene, 0, std::string(65, 'x'))) == "name: must have 1 to 64 characters\n");
  CHECK(said(edit::rename(scene, 0, "a\nb")) == "name: must be of characters that can be seen, on one line\n");
  CHECK(edit::rename(scene, 0, "arc"));
}

TEST_CASE("a thing stands behind what it is made from, wherever it is moved") {
  const Workspace scene = scene_of(a_curve_and_a_point);
  CHECK(said(edit::move_to(scene, 1, 0)) == "point: is made from \"arc\", which must stand before it\n");
  CHECK(said(edit::move_to(scene, 0, 2)) == "arc: \"point\" is made from it and must stand behind it\n");
  const Workspace swapped = taken(edit::move_to(scene, 1, 2));
  CHECK(swapped.objects[1].name == "longer");
  CHECK(read_back(swapped) == swapped);
}

TEST_CASE("copies of a thing and of what is made from it hang together; a copy alone is given") {
  const Workspace scene = scene_of(a_curve_and_a_point);
  const Workspace both = taken(edit::duplicate(scene, {2, 0}));
  REQUIRE(both.objects.size() == 5);
  CHECK(both.objects[3].name == "arc 2");
  CHECK(sources_of(*both.objects[4].recipe) == std::vector<std::string>{"arc 2"});
  check_that_all_is_made(both);
  CHECK(curve_in(both, "longer 2") != curve_in(both, "longer"));

  const Workspace alone = taken(edit::duplicate(scene, {2}));
  CHECK(!alone.objects[3].recipe);
  CHECK(curve_in(alone, "longer 2") != curve_in(alone, "longer"));
}

TEST_CASE("while one drags, what follows is made in doubles, and agrees with what is exact in the end") {
  const unsigned seed = GENERATE(range(1u, 20u));
  INFO("seed " << seed);
  RandomScenes random(seed);
  Workspace scene = random.scene(3, 4);
  const std::vector<PointRef> point{{random.index(3), 0}};
  const Point<Exact> by{Exact::ratio(1, 3), Exact::ratio(-1, 7), Exact(0)};
  const auto dragged = edit::move_points(scene, point, by, true), final = edit::move_points(scene, point, by);
  REQUIRE(dragged.value.has_value() == final.value.has_value());
  if (!final) return;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    INFO(scene.objects[i].name << ": " << dragged->objects[i].problem << " / " << final->objects[i].problem);
    CHECK(dragged->objects[i].problem.empty() == final->objects[i].problem.empty());
    CHECK(difference(dragged->objects[i].geometry, final->objects[i].geometry) < 1e-6);
  }
}

TEST_CASE("numbers are exact where that takes little time, and marked where it does not") {
  const Workspace scene = scene_of(a_curve_and_a_point);
  CHECK(!only_point(scene, "point").x.is_approximate());
  const Workspace dragged = taken(edit::move_points(scene, {{0, 1}}, {Exact(0), Exact(2), Exact(0)}, true));
  CHECK(only_point(dragged, "point").x.is_approximate());

  // Each level of the triangle doubles the length of the fractions.
  std::string points;
  for (int i = 0; i <= 25; ++i)
    points += (i > 0 ? ", " : "") + std::string("[\"1/") + std::to_string(1'000'003 + 2 * i) + "\", \"1/" +
              std::to_string(1'000'033 + 4 * i) + "\"]";
  const std::string longer = R"({"name": "long", "curve": {"degree": 25, "points": [)" + points + R"(]}},
    {"name": "point", "made": {"algorithm": "de_casteljau", "inputs": {"curve": {"object": "long"},
      "u": "1)" + std::string(180, '3') +
                             "/2" + std::string(180, '7') + R"("}}})";
  CHECK(only_point(scene_of(longer), "point").x.is_approximate());
}

TEST_CASE("only what follows from a change is made anew") {
  std::string objects;
  for (int i = 0; i < 50; ++i) {
    const std::string n = std::to_string(i);
    objects += (i > 0 ? "," : "") + std::string(R"({"name": "curve )") + n +
               R"(", "curve": {"degree": 2, "points": [[0, 0], [1, 2], [2, 0]]}},
               {"name": "made )" +
               n + R"(", "made": {"algorithm": "degree_elevation", "inputs": {"curve": {"object":
               "curve )" +
               n + R"("}}}})";
  }
  Workspace scene = scene_of(objects);
  // A thing that somebody spoilt shows whether it was made again.
  const Geometry spoilt = scene.objects[0].geometry;
  for (std::size_t i = 1; i < 100; i += 2) scene.objects[i].geometry = spoilt;
  const Workspace after = taken(edit::move_points(scene, {{20, 0}}, {Exact(1), Exact(0), Exact(0)}));
  for (std::size_t i = 1; i < 100; i += 2) CHECK((after.objects[i].geometry == spoilt) == (i != 21));
}

TEST_CASE("a thing that cannot be made any more keeps its shape, says why, and survives its file") {
  const Workspace scene = scene_of(R"(
    {"name": "a", "curve": {"degree": 1, "points": [[0, 0], [2, 0]]}},
    {"name": "point", "made": {"algorithm": "de_casteljau", "inputs": {"curve": {"object": "a"}, "u": "1/2"}}},
    {"name": "behind", "made": {"algorithm": "degree_elevation", "inputs": {"curve": {"object": "a"}}}})");
  const Workspace spline = taken(
      edit::change(scene, 0, [](Curve<Exact> curve) { return edit::set_kind(std::move(curve), CurveKind::bspline); }));
  const Workspace after = taken(edit::insert_point(spline, {0, 0}, {Exact(1), Exact(1), Exact(0)}));
  CHECK_THAT(after.find("point")->problem, Catch::StartsWith("curve: "));
  CHECK(after.find("point")->geometry == scene.find("point")->geometry);
  CHECK(after.find("behind")->problem.empty());
  CHECK(read_back(after) == after);
  const Workspace again = taken(
      edit::change(after, 0, [](Curve<Exact> curve) { return edit::set_kind(std::move(curve), CurveKind::bezier); }));
  CHECK(again.find("point")->problem.empty());
}

TEST_CASE("an instance is placed for itself") {
  const Workspace scene = scene_of(R"(
    {"name": "line", "curve": {"degree": 1, "points": [[0, 0, 0], [1, 0, 0]]}},
    {"name": "sheet", "made": {"algorithm": "skinning", "inputs": {"profiles": [
      {"object": "line"}, {"object": "line", "move": [0, 1, 0]}], "degree_v": 1}}})");
  const Placement up{.move = {Exact(0), Exact(1), Exact(3)}};
  const Workspace after = taken(edit::place_instance(scene, 1, "profiles", 1, up));
  CHECK(surface_in(after, "sheet").at(1, 1) == HPoint<Exact>(1, 1, 3, 1));
  CHECK(surface_in(after, "sheet").at(1, 0) == HPoint<Exact>(1, 0, 0, 1));
  CHECK(said(edit::place_instance(scene, 1, "profiles", 2, up)) == "profiles[2]: there is no such instance\n");
  CHECK(said(edit::place_instance(scene, 0, "profiles", 0, up)) == "there is no such made thing in the scene\n");
}

TEST_CASE("a selected point and its twin move once") {
  const Workspace scene = scene_of(R"({"name": "ring", "curve": {"degree": 2, "knots": [-2, -1, 0, 1, 2, 3, 4, 5],
    "points": [[0, 0], [1, 0], [0, 1], [0, 0], [1, 0]]}})");
  const Workspace after = taken(edit::move_points(scene, {{0, 0}, {0, 3}}, {Exact(0), Exact(-1), Exact(0)}));
  CHECK(*place_of(after.objects[0].geometry, 0) == Point<Exact>(0, -1, 0));
  CHECK(*place_of(after.objects[0].geometry, 3) == Point<Exact>(0, -1, 0));
}

TEST_CASE("what is wrong with an edit is said with the thing's name and the place in it") {
  const Workspace scene = scene_of(a_curve_and_a_point);
  CHECK(said(edit::set_weight(scene, {0, 0}, Exact(-1))) ==
        "arc.weights[0]: a weight must not be negative, not -1\n" + std::string());
  CHECK(said(edit::set_weight(scene, {1, 0}, Exact(2))) ==
        "point.weights[0]: points that are no control points have no weights\n");
  CHECK(said(edit::set_place(scene, {0, 3}, {Exact(0), Exact(0), Exact(0)})) ==
        "arc.points[3]: there is no such control point\n");
  CHECK(said(edit::set_place(scene, {7, 3}, {Exact(0), Exact(0), Exact(0)})) ==
        "there is no such thing in the scene\n");
  CHECK(said(edit::set_map(scene, 0, SurfaceMap::mean)) == "arc: is no surface, and only those have maps\n");
  CHECK(said(edit::set_color(scene, 0, 8)) == "color: must be from 0 to 7, not 8\n");
}

TEST_CASE("a scene has no more than a thousand things") {
  Workspace scene = scene_of(a_curve_and_a_point);
  const SceneObject arc = scene.objects[0];
  while (scene.objects.size() < most_objects) {
    scene.objects.push_back(arc);
    scene.objects.back().name = "arc " + std::to_string(scene.objects.size());
  }
  CHECK(said(edit::add(scene, arc)) == "a scene has at most 1000 things\n");
  CHECK(said(edit::duplicate(scene, {0})) == "a scene has at most 1000 things\n");
}
