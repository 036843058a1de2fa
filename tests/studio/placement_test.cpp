// Instances: affine maps of control points are affine maps of what is made of them.

#include "studio/placement.hpp"

#include "kernel/evaluate.hpp"
#include "scenes.hpp"

using namespace blossom;
using namespace blossom::test;

TEST_CASE("a curve is placed with its control points, exactly") {
  const unsigned seed = GENERATE(range(1u, 41u));
  INFO("seed " << seed);
  RandomScenes random(seed);
  const Curve<Exact> curve = random.curve(random.whole(2, 3));
  const Placement place = random.placement();
  const Curve<Exact> there = placed(curve, place);
  for (int i = 0; i < 8; ++i) {
    const Exact u = random_parameter(random.engine(), curve.knots, curve.degree);
    const auto P = point(curve, u), Q = point(there, u);
    REQUIRE(P);
    REQUIRE(Q);
    CHECK(placed(*P, place) == *Q);
  }
}

TEST_CASE("placing what is made is making of what is placed, for algorithms that only blend points") {
  const std::string id = GENERATE("de_boor", "knot_insertion", "degree_elevation", "skinning");
  const unsigned seed = GENERATE(range(1u, 11u));
  INFO(id << ", seed " << seed);
  RandomScenes random(seed);
  Workspace scene;
  for (int i = 0; i < 3; ++i) {
    SceneObject object;
    object.name = "curve";
    object.geometry = random.curve(3);
    look_at_middle(object);
    scene = taken(edit::add(scene, object));
  }
  const Algorithm& algorithm = *find_algorithm(id);
  Recipe recipe =
      recipe_for(algorithm, scene, id == "skinning" ? std::vector<std::size_t>{0, 1, 2} : std::vector<std::size_t>{0});
  if (id == "skinning") recipe.inputs["parametrization"] = InputValue<Exact>(std::string("uniform"));
  const auto here = made_by(scene, recipe, 3);
  if (!here) return;  // profiles that coincide, say
  const Placement place = random.placement();
  for (auto& [input, ingredient] : recipe.inputs)
    if (auto* references = std::get_if<std::vector<Reference>>(&ingredient))
      for (Reference& reference : *references) reference.place = place;
  const auto there = made_by(scene, recipe, 3);
  INFO(to_string(there.diagnostics));
  REQUIRE(there);
  REQUIRE(there->size() == here->size());
  for (std::size_t i = 0; i < here->size(); ++i)
    CHECK(std::visit([&](const auto& each) -> Geometry { return placed(each, place); }, (*here)[i]) == (*there)[i]);
}

TEST_CASE("scaling comes first, then the turns about x, y and z, then the move") {
  const Point<Exact> P(1, 2, 3);
  CHECK(placed(P, {.scale = {Exact(2), Exact(1), Exact(-1)}}) == Point<Exact>(2, 2, -3));
  CHECK(placed(P, {.turn = {Exact(90), Exact(0), Exact(0)}}) == Point<Exact>(1, -3, 2));
  CHECK(placed(P, {.turn = {Exact(0), Exact(90), Exact(0)}}) == Point<Exact>(3, 2, -1));
  CHECK(placed(P, {.turn = {Exact(0), Exact(0), Exact(90)}}) == Point<Exact>(-2, 1, 3));
  CHECK(placed(P, {.turn = {Exact(90), Exact(0), Exact(90)}}) == Point<Exact>(3, 1, 2));
  CHECK(placed(P, {.scale = {Exact(2), Exact(2), Exact(2)},
                   .turn = {Exact(0), Exact(0), Exact(-270)},
                   .move = {Exact(1), Exact(0), Exact(0)}}) == Point<Exact>(-3, 2, 6));
}

TEST_CASE("turns by quarters are exact, whatever their number; others keep lengths and add up") {
  const Point<Exact> P(3, 4, 0);
  for (const int quarters : {-1001, -4, 1, 2, 3, 8, 400'000'003}) {
    const Point<Exact> Q = placed(P, {.turn = {Exact(0), Exact(0), Exact(90) * Exact(quarters)}});
    CHECK(!Q.x.is_approximate());
    CHECK(Q.x * Q.x + Q.y * Q.y == Exact(25));
  }
  Point<Exact> turned = P;
  for (int i = 0; i < 9; ++i) turned = placed(turned, {.turn = {Exact(0), Exact(0), Exact(40)}});
  CHECK(turned.x.is_approximate());
  CHECK(!turned.z.is_approximate());
  CHECK(distance(rounded(turned), rounded(P)) < 1e-14);
}

TEST_CASE("a plane curve that is turned out of its plane is spatial; one that stays is not") {
  const Curve<Exact> curve{1, {0, 0, 1, 1}, {{0, 0, 0, 1}, {2, 2, 0, 2}}, 2, true, true};
  CHECK(placed(curve, {.turn = {Exact(0), Exact(0), Exact(30)}}).dimension == 2);
  const Curve<Exact> up = placed(curve, {.turn = {Exact(90), Exact(0), Exact(0)}});
  CHECK(up.dimension == 3);
  CHECK(up.points[1] == HPoint<Exact>(2, 0, 2, 2));  // the weight stays
  CHECK(placed(curve, {.move = {Exact(0), Exact(0), Exact(1)}}).points[1] == HPoint<Exact>(2, 2, 2, 2));
}

TEST_CASE("about a centre, the centre stays") {
  const unsigned seed = GENERATE(range(1u, 21u));
  INFO("seed " << seed);
  RandomScenes random(seed);
  Placement place = random.placement();
  place.move = {Exact(0), Exact(0), Exact(0)};
  const Point<Exact> centre = random.place(), P = random.place();
  CHECK(placed(centre, about(place, centre)) == centre);
  // The way from the centre is mapped as from the origin.
  const Point<Exact> way(P.x - centre.x, P.y - centre.y, P.z - centre.z), there = placed(P, about(place, centre));
  CHECK(placed(way, place) == Point<Exact>(there.x - centre.x, there.y - centre.y, there.z - centre.z));
}
