#include "scene/workspace_view.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "kernel/evaluate.hpp"
#include "scene/workspace_builder.hpp"

namespace blossom {

// The samples of a scene's things by their names; of things that are no more, none.
struct WorkspaceScenes::Cache {
  std::map<std::string, ObjectSamples, std::less<>> known;

  const ObjectSamples& of(const SceneObject& object) {
    const auto found = known.find(object.name);
    if (found == known.end()) return known.emplace(object.name, object.geometry).first->second;
    if (!(found->second.exact() == object.geometry)) found->second.update(object.geometry);
    return found->second;
  }
  void keep_only(const Workspace& workspace) {
    if (known.size() <= workspace.objects.size()) return;
    std::erase_if(known, [&](const auto& entry) { return workspace.find(entry.first) == nullptr; });
  }
};

namespace {

std::array<std::array<double, 2>, 2> domain_of(const ObjectSamples& samples) {
  if (const auto* curve = samples.curve()) return {{{curve->domain_begin(), curve->domain_end()}, {0, 1}}};
  if (const auto* s = samples.surface()) {
    const auto [p, q] = s->degree;
    return {{{s->knots[0][static_cast<std::size_t>(p)], s->knots[0][static_cast<std::size_t>(s->rows)]},
             {s->knots[1][static_cast<std::size_t>(q)], s->knots[1][static_cast<std::size_t>(s->columns)]}}};
  }
  return {{{0, 1}, {0, 1}}};
}

double within(double value, const std::array<double, 2>& domain) {
  return std::isfinite(value) ? std::clamp(value, domain[0], domain[1]) : domain[0];
}

bool shows_points(const SceneObject& object, const ObjectSamples& samples) {
  return object.shows[Show::points] || object.shows[Show::polygon] || object.shows[Show::indices] ||
         samples.shape_bounds().empty();
}

// All of an object that a camera is fitted to.
template <class Body>
void for_each_place(const SceneObject& object, const ObjectSamples& samples, const Body& body) {
  if (shows_points(object, samples))
    for (const auto& at : samples.points())
      if (at) body(*at);
  for (const auto& at : samples.track().points) body(at);
  if (object.shows[Show::hodograph]) {
    const Hodograph hodograph = hodograph_of(samples);
    for (const auto& points : hodograph.lines)
      for (const auto& at : points) body(at);
    for (const auto& at : hodograph.polygon) body(at);
    if (!hodograph.lines.empty()) body(glm::dvec3(0));
  }
  if (object.shows[Show::projection])
    if (const auto above = lifted(samples)) {
      for (const auto& P : above->spline.points) body(glm::dvec3(P.x, P.y, P.z));
      body(above->origin());
    }
  const Mesh& mesh = samples.mesh().mesh;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 5) body(mesh.positions[mesh.indices[i]]);
}

Camera usual_camera(const Workspace& workspace, bool spatial) {
  constexpr double quarter = std::numbers::pi / 2;
  Camera camera;
  camera.kind = spatial ? Camera::Kind::orbit : Camera::Kind::plane;
  camera.perspective = spatial;
  if (!workspace.look) {
    camera.azimuth = -1.0;
    camera.elevation = 0.42;
    return camera;
  }
  const Look& look = *workspace.look;
  camera.azimuth = look.azimuth;
  camera.elevation = look.elevation;
  if (look.from == Look::From::space) {
    camera.kind = Camera::Kind::orbit;
    camera.perspective = look.perspective;
    return camera;
  }
  camera.kind = Camera::Kind::orbit;
  camera.perspective = false;
  if (look.from == Look::From::xy) camera.kind = spatial ? Camera::Kind::orbit : Camera::Kind::plane;
  camera.azimuth = look.from == Look::From::yz ? 0 : -quarter;
  camera.elevation = look.from == Look::From::xy ? quarter : 0;
  return camera;
}

}  // namespace

WorkspaceScenes::WorkspaceScenes() : cache_(std::make_unique<Cache>()) {}
WorkspaceScenes::~WorkspaceScenes() = default;

