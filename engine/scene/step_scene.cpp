#include "scene/step_scene.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "kernel/evaluate.hpp"
#include "kernel/tessellate.hpp"
#include "scene/panels.hpp"
#include "scene/typeset.hpp"

namespace blossom {
namespace {

constexpr int samples_per_span = 32;
constexpr int mesh_per_span = 12;
constexpr std::size_t most_labels = 80;  // beyond that only what the step is about is named

struct Bounds {
  glm::dvec3 low{1e300}, high{-1e300};
  void add(const glm::dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
};

glm::dvec3 plain(const Point<double>& p) { return {p.x, p.y, p.z}; }

Polyline line(std::vector<glm::dvec3> points, Role role, double width = 1, bool dashed = false) {
  Polyline made;
  made.points = std::move(points);
  made.role = role;
  made.width_scale = width;
  made.dashed = dashed;
  return made;
}

Marker marker(const glm::dvec3& at, Role role, double size = 1, Marker::Shape shape = Marker::Shape::disc) {
  return {at, role, shape, size};
}

// 1, 2 or 5 times a power of ten: about `count` lines over `length`.
double nice_step(double length, double count) {
  const double raw = length / count;
  const double power = std::pow(10, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (raw <= factor * power) return factor * power;
  return 10 * power;
}

Role level_role(int level) {
  static constexpr Role roles[] = {Role::level_a, Role::level_b, Role::level_c};
  return roles[static_cast<std::size_t>(std::max(level - 1, 0)) % 3];
}

}  // namespace

struct StepScenes::Samples {
  std::vector<std::vector<glm::dvec3>> curves;  // connected pieces of the input curves
  std::vector<glm::dvec3> knots;                // points of the input curves at their inner knots
  std::vector<std::vector<glm::dvec3>> result;  // of a resulting curve
  Mesh mesh;                                    // of a resulting surface
  std::vector<std::vector<glm::dvec3>> isolines;
  Bounds bounds;
  std::vector<glm::dvec3> extent;  // everything that must fit into the view

  void add(const glm::dvec3& at) {
    bounds.add(at);
    extent.push_back(at);
  }

  void add_curve(const Curve<double>& curve, std::vector<std::vector<glm::dvec3>>& pieces) {
    CurveSamples samples;
    sample_curve(curve, samples_per_span, samples);
    for (std::size_t piece = 0; piece < samples.pieces.size(); ++piece) {
      const std::size_t end = piece + 1 < samples.pieces.size() ? samples.pieces[piece + 1] : samples.points.size();
      pieces.emplace_back();
      for (std::size_t i = samples.pieces[piece]; i < end; ++i) {
        pieces.back().push_back(plain(samples.points[i]));
        add(pieces.back().back());
      }
    }
  }

