#include "scene/object_samples.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernel/evaluate.hpp"
#include "kernel/light_lines.hpp"
#include "kernel/surface_shape.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_samples = 6000, most_knots = 400;
constexpr int deepest = 6;               // a step of a curve is halved so often at most
constexpr double flat = 1 / 8000.0;      // of the size of a curve: how far it may be from its chord
constexpr double least_cosine = 0.9995;  // 2 degrees: how much it may turn within a step
constexpr int mesh_lines = 112, mesh_per_span = 32, least_per_span = 4;
constexpr std::size_t most_isolines = 20;
constexpr int frame_steps = 400;

// C(u) of the piece over the span k, also at its right end.
std::optional<glm::dvec3> point_of_piece(const Curve<double>& curve, int k, double u) {
  detail::BasisRow<double> N;
  basis_functions<double>(curve.knots, curve.degree, k, u, N);
  const auto at = affine_point(
      detail::combine<0, double>(N.data(), curve.points.data() + (k - curve.degree), curve.degree).point());
  return at ? std::optional(plain(*at)) : std::nullopt;
}

// The samples of one piece between two that are known already: halved until the curve keeps to its chords.
class Refiner {
 public:
  Refiner(const Curve<double>& curve, double size, CurveTrack& track)
      : curve_(curve), tolerance_(size * flat), track_(track) {}

  void add(int k, double u0, const std::optional<glm::dvec3>& p0, double u1, const std::optional<glm::dvec3>& p1) {
    struct Step {
      double u0, u1;
      std::optional<glm::dvec3> p0, p1;
      int depth;
    };
    std::vector<Step> waiting{{u0, u1, p0, p1, 0}};
    while (!waiting.empty()) {
      const Step step = waiting.back();
      waiting.pop_back();
      const double middle = step.u0 + (step.u1 - step.u0) / 2;
      if (step.depth < deepest && track_.points.size() + waiting.size() < most_samples && step.u0 < middle &&
          middle < step.u1) {
        const auto at = point_of_piece(curve_, k, middle);
        if (!at || !step.p0 || !step.p1 || bends(*step.p0, *at, *step.p1)) {
          waiting.push_back({middle, step.u1, at, step.p1, step.depth + 1});
          waiting.push_back({step.u0, middle, step.p0, at, step.depth + 1});
          continue;
        }
      }
      put(step.u1, step.p1);
    }
  }
  void put(double u, const std::optional<glm::dvec3>& at) {
    if (at) {
      if (!connected_) track_.pieces.push_back(track_.points.size());
      track_.u.push_back(u);
      track_.points.push_back(*at);
    }
    connected_ = at.has_value();
  }
  void jump() { connected_ = false; }
  bool connected() const { return connected_; }

 private:
  bool bends(const glm::dvec3& a, const glm::dvec3& m, const glm::dvec3& b) const {
    const glm::dvec3 first = m - a, second = b - m, chord = b - a;
    const double lengths = glm::length(first) * glm::length(second);
    if (!(lengths > 16 * tolerance_ * tolerance_)) return false;
    if (glm::dot(first, second) < least_cosine * lengths) return true;
    return glm::length(glm::cross(chord, first)) > tolerance_ * glm::length(chord);
  }

  const Curve<double>& curve_;
  double tolerance_;
  CurveTrack& track_;
  bool connected_ = false;
};

std::vector<std::size_t> all_spans(const std::vector<double>& knots, int degree) {
  std::vector<std::size_t> spans;
  const auto p = static_cast<std::size_t>(degree);
  for (std::size_t k = p; k + p + 1 < knots.size(); ++k)
    if (knots[k] < knots[k + 1]) spans.push_back(k);
  return spans;
}

