#include "player/grip.hpp"

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "player/document.hpp"
#include "player/session.hpp"

using namespace blossom;

namespace {

std::unique_ptr<Session> opened(const char* file) {
  auto document = open_document(file);
  INFO(to_string(document.diagnostics));
  REQUIRE(document);
  auto session = Session::open(std::move(*document), true);
  REQUIRE(session);
  return std::move(*session);
}

std::unique_ptr<Session> de_boor() { return opened("tests/play/data/22-de-boor.json"); }

// 100 units of the page are 1 in the world; (0, 0) is in the middle, at (400, 300).
constexpr ViewSize page{800, 600};
Camera plane() {
  Camera camera;
  camera.kind = Camera::Kind::plane;
  camera.height = 6;
  return camera;
}
Camera space(double azimuth, double elevation) {
  Camera camera = plane();
  camera.kind = Camera::Kind::orbit;
  camera.azimuth = azimuth;
  camera.elevation = elevation;
  return camera;
}

const PointAddress second{"curve", 0, 1};  // (0, 0)
const PointAddress fourth{"curve", 0, 3};  // (30, 20)

std::string text(const Point<Exact>& p) { return p.x.to_string() + " " + p.y.to_string() + " " + p.z.to_string(); }

constexpr GripKeys none{}, along{true, false}, snapping{false, true};

// Knots from 0 to 1 on 1000 units.
constexpr KnotAxis axis{0, 1, 0, 1000};

std::string knots_of(const Edited& edited) {
  INFO(to_string(edited.diagnostics));
  REQUIRE(edited);
  std::string found;
  for (const Exact& u : edited->curve("curve").knots) found += (found.empty() ? "" : " ") + u.to_string();
  return found;
}

}  // namespace

TEST_CASE("a dragged point goes with the mouse, in numbers as fine as the page") {
  const auto session = de_boor();
  const PointGrip grip(*session, second, plane(), page, {403, 301}, 0.5);
  CHECK(grip.name() == "P[0][1]");
  // Taken beside its middle, it does not jump there.
  CHECK(text(grip.place({403, 301}, none)) == "0 0 0");
  CHECK(text(grip.place({404, 301}, none)) == "1/100 0 0");
  CHECK(text(grip.place({540, 178}, none)) == "137/100 123/100 0");
  CHECK(text(grip.place({540.3, 178.4}, none)) == "137/100 123/100 0");
}

TEST_CASE("a dragged point snaps to the grid that is drawn") {
  const auto session = de_boor();
  const PointGrip grip(*session, second, plane(), page, {400, 300}, 0.5);
  CHECK(text(grip.place({540, 178}, snapping)) == "3/2 1 0");
  CHECK(grid_spacing(*session, plane(), page) == 1);  // 8 world units across in about 10 steps
}

TEST_CASE("along an axis the other coordinates keep their exact numbers") {
  auto session = de_boor();
  const PointAddress at = second;
  REQUIRE(session->edit(
      move_point(session->algorithm(), session->inputs(), at, {Exact::ratio(1, 3), Exact::ratio(1, 7), 0}), "moved"));
  const PointGrip grip(*session, at, plane(), page, {0, 0}, 0.5);
  CHECK_FALSE(grip.axis({0, 0}));
  CHECK(grip.axis({50, 20}) == 0);
  CHECK(grip.axis({20, -50}) == 1);
  CHECK(text(grip.place({20, -50}, along)) == "1/3 16/25 0");
  CHECK(text(grip.place({50, 20}, along)) == "83/100 1/7 0");
  // Without keys likewise, where the mouse moved straight.
  CHECK(text(grip.place({50, 0}, none)) == "83/100 1/7 0");
}

TEST_CASE("every edit of a drag starts from where it began") {
  auto session = de_boor();
  const PointGrip grip(*session, fourth, plane(), page, {0, 0}, 0.5);
  const Inputs<Exact> before = session->inputs();
  REQUIRE(session->edit(grip.edited(session->algorithm(), {100, 0}, none), "moved", "drag"));
  REQUIRE(session->edit(grip.edited(session->algorithm(), {200, 0}, none), "moved", "drag"));
  CHECK(affine(session->inputs().curve("curve"), 3).x == Exact(32));
  REQUIRE(session->edit(grip.edited(session->algorithm(), {0, 0}, none), "moved", "drag"));
  CHECK(session->inputs() == before);
}

