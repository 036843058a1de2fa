// Scenes of the studio as they are drawn: marks are where geometry says, and what does not exist is left out.
#include "scene/workspace_view.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "kernel/evaluate.hpp"
#include "scene/color_bands.hpp"
#include "scene/object_samples.hpp"
#include "scene/workspace_builder.hpp"

using namespace blossom;

namespace {

HPoint<Exact> P(double x, double y, double z = 0, double w = 1) {
  return {Exact(w) * Exact(x), Exact(w) * Exact(y), Exact(w) * Exact(z), Exact(w)};
}

Curve<Exact> curve_of(int degree, std::vector<HPoint<Exact>> points, std::vector<double> knots = {},
                      int dimension = 3) {
  Curve<Exact> made;
  made.degree = degree;
  made.points = std::move(points);
  made.dimension = dimension;
  if (knots.empty()) made.knots = bezier_knots<Exact>(degree);
  for (const double u : knots) made.knots.push_back(Exact(u));
  made.bezier = knots.empty();
  for (const auto& point : made.points) made.rational = made.rational || point.w != Exact(1);
  return made;
}

Curve<Exact> wave() {
  return curve_of(3, {P(0, 0), P(1, 3, 1), P(4, 4, -1), P(6, 1, 2), P(8, 3)}, {0, 0, 0, 0, 1, 2, 2, 2, 2});
}

Surface<Exact> hill(int size = 5, double height = 2) {
  Surface<Exact> made;
  made.degree = {3, 2};
  made.rows = made.columns = size;
  for (int d = 0; d < 2; ++d) {
    const int p = made.degree[static_cast<std::size_t>(d)];
    for (int i = 0; i < size + p + 1; ++i)
      made.knots[static_cast<std::size_t>(d)].push_back(Exact(std::clamp(i - p, 0, size - p)));
  }
  for (int i = 0; i < size; ++i)
    for (int j = 0; j < size; ++j) made.points.push_back(P(i, j, height * std::sin(i) * std::cos(j)));
  return made;
}

SceneObject object(std::string name, Geometry geometry, bool everything = false) {
  SceneObject made;
  made.name = std::move(name);
  made.geometry = std::move(geometry);
  made.shows = usual_shows(made.geometry);
  for (const ShowName& show : show_names())
    if (everything) made.shows.set(show.show, true);
  return made;
}

Workspace scene_of(std::vector<SceneObject> objects) {
  Workspace made;
  made.objects = std::move(objects);
  return made;
}

bool finite(const glm::dvec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

// Everything a view draws is somewhere.
void check_finite(const View& view) {
  std::size_t nowhere = 0;
  const auto look_at = [&](const auto& points) {
    for (const glm::dvec3& at : points) nowhere += finite(at) ? 0 : 1;
  };
  for (const auto& mesh : view.meshes) {
    for (const std::uint32_t i : mesh.indices) nowhere += finite(mesh.positions.at(i)) ? 0 : 1;
    look_at(mesh.normals);
    for (const float value : mesh.values) nowhere += value >= 0 && value <= 1 ? 0 : 1;
  }
  for (const auto& polygon : view.polygons) look_at(polygon.points);
  for (const auto& line : view.polylines) look_at(line.points);
  for (const auto& marker : view.markers) look_at(std::array{marker.position});
  for (const auto& label : view.labels) {
    look_at(std::array{label.anchor});
    for (const auto& run : label.text) nowhere += run.text.find("nan") == std::string::npos ? 0 : 1;
  }
  CHECK(nowhere == 0);
}

glm::dvec2 middle(const Spot& spot) { return {spot.x + spot.width / 2, spot.y + spot.height / 2}; }

const Spot& spot_named(const Sheet& sheet, const std::string& name) {
  for (const Spot& spot : sheet.spots)
    if (spot.name == name) return spot;
  throw std::runtime_error("no spot " + name);
}

}  // namespace

TEST_CASE("Degenerate curves with every mark shown are drawn without a place that is none") {
  const auto u = GENERATE(0.0, 0.5, 1.0);
  const std::vector<Curve<Exact>> curves = {
      curve_of(3, {P(1, 2), P(1, 2), P(1, 2), P(1, 2)}),         // a point
      curve_of(3, {P(0, 0), P(1, 1), P(2, 2), P(3, 3)}),         // a straight line
      curve_of(3, {P(0, 0), P(2, 2), P(0, 2), P(2, 0)}, {}, 2),  // a cusp at 1/2
      curve_of(3, {P(0, 0), P(0, 0), P(1, 1), P(2, 0)}),         // no speed at the beginning
      curve_of(2, {P(0, 0), P(1, 1, 0, 0), P(2, 0)}, {}, 2),     // a weight of 0
      curve_of(2, {P(0, 0), P(1, 1, 0, -1), P(2, 0)}, {}, 2),    // a pole at 1/2
      curve_of(1, {P(0, 0), P(1, 1), P(1, 1), P(5, 2)}, {0, 0, 1, 2, 3, 3}),
      curve_of(2, {P(0, 0), P(1, 0), P(2, 0), P(5, 5), P(6, 5), P(7, 5)}, {0, 0, 0, 1, 1, 1, 2, 2, 2}),  // a jump
  };
  for (std::size_t i = 0; i < curves.size(); ++i) {
    INFO("curve " << i << " at " << u);
    SceneObject thing = object("c", curves[i], true);
    thing.u = Exact(u);
    const Workspace scene = scene_of({thing, object("wave", wave(), true)});
    const WorkspaceScenes scenes;
    WorkspaceLook look;
    look.current = 0;
    check_finite(scenes.view(scene, 800, 600, look).view);
    scenes.riding(scene, 0, u);
  }
}

TEST_CASE("Degenerate surfaces with every mark and map are drawn without a place that is none") {
  Surface<Exact> cone = hill(), fold = hill(), flat = hill(5, 0), point = hill(), pole = hill();
  for (int j = 0; j < 5; ++j) cone.at(0, j) = P(0, 0, 3);
  for (int j = 0; j < 5; ++j) fold.at(1, j) = fold.at(0, j);
  for (auto& at : point.points) at = P(1, 1, 1);
  pole.rational = true;
  for (int j = 0; j < 5; ++j) pole.at(0, j) = {Exact(0), Exact(j), Exact(0), Exact(0)};
  for (const Surface<Exact>& surface : {cone, fold, flat, point, pole})
    for (int map = 0; map < surface_map_count; ++map)
      for (const double at : {0.0, 1.0}) {
        INFO("map " << map << " at " << at);
        SceneObject thing = object("s", surface, true);
        thing.map = static_cast<SurfaceMap>(map);
        thing.u = thing.v = Exact(at);
        WorkspaceLook look;
        look.current = 0;
        check_finite(WorkspaceScenes().view(scene_of({thing}), 800, 600, look).view);
      }
}

TEST_CASE("An empty scene has a view") {
  const Sheet sheet = WorkspaceScenes().view({}, 800, 600, {});
  check_finite(sheet.view);
  CHECK(sheet.view.camera.height > 1);
  CHECK(sheet.spots.empty());
}

TEST_CASE("The levels of de Boor's algorithm end at the point on the curve") {
  std::mt19937 random(5);
  const Curve<double> curve = convert<double>(wave());
  for (int i = 0; i < 200; ++i) {
    const double u = i == 0 ? 0 : i == 1 ? 1 : i == 2 ? 2 : std::uniform_real_distribution(0.0, 2.0)(random);
    const int k = find_span<double>(curve.knots, 3, u);
    const NetLevels net =
        de_boor_levels(curve.knots, 3, std::span(curve.points).subspan(static_cast<std::size_t>(k - 3), 4), k, u);
    REQUIRE(net.levels.size() == 4);
    REQUIRE(net.levels[3].size() == 1);
    const auto at = plain_place(net.levels[3][0]);
    CHECK(glm::length(*at - plain(*point(curve, u))) < 1e-12);
  }
}

TEST_CASE("A curve is sampled as finely as it bends, and never endlessly") {
  const Curve<double> curve = convert<double>(wave());
  const CurveTrack track = track_of(curve);
  REQUIRE(track.pieces.size() == 1);
  CHECK(track.u.front() == 0);
  CHECK(track.u.back() == 2);
  for (std::size_t i = 0; i + 1 < track.u.size(); ++i) {
    REQUIRE(track.u[i] < track.u[i + 1]);
    const glm::dvec3 halfway = plain(*point(curve, (track.u[i] + track.u[i + 1]) / 2));
    const glm::dvec3 a = track.points[i], b = track.points[i + 1];
    CHECK(glm::length(glm::cross(halfway - a, b - a)) / glm::length(b - a) < 10.0 / 4000);
  }
  const CurveTrack straight = track_of(convert<double>(curve_of(1, {P(0, 0), P(5, 5)})));
  CHECK(straight.points.size() == 2);
  CHECK(track.points.size() > 30);

  const auto jump = curve_of(1, {P(0, 0), P(1, 0), P(1, 5), P(2, 5)}, {0, 0, 1, 1, 2, 2});
  CHECK(track_of(convert<double>(jump)).pieces.size() == 2);
  std::vector<HPoint<Exact>> many;
  std::vector<double> knots{0};
  for (int i = 0; i < 4000; ++i) {
    many.push_back(P(i, i % 2));
    knots.push_back(i);
  }
  knots.push_back(3999);
  CHECK(track_of(convert<double>(curve_of(1, many, knots))).points.size() < 8000);
}

TEST_CASE("A surface brought up to date after points moved is the one made anew") {
  std::mt19937 random(7);
  Surface<Exact> surface = hill(9);
  ObjectSamples kept{Geometry(surface)};
  for (int round = 0; round < 20; ++round) {
    const int i = static_cast<int>(random() % 9), j = static_cast<int>(random() % 9);
    surface.at(i, j) = P(i, j, static_cast<double>(random() % 50) / 8, 1);
    kept.update(Geometry(surface));
    const ObjectSamples anew{Geometry(surface)};
    REQUIRE(kept.mesh().mesh == anew.mesh().mesh);
    REQUIRE(kept.points() == anew.points());
    CHECK(kept.numbers(SurfaceMap::mean).values == anew.numbers(SurfaceMap::mean).values);
  }
}

TEST_CASE("The circle of curvature of a circle is that circle") {
  // A quarter as a rational parabola (The NURBS Book, example 7.1): weights 1, 1, 2.
  SceneObject thing = object("arc", curve_of(2, {P(1, 0), P(1, 1), P(0, 1, 0, 2)}, {}, 2));
  thing.shows = {};
  thing.shows.set(Show::circle, true);
  thing.u = Exact::ratio(3, 10);
  const Sheet sheet = WorkspaceScenes().view(scene_of({thing}), 800, 600, {});
  bool any = false;
  for (const Polyline& line : sheet.view.polylines) {
    if (line.role != Role::ratio_near || !line.closed) continue;
    any = true;
    for (const auto& at : line.points) CHECK(glm::length(at) == Approx(1).margin(1e-9));
  }
  CHECK(any);
}

TEST_CASE("The mouse finds the parameter of what is under it") {
  const Workspace scene = scene_of({object("wave", wave()), object("hill", hill())});
  const WorkspaceScenes scenes;
  const Camera camera = scenes.usual(scene, 900, 700);
  const ViewSize size{900, 700};
  for (const double u : {0.0, 0.3, 1.0, 1.7, 2.0}) {
    const auto at = to_page(camera, size, plain(*point(convert<double>(wave()), u)));
    const auto found = scenes.parameter_at(scene, 0, camera, size, *at, 5);
    REQUIRE(found);
    CHECK(found->x == Approx(u).margin(0.02));
  }
  CHECK_FALSE(scenes.parameter_at(scene, 0, camera, size, {-300, -300}, 5));
  CHECK_FALSE(scenes.parameter_at(scene, 9, camera, size, {0, 0}, 5));
  // From above every place of the hill is seen.
  Camera above = scenes.fitted(scene, 900, 700, facing(camera, Plane::xy));
  const auto at = to_page(above, size, plain(*point(convert<double>(hill()), 0.7, 1.3)));
  const auto found = scenes.parameter_at(scene, 1, above, size, *at, 5);
  REQUIRE(found);
  CHECK(found->x == Approx(0.7).margin(0.02));
  CHECK(found->y == Approx(1.3).margin(0.02));
}

TEST_CASE("A ride looks along the curve from above it, upright") {
  const Workspace scene = scene_of({object("arc", curve_of(3, {P(0, 0), P(3, 0), P(6, 3), P(6, 6)}, {}, 2))});
  const WorkspaceScenes scenes;
  for (const double u : {0.0, 0.4, 1.0}) {
    const auto camera = scenes.riding(scene, 0, u);
    REQUIRE(camera);
    const Lens lens(*camera, {800, 600});
    const auto curve = convert<double>(std::get<Curve<Exact>>(scene.objects[0].geometry));
    const auto here = frame(curve, u);
    const glm::dvec3 eye = camera->centre + lens.eye() * lens.axes().toward;
    CHECK(eye.z > 0);
    CHECK(glm::length(eye - plain(here->point)) < 1);
    CHECK(glm::dot(-lens.axes().toward, plain(here->tangent)) > 0.98);
    CHECK(lens.axes().up.z > 0.98);
    CHECK(lens.axes().right.z == Approx(0).margin(1e-9));
  }
  CHECK_FALSE(scenes.riding(scene_of({object("hill", hill())}), 0, 0));
}

TEST_CASE("Spots name control points and handles; handles stay as large as they are on the page") {
  const Workspace scene = scene_of({object("wave", wave()), object("hill", hill())});
  const WorkspaceScenes scenes;
  WorkspaceLook look;
  look.current = 0;
  look.gizmo = glm::dvec3{4, 2, 0};
  look.camera = scenes.usual(scene, 900, 700);
  const Sheet sheet = scenes.view(scene, 900, 700, look);
  CHECK(spot_named(sheet, "wave P[2]").link == Link{Link::Kind::object, 0, 3});
  CHECK(spot_named(sheet, "hill P[1][2]").link == Link{Link::Kind::object, 1, 8});
  CHECK(spot_named(sheet, "wave").link == Link{Link::Kind::object, 0, 0});
  CHECK(spot_named(sheet, "scale").link == Link{Link::Kind::handle, 7, 0});
  const auto reach = [](const Sheet& of) {
    return glm::length(middle(spot_named(of, "move z")) - middle(spot_named(of, "move")));
  };
  look.camera->height *= 3;
  const Sheet farther = scenes.view(scene, 900, 700, look);
  CHECK(reach(farther) == Approx(reach(sheet)).epsilon(0.1));
  CHECK(reach(sheet) > 50);

  look.handles = false;
  CHECK(scenes.view(scene, 900, 700, look).spots.empty());
}

TEST_CASE("Hidden things are not drawn, and a plane scene is seen from straight above") {
  Workspace scene = scene_of({object("a", curve_of(2, {P(0, 0), P(1, 2), P(2, 0)}, {}, 2)), object("hill", hill())});
  const WorkspaceScenes scenes;
  CHECK(scenes.usual(scene, 800, 600).kind == Camera::Kind::orbit);
  CHECK(scenes.view(scene, 800, 600, {}).view.meshes.size() == 1);
  scene.objects[1].hidden = true;
  CHECK(scenes.usual(scene, 800, 600).kind == Camera::Kind::plane);
  CHECK(scenes.view(scene, 800, 600, {}).view.meshes.empty());
}

TEST_CASE("Stripes cut triangles where the number is whole, and lose nothing") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  mesh.normals.assign(3, {0, 0, 1});
  mesh.indices = {0, 1, 2};
  const Mesh made = banded(mesh, {0.5, 3.5, 0.5});
  double area = 0, dark = 0;
  for (std::size_t i = 0; i < made.indices.size(); i += 3) {
    const auto &a = made.positions[made.indices[i]], &b = made.positions[made.indices[i + 1]],
               &c = made.positions[made.indices[i + 2]];
    const double part = glm::length(glm::cross(b - a, c - a)) / 2;
    area += part;
    if (made.values[made.indices[i]] == 0) dark += part;
    const double number = 0.5 + (a.x + b.x + c.x) / 4;  // the number runs as 1/2 + 3/4 x
    CHECK(made.values[made.indices[i]] == (std::fmod(std::floor(number), 2) == 0 ? 0.0F : 1.0F));
  }
  CHECK(area == Approx(8));
  // Left of x = 2/3, and between x = 2 and x = 10/3, of a triangle whose height at x is 4 - x.
  CHECK(dark == Approx(4 * 2.0 / 3 - 2.0 / 9 + (4 * 10.0 / 3 - 50.0 / 9) - (8 - 2)));
}

