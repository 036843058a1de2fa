// The picture of a rational plane curve below the curve in space: both are there, the plane one at height 1, and the
// rays from the origin pass through a point and what it was lifted to.

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

#include "scene/step_scene.hpp"

using namespace blossom;

namespace {

struct Picture {
  Run<Exact> run;
  Narrator<Exact> narrator;
  StepSource source;
  StepScenes scenes;
  explicit Picture(Run<Exact> made)
      : run(std::move(made)), narrator(run, 6), source(make_source(narrator)), scenes(source) {}
  Picture(const Picture&) = delete;

  std::uint32_t last() const { return run.trace.step_count() - 1; }
  glm::dvec3 place(const char* name) const { return *source.points[*run.trace.find(name)]; }
};

Run<Exact> recorded() {
  const auto document = JsonDocument::parse(
      "inputs", R"({"curve": {"degree": 2, "points": [[-2, 0], [0, 2], [2, 0]], "weights": [1, 2, 1]}, "u": "1/4"})");
  REQUIRE(document);
  Diagnostics none;
  const Algorithm& algorithm = *find_algorithm("projection");
  const auto inputs = read_inputs(algorithm, Cursor(*document, none));
  REQUIRE(inputs);
  auto run = record<Exact>(algorithm, *inputs);
  REQUIRE(run);
  return *std::move(run);
}

bool on_one_line(const glm::dvec3& a, const glm::dvec3& b) { return glm::length(glm::cross(a, b)) < 1e-9; }

}  // namespace

TEST_CASE("the plane curve is drawn at height 1, and every point of it below or above one of the curve in space") {
  const Picture picture(recorded());
  const View view = picture.scenes.viewport(picture.last(), 600, 400);
  CHECK(view.camera.kind == Camera::Kind::orbit);
  const Polyline *plane = nullptr, *space = nullptr;
  for (const Polyline& line : view.polylines) {
    if (line.role == Role::curve) plane = &line;
    if (line.role == Role::curve_result) space = &line;
  }
  REQUIRE(plane != nullptr);
  REQUIRE(space != nullptr);
  REQUIRE(plane->points.size() == space->points.size());
  for (std::size_t i = 0; i < plane->points.size(); ++i) {
    CHECK(plane->points[i].z == Approx(1));
    CHECK(on_one_line(plane->points[i], space->points[i]));
  }
}

TEST_CASE("rays lead from the origin to the control points and to what they are lifted to") {
  const Picture picture(recorded());
  const View view = picture.scenes.viewport(picture.last(), 600, 400);
  const glm::dvec3 origin(0, 0, 0);
  for (const char* name : {"P[0]", "P[1]", "P[2]", "H[0]", "H[1]", "H[2]", "Cw", "C"}) {
    INFO(name);
    const glm::dvec3 at = picture.place(name);
    CHECK(std::ranges::any_of(view.polylines, [&](const Polyline& line) {
      return line.points.size() == 2 && line.points[0] == origin && line.points[1] == at;
    }));
  }
  CHECK(picture.place("H[1]") == glm::dvec3(0, 4, 2));
  CHECK(on_one_line(picture.place("H[1]"), picture.place("P[1]")));
  CHECK(on_one_line(picture.place("Cw"), picture.place("C")));
  CHECK(picture.place("C").z == 1);
}

TEST_CASE("a translucent plane at height 1 holds the control points") {
  const Picture picture(recorded());
  const View view = picture.scenes.viewport(0, 600, 400);
  REQUIRE(view.meshes.size() == 1);
  CHECK(view.meshes[0].opacity < 1);
  for (const auto& at : view.meshes[0].positions) CHECK(at.z == 1);
  for (const char* name : {"P[0]", "P[1]", "P[2]"}) {
    const glm::dvec3 at = picture.place(name);
    CHECK((view.meshes[0].positions[0].x < at.x && at.x < view.meshes[0].positions[2].x));
    CHECK((view.meshes[0].positions[0].y < at.y && at.y < view.meshes[0].positions[2].y));
  }
}
