// How a scene is looked at, what a place in a pane means, and what moves by itself.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "player/edit.hpp"
#include "player/studio.hpp"
#include "scene/grid.hpp"

namespace blossom {
namespace {

constexpr double seconds_along = 6;
constexpr double grazing = 0.12;      // sine of the angle below which a plane is seen from its edge
constexpr int fine_parameter = 1000;  // pieces of the domain, of what is dragged

constexpr double pi = 3.14159265358979323846;

glm::dvec3 normal_of(StudioPane pane) {
  switch (pane) {
    case StudioPane::xz:
      return {0, 1, 0};
    case StudioPane::yz:
      return {1, 0, 0};
    default:
      return {0, 0, 1};
  }
}

}  // namespace

std::string_view pane_name(StudioPane pane) {
  static constexpr std::string_view names[] = {"space", "xy", "xz", "yz"};
  return names[static_cast<std::size_t>(pane)];
}

WorkspaceLook Studio::look() const {
  WorkspaceLook look;
  look.current = current().value_or(SIZE_MAX);
  look.chosen = chosen_;
  look.selected = selected_;
  if (moving_u_) look.u = moving_u_;
  look.comb_scale = comb_scale;
  look.map_range = map_range;
  if (gizmo && !riding_)
    if (const auto at = centre()) look.gizmo = in_world(*at);
  return look;
}

// The space pane is looked at as the scene says; the others straight at their planes. The xy pane is a plane camera's,
// with a grid all over.
Camera Studio::camera_of(StudioPane which, ViewSize size) const {
  if (which == StudioPane::space && riding_)
    if (const auto i = current())
      if (const auto camera = scenes_->riding(workspace(), *i, u())) return *camera;
  if (const auto& camera = cameras[static_cast<std::size_t>(which)]) return *camera;
  Camera look;
  look.kind = which == StudioPane::xy ? Camera::Kind::plane : Camera::Kind::orbit;
  if (which == StudioPane::space) {
    if (const auto& first = workspace().look; first && first->from == Look::From::space) {
      look.azimuth = first->azimuth;
      look.elevation = first->elevation;
    }
    look.perspective = perspective;
  } else if (which != StudioPane::xy) {
    look.azimuth = which == StudioPane::yz ? 0 : -pi / 2;
    look.elevation = 0;
  }
  return scenes_->fitted(workspace(), size.width, size.height, look);
}

void Studio::fit() { cameras = {}; }

void Studio::zoom(double factor) {
  const auto index = static_cast<std::size_t>(pane);
  const ViewSize size = pane_sizes[index];
  cameras[index] = zoomed(camera_of(pane), size, {size.width / 2, size.height / 2}, factor);
}

void Studio::show_pane(StudioPane which) {
  pane = which;
  four_panes = false;
}

void Studio::set_perspective(bool on) {
  perspective = on;
  if (auto& camera = cameras[static_cast<std::size_t>(StudioPane::space)]) camera->perspective = on;
}

double Studio::grid_of(StudioPane which, ViewSize size) const {
  return plane_grid_step(camera_of(which, size), size.width, size.height);
}

std::optional<Point<Exact>> Studio::place_at(StudioPane which, ViewSize size, glm::dvec2 at, double grid) const {
  const Camera camera = camera_of(which, size);
  Point<Exact> through{Exact(0), Exact(0), Exact(0)};
  if (!clicked_.empty()) {
    through = clicked_.back();
  } else if (const SceneObject* here = object()) {
    if (const std::size_t count = point_count(here->geometry); count > 0)
      through = place_of(here->geometry, count - 1).value_or(through);
  }
  const glm::dvec3 reference = in_world(through), toward = axes_of(camera).toward;
  glm::dvec3 normal = normal_of(which);
  if (std::abs(glm::dot(normal, toward)) < grazing) normal = toward;
  const auto place = on_plane(camera, size, at, reference, normal);
  const auto beside = on_plane(camera, size, at + glm::dvec2{1, 0}, reference, normal);
  if (!place || !beside || !std::isfinite(place->x + place->y + place->z)) return std::nullopt;
  const double unit = std::max(glm::length(*beside - *place), 1e-12);
  Point<Exact> exact = through;
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs((*place)[axis] - reference[axis]) > 1e-9 * unit) exact[axis] = snapped((*place)[axis], unit, grid);
  return exact;
}