TEST_CASE("The domain square says where (u, v) is, and back") {
  Sheet sheet;
  const Surface<double> surface = convert<double>(hill());
  const DomainSquare square = add_domain_square(sheet, surface, {0.5, 2.5}, 10, 20, 240);
  check_finite(sheet.view);
  for (const glm::dvec2 uv : {glm::dvec2{0, 0}, glm::dvec2{2, 3}, glm::dvec2{0.7, 1.9}})
    CHECK(glm::length(square.parameter(square.place(uv)) - uv) < 1e-12);
  CHECK(square.place({0, 3}).y < square.place({0, 0}).y);  // v upwards
  CHECK(glm::length(middle(spot_named(sheet, "(u, v)")) - square.place({0.5, 2.5})) < 1e-9);
  CHECK(spot_named(sheet, "v knot 3").link == Link{Link::Kind::knot, 3, 1});
  CHECK(square.parameter({-1000, 1e9}) == glm::dvec2{0, 0});
}

TEST_CASE("The parts of the partition bar fill it") {
  for (const Geometry& geometry :
       {Geometry(wave()), Geometry(hill()), Geometry(curve_of(2, {P(1, 0), P(1, 1), P(0, 1, 0, 2)}, {}, 2))}) {
    Sheet sheet;
    CHECK(add_partition_bar(sheet, geometry, 0.6, 1.2, 10, 10, 500) > 40);
    double sum = 0;
    for (const Spot& spot : sheet.spots) sum += spot.width;
    CHECK(sum == Approx(500).epsilon(0.02));
    check_finite(sheet.view);
  }
}

