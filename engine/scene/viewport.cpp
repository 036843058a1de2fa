// The geometry of one step: what is alive, what the step does, and what is lit.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <tuple>

#include "scene/camera.hpp"
#include "scene/grid.hpp"
#include "scene/scene_samples.hpp"
#include "scene/step_scene.hpp"
#include "scene/typeset.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_labels = 80;    // beyond that only what the step is about is named
constexpr std::size_t most_points = 1500;  // beyond that what the step is not about is thinned out
constexpr std::size_t most_shares = 64;    // rings of ancestors, those that weigh most
constexpr std::size_t most_share_texts = 12;
constexpr double least_share = 5e-4;  // would be written as 0
constexpr double spot_size = 22;

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

// The share of the far part of a divided segment, in the manner of the share of the near one: 3/5 beside 2/5.
std::string other_share(const std::string& share, double value) {
  if (share.find('/') != std::string::npos)
    if (const auto exact = Exact::parse(share)) return (Exact(1) - *exact).to_string();
  return format_short(1 - value, 4);
}

// What the current step does to two points: A and B are divided at M, as the share a says.
struct Division {
  glm::dvec3 A, B, M;
  double a = 0;
  std::string share;
  bool swapped = false;  // the share is that of the second part
};

class ViewportBuilder {
 public:
  ViewportBuilder(const StepSource& source, const SceneSamples& samples, std::uint32_t step,
                  const ViewportOptions& options, Sheet& sheet)
      : source_(source),
        graph_(*source.graph),
        samples_(samples),
        step_(step),
        options_(options),
        motion_(options.motion < 1 ? std::max(options.motion, 0.0) : 1),
        sheet_(sheet),
        view_(sheet.view),
        last_(step + 1 == graph_.step_count()),
        surface_done_(last_ && !samples.surface().mesh.indices.empty()),
        size_(source.spatial() ? 0.75 : 1),
        main_(graph_.main_value(step)),
        around_(graph_.phase_path(graph_.step(step).phase)) {
    std::tie(first_new_, end_new_) = graph_.values_of(step);
    if (main_ != absent && !graph_.is_input(main_)) {
      const auto from = graph_.operands(main_);
      operands_.assign(from.begin(), from.end());
      std::ranges::sort(operands_);
    }
    // A step that writes down a whole polygon has no single value to look at.
    single_ = main_ != absent && end_new_ - first_new_ <= 3;
    division_ = division_of_step();
  }

  void build() {
    if (options_.grid) add_grid();
    add_curves();
    find_shown();
    add_rows();
    if (last_)
      for (const auto& piece : samples_.result) view_.polylines.push_back(line(piece, Role::curve_result, 1, true));
    add_points();
    add_shares();
    add_lit_elsewhere();
    add_step();
  }
  void add_spots();

 private:
  bool made_now(ValueId v) const { return v >= first_new_ && v < end_new_ && !graph_.is_input(v); }
  bool read_now(ValueId v) const { return std::ranges::binary_search(operands_, v); }
  bool is_around(const Drawable& d) const {
    return d.phase == absent || std::ranges::find(around_, d.phase) != around_.end();
  }
  bool in_net(const Drawable& d) const {  // of the finished surface
    return d.draw == ValueSpec::Draw::net && !d.given;
  }
  // Where it is at this moment of the step.
  glm::dvec3 place(ValueId v) const {
    if (motion_ < 1 && v == main_ && division_) return division_->A + motion_ * (division_->M - division_->A);
    return *source_.points[v];
  }
  Role role_of(const Drawable& d) const {
    if (d.given) return step_ < d.gone ? Role::control_point : Role::retired;
    return surface_done_ ? Role::control_point : d.role;
  }

  std::optional<Division> division_of_step() const;
  void add_grid();
  void add_curves();
  void find_shown();
  void thin_out();
  void add_rows();
  void add_rows_along(bool rows);
  void add_points();
  void add_name(const Drawable&, std::size_t position, bool many_new);
  void add_shares();
  void add_lit_elsewhere();
  void add_step();
  void add_division(const Division&);
  void add_ring(const glm::dvec3& at, double size) {
    view_.markers.push_back(marker(at, Role::highlight, size, Marker::Shape::ring));
  }

