#include "trace/trace.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>

namespace blossom {

std::string_view kind_name(ValueKind kind) {
  switch (kind) {
    case ValueKind::integer:
      return "integer";
    case ValueKind::scalar:
      return "scalar";
    case ValueKind::point:
      return "point";
    case ValueKind::vector:
      return "vector";
    case ValueKind::list:
      return "list";
  }
  return "";
}

std::span<const ValueId> TraceGraph::operands(ValueId v) const {
  const std::size_t first = values_[v].operands_at;
  const std::size_t end = v + 1 < values_.size() ? values_[v + 1].operands_at : operands_.size();
  return std::span<const ValueId>(operands_).subspan(first, end - first);
}

std::pair<ValueId, ValueId> TraceGraph::values_of(std::uint32_t step) const {
  return {steps_[step].first_value, step + 1 < step_count() ? steps_[step + 1].first_value : value_count()};
}

ValueId TraceGraph::main_value(std::uint32_t step) const {
  const auto [first, end] = values_of(step);
  return first == end ? absent : end - 1;
}

const std::vector<std::pair<ValueId, std::uint32_t>>& TraceGraph::retired_by_value() const {
  if (retired_by_value_.size() != retired_by_step_.size()) {
    retired_by_value_ = retired_by_step_;
    std::sort(retired_by_value_.begin(), retired_by_value_.end());
  }
  return retired_by_value_;
}

std::uint32_t TraceGraph::retired_at(ValueId v) const {
  const auto& retired = retired_by_value();
  const auto it = std::lower_bound(retired.begin(), retired.end(), std::pair<ValueId, std::uint32_t>{v, 0});
  return it != retired.end() && it->first == v ? it->second : absent;
}

std::uint32_t TraceGraph::introduced_by(std::uint32_t step) const {
  const std::uint32_t phase = steps_[step].phase;
  return phase != absent && phases_[phase].first_step == step ? phase : absent;
}

std::vector<std::uint32_t> TraceGraph::phase_path(std::uint32_t phase) const {
  std::vector<std::uint32_t> path;
  for (; phase != absent; phase = phases_[phase].parent) path.push_back(phase);
  std::reverse(path.begin(), path.end());
  return path;
}

std::string TraceGraph::scope(ValueId v) const {
  auto path = phase_path(phase_of(v));
  std::erase_if(path, [&](std::uint32_t phase) { return !phases_[phase].scoped; });
  if (values_[v].name.outer != 0 && !path.empty()) path.pop_back();
  std::string text;
  for (const std::uint32_t phase : path) text += phases_[phase].label() + ".";
  return text;
}

namespace {

std::string name_in(std::string scope, const Name& name) {
  for (std::uint64_t rest = name.symbol.packed; rest != 0; rest >>= 8) scope += static_cast<char>(rest & 0xff);
  char digits[16];
  for (int i = 0; i < name.arity; ++i) {
    const auto end = std::to_chars(digits, digits + sizeof digits, name.index[i]).ptr;
    scope.append(1, '[').append(digits, end).append(1, ']');
  }
  return scope;
}

}  // namespace

std::string TraceGraph::name(ValueId v) const { return name_in(scope(v), values_[v].name); }

std::optional<ValueId> TraceGraph::find(std::string_view name) const {
  if (index_.empty()) {
    index_.reserve(value_count());
    // Neighbours mostly share their scope, which takes longer to find than the rest of the name.
    std::string scope;
    for (ValueId v = 0; v < value_count(); ++v) {
      const bool same = v > 0 && phase_of(v) == phase_of(v - 1) && values_[v].name.outer == values_[v - 1].name.outer;
      if (!same) scope = this->scope(v);
      [[maybe_unused]] const bool unique = index_.emplace(name_in(scope, values_[v].name), v).second;
      assert(unique && "two values of one name");
    }
  }
  const auto it = index_.find(std::string(name));
  return it == index_.end() ? std::nullopt : std::optional(it->second);
}

std::size_t TraceGraph::memory_bytes() const {
  return values_.size() * sizeof(ValueRecord) + operands_.size() * sizeof(ValueId) +
         steps_.size() * sizeof(StepRecord) + retired_by_step_.size() * sizeof(retired_by_step_[0]);
}

template <Scalar S>
std::vector<Numbers<S>> Trace<S>::replay(const std::unordered_map<ValueId, Numbers<S>>& given) const {
  std::vector<Numbers<S>> made(value_count());
  std::vector<NumbersView<S>> views;
  for (ValueId v = 0; v < value_count(); ++v) {
    const auto own = numbers(v);
    if (const auto it = given.find(v); it != given.end()) {
      made[v] = it->second;
    } else if (is_input(v)) {
      made[v].assign(own.begin(), own.end());
    } else {
      views.clear();
      for (const ValueId o : operands(v)) views.emplace_back(made[o]);
      if (!values_[v].rule->template replay<S>()(views, made[v])) made[v].clear();
    }
  }
  return made;
}

template <Scalar S>
std::vector<ValueId> Trace<S>::approximate_values() const {
  std::vector<ValueId> found;
  for (ValueId v = 0; v < value_count(); ++v)
    if (std::ranges::any_of(numbers(v), [](const S& x) { return is_approximate(x); })) found.push_back(v);
  return found;
}

template <Scalar S>
std::vector<PolarLabel<S>> Trace<S>::polar_labels() const {
  std::vector<PolarLabel<S>> labels(value_count());
  for (const PolarSeed& seed : polar_seeds_) {
    auto& label = labels[seed.value];
    const auto count = static_cast<std::size_t>(seed.count);
    switch (seed.kind) {
      case PolarSeed::Kind::knots:
        for (std::size_t i = 0; i < count; ++i) label.u.push_back(numbers(seed.first + static_cast<ValueId>(i))[0]);
        break;
      case PolarSeed::Kind::bezier:
        label.u.assign(count - seed.first, S(0));
        label.u.insert(label.u.end(), seed.first, S(1));
        break;
      case PolarSeed::Kind::net: {
        const auto u = polar_numbers_.begin() + seed.first;
        label.u.assign(u, u + seed.count);
        label.v.assign(u + seed.count, u + seed.count + seed.count_v);
        break;
      }
    }
  }
  for (ValueId v = 0; v < value_count(); ++v) {
    if (is_input(v) || values_[v].rule->polar == Polar::none || !labels[v].empty()) continue;
    const auto from = operands(v);
    if (values_[v].rule->polar == Polar::same) {
      labels[v] = labels[from[0]];
      continue;
    }
    if (values_[v].rule->polar == Polar::repeat || values_[v].rule->polar == Polar::repeat_v) {
      labels[v] = labels[from[0]];
      auto& label = values_[v].rule->polar == Polar::repeat ? labels[v].u : labels[v].v;
      if (!label.empty() && label.size() < max_degree) label.push_back(label.back());
      continue;
    }
    // Two points of a surface are of one row or of one column: the arguments in the other direction are the same.
    const auto& first = labels[from[from.size() - 2]];  // behind the ratio, if there is one
    const auto& second = labels[from[from.size() - 1]];
    const bool along_v = first.v != second.v;
    if (along_v && first.u != second.u) continue;
    const auto& A = along_v ? first.v : first.u;
    const auto& B = along_v ? second.v : second.u;
    if (A.empty() || B.empty()) continue;
    (along_v ? labels[v].u : labels[v].v) = along_v ? first.u : first.v;
    auto& label = along_v ? labels[v].v : labels[v].u;
    if (values_[v].rule->polar == Polar::merge) {
      std::set_union(A.begin(), A.end(), B.begin(), B.end(), std::back_inserter(label));
    } else if (from.size() == 2) {
      // A midpoint: f(A, a) and f(A, b) make f(A, (a + b) / 2).
      std::vector<S> a, b;
      std::set_difference(A.begin(), A.end(), B.begin(), B.end(), std::back_inserter(a));
      std::set_difference(B.begin(), B.end(), A.begin(), A.end(), std::back_inserter(b));
      if (a.size() != 1 || b.size() != 1) continue;
      const S u = (a[0] + b[0]) / S(2);
      std::set_intersection(A.begin(), A.end(), B.begin(), B.end(), std::back_inserter(label));
      label.insert(std::upper_bound(label.begin(), label.end(), u), u);
    } else {
      // The new argument is the parameter itself: what the ratio was made from, or, on [0, 1], the ratio.
      const ValueId ratio = from[0];
      const bool made = !is_input(ratio) && values_[ratio].rule == &rule_info<Ratio>;
      const S& u = numbers(made ? operands(ratio)[0] : ratio)[0];
      std::set_intersection(A.begin(), A.end(), B.begin(), B.end(), std::back_inserter(label));
      label.insert(std::upper_bound(label.begin(), label.end(), u), u);
    }
    if (label.size() > max_degree) label.clear();  // no algorithm's: a file's
  }
  return labels;
}

template <Scalar S>
bool Trace<S>::operator==(const Trace& other) const {
  if (dimension != other.dimension || rational != other.rational || value_count() != other.value_count() ||
      step_count() != other.step_count() || phases_ != other.phases_)
    return false;
  for (std::uint32_t k = 0; k < step_count(); ++k)
    if (steps_[k].first_value != other.steps_[k].first_value || steps_[k].phase != other.steps_[k].phase) return false;
  for (ValueId v = 0; v < value_count(); ++v) {
    const auto& a = values_[v];
    const auto& b = other.values_[v];
    if (a.name != b.name || a.rule != b.rule || a.step != b.step || a.kind != b.kind ||
        retired_at(v) != other.retired_at(v) || !std::ranges::equal(operands(v), other.operands(v)) ||
        !std::ranges::equal(numbers(v), other.numbers(v)))
      return false;
  }
  return polar_labels() == other.polar_labels();
}

template class Trace<double>;
template class Trace<Exact>;

}  // namespace blossom