TEST_CASE("Plots of what does not bend, or has no frame, are drawn") {
  for (const auto& exact : {curve_of(1, {P(0, 0), P(1, 1)}), curve_of(3, {P(1, 1), P(1, 1), P(1, 1), P(1, 1)}), wave(),
                            curve_of(3, {P(0, 0), P(2, 2), P(0, 2), P(2, 0)}, {}, 2)}) {
    Sheet sheet;
    const double height = add_curve_plots(sheet, convert<double>(exact), 0.5,
                                          {CurvePlot::speed, CurvePlot::curvature, CurvePlot::torsion}, 0, 0, 500, 300);
    CHECK(height > 250);
    check_finite(sheet.view);
    CHECK(sheet.spots.size() == 3);
    for (const Polyline& line : sheet.view.polylines)
      for (const auto& at : line.points) CHECK((at.y >= 0 && at.y <= height + 1e-9));
  }
}

TEST_CASE("The knots of a closed curve that follow from others are quieter") {
  Sheet sheet;
  auto ring = curve_of(2, {P(0, 0), P(2, 0), P(2, 2), P(0, 2), P(0, 0), P(2, 0)}, {-2, -1, 0, 1, 2, 3, 4, 5, 6}, 2);
  CHECK(add_object_knots(sheet, convert<double>(ring), 1.5, 0, 0, 600) > 0);
  const auto count = [&](Role role) {
    return std::ranges::count_if(sheet.view.markers, [&](const Marker& m) { return m.role == role; });
  };
  CHECK(count(Role::control_point) == 5);
  CHECK(count(Role::retired) == 4);
  CHECK(spot_named(sheet, "u").link.kind == Link::Kind::parameter);
}
