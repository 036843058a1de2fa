#include <algorithm>
#include <cmath>

#include "algorithms/typeset.hpp"
#include "scene/knot_parts.hpp"
#include "scene/panels.hpp"

namespace blossom {
namespace {

using parts::Box;
using parts::Knot;

constexpr double margin = 40;                                        // left and right of the axis
constexpr double line_at = knot_line_at, height = knot_line_height;  // of the line in the panel; of the panel
constexpr double result_at = 63;                                     // of the second line in the panel

// The values U[i] of a curve, or U[l][i] of several: they are given at the first step.
std::vector<ValueId> knot_values(const StepSource& source, std::size_t curve, std::size_t count) {
  std::vector<ValueId> found(count, absent);
  const TraceGraph& graph = *source.graph;
  const int arity = source.curves.size() > 1 ? 2 : 1;
  const auto [begin, end] = graph.values_of(0);
  for (ValueId v = begin; v < end; ++v) {
    const Name& name = graph.value(v).name;
    if (!(name.symbol == Symbol::of("U")) || name.arity != arity) continue;
    if (arity == 2 && name.index[0] != static_cast<int>(curve)) continue;
    if (const auto i = static_cast<std::size_t>(name.index[arity - 1]); i < count) found[i] = v;
  }
  return found;
}

ValueId given_u(const StepSource& source) {
  const auto [begin, end] = source.graph->values_of(0);
  for (ValueId v = begin; v < end; ++v)
    if (source.graph->value(v).name == "u"_v()) return v;
  return absent;
}

// A fraction with a small denominator that is this number; empty: there is none.
std::string small_fraction(double value) {
  constexpr int largest = 16;
  for (int n = 1; n <= largest && std::abs(value) < 1e6; ++n) {
    const double over = std::nearbyint(value * n);
    if (std::abs(value * n - over) > 1e-12 * std::max(1.0, std::abs(over))) continue;
    return format_short(over, 0) + (n > 1 ? "/" + std::to_string(n) : "");
  }
  return {};
}

// The number as the run writes it (1/4, not 0.25), if that is short. Of knots that are no values of the run likewise.
std::string number(const StepSource& source, ValueId v, double value) {
  std::string exact = v != absent ? source.value_text(v) : source.exact ? small_fraction(value) : std::string();
  return exact.empty() || exact.size() > 8 ? format_short(value, 4) : exact;
}

// The input that the knots on the first line belong to, where the run has made knots of the same name.
std::string owner(const StepSource& source, ValueId made) {
  if (made == absent || !(source.graph->value(made).name == "U"_v())) return {};
  const auto& inputs = source.algorithm->inputs;
  const auto curve = std::ranges::find(inputs, InputSpec::Type::curve, &InputSpec::type);
  return curve != inputs.end() ? std::string(curve->name) : std::string();
}

// The span k, once it is known.
std::optional<std::size_t> span_of(const StepSource& source, std::uint32_t step) {
  const TraceGraph& graph = *source.graph;
  if (source.algorithm->spec("k"_v()) == nullptr) return std::nullopt;
  for (ValueId v = 0; v < graph.value_count() && graph.value(v).step <= step; ++v)
    if (graph.value(v).name == "k"_v() && graph.scope(v).empty()) return static_cast<std::size_t>(source.scalars[v]);
  return std::nullopt;
}

// What a ratio measures: u between two knots.
void add_ratio(View& view, const StepSource& source, std::uint32_t step, const KnotAxis& axis, double line) {
  const ValueId main = source.graph->main_value(step);
  if (main == absent || source.graph->value(main).rule != &rule_info<Ratio> || !source.graph->scope(main).empty())
    return;
  const auto from = source.graph->operands(main);
  const double u = axis.place(source.scalars[from[0]]);
  const double a = axis.place(source.scalars[from[1]]);
  const double b = axis.place(source.scalars[from[2]]);
  parts::stroke(view, {{a, line - 6, 0}, {b, line - 6, 0}}, Role::ratio_far);
  parts::stroke(view, {{a, line - 6, 0}, {u, line - 6, 0}}, Role::ratio_near);
}

// The texts of a list "(0, 1/2, 1)".
std::vector<std::string> elements(std::string_view list) {
  std::vector<std::string> found;
  list = list.substr(1, list.size() - 2);
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find(", ", at), list.size());
    found.emplace_back(list.substr(at, end - at));
    at = end + 2;
  }
  return found;
}

// The knot vector of the result, over the same axis.
void add_result(Sheet& sheet, const StepSource& source, ValueId v, const Emphasis& emphasis, const KnotAxis& axis,
                double x, double y, double width) {
  View& view = sheet.view;
  const double line = y + result_at;
  const std::vector<double> values = source.raw(v);
  const std::vector<std::string> texts = elements(source.value_text(v));
  const ValueRecord& record = source.graph->value(v);
  const bool lit = emphasis.lights(v), now = source.graph->main_value(record.step) == v;
  parts::text(view, x, line + 4, typeset_name(record.name, source.algorithm_at(record.step)),
              lit ? Role::highlight : Role::text_quiet, 0.9);
  parts::stroke(view, {{axis.left, line, 0}, {axis.right, line, 0}}, now ? Role::polygon : Role::rule_line);
  std::vector<Knot> knots;
  for (std::size_t i = 0; i < values.size(); i += knots.back().count) {
    Knot knot{i, 1, axis.place(values[i]), {}};
    while (i + knot.count < values.size() && values[i + knot.count] == values[i]) ++knot.count;
    const bool is_short = i < texts.size() && texts[i].size() <= 8;
    knot.label = parts::knot_label(is_short ? texts[i] : format_short(values[i], 4), knot.count);
    view.markers.push_back(
        {{knot.at, line, 0}, lit ? Role::highlight : Role::control_point, Marker::Shape::triangle, 0.9});
    knots.push_back(std::move(knot));
  }
  parts::set_knot_labels(view, knots, line, x, x + width, 1);
  sheet.spots.push_back(
      {{Link::Kind::value, v}, x, line - 7, width, y + knot_lines_height - line + 7, source.graph->name(v)});
}

}  // namespace

