#include "scene/scheme.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "algorithms/typeset.hpp"
#include "scene/panel_parts.hpp"

namespace blossom {
namespace {

constexpr std::size_t longest_text = 44;  // of a value in a cell; the formula has all of it

bool is_elevation(const RuleInfo& rule) { return rule.polar == Polar::merge || rule.polar == Polar::repeat; }

// The nearest phase, itself or around it, that is an algorithm of its own.
std::uint32_t part_of(const TraceGraph& graph, std::uint32_t phase) {
  while (phase != absent && graph.phases()[phase].algorithm.empty()) phase = graph.phases()[phase].parent;
  return phase;
}

const Algorithm* algorithm_of(const StepSource& source, std::uint32_t part) {
  return part == absent ? source.algorithm : find_algorithm(source.graph->phases()[part].algorithm);
}

// Moves what stands nearer than one row to its neighbour, all of it as little as it can on the whole.
bool spread(std::vector<double>& rows) {
  double before = 0, after = 0;
  bool moved = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    before += rows[i];
    if (i > 0 && rows[i] < rows[i - 1] + 1) {
      moved = moved || rows[i] < rows[i - 1] + 1 - 1e-9;
      rows[i] = rows[i - 1] + 1;
    }
    after += rows[i];
  }
  if (moved)
    for (double& row : rows) row += (before - after) / static_cast<double>(rows.size());
  return moved;
}

// The cells of one scheme while it is made: values in columns, with what each comes from.
struct Builder {
  struct Made {
    ValueId value;
    int column;
    double row = 0;
    std::vector<std::size_t> from;
    bool made = false;  // here; else only read
  };
  std::vector<Made> cells;
  std::unordered_map<ValueId, std::size_t> index;

  std::size_t add(ValueId v, int column) {
    index.emplace(v, cells.size());
    cells.push_back({v, column, 0, {}, false});
    return cells.size() - 1;
  }

  // A point comes from points, wherever they were made. A number comes from those of the scheme alone (the knots beside
  // them are no cells), so that the first one of all stands in column 0; it may be given, as the table says.
  void add_made(const TraceGraph& graph, const Algorithm& algorithm, ValueId v) {
    const bool is_point = graph.value(v).kind == ValueKind::point;
    std::vector<std::size_t> from;
    int column = is_point ? 1 : 0;
    for (const ValueId o : graph.operands(v)) {
      const auto known = index.find(o);
      const auto is_given_cell = [&] {
        const ValueSpec* spec = graph.is_input(o) ? algorithm.spec(graph.value(o).name) : nullptr;
        return spec != nullptr && spec->tableau;
      };
      if (is_point ? graph.value(o).kind != ValueKind::point : known == index.end() && !is_given_cell()) continue;
      from.push_back(known != index.end() ? known->second : add(o, 0));
      column = std::max(column, cells[from.back()].column + 1);
    }
    const std::size_t made = add(v, column);
    cells[made].from = std::move(from);
    cells[made].made = true;
  }

  std::vector<std::vector<std::size_t>> by_column() const {
    std::vector<std::vector<std::size_t>> columns;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto column = static_cast<std::size_t>(cells[i].column);
      if (columns.size() <= column) columns.resize(column + 1);
      columns[column].push_back(i);
    }
    return columns;
  }

  bool place(std::vector<std::size_t>& column) {
    std::ranges::stable_sort(column, {}, [&](std::size_t i) { return cells[i].row; });
    std::vector<double> rows;
    for (const std::size_t i : column) rows.push_back(cells[i].row);
    const bool moved = spread(rows);
    for (std::size_t i = 0; i < column.size(); ++i) cells[column[i]].row = rows[i];
    return moved;
  }

  // Each between what it comes from. Elevation makes more points than it takes: then the earlier columns are spread as
  // well, each point standing between those that come from it.
  void place_all(std::vector<std::vector<std::size_t>>& columns) {
    for (std::size_t i = 0; i < columns[0].size(); ++i) cells[columns[0][i]].row = static_cast<double>(i);
    bool moved = false;
    for (std::size_t c = 1; c < columns.size(); ++c) {
      for (const std::size_t i : columns[c]) {
        double sum = 0;
        for (const std::size_t o : cells[i].from) sum += cells[o].row;
        cells[i].row = sum / static_cast<double>(std::max<std::size_t>(cells[i].from.size(), 1));
      }
      moved = place(columns[c]) || moved;
    }
    if (!moved) return;
    for (std::size_t c = columns.size() - 1; c > 0; --c) {
      std::unordered_map<std::size_t, std::pair<double, int>> readers;
      for (const std::size_t i : columns[c])
        for (const std::size_t o : cells[i].from) {
          readers[o].first += cells[i].row;
          ++readers[o].second;
        }
      for (const std::size_t o : columns[c - 1])
        if (const auto found = readers.find(o); found != readers.end())
          cells[o].row = found->second.first / found->second.second;
      place(columns[c - 1]);
    }
  }
};

}  // namespace

