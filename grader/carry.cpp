#include "grader/carry.hpp"

#include <cmath>

namespace blossom {
namespace {

// What the operands' rounding may grant, in tolerances: two digits lost on the way. Without a bound, a weight typed as
// 0.00001 would make every point that is divided by it count as carried.
constexpr double most_widening = 100;

}  // namespace

ReplayPlan::ReplayPlan(const Exercise& exercise) {
  const auto& trace = exercise.run.trace;
  part_of.assign(trace.value_count(), not_asked);
  std::vector<char> needed(trace.value_count(), 0);
  if (exercise.is_sheet()) return;  // its values are its scenes'
  for (std::size_t i = 0; i < exercise.parts.size(); ++i) {
    part_of[exercise.parts[i].value] = static_cast<std::int32_t>(i);
    needed[exercise.parts[i].value] = 1;
  }
  for (ValueId v = trace.value_count(); v-- > 0;) {
    if (needed[v] == 0 || trace.is_input(v)) continue;
    order.push_back(v);
    for (const ValueId o : trace.operands(v)) needed[o] = 1;
  }
  std::ranges::reverse(order);
}

Replayed::Replayed(const Exercise& exercise, const ReplayPlan& plan, Rounding rounding)
    : exercise_(&exercise), plan_(&plan), rounding_(rounding) {
  const auto& trace = exercise.run.trace;
  const std::size_t count = trace.value_count();
  own_.reserve(count);
  for (ValueId v = 0; v < count; ++v) own_.push_back(trace.numbers(v));
  expected_ = own_;
  changed_.assign(count, 0);
  given_.assign(count, 0);
  made_.resize(count);
}

void Replayed::start() {
  const auto& trace = exercise_->run.trace;
  for (const ValueId v : plan_->order) {
    own_[v] = expected_[v] = trace.numbers(v);
    changed_[v] = given_[v] = 0;
    made_[v].rounding.clear();
    made_[v].expected_rounding.clear();
  }
}

bool Replayed::operands_changed(ValueId v) const {
  return std::ranges::any_of(exercise_->run.trace.operands(v), [&](ValueId o) { return changed_[o] != 0; });
}

bool Replayed::make(ValueId v, Numbers<Exact>& made) {
  const auto& trace = exercise_->run.trace;
  operands_.clear();
  for (const ValueId o : trace.operands(v)) {
    if (own_[o].empty()) return false;
    operands_.push_back(own_[o]);
  }
  if (!trace.value(v).rule->replay<Exact>()(operands_, made)) return false;
  // From numbers that overflow nothing follows.
  return std::ranges::all_of(made, [](const Exact& x) { return !x.is_approximate() || std::isfinite(x.to_double()); });
}

void Replayed::put_in(ValueId v, const Part& part, const Given& given) {
  const auto right = exercise_->run.trace.numbers(v);
  Made& made = made_[v];
  const auto model = expected_[v].empty() ? right : expected_[v];
  made.own = part.as_traced(given.numbers, model);
  if (made.own.empty()) return;
  own_[v] = made.own;
  changed_[v] = std::ranges::equal(made.own, right) ? 0 : 1;
  if (given.rounding.empty() || rounding_ == Rounding::ignored || part.form == Form::weight) return;
  made.rounding = given.rounding;
  made.rounding.resize(made.own.size(), 0);
  const auto d = static_cast<std::size_t>(part.dimension);
  if (part.form == Form::homogeneous && d < 3) std::swap(made.rounding[d], made.rounding[3]);  // typed: x, y, w
  const bool is_point = part.kind == ValueKind::point || part.kind == ValueKind::vector;
  if (is_point && part.rational && part.form == Form::affine)
    for (double& r : made.rounding) r *= std::abs(made.own[3].to_double());
}

const Tolerance& Replayed::tolerance(ValueId v) const {
  const std::int32_t part = plan_->part_of[v];
  return part == ReplayPlan::not_asked ? exercise_->tolerance
                                       : exercise_->parts[static_cast<std::size_t>(part)].tolerance;
}

std::vector<char> Replayed::trivial() const {
  std::vector<char> trivial(own_.size(), 0);
  for (const ValueId v : plan_->order)
    if (is_trivial(v, trivial)) trivial[v] = 1;
  return trivial;
}

bool Replayed::is_trivial(ValueId v, const std::vector<char>& trivial) const {
  const auto& trace = exercise_->run.trace;
  const ValueKind kind = trace.value(v).kind;
  const auto result = expected_[v];
  if (result.empty() || kind == ValueKind::integer) return false;
  if (kind == ValueKind::list) return is_trivial_list(v, trivial);
  const auto is_zero = [&](NumbersView<Exact> numbers) {
    // A weight does not make a point at the origin another point.
    const std::size_t count = kind == ValueKind::point ? numbers.size() - 1 : numbers.size();
    return std::ranges::all_of(numbers.first(count), [](const Exact& x) { return x == Exact(0); });
  };
  const std::int32_t part = plan_->part_of[v];
  const bool asked = part != ReplayPlan::not_asked;
  const Part* const typed_as = asked ? &exercise_->parts[static_cast<std::size_t>(part)] : nullptr;
  const auto wide = asked ? widening(*typed_as) : std::vector<double>();
  // Whether an operand, written down once more, would pass for the result.
  const auto is_copy = [&](NumbersView<Exact> operand) {
    if (asked) return agrees(*typed_as, result, typed_as->as_typed(operand), wide);
    return std::ranges::equal(operand, result, [&](const Exact& typed, const Exact& right) {
      return within(exercise_->tolerance, right, typed);
    });
  };
  std::size_t count = 0;
  bool all_zero = true, any_copied = false, all_inherit = true;
  for (const ValueId o : trace.operands(v)) {
    if (trace.value(o).kind != kind) continue;
    ++count;
    if (own_[o].empty()) return false;
    all_zero = all_zero && is_zero(own_[o]);
    any_copied = any_copied || is_copy(own_[o]);
    all_inherit = all_inherit && given_[o] == 0 && trivial[o] != 0;
  }
  if (count == 0) return false;
  return (all_zero && is_zero(result)) || (count > 1 && any_copied) || all_inherit;
}

bool Replayed::is_trivial_list(ValueId v, const std::vector<char>& trivial) const {
  const auto& trace = exercise_->run.trace;
  const auto different = [&](NumbersView<Exact> list) {
    std::size_t steps = 0;
    for (std::size_t i = 1; i < list.size(); ++i)
      if (!within(tolerance(v), list[i], list[i - 1])) ++steps;
    return steps;
  };
  if (different(expected_[v]) < different(trace.numbers(v))) return true;
  bool all_inherit = operands_changed(v);
  for (const ValueId o : trace.operands(v))
    if (changed_[o] != 0) all_inherit = all_inherit && given_[o] == 0 && trivial[o] != 0;
  return all_inherit;
}

std::vector<double> Replayed::rounding_through_rule(ValueId v) const {
  const auto& trace = exercise_->run.trace;
  const auto from = trace.operands(v);
  if (expected_[v].empty() || std::ranges::none_of(from, [&](ValueId o) { return !made_[o].rounding.empty(); }))
    return {};
  std::vector<Numbers<double>> operands;
  for (const ValueId o : from) {
    auto& numbers = operands.emplace_back();
    for (const Exact& x : own_[o]) numbers.push_back(x.to_double());
  }
  const auto apply = [&](Numbers<double>& result) {
    const std::vector<NumbersView<double>> views(operands.begin(), operands.end());
    return trace.value(v).rule->replay<double>()(views, result);
  };
  Numbers<double> centre, moved;
  if (!apply(centre)) return {};
  std::vector<double> rounding(centre.size(), 0);
  for (std::size_t o = 0; o < operands.size(); ++o) {
    const auto& radius = made_[from[o]].rounding;
    for (std::size_t i = 0; i < radius.size() && i < operands[o].size(); ++i) {
      if (radius[i] == 0) continue;
      const double before = operands[o][i];
      operands[o][i] = before + radius[i];
      if (apply(moved) && moved.size() == centre.size())
        for (std::size_t n = 0; n < centre.size(); ++n) rounding[n] += std::abs(moved[n] - centre[n]);
      operands[o][i] = before;
    }
  }
  return rounding;
}

std::vector<double> Replayed::widening(const Part& part) const {
  const auto& rounding = made_[part.value].expected_rounding;
  if (rounding.empty() || part.tolerance.kind == Tolerance::Kind::exact || part.form == Form::weight) return {};
  std::vector<double> wide(
      rounding.begin(), rounding.begin() + static_cast<std::ptrdiff_t>(std::min(rounding.size(), part.right.size())));
  if (part.form == Form::homogeneous) wide.back() = rounding.back();
  if (part.kind == ValueKind::point && part.rational && part.form == Form::affine) {
    const double w = std::abs(expected_[part.value][3].to_double());
    for (double& r : wide) r = w > 0 ? r / w : 0;
  }
  const auto expected = part.as_typed(expected_[part.value]);
  double tolerated = 0;
  for (const Exact& x : expected) tolerated = std::max(tolerated, slack(part.tolerance, x).to_double());
  for (double& r : wide) r = std::min(r, most_widening * tolerated);
  return wide;
}

}  // namespace blossom