ValueId resulting_knots(const StepSource& source, std::uint32_t step) {
  const TraceGraph& graph = *source.graph;
  if (source.curves.size() != 1 || graph.step_count() == 0) return absent;
  const auto& knots = source.curves[0].knots;
  for (ValueId v = graph.values_of(std::min(step, graph.step_count() - 1)).second; v-- > 0;) {
    const ValueRecord& record = graph.value(v);
    if (record.kind != ValueKind::list || record.rule == nullptr || !graph.scope(v).empty()) continue;
    const std::vector<double> made = source.raw(v);
    if (!made.empty() && made.front() >= knots.front() && made.back() <= knots.back()) return v;
  }
  return absent;
}

std::optional<KnotAxis> knot_axis(const Curve<double>& curve, double x, double width) {
  const auto& knots = curve.knots;
  if (knots.empty() || !(knots.front() < knots.back())) return std::nullopt;
  return KnotAxis{knots.front(), knots.back(), x + margin, x + width - margin};
}

std::optional<KnotAxis> knot_axis(const StepSource& source, std::size_t curve, double x, double width) {
  if (curve >= source.curves.size()) return std::nullopt;
  return knot_axis(source.curves[curve], x, width);
}

double add_knot_line(Sheet& sheet, const StepSource& source, std::uint32_t step, const Emphasis& emphasis, double x,
                     double y, double width, std::size_t which, bool always, bool result) {
  const auto axis = knot_axis(source, which, x, width);
  if (!axis || (source.curves[which].bezier && !always)) return 0;
  const auto& curve = source.curves[which];
  View& view = sheet.view;
  const double line = y + line_at;
  const ValueId made = result ? resulting_knots(source, step) : absent;
  const std::string of = owner(source, made);
  parts::text(view, x, line + 4, of.empty() ? RichText{{"U", TextRun::Level::base, true}} : RichText{{of}},
              Role::text_quiet, of.empty() ? 0.9 : 0.72);
  parts::stroke(view, {{axis->left, line, 0}, {axis->right, line, 0}}, Role::rule_line);
  parts::stroke(view, {{axis->place(curve.domain_begin()), line, 0}, {axis->place(curve.domain_end()), line, 0}},
                Role::polygon);
  if (const auto k = span_of(source, step); k && *k + 1 < curve.knots.size())
    parts::stroke(view, {{axis->place(curve.knots[*k]), line, 0}, {axis->place(curve.knots[*k + 1]), line, 0}},
                  Role::current);

  const auto values = knot_values(source, which, curve.knots.size());
  std::vector<Knot> knots;
  for (std::size_t i = 0; i < curve.knots.size(); i += knots.back().count) {
    Knot knot{i, 1, axis->place(curve.knots[i]), {}};
    while (i + knot.count < curve.knots.size() && curve.knots[i + knot.count] == curve.knots[i]) ++knot.count;
    knot.label = parts::knot_label(number(source, values[i], curve.knots[i]), knot.count);
    bool lit = false;
    for (std::size_t j = i; j < i + knot.count; ++j) lit = lit || (values[j] != absent && emphasis.lights(values[j]));
    if (lit) view.markers.push_back({{knot.at, line, 0}, Role::highlight, Marker::Shape::ring, 1});
    view.markers.push_back({{knot.at, line, 0}, Role::control_point, Marker::Shape::triangle, 0.9});
    knots.push_back(std::move(knot));
  }
  parts::set_knot_labels(view, knots, line, x, x + width, made == absent ? 2 : 1);
  if (made != absent) add_result(sheet, source, made, emphasis, *axis, x, y, width);
  add_ratio(view, source, step, *axis, line);

  std::optional<Box> handle;
  if (source.parameter && source.curves.size() == 1) {
    const double at = axis->place(*source.parameter);
    view.markers.push_back({{at, line, 0}, Role::current, Marker::Shape::diamond, 1});
    RichText words{{"u", TextRun::Level::base, true}, {" = " + number(source, given_u(source), *source.parameter)}};
    const double half = parts::width_of(words, Role::text_current, 0.85) / 2;
    const double middle = std::clamp(at, x + half, std::max(x + half, x + width - half));
    Label& label =
        parts::text(view, middle, line - 12, std::move(words), Role::text_current, 0.85, Label::Placement::centre);
    label.priority = 10;
    handle = Box{at - 9, y, 18, line_at + parts::knot_reach};
  }
  parts::add_knot_spots(sheet, knots, handle, y + height, line);
  return made == absent ? height : knot_lines_height;
}

}  // namespace blossom