TEST_CASE("in space a point moves in the plane that faces the view, or along the axis that the drag runs along") {
  const auto session = opened("lessons/67-skinning.json");
  const PointAddress at{"profiles", 1, 0};
  const Point<Exact> start = affine(curve_at(session->inputs(), {"profiles", 1}), 0);
  const auto difference = [&](const Point<Exact>& p) {
    return glm::dvec3{(p.x - start.x).to_double(), (p.y - start.y).to_double(), (p.z - start.z).to_double()};
  };
  // From the front: x to the right, z up.
  const Camera front = facing(space(0, 0), Plane::xz);
  const PointGrip grip(*session, at, front, page, {0, 0}, 0.5);
  const glm::dvec3 moved = difference(grip.place({120, -70}, none));
  CHECK(moved.x == Approx(1.2).margin(0.011));
  CHECK(moved.y == 0);
  CHECK(moved.z == Approx(0.7).margin(0.011));
  CHECK(grip.axis({30, -90}) == 2);
  CHECK(grip.axis({-90, 30}) == 0);  // y runs toward the viewer: never it

  for (const bool perspective : {false, true}) {
    Camera askew = space(0.7, 0.5);
    askew.perspective = perspective;
    askew.centre = {start.x.to_double(), start.y.to_double(), start.z.to_double()};
    const PointGrip turned(*session, at, askew, page, {400, 300}, 0.5);
    const glm::dvec3 facing_view = difference(turned.place({490, 240}, none));
    const ViewAxes axes = axes_of(askew);
    CHECK(facing_view.x * axes.toward.x + facing_view.y * axes.toward.y + facing_view.z * axes.toward.z ==
          Approx(0).margin(0.02));
    CHECK(difference(turned.place({400, 200}, along)).x == 0);
    CHECK(difference(turned.place({400, 200}, along)).y == 0);
    CHECK(difference(turned.place({400, 200}, along)).z > 0.9);
  }
}

TEST_CASE("a point of a plane curve that is drawn above its plane stays in it, and under the mouse") {
  auto session = opened("lessons/43-projection.json");
  const PointAddress at{"curve", 0, 1};
  const auto drawn = [&] {
    const StepSource& source = session->recording().source();
    return *source.points[*value_of(*source.graph, session->inputs(), at)];
  };
  CHECK(drawn() == glm::dvec3{0, 2, 1});  // (0, 2) at height 1
  for (const bool perspective : {false, true}) {
    Camera askew = space(-1.1, 0.4);
    askew.perspective = perspective;
    const glm::dvec2 from = *to_page(askew, page, drawn()), to = from + glm::dvec2{70, -30};
    const Grip grip = grip_of_value(*session, *session->recording().graph().find("P[1]"), askew, page, from);
    REQUIRE(std::holds_alternative<PointGrip>(grip));
    const PointGrip& point = std::get<PointGrip>(grip);
    CHECK(point.address() == at);
    REQUIRE(session->edit(point.edited(session->algorithm(), to, none), "moved"));
    const Curve<Exact>& curve = session->inputs().curve("curve");
    CHECK(curve.points[1].w == Exact(2));
    const Point<Exact> given = affine(curve, 1);
    CHECK(drawn() == glm::dvec3{given.x.to_double(), given.y.to_double(), 1});
    CHECK(glm::distance(*to_page(askew, page, drawn()), to) < 1.5);  // as fine as the page
    REQUIRE(session->undo());
  }
  // Seen from the side, the plane is a line: what moves is what one sees move.
  const Camera front = facing(space(0, 0), Plane::xz);
  const PointGrip point(*session, at, front, page, {400, 300}, 0.5);
  CHECK(text(point.place({450, 300}, none)) == "1/2 2 0");
}

TEST_CASE("what is computed cannot be dragged, and says so") {
  const auto session = de_boor();
  const TraceGraph& graph = session->recording().graph();
  const Grip given = grip_of_value(*session, *graph.find("P[0][3]"), plane(), page, {0, 0});
  REQUIRE(std::holds_alternative<PointGrip>(given));
  CHECK(std::get<PointGrip>(given).address() == fourth);
  const Grip made = grip_of_value(*session, *graph.find("P[1][3]"), plane(), page, {0, 0});
  REQUIRE(std::holds_alternative<StuckGrip>(made));
  CHECK(std::get<StuckGrip>(made).why == "P₃⁽¹⁾ is computed; drag one of the control points it comes from.");
}

TEST_CASE("looking around pans, or turns") {
  const LookGrip pans{plane(), page, {10, 10}, false};
  CHECK(pans.at({110, 10}).centre.x == Approx(-1));
  CHECK(pans.at({10, 110}).centre.y == Approx(1));
  const LookGrip turns{space(1, 0), page, {0, 0}, true};
  CHECK(turns.at({80, 0}).azimuth < 1);
  CHECK(turns.at({80, 0}).centre == turns.from.centre);
}