// Parameters of the mesh in one direction: uniform in each span, every knot among them unless there are too many; and
// which of them have an isoparametric curve, and which a knot line.
void lay_lines(const std::vector<double>& knots, int degree, std::vector<double>& at,
               std::vector<std::size_t>& isolines, std::vector<std::size_t>& knot_lines) {
  const int spans = std::max(static_cast<int>(all_spans(knots, degree).size()), 1);
  const int steps = std::clamp(mesh_lines / spans, least_per_span, mesh_per_span);
  span_parameters(knots, degree, steps, at);
  const std::size_t most = 4 * mesh_lines;
  if (at.size() > most + 1) {
    std::vector<double> fewer;
    for (std::size_t i = 0; i <= most; ++i) fewer.push_back(at[i * (at.size() - 1) / most]);
    at = std::move(fewer);
  }
  const std::size_t last = at.size() - 1;
  // Four curves for a span, or two, as long as they can be told apart.
  const int share = spans <= 2 ? 8 : (spans <= 5 ? 4 : 2);
  const auto stride = std::max<std::size_t>(static_cast<std::size_t>(std::max(steps / share, 1)),
                                            (last + most_isolines - 1) / most_isolines);
  isolines.clear();
  knot_lines.clear();
  for (std::size_t i = 0; i <= last; i += stride) isolines.push_back(i);
  if (last % stride != 0) isolines.push_back(last);
  for (std::size_t i = 0; i <= last; ++i)
    if (std::ranges::binary_search(knots, at[i])) knot_lines.push_back(i);
}

// In stripes: 12 from where a surface faces the light to its silhouette.
std::vector<double> isophote_stripes(const SurfaceGrid& grid) {
  const Point<double> light(0.35, -0.45, 0.82);
  VertexValues angles;
  isophotes(grid.normals, light, angles);
  for (double& angle : angles.values) angle *= 24 / std::numbers::pi;
  for (const int i : angles.undefined) angles.values[static_cast<std::size_t>(i)] = std::nan("");
  return std::move(angles.values);
}

// Of what is finite.
double robust_range(const std::vector<double>& values) {
  std::vector<double> sizes;
  sizes.reserve(values.size());
  for (const double value : values)
    if (std::isfinite(value)) sizes.push_back(std::abs(value));
  if (sizes.empty()) return 0;
  const auto place = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 95 / 100);
  std::ranges::nth_element(sizes, place);
  return *place;
}

}  // namespace

std::optional<glm::dvec3> plain_place(const HPoint<double>& P) {
  const auto at = affine_point(P);
  return at ? std::optional(plain(*at)) : std::nullopt;
}

CurveTrack track_of(const Curve<double>& curve) {
  CurveTrack track;
  Bounds bounds;
  for (const auto& P : curve.points)
    if (const auto at = plain_place(P)) bounds.add(*at);
  Refiner refiner(curve, bounds.diagonal(), track);
  const auto spans = all_spans(curve.knots, curve.degree);
  const auto count = static_cast<int>(std::max<std::size_t>(spans.size(), 1));
  // Not fewer than would miss a wiggle of the degree.
  const int steps = std::clamp(3000 / count, 2, curve.degree == 1 && !curve.rational ? 1 : 4 * curve.degree);
  for (const std::size_t k : spans) {
    const double* Uk = curve.knots.data() + k;
    auto before = point_of_piece(curve, static_cast<int>(k), Uk[0]);
    double u_before = Uk[0];
    if (!refiner.connected()) refiner.put(u_before, before);
    for (int i = 1; i <= steps; ++i) {
      const double u = parameter_in_span(Uk, i, steps);
      const auto here = point_of_piece(curve, static_cast<int>(k), u);
      refiner.add(static_cast<int>(k), u_before, before, u, here);
      before = here;
      u_before = u;
    }
    if (Uk[1] == Uk[curve.degree + 1]) refiner.jump();  // a knot of multiplicity p + 1
  }
  return track;
}

std::vector<std::vector<glm::dvec3>> SurfaceTrack::line(int direction, std::size_t at) const {
  std::vector<std::vector<glm::dvec3>> pieces(1);
  const auto add = [&](std::size_t vertex) {
    if (!grid.undefined.empty() && std::ranges::binary_search(grid.undefined, static_cast<int>(vertex)))
      pieces.emplace_back();
    else
      pieces.back().push_back(mesh.positions[vertex]);
  };
  if (direction == 0)
    for (std::size_t b = 0; b < v.size(); ++b) add(at * columns() + b);
  else
    for (std::size_t a = 0; a < u.size(); ++a) add(a * columns() + at);
  return pieces;
}

ObjectSamples::ObjectSamples(const Geometry& geometry) : exact_(geometry) { make(); }

void ObjectSamples::update(const Geometry& changed) {
  if (!move_points(changed)) {
    exact_ = changed;
    make();
  }
}

