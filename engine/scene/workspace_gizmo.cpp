// The handles for moving, turning and scaling what is chosen: always of one size, and never hidden.
#include <array>
#include <cmath>
#include <numbers>

#include "scene/workspace_builder.hpp"

namespace blossom {
namespace {

constexpr double reach = 84, arc_radius = 58, cube_at = 34;  // page units from the middle
constexpr double handle_spot = 11;
constexpr int arc_steps = 24;
constexpr std::array<Role, 3> axis_roles{Role::current, Role::curve_result, Role::level_a};
constexpr std::array<double, 3> axis_widths{0.6, 0.67, 1.25};  // as strong as one another
constexpr std::array<const char*, 3> axis_names{"x", "y", "z"};

}  // namespace

void WorkspaceBuilder::add_gizmo() {
  if (!look_.gizmo) return;
  const auto seen = lens_(*look_.gizmo);
  if (!seen) return;
  // Brought to the viewer on the rays of sight: it looks the same, and stands before everything.
  const double front = bounds_.diagonal() + lens_.camera().height / 4;
  const bool perspective = lens_.perspective();
  const double ahead = lens_.z_of(bounds_.centre()) + front;
  const double z = perspective ? std::min(ahead, 0.8 * lens_.eye()) : ahead;
  const bool is_flat = flat();
  const auto middle =
      is_flat ? *look_.gizmo : lens_.back({seen->x, seen->y}, std::max(z, seen->z)).value_or(*look_.gizmo);
  const double unit = perspective ? unit_ * (1 - lens_.z_of(middle) / lens_.eye()) : unit_;
  const auto axis = [](int i) {
    glm::dvec3 d(0);
    d[i] = 1;
    return d;
  };
  const auto handle = [&](std::uint32_t id, const glm::dvec3& at, std::string name) {
    add_spot({Link::Kind::handle, id, 0}, at, handle_spot, std::move(name));
  };
  const glm::dvec3 toward = lens_.to_viewer(middle);
  // An axis that points at the viewer cannot be dragged along, and a ring seen from its edge cannot be turned.
  const auto usable = [&](int i, bool ring) {
    if (is_flat) return ring == (i == 2);
    const double along = std::abs(glm::dot(axis(i), toward));
    return ring ? along > 0.12 : along < 0.97;
  };
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!usable(i, false)) continue;
    const glm::dvec3 tip = middle + axis(i) * (reach * unit);
    view_.polylines.push_back(arrow(middle, tip, axis_roles[at], axis_widths[at]));
    view_.labels.push_back(label_around(tip, italic(axis_names[at]), axis_roles[at], 50, false));
    handle(static_cast<std::uint32_t>(i), tip, std::string("move ") + axis_names[at]);
  }
  for (int i = 0; i < 3; ++i) {
    if (!usable(i, true)) continue;
    const auto at = static_cast<std::size_t>(i);
    const glm::dvec3 a = axis((i + 1) % 3), b = axis((i + 2) % 3);
    std::vector<glm::dvec3> arc;
    for (int s = 2; s <= arc_steps - 2; ++s) {
      const double angle = std::numbers::pi / 2 * s / arc_steps;
      arc.push_back(middle + (arc_radius * unit) * (std::cos(angle) * a + std::sin(angle) * b));
    }
    const glm::dvec3 grip = arc[arc.size() / 2];
    view_.polylines.push_back(line(std::move(arc), axis_roles[at], 0.75 * axis_widths[at]));
    view_.markers.push_back(
        marker(grip, axis_roles[at], axis_roles[at] == Role::current ? 0.65 : 1, Marker::Shape::diamond));
    handle(static_cast<std::uint32_t>(4 + i), grip, std::string("turn ") + axis_names[at]);
  }
  const glm::dvec3 diagonal = is_flat ? glm::dvec3{-1, -1, 0} : glm::dvec3{-1, -1, -1};
  const glm::dvec3 cube = middle + diagonal * (cube_at * unit);
  view_.polylines.push_back(line({middle, cube}, Role::text, 1));
  view_.markers.push_back(marker(cube, Role::text, 2, Marker::Shape::square));
  handle(7, cube, "scale");
  view_.markers.push_back(marker(middle, Role::text, 2, Marker::Shape::ring));
  handle(3, middle, "move");
}

}  // namespace blossom
