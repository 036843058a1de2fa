// What can be done with what is chosen, told from the table of algorithms alone.

#include "scenes.hpp"
#include "studio/remake.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

// Something of each kind, and more of what constructions are made from.
Workspace one_of_each() {
  return scene_of(R"(
    {"name": "bezier", "curve": {"degree": 3, "points": [[1, 0, 0], [2, 0, 1], [1, 0, 2], [2, 0, 3]]}},
    {"name": "bspline", "curve": {"degree": 2, "knots": [0, 0, 0, 1, 2, 2, 3, 3, 3],
      "points": [[0, 0, 0], [1, 1, 0], [2, 0, 0], [3, 2, 0], [4, 0, 0], [5, 1, 0]]}},
    {"name": "line", "curve": {"degree": 1, "points": [[0, 0, 0], [0, 0, 3]]}},
    {"name": "closed", "curve": {"degree": 2, "knots": [-2, -1, 0, 1, 2, 3, 4, 5],
      "points": [[0, 0, 4], [1, 0, 5], [0, 1, 5], [0, 0, 4], [1, 0, 5]]}},
    {"name": "plane", "curve": {"degree": 2, "points": [[1, 0], [2, 1], [1, 2]]}},
    {"name": "surface", "surface": {"degree": [2, 2], "knots": [[0, 0, 0, 1, 1, 2, 2, 2], [0, 0, 0, 1, 1, 1]],
      "points": [[[0, 0, 0], [0, 1, 0], [0, 2, 0]], [[1, 0, 1], [1, 1, 0], [1, 2, 0]], [[2, 0, 0], [2, 1, 0], [2, 2, 0]],
                 [[3, 0, 1], [3, 1, 0], [3, 2, 0]], [[4, 0, 1], [4, 1, 0], [4, 2, 1]]]}},
    {"name": "row", "points": [[0, 0], [1, 2], [3, 3], [5, 1], [6, 4], [8, 2]]},
    {"name": "place", "points": [[1, 2]]},
    {"name": "two", "points": [[0, 0], [3, 2]]},
    {"name": "net", "net": [[[0, 0, 0], [0, 1, 0], [0, 2, 1], [0, 3, 0]], [[1, 0, 1], [1, 1, 0], [1, 2, 0], [1, 3, 1]],
                            [[2, 0, 0], [2, 1, 1], [2, 2, 0], [2, 3, 0]], [[3, 0, 1], [3, 1, 0], [3, 2, 1], [3, 3, 0]]]},
    {"name": "b0", "curve": {"degree": 1, "points": [[0, 0, 0], [3, 0, 0]]}},
    {"name": "b1", "curve": {"degree": 1, "points": [[0, 3, 0], [3, 3, 0]]}},
    {"name": "l0", "curve": {"degree": 1, "points": [[0, 0, 0], [0, 3, 0]]}},
    {"name": "l1", "curve": {"degree": 1, "points": [[3, 0, 0], [3, 3, 0]]}})");
}

std::vector<std::size_t> named(const Workspace& scene, const std::vector<std::string>& names) {
  std::vector<std::size_t> objects;
  for (const auto& name : names) objects.push_back(*scene.index_of(name));
  return objects;
}

}  // namespace

TEST_CASE("every algorithm can be applied to something, with parameters that do") {
  const Workspace scene = one_of_each();
  const std::vector<std::vector<std::string>> choices{{"bezier"},
                                                      {"bspline"},
                                                      {"closed"},
                                                      {"plane"},
                                                      {"surface"},
                                                      {"row"},
                                                      {"net"},
                                                      {"place"},
                                                      {"plane", "two"},
                                                      {"bezier", "plane"},
                                                      {"bezier", "line"},
                                                      {"bezier", "bspline"},
                                                      {"b0", "b1"},
                                                      {"b0", "b1", "l0", "l1"},
                                                      {"b0", "b1", "line"}};
  for (const Algorithm* algorithm : algorithms()) {
    std::string tried;
    bool made = false;
    for (const auto& names : choices) {
      const auto objects = named(scene, names);
      if (!takes(*algorithm, scene, objects)) continue;
      const auto worked = edit::add_made(scene, recipe_for(*algorithm, scene, objects));
      tried += names.front() + " (" + std::to_string(names.size()) + "): " + to_string(worked.diagnostics) + "\n";
      made = made || worked.value.has_value();
    }
    INFO(algorithm->id << "\n" << tried);
    CHECK(made);
  }
}

TEST_CASE("a polar form is offered with as many arguments as the curve's degree, inside of the domain") {
  const Workspace scene = one_of_each();
  for (const auto& [name, degree] : {std::pair("bezier", 3), std::pair("bspline", 2), std::pair("line", 1)}) {
    const Recipe recipe = recipe_for(*find_algorithm("polar_form"), scene, named(scene, {name}));
    const auto inputs = inputs_of(scene, recipe, scene.objects.size());
    INFO(name << "\n" << to_string(inputs.diagnostics));
    REQUIRE(inputs);
    const auto& arguments = inputs->numbers("arguments");
    CHECK(static_cast<int>(arguments.size()) == degree);
    CHECK(std::ranges::is_sorted(arguments));
    const auto domain = domain_of(inputs->curve("curve"), 0);
    CHECK(domain->first < arguments.front());
    CHECK(arguments.back() < domain->second);
  }
}