// Only where control points of a surface that has stayed the same otherwise act on it.
bool ObjectSamples::move_points(const Geometry& changed) {
  auto* before = std::get_if<Surface<Exact>>(&exact_);
  const auto* after = std::get_if<Surface<Exact>>(&changed);
  auto* plain_surface = std::get_if<Surface<double>>(&geometry_);
  if (before == nullptr || after == nullptr || plain_surface == nullptr) return false;
  if (before->degree != after->degree || before->rows != after->rows || before->columns != after->columns ||
      before->rational != after->rational || before->bezier != after->bezier || before->knots != after->knots)
    return false;
  std::array<int, 2> rows{after->rows, -1}, columns{after->columns, -1};
  for (int i = 0; i < after->rows; ++i)
    for (int j = 0; j < after->columns; ++j) {
      const HPoint<Exact>& P = after->at(i, j);
      if (P == before->at(i, j)) continue;
      rows = {std::min(rows[0], i), std::max(rows[1], i)};
      columns = {std::min(columns[0], j), std::max(columns[1], j)};
      before->at(i, j) = P;
      HPoint<double>& Q = plain_surface->at(i, j);
      for (int c = 0; c < 4; ++c) Q[c] = P[c].to_double();
      points_[static_cast<std::size_t>(i * after->columns + j)] = plain_place(Q);
    }
  if (rows[1] < 0) return true;
  for (auto& numbers : numbers_) numbers.reset();
  const std::vector<int> undefined = mesh_.grid.undefined;
  const GridUpdate part = update_grid(*plain_surface, mesh_.grid, rows, columns);
  fill_vertices(part);
  if (undefined != mesh_.grid.undefined) fill_triangles();
  find_bounds();
  return true;
}

void ObjectSamples::make() {
  std::visit(
      [&](const auto& exact) {
        auto made = convert<double>(exact);
        points_.clear();
        for (const auto& P : made.points) points_.push_back(plain_place(P));
        if constexpr (requires { made.dimension; })
          spatial_ = made.dimension == 3;
        else
          spatial_ = true;
        if constexpr (requires { made.columns; }) columns_ = made.columns;
        geometry_ = std::move(made);
      },
      exact_);
  frames_.reset();
  for (auto& numbers : numbers_) numbers.reset();
  sample();
  find_bounds();
}

void ObjectSamples::find_bounds() {
  bounds_ = shape_bounds_ = {};
  for (const auto& at : track_.points) shape_bounds_.add(at);
  for (const std::uint32_t i : mesh_.mesh.indices) shape_bounds_.add(mesh_.mesh.positions[i]);
  for (const auto& at : points_)
    if (at) bounds_.add(*at);
  bounds_.add(shape_bounds_);
}

void ObjectSamples::sample() {
  knots_.clear();
  track_ = {};
  if (const auto* c = curve()) {
    track_ = track_of(*c);
    for (int i = c->degree + 1; i <= c->n() && knots_.size() < most_knots; ++i) {
      const double u = c->knots[static_cast<std::size_t>(i)];
      if (u > c->domain_begin() && u < c->domain_end() && u != c->knots[static_cast<std::size_t>(i) - 1])
        if (const auto at = point(*c, u)) knots_.push_back(plain(*at));
    }
  }
  const auto* s = surface();
  if (s == nullptr) return;
  lay_lines(s->knots[0], s->degree[0], mesh_.u, mesh_.isolines[0], mesh_.knot_lines[0]);
  lay_lines(s->knots[1], s->degree[1], mesh_.v, mesh_.isolines[1], mesh_.knot_lines[1]);
  evaluate_grid(*s, mesh_.u, mesh_.v, true, mesh_.grid);
  const SurfaceGrid& grid = mesh_.grid;
  mesh_.mesh.positions.resize(grid.points.size());
  mesh_.mesh.normals.resize(grid.points.size());
  fill_vertices({0, grid.rows - 1, 0, grid.columns - 1});
  fill_triangles();
}

void ObjectSamples::fill_vertices(const GridUpdate& part) {
  const SurfaceGrid& grid = mesh_.grid;
  Mesh& mesh = mesh_.mesh;
  const auto index = [&](int a, int b) {
    return static_cast<std::size_t>(a) * mesh_.columns() + static_cast<std::size_t>(b);
  };
  for (int a = part.first_a; a <= part.last_a; ++a)
    for (int b = part.first_b; b <= part.last_b; ++b) {
      const std::size_t i = index(a, b);
      mesh.positions[i] = plain(grid.points[i]);
      mesh.normals[i] = plain(grid.normals[i]);
      if (mesh.normals[i] != glm::dvec3(0)) continue;
      // Where there is no normal it is lit as what lies around it.
      glm::dvec3 sum(0);
      for (int x = std::max(a - 1, 0); x <= std::min(a + 1, grid.rows - 1); ++x)
        for (int y = std::max(b - 1, 0); y <= std::min(b + 1, grid.columns - 1); ++y)
          sum += plain(grid.normals[index(x, y)]);
      if (glm::length(sum) > 1e-6) mesh.normals[i] = glm::normalize(sum);
    }
}

