// Borders that are C1 stay C1 while one side is edited.

#include <catch2/catch.hpp>
#include <random>

#include "algorithms/run.hpp"
#include "kernel/splines.hpp"
#include "kernel/subdivision.hpp"
#include "kernel/surface_subdivision.hpp"
#include "studio/seams.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

Workspace scene_of(std::vector<Geometry> all) {
  Workspace scene;
  for (std::size_t i = 0; i < all.size(); ++i) {
    SceneObject object;
    object.name = "piece " + std::to_string(i);
    object.geometry = std::move(all[i]);
    look_at_middle(object);
    scene.objects.push_back(std::move(object));
  }
  return scene;
}

// A curve cut at a parameter inside, as the algorithm does it.
std::vector<Geometry> cut(const Curve<Exact>& curve, const Exact& u) {
  Inputs<Exact> inputs;
  inputs.values.emplace("curve", curve);
  inputs.values.emplace("u", u);
  const auto made = run_plain<Exact>(*find_algorithm("subdivision"), inputs);
  REQUIRE(made);
  std::vector<Geometry> pieces;
  for (const auto& piece : std::get<std::vector<Curve<Exact>>>(*made)) pieces.emplace_back(piece);
  return pieces;
}
std::vector<Geometry> cut(const Surface<Exact>& surface, const std::string& direction, const Exact& t) {
  Inputs<Exact> inputs;
  inputs.values.emplace("surface", surface);
  inputs.values.emplace("direction", direction);
  inputs.values.emplace("t", t);
  const auto made = run_plain<Exact>(*find_algorithm("surface_subdivision"), inputs);
  REQUIRE(made);
  std::vector<Geometry> pieces;
  for (const auto& piece : std::get<std::vector<Surface<Exact>>>(*made)) pieces.emplace_back(piece);
  return pieces;
}

Exact inside(const std::vector<Exact>& U, int p) {
  const Exact a = U[static_cast<std::size_t>(p)], b = U[U.size() - 1 - static_cast<std::size_t>(p)];
  return a + (b - a) * Exact::ratio(3, 7);
}

// Moves any point of the first piece and lets the second follow.
void check_moves(const Workspace& scene, unsigned seed) {
  REQUIRE(share_smooth_border(scene.objects[0].geometry, scene.objects[1].geometry));
  std::mt19937 random(seed);
  const std::size_t count = point_count(scene.objects[0].geometry);
  for (std::size_t point = 0; point < count; ++point) {
    const Point<Exact> by(random_ratio(random, -3, 3, 2), random_ratio(random, -3, 3, 2), Exact(0));
    const auto moved = edit::move_points(scene, {{0, point}}, by);
    if (!moved) continue;  // a point of weight 0
    const Workspace kept = seams_kept(scene, *moved, 0);
    CAPTURE(seed, point);
    CHECK(share_smooth_border(kept.objects[0].geometry, kept.objects[1].geometry));
    CHECK(place_of(kept.objects[0].geometry, point) == place_of(moved->objects[0].geometry, point));
  }
}

}  // namespace

TEST_CASE("the two parts of a curve that was cut stay C1, whichever point is moved", "[studio]") {
  const unsigned seed = GENERATE(range(1u, 12u));
  std::mt19937 random(seed);
  const int p = random_int(random, 2, 4);
  const auto curve = random_curve(random, p, random_int(random, 1, 4), 1, true, seed % 3 == 0);
  check_moves(scene_of(cut(curve, inside(curve.knots, p))), seed);
}

TEST_CASE("the two parts of a surface that was cut in u or in v stay C1", "[studio]") {
  const unsigned seed = GENERATE(range(1u, 8u));
  std::mt19937 random(seed);
  const auto surface = random_surface(random, 2, 3, 1, true, false);
  const bool in_u = seed % 2 == 0;
  const std::size_t d = in_u ? 0 : 1;
  check_moves(scene_of(cut(surface, in_u ? "u" : "v", inside(surface.knots[d], surface.degree[d]))), seed);
}

TEST_CASE("moving the border takes both tangents along; moving a point beside it turns the other's", "[studio]") {
  const Curve<Exact> line{2, bezier_knots<Exact>(2), {{0, 0, 0, 1}, {2, 2, 0, 1}, {4, 0, 0, 1}}, 2, false, true};
  const Workspace scene = scene_of(cut(line, Exact::ratio(1, 2)));  // the border is (2, 1), beside it (1, 1) and (3, 1)
  const auto lifted = edit::move_points(scene, {{0, 2}}, {Exact(0), Exact(3), Exact(0)});
  const Workspace kept = seams_kept(scene, *lifted, 0);
  CHECK(*place_of(kept.objects[0].geometry, 1) == Point<Exact>(1, 4, 0));
  CHECK(*place_of(kept.objects[1].geometry, 0) == Point<Exact>(2, 4, 0));
  CHECK(*place_of(kept.objects[1].geometry, 1) == Point<Exact>(3, 4, 0));
  CHECK(*place_of(kept.objects[1].geometry, 2) == Point<Exact>(4, 0, 0));
  const auto turned = edit::move_points(scene, {{0, 1}}, {Exact(0), Exact(1), Exact(0)});
  CHECK(*place_of(seams_kept(scene, *turned, 0).objects[1].geometry, 1) == Point<Exact>(3, 0, 0));
}

TEST_CASE("what was not smooth before stays as it is", "[studio]") {
  const Curve<Exact> a{1, bezier_knots<Exact>(1), {{0, 0, 0, 1}, {1, 0, 0, 1}}, 2, false, true};
  const Curve<Exact> b{1, bezier_knots<Exact>(1), {{1, 0, 0, 1}, {1, 5, 0, 1}}, 2, false, true};
  const Workspace scene = scene_of({a, b});
  CHECK(!share_smooth_border(a, b));
  const auto moved = edit::move_points(scene, {{0, 1}}, {Exact(1), Exact(1), Exact(0)});
  CHECK(seams_kept(scene, *moved, 0) == *moved);
}