  const StepSource& source_;
  const TraceGraph& graph_;
  const SceneSamples& samples_;
  std::uint32_t step_;
  const ViewportOptions& options_;
  double motion_;
  Sheet& sheet_;
  View& view_;
  bool last_, surface_done_;
  double size_;  // of markers
  ValueId main_;
  std::vector<std::uint32_t> around_;  // phases
  ValueId first_new_ = 0, end_new_ = 0;
  std::vector<ValueId> operands_;  // ascending
  bool single_ = false;
  std::optional<Division> division_;
  std::vector<const Drawable*> shown_;  // by value
  int stride_ = 1;                      // of the first indices of a net that was thinned out
};

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
  Division made{*source_.points[points[0]], *source_.points[points[1]], *source_.points[main_], 0, {}, merge};
  made.a = merge ? 1 - source_.scalars[from[0]] : source_.scalars[from[0]];
  const glm::dvec3 AB = made.B - made.A;
  if (source_.rational && glm::length(AB) > 0) {
    // Weights pull the point along: the picture shows where it really divides the segment.
    made.a = glm::dot(made.M - made.A, AB) / glm::dot(AB, AB);
    made.share = format_short(merge ? 1 - made.a : made.a, 4);
  } else {
    made.share = source_.value_text(from[0]);
  }
  return made;
}

void ViewportBuilder::add_grid() {
  if (view_.camera.kind == Camera::Kind::plane) add_plane_grid(view_);
  if (view_.camera.kind == Camera::Kind::orbit) add_ground_grid(view_, samples_.bounds);
}

void ViewportBuilder::add_curves() {
  if (surface_done_) {
    view_.meshes.push_back(samples_.surface().mesh);
    if (options_.surface_net)
      for (const auto& iso : samples_.surface().isolines) view_.polylines.push_back(line(iso, Role::isoline));
  }
  if (!options_.curves) return;
  for (const auto& piece : samples_.curves) view_.polylines.push_back(line(piece, Role::curve));
  for (const auto& at : samples_.knots) view_.markers.push_back(marker(at, Role::curve, 0.8, Marker::Shape::square));
}

void ViewportBuilder::find_shown() {
  const auto& all = samples_.drawables;
  const auto end = std::ranges::upper_bound(all, step_, {}, &Drawable::born);
  for (auto d = all.begin(); d != end; ++d) {
    if (!d->given && step_ >= d->gone && !read_now(d->value)) continue;
    if (surface_done_ && (!in_net(*d) || d->phase != absent)) continue;
    if (surface_done_ && !options_.surface_net && !made_now(d->value)) continue;
    shown_.push_back(&*d);
  }
  if (shown_.size() > most_points) thin_out();
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
    if (rows ? d->draw == ValueSpec::Draw::point : !in_net(*d)) continue;
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
    if (run.size() > 1) view_.polylines.push_back(line(run, role, width));
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
    const bool now = made_now(d.value), loud = now && single_;
    const glm::dvec3 at = place(d.value);
    double size = surface_done_ && !loud ? 0.6 * size_ : size_;
    if (now && !division_) size *= motion_;
    if (read_now(d.value) && single_ && !now)
      view_.markers.push_back(marker(at, Role::operand, 1.7 * size_, Marker::Shape::ring));
    view_.markers.push_back(marker(at, loud ? Role::current : role_of(d), size));
    if (options_.emphasis.lights(d.value)) add_ring(at, 1);
    add_name(d, i, new_count > most_labels);
  }
}