void ObjectSamples::fill_triangles() {
  const SurfaceGrid& grid = mesh_.grid;
  const std::size_t rows = mesh_.u.size(), columns = mesh_.columns();
  auto& indices = mesh_.mesh.indices;
  indices.clear();
  indices.reserve(6 * (rows - 1) * (columns - 1));
  const auto at = [&](std::size_t a, std::size_t b) { return static_cast<std::uint32_t>(a * columns + b); };
  const auto defined = [&](std::uint32_t i) {
    return grid.undefined.empty() || !std::ranges::binary_search(grid.undefined, static_cast<int>(i));
  };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (defined(a) && defined(b) && defined(c)) indices.insert(indices.end(), {a, b, c});
  };
  for (std::size_t a = 0; a + 1 < rows; ++a)
    for (std::size_t b = 0; b + 1 < columns; ++b) {
      add(at(a, b), at(a + 1, b), at(a + 1, b + 1));
      add(at(a, b), at(a + 1, b + 1), at(a, b + 1));
    }
}

const CurveFrames& ObjectSamples::frames() const {
  if (frames_) return *frames_;
  frames_ = std::make_unique<CurveFrames>();
  const auto* c = curve();
  if (c == nullptr) return *frames_;
  const int spans = std::max(static_cast<int>(all_spans(c->knots, c->degree).size()), 1);
  span_parameters(c->knots, c->degree, std::clamp(frame_steps / spans, 4, 64), frames_->u);
  sample_frames(*c, frames_->u, frames_->frames);
  rotation_minimising_frames(*c, frames_->u, frames_->moving, Point<double>(0, 0, 1));
  return *frames_;
}

const SurfaceNumbers& ObjectSamples::numbers(SurfaceMap map) const {
  auto& wanted = numbers_[static_cast<std::size_t>(map)];
  if (wanted) return *wanted;
  const auto* s = surface();
  if (s == nullptr || map == SurfaceMap::none) {
    wanted = std::make_unique<SurfaceNumbers>();
    return *wanted;
  }
  if (map == SurfaceMap::isophotes || map == SurfaceMap::reflection) {
    // Reflections depend on the eye; who draws them computes them.
    wanted = std::make_unique<SurfaceNumbers>();
    if (map == SurfaceMap::isophotes) wanted->values = isophote_stripes(mesh_.grid);
    return *wanted;
  }
  // One evaluation serves all four curvatures.
  CurvatureGrid grid;
  evaluate_curvatures(*s, mesh_.u, mesh_.v, grid);
  for (const auto& [kind, values] :
       {std::pair{SurfaceMap::gaussian, &grid.gaussian}, std::pair{SurfaceMap::mean, &grid.mean},
        std::pair{SurfaceMap::largest, &grid.maximum}, std::pair{SurfaceMap::smallest, &grid.minimum}}) {
    for (const int i : grid.singular) (*values)[static_cast<std::size_t>(i)] = std::nan("");
    const double range = robust_range(*values);
    numbers_[static_cast<std::size_t>(kind)] =
        std::make_unique<SurfaceNumbers>(SurfaceNumbers{std::move(*values), range});
  }
  return *wanted;
}

std::optional<MovingFrame> moving_frame_at(const ObjectSamples& samples, double u) {
  const auto* curve = samples.curve();
  if (curve == nullptr) return std::nullopt;
  const CurveFrames& all = samples.frames();
  auto last = static_cast<std::size_t>(std::ranges::upper_bound(all.u, u) - all.u.begin());
  while (last > 0 && !all.moving[last - 1]) --last;
  if (last == 0) return std::nullopt;
  const double both[] = {all.u[last - 1], u};
  std::vector<std::optional<MovingFrame>> moved;
  rotation_minimising_frames(*curve, both, moved, all.moving[last - 1]->normal);
  return moved.back();
}

}  // namespace blossom
