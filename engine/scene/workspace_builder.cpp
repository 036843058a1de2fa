#include "scene/workspace_builder.hpp"

#include <algorithm>
#include <cmath>

#include "scene/grid.hpp"

namespace blossom {
namespace {

constexpr double arrow_length = 78;      // page units
constexpr std::size_t most_names = 150;  // of control points
constexpr std::size_t many_points = 80;  // are drawn smaller
constexpr double cell = 4;               // page units, of the depths of faces
constexpr double point_reach = 9, curve_reach = 6, face_reach = 8;
constexpr std::size_t curve_spots = 48, face_spots = 6;

RichText bold(RichText text) {
  for (TextRun& run : text) run.bold = true;
  return text;
}

}  // namespace

RichText italic(std::string text) { return {{std::move(text), TextRun::Level::base, true}}; }

RichText level_name(int level, const std::vector<int>& indices) {
  std::string sub;
  for (const int i : indices) sub += (sub.empty() ? "" : ",") + std::to_string(i);
  RichText name{{"P", TextRun::Level::base, true}, {sub, TextRun::Level::sub}};
  if (level > 0) name.push_back({"(" + std::to_string(level) + ")", TextRun::Level::super});
  return name;
}

RichText point_name(const ObjectSamples& samples, std::size_t point) {
  const int i = static_cast<int>(point), columns = samples.columns();
  return level_name(0, columns > 0 ? std::vector<int>{i / columns, i % columns} : std::vector<int>{i});
}

std::string point_spot_name(const SceneObject& object, const ObjectSamples& samples, std::size_t point) {
  const auto columns = static_cast<std::size_t>(samples.columns());
  if (columns == 0) return object.name + " P[" + std::to_string(point) + "]";
  return object.name + " P[" + std::to_string(point / columns) + "][" + std::to_string(point % columns) + "]";
}

WorkspaceBuilder::WorkspaceBuilder(const WorkspaceLook& look, const Bounds& bounds, Sheet& sheet)
    : look_(look),
      bounds_(bounds),
      sheet_(sheet),
      view_(sheet.view),
      lens_(sheet.view.camera, {sheet.view.width, sheet.view.height}),
      unit_(lens_.camera().height / std::max(sheet.view.height, 1.0)),
      mark_(arrow_length * unit_) {}

void WorkspaceBuilder::add_ground() {
  const Camera& camera = view_.camera;
  const ViewAxes axes = axes_of(camera);
  const auto along_axis = [](const glm::dvec3& d) { return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}); };
  const bool facing = camera.kind == Camera::Kind::plane || (!camera.perspective && along_axis(axes.toward) > 1 - 1e-9);
  if (look_.grid && facing) {
    double depth = 0;
    if (camera.kind == Camera::Kind::orbit) {
      // Behind everything that stands there.
      depth = std::min(0.0, glm::dot(bounds_.centre(), axes.toward) - bounds_.diagonal() / 2);
    }
    add_plane_grid(view_, depth);
  } else if (look_.grid) {
    add_ground_grid(view_, bounds_);
  } else if (look_.axes && camera.kind == Camera::Kind::orbit) {
    const double length = std::max(0.3 * bounds_.diagonal(), mark_);
    const char* names[] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
      glm::dvec3 along(0);
      along[i] = length;
      view_.polylines.push_back(arrow({0, 0, 0}, along, Role::axis));
      view_.labels.push_back(label_around(along, italic(names[i]), Role::text_quiet, -5));
    }
  }
}

void WorkspaceBuilder::find_nearest() const {
  cell_columns_ = static_cast<int>(std::ceil(view_.width / cell)) + 1;
  cell_rows_ = static_cast<int>(std::ceil(view_.height / cell)) + 1;
  nearest_.assign(static_cast<std::size_t>(cell_columns_) * static_cast<std::size_t>(cell_rows_), -1e30F);
  std::vector<glm::dvec3> seen;
  for (std::size_t m = 0; m < opaque_; ++m) {
    const Mesh& mesh = view_.meshes[m];
    seen.clear();
    for (const glm::dvec3& at : mesh.positions) {
      const auto found = lens_(at);
      seen.push_back(found ? glm::dvec3{found->x / cell, found->y / cell, found->z} : glm::dvec3{-1e9, -1e9, -1e9});
    }
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      const glm::dvec3 &a = seen[mesh.indices[i]], &b = seen[mesh.indices[i + 1]], &c = seen[mesh.indices[i + 2]];
      const glm::dvec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
      if (!(low.x > -1e6 && high.x < 1e6 && low.y > -1e6 && high.y < 1e6)) continue;
      const double whole = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
      if (whole == 0) continue;
      const int x0 = std::max(0, static_cast<int>(low.x)), x1 = std::min(cell_columns_ - 1, static_cast<int>(high.x));
      const int y0 = std::max(0, static_cast<int>(low.y)), y1 = std::min(cell_rows_ - 1, static_cast<int>(high.y));
      for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
          const double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
          const double s = (px * (c.y - a.y) - (c.x - a.x) * py) / whole,
                       t = ((b.x - a.x) * py - px * (b.y - a.y)) / whole;
          if (s < 0 || t < 0 || s + t > 1) continue;
          float& near = nearest_[static_cast<std::size_t>(y) * static_cast<std::size_t>(cell_columns_) +
                                 static_cast<std::size_t>(x)];
          near = std::max(near, static_cast<float>(a.z + s * (b.z - a.z) + t * (c.z - a.z)));
        }
    }
  }
}