Scheme make_scheme(const StepSource& source, std::uint32_t part) {
  const TraceGraph& graph = *source.graph;
  const Algorithm* algorithm = algorithm_of(source, part);
  Scheme scheme;
  if (algorithm == nullptr) return scheme;
  const bool by_table = std::ranges::any_of(algorithm->values, &ValueSpec::tableau);
  const bool elevates = std::ranges::any_of(algorithm->rules, [](const RuleInfo* rule) { return is_elevation(*rule); });
  if (!by_table && !elevates) return scheme;

  Builder builder;
  const std::uint32_t first = part == absent ? 0 : graph.phases()[part].first_step;
  const std::uint32_t last = part == absent ? graph.step_count() - 1 : graph.phases()[part].last_step;
  std::unordered_map<std::uint32_t, bool> inside;  // whether a phase belongs to this part, not to one within it
  for (std::uint32_t step = first; step <= last; ++step) {
    const std::uint32_t phase = graph.step(step).phase;
    const auto known = inside.find(phase);
    const bool here =
        known != inside.end() ? known->second : inside.emplace(phase, part_of(graph, phase) == part).first->second;
    if (!here) continue;
    const auto [begin, end] = graph.values_of(step);
    for (ValueId v = begin; v < end; ++v) {
      const ValueRecord& record = graph.value(v);
      const bool is_cell = record.kind == ValueKind::point || (by_table && record.kind == ValueKind::scalar);
      if (!is_cell || record.rule == nullptr) continue;
      const ValueSpec* spec = by_table ? algorithm->spec(record.name) : nullptr;
      if (by_table ? spec != nullptr && spec->tableau : is_elevation(*record.rule))
        builder.add_made(graph, *algorithm, v);
    }
  }
  if (builder.cells.empty()) return scheme;

  auto columns = builder.by_column();
  builder.place_all(columns);
  double top = 1e300, bottom = -1e300;
  for (const auto& cell : builder.cells) {
    top = std::min(top, cell.row);
    bottom = std::max(bottom, cell.row);
  }
  scheme.rows = bottom - top + 1;
  for (const auto& column : columns) {
    scheme.columns.push_back(scheme.cells.size());
    for (const std::size_t i : column) {
      const auto& cell = builder.cells[i];
      scheme.by_value_.emplace_back(cell.value, scheme.cells.size());
      if (cell.made) scheme.by_step_.emplace_back(graph.value(cell.value).step, scheme.cells.size());
      scheme.cells.push_back({cell.value, cell.column, cell.row - top});
    }
  }
  scheme.columns.push_back(scheme.cells.size());
  std::ranges::sort(scheme.by_value_);
  std::ranges::sort(scheme.by_step_);
  return scheme;
}

const Scheme::Cell* Scheme::find(ValueId v) const {
  const auto found = std::ranges::lower_bound(by_value_, v, {}, &std::pair<ValueId, std::size_t>::first);
  return found != by_value_.end() && found->first == v ? &cells[found->second] : nullptr;
}

const Scheme::Cell& Scheme::current(const TraceGraph& graph, std::uint32_t step) const {
  if (const ValueId main = graph.main_value(step); main != absent && !graph.is_input(main))
    if (const Cell* cell = find(main)) return *cell;
  const auto next = std::ranges::lower_bound(by_step_, step, {}, &std::pair<std::uint32_t, std::size_t>::first);
  return cells[next != by_step_.end() ? next->second : by_step_.back().second];
}

const Scheme::Texts& Scheme::texts(const StepSource& source) const {
  if (texts_) return *texts_;
  texts_ = std::make_unique<Texts>();
  texts_->name_ems.assign(static_cast<std::size_t>(column_count()), 0);
  texts_->value_ems = texts_->name_ems;
  for (const Cell& cell : cells) {
    const auto column = static_cast<std::size_t>(cell.column);
    const ValueRecord& record = source.graph->value(cell.value);
    texts_->names.push_back(typeset_name(record.name, source.algorithm_at(record.step)));
    texts_->values.push_back(parts::shortened(source.value_text(cell.value), longest_text));
    texts_->name_ems[column] = std::max(texts_->name_ems[column], parts::ems(texts_->names.back()));
    texts_->value_ems[column] = std::max(texts_->value_ems[column], parts::ems(texts_->values.back()));
  }
  return *texts_;
}

const Scheme* Schemes::at(const StepSource& source, std::uint32_t step) {
  const TraceGraph& graph = *source.graph;
  std::uint32_t phase = graph.step(step).phase;
  // The step that introduces a phase still belongs to what is around it.
  if (phase != absent && graph.introduced_by(step) == phase) phase = graph.phases()[phase].parent;
  for (std::uint32_t part = part_of(graph, phase);; part = part_of(graph, graph.phases()[part].parent)) {
    auto found = made_.find(part);
    if (found == made_.end()) found = made_.emplace(part, make_scheme(source, part)).first;
    if (!found->second.cells.empty()) return &found->second;
    if (part == absent) return nullptr;
  }
}

const Scheme* scheme_at(const StepSource& source, std::uint32_t step) {
  if (!source.schemes) source.schemes = std::make_shared<Schemes>();
  return source.schemes->at(source, step);
}

}  // namespace blossom
