// What is drawn of a curve besides itself. Where something does not exist (a frame at a cusp, the circle of a straight
// piece) its mark is left out.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "kernel/evaluate.hpp"
#include "scene/hull_shape.hpp"
#include "scene/panel_parts.hpp"
#include "scene/workspace_builder.hpp"

namespace blossom {
namespace {

constexpr int circle_steps = 128;
constexpr double largest_circle = 25;  // of the scene's size: what is larger looks straight
constexpr double largest_veil = 1.5;   // a sphere of this many sizes is drawn as circles only
constexpr double comb_share = 0.16;    // of the scene's size: how long a tooth is that 95 in 100 do not exceed
constexpr double longest_tooth = 4;    // of that
constexpr int named_degree = 5;        // nets of higher degrees have no names

using Level = TextRun::Level;

// P_{k-p}..P_k.
std::span<const HPoint<double>> in_force(const Curve<double>& curve, int k) {
  return std::span(curve.points)
      .subspan(static_cast<std::size_t>(k - curve.degree), static_cast<std::size_t>(curve.degree) + 1);
}

std::vector<glm::dvec3> circle_around(const glm::dvec3& centre, const glm::dvec3& x, const glm::dvec3& y) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < circle_steps; ++i) {
    const double angle = 2 * std::numbers::pi * i / circle_steps;
    points.push_back(centre + std::cos(angle) * x + std::sin(angle) * y);
  }
  return points;
}

Mesh sphere_around(const glm::dvec3& centre, double radius, Role role) {
  constexpr int rings = 40, sectors = 80;
  Mesh mesh;
  mesh.role = role;
  mesh.opacity = 0.2;
  for (int i = 0; i <= rings; ++i)
    for (int j = 0; j <= sectors; ++j) {
      const double a = std::numbers::pi * i / rings, b = 2 * std::numbers::pi * j / sectors;
      const glm::dvec3 normal{std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
      mesh.positions.push_back(centre + radius * normal);
      mesh.normals.push_back(normal);
    }
  const auto at = [](int i, int j) { return static_cast<std::uint32_t>(i * (sectors + 1) + j); };
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < sectors; ++j)
      mesh.indices.insert(mesh.indices.end(),
                          {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)});
  return mesh;
}

// 1, 2 or 5 times a power of ten, not above.
double nice_below(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= value) return factor * power;
  return power;
}

// The value that 95 in 100 do not exceed, of values that are not negative; 0 of none.
double robust_most(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 95 / 100);
  std::ranges::nth_element(values, place);
  return *place;
}

// C' as a curve: its control points are p (P_{i+1} - P_i) / (u_{i+p+1} - u_{i+1}). Nothing for a rational curve, and
// where it jumps.
std::optional<Curve<double>> derivative_curve(const Curve<double>& curve) {
  const int p = curve.degree;
  if (curve.rational || p < 2) return std::nullopt;
  Curve<double> made;
  made.degree = p - 1;
  made.dimension = curve.dimension;
  made.knots.assign(curve.knots.begin() + 1, curve.knots.end() - 1);
  for (int i = 0; i < curve.n(); ++i) {
    const auto a = static_cast<std::size_t>(i), b = a + static_cast<std::size_t>(p);
    const double length = curve.knots[b + 1] - curve.knots[a + 1];
    if (!(length > 0)) return std::nullopt;
    HPoint<double> Q = (curve.points[a + 1] - curve.points[a]) * (p / length);
    Q.w = 1;
    made.points.push_back(Q);
  }
  return made;
}

}  // namespace

NetLevels de_boor_levels(const std::vector<double>& knots, int degree, std::span<const HPoint<double>> points, int k,
                         double u) {
  NetLevels net{k - degree, {{points.begin(), points.end()}}};
  for (int r = 1; r <= degree; ++r) {
    const auto& before = net.levels.back();
    std::vector<HPoint<double>> level;
    for (int i = k - degree + r; i <= k; ++i) {
      const auto low = static_cast<std::size_t>(i), high = static_cast<std::size_t>(i + degree - r + 1);
      const double alpha = (u - knots[low]) / (knots[high] - knots[low]);  // the span k lies between them
      const auto j = static_cast<std::size_t>(i - (k - degree + r));
      level.push_back(before[j] * (1 - alpha) + before[j + 1] * alpha);
    }
    net.levels.push_back(std::move(level));
  }
  return net;
}