Camera WorkspaceScenes::fitted(const Workspace& workspace, double width, double height, const Camera& look) const {
  Bounds bounds;
  const auto for_each = [&](const auto& body) {
    for (const SceneObject& object : workspace.objects)
      if (!object.hidden) for_each_place(object, cache_->of(object), body);
  };
  for_each([&](const glm::dvec3& at) { bounds.add(at); });
  if (bounds.empty()) {  // a sheet of paper to begin on
    bounds.add({-5, -3.5, 0});
    bounds.add({5, 3.5, 0});
    return fitted_camera(look, width, height, bounds, [&](const auto& body) { body(bounds.low), body(bounds.high); });
  }
  if (bounds.diagonal() < 1e-9) {  // a single point
    bounds.low -= glm::dvec3(1);
    bounds.high += glm::dvec3(1);
    return fitted_camera(look, width, height, bounds, [&](const auto& body) { body(bounds.low), body(bounds.high); });
  }
  return fitted_camera(look, width, height, bounds, for_each);
}

Camera WorkspaceScenes::usual(const Workspace& workspace, double width, double height) const {
  const bool spatial = std::ranges::any_of(workspace.objects, [&](const SceneObject& object) {
    return !object.hidden && (cache_->of(object).spatial() || object.shows[Show::projection]);
  });
  return fitted(workspace, width, height, usual_camera(workspace, spatial));
}

double WorkspaceScenes::map_range(const Workspace& workspace, std::size_t object, const WorkspaceLook& look) const {
  const SceneObject& thing = workspace.objects[object];
  if (!has_range(thing.map)) return 0;
  return look.map_range > 0 ? look.map_range : cache_->of(thing).numbers(thing.map).range;
}

Sheet WorkspaceScenes::view(const Workspace& workspace, double width, double height, const WorkspaceLook& look) const {
  cache_->keep_only(workspace);
  Bounds bounds;
  std::vector<Thing> things;
  for (std::size_t i = 0; i < workspace.objects.size(); ++i) {
    const SceneObject& object = workspace.objects[i];
    if (object.hidden) continue;
    const ObjectSamples& samples = cache_->of(object);
    Thing thing{i, &object, &samples, i == look.current, std::ranges::find(look.chosen, i) != look.chosen.end()};
    thing.role = object_role(std::clamp(object.color, 0, object_colors - 1));
    const auto domain = domain_of(samples);
    thing.u = within(thing.current && look.u ? *look.u : object.u.to_double(), domain[0]);
    thing.v = within(thing.current && look.v ? *look.v : object.v.to_double(), domain[1]);
    things.push_back(thing);
    for_each_place(object, samples, [&](const glm::dvec3& at) { bounds.add(at); });
  }
  if (bounds.empty()) bounds.add({0, 0, 0});

  Sheet sheet;
  sheet.view.width = width;
  sheet.view.height = height;
  sheet.view.camera = look.camera ? *look.camera : usual(workspace, width, height);
  WorkspaceBuilder builder(look, bounds, sheet);
  builder.add_ground();
  // The current one last, over the others.
  std::ranges::stable_partition(things, [](const Thing& thing) { return !thing.current; });
  for (const Thing& thing : things) builder.add_shape(thing);
  builder.hide_ground_names();
  if (look.handles) {
    for (const Thing& thing : things) builder.add_points(thing);
    for (const Thing& thing : things) builder.add_marks(thing);
    if (things.size() > 1)
      for (const Thing& thing : things) builder.add_name(thing);
    builder.add_gizmo();
    builder.finish();
  }
  return sheet;
}