bool WorkspaceBuilder::hidden(const glm::dvec3& at) const {
  if (opaque_ == 0) return false;
  if (nearest_.empty()) find_nearest();
  const auto seen = lens_(at);
  if (!seen || !(seen->x >= 0 && seen->y >= 0 && seen->x < view_.width && seen->y < view_.height)) return false;
  const auto index = static_cast<std::size_t>(seen->y / cell) * static_cast<std::size_t>(cell_columns_) +
                     static_cast<std::size_t>(seen->x / cell);
  return static_cast<double>(nearest_[index]) > seen->z + 0.02 * lens_.camera().height;
}

void WorkspaceBuilder::hide_ground_names() {
  std::erase_if(view_.labels, [&](const Label& label) { return label.optional && hidden(label.anchor); });
}

void WorkspaceBuilder::add_label(Label label) {
  if (!hidden(label.anchor)) view_.labels.push_back(std::move(label));
}

void WorkspaceBuilder::add_spot(const Link& link, const glm::dvec3& at, double half, std::string name) {
  const auto seen = lens_(at);
  if (!seen || !std::isfinite(seen->x) || !std::isfinite(seen->y)) return;
  if (seen->x < -half || seen->y < -half || seen->x > view_.width + half || seen->y > view_.height + half) return;
  const Spot spot{link, seen->x - half, seen->y - half, 2 * half, 2 * half, std::move(name)};
  if (link.kind == Link::Kind::handle)
    handle_spots_.push_back(spot);
  else if (link.part == 0)
    shape_spots_.push_back(spot);
  else
    point_spots_.push_back({spot, seen->z});
}

void WorkspaceBuilder::add_lines(const std::vector<std::vector<glm::dvec3>>& lines, Role role, double width) {
  for (const auto& points : lines)
    if (points.size() > 1) view_.polylines.push_back(line(points, role, width));
}

// A direction, given by any vector along it.
void WorkspaceBuilder::add_arrow(const glm::dvec3& from, const glm::dvec3& along, double length, Role role,
                                 RichText name) {
  const double size = glm::length(along);
  if (!(size > 0) || !std::isfinite(size)) return;
  const glm::dvec3 to = from + along * (length / size);
  view_.polylines.push_back(
      arrow(from, to, role, role == Role::current ? 0.6 : (role == Role::curve_result ? 0.67 : 1.25)));
  view_.labels.push_back(label_around(to, bold(std::move(name)), role, 25, false));
}

void WorkspaceBuilder::add_shape(const Thing& thing) {
  const ObjectSamples& samples = *thing.samples;
  const Link link{Link::Kind::object, static_cast<std::uint32_t>(thing.index), 0};
  if (samples.surface() != nullptr) {
    add_faces(thing);
    opaque_ = view_.meshes.size();
    const auto& mesh = samples.mesh();
    for (std::size_t i = 1; i < face_spots && !mesh.mesh.indices.empty(); ++i)
      for (std::size_t j = 1; j < face_spots; ++j) {
        const std::size_t a = i * (mesh.u.size() - 1) / face_spots, b = j * (mesh.v.size() - 1) / face_spots;
        add_spot(link, mesh.mesh.positions[a * mesh.columns() + b], face_reach, thing.object->name);
      }
    return;
  }
  if (samples.curve() == nullptr) return;
  const CurveTrack& track = samples.track();
  const double width = thing.current ? 1.55 : (thing.chosen ? 1.25 : 0.95);
  track.for_each_piece([&](std::size_t first, std::size_t end) {
    std::vector<glm::dvec3> points(track.points.begin() + static_cast<std::ptrdiff_t>(first),
                                   track.points.begin() + static_cast<std::ptrdiff_t>(end));
    if (points.size() > 1) view_.polylines.push_back(line(std::move(points), thing.role, width));
  });
  const std::size_t count = track.points.size();
  for (std::size_t i = 0; i < curve_spots && count > 0; ++i)
    add_spot(link, track.points[i * (count - 1) / (curve_spots - 1)], curve_reach, thing.object->name);
}