void WorkspaceBuilder::add_curve_marks(const Thing& thing, const Curve<double>& curve) {
  if (thing.shows(Show::comb)) add_comb(thing);
  if (thing.shows(Show::projection)) add_projection(thing, curve);
  if (thing.shows(Show::hodograph)) add_hodograph(thing, curve);
  if (thing.shows(Show::knots)) {
    for (const auto& at : thing.samples->knots())
      view_.markers.push_back(marker(at, thing.role, thing.current ? 0.85 : 0.7, Marker::Shape::square));
  }
  if (thing.shows(Show::hull)) {
    const auto points = in_force(curve, find_span<double>(curve.knots, curve.degree, thing.u));
    std::vector<Point<double>> corners;
    for (const auto& P : points)
      if (const auto at = affine_point(P); at && P.w > 0) corners.push_back(*at);
    if (corners.size() == points.size()) add_hull(view_, corners);  // the property is one of positive weights
  }
  if (thing.shows(Show::net)) add_net(thing, curve);
  if (thing.shows(Show::circle)) add_circle(curve, thing.u, false);
  if (thing.shows(Show::sphere)) add_circle(curve, thing.u, true);
  if (thing.shows(Show::triad)) add_triad(thing, curve);
  const bool moving = thing.shows(Show::triad) || thing.shows(Show::circle) || thing.shows(Show::sphere);
  if (!thing.shows(Show::point) && !thing.shows(Show::net) && !moving) return;
  const auto at = point(curve, thing.u);
  if (!at) return;
  RichText name = italic("C");
  name.push_back({"(" + parts::significant(thing.u) + ")"});
  add_traced_point(plain(*at), thing.shows(Show::point) ? name : RichText{}, thing.current);
}

void WorkspaceBuilder::add_traced_point(const glm::dvec3& at, RichText name, bool loud) {
  view_.markers.push_back(marker(at, Role::result, loud ? 1 : 0.8));
  if (!name.empty()) view_.labels.push_back(label_around(at, std::move(name), Role::result, loud ? 30 : 8, !loud));
}

void WorkspaceBuilder::add_net(const Thing& thing, const Curve<double>& curve) {
  static constexpr Role roles[] = {Role::level_a, Role::level_b, Role::level_c};
  const int k = find_span<double>(curve.knots, curve.degree, thing.u);
  const NetLevels net = de_boor_levels(curve.knots, curve.degree, in_force(curve, k), k, thing.u);
  for (int r = 1; r < curve.degree; ++r) {
    const Role role = roles[(r - 1) % 3];
    std::vector<std::vector<glm::dvec3>> lines(1);
    const auto& level = net.levels[static_cast<std::size_t>(r)];
    for (std::size_t j = 0; j < level.size(); ++j) {
      const auto at = plain_place(level[j]);
      if (!at) {
        lines.emplace_back();
        continue;
      }
      lines.back().push_back(*at);
      view_.markers.push_back(marker(*at, role, 0.85));
      if (thing.current && curve.degree <= named_degree)
        view_.labels.push_back(
            label_around(*at, level_name(r, {net.first + r + static_cast<int>(j)}), role, 3, true, 0.85));
    }
    add_lines(lines, role, 1);
  }
}

void WorkspaceBuilder::add_triad(const Thing& thing, const Curve<double>& curve) {
  const auto here = frame(curve, thing.u);
  if (!here) return;
  const glm::dvec3 at = plain(here->point);
  add_arrow(at, plain(here->tangent), mark_, Role::current, italic("T"));
  if (!thing.shows(Show::transport)) {
    if (here->normal) add_arrow(at, plain(*here->normal), mark_, Role::curve_result, italic("N"));
    // Toward the viewer it is a point.
    if (here->binormal && !flat()) add_arrow(at, plain(*here->binormal), mark_, Role::level_a, italic("B"));
    return;
  }
  const auto moved = moving_frame_at(*thing.samples, thing.u);
  if (!moved) return;
  add_arrow(at, plain(moved->normal), mark_, Role::curve_result, italic("R"));
  if (!flat()) add_arrow(at, plain(moved->binormal), mark_, Role::level_a, italic("S"));
}

