#include "player/influence.hpp"

#include <algorithm>
#include <iterator>

namespace blossom {
namespace {

bool is_point(ValueKind kind) { return kind == ValueKind::point || kind == ValueKind::vector; }

// Tells how much a value's operands count in it. The rules that make points are linear in the points they take, so a
// rule's answer to a point that is 1 in x, where every other point is 0, is that point's weight without any
// cancellation; what it answers to zeros alone is taken off, should it have a constant part.
class Weights {
 public:
  explicit Weights(const StepSource& source) : source_(source) {}

  // f(operand, weight) for each operand of v that is a point.
  template <class F>
  void each(ValueId v, F&& f) {
    const TraceGraph& graph = *source_.graph;
    const RuleInfo* rule = graph.value(v).rule;
    if (rule == nullptr || !is_point(graph.value(v).kind)) return;
    const auto operands = graph.operands(v);
    if (rule == &rule_info<Project>) {
      f(operands[0], 1.0);  // in homogeneous coordinates it is the same point
      return;
    }
    if (numbers_.size() < operands.size()) numbers_.resize(operands.size());
    views_.clear();
    for (std::size_t i = 0; i < operands.size(); ++i) {
      take(operands[i], numbers_[i]);
      views_.emplace_back(numbers_[i]);
    }
    if (!rule->replay_double(views_, made_)) return;
    const double constant = made_[0];
    for (std::size_t i = 0; i < operands.size(); ++i) {
      if (!is_point(graph.value(operands[i]).kind)) continue;
      numbers_[i][0] = 1;
      if (rule->replay_double(views_, made_)) f(operands[i], made_[0] - constant);
      numbers_[i][0] = 0;
    }
  }

 private:
  void take(ValueId v, std::vector<double>& numbers) const {
    switch (source_.graph->value(v).kind) {
      case ValueKind::point:
      case ValueKind::vector:
        numbers.assign(4, 0.0);
        break;
      case ValueKind::integer:
      case ValueKind::scalar:
        numbers.assign(1, source_.scalars[v]);
        break;
      case ValueKind::list:
        numbers = source_.raw(v);
        break;
    }
  }

