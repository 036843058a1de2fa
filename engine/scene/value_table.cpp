// The values that the part of the run around a step has made so far, where there is no triangular scheme to show.
#include <algorithm>

#include "algorithms/typeset.hpp"
#include "scene/panel_parts.hpp"
#include "scene/panels.hpp"

namespace blossom {
namespace {

constexpr double row_height = 20, name_size = 0.95, value_size = 0.92;
constexpr std::size_t most_rows = 24;      // the last ones
constexpr std::size_t most_visited = 400;  // values looked at: a phase may have very many in phases of its own

struct Table {
  std::vector<ValueId> values;  // ascending
  std::uint32_t phase = absent;
  bool more = false;  // earlier ones are left out
};

bool within(const TraceGraph& graph, std::uint32_t phase, std::uint32_t outer) {
  while (phase != outer && phase != absent) phase = graph.phases()[phase].parent;
  return phase == outer;
}

// The values of a phase up to a step, without those of phases within, if it has any of its own.
Table values_of_phase(const TraceGraph& graph, std::uint32_t phase, std::uint32_t step) {
  Table table;
  table.phase = phase;
  const std::uint32_t first = phase == absent ? 0 : graph.phases()[phase].first_step;
  const ValueId begin = graph.values_of(first).first;
  ValueId v = graph.values_of(step).second;
  std::vector<ValueId> within_it;
  for (std::size_t visited = 0; v > begin && visited < most_visited; ++visited) {
    --v;
    if (graph.is_input(v) && step > 0) break;
    if (graph.phase_of(v) == phase)
      table.values.push_back(v);
    else if (within(graph, graph.phase_of(v), phase))
      within_it.push_back(v);
    if (table.values.size() > most_rows) break;
  }
  if (table.values.empty()) table.values = std::move(within_it);
  table.more = table.values.size() > most_rows;
  if (table.more) table.values.resize(most_rows);
  std::ranges::reverse(table.values);
  return table;
}

// Of the innermost phase around the step that has made anything.
Table table_at(const TraceGraph& graph, std::uint32_t step) {
  auto path = graph.phase_path(graph.step(step).phase);
  for (auto phase = path.rbegin(); phase != path.rend(); ++phase)
    if (Table table = values_of_phase(graph, *phase, step); !table.values.empty()) return table;
  return values_of_phase(graph, absent, step);
}

}  // namespace

TableauSize add_value_table(Sheet& sheet, const StepSource& source, std::uint32_t step, const Emphasis& emphasis,
                            double x, double y, double width) {
  const TraceGraph& graph = *source.graph;
  const Table table = table_at(graph, step);
  TableauSize size;
  if (table.values.empty()) return size;
  double at = y;
  std::string title = table.phase == absent ? std::string(step == 0 ? "What is given" : "Values so far")
                                            : source.phase_title(table.phase);
  if (table.more) title += "  (the last " + std::to_string(most_rows) + " values)";
  at += parts::heading(sheet.view, x + 4, at, title);
  std::vector<RichText> names;
  double name_width = 0;
  for (const ValueId v : table.values) {
    names.push_back(typeset_name(graph.value(v).name, source.algorithm_at(graph.value(v).step)));
    name_width = std::max(name_width, parts::width_of(names.back(), Role::text, name_size));
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const ValueId v = table.values[i];
    const bool now = !graph.is_input(v) && graph.value(v).step == step;
    const bool lit = emphasis.lights(v);
    const parts::Box box{x, at, width, row_height};
    if (now) {
      parts::fill(sheet.view, box, Role::current, 0.18);
      parts::fill(sheet.view, {x, at, 3, row_height}, Role::current);
      size.current_y = at + row_height / 2;
    }
    if (lit || emphasis.share(v) != 0) parts::fill(sheet.view, box, Role::highlight, lit ? 0.22 : 0.1);
    const double baseline = at + 14, equals = x + 10 + name_width + 6;
    parts::text(sheet.view, equals - 6, baseline, std::move(names[i]), Role::text, name_size, Label::Placement::right);
    std::string words = "= " + source.value_text(v);
    const double room = x + width - equals - 4;
    const double fitting = parts::size_to_fit(parts::ems(words), Role::text, room, value_size);
    if (fitting < 0.6) words = parts::shortened(words, 40);
    parts::text(sheet.view, equals, baseline, {{words}}, now ? Role::text_current : Role::text,
                parts::size_to_fit(parts::ems(words), Role::text, room, value_size));
    sheet.spots.push_back({{Link::Kind::value, v}, x, at, width, row_height, graph.name(v)});
    at += row_height;
  }
  if (size.current_y == 0 && step > 0) size.current_y = at - row_height / 2;
  size.width = width;
  size.height = at - y + 4;
  return size;
}

}  // namespace blossom
