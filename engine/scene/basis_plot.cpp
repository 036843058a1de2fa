#include <algorithm>
#include <cmath>
#include <span>

#include "kernel/basis.hpp"
#include "scene/panel_parts.hpp"
#include "scene/panels.hpp"

namespace blossom {
namespace {

using parts::Box;

constexpr double top_room = 18, bottom_room = 18;  // for labels at the peaks; for "sum = 1"
constexpr double label_size = 0.8, value_size = 0.74;
constexpr double bar_width = 18, bar_gap = 12;
constexpr double units_per_sample = 3;
constexpr int most_halvings = 8;         // of the way between two samples of a rational function
constexpr double seen_bend = 0.15;       // in units
constexpr std::size_t most_labels = 24;  // of more functions only those that count at u have names
constexpr std::size_t few_labels = 12;   // may stand farther from their peaks
constexpr double least_share = 0.0005;   // of a part of the bar that is labelled
constexpr double least_peak = 0.02;      // of a function that is labelled

// The basis functions of a curve on the axis of its knots.
class BasisFunctions {
 public:
  explicit BasisFunctions(const Curve<double>& curve) : curve_(&curve), p_(curve.degree) {
    // With more knots at both ends, every nonempty span has p + 1 functions, and the ones there are stay the same.
    const double step = (curve.knots.back() - curve.knots.front()) / static_cast<double>(curve.knots.size());
    for (int i = p_ + 1; i >= 1; --i) knots_.push_back(curve.knots.front() - i * step);
    knots_.insert(knots_.end(), curve.knots.begin(), curve.knots.end());
    for (int i = 1; i <= p_ + 1; ++i) knots_.push_back(curve.knots.back() + i * step);
    values_.resize(static_cast<std::size_t>(p_) + 1);
  }

  int count() const { return curve_->n() + 1; }

  // N_{k-p..k} at u (R of a rational curve), with index 0 for k - p; those that are no functions of the curve are 0.
  const std::vector<double>& at(int k, double u) {
    basis_functions<double>(knots_, p_, k + p_ + 1, u, values_);
    double sum = 0;
    for (int r = 0; r <= p_; ++r) {
      const int i = k - p_ + r;
      auto& value = values_[static_cast<std::size_t>(r)];
      if (i < 0 || i >= count())
        value = 0;
      else if (curve_->rational)
        value *= curve_->points[static_cast<std::size_t>(i)].w;
      sum += value;
    }
    if (curve_->rational)
      for (double& value : values_) value /= sum;
    return values_;
  }

