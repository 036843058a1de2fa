#pragma once
// The recorder that keeps everything. See kernel/recorder.hpp for what a recorder is.

#include "trace/trace.hpp"

namespace blossom {

// What a recorder throws when a run makes more values than anybody could look at.
struct TraceTooLarge {};
inline constexpr std::uint32_t most_values = 2'000'000;

template <Scalar S>
class TraceRecorder : private Trace<S> {
 public:
  static constexpr bool recording = true;
  using Id = ValueId;
  using Number = S;

  // Starts again, keeping the memory of the last run.
  void clear() {
    this->values_.clear();
    this->operands_.clear();
    this->steps_.clear();
    this->phases_.clear();
    this->retired_by_step_.clear();
    this->numbers_.clear();
    this->polar_seeds_.clear();
    this->polar_numbers_.clear();
    this->index_.clear();
    this->retired_by_value_.clear();
    phase_ = absent;
    grouped_ = 0;
    step_open_ = false;
  }

  // The trace so far: a view, or taken out of a recorder that is done.
  const Trace<S>& trace() const { return *this; }
  Trace<S> take() && {
    finish();
    return std::move(static_cast<Trace<S>&>(*this));
  }
  // Inputs that no later value joined in a step (an algorithm that only has inputs) get theirs.
  void finish() {
    if (step_open_) close_step();
  }

  template <class Rule, class... Operands>
  auto apply(Rule, const Name& name, const Operands&... operands) {
    auto made = Rule::template apply<S>(operands.value...);
    if (this->steps_.empty() && step_open_) close_step();  // what is given at the beginning is step 0
    const Id id = begin_value(name, &rule_info<Rule>, rule_info<Rule>.makes);
    if constexpr ((... && requires { this->operands_.push_back(operands.id); })) {
      // One growth check for all operands.
      Id* out = this->operands_.add(sizeof...(operands));
      ((*out++ = operands.id), ...);
    } else {
      (add_operand(operands), ...);
    }
    add_numbers(made);
    if (grouped_ == 0) close_step();
    return Traced<decltype(made), Id>{std::move(made), id};
  }

  template <class T>
  Traced<T, Id> input(const Name& name, const T& value) {
    const Id id = begin_value(name, nullptr, detail::kind_of<T>());
    add_numbers(value);
    return {value, id};
  }
  template <class T>
  Givens<T, Id> inputs(const NameMaker& symbol, std::span<const T> values) {
    const Id first = this->value_count();
    for (std::size_t i = 0; i < values.size(); ++i) input(symbol(static_cast<int>(i)), values[i]);
    return {values, first};
  }
  template <class T>
  Givens<T, Id> inputs(const NameMaker& symbol, int row, std::span<const T> values) {
    const Id first = this->value_count();
    for (std::size_t i = 0; i < values.size(); ++i) input(symbol(row, static_cast<int>(i)), values[i]);
    return {values, first};
  }
  Traced<std::span<const S>, Id> list(const Name& name, const std::span<const S>& values) {
    const Id id = begin_value(name, nullptr, ValueKind::list);
    add_numbers(values);
    return {values, id};
  }

  class PhaseGuard {
   public:
    explicit PhaseGuard(TraceRecorder& recorder, std::uint32_t outside) : recorder_(&recorder), outside_(outside) {}
    PhaseGuard(const PhaseGuard&) = delete;
    ~PhaseGuard() { recorder_->leave(outside_); }

   private:
    TraceRecorder* recorder_;
    std::uint32_t outside_;
  };
  PhaseGuard phase(const Phase& phase) {
    finish();
    const std::uint32_t outside = phase_;
    phase_ = static_cast<std::uint32_t>(this->phases_.size());
    this->phases_.push_back({std::string(phase.id), phase.index, phase.scoped, std::string(phase.algorithm), outside,
                             this->step_count(), this->step_count()});
    this->steps_.push_back({this->value_count(), phase_});
    return PhaseGuard(*this, outside);
  }

  class StepGuard {
   public:
    explicit StepGuard(TraceRecorder& recorder) : recorder_(&recorder) { ++recorder_->grouped_; }
    StepGuard(const StepGuard&) = delete;
    ~StepGuard() {
      if (--recorder_->grouped_ == 0) recorder_->finish();
    }

   private:
    TraceRecorder* recorder_;
  };
  StepGuard one_step() {
    finish();
    return StepGuard(*this);
  }

  void retire(Id id) { this->retired_by_step_.push_back({id, this->step_count() - (step_open_ ? 0 : 1)}); }
  void polar_knots(Id id, Id first_knot, int count) {
    this->polar_seeds_.push_back({Trace<S>::PolarSeed::Kind::knots, id, first_knot, count, 0});
  }
  void polar_bezier(Id id, int i, int n) {
    this->polar_seeds_.push_back({Trace<S>::PolarSeed::Kind::bezier, id, static_cast<std::uint32_t>(i), n, 0});
  }
  void polar_net(Id id, std::span<const S> u, std::span<const S> v) {
    this->polar_seeds_.push_back({Trace<S>::PolarSeed::Kind::net, id,
                                  static_cast<std::uint32_t>(this->polar_numbers_.size()),
                                  static_cast<std::int32_t>(u.size()), static_cast<std::int32_t>(v.size())});
    this->polar_numbers_.insert(this->polar_numbers_.end(), u.begin(), u.end());
    this->polar_numbers_.insert(this->polar_numbers_.end(), v.begin(), v.end());
  }

 private:
  std::uint32_t phase_ = absent;
  int grouped_ = 0;
  bool step_open_ = false;  // values wait for the step that will hold them
  ValueId open_first_ = 0;

  Id begin_value(const Name& name, const RuleInfo* rule, ValueKind kind) {
    const Id id = this->value_count();
    if (id == most_values) [[unlikely]]
      throw TraceTooLarge{};
    if (!step_open_) {
      step_open_ = true;
      open_first_ = id;
    }
    ValueRecord& record = *this->values_.add(1);
    record.name = name;
    record.kind = kind;
    record.step = this->step_count();
    record.rule = rule;
    record.numbers_at = static_cast<std::uint32_t>(this->numbers_.size());
    record.operands_at = static_cast<std::uint32_t>(this->operands_.size());
    return id;
  }
  // Inputs given on the way join the step of the next value made.
  void close_step() {
    this->steps_.push_back({open_first_, phase_});
    step_open_ = false;
  }
  void leave(std::uint32_t outside) {
    finish();
    this->phases_[phase_].last_step = this->step_count() - 1;
    phase_ = outside;
  }

  template <class Operand>
  void add_operand(const Operand& operand) {
    if constexpr (requires { operand.id(0); }) {
      for (int i = 0; i < operand.count(); ++i) this->operands_.push_back(operand.id(i));
    } else {
      this->operands_.push_back(operand.id);
    }
  }
  void add_numbers(int value) { this->numbers_.push_back(S(value)); }
  void add_numbers(const S& value) { this->numbers_.push_back(value); }
  void add_numbers(const HPoint<S>& value) {
    S* out = new_numbers(4);
    out[0] = value.x;
    out[1] = value.y;
    out[2] = value.z;
    out[3] = value.w;
  }
  void add_numbers(std::span<const S> values) { std::copy(values.begin(), values.end(), new_numbers(values.size())); }
  S* new_numbers(std::size_t count) {
    if constexpr (std::is_same_v<S, double>) {
      return this->numbers_.add(count);
    } else {
      this->numbers_.resize(this->numbers_.size() + count);
      return this->numbers_.data() + this->numbers_.size() - count;
    }
  }
};

}  // namespace blossom