  const StepSource& source_;
  std::vector<std::vector<double>> numbers_;
  std::vector<NumbersView<double>> views_;
  std::vector<double> made_;
};

// Whether a value is its operand under another name: an end that stays, a point over mapped knots, a point divided by
// its weight.
bool stands_for_operand(const RuleInfo* rule) {
  return rule != nullptr && (rule->formula == "{0}" || rule == &rule_info<Project>);
}

// The values made until `step` that stand for the same as v, and v itself; ascending.
std::vector<ValueId> standing_for_same(const TraceGraph& graph, ValueId v, std::uint32_t step) {
  ValueId root = v;
  while (stands_for_operand(graph.value(root).rule)) root = graph.operands(root)[0];
  std::vector<ValueId> same{root};
  for (ValueId w = root + 1; w < graph.value_count() && (w <= v || graph.value(w).step <= step); ++w) {
    const auto operands = graph.operands(w);
    if (operands.size() == 1 && std::binary_search(same.begin(), same.end(), operands[0]) &&
        stands_for_operand(graph.value(w).rule))
      same.push_back(w);
  }
  return same;
}

// The given value called symbol[index] or symbol[0][index] (the first curve's, of several); absent if there is none.
ValueId given(const TraceGraph& graph, std::string_view symbol, std::uint32_t index, ValueKind kind) {
  if (graph.step_count() == 0) return absent;
  const auto wanted = static_cast<std::int64_t>(index);
  const auto [first, end] = graph.values_of(0);
  for (ValueId v = first; v < end; ++v) {
    const Name& name = graph.value(v).name;
    if (graph.value(v).kind != kind || name.symbol != Symbol::of(symbol)) continue;
    if (name.arity == 1 && name.index[0] == wanted) return v;
    if (name.arity == 2 && name.index[0] == 0 && name.index[1] == wanted) return v;
  }
  return absent;
}

Emphasis emphasis_of_value(const StepSource& source, ValueId v, std::uint32_t step) {
  const TraceGraph& graph = *source.graph;
  Emphasis emphasis;
  if (v >= graph.value_count()) return emphasis;
  emphasis.lit = standing_for_same(graph, v, step);
  const auto from = shares(source, v);
  for (ValueId w = 0; w < v; ++w)
    if (from[w] != 0) emphasis.shares.emplace_back(w, from[w]);
  if (graph.is_input(v)) {
    const auto onward = shares_onward(source, v);
    for (ValueId w = v + 1; w < graph.value_count() && graph.value(w).step <= step; ++w)
      if (onward[w] != 0) emphasis.shares.emplace_back(w, onward[w]);
  }
  // A line can be marked only where its pseudo-code is the one that is shown.
  const std::uint32_t made_at = graph.value(v).step;
  if (&source.algorithm_at(made_at) == &source.algorithm_at(step)) emphasis.line = source.line(made_at);
  return emphasis;
}

// The steps of the algorithm that explains this step: of the innermost phase that is an algorithm, or of the whole run.
std::pair<std::uint32_t, std::uint32_t> steps_of_algorithm(const TraceGraph& graph, std::uint32_t step) {
  const auto& phases = graph.phases();
  std::uint32_t phase = graph.step(step).phase;
  while (phase != absent && phases[phase].algorithm.empty()) phase = phases[phase].parent;
  if (phase == absent) return {0, graph.step_count() - 1};
  return {phases[phase].first_step, phases[phase].last_step};
}

// What is made, not given, in the steps from first to last.
void light_made(const TraceGraph& graph, std::uint32_t first, std::uint32_t last, Emphasis& emphasis) {
  for (std::uint32_t k = first; k <= last; ++k) {
    const auto [begin, end] = graph.values_of(k);
    for (ValueId v = begin; v < end; ++v)
      if (!graph.is_input(v)) emphasis.lit.push_back(v);
  }
}

Emphasis emphasis_of_line(const StepSource& source, std::uint32_t line, std::uint32_t step) {
  Emphasis emphasis;
  emphasis.line = static_cast<int>(line);
  const auto [first, last] = steps_of_algorithm(*source.graph, step);
  const Algorithm& algorithm = source.algorithm_at(step);
  for (std::uint32_t k = first; k <= std::min(last, step); ++k)
    if (&source.algorithm_at(k) == &algorithm && source.line(k) == emphasis.line)
      light_made(*source.graph, k, k, emphasis);
  return emphasis;
}

Emphasis emphasis_of_knot(const StepSource& source, std::uint32_t index) {
  Emphasis emphasis;
  if (source.curves.empty() || index >= source.curves[0].knots.size()) return emphasis;
  const auto& knots = source.curves[0].knots;
  for (std::uint32_t i = index; i < knots.size() && knots[i] == knots[index]; ++i)
    if (const ValueId v = given(*source.graph, "U", i, ValueKind::scalar); v != absent) emphasis.lit.push_back(v);
  std::ranges::sort(emphasis.lit);
  return emphasis;
}

}  // namespace

std::vector<double> shares(const StepSource& source, ValueId v) {
  std::vector<double> share(static_cast<std::size_t>(v) + 1);
  share[v] = 1;
  Weights weights(source);
  for (ValueId w = v + 1; w-- > 0;)
    if (share[w] != 0) weights.each(w, [&](ValueId o, double weight) { share[o] += share[w] * weight; });
  return share;
}

std::vector<double> shares_onward(const StepSource& source, ValueId v) {
  const TraceGraph& graph = *source.graph;
  std::vector<double> share(graph.value_count());
  share[v] = 1;
  if (!is_point(graph.value(v).kind)) return share;
  Weights weights(source);
  for (ValueId w = v + 1; w < graph.value_count(); ++w)
    if (std::ranges::any_of(graph.operands(w), [&](ValueId o) { return share[o] != 0; }))
      weights.each(w, [&](ValueId o, double weight) { share[w] += share[o] * weight; });
  return share;
}

Emphasis emphasis_of(const StepSource& source, const Link& link, std::uint32_t step) {
  const TraceGraph& graph = *source.graph;
  Emphasis emphasis;
  switch (link.kind) {
    case Link::Kind::none:
    case Link::Kind::object:  // of the studio, where nothing is traced
    case Link::Kind::handle:
      break;
    case Link::Kind::value:
      return emphasis_of_value(source, link.id, step);
    case Link::Kind::line:
      return emphasis_of_line(source, link.id, step);
    case Link::Kind::phase:
      if (link.id < graph.phases().size())
        light_made(graph, graph.phases()[link.id].first_step, std::min(graph.phases()[link.id].last_step, step),
                   emphasis);
      break;
    case Link::Kind::step:
      if (link.id <= step) light_made(graph, link.id, link.id, emphasis);
      break;
    case Link::Kind::knot:
      return emphasis_of_knot(source, link.id);
    case Link::Kind::parameter:
      for (auto [v, end] = graph.values_of(0); v < end; ++v)
        if (graph.value(v).name == "u"_v()) emphasis.lit.push_back(v);
      break;
    case Link::Kind::basis:
      if (const ValueId v = given(graph, "P", link.id, ValueKind::point); v != absent)
        return emphasis_of_value(source, v, step);
      break;
  }
  return emphasis;
}

Emphasis merged(const Emphasis& a, const Emphasis& b) {
  Emphasis both;
  std::ranges::set_union(a.lit, b.lit, std::back_inserter(both.lit));
  // Of two entries for one value set_union takes that of its first range.
  std::ranges::set_union(
      b.shares, a.shares, std::back_inserter(both.shares), {}, [](const auto& entry) { return entry.first; },
      [](const auto& entry) { return entry.first; });
  both.line = b.line != 0 ? b.line : a.line;
  return both;
}

}  // namespace blossom