TEST_CASE("what is offered for a choice takes all of it") {
  const Workspace scene = one_of_each();
  for (const auto& objects : {named(scene, {"bezier"}), named(scene, {"row"}), named(scene, {"surface"}),
                              named(scene, {"b0", "b1"}), named(scene, {"b0", "b1", "line"})}) {
    const auto offered = algorithms_for(scene, objects);
    for (const Algorithm* algorithm : offered)
      CHECK(sources_of(recipe_for(*algorithm, scene, objects)).size() == objects.size());
    CHECK(std::ranges::is_sorted(offered, {}, [](const Algorithm* each) { return each->family; }));
  }
  CHECK(algorithms_for(scene, {}).empty());
  CHECK(algorithms_for(scene, named(scene, {"surface", "row", "net"})).empty());
}

TEST_CASE("an algorithm is not offered for a curve it cannot take") {
  const Workspace scene = one_of_each();
  CHECK(takes(*find_algorithm("de_casteljau"), scene, named(scene, {"bezier"})));
  CHECK(!takes(*find_algorithm("de_casteljau"), scene, named(scene, {"bspline"})));
  CHECK(!takes(*find_algorithm("de_casteljau"), scene, named(scene, {"row"})));
  CHECK(!takes(*find_algorithm("de_casteljau"), scene, named(scene, {"bezier", "plane"})));
  CHECK(!takes(*find_algorithm("skinning"), scene, named(scene, {"bezier"})));
  CHECK(takes(*find_algorithm("skinning"), scene, named(scene, {"bezier", "plane", "line"})));
}

TEST_CASE("parameters are where one looks at the thing; curves stand in the order in which they were chosen") {
  Workspace scene = one_of_each();
  scene.objects[0].u = Exact::ratio(1, 5);
  const Recipe point = recipe_for(*find_algorithm("de_casteljau"), scene, {0});
  CHECK(std::get<InputValue<Exact>>(point.inputs.find("u")->second) == InputValue<Exact>(Exact::ratio(1, 5)));
  const Recipe skin = recipe_for(*find_algorithm("skinning"), scene, named(scene, {"line", "bezier"}));
  const auto& profiles = std::get<std::vector<Reference>>(skin.inputs.find("profiles")->second);
  CHECK(profiles == std::vector<Reference>{{"line", {}}, {"bezier", {}}});
}

TEST_CASE("a point of an evaluation is a row of one point, in the plane if the curve is") {
  const Workspace scene = one_of_each();
  const auto made =
      made_by(scene, recipe_for(*find_algorithm("de_boor"), scene, named(scene, {"plane"})), scene.objects.size());
  REQUIRE(made);
  CHECK(std::get<PointRow<Exact>>(made->front()).dimension == 2);
  CHECK(place_of(made->front(), 0) == Point<Exact>(Exact::ratio(3, 2), 1, 0));
}

TEST_CASE("all pieces of a result become things, and follow together") {
  const Workspace scene = one_of_each();
  const Workspace cut = taken(edit::add_made(scene, recipe_for(*find_algorithm("subdivision"), scene, {1})));
  REQUIRE(cut.objects.size() == scene.objects.size() + 2);
  const std::size_t first = scene.objects.size();
  CHECK(cut.objects[first].name == "subdivision");
  CHECK(cut.objects[first + 1].name == "subdivision 2");
  CHECK(curve_in(cut, "subdivision").points.back() == curve_in(cut, "subdivision 2").points.front());
  const Workspace moved = taken(edit::move_points(cut, {{1, 3}}, {Exact(0), Exact(5), Exact(1)}));
  CHECK(curve_in(moved, "subdivision 2") != curve_in(cut, "subdivision 2"));
  CHECK(curve_in(moved, "subdivision").points.back() == curve_in(moved, "subdivision 2").points.front());
  CHECK(read_back(moved) == moved);
}

TEST_CASE("a curve stands for its control points where points are wanted, but not one without a place") {
  Workspace scene = scene_of(R"({"name": "curve", "curve": {"degree": 2, "points": [[0, 0], [1, 2], [2, 0]],
    "weights": [1, 0, 1]}})");
  const Algorithm* with_points = nullptr;
  for (const Algorithm* each : algorithms())
    if (each->family == Family::fitting && each->inputs.front().type == InputSpec::Type::points) with_points = each;
  if (with_points == nullptr) return;  // no such algorithm yet
  CHECK(!takes(*with_points, scene, {0}));
  scene = taken(edit::set_weight(scene, {0, 1}, Exact(2)));
  scene = taken(edit::set_place(scene, {0, 1}, {Exact(1), Exact(2), Exact(0)}));
  CHECK(std::get<std::vector<Reference>>(recipe_for(*with_points, scene, {0}).inputs.find("points")->second).size() ==
        1);
}
