// The geometry of one step: what is alive, what the step does, and what is lit.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "algorithms/typeset.hpp"
#include "scene/camera.hpp"
#include "scene/grid.hpp"
#include "scene/hull_shape.hpp"
#include "scene/panel_parts.hpp"
#include "scene/viewport_builder.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_labels_plane = 80, most_labels_space = 24;  // beyond: only what the step is about
constexpr std::size_t few_lit = 3;                                     // named wherever they are
constexpr std::size_t most_points = 1500;  // beyond that what the step is not about is thinned out
// Beyond that a net is drawn finer; of a finished surface, only its lines.
constexpr std::ptrdiff_t most_net_points = 300;

}  // namespace

std::optional<Division> ViewportBuilder::division_of_step() const {
  if (operands_.size() != 3 || !source_.points[main_]) return std::nullopt;
  const RuleInfo* rule = graph_.value(main_).rule;
  if (rule->polar != Polar::blend && rule->polar != Polar::merge) return std::nullopt;
  const auto from = graph_.operands(main_);
  std::vector<ValueId> points;
  for (const ValueId o : from)
    if (source_.points[o] && graph_.value(o).kind == ValueKind::point) points.push_back(o);
  if (points.size() != 2) return std::nullopt;
  // a of Blend belongs to the second point, a of Elevate to the first.
  const bool merge = rule->polar == Polar::merge;
  Division made{*source_.points[points[0]], *source_.points[points[1]], *source_.points[main_], 0, {}, {}, merge};
  made.a = merge ? 1 - source_.scalars[from[0]] : source_.scalars[from[0]];
  made.share = source_.value_text(from[0]);
  made.other = parts::other_share(made.share, source_.scalars[from[0]]);
  const glm::dvec3 AB = made.B - made.A;
  // Weights pull the point along the segment; the shares are those of the formula all the same.
  if (source_.rational && glm::length(AB) > 0) made.a = glm::dot(made.M - made.A, AB) / glm::dot(AB, AB);
  return made;
}

void ViewportBuilder::add_grid() {
  if (view_.camera.kind == Camera::Kind::plane) add_plane_grid(view_);
  if (view_.camera.kind == Camera::Kind::orbit) add_ground_grid(view_, samples_.bounds);
}

void ViewportBuilder::add_hulls() {
  for (const auto& hull : options_.hulls) {
    std::vector<Point<double>> points;
    for (const ValueId v : hull)
      if (graph_.value(v).step <= step_ && source_.points[v]) {
        const glm::dvec3 at = place(v);
        points.emplace_back(at.x, at.y, at.z);
      }
    add_hull(view_, points);
  }
}

void ViewportBuilder::add_curves() {
  if (surface_done_) {
    view_.meshes.push_back(samples_.surface().mesh);
    if (options_.surface_net)
      for (const auto& iso : samples_.surface().isolines) view_.polylines.push_back(line(iso, Role::isoline));
  }
  if (!options_.curves) return;
  // A given surface is only lines, so that what is made on it is seen; where a finished one stands, it is in the way.
  if (!surface_done_)
    for (const auto& iso : samples_.given_isolines) view_.polylines.push_back(line(iso, Role::isoline, 0.6));
  for (const auto& piece : samples_.curves) view_.polylines.push_back(line(piece, Role::curve));
  for (const auto& at : samples_.knots) view_.markers.push_back(marker(at, Role::curve, 0.8, Marker::Shape::square));
}

// The curves in space, and below them the plane at height 1.
void ViewportBuilder::add_lifted() {
  if (samples_.lifted.empty()) return;
  Bounds flat;
  for (const auto& piece : samples_.curves)
    for (const auto& at : piece) flat.add(at);
  for (const Drawable& d : samples_.drawables)
    if (d.given && d.ray) flat.add(*source_.points[d.value]);
  const double margin = 0.08 * flat.diagonal();
  const double x0 = flat.low.x - margin, x1 = flat.high.x + margin;
  const double y0 = flat.low.y - margin, y1 = flat.high.y + margin;
  Mesh plane;
  plane.positions = {{x0, y0, 1}, {x1, y0, 1}, {x1, y1, 1}, {x0, y1, 1}};
  plane.normals.assign(4, {0, 0, 1});
  plane.indices = {0, 1, 2, 0, 2, 3};
  plane.opacity = 0.25;
  Polyline edge = line(plane.positions, Role::isoline, 0.6);
  edge.closed = true;
  view_.meshes.push_back(std::move(plane));
  view_.polylines.push_back(std::move(edge));
  if (options_.labels) view_.labels.push_back(label_around({x1, y0, 1}, {{"w = 1"}}, Role::text_quiet, 2));
  if (!options_.curves) return;
  for (const auto& piece : samples_.lifted) view_.polylines.push_back(line(piece, Role::curve_result, 0.8));
}