// The circle of curvature, or the sphere.
void WorkspaceBuilder::add_circle(const Curve<double>& curve, double u, bool sphere) {
  const auto here = frame(curve, u);
  if (!here) return;
  glm::dvec3 centre;
  double radius = 0;
  if (sphere) {
    const auto found = osculating_sphere(curve, u);
    if (!found) return;
    centre = plain(found->centre);
    radius = found->radius;
  } else {
    const auto found = osculating_circle(*here);
    if (!found) return;
    centre = plain(found->centre);
    radius = found->radius;
  }
  const double size = std::max(bounds_.diagonal(), 1e-9);
  if (!(radius < largest_circle * size)) return;
  const glm::dvec3 at = plain(here->point);
  const Role role = sphere ? Role::level_b : Role::ratio_near;
  if (sphere) {
    // A veil would lie over everything for one who stands inside, or nearly.
    const glm::dvec3 eye = lens_.camera().centre + lens_.eye() * lens_.axes().toward;
    const bool inside = lens_.perspective() && glm::length(eye - centre) < 1.3 * radius;
    if (!inside && radius < largest_veil * size) view_.meshes.push_back(sphere_around(centre, radius, role));
    const glm::dvec3 x = glm::normalize(at - centre), T = plain(here->tangent);
    const std::array<glm::dvec3, 3> axes{x, T, glm::normalize(glm::cross(x, T))};
    for (std::size_t i = 0; i < 3; ++i) {
      Polyline rim = line(circle_around(centre, radius * axes[i], radius * axes[(i + 1) % 3]), role, 0.5);
      rim.closed = true;
      view_.polylines.push_back(std::move(rim));
    }
  } else {
    Polyline rim = line(circle_around(centre, radius * plain(here->tangent), radius * plain(*here->normal)), role, 0.4);
    rim.closed = true;
    view_.polylines.push_back(std::move(rim));
  }
  view_.polylines.push_back(line({at, centre}, role, sphere ? 0.7 : 0.25));
  view_.markers.push_back(marker(centre, role, 1, sphere ? Marker::Shape::square : Marker::Shape::disc));
  // Beside the radius: ρ is the reciprocal of the curvature, as books have it.
  RichText words{{sphere ? "R" : "ρ", Level::base, true}, {" = " + parts::significant(radius)}};
  view_.labels.push_back(label_around((at + centre) * 0.5, std::move(words), role, 12, true, 0.9));
}

// Teeth as long as the curvature, away from the centre of curvature.
void WorkspaceBuilder::add_comb(const Thing& thing) {
  const CurveFrames& all = thing.samples->frames();
  std::vector<double> sizes;
  for (const auto& f : all.frames)
    if (f && f->curvature && *f->curvature > 0) sizes.push_back(*f->curvature);
  const double usual = robust_most(sizes);
  if (!(usual > 0)) return;
  const double scale = comb_share * thing.samples->shape_bounds().diagonal() / usual * look_.comb_scale;
  const double longest = longest_tooth * usual;
  std::vector<std::vector<glm::dvec3>> tips(1);
  const std::size_t each = std::max<std::size_t>(1, all.u.size() / 160);
  for (std::size_t i = 0; i < all.frames.size(); ++i) {
    const auto& f = all.frames[i];
    if (!f || !f->curvature) {
      tips.emplace_back();
      continue;
    }
    const glm::dvec3 at = plain(f->point);
    const glm::dvec3 tip = f->normal ? at - plain(*f->normal) * (std::min(*f->curvature, longest) * scale) : at;
    // Where the curve bends the other way the comb changes sides, and passes through the curve.
    if (!tips.back().empty() && i > 0 && f->normal && all.frames[i - 1] && all.frames[i - 1]->normal &&
        glm::dot(*f->normal, *all.frames[i - 1]->normal) < 0) {
      tips.back().push_back(at);
    }
    tips.back().push_back(tip);
    if (i % each == 0 && tip != at) view_.polylines.push_back(line({at, tip}, Role::result, 0.2));
  }
  add_lines(tips, Role::result, 0.38);
}

Hodograph hodograph_of(const ObjectSamples& samples) {
  Hodograph made;
  const auto* curve = samples.curve();
  if (curve == nullptr) return made;
  const CurveFrames& all = samples.frames();
  double longest = 0;
  for (const auto& f : all.frames)
    if (f) longest = std::max(longest, f->speed);
  const double size = std::max(samples.shape_bounds().diagonal(), 1e-9);
  if (!(longest > 0) || !std::isfinite(longest)) return made;
  made.factor = longest <= 1.2 * size ? 1 : nice_below(0.8 * size / longest);
  if (const auto derivative = derivative_curve(*curve)) {
    const CurveTrack track = track_of(*derivative);
    track.for_each_piece([&](std::size_t first, std::size_t end) {
      auto& points = made.lines.emplace_back();
      for (std::size_t i = first; i < end; ++i) points.push_back(track.points[i] * made.factor);
    });
    for (const auto& Q : derivative->points) made.polygon.push_back(glm::dvec3(Q.x, Q.y, Q.z) * made.factor);
    return made;
  }
  made.lines.emplace_back();
  for (const auto& f : all.frames) {
    if (f)
      made.lines.back().push_back(plain(f->tangent) * (f->speed * made.factor));
    else
      made.lines.emplace_back();
  }
  return made;
}