void ViewportBuilder::add_name(const Drawable& d, std::size_t position, bool many_new) {
  const ValueId v = d.value;
  const bool now = made_now(v), loud = now && single_, read = read_now(v) && single_;
  const bool lit = options_.emphasis.lights(v);
  if (now && motion_ < 0.5) return;
  if (!lit) {
    if (!options_.labels || surface_done_ || (many_new && now)) return;
    if (!now && !read && (shown_.size() > most_labels || !is_around(d))) return;
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
  label.optional = !lit && !now && !read;
  view_.labels.push_back(std::move(label));
}

// Rings around what the lit value came from: the larger, the more it weighs.
void ViewportBuilder::add_shares() {
  struct Share {
    glm::dvec3 at;
    double share;
  };
  std::vector<Share> shares;
  for (const auto& [v, share] : options_.emphasis.shares) {
    if (!(std::abs(share) >= least_share) || options_.emphasis.lights(v)) continue;
    if (v >= graph_.value_count() || graph_.value(v).step > step_) continue;
    const auto d = std::ranges::lower_bound(samples_.drawables, v, {}, &Drawable::value);
    if (d != samples_.drawables.end() && d->value == v && is_around(*d)) shares.push_back({place(v), share});
  }
  std::ranges::stable_sort(shares,
                           [](const Share& a, const Share& b) { return std::abs(a.share) > std::abs(b.share); });
  // Values that stand at one place (a point that a step only carries over) are one ring.
  std::vector<Share> kept;
  for (const Share& share : shares) {
    if (kept.size() == most_shares) break;
    if (std::ranges::none_of(kept, [&](const Share& other) { return other.at == share.at; })) kept.push_back(share);
  }
  for (const Share& share : kept) {
    add_ring(share.at, 0.5 + 0.9 * std::sqrt(std::min(std::abs(share.share), 1.0)));
    if (kept.size() > most_share_texts) continue;
    Label label;
    label.anchor = share.at;
    label.text = {{format_short(share.share, 3)}};
    label.role = Role::text_quiet;
    label.size_scale = 0.9;
    label.placement = Label::Placement::around;
    label.priority = 25;
    label.optional = true;
    view_.labels.push_back(std::move(label));
  }
}

// What is lit although it is not of this step: retired, or of another phase.
void ViewportBuilder::add_lit_elsewhere() {
  for (const ValueId v : options_.emphasis.lit) {
    if (v >= graph_.value_count() || graph_.value(v).step > step_ || !source_.points[v]) continue;
    if (std::ranges::binary_search(shown_, v, {}, [](const Drawable* d) { return d->value; })) continue;
    add_ring(*source_.points[v], 1);
    Label label;
    label.anchor = *source_.points[v];
    label.text = typeset_name(graph_.value(v).name, source_.algorithm_at(graph_.value(v).step));
    for (TextRun& run : label.text) run.bold = true;
    label.role = Role::text_quiet;
    label.placement = Label::Placement::around;
    label.priority = 40;
    view_.labels.push_back(std::move(label));
  }
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
    const std::string other = other_share(d.share, d.a);
    if (d.a > 0) label(d.A, M, d.swapped ? other : d.share);
    if (d.a < 1) label(M, d.B, d.swapped ? d.share : other);
    return;
  }
  // Extrapolation: M lies on the line beyond one of them.
  view_.polylines.push_back(line({d.A, d.B}, Role::ratio_near));
  if (d.a > 1 && d.a * motion_ <= 1) return;  // still on its way between them
  view_.polylines.push_back(line({d.a > 1 ? d.B : d.A, M}, Role::ratio_far, 1, true));
}

void ViewportBuilder::add_spots() {
  const Lens lens(view_.camera, {view_.width, view_.height});
  std::vector<std::pair<double, Spot>> found;
  for (const Drawable* d : shown_) {
    const auto at = lens(place(d->value));
    if (!at || !(at->x >= 0 && at->x <= view_.width && at->y >= 0 && at->y <= view_.height)) continue;
    found.push_back({at->z,
                     {{Link::Kind::value, d->value},
                      at->x - spot_size / 2,
                      at->y - spot_size / 2,
                      spot_size,
                      spot_size,
                      graph_.name(d->value)}});
  }
  if (view_.camera.kind == Camera::Kind::orbit)
    std::ranges::stable_sort(found, {}, [](const auto& entry) { return entry.first; });
  sheet_.spots.reserve(found.size());
  for (auto& [z, spot] : found) sheet_.spots.push_back(std::move(spot));
}

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