void ViewportBuilder::add_rays() {
  for (const Drawable* d : shown_)
    if (d->ray)
      view_.polylines.push_back(
          line({{0, 0, 0}, place(d->value)}, made_now(d->value) ? Role::current : Role::earlier, 0.5));
}

void ViewportBuilder::find_shown() {
  const auto& all = samples_.drawables;
  const auto end = std::ranges::upper_bound(all, step_, {}, &Drawable::born);
  for (auto d = all.begin(); d != end; ++d) {
    if (!d->given && step_ >= d->gone && !read_now(d->value)) continue;
    if (surface_done_ && !is_data(*d)) {
      if (!in_net(*d) || d->phase != absent) continue;
      if (!options_.surface_net && !made_now(d->value)) continue;
    }
    if (is_over(*d) && !read_now(d->value)) continue;
    shown_.push_back(&*d);
  }
  if (shown_.size() > most_points) thin_out();
  crowded_ = std::ranges::count_if(shown_, [&](const Drawable* d) { return in_net(*d); }) > most_net_points;
}

// More points than can be told apart: those of phases that are over go, and of a net that is still too large every so
// manyth row and what the step is about stay.
void ViewportBuilder::thin_out() {
  const auto wanted = [&](const Drawable* d) {
    return made_now(d->value) || read_now(d->value) || options_.emphasis.lights(d->value);
  };
  std::erase_if(shown_, [&](const Drawable* d) { return !wanted(d) && !is_around(*d); });
  if (shown_.size() <= most_points) return;
  stride_ = static_cast<int>((shown_.size() + most_points - 1) / most_points);
  int last_row = 0;
  for (const Drawable* d : shown_)
    if (in_net(*d)) last_row = std::max(last_row, graph_.value(d->value).name.index[0]);
  std::erase_if(shown_, [&](const Drawable* d) {
    if (wanted(d) || !in_net(*d)) return false;
    const int row = graph_.value(d->value).name.index[0];
    return row % stride_ != 0 && row != last_row;
  });
}

void ViewportBuilder::add_rows() {
  add_rows_along(true);
  add_rows_along(false);
}

// Polylines through the values of one family: those of one first index, and across, of a net, those of one second
// index.
void ViewportBuilder::add_rows_along(bool rows) {
  struct Member {
    std::uint32_t phase;
    int arity;
    std::uint64_t symbol;
    int group, index;
    const Drawable* drawable;
    // Larger arities first, so that results are drawn over triangles.
    auto key() const { return std::tuple(phase, -arity, symbol, group); }
  };
  std::vector<Member> members;
  members.reserve(shown_.size());
  for (const Drawable* d : shown_) {
    if (rows ? d->draw == ValueSpec::Draw::point : d->draw != ValueSpec::Draw::net) continue;
    if (surface_done_ && d->given) continue;  // the data of the surface: points beside its net
    const Name& name = graph_.value(d->value).name;
    const int row = name.arity == 2 ? name.index[0] : 0, column = name.arity > 0 ? name.index[name.arity - 1] : 0;
    members.push_back({d->phase, name.arity, name.symbol.packed, rows ? row : column, rows ? column : row, d});
  }
  std::ranges::stable_sort(members, [](const Member& a, const Member& b) {
    return std::pair(a.key(), a.index) < std::pair(b.key(), b.index);
  });
  const double width = surface_done_ ? 0.7 : (source_.spatial() ? 0.6 : 1);
  std::vector<glm::dvec3> run;
  Role role = Role::polygon;
  const auto flush = [&] {
    const bool finer = crowded_ && role == Role::result;
    if (run.size() > 1) view_.polylines.push_back(line(run, role, finer ? 0.5 * width : width));
    run.clear();
  };
  const int most_gap = rows ? 1 : stride_;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Member& member = members[i];
    const bool same_group = i > 0 && members[i - 1].key() == member.key();
    if (!run.empty() && !(same_group && member.index <= members[i - 1].index + most_gap)) flush();
    // Of two values of one index the later one counts.
    if (same_group && members[i - 1].index == member.index && !run.empty()) run.pop_back();
    role = member.drawable->given || surface_done_ ? Role::polygon : role_of(*member.drawable);
    run.push_back(place(member.drawable->value));
  }
  flush();
}