void WorkspaceBuilder::add_hodograph(const Thing& thing, const Curve<double>& curve) {
  const Hodograph hodograph = hodograph_of(*thing.samples);
  if (hodograph.lines.empty()) return;
  for (const auto& at : hodograph.polygon) view_.markers.push_back(marker(at, Role::earlier, 0.7));
  if (hodograph.polygon.size() > 1) view_.polylines.push_back(line(hodograph.polygon, Role::earlier));
  add_lines(hodograph.lines, Role::level_b, 1.1);
  view_.markers.push_back(marker({0, 0, 0}, Role::level_b, 0.8, Marker::Shape::cross));
  const auto here = frame(curve, thing.u);
  if (!here) return;
  const glm::dvec3 tip = plain(here->tangent) * (here->speed * hodograph.factor);
  view_.polylines.push_back(arrow({0, 0, 0}, tip, Role::level_b, 0.8));
  RichText name{{"C′", Level::base, true}, {"(" + parts::significant(thing.u) + ")"}};
  if (hodograph.factor != 1) name.push_back({" × " + parts::significant(hodograph.factor, 2)});
  view_.labels.push_back(label_around(tip, std::move(name), Role::level_b, 14, !thing.current, 0.9));
}

std::optional<Lifted> lifted(const ObjectSamples& samples) {
  const auto* curve = samples.curve();
  if (curve == nullptr || curve->dimension != 2) return std::nullopt;
  double heaviest = 1;
  for (const auto& P : curve->points) heaviest = std::max(heaviest, std::abs(P.w));
  Lifted made{std::max(0.6 * samples.shape_bounds().diagonal(), 1e-9) / std::max(heaviest - 1, 1.0), *curve};
  made.spline.dimension = 3;
  made.spline.rational = false;  // one dimension up there are no weights
  for (auto& P : made.spline.points) {
    const glm::dvec3 at = made.place(P);
    P = {at.x, at.y, at.z, 1};
  }
  return made;
}

void WorkspaceBuilder::add_projection(const Thing& thing, const Curve<double>& curve) {
  const auto above = lifted(*thing.samples);
  if (!above) return;
  const glm::dvec3 origin = above->origin();
  std::vector<glm::dvec3> polygon;
  for (const auto& P : above->spline.points) {
    polygon.push_back({P.x, P.y, P.z});
    view_.markers.push_back(marker(polygon.back(), Role::level_b, 0.9));
  }
  view_.polylines.push_back(line(polygon, Role::level_b, 0.6));
  const CurveTrack track = track_of(above->spline);
  track.for_each_piece([&](std::size_t first, std::size_t end) {
    view_.polylines.push_back(line({track.points.begin() + static_cast<std::ptrdiff_t>(first),
                                    track.points.begin() + static_cast<std::ptrdiff_t>(end)},
                                   Role::curve, 1.1));
  });
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    // To whichever is farther from the origin.
    const auto below = plain_place(curve.points[i]);
    const glm::dvec3 end = below && curve.points[i].w < 1 ? *below : polygon[i];
    view_.polylines.push_back(line({origin, end}, Role::earlier, 0.8));
    RichText name{{"P", Level::base, true}, {std::to_string(i), Level::sub}, {"w", Level::super, true}};
    const bool apart = !below || glm::length(*below - polygon[i]) > 1e-9 * above->height;
    if (thing.current && apart)
      view_.labels.push_back(label_around(polygon[i], std::move(name), Role::level_b, 5, true, 0.9));
  }
  view_.markers.push_back(marker(origin, Role::text, 1));
  view_.labels.push_back(label_around(origin, {{"O", Level::base, true}, {" (w = 0)"}}, Role::text, 10, true, 0.9));
  // The ray to the point at u.
  const int k = find_span<double>(curve.knots, curve.degree, thing.u);
  const NetLevels net = de_boor_levels(curve.knots, curve.degree, in_force(curve, k), k, thing.u);
  const HPoint<double> C = net.levels.back()[0];
  const glm::dvec3 up = above->place(C);
  const auto down = plain_place(C);
  view_.polylines.push_back(line({origin, down && C.w < 1 ? *down : up}, Role::result, 0.45));
  view_.markers.push_back(marker(up, Role::result, 0.8));
  if (down) view_.markers.push_back(marker(*down, Role::result, 0.8));
  RichText name{{"C", Level::base, true}, {"w", Level::super, true}, {"(" + parts::significant(thing.u) + ")"}};
  view_.labels.push_back(label_around(up, std::move(name), Role::result, 20, true));
  // The plane w = 1.
  Bounds plane;
  for (const auto& at : thing.samples->track().points) plane.add(at);
  if (plane.empty()) return;
  const double pad = 0.15 * plane.diagonal();
  const glm::dvec3 low = plane.low - pad, high = plane.high + pad;
  Polyline rim =
      line({{low.x, low.y, 0}, {high.x, low.y, 0}, {high.x, high.y, 0}, {low.x, high.y, 0}}, Role::axis, 0.8);
  rim.closed = true;
  view_.polylines.push_back(std::move(rim));
  view_.labels.push_back(label_around({high.x, low.y, 0}, {{"w", Level::base, true}, {" = 1"}}, Role::text_quiet, 2));
}

}  // namespace blossom
