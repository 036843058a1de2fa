#include "scene/source.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "kernel/lift.hpp"

namespace blossom {

const ValueSpec* StepSource::spec(ValueId v) const {
  const Name& name = graph->value(v).name;
  const ValueSpec* found = algorithm_at(graph->value(v).step).spec(name);
  return found != nullptr ? found : algorithm->spec(name);
}

Name foot_of(const Name& vector, const ValueSpec& spec) {
  const std::string_view foot = spec.foot;
  const std::size_t bracket = foot.find('[');
  Name name{Symbol::of(foot.substr(0, bracket))};
  name.outer = vector.outer;
  if (bracket == std::string_view::npos) return name;
  name.arity = 1;
  const std::string_view inside = foot.substr(bracket + 1, foot.size() - bracket - 2);
  if (std::from_chars(inside.data(), inside.data() + inside.size(), name.index[0]).ec != std::errc())
    name.index[0] = vector.index[0];
  return name;
}

namespace {

// Whether a value that is kept like a point is a vector: a coefficient of a polynomial curve.
bool is_arrow(const Name& name, const Algorithm& algorithm) {
  const ValueSpec* spec = algorithm.spec(name);
  return spec != nullptr && !spec->foot.empty() && foot_of(name, *spec) != name;
}

Curve<double> in_double(const Curve<double>& curve) { return curve; }
Curve<double> in_double(const Curve<Exact>& curve) { return convert<double>(curve); }
Surface<double> in_double(const Surface<double>& surface) { return surface; }
Surface<double> in_double(const Surface<Exact>& surface) { return convert<double>(surface); }
template <class T>
auto in_double(const std::vector<T>& pieces) {
  std::vector<decltype(in_double(pieces.front()))> made;
  for (const auto& piece : pieces) made.push_back(in_double(piece));
  return made;
}
template <Scalar S>
HPoint<double> in_double(const HPoint<S>& point) {
  return {to_double(point.x), to_double(point.y), to_double(point.z), to_double(point.w)};
}

}  // namespace

template <Scalar S>
StepSource make_source(const Narrator<S>& narrator) {
  const Run<S>& run = narrator.run();
  StepSource source;
  source.graph = &run.trace;
  source.algorithm = run.algorithm;
  source.dimension = run.trace.dimension;
  source.rational = run.trace.rational;
  source.exact = std::same_as<S, Exact>;
  for (const auto& [name, value] : run.inputs.values) {
    if (const auto* c = std::get_if<Curve<S>>(&value)) source.curves.push_back(in_double(*c));
    if (const auto* cs = std::get_if<std::vector<Curve<S>>>(&value))
      for (const auto& c : *cs) source.curves.push_back(in_double(c));
    if (const auto* s = std::get_if<Surface<S>>(&value)) source.surfaces.push_back(in_double(*s));
    if (const auto* u = std::get_if<S>(&value); u != nullptr && name == "u") source.parameter = to_double(*u);
  }
  if (run.algorithm->pictured != nullptr) {
    if constexpr (std::same_as<S, double>)
      source.pictured = run.algorithm->pictured(run.inputs);
    else
      source.pictured = run.algorithm->pictured(convert<double>(run.inputs));
  }
  if (run.algorithm->lifts)
    for (auto& curve : source.curves) {
      source.lifted.push_back(lifted(curve));
      curve = at_height_one(curve);
    }
  std::visit([&](const auto& outcome) { source.outcome = in_double(outcome); }, run.outcome);

  const bool any_feet = std::ranges::any_of(run.algorithm->values, [](const auto& spec) { return !spec.foot.empty(); });
  const ValueId count = run.trace.value_count();
  source.points.resize(count);
  source.scalars.resize(count);
  for (ValueId v = 0; v < count; ++v) {
    const auto numbers = run.trace.numbers(v);
    const ValueKind kind = run.trace.value(v).kind;
    if (kind == ValueKind::scalar || kind == ValueKind::integer) source.scalars[v] = to_double(numbers[0]);
    if (kind != ValueKind::point) continue;
    const double w = run.trace.rational ? to_double(numbers[3]) : 1;
    const glm::dvec3 at{to_double(numbers[0]) / w, to_double(numbers[1]) / w, to_double(numbers[2]) / w};
    if (any_feet && is_arrow(run.trace.value(v).name, *run.algorithm)) continue;
    if (std::isfinite(at.x) && std::isfinite(at.y) && std::isfinite(at.z)) source.points[v] = at;
  }

  const Narrator<S>* n = &narrator;
  source.algorithm_at = [n](std::uint32_t step) -> const Algorithm& { return n->algorithm_at(step); };
  source.line = [n](std::uint32_t step) { return n->line(step); };
  source.value_text = [n](ValueId v) { return n->value_text(v); };
  source.made_text = [n](ValueId v) { return n->made_text(v); };
  source.formula = [n](ValueId v) { return n->formula(v); };
  source.own_name = [n](ValueId v) { return n->own_name(v); };
  source.operand_name = [n](ValueId v, ValueId o) { return n->operand_name(v, o); };
  source.numbers = [n](ValueId v) { return n->numbers(v); };
  source.polar = [n](ValueId v) { return n->polar(v); };
  source.phase_title = [n](std::uint32_t phase) { return n->phase_title(phase); };
  source.text = [n](std::uint32_t step) { return n->text(step); };
  source.raw = [n](ValueId v) {
    std::vector<double> numbers;
    for (const S& number : n->trace().numbers(v)) numbers.push_back(to_double(number));
    return numbers;
  };
  return source;
}

template StepSource make_source(const Narrator<double>&);
template StepSource make_source(const Narrator<Exact>&);

}  // namespace blossom