std::optional<Studio::Hit> Studio::hit_at(StudioPane which, ViewSize size, glm::dvec2 at, double reach) const {
  const Camera camera = camera_of(which, size);
  // Curves lie on surfaces and are thinner: they come first, and among those the current one, then what is drawn last.
  std::vector<std::size_t> order;
  const auto& objects = workspace().objects;
  for (const bool surfaces : {false, true}) {
    const std::size_t begin = order.size();
    for (std::size_t i = objects.size(); i-- > 0;)
      if (!objects[i].hidden && std::holds_alternative<Surface<Exact>>(objects[i].geometry) == surfaces)
        order.push_back(i);
    if (const auto here = current()) {
      const auto found = std::find(order.begin() + static_cast<std::ptrdiff_t>(begin), order.end(), *here);
      if (found != order.end()) std::rotate(order.begin() + static_cast<std::ptrdiff_t>(begin), found, found + 1);
    }
  }
  for (const std::size_t i : order)
    if (const auto uv = scenes_->parameter_at(workspace(), i, camera, size, at, reach)) return Hit{i, *uv};
  return std::nullopt;
}

// ---- what moves -----------------------------------------------------------------------------------------------------

double Studio::u() const {
  const SceneObject* here = object();
  return here == nullptr ? 0 : moving_u_.value_or(here->u.to_double());
}

double Studio::v() const {
  const SceneObject* here = object();
  return here == nullptr ? 0 : here->v.to_double();
}

void Studio::run(bool on) {
  if (on == running_) return;
  if (!on) {
    // Where it stopped is where one looks from then on.
    const double here = u();
    stop();
    look_at(here, v());
    return;
  }
  const SceneObject* here = object();
  if (here == nullptr) return;
  const Range range = domain_of(here->geometry);
  if (!(range.last.x > range.first.x)) return;
  const double now = u();
  running_ = true;
  moving_u_ = now >= range.last.x ? range.first.x : now;
}

void Studio::ride(bool on) {
  const SceneObject* here = object();
  if (on && (here == nullptr || !std::holds_alternative<Curve<Exact>>(here->geometry))) return;
  if (on && !four_panes) pane = StudioPane::space;
  run(on);
  riding_ = on && running_;
}

void Studio::stop() {
  running_ = riding_ = false;
  moving_u_.reset();
}

bool Studio::advance(double seconds) {
  if (!running_ || !moving_u_) return false;
  const Range range = domain_of(object()->geometry);
  const double length = range.last.x - range.first.x;
  double at = *moving_u_ - range.first.x + seconds * speed * length / seconds_along;
  if (at >= length) at = std::fmod(at, length);
  moving_u_ = range.first.x + at;
  return true;
}

bool Studio::look_at(double u_at, double v_at) {
  const SceneObject* here = object();
  if (here == nullptr) return false;
  const Range range = domain_of(here->geometry);
  // Numbers that one can say, as fine as a hand can point.
  const auto said = [&](double x, int axis) {
    const double unit = (range.last[axis] - range.first[axis]) / fine_parameter;
    return unit > 0 && std::isfinite(x) ? snapped(x, unit) : Exact(range.first[axis]);
  };
  return look_at(said(u_at, 0), said(v_at, 1));
}

bool Studio::look_at(const Exact& u_at, const Exact& v_at) {
  const auto i = current();
  if (!i) return false;
  stop();
  const std::string name = object()->name;
  return edit(edit::look_at(workspace(), *i, u_at, v_at), name + " looked at elsewhere", "look at " + name);
}

}  // namespace blossom
