#include "scene/grid.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/scalar.hpp"
#include "scene/camera.hpp"

namespace blossom {
namespace {

constexpr int most_lines = 200;

Label quiet_label(const glm::dvec3& at, std::string text, Label::Placement placement) {
  Label label;
  label.anchor = at;
  label.text = {{std::move(text)}};
  label.role = Role::text_quiet;
  label.size_scale = 0.66;
  label.placement = placement;
  label.optional = true;
  label.priority = -10;
  return label;
}

// With as many decimals as tell neighbours apart.
std::string tick_text(double value, double step) {
  if (std::abs(value) < step / 2) return "0";
  return format_short(value, static_cast<int>(std::clamp(std::ceil(-std::log10(step)), 6.0, 15.0)));
}

Polyline two_points(const glm::dvec3& a, const glm::dvec3& b, Role role) {
  Polyline made;
  made.points = {a, b};
  made.role = role;
  return made;
}

// The multiples of a step from low to high; counted, as a step that is tiny beside its multiples adds up to nothing.
template <class Body>
void for_each_multiple(double step, double low, double high, const Body& body) {
  const double first = std::ceil(low / step);
  for (int i = 0; i < most_lines; ++i) {
    const double value = (first + i) * step;
    if (!(value <= high)) break;
    body(value, std::abs(value) < step / 2);
  }
}

}  // namespace

double nice_step(double length, double count) {
  const double raw = length / count;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power) return factor * power;
  return 10 * power;
}

double plane_grid_step(const Camera& camera, double width, double height) {
  return nice_step(camera.height * width / height, 10);
}

double ground_grid_step(const Bounds& bounds) {
  const glm::dvec3 size = bounds.high - bounds.low;
  const double largest = std::max({size.x, size.y, size.z, 1e-6});
  return nice_step(1.3 * std::max({size.x, size.y, largest / 2}), 10);
}

void add_plane_grid(View& view, double depth) {
  const Camera& camera = view.camera;
  const ViewAxes axes = axes_of(camera);
  const double half_h = camera.height / 2;
  const double half_w = half_h * view.width / view.height;
  const double step = plane_grid_step(camera, view.width, view.height);
  const double unit = camera.height / view.height;  // of the page, in the world
  const double edge = 0.02 * camera.height;
  const double x0 = glm::dot(camera.centre, axes.right), y0 = glm::dot(camera.centre, axes.up);
  const double left = x0 - half_w, right = x0 + half_w;
  const double bottom = y0 - half_h, top = y0 + half_h;
  const auto place = [&](double x, double y) { return x * axes.right + y * axes.up + depth * axes.toward; };
  const auto tick = [&](double value, const glm::dvec3& at) {
    view.labels.push_back(quiet_label(at, tick_text(value, step), Label::Placement::left));
  };
  for_each_multiple(step, left, right, [&](double x, bool axis) {
    view.polylines.push_back(two_points(place(x, bottom), place(x, top), axis ? Role::axis : Role::grid));
    if (x + 36 * unit < right) tick(x, place(x + 0.3 * edge, bottom + 0.6 * edge));
  });
  for_each_multiple(step, bottom, top, [&](double y, bool axis) {
    view.polylines.push_back(two_points(place(left, y), place(right, y), axis ? Role::axis : Role::grid));
    if (y + 16 * unit < top) tick(y, place(left + 0.6 * edge, y + 0.3 * edge));
  });
}

void add_ground_grid(View& view, const Bounds& bounds) {
  const glm::dvec3 size = bounds.high - bounds.low;
  const double largest = std::max({size.x, size.y, size.z, 1e-6});
  const double step = ground_grid_step(bounds);
  const double pad = 0.5 * step;
  const double x0 = std::floor((bounds.low.x - pad) / step) * step, x1 = std::ceil((bounds.high.x + pad) / step) * step;
  const double y0 = std::floor((bounds.low.y - pad) / step) * step, y1 = std::ceil((bounds.high.y + pad) / step) * step;
  // At height 0 where that is not far below; the bounds may also reach below 0.
  const double ground = bounds.low.z > 0 && bounds.low.z < largest / 4 ? 0 : bounds.low.z;

  // Lines have a point at each crossing: what is behind the viewer leaves the rest in sight.
  const auto grid_line = [&](bool along_x, double at) {
    Polyline line;
    line.role = Role::grid;
    const double from = along_x ? x0 : y0, to = along_x ? x1 : y1;
    for_each_multiple(step, from - step / 2, to + step / 2, [&](double s, bool) {
      line.points.push_back(along_x ? glm::dvec3{s, at, ground} : glm::dvec3{at, s, ground});
    });
    if (line.points.size() > 1) view.polylines.push_back(std::move(line));
  };
  // Numbers stand at the two edges that are nearest to the viewer, at every other line.
  const glm::dvec3 toward = axes_of(view.camera).toward;
  const double near_x = toward.x > 0 ? x1 + 0.35 * step : x0 - 0.35 * step;
  const double near_y = toward.y > 0 ? y1 + 0.35 * step : y0 - 0.35 * step;
  for_each_multiple(step, x0 - step / 2, x1 + step / 2, [&](double x, bool) {
    grid_line(false, x);
    if (std::fmod(std::round(std::abs(x / step)), 2) == 0)
      view.labels.push_back(quiet_label({x, near_y, ground}, tick_text(x, step), Label::Placement::centre));
  });
  for_each_multiple(step, y0 - step / 2, y1 + step / 2, [&](double y, bool) {
    grid_line(true, y);
    if (std::fmod(std::round(std::abs(y / step)), 2) == 0)
      view.labels.push_back(quiet_label({near_x, y, ground}, tick_text(y, step), Label::Placement::centre));
  });

  const auto arrow = [&](const glm::dvec3& from, const glm::dvec3& to, const char* name) {
    Polyline line = two_points(from, to, Role::axis);
    line.arrow = true;
    view.polylines.push_back(std::move(line));
    Label label;
    label.anchor = to;
    label.text = {{name, TextRun::Level::base, true}};
    label.role = Role::text_quiet;
    label.placement = Label::Placement::around;
    label.priority = -5;
    label.optional = true;
    view.labels.push_back(std::move(label));
  };
  // From the origin, or what of the grid is nearest to it; short enough to be seen beside what stands there.
  const glm::dvec3 origin{std::clamp(0.0, x0, x1), std::clamp(0.0, y0, y1), ground};
  const double length = std::max(0.3 * largest, step);
  arrow(origin, origin + glm::dvec3{length, 0, 0}, "x");
  arrow(origin, origin + glm::dvec3{0, length, 0}, "y");
  arrow(origin, origin + glm::dvec3{0, 0, length}, "z");
}

}  // namespace blossom