 private:
  const Curve<double>* curve_;
  int p_;
  std::vector<double> knots_, values_;
};

struct Function {
  int index = 0;
  std::vector<glm::dvec3> points;
  double peak = -1, peak_at = 0;  // value and parameter
  std::optional<double> value;    // at u, if it is not zero there
  RichText name;
};

struct Plot {
  KnotAxis axis;
  double top = 0, bottom = 0;
  double place(double value) const { return bottom + (top - bottom) * value; }
};

RichText name_of(const Curve<double>& curve, int i) {
  return {{curve.rational ? "R"
           : curve.bezier ? "B"
                          : "N",
           TextRun::Level::base, true},
          {std::to_string(i) + "," + std::to_string(curve.degree), TextRun::Level::sub}};
}

// The values of the functions of a span.
struct Sample {
  double u;
  std::vector<double> values;
  Sample(double at, int k, BasisFunctions& basis) : u(at), values(basis.at(k, at)) {}
};

// Adds samples between the last one and the next, until straight lines between them are what a curve looks like.
void refine(std::vector<Sample>& samples, const Sample& next, int halvings, const Plot& plot, int k,
            BasisFunctions& basis) {
  if (halvings == 0) return;
  const Sample& last = samples.back();
  const double u = (last.u + next.u) / 2;
  if (!(last.u < u) || !(u < next.u)) return;
  const Sample between(u, k, basis);
  double bend = 0;
  for (std::size_t r = 0; r < between.values.size(); ++r)
    bend = std::max(bend, std::abs(between.values[r] - (last.values[r] + next.values[r]) / 2));
  if (!(bend * (plot.bottom - plot.top) > seen_bend)) return;
  refine(samples, between, halvings - 1, plot, k, basis);
  samples.push_back(between);
  refine(samples, next, halvings - 1, plot, k, basis);
}

// Polylines of all functions, span by span: on each span p + 1 of them at once.
std::vector<Function> sampled(const Curve<double>& curve, const Plot& plot, BasisFunctions& basis) {
  std::vector<Function> functions(static_cast<std::size_t>(basis.count()));
  for (std::size_t i = 0; i < functions.size(); ++i) functions[i].index = static_cast<int>(i);
  const int p = curve.degree;
  // A rational function is a share of the sum of all, and outside of the domain not all are there.
  const int first = curve.rational ? p : 0;
  const int last = curve.rational ? curve.n() : curve.m() - 1;
  for (int k = first; k <= last; ++k) {
    const double from = curve.knots[static_cast<std::size_t>(k)], to = curve.knots[static_cast<std::size_t>(k) + 1];
    if (!(from < to)) continue;
    const double width = plot.axis.place(to) - plot.axis.place(from);
    const int pieces = std::clamp(static_cast<int>(width / units_per_sample), 4, 64);
    // Large weights make functions steep: there are more samples where one of them bends.
    std::vector<Sample> samples;
    for (int s = 0; s <= pieces; ++s) {
      Sample next(s == pieces ? to : from + (to - from) * s / pieces, k, basis);
      if (curve.rational && s > 0) refine(samples, next, most_halvings, plot, k, basis);
      samples.push_back(std::move(next));
    }
    for (const auto& [u, values] : samples) {
      for (int r = 0; r <= p; ++r) {
        const int i = k - p + r;
        const double value = values[static_cast<std::size_t>(r)];
        if (i < 0 || i >= basis.count() || !std::isfinite(value)) continue;
        Function& f = functions[static_cast<std::size_t>(i)];
        f.points.push_back({plot.axis.place(u), plot.place(std::clamp(value, -0.06, 1.06)), 0});
        if (value > f.peak) {
          f.peak = value;
          f.peak_at = u;
        }
      }
    }
  }
  return functions;
}

// The control point of each function, to know whether it is lit; absent where there is none.
std::vector<ValueId> control_points(const StepSource& source, std::size_t curve, std::size_t count) {
  std::vector<ValueId> found(count, absent);
  const TraceGraph& graph = *source.graph;
  const auto [begin, end] = graph.values_of(0);
  for (ValueId v = begin; v < end; ++v) {
    const ValueRecord& record = graph.value(v);
    if (record.kind != ValueKind::point || record.rule != nullptr || record.name.arity == 0) continue;
    if (source.curves.size() > 1 && record.name.index[0] != static_cast<int>(curve)) continue;
    if (const auto i = static_cast<std::size_t>(record.name.index[record.name.arity - 1]); i < count) found[i] = v;
  }
  return found;
}

void add_spot(Sheet& sheet, const Box& box, int i, const std::string& name) {
  for (const Spot& other : sheet.spots)
    if (box.meets({other.x, other.y, other.width, other.height})) return;
  sheet.spots.push_back(
      {{Link::Kind::basis, static_cast<std::uint32_t>(i)}, box.x, box.y, box.width, box.height, name});
}

// Where a name may stand, from its peak downwards.
constexpr double beside_peak[] = {-5, -17, 15, 27, -29, 39};

// A name at each peak that has room for it, beside the markers at u (`taken`): those that count at u first.
void add_labels(Sheet& sheet, const std::vector<Function>& functions, const Plot& plot, bool with_u, double left,
                double right, std::vector<Box> taken) {
  const bool many = functions.size() > most_labels;
  std::vector<const Function*> order;
  for (const Function& f : functions)
    if (f.peak > least_peak && (f.value || !with_u || !many)) order.push_back(&f);
  std::ranges::stable_sort(order, {}, [](const Function* f) { return !f->value; });
  for (const Function* f : order) {
    const Role role = f->value || !with_u ? Role::text : Role::text_quiet;
    const double size = label_size;
    const double width = parts::width_of(f->name, role, size);
    const double x = std::clamp(plot.axis.place(f->peak_at), left + width / 2, right - width / 2);
    const double peak = plot.place(std::min(f->peak, 1.06));
    for (const double below : std::span(beside_peak, order.size() <= few_labels ? 6 : 2)) {
      const Box box{x - width / 2, peak + below - 10, width, 14};
      if (box.y < plot.top - top_room || box.bottom() > plot.bottom) continue;
      if (std::ranges::any_of(taken, [&](const Box& other) { return box.meets(other, 1); })) continue;
      taken.push_back(box);
      parts::text(sheet.view, x, peak + below, f->name, role, size, Label::Placement::centre);
      add_spot(sheet, box, f->index, "basis " + std::to_string(f->index));
      break;
    }
  }
}

// The fourth role is drawn wide, the fifth wider, elsewhere; here all lines are alike.
double width_of(bool quiet, int i) {
  const int look = i % parts::cycle_length;
  return quiet || look < 3 ? 1 : (look == 3 ? 0.62 : 0.42);
}

// Told apart without colour as well: full, or with lines across or along, dashed like the curve.
void pattern(View& view, const Box& box, int i) {
  const Role role = parts::cycle(i);
  const int look = i % parts::cycle_length;
  parts::fill(view, box, role, look == 0 || look == 3 ? 0.5 : 0.15);
  if (look == 1 || look == 4)
    for (double at = box.y + 4; at < box.bottom(); at += 5)
      parts::stroke(view, {{box.x, at, 0}, {box.right(), at, 0}}, role, 0.5);
  if (look == 2 || look == 4)
    for (double at = box.x + 4.5; at < box.right(); at += 4.5)
      parts::stroke(view, {{at, box.y, 0}, {at, box.bottom(), 0}}, role, 0.5);
  parts::stroke(view, {{box.x, box.y, 0}, {box.right(), box.y, 0}}, Role::text, 0.7);
}

// The values at u, piled up: together they are 1.
void add_bar(Sheet& sheet, const std::vector<Function>& functions, const Plot& plot, double x, double right) {
  struct Segment {
    const Function* f;
    double middle, label;
  };
  View& view = sheet.view;
  std::vector<Segment> segments;
  double sum = 0, piled = 0;
  for (const Function& f : functions) {
    if (!f.value) continue;
    sum += *f.value;
    if (*f.value <= 0) continue;  // a negative share, of a negative weight, has no height
    const Box box{x, plot.place(std::min(piled + *f.value, 1.0)), bar_width, 0};
    const double foot = plot.place(std::min(piled, 1.0));
    piled += *f.value;
    Box segment = box;
    segment.height = foot - box.y;
    pattern(view, segment, f.index);
    if (segment.height >= 3) add_spot(sheet, segment, f.index, "basis " + std::to_string(f.index) + " at u");
    if (*f.value >= least_share) segments.push_back({&f, segment.y + segment.height / 2, 0});
  }
  parts::outline(view, {x, plot.top, bar_width, plot.bottom - plot.top}, Role::text, 0.8);
  parts::text(view, x, plot.bottom + 13, {{"sum = " + format_short(sum, 3)}}, Role::text_quiet, value_size);

  // Labels beside their parts, as near as they can stand; the smallest parts go without when there are too many.
  constexpr double pitch = 12;
  const auto room = static_cast<std::size_t>((plot.bottom - plot.top) / pitch);
  while (segments.size() > room)
    segments.erase(std::ranges::min_element(segments, {}, [](const Segment& s) { return *s.f->value; }));
  double below = plot.bottom + pitch / 2;  // segments come from below
  for (Segment& s : segments) below = s.label = std::min(s.middle, below - pitch);
  double above = plot.top - pitch / 2;
  for (auto s = segments.rbegin(); s != segments.rend(); ++s) above = s->label = std::max(s->label, above + pitch);
  for (const Segment& s : segments) {
    RichText words = s.f->name;
    words.push_back({" " + format_short(*s.f->value, 3)});
    const double size = parts::size_to_fit(parts::ems(words), Role::text, right - x - bar_width - 5, value_size);
    parts::text(view, x + bar_width + 5, s.label + 4, std::move(words), Role::text, size);
  }
}

}  // namespace

double add_basis(Sheet& sheet, const StepSource& source, std::uint32_t, const Emphasis& emphasis, double x, double y,
                 double width, double height, std::size_t which, bool at_u) {
  const auto axis = knot_axis(source, which, x, width - basis_bar_room);
  if (!axis || axis->right <= axis->left || height < top_room + bottom_room + 20) return 0;
  const auto& curve = source.curves[which];
  View& view = sheet.view;
  const Plot plot{*axis, y + top_room, y + height - bottom_room};
  const bool u = at_u && source.curves.size() == 1 && source.parameter.has_value();

  BasisFunctions basis(curve);
  auto functions = sampled(curve, plot, basis);
  const double at = u ? *source.parameter : curve.domain_begin();
  if (u && at >= curve.domain_begin() && at <= curve.domain_end()) {
    const int k = find_span<double>(curve.knots, curve.degree, at);
    const auto& values = basis.at(k, at);
    for (int r = 0; r <= curve.degree; ++r)
      if (const double value = values[static_cast<std::size_t>(r)]; std::abs(value) > 1e-12 && std::isfinite(value))
        functions[static_cast<std::size_t>(k - curve.degree + r)].value = value;
  }
  for (Function& f : functions) f.name = name_of(curve, f.index);

  const double begin = axis->place(curve.domain_begin()), end = axis->place(curve.domain_end());
  parts::fill(view, {begin, plot.top, end - begin, plot.bottom - plot.top}, Role::panel);
  for (const double value : {0.0, 0.5, 1.0}) {
    parts::stroke(view, {{axis->left, plot.place(value), 0}, {axis->right, plot.place(value), 0}},
                  value == 0 ? Role::axis : Role::grid);
    parts::text(view, axis->left - 6, plot.place(value) + 4, {{format_short(value, 1)}}, Role::text_quiet, value_size,
                Label::Placement::right);
  }
  const auto points = control_points(source, which, functions.size());
  for (std::size_t i = 0; i < functions.size(); ++i) {
    if (functions[i].points.size() < 2) continue;
    const bool lit = points[i] != absent && emphasis.lights(points[i]);
    if (lit) parts::stroke(view, functions[i].points, Role::highlight, 0.75);
  }
  for (const bool loud : {false, true})
    for (Function& f : functions) {
      if (f.points.size() < 2 || (u && f.value) != loud) continue;
      const bool quiet = u && !loud;
      parts::stroke(view, std::move(f.points), quiet ? Role::earlier : parts::cycle(f.index),
                    (loud || functions.size() <= most_labels ? 1 : 0.6) * width_of(quiet, f.index),
                    !quiet && f.index % parts::cycle_length == 4);
    }
  if (u) {
    parts::stroke(view, {{axis->place(at), plot.top, 0}, {axis->place(at), plot.bottom, 0}}, Role::current, 0.4);
    const double dot = curve.degree > 8 ? 0.6 : 1;  // many lie close together
    for (const Function& f : functions)
      if (f.value)
        view.markers.push_back({{axis->place(at), plot.place(std::clamp(*f.value, -0.06, 1.06)), 0},
                                parts::cycle(f.index),
                                Marker::Shape::disc,
                                dot});
    add_bar(sheet, functions, plot, axis->right + bar_gap, x + width - 2);
  }
  std::vector<Box> dots;
  if (u)
    for (const Function& f : functions)
      if (f.value) dots.push_back({axis->place(at) - 5, plot.place(std::clamp(*f.value, -0.06, 1.06)) - 5, 10, 10});
  add_labels(sheet, functions, plot, u, axis->left - 2, axis->right + 6, std::move(dots));
  return height;
}

}  // namespace blossom
