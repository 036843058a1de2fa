// What is drawn of a surface: its faces and lines, and what there is at (u, v).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/evaluate.hpp"
#include "kernel/light_lines.hpp"
#include "kernel/surface_shape.hpp"
#include "scene/color_bands.hpp"
#include "scene/hull_shape.hpp"
#include "scene/panel_parts.hpp"
#include "scene/workspace_builder.hpp"

namespace blossom {
namespace {

constexpr Role levels[] = {Role::level_a, Role::level_b, Role::level_c};
constexpr double stripes_around = 36;
constexpr double longest_direction = 0.16;  // of the scene's size: of a principal direction

// The number of the stripe, of lamps all around the surface that go along y, as the viewer sees them in it.
std::vector<double> reflection_stripes(const ObjectSamples& samples, const Lens& lens) {
  const Bounds& bounds = samples.shape_bounds();
  const SurfaceGrid& grid = samples.mesh().grid;
  const auto vector = [](const glm::dvec3& v) { return Point<double>(v.x, v.y, v.z); };
  const glm::dvec3 toward = lens.axes().toward;
  const Eye eye{vector(lens.perspective() ? lens.camera().centre + lens.eye() * toward : toward), !lens.perspective()};
  VertexValues angles;
  reflection_lines(grid.points, grid.normals, eye, lines_above(vector(bounds.low), vector(bounds.high)), true, angles);
  // A whole number of pairs goes around: the jump at straight down is not seen.
  for (double& angle : angles.values) angle *= stripes_around / (2 * std::numbers::pi);
  for (const int i : angles.undefined) angles.values[static_cast<std::size_t>(i)] = std::nan("");
  return std::move(angles.values);
}

}  // namespace

bool has_range(SurfaceMap map) {
  return map != SurfaceMap::none && map != SurfaceMap::isophotes && map != SurfaceMap::reflection;
}

void WorkspaceBuilder::add_faces(const Thing& thing) {
  const SurfaceTrack& track = thing.samples->mesh();
  if (track.mesh.indices.empty()) return;
  const SurfaceMap map = thing.shows(Show::faces) ? thing.object->map : SurfaceMap::none;
  if (thing.shows(Show::faces)) {
    Mesh mesh = track.mesh;
    mesh.role = thing.role;
    if (has_range(map)) {
      const SurfaceNumbers& numbers = thing.samples->numbers(map);
      const double range = look_.map_range > 0 ? look_.map_range : numbers.range;
      mesh.map = ColorMap::diverging;
      mesh.values.reserve(numbers.values.size());
      for (const double value : numbers.values) {
        const double share = range > 0 && std::isfinite(value) ? std::clamp(value / range, -1.0, 1.0) : 0;
        mesh.values.push_back(static_cast<float>(0.5 + 0.5 * share));
      }
    } else if (map != SurfaceMap::none) {
      mesh = banded(mesh, map == SurfaceMap::reflection ? reflection_stripes(*thing.samples, lens_)
                                                        : thing.samples->numbers(map).values);
    }
    view_.meshes.push_back(std::move(mesh));
  }
  const auto add = [&](const auto& lines, Role role, double width) {
    for (int direction = 0; direction < 2; ++direction)
      for (const std::size_t at : lines[static_cast<std::size_t>(direction)])
        add_lines(track.line(direction, at), role, width);
  };
  // On the colours of a map, lines of the thing's own colour would be read as numbers.
  const Role role = map == SurfaceMap::none ? thing.role : Role::text_quiet;
  const double loud = map == SurfaceMap::none ? 1 : 1.4;
  const std::array<std::vector<std::size_t>, 2> rim{{{0, track.u.size() - 1}, {0, track.v.size() - 1}}};
  if (thing.shows(Show::isolines)) add(track.isolines, role, (thing.current ? 0.36 : 0.28) * loud);
  if (thing.shows(Show::knots)) add(track.knot_lines, role, (thing.current ? 0.85 : 0.7) * loud);
  add(rim, role, (thing.current ? 0.75 : 0.45) * loud);
}

void WorkspaceBuilder::add_surface_marks(const Thing& thing, const Surface<double>& surface) {
  const double u = thing.u, v = thing.v;
  if (thing.shows(Show::point)) add_lines_through(surface, u, v);
  if (thing.shows(Show::hull)) {
    const auto [p, q] = surface.degree;
    const int k = find_span<double>(surface.knots[0], p, u), l = find_span<double>(surface.knots[1], q, v);
    std::vector<Point<double>> corners;
    bool positive = true;
    for (int i = k - p; i <= k; ++i)
      for (int j = l - q; j <= l; ++j) {
        const auto at = affine_point(surface.at(i, j));
        positive = positive && at && surface.at(i, j).w > 0;
        if (at) corners.push_back(*at);
      }
    if (positive) add_hull(view_, corners);
  }
  if (thing.shows(Show::net)) add_surface_net(surface, u, v);
  if (thing.shows(Show::principal)) add_principal(surface, u, v);
  if (thing.shows(Show::triad)) add_tangents(surface, u, v);
  const bool marks = thing.shows(Show::net) || thing.shows(Show::principal) || thing.shows(Show::triad);
  if (!thing.shows(Show::point) && !marks) return;
  const auto at = point(surface, u, v);
  if (!at) return;
  RichText name = italic("S");
  name.push_back({"(" + parts::significant(u) + ", " + parts::significant(v) + ")"});
  add_traced_point(plain(*at), thing.shows(Show::point) ? name : RichText{}, thing.current);
}

// The isoparametric curves through S(u, v).
void WorkspaceBuilder::add_lines_through(const Surface<double>& surface, double u, double v) {
  constexpr int steps = 160;
  for (std::size_t d = 0; d < 2; ++d) {
    const auto& knots = surface.knots[d];
    const auto p = static_cast<std::size_t>(surface.degree[d]);
    const double begin = knots[p], end = knots[knots.size() - 1 - p];
    std::vector<std::vector<glm::dvec3>> lines(1);
    for (int i = 0; i <= steps; ++i) {
      const double at = i == steps ? end : begin + (end - begin) * i / steps;
      if (const auto S = d == 0 ? point(surface, at, v) : point(surface, u, at))
        lines.back().push_back(plain(*S));
      else
        lines.emplace_back();
    }
    add_lines(lines, Role::result, 0.4);
  }
}

// First every row in force at v: its points R_i; then these at u. The rows' own levels are quiet.
void WorkspaceBuilder::add_surface_net(const Surface<double>& surface, double u, double v) {
  const auto [p, q] = surface.degree;
  const int k = find_span<double>(surface.knots[0], p, u), l = find_span<double>(surface.knots[1], q, v);
  const auto draw = [&](const std::vector<HPoint<double>>& points, Role role, double width, double size) {
    std::vector<std::vector<glm::dvec3>> lines(1);
    for (const auto& P : points) {
      if (const auto at = plain_place(P)) {
        lines.back().push_back(*at);
        if (size > 0) view_.markers.push_back(marker(*at, role, size));
      } else {
        lines.emplace_back();
      }
    }
    add_lines(lines, role, width);
  };
  std::vector<HPoint<double>> R;
  for (int i = k - p; i <= k; ++i) {
    std::vector<HPoint<double>> row;
    for (int j = l - q; j <= l; ++j) row.push_back(surface.at(i, j));
    const NetLevels net = de_boor_levels(surface.knots[1], q, row, l, v);
    draw(row, Role::operand, 0.5, 0);
    for (int r = 1; r < q; ++r) draw(net.levels[static_cast<std::size_t>(r)], Role::level_a, 0.6, 0.55);
    R.push_back(net.levels.back()[0]);
    if (const auto at = plain_place(R.back()); at && q <= 5)
      add_label(label_around(*at, {{"R", TextRun::Level::base, true}, {std::to_string(i), TextRun::Level::sub}},
                             Role::level_b, 9, true, 0.9));
  }
  draw(R, Role::level_b, 1.3, 1.1);
  const NetLevels across = de_boor_levels(surface.knots[0], p, R, k, u);
  for (int r = 1; r < p; ++r) draw(across.levels[static_cast<std::size_t>(r)], levels[2], 1.3, 0.9);
}

void WorkspaceBuilder::add_tangents(const Surface<double>& surface, double u, double v) {
  const auto at = point(surface, u, v);
  if (!at) return;
  std::array<Point<double>, 4> D;
  const auto name = [](const char* letter, const char* sub) {
    return RichText{{letter, TextRun::Level::base, true}, {sub, TextRun::Level::sub, true}};
  };
  if (derivatives(surface, u, v, 1, D)) {
    add_arrow(plain(*at), plain(D[2]), mark_, Role::current, name("S", "u"));
    add_arrow(plain(*at), plain(D[1]), mark_, Role::level_a, name("S", "v"));
  }
  if (const auto normal = unit_normal(surface, u, v))
    add_arrow(plain(*at), plain(*normal), mark_, Role::curve_result, italic("N"));
}

// The directions in which it bends most and least, each as far to both sides as the radius of curvature reaches.
void WorkspaceBuilder::add_principal(const Surface<double>& surface, double u, double v) {
  const auto shape = surface_shape(surface, u, v);
  if (!shape) return;
  const glm::dvec3 at = plain(shape->point);
  const double most = longest_direction * bounds_.diagonal();
  const auto add = [&](const Point<double>& direction, double k, Role role, const char* index) {
    const double radius = k != 0 ? 1 / std::abs(k) : most;
    const glm::dvec3 along = plain(direction) * std::min(radius, most);
    view_.polylines.push_back(line({at - along, at + along}, role, role == Role::current ? 0.7 : 1.4, false));
    RichText name{{"k", TextRun::Level::base, true}, {index, TextRun::Level::sub}, {" = " + parts::significant(k)}};
    add_label(label_around(at + along, std::move(name), role, 18, true, 0.9));
  };
  add(shape->maximum_direction, shape->curvatures.maximum, Role::current, "1");
  add(shape->minimum_direction, shape->curvatures.minimum, Role::level_a, "2");
}

}  // namespace blossom
