// Cameras: to the page and back, and how they move.
#include "scene/camera.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

using namespace blossom;

namespace {

constexpr double pi = std::numbers::pi;
constexpr ViewSize size{640, 400};

struct Chance {
  std::mt19937 random;
  explicit Chance(unsigned seed) : random(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  glm::dvec3 point(double reach) { return {number(-reach, reach), number(-reach, reach), number(-reach, reach)}; }
  glm::dvec2 on_page() { return {number(0, size.width), number(0, size.height)}; }
  Camera camera(Camera::Kind kind, bool perspective) {
    return {kind, point(5), number(1, 20), number(-pi, pi), number(-1.5, 1.5), perspective};
  }
};

// `body(camera, chance)` for cameras of each kind that has a world.
template <class Body>
void for_cameras(unsigned seed, Body&& body) {
  Chance chance(seed);
  for (int i = 0; i < 200; ++i) {
    const bool plane = i % 3 == 0;
    const Camera camera = chance.camera(plane ? Camera::Kind::plane : Camera::Kind::orbit, i % 3 == 2);
    INFO("seed " << seed << ", camera " << i << (plane ? " plane" : camera.perspective ? " perspective" : " parallel"));
    body(camera, chance);
  }
}

double distance(const glm::dvec2& a, const glm::dvec2& b) { return glm::length(a - b); }

}  // namespace

TEST_CASE("A plane camera shows its height of the world about its centre, x right and y up") {
  const Camera camera{Camera::Kind::plane, {3, 4, 0}, 10};
  CHECK(distance(*to_page(camera, size, {3, 4, 0}), {320, 200}) < 1e-9);
  CHECK(distance(*to_page(camera, size, {3, 9, 0}), {320, 0}) < 1e-9);
  CHECK(distance(*to_page(camera, size, {4, 4, 7}), {360, 200}) < 1e-9);
}

TEST_CASE("A page camera is the page") {
  const Camera camera;
  CHECK(*to_page(camera, size, {12, 34, 0}) == glm::dvec2{12, 34});
  CHECK(*to_world(camera, size, {12, 34}, {0, 0, 5}) == glm::dvec3{12, 34, 5});
  CHECK(panned(camera, size, {5, 5}) == camera);
  CHECK(zoomed(camera, size, {5, 5}, 2) == camera);
  CHECK(orbited(camera, size, {5, 5}) == camera);
}

TEST_CASE("The axes of a view are at right angles, of length 1, and right-handed") {
  for_cameras(1, [](const Camera& camera, Chance&) {
    const auto [right, up, toward] = axes_of(camera);
    CHECK(glm::length(glm::cross(right, up) - toward) < 1e-12);
    CHECK(glm::length(right) == Approx(1));
    CHECK(glm::length(up) == Approx(1));
    CHECK(std::abs(glm::dot(right, up)) < 1e-12);
    if (camera.kind == Camera::Kind::orbit) CHECK(right.z == 0);  // z stays upright
  });
}

TEST_CASE("From the page to the world and back is the same place") {
  for_cameras(2, [](const Camera& camera, Chance& chance) {
    const glm::dvec2 at = chance.on_page();
    const glm::dvec3 through = camera.centre + chance.point(0.2 * camera.height);
    const auto world = to_world(camera, size, at, through);
    REQUIRE(world);
    CHECK(std::abs(glm::dot(*world - through, axes_of(camera).toward)) < 1e-9 * camera.height);
    CHECK(distance(*to_page(camera, size, *world), at) < 1e-8);
    // The place of a point is where that point is found.
    CHECK(glm::length(*to_world(camera, size, *to_page(camera, size, through), through) - through) < 1e-9);
  });
}

TEST_CASE("What is nearer is larger in perspective, and as large in parallel projection") {
  Chance chance(3);
  for (const bool perspective : {false, true}) {
    const Camera camera = chance.camera(Camera::Kind::orbit, perspective);
    const auto [right, up, toward] = axes_of(camera);
    const double reach = 0.2 * camera.height;
    const auto length = [&, r = right, t = toward](double z) {
      const glm::dvec3 at = camera.centre + z * t;
      return distance(*to_page(camera, size, at), *to_page(camera, size, at + reach * r));
    };
    const double middle = length(0);
    CHECK(middle == Approx(0.2 * size.height));
    if (perspective) {
      CHECK(length(reach) > 1.05 * middle);
      CHECK(length(-reach) < 0.95 * middle);
    } else {
      CHECK(length(reach) == Approx(middle));
    }
  }
}

TEST_CASE("Nothing is seen behind the viewer") {
  Camera camera{Camera::Kind::orbit, {1, 2, 3}, 4, 0.3, 0.2, true};
  const glm::dvec3 behind = camera.centre + 100.0 * axes_of(camera).toward;
  CHECK_FALSE(to_page(camera, size, behind));
  CHECK_FALSE(to_world(camera, size, {10, 10}, behind));
  camera.perspective = false;
  CHECK(to_page(camera, size, behind));
  CHECK_FALSE(to_page({Camera::Kind::orbit, {}, 1, 0, 0, true}, size, {std::nan(""), 0, 0}));
}

TEST_CASE("Panning moves the plane through the centre with the mouse") {
  for_cameras(4, [](const Camera& camera, Chance& chance) {
    const glm::dvec2 from = chance.on_page(), to = chance.on_page();
    const auto grabbed = to_world(camera, size, from, camera.centre);
    CHECK(distance(*to_page(panned(camera, size, to - from), size, *grabbed), to) < 1e-8);
  });
}

TEST_CASE("Zooming keeps the point under the mouse, and undoes itself") {
  for_cameras(5, [](const Camera& camera, Chance& chance) {
    const glm::dvec2 at = chance.on_page();
    const double factor = chance.number(0.2, 5);
    const auto under = to_world(camera, size, at, camera.centre);
    const Camera nearer = zoomed(camera, size, at, factor);
    CHECK(nearer.height == Approx(camera.height / factor));
    CHECK(distance(*to_page(nearer, size, *under), at) < 1e-8);
    const Camera again = zoomed(nearer, size, at, 1 / factor);
    CHECK(again.height == Approx(camera.height));
    CHECK(glm::length(again.centre - camera.centre) < 1e-9);
  });
}

TEST_CASE("However long one zooms, the camera stays usable") {
  for (const double factor : {1e3, 1e-3}) {
    Camera camera{Camera::Kind::plane, {0, 0, 0}, 10};
    for (int i = 0; i < 200; ++i) camera = zoomed(camera, size, {100, 50}, factor);
    CHECK(camera.height > 0);
    CHECK(std::isfinite(camera.height));
    CHECK(std::isfinite(camera.centre.x));
    CHECK(zoomed(camera, size, {0, 0}, 0) == camera);
    CHECK(zoomed(camera, size, {0, 0}, std::nan("")) == camera);
  }
}

TEST_CASE("Orbiting turns by half a turn for the width of the view, and not over the poles") {
  const Camera camera{Camera::Kind::orbit, {1, 2, 3}, 4, 0.5, 0.25};
  const Camera quarter = orbited(camera, size, {size.width / 2, 0});
  CHECK(std::abs(std::remainder(quarter.azimuth - (0.5 - pi / 2), 2 * pi)) < 1e-12);
  CHECK(quarter.elevation == camera.elevation);
  CHECK(orbited(camera, size, {0, 1e5}).elevation == Approx(89 * pi / 180));
  CHECK(orbited(camera, size, {0, -1e5}).elevation == Approx(-89 * pi / 180));
  CHECK(orbited(camera, size, {12345, 678}).centre == camera.centre);
  CHECK(std::abs(orbited(camera, size, {1e6, 0}).azimuth) <= pi + 1e-12);
  // What is in front goes with the mouse.
  const glm::dvec3 front = camera.centre + axes_of(camera).toward;
  const glm::dvec2 after = *to_page(orbited(camera, size, {10, 10}), size, front);
  CHECK(after.x > size.width / 2);
  CHECK(after.y > size.height / 2);
}

TEST_CASE("Each plane is seen with its axes to the right and upwards") {
  const Camera camera{Camera::Kind::orbit, {1, 2, 3}, 4, 0.7, 0.3, true};
  const auto check = [&](Plane plane, const glm::dvec3& right, const glm::dvec3& up) {
    const Camera seen = facing(camera, plane);
    CHECK_FALSE(seen.perspective);
    CHECK(seen.centre == camera.centre);
    CHECK(glm::length(axes_of(seen).right - right) < 1e-12);
    CHECK(glm::length(axes_of(seen).up - up) < 1e-12);
  };
  check(Plane::xy, {1, 0, 0}, {0, 1, 0});
  check(Plane::xz, {1, 0, 0}, {0, 0, 1});
  check(Plane::yz, {0, 1, 0}, {0, 0, 1});
}

TEST_CASE("Dragging along a line gives the point of the line that is seen under the mouse") {
  for_cameras(6, [](const Camera& camera, Chance& chance) {
    const glm::dvec3 through = camera.centre + chance.point(0.2 * camera.height);
    const glm::dvec3 direction = chance.point(1);
    const glm::dvec3 wanted = through + chance.number(-0.1, 0.1) * camera.height * glm::normalize(direction);
    const glm::dvec3 toward = axes_of(camera).toward;
    if (std::abs(glm::dot(glm::normalize(direction), toward)) > 0.9) return;
    const auto found = to_line(camera, size, *to_page(camera, size, wanted), through, direction);
    REQUIRE(found);
    CHECK(glm::length(*found - wanted) < 1e-8);
  });
}

TEST_CASE("Beside the line, the nearest point of the line is meant") {
  const Camera camera{Camera::Kind::plane, {0, 0, 0}, 10};
  const auto at = to_page(camera, size, {2, 3, 0});
  CHECK(glm::length(*to_line(camera, size, *at, {0, 1, 0}, {5, 0, 0}) - glm::dvec3{2, 1, 0}) < 1e-12);
}

TEST_CASE("A line that runs toward the viewer cannot be dragged along") {
  for_cameras(7, [](const Camera& camera, Chance&) {
    const glm::dvec2 middle{size.width / 2, size.height / 2};
    CHECK_FALSE(to_line(camera, size, middle, camera.centre, axes_of(camera).toward));
    CHECK_FALSE(to_line(camera, size, middle, camera.centre, {0, 0, 0}));
    CHECK(to_line(camera, size, middle, camera.centre, axes_of(camera).up));
  });
}

TEST_CASE("A camera on its way begins and ends where it should, and turns the shorter way") {
  const Camera a{Camera::Kind::orbit, {0, 0, 0}, 2, 3.0, 0.2}, b{Camera::Kind::orbit, {4, 0, 0}, 8, -3.0, 0.6, true};
  CHECK(between(a, b, 0) == a);
  CHECK(between(a, b, 1) == b);
  const Camera half = between(a, b, 0.5);
  CHECK(half.centre == glm::dvec3{2, 0, 0});
  CHECK(half.height == Approx(4));
  CHECK(half.elevation == Approx(0.4));
  CHECK(std::abs(half.azimuth) == Approx(pi));  // over the back, not over the front
}

TEST_CASE("From a plane to an orbit camera there is no jump at the beginning") {
  const Camera flat{Camera::Kind::plane, {1, 2, 0}, 6}, round{Camera::Kind::orbit, {1, 2, 0}, 6, 0.4, 0.3};
  const Camera first = between(flat, round, 1e-6);
  for (const glm::dvec3& p : {glm::dvec3{1, 2, 0}, glm::dvec3{3, 2, 0}, glm::dvec3{-1, 4, 0}})
    CHECK(distance(*to_page(first, size, p), *to_page(flat, size, p)) < 0.01);
}
