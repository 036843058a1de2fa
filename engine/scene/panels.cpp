#include "scene/panels.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "scene/typeset.hpp"

namespace blossom {
namespace {

void fill(View& view, double x, double y, double width, double height, Role role, double opacity = 1) {
  view.polygons.push_back(
      {{{x, y, 0}, {x + width, y, 0}, {x + width, y + height, 0}, {x, y + height, 0}}, role, opacity});
}

Label& text(View& view, double x, double y, RichText runs, Role role, double size = 1) {
  Label label;
  label.anchor = {x, y, 0};
  label.text = std::move(runs);
  label.role = role;
  label.size_scale = size;
  view.labels.push_back(std::move(label));
  return view.labels.back();
}

double heading(View& view, double x, double y, const std::string& words) {
  text(view, x, y + 12, {{words, TextRun::Level::base, false, true}}, Role::text_quiet, 0.85);
  return 22;
}

// How many lines a text takes at a width, in characters of about half an em: enough to reserve space. Lines that are
// broken at blanks are about seven eighths full.
int lines_of(std::size_t characters, double width, double size) {
  const double per_line = std::max(8.0, width / (size * 0.6));
  const auto count = static_cast<double>(characters);
  return count <= per_line ? 1 : static_cast<int>(std::ceil(count / (per_line * 0.875)));
}

std::size_t characters(const RichText& runs) {
  std::size_t count = 0;
  for (const TextRun& run : runs) count += run.text.size();
  return count;
}

}  // namespace

double add_pseudo_code(View& view, const StepSource& source, std::uint32_t step, double x, double y, double width) {
  const Algorithm& algorithm = source.algorithm_at(step);
  const int current = source.line(step);
  double at = y + heading(view, x, y, std::string(algorithm.title));
  const double row = 20;
  std::size_t longest = 1;
  for (const auto line : algorithm.pseudo_code) longest = std::max(longest, line.size());
  const double size =
      std::min(0.86, (width - 26) / (static_cast<double>(longest) * 14 * 0.69));  // of a theme with larger text, too
  if (size < 0.55) {  // too small to read: only the line that counts, wrapped
    if (current == 0) return at - y;
    const std::string_view code = algorithm.pseudo_code[static_cast<std::size_t>(current) - 1];
    const std::string line(code.substr(code.find_first_not_of(' ')));
    const double height = 18 * lines_of(line.size(), width, 14 * 0.78) + 4;
    fill(view, x - 6, at, width + 12, height, Role::current, 0.18);
    text(view, x, at + 14, {{line, TextRun::Level::base, false, true, true}}, Role::text, 0.72).max_width = width;
    return at - y + height + 12;
  }
  for (std::size_t i = 0; i < algorithm.pseudo_code.size(); ++i) {
    const bool here = static_cast<int>(i) + 1 == current;
    if (here) {
      fill(view, x - 6, at, width + 12, row, Role::current, 0.18);
      fill(view, x - 6, at, 3, row, Role::current);
    }
    text(view, x + 14, at + 14, {{std::to_string(i + 1), TextRun::Level::base, false, false, true}}, Role::text_quiet,
         size)
        .placement = Label::Placement::right;
    text(view, x + 22, at + 14, {{std::string(algorithm.pseudo_code[i]), TextRun::Level::base, false, here, true}},
         Role::text, size);
    at += row;
  }
  return at - y + 12;
}

double add_formula(View& view, const StepSource& source, std::uint32_t step, double x, double y, double width,
                   double height) {
  const ValueId v = source.graph->main_value(step);
  if (v == absent || source.graph->is_input(v)) return 0;
  const Algorithm& algorithm = source.algorithm_at(step);
  double at = y + heading(view, x, y, "This step");
  const auto shortened = [](std::string words) {
    const std::size_t most = 220;  // a knot vector of hundreds of knots is not for this box
    return words.size() <= most ? words : words.substr(0, most) + " ...";
  };
  const std::string formula = source.formula(v);
  const std::string numbers = source.numbers(v);
  const std::string value = shortened(source.value_text(v));

  RichText result = typeset_name(source.graph->value(v).name, algorithm);
  result.push_back({" = " + value});
  const std::size_t letters = characters(result) + 2;
  const double size = lines_of(letters, width, 14 * 1.05) > 2 ? 0.85 : 1.05;
  text(view, x, at + 15, std::move(result), Role::text_current, size).max_width = width;
  at += 21 * size * lines_of(letters, width, 15.7 * size) + 4;

  // One label, so that its lines cannot run into each other however they wrap.
  std::vector<std::string> parts{"= " + shortened(formula)};
  if (numbers != formula && numbers != source.value_text(v)) parts.push_back("= " + shortened(numbers));
  if (const std::string polar = source.polar(v); !polar.empty()) parts.push_back("blossom value " + polar);
  std::string from;
  const double from_at = at;
  for (const std::string& part : parts) {
    const double needed = 19 * lines_of(part.size(), width, 14 * 0.9);
    if (at + needed > y + height) break;
    from += (from.empty() ? "" : "\n") + part;
    at += needed;
  }
  if (!from.empty()) text(view, x, from_at + 14, typeset_text(from, algorithm), Role::text, 0.9).max_width = width;
  return at - y + 12;
}

double add_tableau(View& view, const StepSource& source, std::uint32_t step, double x, double y, double width,
                   double height) {
  const TraceGraph& graph = *source.graph;
  std::map<int, std::map<int, ValueId>>
      columns;  // level -> index -> value; of the whole trace, so the frame stands still
  std::set<int> rows;
  for (ValueId v = 0; v < graph.value_count(); ++v) {
    const Name& name = graph.value(v).name;
    const ValueSpec* spec = source.algorithm->spec(name);
    if (spec == nullptr || !spec->tableau || name.arity == 0 || !graph.scope(v).empty()) continue;
    columns[name.arity == 2 ? name.index[0] : 0][name.index[name.arity - 1]] = v;  // P[i] is level 0
  }
  if (columns.size() < 2) return 0;
  // Control points that no later level reads are not part of the triangle.
  std::set<ValueId> read;
  for (const auto& [level, cells] : columns)
    for (const auto& [i, v] : cells)
      for (const ValueId o : graph.operands(v)) read.insert(o);
  for (const auto& [level, cells] : columns)
    for (const auto& [i, v] : cells)
      if (level > 0 || read.contains(v)) rows.insert(i);

  const double cell_width = width / static_cast<double>(columns.size());
  const double row_height = std::min(38.0, (height - 30) / static_cast<double>(rows.size()));
  if (cell_width < 34 || row_height < 15) return 0;
  double at = y + heading(view, x, y, "Triangular scheme");
  const bool values = cell_width >= 64 && row_height >= 30;

  std::map<ValueId, glm::dvec2> centre;
  const ValueId made_by_step = graph.main_value(step);
  const ValueId main = made_by_step != absent && graph.is_input(made_by_step) ? absent : made_by_step;
  std::set<ValueId> operands;
  if (main != absent)
    for (const ValueId o : graph.operands(main)) operands.insert(o);
  const auto row_of = [&](int i) { return static_cast<double>(std::distance(rows.begin(), rows.find(i))); };
  int column = 0;
  for (const auto& [level, cells] : columns) {
    for (const auto& [i, v] : cells) {
      if (!rows.contains(i) || (level == 0 && !read.contains(v))) continue;
      // Each level stands between the points it comes from, as on a blackboard.
      double middle = row_of(i);
      int points = 0;
      double sum = 0;
      for (const ValueId o : graph.operands(v))
        if (const auto it = centre.find(o); it != centre.end()) {
          sum += it->second.y;
          ++points;
        }
      const double cy = points > 0 ? sum / points : at + (middle + 0.5) * row_height;
      centre[v] = {x + (column + 0.5) * cell_width, cy};
    }
    ++column;
  }
  for (const auto& [v, c] : centre) {
    const bool made = graph.value(v).step <= step;
    const bool current = v == main;
    for (const ValueId o : graph.operands(v))
      if (const auto it = centre.find(o); it != centre.end()) {
        Polyline arrow;
        arrow.points = {{it->second.x + cell_width * 0.36, it->second.y, 0}, {c.x - cell_width * 0.36, c.y, 0}};
        arrow.role = current ? Role::current : Role::rule_line;
        if (current) arrow.width_scale = 0.5;
        if (made) view.polylines.push_back(std::move(arrow));
      }
    const double w = cell_width * 0.72;
    const double h = std::min(row_height * 0.86, values ? 34.0 : 20.0);
    if (current) fill(view, c.x - w / 2 - 1, c.y - h / 2 - 1, w + 2, h + 2, Role::current, 0.25);
    if (operands.contains(v)) fill(view, c.x - w / 2 - 1, c.y - h / 2 - 1, w + 2, h + 2, Role::operand, 0.22);
    if (!made) {
      fill(view, c.x - w / 4, c.y - 1, w / 2, 2, Role::rule_line);  // a line to be written on
      continue;
    }
    Label& name = text(view, c.x, values ? c.y - 1 : c.y + 5, typeset_name(graph.value(v).name, *source.algorithm),
                       current ? Role::text_current : Role::text, 0.9);
    name.placement = Label::Placement::centre;
    if (values && source.points[v]) {
      const auto& p = *source.points[v];
      std::string numbers = "(" + format_short(p.x, 2) + ", " + format_short(p.y, 2);
      if (source.spatial()) numbers += ", " + format_short(p.z, 2);
      const double size = std::min(0.72, cell_width * 0.74 / (static_cast<double>(numbers.size() + 1) * 14 * 0.55));
      text(view, c.x, c.y + 14, {{numbers + ")"}}, Role::text_quiet, size).placement = Label::Placement::centre;
    }
  }
  return at - y + row_height * static_cast<double>(rows.size()) + 12;
}

double add_knot_line(View& view, const StepSource& source, std::uint32_t step, double x, double y, double width) {
  if (source.curves.size() != 1 || source.curves[0].bezier) return 0;
  const auto& curve = source.curves[0];
  const double first = curve.knots.front();
  const double last = curve.knots.back();
  if (!(first < last)) return 0;
  const double left = x + 40;
  const double right = x + width - 40;
  const double line = y + 26;
  const auto place = [&](double u) { return left + (u - first) / (last - first) * (right - left); };
  text(view, x, line + 4, {{"U", TextRun::Level::base, true}}, Role::text_quiet, 0.9);
  // The number as the run writes it (1/4, not 0.25), if that is short.
  const auto number = [&](const std::string& name, double value) {
    const auto v = source.graph->find(name);
    std::string exact = v ? source.value_text(*v) : std::string();
    return exact.empty() || exact.size() > 8 ? format_short(value, 4) : exact;
  };

  Polyline all;
  all.points = {{left, line, 0}, {right, line, 0}};
  all.role = Role::rule_line;
  view.polylines.push_back(all);
  Polyline domain;
  domain.points = {{place(curve.domain_begin()), line, 0}, {place(curve.domain_end()), line, 0}};
  domain.role = Role::polygon;
  view.polylines.push_back(domain);

  // The span k, once it is known.
  for (ValueId v = 0; v < source.graph->value_count() && source.graph->value(v).step <= step; ++v) {
    if (!(source.graph->value(v).name == "k"_v()) || !source.graph->scope(v).empty()) continue;
    const auto k = static_cast<std::size_t>(source.scalars[v]);
    if (k + 1 >= curve.knots.size()) continue;
    Polyline span;
    span.points = {{place(curve.knots[k]), line, 0}, {place(curve.knots[k + 1]), line, 0}};
    span.role = Role::current;
    view.polylines.push_back(span);
  }
  for (std::size_t i = 0; i < curve.knots.size();) {
    std::size_t end = i;
    while (end < curve.knots.size() && curve.knots[end] == curve.knots[i]) ++end;
    Marker knot;
    knot.position = {place(curve.knots[i]), line, 0};
    knot.role = Role::control_point;
    knot.shape = Marker::Shape::triangle;
    knot.size_scale = 0.9;
    view.markers.push_back(knot);
    Label label;
    label.anchor = {place(curve.knots[i]), line + 20, 0};
    label.text = {{std::to_string(end - i) + "(" + number("U[" + std::to_string(i) + "]", curve.knots[i]) + ")"}};
    label.role = Role::text_quiet;
    label.size_scale = 0.72;
    label.placement = Label::Placement::centre;
    label.optional = true;
    view.labels.push_back(label);
    i = end;
  }
  // A ratio measures u between two knots.
  if (const ValueId main = source.graph->main_value(step);
      main != absent && source.graph->value(main).rule == &rule_info<Ratio> && source.graph->scope(main).empty()) {
    const auto from = source.graph->operands(main);
    const double a = source.scalars[from[1]];
    const double b = source.scalars[from[2]];
    Polyline between;
    between.points = {{place(a), line - 6, 0}, {place(b), line - 6, 0}};
    between.role = Role::ratio_far;
    view.polylines.push_back(between);
    between.points = {{place(a), line - 6, 0}, {place(source.scalars[from[0]]), line - 6, 0}};
    between.role = Role::ratio_near;
    view.polylines.push_back(between);
  }
  if (source.parameter) {
    Marker u;
    u.position = {place(*source.parameter), line, 0};
    u.role = Role::current;
    u.shape = Marker::Shape::diamond;
    view.markers.push_back(u);
    Label& label =
        text(view, place(*source.parameter), line - 12,
             {{"u", TextRun::Level::base, true}, {" = " + number("u", *source.parameter)}}, Role::text_current, 0.85);
    label.placement = Label::Placement::centre;
    label.priority = 10;
  }
  return 56;
}

}  // namespace blossom
