#include "player/edit.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>

#include "base/json_write.hpp"
#include "player/edit_parts.hpp"

namespace blossom {

using namespace edits;

// ---- addresses ------------------------------------------------------------------------------------------------------

std::vector<CurveAddress> curves_of(const Inputs<Exact>& inputs) {
  std::vector<CurveAddress> addresses;
  for (const auto& [name, value] : inputs.values) {
    if (std::holds_alternative<Curve<Exact>>(value)) addresses.push_back({name, 0});
    if (const auto* several = std::get_if<std::vector<Curve<Exact>>>(&value))
      for (std::size_t i = 0; i < several->size(); ++i) addresses.push_back({name, i});
  }
  return addresses;
}

const Curve<Exact>& curve_at(const Inputs<Exact>& inputs, const CurveAddress& address) {
  const InputValue<Exact>& value = inputs.values.find(address.input)->second;
  if (const auto* one = std::get_if<Curve<Exact>>(&value)) return *one;
  return std::get<std::vector<Curve<Exact>>>(value)[address.curve];
}

namespace {

bool is_given_point(const TraceGraph& trace, ValueId v) {
  return trace.is_input(v) && trace.value(v).kind == ValueKind::point;
}

// The given points that are control points. Points of other inputs, such as those of a line, come before them under a
// symbol of their own.
std::vector<ValueId> control_points(const TraceGraph& trace, const Inputs<Exact>& inputs) {
  std::size_t count = 0;
  for (const CurveAddress& at : curves_of(inputs)) count += curve_at(inputs, at).points.size();
  std::vector<ValueId> given;
  for (ValueId v = 0; v < trace.values_of(0).second; ++v)
    if (is_given_point(trace, v)) given.push_back(v);
  while (given.size() > count) {
    const auto other = std::ranges::find_if(
        given, [&](ValueId v) { return trace.value(v).name.symbol != trace.value(given.front()).name.symbol; });
    if (given.end() - other < static_cast<std::ptrdiff_t>(count)) break;
    given.erase(given.begin(), other);
  }
  return given;
}

}  // namespace

// Algorithms record the control points they are given at step 0, curve by curve, whatever they call them.
std::optional<PointAddress> address_of(const TraceGraph& trace, const Inputs<Exact>& inputs, ValueId value) {
  if (value >= trace.value_count() || !is_given_point(trace, value)) return std::nullopt;
  const auto given = control_points(trace, inputs);
  const auto found = std::ranges::find(given, value);
  if (found == given.end()) return std::nullopt;
  auto before = static_cast<std::size_t>(found - given.begin());
  for (const CurveAddress& at : curves_of(inputs)) {
    const std::size_t count = curve_at(inputs, at).points.size();
    if (before < count) return PointAddress{at.input, at.curve, before};
    before -= count;
  }
  return std::nullopt;
}

std::optional<ValueId> value_of(const TraceGraph& trace, const Inputs<Exact>& inputs, const PointAddress& address) {
  std::size_t before = address.point;
  const auto curves = curves_of(inputs);
  const auto own = std::find(curves.begin(), curves.end(), CurveAddress{address.input, address.curve});
  if (own == curves.end() || address.point >= curve_at(inputs, *own).points.size()) return std::nullopt;
  for (auto at = curves.begin(); at != own; ++at) before += curve_at(inputs, *at).points.size();
  const auto given = control_points(trace, inputs);
  return before < given.size() ? std::optional(given[before]) : std::nullopt;
}

// ---- the other inputs -----------------------------------------------------------------------------------------------

namespace {

Edited set_value(const Algorithm& algorithm, Inputs<Exact> inputs, std::string_view input, InputValue<Exact> value) {
  const auto found = inputs.values.find(input);
  if (found == inputs.values.end() || found->second.index() != value.index())
    return refused(std::string(input), "is no such input of " + std::string(algorithm.id));
  found->second = std::move(value);
  return checked(algorithm, std::move(inputs), input);
}

}  // namespace

Edited set_number(const Algorithm& algorithm, const Inputs<Exact>& inputs, std::string_view input, const Exact& x) {
  return set_value(algorithm, inputs, input, x);
}
Edited set_integer(const Algorithm& algorithm, const Inputs<Exact>& inputs, std::string_view input, int i) {
  return set_value(algorithm, inputs, input, i);
}
Edited set_choice(const Algorithm& algorithm, const Inputs<Exact>& inputs, std::string_view input,
                  std::string_view choice) {
  return set_value(algorithm, inputs, input, std::string(choice));
}

Edited inputs_around(const Algorithm& algorithm, const Curve<Exact>& curve) {
  Inputs<Exact> inputs;
  std::string around;
  for (const InputSpec& spec : algorithm.inputs) {
    std::optional<InputValue<Exact>> value;
    if (spec.type == InputSpec::Type::curve && around.empty()) {
      value = curve;
      around = spec.name;
    } else if (!spec.fallback.empty()) {
      const auto document = JsonDocument::parse("default", std::string(spec.fallback));
      Diagnostics none_expected;
      value = read_input(spec, Cursor(*document, none_expected));
    } else if (spec.type == InputSpec::Type::number) {
      value = (curve.domain_begin() + curve.domain_end()) / Exact(2);
    }
    if (!value)
      return refused("", "is one curve, but " + std::string(algorithm.id) + " needs more: its input \"" +
                             std::string(spec.name) + "\" (" + std::string(spec.description) + ")");
    inputs.values.emplace(std::string(spec.name), std::move(*value));
  }
  fit_others(algorithm, inputs, around);
  return fitting(algorithm, std::move(inputs));
}

// ---- numbers and text -----------------------------------------------------------------------------------------------

Exact snapped(double value, double unit, double grid) {
  assert(std::isfinite(value));
  constexpr double most = 9e15;  // what is counted in a double
  if (grid > 0) {
    const auto step = Exact::parse(format_number(grid));
    const double count = std::nearbyint(value / grid);
    if (step && std::abs(count) < most) return Exact(static_cast<std::int64_t>(count)) * *step;
  }
  if (!(unit > 0) || !std::isfinite(unit)) unit = 1;
  // Its digits, by way of its text: a logarithm of 0.001 might not be a whole number.
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.9e", unit);
  char* const e = std::strchr(text.data(), 'e');
  const int power = std::atoi(e + 1);
  *e = '\0';
  const double digits = std::strtod(text.data(), nullptr);
  const char* const first = digits <= 1 ? "1" : digits <= 2 ? "2" : digits <= 5 ? "5" : "10";
  const auto step = Exact::parse(std::string(first) + "e" + std::to_string(power));
  const double count = step ? std::nearbyint(value / step->to_double()) : most;
  return std::abs(count) < most ? Exact(static_cast<std::int64_t>(count)) * *step : Exact(value);
}

namespace {

// Exact strings become numbers where that is the same.
void to_numbers(Json& json) {
  if (json.kind == Json::Kind::string)
    if (const auto x = Exact::parse(json.text)) json = json_number(*x);
  for (Json& item : json.items) to_numbers(item);
}

}  // namespace

Json json_of(const Inputs<Exact>& inputs) {
  constexpr JsonLimits own_text{std::numeric_limits<std::uint32_t>::max(), 32, std::numeric_limits<std::size_t>::max()};
  std::vector<std::pair<std::string, Json>> members;
  for (const auto& [name, value] : inputs.values) {
    const auto document = JsonDocument::parse(name, write_input<Exact>(value), own_text);
    Json json = document->root();
    to_numbers(json);
    members.emplace_back(name, std::move(json));
  }
  return json_object(std::move(members));
}

std::string write_inputs(const Inputs<Exact>& inputs, int indent) { return write_json(json_of(inputs), indent); }

}  // namespace blossom