TEST_CASE("a knot is dragged alone, the outermost of equal ones in the direction of the drag") {
  const auto session = de_boor();
  const Algorithm& algorithm = session->algorithm();
  const CurveAddress curve{"curve", 0};
  const KnotGrip inner(*session, curve, 5, axis, 500);
  CHECK(inner.value(500, none) == Exact::ratio(1, 2));
  CHECK(knots_of(inner.edited(algorithm, 560, none)) == "0 0 0 0 1/4 14/25 3/4 1 1 1 1");
  CHECK(knots_of(inner.edited(algorithm, 500, none)) == "0 0 0 0 1/4 1/2 3/4 1 1 1 1");
  const KnotGrip first(*session, curve, 0, axis, 0);
  CHECK(knots_of(first.edited(algorithm, 100, none)) == "0 0 0 1/10 1/4 1/2 3/4 1 1 1 1");
  CHECK(knots_of(first.edited(algorithm, -100, none)) == "-1/10 0 0 0 1/4 1/2 3/4 1 1 1 1");
  CHECK(knots_of(first.edited(algorithm, 100, along)) == "1/10 1/10 1/10 1/10 1/4 1/2 3/4 1 1 1 1");
}

TEST_CASE("a knot beyond its neighbour is refused at that knot") {
  const auto session = de_boor();
  const KnotGrip grip(*session, {"curve", 0}, 5, axis, 500);
  const Edited edited = grip.edited(session->algorithm(), 800, none);
  REQUIRE_FALSE(edited);
  CHECK(edited.diagnostics[0].path == "curve.knots[5]");
  CHECK(grip.value(800, none) == Exact::ratio(4, 5));  // where its mark is shown meanwhile
}

TEST_CASE("knots of a Bezier curve stay where they are") {
  const auto session = opened("tests/play/data/11-de-casteljau.json");
  const KnotGrip grip(*session, {"curve", 0}, 0, axis, 0);
  CHECK(grip.edited(session->algorithm(), 0, none));
  const Edited edited = grip.edited(session->algorithm(), 100, none);
  REQUIRE_FALSE(edited);
  CHECK(edited.diagnostics[0].message == "of a Bézier curve are 0 and 1; make it a B-spline curve first");
}

TEST_CASE("u is dragged within the domain") {
  const auto session = de_boor();  // u = 2/5
  const ParameterGrip grip(*session, axis, 403, false);
  CHECK(grip.value(403, none) == Exact::ratio(2, 5));
  CHECK(grip.value(503, none) == Exact::ratio(1, 2));
  CHECK(grip.value(504.2, none) == Exact::ratio(501, 1000));
  CHECK(grip.value(2000, none) == Exact(1));
  CHECK(grip.value(-2000, none) == Exact(0));
  const ParameterGrip jumping(*session, axis, 700, true);
  CHECK(jumping.value(700, none) == Exact::ratio(7, 10));
  const Edited edited = jumping.edited(session->algorithm(), 700, none);
  REQUIRE(edited);
  CHECK(edited->number("u") == Exact::ratio(7, 10));
}

TEST_CASE("snapping takes the nearest fraction of the domain with a denominator up to 12") {
  CHECK(nearest_fraction(0.34, 0, 1) == Exact::ratio(1, 3));
  CHECK(nearest_fraction(0.5, 0, 1) == Exact::ratio(1, 2));
  CHECK(nearest_fraction(0.085, 0, 1) == Exact::ratio(1, 12));
  CHECK(nearest_fraction(0.02, 0, 1) == Exact(0));
  CHECK(nearest_fraction(4.3, 2, 9) == Exact(2) + Exact(7) * Exact::ratio(1, 3));
  CHECK(nearest_fraction(-0.26, 0, 1) == Exact::ratio(-1, 4));  // a knot may lie beyond the domain
  const auto session = de_boor();
  CHECK(ParameterGrip(*session, axis, 400, false).value(420, snapping) == Exact::ratio(5, 12));
}

TEST_CASE("a point added behind another stands halfway to the next, or on beyond the last") {
  const auto session = de_boor();
  const auto& curve = session->inputs().curve("curve");
  CHECK(text(place_behind(curve, 2)) == "15 20 0");
  CHECK(text(place_behind(curve, 6)) == "15 15 0");
}

TEST_CASE("a direction of the view is the axis that runs most along it") {
  const auto check = [](const Camera& camera, int dimension, const glm::dvec3& way, int wanted, bool backwards) {
    const PageAxis found = nearest_axis(camera, dimension, way);
    CHECK(found.axis == wanted);
    CHECK(found.backwards == backwards);
  };
  check(plane(), 2, {1, 0, 0}, 0, false);
  check(plane(), 2, {0, -1, 0}, 1, true);
  check(space(0, 0), 3, {1, 0, 0}, 1, false);  // from +x: y to the right, z up
  check(space(0, 0), 3, {0, 0, 1}, 0, false);
  check(space(0, 0), 3, {0, -1, 0}, 2, true);
}