namespace {

// The sample of a curve nearest to `at` on the page, and how far away it is.
struct Near {
  double u = 0, distance = 1e300;
};
Near nearest_on(const CurveTrack& track, const Lens& lens, glm::dvec2 at) {
  Near best;
  track.for_each_piece([&](std::size_t first, std::size_t end) {
    std::optional<Lens::Seen> before;
    for (std::size_t i = first; i < end; ++i) {
      const auto seen = lens(track.points[i]);
      if (seen) {
        const glm::dvec2 b{seen->x, seen->y};
        glm::dvec2 a = b;
        if (before) a = {before->x, before->y};
        const glm::dvec2 ab = b - a;
        const double square = glm::dot(ab, ab),
                     t = square > 0 ? std::clamp(glm::dot(at - a, ab) / square, 0.0, 1.0) : 1;
        const double distance = glm::length(a + t * ab - at);
        if (distance < best.distance) {
          const double u0 = before && i > first ? track.u[i - 1] : track.u[i];
          best = {u0 + t * (track.u[i] - u0), distance};
        }
      }
      before = seen;
    }
  });
  return best;
}

// Where the ray through `at` meets the triangles of a surface first.
std::optional<glm::dvec2> seen_through(const SurfaceTrack& track, const Lens& lens, glm::dvec2 at) {
  std::vector<glm::dvec3> seen;
  seen.reserve(track.mesh.positions.size());
  for (const glm::dvec3& p : track.mesh.positions) {
    const auto s = lens(p);
    seen.push_back(s ? glm::dvec3{s->x, s->y, s->z} : glm::dvec3{1e9, 1e9, -1e9});
  }
  std::optional<glm::dvec2> best;
  double nearest = -1e300;
  const auto uv = [&](std::uint32_t i) {
    return glm::dvec2{track.u[i / track.columns()], track.v[i % track.columns()]};
  };
  const auto& indices = track.mesh.indices;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const glm::dvec3 &a = seen[indices[i]], &b = seen[indices[i + 1]], &c = seen[indices[i + 2]];
    if (std::max({a.x, b.x, c.x}) < at.x || std::min({a.x, b.x, c.x}) > at.x) continue;
    if (std::max({a.y, b.y, c.y}) < at.y || std::min({a.y, b.y, c.y}) > at.y) continue;
    const double whole = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (whole == 0) continue;
    const double s = ((at.x - a.x) * (c.y - a.y) - (c.x - a.x) * (at.y - a.y)) / whole;
    const double t = ((b.x - a.x) * (at.y - a.y) - (at.x - a.x) * (b.y - a.y)) / whole;
    if (s < 0 || t < 0 || s + t > 1) continue;
    const double z = a.z + s * (b.z - a.z) + t * (c.z - a.z);
    if (z <= nearest) continue;
    nearest = z;
    best = uv(indices[i]) + s * (uv(indices[i + 1]) - uv(indices[i])) + t * (uv(indices[i + 2]) - uv(indices[i]));
  }
  return best;
}

}  // namespace

std::optional<glm::dvec2> WorkspaceScenes::parameter_at(const Workspace& workspace, std::size_t object,
                                                        const Camera& camera, ViewSize size, glm::dvec2 at,
                                                        double reach) const {
  if (object >= workspace.objects.size() || workspace.objects[object].hidden) return std::nullopt;
  const ObjectSamples& samples = cache_->of(workspace.objects[object]);
  const Lens lens(camera, size);
  if (samples.curve() != nullptr) {
    const Near near = nearest_on(samples.track(), lens, at);
    return near.distance <= reach ? std::optional(glm::dvec2{near.u, 0}) : std::nullopt;
  }
  if (samples.surface() == nullptr) return std::nullopt;
  const SurfaceTrack& track = samples.mesh();
  if (const auto uv = seen_through(track, lens, at)) return uv;
  // Beside it: the nearest vertex, as one drags over the edge.
  std::optional<glm::dvec2> best;
  double nearest = reach;
  for (const std::uint32_t i : track.mesh.indices) {
    const auto seen = lens(track.mesh.positions[i]);
    const double distance = seen ? glm::length(glm::dvec2{seen->x, seen->y} - at) : 1e300;
    if (distance > nearest) continue;
    nearest = distance;
    best = glm::dvec2{track.u[i / track.columns()], track.v[i % track.columns()]};
  }
  return best;
}

std::optional<Camera> WorkspaceScenes::riding(const Workspace& workspace, std::size_t object, double u) const {
  if (object >= workspace.objects.size()) return std::nullopt;
  const ObjectSamples& samples = cache_->of(workspace.objects[object]);
  const auto* curve = samples.curve();
  if (curve == nullptr) return std::nullopt;
  const double at = within(u, {curve->domain_begin(), curve->domain_end()});
  const auto here = moving_frame_at(samples, at);
  if (!here) return std::nullopt;
  const glm::dvec3 ahead = plain(here->tangent), up = plain(here->normal);
  const double size = std::max(samples.shape_bounds().diagonal(), 1e-9);

  Camera camera;
  camera.kind = Camera::Kind::orbit;
  camera.perspective = true;
  camera.height = 0.25 * size;
  // A little downwards, so that the curve is seen.
  const glm::dvec3 toward = glm::normalize(-ahead + 0.12 * up);
  camera.elevation = std::asin(std::clamp(toward.z, -1.0, 1.0));
  camera.azimuth = std::hypot(toward.x, toward.y) > 1e-12 ? std::atan2(toward.y, toward.x) : 0;
  const ViewAxes axes = axes_of(camera);
  // The picture turns clockwise about what it looks at until `up` is upwards.
  camera.roll = std::atan2(-glm::dot(up, axes.right), glm::dot(up, axes.up));
  const glm::dvec3 eye = plain(here->point) + 0.05 * size * up - 0.02 * size * ahead;
  camera.centre = eye - camera.height / 2 / half_angle_tangent * toward;
  return camera;
}

}  // namespace blossom