void WorkspaceBuilder::add_points(const Thing& thing) {
  const ObjectSamples& samples = *thing.samples;
  const auto& points = samples.points();
  const bool data = samples.curve() == nullptr && samples.surface() == nullptr;  // points and nothing else
  const Role net_role = thing.current ? Role::polygon : Role::earlier;
  if (thing.shows(Show::polygon) && !data) {
    std::vector<std::vector<glm::dvec3>> lines;
    const std::size_t columns = samples.columns() > 0 ? static_cast<std::size_t>(samples.columns()) : points.size();
    const std::size_t rows = columns > 0 ? points.size() / columns : 0;
    // A point without a place interrupts the line.
    const auto add = [&](std::size_t from, std::size_t step, std::size_t count) {
      lines.emplace_back();
      for (std::size_t i = 0; i < count; ++i) {
        if (const auto& at = points[from + i * step])
          lines.back().push_back(*at);
        else
          lines.emplace_back();
      }
    };
    for (std::size_t i = 0; i < rows; ++i) add(i * columns, 1, columns);
    if (samples.columns() > 0)
      for (std::size_t j = 0; j < columns; ++j) add(j, columns, rows);
    add_lines(lines, net_role, samples.columns() > 0 ? 0.65 : (thing.current ? 1 : 0.9));
  }
  const auto selected = [&](std::size_t i) {
    return std::ranges::find(look_.selected, PointRef{thing.index, i}) != look_.selected.end();
  };
  const bool shown = thing.shows(Show::points) || data;
  const double size = points.size() > many_points ? 0.62 : (thing.current ? 0.95 : 0.75);
  const Role role = data ? thing.role : (thing.current ? Role::control_point : Role::earlier);
  const bool names = thing.shows(Show::indices) && (thing.current || points.size() <= most_names);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i]) continue;
    const PointRef self{thing.index, i};
    const bool chosen = selected(i), hovered = look_.hovered == self;
    if (shown || chosen || hovered) {
      view_.markers.push_back(marker(*points[i], chosen ? Role::current : role, chosen ? 0.85 : size));
      if (hovered) view_.markers.push_back(marker(*points[i], Role::highlight, 0.95, Marker::Shape::ring));
      const Link link{Link::Kind::object, static_cast<std::uint32_t>(thing.index), static_cast<std::uint32_t>(i) + 1};
      add_spot(link, *points[i], point_reach, point_spot_name(*thing.object, samples, i));
    }
    if (!names && !chosen && !hovered) continue;
    // Of points in one place the first has its name there.
    const bool again = i > 0 && points[i - 1] == points[i] && !chosen && !hovered;
    if (again) continue;
    const bool loud = chosen || hovered;
    const bool crowd = points.size() > 40;
    add_label(label_around(*points[i], point_name(samples, i),
                           loud ? Role::text_strong : (thing.current ? Role::text : Role::text_quiet),
                           loud ? 40 : (thing.current ? 6 : -2), true, loud ? 0.82 : (crowd ? 0.75 : 0.92)));
  }
}

void WorkspaceBuilder::add_marks(const Thing& thing) {
  if (const auto* curve = thing.samples->curve()) add_curve_marks(thing, *curve);
  if (const auto* surface = thing.samples->surface()) add_surface_marks(thing, *surface);
}

// A curve's at three quarters of the way, a surface's at its top, that of points at the last one.
void WorkspaceBuilder::add_name(const Thing& thing) {
  const ObjectSamples& samples = *thing.samples;
  std::optional<glm::dvec3> at;
  if (samples.curve() != nullptr) {
    const auto& points = samples.track().points;
    if (!points.empty()) at = points[points.size() * 3 / 4];
  } else if (samples.surface() != nullptr && !samples.mesh().mesh.indices.empty()) {
    const Mesh& mesh = samples.mesh().mesh;
    double highest = -1e300;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 7) {
      const glm::dvec3& p = mesh.positions[mesh.indices[i]];
      const double height = glm::dot(p, lens_.axes().up);
      if (height > highest) {
        highest = height;
        at = p;
      }
    }
  } else {
    for (const auto& p : samples.points())
      if (p) at = p;
  }
  if (!at) return;
  RichText name{{thing.object->name}};
  if (thing.current) name = bold(std::move(name));
  add_label(label_around(*at, std::move(name), thing.role, thing.current ? 15 : 4, !thing.current, 0.95));
}

void WorkspaceBuilder::finish() {
  std::ranges::stable_sort(point_spots_, {}, [](const PointSpot& spot) { return spot.z; });
  for (Spot& spot : shape_spots_) sheet_.spots.push_back(std::move(spot));
  for (PointSpot& spot : point_spots_) sheet_.spots.push_back(std::move(spot.spot));
  for (Spot& spot : handle_spots_) sheet_.spots.push_back(std::move(spot));
}

}  // namespace blossom
