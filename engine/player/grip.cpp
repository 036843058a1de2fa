#include "player/grip.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "algorithms/typeset.hpp"
#include "player/session.hpp"

namespace blossom {
namespace {

constexpr int largest_denominator = 12;

glm::dvec3 to_dvec3(const Point<Exact>& p) { return {p.x.to_double(), p.y.to_double(), p.z.to_double()}; }

glm::dvec3 unit_vector(int axis) {
  glm::dvec3 e{0, 0, 0};
  e[axis] = 1;
  return e;
}

// The point at this one's height that is seen under `at`. Nothing when that plane is hardly more than a line.
std::optional<glm::dvec3> to_level(const Camera& camera, ViewSize size, glm::dvec2 at, const glm::dvec3& through) {
  const auto near = to_world(camera, size, at, through);
  const auto far = to_world(camera, size, at, through - 0.1 * camera.height * axes_of(camera).toward);
  if (!near || !far) return std::nullopt;
  const glm::dvec3 ray = *far - *near;
  if (std::abs(ray.z) < 0.05 * glm::length(ray)) return std::nullopt;
  glm::dvec3 found = *near + (through.z - near->z) / ray.z * ray;
  found.z = through.z;
  if (!to_page(camera, size, found)) return std::nullopt;  // beyond the horizon
  return found;
}

// As fine as a unit of the page, or a nice fraction of the domain.
Exact parameter_at(double value, double per_unit, const Exact& begin, const Exact& end, bool snap) {
  return snap ? nearest_fraction(value, begin, end) : snapped(value, per_unit);
}

}  // namespace

Camera LookGrip::at(glm::dvec2 mouse) const {
  return turns ? orbited(from, size, mouse - start) : panned(from, size, mouse - start);
}

// ---- points ---------------------------------------------------------------------------------------------------------

PointGrip::PointGrip(const Session& session, const PointAddress& address, const Camera& camera, ViewSize size,
                     glm::dvec2 mouse, double grid)
    : before_(session.inputs()), address_(address), camera_(camera), size_(size), mouse_(mouse), grid_(grid) {
  const Curve<Exact>& curve = curve_at(before_, {address.input, address.curve});
  start_ = affine(curve, address.point);
  from_ = to_dvec3(start_);
  dimension_ = curve.dimension;
  const StepSource& source = session.recording().source();
  if (const auto v = value_of(*source.graph, before_, address)) {
    name_ = source.graph->name(*v);
    from_ = source.points[*v].value_or(from_);
  }
  on_page_ = to_page(camera, size, from_).value_or(mouse);
}

std::optional<int> PointGrip::axis(glm::dvec2 mouse) const {
  const glm::dvec2 drag = mouse - mouse_;
  const double length = glm::length(drag);
  if (!(length > 0)) return std::nullopt;
  // A short piece of each axis, as it is seen from here; one that runs toward the viewer is hardly seen.
  std::optional<int> best;
  double most = 0;
  for (int axis = 0; axis < dimension_; ++axis) {
    const auto end = to_page(camera_, size_, from_ + 1e-3 * camera_.height * unit_vector(axis));
    if (!end) continue;
    const glm::dvec2 seen = *end - on_page_;
    const double seen_length = glm::length(seen), full = 1e-3 * size_.height;
    if (seen_length < 0.05 * full) continue;
    const double along = std::abs(glm::dot(seen, drag)) / (seen_length * length);
    if (along > most) {
      most = along;
      best = axis;
    }
  }
  return best;
}

Point<Exact> PointGrip::place(glm::dvec2 mouse, const GripKeys& keys) const {
  const glm::dvec2 target = on_page_ + (mouse - mouse_);
  const int along = keys.along ? axis(mouse).value_or(-1) : -1;
  if (mouse == mouse_) return start_;
  const auto there = [&](glm::dvec2 at) {
    if (along >= 0) return to_line(camera_, size_, at, from_, unit_vector(along));
    const bool level = dimension_ == 2 && camera_.kind == Camera::Kind::orbit;
    const auto found = level ? to_level(camera_, size_, at, from_) : std::nullopt;
    return found ? found : to_world(camera_, size_, at, from_);
  };
  const auto to = there(target), beside = to_world(camera_, size_, target + glm::dvec2{1, 0}, from_);
  const auto here = to_world(camera_, size_, target, from_);
  if (!to || !beside || !here || !std::isfinite(to->x + to->y + to->z)) return start_;
  const double unit = glm::length(*beside - *here);  // what one unit of the page is in the world, here
  const double grid = keys.snap ? grid_ : 0;
  Point<Exact> place = start_;
  Exact* const coordinates[] = {&place.x, &place.y, &place.z};
  for (int i = 0; i < dimension_; ++i) {
    // What the drag does not change keeps its exact number.
    const bool moves = along >= 0 ? i == along : std::abs((*to)[i] - from_[i]) > 1e-9 * unit;
    if (moves) *coordinates[i] = snapped((*to)[i], unit, grid);
  }
  return place;
}

Edited PointGrip::edited(const Algorithm& algorithm, glm::dvec2 mouse, const GripKeys& keys) const {
  const Point<Exact> to = place(mouse, keys);
  if (to == start_) return before_;
  return move_point(algorithm, before_, address_, to);
}

Grip grip_of_value(const Session& session, ValueId value, const Camera& camera, ViewSize size, glm::dvec2 mouse) {
  const TraceGraph& graph = session.recording().graph();
  const std::string name = graph.name(value);
  const ValueRecord& record = graph.value(value);
  const std::string shown = plain_name(record.name, session.recording().source().algorithm_at(record.step));
  const auto address = address_of(graph, session.inputs(), value);
  if (!address)
    return StuckGrip{name, graph.is_input(value)
                               ? shown + " is given and cannot be dragged."
                               : shown + " is computed; drag one of the control points it comes from."};
  const auto& at = session.recording().source().points[value];
  if (!at || !to_page(camera, size, *at))
    return StuckGrip{name, shown + " has weight 0 and so no place; give it a positive weight first."};
  return PointGrip(session, *address, camera, size, mouse, grid_spacing(session, camera, size));
}

double grid_spacing(const Session& session, const Camera& camera, ViewSize size) {
  return session.recording().scenes().grid_step(camera, size.width, size.height);
}

Point<Exact> place_behind(const Curve<Exact>& curve, std::size_t point) {
  const Point<Exact> here = affine(curve, point);
  const bool last = point + 1 == curve.points.size();
  const Point<Exact> other = affine(curve, last ? point - 1 : point + 1);
  const Exact half = Exact::ratio(last ? -1 : 1, 2);
  return {here.x + half * (other.x - here.x), here.y + half * (other.y - here.y), here.z + half * (other.z - here.z)};
}

PageAxis nearest_axis(const Camera& camera, int dimension, const glm::dvec3& direction) {
  const ViewAxes axes = axes_of(camera);
  const glm::dvec3 wanted = direction.x * axes.right + direction.y * axes.up + direction.z * axes.toward;
  PageAxis best;
  double most = -1;
  for (int axis = 0; axis < dimension; ++axis)
    if (std::abs(wanted[axis]) > most + 1e-9) {
      most = std::abs(wanted[axis]);
      best = {axis, wanted[axis] < 0};
    }
  return best;
}

// ---- parameters -----------------------------------------------------------------------------------------------------

Exact nearest_fraction(double value, const Exact& begin, const Exact& end) {
  const double a = begin.to_double(), length = (end - begin).to_double();
  double least = std::numeric_limits<double>::infinity();
  Exact best = begin;
  for (int n = 1; n <= largest_denominator; ++n) {
    const double k = std::nearbyint((value - a) / length * n);
    if (!(std::abs(k) < 1e9)) continue;
    const double off = std::abs(a + k / n * length - value);
    if (off < least - 1e-12 * std::abs(length)) {  // of equals the one with the smaller denominator
      least = off;
      best = begin + (end - begin) * Exact::ratio(static_cast<std::int64_t>(k), n);
    }
  }
  return best;
}

KnotGrip::KnotGrip(const Session& session, const CurveAddress& address, std::size_t first, const KnotAxis& axis,
                   double mouse_x)
    : before_(session.inputs()), address_(address), first_(first), last_(first), mouse_x_(mouse_x) {
  const Curve<Exact>& curve = curve_at(before_, address);
  from_ = curve.knots[first];
  while (last_ + 1 < curve.knots.size() && curve.knots[last_ + 1] == from_) ++last_;
  begin_ = curve.domain_begin();
  end_ = curve.domain_end();
  per_unit_ = (axis.last - axis.first) / (axis.right - axis.left);
}

Exact KnotGrip::value(double mouse_x, const GripKeys& keys) const {
  if (mouse_x == mouse_x_) return from_;
  return parameter_at(from_.to_double() + (mouse_x - mouse_x_) * per_unit_, per_unit_, begin_, end_, keys.snap);
}

std::size_t KnotGrip::index(double mouse_x, const GripKeys& keys) const {
  return keys.along || mouse_x < mouse_x_ ? first_ : last_;
}

Edited KnotGrip::edited(const Algorithm& algorithm, double mouse_x, const GripKeys& keys) const {
  const Exact to = value(mouse_x, keys);
  if (to == from_) return before_;
  if (curve_at(before_, address_).bezier)
    return Diagnostics{
        {"", 0, 0, address_.input + ".knots", "of a Bézier curve are 0 and 1; make it a B-spline curve first"}};
  const std::size_t i = index(mouse_x, keys);
  return keys.along ? set_equal_knots(algorithm, before_, address_, i, to)
                    : set_knot(algorithm, before_, address_, i, to);
}

ParameterGrip::ParameterGrip(const Session& session, const KnotAxis& axis, double mouse_x, bool jumps)
    : before_(session.inputs()), at_(axis.parameter(mouse_x)), mouse_x_(mouse_x), jumps_(jumps) {
  from_ = before_.number("u");
  const Curve<Exact>& curve = curve_at(before_, curves_of(before_).front());
  begin_ = curve.domain_begin();
  end_ = curve.domain_end();
  per_unit_ = (axis.last - axis.first) / (axis.right - axis.left);
  if (!jumps) at_ = from_.to_double();
}

Exact ParameterGrip::value(double mouse_x, const GripKeys& keys) const {
  if (!jumps_ && mouse_x == mouse_x_) return from_;
  const Exact meant = parameter_at(at_ + (mouse_x - mouse_x_) * per_unit_, per_unit_, begin_, end_, keys.snap);
  return std::clamp(meant, begin_, end_);
}

Edited ParameterGrip::edited(const Algorithm& algorithm, double mouse_x, const GripKeys& keys) const {
  return set_number(algorithm, before_, "u", value(mouse_x, keys));
}

}  // namespace blossom
