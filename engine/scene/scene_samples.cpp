#include "scene/scene_samples.hpp"

#include <algorithm>
#include <cmath>
#include <glm/vector_relational.hpp>

#include "kernel/evaluate.hpp"
#include "kernel/tessellate.hpp"
#include "scene/fit.hpp"

namespace blossom {
namespace {

constexpr int samples_per_span = 80, fewest_samples = 4;
constexpr int most_samples = 4000;  // of all curves together, as far as each span has the fewest
constexpr std::size_t most_knots = 200;
constexpr int mesh_per_span = 12;
constexpr int samples_per_line_span = 40, most_line_samples = 400;  // of an isoparametric curve
constexpr int most_mesh_lines = 120, most_isolines = 20;            // in each direction

glm::dvec3 plain(const Point<double>& p) { return {p.x, p.y, p.z}; }

int span_count(const std::vector<double>& knots, int degree) {
  int count = 0;
  for (std::size_t k = static_cast<std::size_t>(degree); k + static_cast<std::size_t>(degree) + 1 < knots.size(); ++k)
    count += knots[k] < knots[k + 1] ? 1 : 0;
  return count;
}

int samples_for(const std::vector<Curve<double>>& curves) {
  int spans = 0;
  for (const auto& curve : curves) spans += span_count(curve.knots, curve.degree);
  return std::clamp(most_samples / std::max(spans, 1), fewest_samples, samples_per_span);
}

// Parameters of the mesh in one direction: uniform in each span, every knot among them unless there are too many.
struct MeshLines {
  std::vector<double> at;
  std::vector<double> fine;  // where curves are sampled that run in this direction, for their corners would be seen
  std::size_t stride = 1;    // from one isoparametric curve to the next