void ViewportBuilder::add_points() {
  std::size_t new_count = 0;
  for (const Drawable* d : shown_) new_count += made_now(d->value) ? 1 : 0;
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const Drawable& d = *shown_[i];
    const bool now = made_now(d.value), loud = now && single_, lit = options_.emphasis.lights(d.value);
    const glm::dvec3 at = place(d.value);
    double size = surface_done_ && !loud && !is_data(d) ? 0.6 * size_ : size_;
    if (now && !division_) size *= motion_;
    if (read_now(d.value) && single_ && !now)
      view_.markers.push_back(marker(at, Role::operand, 1.7 * size_, Marker::Shape::ring));
    if (crowded_ && in_net(d) && !now && !lit) {
      if (surface_done_) continue;
      size *= 0.35;
    }
    view_.markers.push_back(marker(at, loud ? Role::current : role_of(d), size));
    if (lit && !options_.emphasis.quiet) add_ring(at, 1);
    add_name(d, i, new_count > most_labels());
  }
}

void ViewportBuilder::add_arrows() {
  for (const StandingArrow& a : samples_.arrows) {
    if (a.born > step_) break;
    const bool now = made_now(a.value), lit = options_.emphasis.lights(a.value);
    if (graph_.retired_at(a.value) <= step_ && !read_now(a.value) && !lit) continue;
    const glm::dvec3 tip = a.foot + (now ? motion_ : 1) * a.along;
    if (tip == a.foot) continue;
    view_.polylines.push_back(arrow(a.foot, tip, lit ? Role::highlight : now ? Role::current : Role::level_a, 0.8));
    if (!options_.labels && !lit) continue;
    RichText name = typeset_name(graph_.value(a.value).name, source_.algorithm_at(graph_.value(a.value).step));
    if (a.scale != 1) name.insert(name.begin(), {format_short(a.scale, 2) + " "});
    view_.labels.push_back(
        label_around(tip, std::move(name), now ? Role::text_current : Role::text, now ? 30 : 5, !now));
  }
}

std::size_t ViewportBuilder::most_labels() const { return source_.spatial() ? most_labels_space : most_labels_plane; }

bool ViewportBuilder::hidden(ValueId v) const {
  const Lens lens(view_.camera, {view_.width, view_.height});
  const Mesh& mesh = samples_.surface().mesh;
  if (seen_.empty())
    for (const glm::dvec3& at : mesh.positions) {
      const auto seen = lens(at);
      seen_.push_back(seen ? glm::dvec3{seen->x, seen->y, seen->z} : glm::dvec3{1e9, 1e9, -1e9});
    }
  const auto point = lens(place(v));
  if (!point) return true;
  const double nearer = point->z + 0.01 * view_.camera.height;  // a point on the surface is not behind it
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const glm::dvec3 &a = seen_[mesh.indices[i]], &b = seen_[mesh.indices[i + 1]], &c = seen_[mesh.indices[i + 2]];
    if (std::max({a.z, b.z, c.z}) < nearer) continue;
    if (std::max({a.x, b.x, c.x}) < point->x || std::min({a.x, b.x, c.x}) > point->x) continue;
    if (std::max({a.y, b.y, c.y}) < point->y || std::min({a.y, b.y, c.y}) > point->y) continue;
    // Barycentric: the triangle is small, so that its depth runs evenly over the view.
    const double whole = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
    if (whole == 0) continue;
    const double s = ((point->x - a.x) * (c.y - a.y) - (c.x - a.x) * (point->y - a.y)) / whole;
    const double t = ((b.x - a.x) * (point->y - a.y) - (point->x - a.x) * (b.y - a.y)) / whole;
    if (s >= 0 && t >= 0 && s + t <= 1 && a.z + s * (b.z - a.z) + t * (c.z - a.z) > nearer) return true;
  }
  return false;
}

