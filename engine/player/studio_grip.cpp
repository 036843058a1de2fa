#include "player/studio_grip.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "player/edit.hpp"
#include "player/studio.hpp"

namespace blossom {
namespace {

constexpr double least_factor = 0.05, most_factor = 20;  // of a drag that scales

Exact zero() { return Exact(0); }
Point<Exact> nowhere() { return {zero(), zero(), zero()}; }

glm::dvec3 unit_vector(int axis) {
  glm::dvec3 e{0, 0, 0};
  e[axis] = 1;
  return e;
}

bool is_plane_curve(const Geometry& geometry) {
  if (const auto* curve = std::get_if<Curve<Exact>>(&geometry)) return curve->dimension == 2;
  const auto* row = std::get_if<PointRow<Exact>>(&geometry);
  return row != nullptr && row->dimension == 2;
}

// The axis that runs most along the drag on the page.
std::optional<int> axis_along(const StudioGrip& grip, const glm::dvec3& from, glm::dvec2 drag, int dimension) {
  const auto on_page = to_page(grip.camera, grip.size, from);
  const double length = glm::length(drag);
  if (!on_page || !(length > 0)) return std::nullopt;
  std::optional<int> best;
  double most = 0;
  for (int axis = 0; axis < dimension; ++axis) {
    const auto end = to_page(grip.camera, grip.size, from + 1e-3 * grip.camera.height * unit_vector(axis));
    if (!end) continue;
    const glm::dvec2 seen = *end - *on_page;
    const double seen_length = glm::length(seen), full = 1e-3 * grip.size.height;
    if (seen_length < 0.05 * full) continue;  // it runs toward the viewer
    const double along = std::abs(glm::dot(seen, drag)) / (seen_length * length);
    if (along > most) most = along, best = axis;
  }
  return best;
}

// From `from`, taken where the mouse was, to what is meant now; snapped as exact numbers.
Point<Exact> moved(const StudioGrip& grip, const Point<Exact>& start, glm::dvec2 mouse, std::optional<int> along,
                   bool flat, bool snap_place, double grid) {
  const glm::dvec3 from = in_world(start);
  const auto on_page = to_page(grip.camera, grip.size, from);
  if (!on_page || mouse == grip.start) return nowhere();
  const glm::dvec2 target = *on_page + (mouse - grip.start);
  const glm::dvec3 toward = axes_of(grip.camera).toward;
  const glm::dvec3 normal = flat && std::abs(toward.z) > 0.05 ? glm::dvec3{0, 0, 1} : toward;
  const auto there = [&](glm::dvec2 at) {
    return along ? to_line(grip.camera, grip.size, at, from, unit_vector(*along))
                 : on_plane(grip.camera, grip.size, at, from, normal);
  };
  const auto to = there(target);
  const auto here = to_world(grip.camera, grip.size, *on_page, from),
             beside = to_world(grip.camera, grip.size, *on_page + glm::dvec2{1, 0}, from);
  if (!to || !here || !beside || !std::isfinite(to->x + to->y + to->z)) return nowhere();
  const double unit = std::max(glm::length(*beside - *here), 1e-12);
  Point<Exact> by = nowhere();
  for (int i = 0; i < (flat ? 2 : 3); ++i) {
    const double distance = (*to)[i] - from[i];
    if (along ? i != *along : std::abs(distance) <= 1e-9 * unit) continue;
    by[i] = snap_place ? snapped((*to)[i], unit, grid) - start[i] : snapped(distance, unit, grid);
  }
  return by;
}

// The angle on the page from where it was taken to the mouse, about the centre; counterclockwise.
double angle_turned(const StudioGrip& grip, glm::dvec2 mouse) {
  const auto centre = to_page(grip.camera, grip.size, in_world(grip.centre));
  if (!centre) return 0;
  const glm::dvec2 a = grip.start - *centre, b = mouse - *centre;
  return std::atan2(a.y * b.x - a.x * b.y, a.x * b.x + a.y * b.y);
}

}  // namespace

glm::dvec3 in_world(const Point<Exact>& p) { return {p.x.to_double(), p.y.to_double(), p.z.to_double()}; }

std::optional<glm::dvec3> on_plane(const Camera& camera, ViewSize size, glm::dvec2 at, const glm::dvec3& through,
                                   const glm::dvec3& normal) {
  const Lens lens(camera, size);
  if (camera.kind == Camera::Kind::page) return to_world(camera, size, at, through);
  const double z = lens.z_of(through);
  const auto near = lens.back(at, z), far = lens.back(at, z - lens.camera().height);
  if (!near || !far) return std::nullopt;
  const glm::dvec3 sight = *far - *near;
  const double down = glm::dot(sight, normal);
  if (std::abs(down) < 1e-9 * glm::length(sight)) return std::nullopt;
  const double t = glm::dot(through - *near, normal) / down;
  const glm::dvec3 place = *near + t * sight;
  // Beyond the horizon the line of sight meets the plane behind the viewer.
  if (lens.perspective() && lens.z_of(place) > 0.98 * lens.eye()) return std::nullopt;
  return place;
}

Point<Exact> displacement(const StudioGrip& grip, glm::dvec2 mouse, const GripKeys& keys) {
  const Geometry& geometry = grip.before->objects[grip.held.object].geometry;
  const auto start = place_of(geometry, grip.held.point);
  if (!start) return nowhere();
  const bool flat = is_plane_curve(geometry);
  const auto along =
      keys.along ? axis_along(grip, in_world(*start), mouse - grip.start, flat ? 2 : 3) : std::optional<int>();
  return moved(grip, *start, mouse, along, flat, true, keys.snap ? grip.grid : 0);
}

Placement placement(const StudioGrip& grip, glm::dvec2 mouse, const GripKeys& keys) {
  Placement made;
  const double grid = keys.snap ? grip.grid : 0;
  const auto id = static_cast<int>(grip.handle);
  if (grip.handle == Handle::move) {
    made.move = moved(grip, grip.centre, mouse, std::nullopt, false, false, grid);
  } else if (id < 3) {
    made.move = moved(grip, grip.centre, mouse, id, false, false, grid);
  } else if (grip.handle != Handle::scale) {
    const int axis = id - static_cast<int>(Handle::turn_x);
    // What turns counterclockwise seen from its axis' tip turns clockwise from behind.
    const double side = glm::dot(axes_of(grip.camera).toward, unit_vector(axis)) < 0 ? -1 : 1;
    const double step = keys.snap ? 15 : 1;
    const double degrees = side * angle_turned(grip, mouse) * 180 / 3.14159265358979323846;
    made.turn[axis] = Exact(static_cast<int>(std::lround(degrees / step) * std::lround(step)));
  } else {
    const auto centre = to_page(grip.camera, grip.size, in_world(grip.centre));
    if (!centre) return made;
    const double before = std::max(glm::length(grip.start - *centre), 1.0);
    const double factor = std::clamp(glm::length(mouse - *centre) / before, least_factor, most_factor);
    const int parts = keys.snap ? 4 : 100;
    const Exact exact = Exact::ratio(std::max<std::int64_t>(1, std::llround(factor * parts)), parts);
    made.scale = {exact, exact, exact};
  }
  return made;
}

Worked dragged(const StudioGrip& grip, glm::dvec2 mouse, const GripKeys& keys, bool quick) {
  if (grip.kind == StudioGrip::Kind::points) {
    const Point<Exact> by = displacement(grip, mouse, keys);
    return by == nowhere() ? Worked(*grip.before) : edit::move_points(*grip.before, grip.points, by, quick);
  }
  const Placement made = placement(grip, mouse, keys);
  if (made.is_identity()) return *grip.before;
  return grip.points.empty() ? edit::place(*grip.before, grip.objects, made, grip.centre, quick)
                             : edit::place(*grip.before, grip.points, made, grip.centre, quick);
}

std::vector<PointRef> boxed(const Workspace& workspace, const StudioGrip& grip, glm::dvec2 mouse) {
  const glm::dvec2 low = glm::min(grip.start, mouse), high = glm::max(grip.start, mouse);
  std::vector<PointRef> found;
  for (std::size_t i = 0; i < workspace.objects.size(); ++i) {
    const SceneObject& object = workspace.objects[i];
    if (object.hidden || !object.shows[Show::points]) continue;
    for (std::size_t point = 0; point < point_count(object.geometry); ++point) {
      const auto place = place_of(object.geometry, point);
      const auto at = place ? to_page(grip.camera, grip.size, in_world(*place)) : std::nullopt;
      if (at && at->x >= low.x && at->y >= low.y && at->x <= high.x && at->y <= high.y) found.push_back({i, point});
    }
  }
  return found;
}

std::string point_name(const Geometry& geometry, std::size_t point) {
  const auto cell = [&](int columns) {
    const auto wide = static_cast<std::size_t>(std::max(columns, 1));
    return "P[" + std::to_string(point / wide) + "][" + std::to_string(point % wide) + "]";
  };
  if (const auto* surface = std::get_if<Surface<Exact>>(&geometry)) return cell(surface->columns);
  if (const auto* net = std::get_if<PointNet<Exact>>(&geometry)) return cell(net->columns);
  return "P[" + std::to_string(point) + "]";
}

// ---- what the studio's mouse holds ----------------------------------------------------------------------------------

namespace {

constexpr const char* drag_gesture = "drag";

std::string what_moves(const StudioGrip& grip) {
  static constexpr std::string_view done[] = {"moved", "turned", "scaled"};
  const int id = static_cast<int>(grip.handle);
  const auto how = grip.kind == StudioGrip::Kind::points || id < 4 ? done[0] : id < 7 ? done[1] : done[2];
  const auto& objects = grip.before->objects;
  std::string what;
  if (grip.points.size() == 1)
    what = objects[grip.points[0].object].name + " " +
           point_name(objects[grip.points[0].object].geometry, grip.points[0].point);
  else if (!grip.points.empty())
    what = std::to_string(grip.points.size()) + " points";
  else
    what = grip.objects.size() == 1 ? objects[grip.objects[0]].name : std::to_string(grip.objects.size()) + " things";
  return what + " " + std::string(how);
}

}  // namespace

void Studio::take(StudioGrip grip) {
  if (grip.kind == StudioGrip::Kind::points || grip.kind == StudioGrip::Kind::handle)
    grip.before = std::make_shared<const Workspace>(workspace());
  const glm::dvec2 start = grip.start;
  history_.end_gesture();
  held_ = Held{std::move(grip), start, {}, false, false};
}

void Studio::drag(glm::dvec2 mouse, const GripKeys& keys) {
  if (!held_ || held_->over) return;
  held_->mouse = mouse;
  held_->keys = keys;
  const StudioGrip& grip = held_->grip;
  const auto index = static_cast<std::size_t>(grip.pane);
  // Fitted again to what moves, the view would run away from the mouse.
  if (!cameras[index] && !riding_) cameras[index] = grip.camera;
  switch (grip.kind) {
    case StudioGrip::Kind::look:
      cameras[index] = grip.turns ? orbited(grip.camera, grip.size, mouse - grip.start)
                                  : panned(grip.camera, grip.size, mouse - grip.start);
      break;
    case StudioGrip::Kind::points:
    case StudioGrip::Kind::handle:
      held_->moved = edit(dragged(grip, mouse, keys, true), what_moves(grip), drag_gesture) || held_->moved;
      break;
    case StudioGrip::Kind::parameter:
      if (current() == grip.object)
        if (const auto uv = scenes_->parameter_at(workspace(), grip.object, grip.camera, grip.size, mouse, 1e9))
          look_at(uv->x, uv->y);
      break;
    case StudioGrip::Kind::box:
      break;
  }
}

void Studio::let_go() {
  if (!held_) return;
  const Held held = *std::exchange(held_, std::nullopt);
  if (held.over) return;
  if (held.grip.kind == StudioGrip::Kind::box) {
    select(boxed(workspace(), held.grip, held.mouse), held.keys.snap);
  } else if (held.moved) {
    // What was made quickly is made exactly; a drag that led back is no edit.
    auto last = dragged(held.grip, held.mouse, held.keys, false);
    if (last && *last == *held.grip.before)
      cancel_gesture();
    else
      edit(std::move(last), what_moves(held.grip), drag_gesture);
  }
  problems_.clear();
  history_.end_gesture();
}

bool Studio::put_back() {
  if (!held_ || held_->over) return false;
  held_->over = true;
  if (held_->grip.kind == StudioGrip::Kind::look)
    cameras[static_cast<std::size_t>(held_->grip.pane)] = held_->grip.camera;
  else if (held_->moved)
    cancel_gesture();
  problems_.clear();
  return true;
}

}  // namespace blossom