  MeshLines(const std::vector<double>& knots, int degree) {
    const int spans = std::max(span_count(knots, degree), 1);
    const int steps = std::clamp(most_mesh_lines / spans, 1, mesh_per_span);
    span_parameters(knots, degree, steps, at);
    if (at.size() > most_mesh_lines + 1) {
      std::vector<double> fewer;
      const std::size_t last = at.size() - 1;
      for (std::size_t i = 0; i <= most_mesh_lines; ++i) fewer.push_back(at[i * last / most_mesh_lines]);
      at = std::move(fewer);
    }
    // Two curves for a span, as long as they can be told apart.
    span_parameters(knots, degree, std::clamp(most_line_samples / spans, steps, samples_per_line_span), fine);
    const std::size_t whole = at.size() - 1;
    stride = std::max<std::size_t>(static_cast<std::size_t>(std::max(steps / 2, 1)),
                                   (whole + most_isolines - 1) / most_isolines);
  }
  // Where the isoparametric curves are that run across.
  std::vector<double> across() const {
    std::vector<double> places;
    for (std::size_t i = 0; i < at.size(); i += stride) places.push_back(at[i]);
    if ((at.size() - 1) % stride != 0) places.push_back(at.back());
    return places;
  }
};

}  // namespace

SurfaceSamples sample_surface(const Surface<double>& surface) {
  SurfaceSamples made;
  const MeshLines u(surface.knots[0], surface.degree[0]), v(surface.knots[1], surface.degree[1]);
  SurfaceGrid grid;
  evaluate_grid(surface, u.at, v.at, true, grid);
  if (!grid.undefined.empty()) return made;  // a pole of the denominator: there is no surface to show there
  Mesh& mesh = made.mesh;
  mesh.role = Role::surface;
  mesh.positions.reserve(grid.points.size());
  mesh.normals.reserve(grid.points.size());
  for (std::size_t i = 0; i < grid.points.size(); ++i) {
    mesh.positions.push_back(plain(grid.points[i]));
    mesh.normals.push_back(plain(grid.normals[i]));
  }
  const auto rows = static_cast<std::size_t>(grid.rows), columns = static_cast<std::size_t>(grid.columns);
  const auto at = [&](std::size_t a, std::size_t b) { return static_cast<std::uint32_t>(a * columns + b); };
  for (std::size_t a = 0; a + 1 < rows; ++a)
    for (std::size_t b = 0; b + 1 < columns; ++b)
      mesh.indices.insert(mesh.indices.end(),
                          {at(a, b), at(a + 1, b), at(a + 1, b + 1), at(a, b), at(a + 1, b + 1), at(a, b + 1)});
  for (const bool along_v : {true, false}) {
    evaluate_grid(surface, along_v ? u.across() : u.fine, along_v ? v.fine : v.across(), false, grid);
    const auto lines = static_cast<std::size_t>(along_v ? grid.rows : grid.columns);
    const auto samples = static_cast<std::size_t>(along_v ? grid.columns : grid.rows);
    for (std::size_t line = 0; line < lines; ++line) {
      auto& made_line = made.isolines.emplace_back();
      for (std::size_t s = 0; s < samples; ++s)
        made_line.push_back(plain(grid.points[along_v ? line * samples + s : s * lines + line]));
    }
  }
  return made;
}

void SurfaceSamples::add(SurfaceSamples other) {
  const auto base = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.role = other.mesh.role;
  mesh.positions.insert(mesh.positions.end(), other.mesh.positions.begin(), other.mesh.positions.end());
  mesh.normals.insert(mesh.normals.end(), other.mesh.normals.begin(), other.mesh.normals.end());
  for (const std::uint32_t i : other.mesh.indices) mesh.indices.push_back(base + i);
  for (auto& iso : other.isolines) isolines.push_back(std::move(iso));
}

SceneSamples::SceneSamples(const StepSource& source) : source_(&source) {
  const int steps = samples_for(source.curves);
  for (const auto& curve : source.curves) {
    add_curve(curve, steps, curves);
    for (int i = curve.degree + 1; i <= curve.n(); ++i) {
      const double u = curve.knots[static_cast<std::size_t>(i)];
      if (u > curve.domain_begin() && u < curve.domain_end() && u != curve.knots[static_cast<std::size_t>(i) - 1])
        if (const auto at = point(curve, u)) knots.push_back(plain(*at));
    }
  }
  if (knots.size() > most_knots) knots.clear();
  for (const auto& curve : source.lifted) add_curve(curve, steps, lifted);
  for (const auto& curve : source.pictured) add_curve(curve, samples_for(source.pictured), curves);
  for (const auto& surface : source.surfaces)
    for (auto& iso : sample_surface(surface).isolines) given_isolines.push_back(std::move(iso));
  if (const auto* curve = std::get_if<Curve<double>>(&source.outcome)) add_curve(*curve, samples_for({*curve}), result);
  if (const auto* pieces = std::get_if<std::vector<Curve<double>>>(&source.outcome))
    for (const auto& curve : *pieces) add_curve(curve, samples_for(*pieces), result);
  find_drawables();
  find_places();
  for_each_place([&](const glm::dvec3& at) { bounds.add(at); });
  if (bounds.empty()) bounds.add({0, 0, 0});
  find_arrows();
}

void SceneSamples::add_curve(const Curve<double>& curve, int steps, std::vector<std::vector<glm::dvec3>>& pieces) {
  CurveSamples samples;
  sample_curve(curve, steps, samples);
  for (std::size_t piece = 0; piece < samples.pieces.size(); ++piece) {
    const std::size_t end = piece + 1 < samples.pieces.size() ? samples.pieces[piece + 1] : samples.points.size();
    auto& made = pieces.emplace_back();
    made.reserve(end - samples.pieces[piece]);
    for (std::size_t i = samples.pieces[piece]; i < end; ++i) made.push_back(plain(samples.points[i]));
  }
}

// Of several surfaces, all together.
const SurfaceSamples& SceneSamples::surface() const {
  if (surface_) return *surface_;
  surface_ = std::make_unique<SurfaceSamples>();
  if (const auto* surface = std::get_if<Surface<double>>(&source_->outcome)) *surface_ = sample_surface(*surface);
  if (const auto* pieces = std::get_if<std::vector<Surface<double>>>(&source_->outcome))
    for (const auto& surface : *pieces) surface_->add(sample_surface(surface));
  return *surface_;
}

// What is drawn; other points only where they lie near, for those on the way to a solution may be anywhere.
void SceneSamples::find_places() {
  Bounds drawn;
  for (const Drawable& d : drawables) drawn.add(*source_->points[d.value]);
  for (const auto* pieces : {&curves, &lifted, &result, &given_isolines})
    for (const auto& piece : *pieces)
      for (const auto& at : piece) drawn.add(at);
  const glm::dvec3 reach(0.5 * drawn.diagonal());
  for (const auto& at : source_->points) {
    if (!at) continue;
    const bool near = glm::all(glm::greaterThanEqual(*at, drawn.low - reach)) &&
                      glm::all(glm::lessThanEqual(*at, drawn.high + reach));
    if (near || drawn.empty()) places_.push_back(*at);
  }
}

// A surface lies in the hull of its control points, which are values; a curve with a weight of 0 may not.
template <class Body>
void SceneSamples::for_each_place(const Body& body) const {
  for (const auto& at : places_) body(at);
  if (!lifted.empty()) body(glm::dvec3{0, 0, 0});  // where the rays come from
  for (const auto* pieces : {&curves, &lifted, &result, &given_isolines})
    for (const auto& piece : *pieces)
      for (const auto& at : piece) body(at);
}

// One pass over the values. Neighbours mostly belong to one phase, whose algorithm and table are looked up once.
void SceneSamples::find_drawables() {
  const TraceGraph& graph = *source_->graph;
  std::vector<int> scopes(graph.phases().size());  // how many scoped phases there are around and with a phase
  for (std::size_t i = 0; i < scopes.size(); ++i) {
    const PhaseRecord& phase = graph.phases()[i];
    scopes[i] = (phase.scoped ? 1 : 0) + (phase.parent == absent ? 0 : scopes[phase.parent]);
  }
  struct Known {
    Name name;
    const ValueSpec* spec;
  };
  std::vector<Known> known;  // of the current phase
  std::uint32_t known_phase = absent;
  bool known_intro = false, any_known = false;
  std::optional<glm::dvec3> outcome;  // if it is a point
  if (const auto* P = std::get_if<HPoint<double>>(&source_->outcome); P != nullptr && P->w != 0)
    outcome = glm::dvec3{P->x, P->y, P->z} / (source_->rational ? P->w : 1);
  for (ValueId v = 0; v < graph.value_count(); ++v) {
    if (!source_->points[v]) continue;
    const ValueRecord& record = graph.value(v);
    const std::uint32_t phase = graph.phase_of(v);
    const bool intro = phase != absent && graph.phases()[phase].first_step == record.step;
    if (!any_known || phase != known_phase || intro != known_intro) known.clear();
    any_known = true;
    known_phase = phase;
    known_intro = intro;
    auto found = std::ranges::find_if(known, [&](const Known& k) {
      return k.name.symbol == record.name.symbol && k.name.arity == record.name.arity;
    });
    if (found == known.end()) found = known.insert(known.end(), {record.name, source_->spec(v)});
    const ValueSpec* spec = found->spec;
    if (spec == nullptr || spec->draw == ValueSpec::Draw::none) continue;
    Drawable made{v, record.step, graph.retired_at(v), absent, spec->draw, graph.is_input(v), spec->ray, Role::earlier};
    if (phase != absent && scopes[phase] > record.name.outer) made.phase = phase;
    static constexpr Role levels[] = {Role::level_a, Role::level_b, Role::level_c};
    switch (spec->draw) {
      case ValueSpec::Draw::level:
        if (record.name.arity == 2)
          made.role = levels[static_cast<std::size_t>(std::max(record.name.index[0] - 1, 0)) % 3];
        break;
      case ValueSpec::Draw::polygon:
      case ValueSpec::Draw::net:
        made.role = Role::result;
        break;
      case ValueSpec::Draw::point:
        if (graph.operands(v).size() == 1 || source_->points[v] == outcome) made.role = Role::result;
        break;
      case ValueSpec::Draw::none:
        break;
    }
    drawables.push_back(made);
  }
}

Camera SceneSamples::fitted(double width, double height, const std::optional<Camera>& look) const {
  Camera from;
  if (look) {
    from = *look;
  } else {
    from.kind = source_->spatial() ? Camera::Kind::orbit : Camera::Kind::plane;
    if (source_->spatial()) {
      from.azimuth = -1.0;
      from.elevation = 0.42;
    }
  }
  from.centre = {};
  from.height = 1;
  if (!fit_ || fit_->width != width || fit_->height != height || fit_->look != from)
    fit_ = Fit{width, height, from, fitted_anew(width, height, from)};
  return fit_->camera;
}

Camera SceneSamples::fitted_anew(double width, double height, const Camera& camera) const {
  return fitted_camera(camera, width, height, bounds, [&](const auto& body) { for_each_place(body); });
}

}  // namespace blossom