void ViewportBuilder::add_name(const Drawable& d, std::size_t position, bool many_new) {
  const ValueId v = d.value;
  const bool now = made_now(v), loud = now && single_, read = read_now(v) && single_;
  // A long phase that is lit is no reason to name all of its values.
  const std::size_t lit_count = options_.emphasis.lit.size();
  const bool lit = lit_count <= most_labels_plane && options_.emphasis.lights(v);
  if (now && motion_ < 0.5) return;
  // A name on the surface would seem to be that of a place on it.
  if (surface_done_ && !loud && lit_count > few_lit && (hidden(v) || ++names_ > most_labels())) return;
  if (!lit) {
    if (!options_.labels || surface_done_ || (many_new && now)) return;
    if (!now && !read && (shown_.size() > most_labels() || !is_around(d))) return;
    // Where several values are one point, the newest has its name there.
    for (std::size_t later = position + 1; later < shown_.size(); ++later)
      if (*source_.points[shown_[later]->value] == *source_.points[v]) return;
  }
  Label label;
  label.anchor = place(v);
  label.text = typeset_name(graph_.value(v).name, source_.algorithm_at(graph_.value(v).step));
  if (lit)
    for (TextRun& run : label.text) run.bold = true;
  label.role =
      loud ? Role::text_current : (read || lit ? Role::text_strong : (d.given || now ? Role::text : Role::text_quiet));
  label.size_scale = loud ? 1.15 : 1;
  label.placement = Label::Placement::around;
  label.priority = lit ? 40 : (now ? 30 : (read ? 15 : (d.given ? 5 : 0)));
  label.optional = !now && !read && !(lit && lit_count <= few_lit);
  view_.labels.push_back(std::move(label));
}

void ViewportBuilder::add_step() {
  if (division_) return add_division(*division_);
  if (main_ == absent || graph_.is_input(main_) || graph_.value(main_).kind != ValueKind::scalar) return;
  // A number made from two points: the segment between them.
  std::vector<glm::dvec3> points;
  for (const ValueId o : graph_.operands(main_))
    if (source_.points[o] && graph_.value(o).kind == ValueKind::point) points.push_back(*source_.points[o]);
  if (points.size() != 2) return;
  view_.polylines.push_back(line({points[0], points[0] + motion_ * (points[1] - points[0])}, Role::ratio_near));
  if (motion_ == 1) view_.polylines.back().points[1] = points[1];
  for (const auto& at : points) view_.markers.push_back(marker(at, Role::operand, 1.7 * size_, Marker::Shape::ring));
}

void ViewportBuilder::add_division(const Division& d) {
  const glm::dvec3 M = place(main_);
  if (d.a >= 0 && d.a <= 1) {
    view_.polylines.push_back(line({d.A, M}, Role::ratio_near));
    view_.polylines.push_back(line({M, d.B}, Role::ratio_far));
    if (!options_.labels || motion_ < 0.5 || d.share.size() > 12) return;
    const auto label = [&](const glm::dvec3& from, const glm::dvec3& to, const std::string& words) {
      Label made;
      made.anchor = (from + to) * 0.5;
      made.text = {{words}};
      made.role = Role::text_current;
      made.size_scale = 0.85;
      made.placement = Label::Placement::around;
      made.optional = true;
      made.priority = 20;
      view_.labels.push_back(made);
    };
    if (d.a > 0) label(d.A, M, d.swapped ? d.other : d.share);
    if (d.a < 1) label(M, d.B, d.swapped ? d.share : d.other);
    return;
  }
  // Extrapolation: M lies on the line beyond one of them.
  view_.polylines.push_back(line({d.A, d.B}, Role::ratio_near));
  if (d.a > 1 && d.a * motion_ <= 1) return;  // still on its way between them
  view_.polylines.push_back(line({d.a > 1 ? d.B : d.A, M}, Role::ratio_far, 1, true));
}

namespace {

Sheet empty_sheet(double width, double height, const Camera& camera) {
  Sheet sheet;
  sheet.view.width = width;
  sheet.view.height = height;
  sheet.view.camera = camera;
  return sheet;
}

}  // namespace

View StepScenes::viewport(std::uint32_t step, double width, double height) const {
  ViewportOptions options;
  options.grid = !source_->spatial();
  Sheet sheet = empty_sheet(width, height, fitted(width, height));
  ViewportBuilder(*source_, *samples_, step, options, sheet).build();
  return std::move(sheet.view);
}

Sheet StepScenes::viewport(std::uint32_t step, double width, double height, const ViewportOptions& options) const {
  Sheet sheet = empty_sheet(width, height, options.camera ? *options.camera : fitted(width, height));
  ViewportBuilder builder(*source_, *samples_, step, options, sheet);
  builder.build();
  builder.add_spots();
  return sheet;
}

}  // namespace blossom
