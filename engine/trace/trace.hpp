#pragma once
// A trace: the graph of named values that an algorithm made, in the order it made them.
//
// Values are never overwritten. Each is born at one step, may be retired at a later one, and knows its rule and
// operands. Steps number from 0: step 0 shows the inputs. A phase is a nested part of the algorithm (and may be another
// algorithm).
//
// TraceGraph is everything but the numbers; Trace<S> adds them. 92 bytes for a blended point in double.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "trace/growing.hpp"
#include "trace/rule.hpp"

namespace blossom {

using ValueId = std::uint32_t;
inline constexpr std::uint32_t absent = 0xffffffff;  // no value, step or phase

struct ValueRecord {
  [[no_unique_address]] Name name;  // `kind` stands in its padding
  ValueKind kind = ValueKind::scalar;
  std::uint32_t step = 0;
  const RuleInfo* rule = nullptr;  // nullptr: an input
  std::uint32_t numbers_at = 0;
  std::uint32_t operands_at = 0;
};
static_assert(sizeof(ValueRecord) <= 40);

struct StepRecord {
  ValueId first_value = 0;  // the step's values are those up to the next step's first
  std::uint32_t phase = absent;
};

struct PhaseRecord {
  std::string id;
  int index = -1;
  bool scoped = false;
  std::string algorithm;  // not empty: this phase is that algorithm
  std::uint32_t parent = absent;
  std::uint32_t first_step = 0;  // its own step, which introduces it
  std::uint32_t last_step = 0;   // the last step inside

  std::string label() const { return index < 0 ? id : id + "[" + std::to_string(index) + "]"; }
  bool operator==(const PhaseRecord&) const = default;
};

// Polar arguments of a point: of a curve's, or of a surface's (u-arguments; v-arguments).
template <Scalar S>
struct PolarLabel {
  std::vector<S> u;
  std::vector<S> v;
  bool empty() const { return u.empty() && v.empty(); }
  bool operator==(const PolarLabel&) const = default;
};

// "b(0, 2/5, 1)", "b(0, 0; 1, 1)"
template <Scalar S, class NumberText>
std::string to_string(const PolarLabel<S>& label, const NumberText& text_of) {
  std::string text = "b(";
  for (std::size_t i = 0; i < label.u.size(); ++i) text += (i > 0 ? ", " : "") + text_of(label.u[i]);
  for (std::size_t i = 0; i < label.v.size(); ++i) text += (i > 0 ? ", " : "; ") + text_of(label.v[i]);
  return text + ")";
}
template <Scalar S>
std::string to_string(const PolarLabel<S>& label) {
  return to_string(label, [](const S& x) { return format_number(x); });
}

class TraceGraph {
 public:
  std::uint32_t value_count() const { return static_cast<std::uint32_t>(values_.size()); }
  std::uint32_t step_count() const { return static_cast<std::uint32_t>(steps_.size()); }
  const ValueRecord& value(ValueId v) const { return values_[v]; }
  const StepRecord& step(std::uint32_t k) const { return steps_[k]; }
  const std::vector<PhaseRecord>& phases() const { return phases_; }

  std::span<const ValueId> operands(ValueId v) const;
  std::pair<ValueId, ValueId> values_of(std::uint32_t step) const;  // [first, end)
  bool is_input(ValueId v) const { return values_[v].rule == nullptr; }
  // The value a step is about: the last it makes; none for a step that only introduces a phase.
  ValueId main_value(std::uint32_t step) const;
  std::uint32_t phase_of(ValueId v) const { return steps_[values_[v].step].phase; }
  std::uint32_t retired_at(ValueId v) const;  // none: never
  bool alive(ValueId v, std::uint32_t step) const {
    return values_[v].step <= step && (retired_by_step_.empty() || step < retired_at(v));
  }
  // The introducing step of a phase, if that is what this step is.
  std::uint32_t introduced_by(std::uint32_t step) const;
  std::vector<std::uint32_t> phase_path(std::uint32_t phase) const;  // from the outermost

  // Full names: scopes and all. A name belongs to at most one value.
  std::string name(ValueId v) const;
  std::string scope(ValueId v) const;  // "elevate[1]." or ""
  std::optional<ValueId> find(std::string_view name) const;

  std::size_t memory_bytes() const;  // of the graph, as allocated for its values, steps and operands

 protected:
  Growing<ValueRecord> values_;
  Growing<ValueId> operands_;
  Growing<StepRecord> steps_;
  std::vector<PhaseRecord> phases_;
  std::vector<std::pair<ValueId, std::uint32_t>> retired_by_step_;  // in the order of steps while recording
  mutable std::unordered_map<std::string, ValueId> index_;          // built at the first find()
  mutable std::vector<std::pair<ValueId, std::uint32_t>> retired_by_value_;

  const std::vector<std::pair<ValueId, std::uint32_t>>& retired_by_value() const;
  friend class TraceReader;
};

template <Scalar S>
class Trace : public TraceGraph {
 public:
  int dimension = 2;
  bool rational = false;

  NumbersView<S> numbers(ValueId v) const {
    const std::size_t first = values_[v].numbers_at;
    const std::size_t end = v + 1 < values_.size() ? values_[v + 1].numbers_at : numbers_.size();
    return std::span<const S>(numbers_).subspan(first, end - first);
  }
  // The polar labels of all values, empty where there is none. One pass along the graph.
  std::vector<PolarLabel<S>> polar_labels() const;

  // Every value again, in order, by its rule from its operands; where `given` names a value its numbers are taken
  // instead. This is what "carried forward" means, and the check that a trace is what was computed.
  std::vector<Numbers<S>> replay(const std::unordered_map<ValueId, Numbers<S>>& given = {}) const;

  // Values that are known only in double precision (chord lengths and all that came of them).
  std::vector<ValueId> approximate_values() const;

  std::size_t memory_bytes() const { return TraceGraph::memory_bytes() + numbers_.size() * sizeof(S); }
  // The same trace: names, kinds, rules by name, operands, steps, phases, numbers.
  bool operator==(const Trace&) const;

 protected:
  struct PolarSeed {
    enum class Kind : std::uint8_t { knots, bezier, net } kind;
    ValueId value;
    std::uint32_t first;  // first knot's id; index i; position in polar_numbers_
    std::int32_t count;   // how many; degree n; of u
    std::int32_t count_v;
  };
  std::conditional_t<std::is_same_v<S, double>, Growing<double>, std::vector<S>> numbers_;
  std::vector<PolarSeed> polar_seeds_;
  std::vector<S> polar_numbers_;
  friend class TraceReader;
};

extern template class Trace<double>;
extern template class Trace<Exact>;

}  // namespace blossom