  void add_surface(const Surface<double>& surface) {
    std::vector<double> u, v;
    span_parameters(surface.knots[0], surface.degree[0], mesh_per_span, u);
    span_parameters(surface.knots[1], surface.degree[1], mesh_per_span, v);
    SurfaceGrid grid;
    evaluate_grid(surface, u, v, true, grid);
    if (!grid.undefined.empty()) return;  // a pole of the denominator: there is no surface to show there
    for (std::size_t i = 0; i < grid.points.size(); ++i) {
      mesh.positions.push_back(plain(grid.points[i]));
      mesh.normals.push_back(plain(grid.normals[i]));
      add(mesh.positions.back());
    }
    const auto at = [&](int a, int b) { return static_cast<std::uint32_t>(a * grid.columns + b); };
    for (int a = 0; a + 1 < grid.rows; ++a)
      for (int b = 0; b + 1 < grid.columns; ++b)
        mesh.indices.insert(mesh.indices.end(),
                            {at(a, b), at(a + 1, b), at(a + 1, b + 1), at(a, b), at(a + 1, b + 1), at(a, b + 1)});
    mesh.role = Role::surface;
    for (int a = 0; a < grid.rows; a += mesh_per_span / 2) {
      isolines.emplace_back();
      for (int b = 0; b < grid.columns; ++b) isolines.back().push_back(mesh.positions[at(a, b)]);
    }
    for (int b = 0; b < grid.columns; b += mesh_per_span / 2) {
      isolines.emplace_back();
      for (int a = 0; a < grid.rows; ++a) isolines.back().push_back(mesh.positions[at(a, b)]);
    }
  }
};

StepScenes::StepScenes(const StepSource& source) : source_(&source), samples_(std::make_unique<Samples>()) {
  for (const auto& curve : source.curves) {
    samples_->add_curve(curve, samples_->curves);
    for (int i = curve.degree + 1; i <= curve.n(); ++i) {
      const double u = curve.knots[static_cast<std::size_t>(i)];
      if (u > curve.domain_begin() && u < curve.domain_end() && u != curve.knots[static_cast<std::size_t>(i) - 1])
        if (const auto at = point(curve, u)) samples_->knots.push_back(plain(*at));
    }
  }
  if (const auto* curve = std::get_if<Curve<double>>(&source.outcome)) samples_->add_curve(*curve, samples_->result);
  if (const auto* surface = std::get_if<Surface<double>>(&source.outcome)) samples_->add_surface(*surface);
  for (const auto& at : source.points)
    if (at) samples_->add(*at);
  if (samples_->extent.empty()) samples_->add({0, 0, 0});
}

StepScenes::~StepScenes() = default;

namespace {

// The camera that shows the bounds in a view of this aspect, with a margin for labels.
Camera camera_for(const Bounds& bounds, const std::vector<glm::dvec3>& extent, bool spatial, double width,
                  double height) {
  Camera camera;
  const double margin = 1.18;
  camera.centre = (bounds.low + bounds.high) * 0.5;
  const glm::dvec3 size = bounds.high - bounds.low;
  if (!spatial) {
    camera.kind = Camera::Kind::plane;
    camera.height = std::max({size.y, size.x * height / width, 1e-9}) * margin;
    return camera;
  }
  camera.kind = Camera::Kind::orbit;
  camera.azimuth = -1.0;
  camera.elevation = 0.42;
  const double ca = std::cos(camera.azimuth), sa = std::sin(camera.azimuth);
  const double ce = std::cos(camera.elevation), se = std::sin(camera.elevation);
  const glm::dvec3 right{-sa, ca, 0};
  const glm::dvec3 up{-se * ca, -se * sa, ce};
  glm::dvec2 low{1e300}, high{-1e300};
  for (const auto& at : extent) {
    const glm::dvec2 seen{glm::dot(at - camera.centre, right), glm::dot(at - camera.centre, up)};
    low = glm::min(low, seen);
    high = glm::max(high, seen);
  }
  camera.centre += 0.5 * (low.x + high.x) * right + 0.5 * (low.y + high.y) * up;
  camera.height = std::max({high.y - low.y, (high.x - low.x) * height / width, 1e-9}) * margin;
  return camera;
}

void add_grid(View& view, double width, double height) {
  const Camera& camera = view.camera;
  const double half_h = camera.height / 2;
  const double half_w = half_h * width / height;
  const double step = nice_step(2 * half_w, 10);
  const double unit = camera.height / height;  // of the page, in the world
  const auto tick = [&](double value, bool horizontal) {
    Label label;
    const double edge = 0.02 * camera.height;
    label.anchor = horizontal ? glm::dvec3{camera.centre.x - half_w + 0.6 * edge, value + 0.3 * edge, 0}
                              : glm::dvec3{value + 0.3 * edge, camera.centre.y - half_h + 0.6 * edge, 0};
    label.text = {{format_short(std::abs(value) < step / 2 ? 0 : value, 6)}};
    label.role = Role::text_quiet;
    label.size_scale = 0.66;
    label.optional = true;
    label.priority = -10;
    view.labels.push_back(label);
  };
  for (double x = std::ceil((camera.centre.x - half_w) / step) * step; x <= camera.centre.x + half_w; x += step) {
    const bool axis = std::abs(x) < step / 2;
    view.polylines.push_back(
        line({{x, camera.centre.y - half_h, 0}, {x, camera.centre.y + half_h, 0}}, axis ? Role::axis : Role::grid));
    if (x + 36 * unit < camera.centre.x + half_w) tick(x, false);
  }
  for (double y = std::ceil((camera.centre.y - half_h) / step) * step; y <= camera.centre.y + half_h; y += step) {
    const bool axis = std::abs(y) < step / 2;
    view.polylines.push_back(
        line({{camera.centre.x - half_w, y, 0}, {camera.centre.x + half_w, y, 0}}, axis ? Role::axis : Role::grid));
    if (y + 16 * unit < camera.centre.y + half_h) tick(y, true);
  }
}

// The share of the far part of a divided segment, in the manner of the share of the near one: 3/5 beside 2/5.
std::string other_share(const std::string& share, double value) {
  if (share.find('/') != std::string::npos)
    if (const auto exact = Exact::parse(share)) return (Exact(1) - *exact).to_string();
  return format_short(1 - value, 4);
}

// What the current step does to two points: A and B are divided at M, as the share a says.
void add_division(View& view, const glm::dvec3& A, const glm::dvec3& B, const glm::dvec3& M, double a,
                  const std::string& share, bool swapped) {
  const auto label = [&](const glm::dvec3& from, const glm::dvec3& to, const std::string& words) {
    Label made;
    made.anchor = (from + to) * 0.5;
    made.text = {{words}};
    made.role = Role::text_current;
    made.size_scale = 0.85;
    made.placement = Label::Placement::around;
    made.optional = true;
    made.priority = 20;
    view.labels.push_back(made);
  };
  if (a >= 0 && a <= 1) {
    view.polylines.push_back(line({A, M}, Role::ratio_near));
    view.polylines.push_back(line({M, B}, Role::ratio_far));
    if (share.size() <= 12) {
      const std::string other = other_share(share, a);
      if (a > 0) label(A, M, swapped ? other : share);
      if (a < 1) label(M, B, swapped ? share : other);
    }
    return;
  }
  // Extrapolation: M lies on the line beyond one of them.
  view.polylines.push_back(line({A, B}, Role::ratio_near));
  view.polylines.push_back(line({a > 1 ? B : A, M}, Role::ratio_far, 1, true));
}

}  // namespace

View StepScenes::viewport(std::uint32_t step, double width, double height) const {
  const StepSource& source = *source_;
  const TraceGraph& graph = *source.graph;
  const bool last = step + 1 == graph.step_count();
  View view;
  view.width = width;
  view.height = height;
  view.camera = camera_for(samples_->bounds, samples_->extent, source.spatial(), width, height);
  if (!source.spatial()) add_grid(view, width, height);

  const bool surface_done = last && !samples_->mesh.indices.empty();
  if (surface_done) {
    view.meshes.push_back(samples_->mesh);
    for (const auto& iso : samples_->isolines) view.polylines.push_back(line(iso, Role::isoline));
  }
  for (const auto& piece : samples_->curves) view.polylines.push_back(line(piece, Role::curve));
  for (const auto& at : samples_->knots) view.markers.push_back(marker(at, Role::curve, 0.8, Marker::Shape::square));

  // The values alive, in groups that form polylines.
  const ValueId main = graph.main_value(step);
  std::set<ValueId> operands;
  if (main != absent && !graph.is_input(main))
    for (const ValueId o : graph.operands(main)) operands.insert(o);
  const auto [first_new, end_new] = graph.values_of(step);

  // Keys: phase, minus the arity (so that results are drawn over triangles), symbol, first index.
  using Group = std::tuple<std::uint32_t, int, std::uint64_t, int>;
  std::map<Group, std::map<int, ValueId>> rows;
  std::map<Group, std::map<int, ValueId>> net_columns;
  std::vector<ValueId> shown;
  for (ValueId v = 0; v < graph.value_count() && graph.value(v).step <= step; ++v) {
    if (!source.points[v]) continue;
    const ValueSpec* spec = source.spec(v);
    if (spec == nullptr || spec->draw == ValueSpec::Draw::none) continue;
    const bool given = graph.is_input(v);
    if (!given && !graph.alive(v, step) && !operands.contains(v)) continue;
    if (surface_done && (given || spec->draw != ValueSpec::Draw::net || !graph.scope(v).empty())) continue;
    const Name& name = graph.value(v).name;
    const std::uint32_t phase = graph.scope(v).empty() ? absent : graph.phase_of(v);
    const int row = name.arity == 2 ? name.index[0] : 0;
    if (spec->draw != ValueSpec::Draw::point)
      rows[{phase, -name.arity, name.symbol.packed, row}][name.arity > 0 ? name.index[name.arity - 1] : 0] = v;
    if (spec->draw == ValueSpec::Draw::net && !given)
      net_columns[{phase, -name.arity, name.symbol.packed, name.index[1]}][name.index[0]] = v;
    shown.push_back(v);
  }
  const auto role_of = [&](ValueId v) {
    const ValueSpec* spec = source.spec(v);
    const Name& name = graph.value(v).name;
    if (graph.is_input(v)) return graph.alive(v, step) ? Role::control_point : Role::retired;
    switch (spec->draw) {
      case ValueSpec::Draw::level:
        return name.arity == 2 ? level_role(name.index[0]) : Role::earlier;
      case ValueSpec::Draw::polygon:
      case ValueSpec::Draw::net:
        return Role::result;
      case ValueSpec::Draw::point:
        return graph.operands(v).size() == 1 ? Role::result : Role::earlier;
      case ValueSpec::Draw::none:
        break;
    }
    return Role::earlier;
  };
  const auto add_rows = [&](const auto& groups) {
    for (const auto& [group, members] : groups) {
      std::vector<glm::dvec3> run;
      int before = 0;
      Role role = Role::polygon;
      const auto flush = [&] {
        if (run.size() > 1) view.polylines.push_back(line(run, role, source.spatial() ? 0.6 : 1));
        run.clear();
      };
      for (const auto& [i, v] : members) {
        if (!run.empty() && i != before + 1) flush();
        role = graph.is_input(v) ? Role::polygon : role_of(v);
        run.push_back(*source.points[v]);
        before = i;
      }
      flush();
    }
  };
  add_rows(rows);
  add_rows(net_columns);
  if (last)
    for (const auto& piece : samples_->result) view.polylines.push_back(line(piece, Role::curve_result, 1, true));

  // Where several values are one point, the newest has its name there.
  std::map<std::tuple<double, double, double>, ValueId> newest;
  for (const ValueId v : shown) newest[{source.points[v]->x, source.points[v]->y, source.points[v]->z}] = v;
  // Names of a phase that is over would only be in the way.
  const auto around = graph.phase_path(graph.step(step).phase);
  const auto here = [&](ValueId v) {
    return graph.scope(v).empty() || std::ranges::find(around, graph.phase_of(v)) != around.end();
  };
  // A step that writes down a whole polygon has no single value to look at.
  const bool single = main != absent && end_new - first_new <= 3;
  const double size = source.spatial() ? 0.75 : 1;

  for (const ValueId v : shown) {
    const bool made_now = v >= first_new && v < end_new && !graph.is_input(v);
    const bool loud = made_now && single;
    const bool read = operands.contains(v) && single;
    const Role role = loud ? Role::current : role_of(v);
    if (read && !made_now)
      view.markers.push_back(marker(*source.points[v], Role::operand, 1.7 * size, Marker::Shape::ring));
    view.markers.push_back(marker(*source.points[v], role, size));
    if (surface_done || (shown.size() > most_labels && !made_now && !read)) continue;
    if (!made_now && !read && !here(v)) continue;
    if (newest[{source.points[v]->x, source.points[v]->y, source.points[v]->z}] != v) continue;
    Label label;
    label.anchor = *source.points[v];
    label.text = typeset_name(graph.value(v).name, source.algorithm_at(graph.value(v).step));
    label.role = loud ? Role::text_current
                      : (read ? Role::text_strong : (graph.is_input(v) || made_now ? Role::text : Role::text_quiet));
    label.size_scale = loud ? 1.15 : 1;
    label.placement = Label::Placement::around;
    label.priority = made_now ? 30 : (read ? 15 : (graph.is_input(v) ? 5 : 0));
    label.optional = !made_now && !read;
    view.labels.push_back(std::move(label));
  }

  // The step itself.
  if (main != absent && !graph.is_input(main)) {
    const auto from = graph.operands(main);
    const RuleInfo* rule = graph.value(main).rule;
    std::vector<ValueId> points;
    for (const ValueId o : from)
      if (source.points[o] && graph.value(o).kind == ValueKind::point) points.push_back(o);
    if (from.size() == 3 && points.size() == 2 && source.points[main] &&
        (rule->polar == Polar::blend || rule->polar == Polar::merge)) {
      // a of Blend belongs to the second point, a of Elevate to the first.
      const glm::dvec3 &A = *source.points[points[0]], &B = *source.points[points[1]], &M = *source.points[main];
      const bool merge = rule->polar == Polar::merge;
      double a = merge ? 1 - source.scalars[from[0]] : source.scalars[from[0]];
      std::string share = source.value_text(from[0]);
      if (source.rational && glm::length(B - A) > 0) {
        // Weights pull the point along: the picture shows where it really divides the segment.
        a = glm::dot(M - A, B - A) / glm::dot(B - A, B - A);
        share = format_short(merge ? 1 - a : a, 4);
      }
      add_division(view, A, B, M, a, share, merge);
    } else if (points.size() == 2 && graph.value(main).kind == ValueKind::scalar) {
      view.polylines.push_back(line({*source.points[points[0]], *source.points[points[1]]}, Role::ratio_near));
      for (const ValueId o : points)
        view.markers.push_back(marker(*source.points[o], Role::operand, 1.7 * size, Marker::Shape::ring));
    }
  }
  return view;
}

Scene StepScenes::page(std::uint32_t step, const std::string& narration, const PageOptions& options) const {
  const StepSource& source = *source_;
  const TraceGraph& graph = *source.graph;
  const double margin = 18;
  const double top = 54;
  const double bottom = 106;
  const double side = std::min(440.0, options.width * 0.38);
  const double main_width = options.width - side - 3 * margin;
  const double main_height = options.height - top - bottom - margin;

  Scene scene;
  scene.width = options.width;
  scene.height = options.height;
  scene.title = options.title;
  scene.description = narration;

  View page;
  page.width = options.width;
  page.height = options.height;
  const auto text = [&](double x, double y, RichText runs, Role role, double size) -> Label& {
    Label label;
    label.anchor = {x, y, 0};
    label.text = std::move(runs);
    label.role = role;
    label.size_scale = size;
    page.labels.push_back(std::move(label));
    return page.labels.back();
  };
  const double room_for_title = options.width - 2 * margin - 130;  // beside the step's number
  const double title_size = std::min(
      1.35, room_for_title / (static_cast<double>(options.title.size()) * 12.2));  // of the theme with the largest text
  text(margin, 34, {{options.title, TextRun::Level::base, false, true}}, Role::text_strong, title_size);
  text(options.width - margin, 34, {{"step " + std::to_string(step) + " / " + std::to_string(graph.step_count() - 1)}},
       Role::text_quiet, 1)
      .placement = Label::Placement::right;

  // Narration, with the phase it happens in.
  double y = options.height - bottom;
  page.polygons.push_back(
      {{{0, y, 0}, {options.width, y, 0}, {options.width, options.height, 0}, {0, options.height, 0}}, Role::panel, 1});
  y += 24;
  std::string phases;
  for (const std::uint32_t phase : graph.phase_path(graph.step(step).phase))
    phases += (phases.empty() ? "" : "  ›  ") + source.phase_title(phase);
  if (!phases.empty()) {
    text(margin, y - 2, {{phases}}, Role::text_quiet,
         std::min(0.85, (options.width - 2 * margin) / (static_cast<double>(phases.size()) * 8)));
    y += 20;
  }
  // A long one on a small page is set smaller, so that its last line is still on it.
  const double narration_width = options.width - 2 * margin;
  const auto narration_height = [&](double size) {
    return std::ceil(static_cast<double>(narration.size()) * size * 9 / narration_width) * 22 * size;
  };
  double narration_size = 1.08;
  while (narration_size > 0.7 && y - 10 + narration_height(narration_size) > options.height) narration_size -= 0.04;
  text(margin, y + 4, typeset_text(narration, source.algorithm_at(step)), Role::text, narration_size).max_width =
      narration_width;

  // Side panels, from above; the knots below the picture.
  View side_view;
  side_view.x = options.width - side - margin;
  side_view.y = top;
  side_view.width = side;
  side_view.height = main_height;
  double at = add_pseudo_code(side_view, source, step, 6, 0, side - 12);
  const double formula = add_formula(side_view, source, step, 6, at, side - 12, main_height - at);
  // The scheme stands at the bottom, where it does not move from step to step.
  const double room = main_height - at - 150;
  if (room > 90) {
    View measured;
    const double height = add_tableau(measured, source, step, 6, 0, side - 12, room);
    if (height > 0 && at + formula + height <= main_height + 24)
      add_tableau(side_view, source, step, 6, main_height - height + 10, side - 12, room);
  }

  View knots;
  knots.x = margin;
  knots.width = main_width;
  knots.height = 56;
  const double knots_height = add_knot_line(knots, source, step, 0, 0, main_width);
  knots.y = top + main_height - knots_height;

  View picture = viewport(step, main_width, main_height - knots_height);
  picture.x = margin;
  picture.y = top;
  scene.views.push_back(std::move(page));
  scene.views.push_back(std::move(picture));
  scene.views.push_back(std::move(side_view));
  if (knots_height > 0) scene.views.push_back(std::move(knots));
  return scene;
}

}  // namespace blossom
