#include "algorithms/run.hpp"

#include <charconv>
#include <cmath>

#include "geometry/document.hpp"
#include "kernel/error.hpp"

namespace blossom {
namespace {

inline constexpr std::size_t max_profiles = 256;

}  // namespace

std::optional<InputValue<Exact>> read_input(const InputSpec& spec, const Cursor& at) {
  switch (spec.type) {
    case InputSpec::Type::number:
      if (auto x = at.number()) return InputValue<Exact>(std::move(*x));
      return std::nullopt;
    case InputSpec::Type::integer:
      if (const auto i = at.integer(spec.at_least, spec.at_most)) return InputValue<Exact>(*i);
      return std::nullopt;
    case InputSpec::Type::choice: {
      auto text = at.string();
      if (!text) return std::nullopt;
      std::vector<std::string> choices(spec.choices.begin(), spec.choices.end());
      if (std::find(choices.begin(), choices.end(), *text) != choices.end()) return InputValue<Exact>(std::move(*text));
      std::string message = "must be one of";
      for (std::size_t i = 0; i < choices.size(); ++i) message += (i > 0 ? ", " : " ") + json_quote(choices[i]);
      if (const auto near = did_you_mean(*text, choices)) message += "; did you mean " + json_quote(*near) + "?";
      at.error(message);
      return std::nullopt;
    }
    case InputSpec::Type::curve:
      if (auto c = read_curve(at)) return InputValue<Exact>(std::move(*c));
      return std::nullopt;
    case InputSpec::Type::surface:
      if (auto s = read_surface(at)) return InputValue<Exact>(std::move(*s));
      return std::nullopt;
    case InputSpec::Type::curves: {
      if (!at.expect_array(static_cast<std::size_t>(spec.at_least), max_profiles)) return std::nullopt;
      std::vector<Curve<Exact>> curves;
      bool all = true;
      for (std::size_t i = 0; i < at.size(); ++i) {
        if (auto c = read_curve(at[i]))
          curves.push_back(std::move(*c));
        else
          all = false;
      }
      if (!all) return std::nullopt;
      return InputValue<Exact>(std::move(curves));
    }
    case InputSpec::Type::numbers: {
      if (!at.expect_array(static_cast<std::size_t>(spec.at_least), static_cast<std::size_t>(spec.at_most)))
        return std::nullopt;
      std::vector<Exact> numbers;
      for (std::size_t i = 0; i < at.size(); ++i)
        if (auto x = at[i].number()) numbers.push_back(std::move(*x));
      if (numbers.size() != at.size()) return std::nullopt;
      return InputValue<Exact>(std::move(numbers));
    }
    case InputSpec::Type::points:
      if (auto row = read_points(at, static_cast<std::size_t>(spec.at_least), static_cast<std::size_t>(spec.at_most)))
        return InputValue<Exact>(std::move(*row));
      return std::nullopt;
    case InputSpec::Type::net:
      if (auto net = read_net(at)) return InputValue<Exact>(std::move(*net));
      return std::nullopt;
  }
  return std::nullopt;
}

std::optional<Inputs<Exact>> read_inputs(const Algorithm& algorithm, const Cursor& at) {
  std::vector<std::string> known;
  for (const auto& spec : algorithm.inputs) known.emplace_back(spec.name);
  if (!at.expect_object(known)) return std::nullopt;
  Inputs<Exact> inputs;
  bool all = true;
  for (const auto& spec : algorithm.inputs) {
    std::optional<InputValue<Exact>> value;
    if (const auto member = at.optional(spec.name)) {
      value = read_input(spec, *member);
    } else if (spec.fallback.empty()) {
      at.required(spec.name);
    } else {
      const auto document = JsonDocument::parse("default", std::string(spec.fallback));
      Diagnostics none_expected;
      value = read_input(spec, Cursor(*document, none_expected));
    }
    if (value)
      inputs.values.emplace(std::string(spec.name), std::move(*value));
    else
      all = false;
  }
  if (!all) return std::nullopt;
  if (algorithm.check != nullptr) {
    bool wrong = false;
    algorithm.check(inputs, [&](std::string_view name) {
      wrong = true;
      const auto member = at.optional(name);
      return member ? *member : at;
    });
    if (wrong) return std::nullopt;
  }
  return inputs;
}

namespace {

Diagnostics as_diagnostics(const KernelError& error) { return {Diagnostic{"", 0, 0, error.input, error.message}}; }

// Dimension and kind of what is traced: of its curves and surfaces, given and made.
template <Scalar S>
void describe(const Algorithm& algorithm, const Inputs<S>& inputs, const Outcome<S>& outcome, int& dimension,
              bool& rational) {
  const auto curve = [&](const Curve<S>& c) {
    dimension = std::max(dimension, c.dimension);
    rational = rational || c.rational;
  };
  const auto surface = [&](const Surface<S>& s) {
    dimension = 3;
    rational = rational || s.rational;
  };
  dimension = 2;
  rational = false;
  if (const auto* c = std::get_if<Curve<S>>(&outcome)) curve(*c);
  if (const auto* s = std::get_if<Surface<S>>(&outcome)) surface(*s);
  if (const auto* cs = std::get_if<std::vector<Curve<S>>>(&outcome))
    for (const auto& c : *cs) curve(c);
  if (const auto* ss = std::get_if<std::vector<Surface<S>>>(&outcome))
    for (const auto& s : *ss) surface(s);
  for (const auto& [name, value] : inputs.values) {
    if (const auto* c = std::get_if<Curve<S>>(&value)) curve(*c);
    if (const auto* cs = std::get_if<std::vector<Curve<S>>>(&value))
      for (const auto& c : *cs) curve(c);
    if (const auto* s = std::get_if<Surface<S>>(&value)) surface(*s);
    if (const auto* row = std::get_if<PointRow<S>>(&value)) dimension = std::max(dimension, row->dimension);
    if (std::holds_alternative<PointNet<S>>(value)) dimension = 3;
  }
  if (algorithm.lifts) {
    dimension = 3;
    rational = false;
  }
}

template <Scalar S>
Diagnostics overflow() {
  std::string message = "on the way numbers become too large for double precision (above 1.8e308): ";
  if constexpr (std::same_as<S, double>) {
    message += "compute exactly, or scale the input down";
  } else {
    message += "scale the input down (exact arithmetic has square roots in double precision)";
  }
  return {Diagnostic{"", 0, 0, "", message}};
}

bool is_finite(double x) { return std::isfinite(x); }
bool is_finite(const Exact& x) { return !x.is_approximate() || std::isfinite(x.to_double()); }
// Its coordinates, too, where it is no point at infinity.
template <Scalar S>
bool is_finite(const HPoint<S>& P) {
  if constexpr (std::same_as<S, double>) {
    const double w = P.w == 0 ? 1 : P.w;
    return is_finite(P.x / w) && is_finite(P.y / w) && is_finite(P.z / w) && is_finite(P.w);
  } else {
    return is_finite(P.x) && is_finite(P.y) && is_finite(P.z) && is_finite(P.w);
  }
}
template <Scalar S>
bool is_finite(const Outcome<S>& outcome) {
  if (const auto* P = std::get_if<HPoint<S>>(&outcome)) return is_finite(*P);
  const auto all = [](const auto& points) {
    return std::ranges::all_of(points, [](const HPoint<S>& P) { return is_finite(P); });
  };
  const auto each = [&](const auto& pieces) {
    return std::ranges::all_of(pieces, [&](const auto& piece) { return all(piece.points); });
  };
  if (const auto* curve = std::get_if<Curve<S>>(&outcome)) return all(curve->points);
  if (const auto* curves = std::get_if<std::vector<Curve<S>>>(&outcome)) return each(*curves);
  if (const auto* surfaces = std::get_if<std::vector<Surface<S>>>(&outcome)) return each(*surfaces);
  return all(std::get<Surface<S>>(outcome).points);
}
template <Scalar S>
bool is_finite(const Trace<S>& trace) {
  for (ValueId v = 0; v < trace.value_count(); ++v) {
    const auto numbers = trace.numbers(v);
    const bool finite = trace.value(v).kind == ValueKind::point
                            ? is_finite(HPoint<S>(numbers[0], numbers[1], numbers[2], numbers[3]))
                            : std::ranges::all_of(numbers, [](const S& x) { return is_finite(x); });
    if (!finite) return false;
  }
  return true;
}

}  // namespace

namespace {

// About four seconds of exact arithmetic.
constexpr std::uint64_t exact_work = 400'000'000;

// What a run throws, as a diagnostic.
template <class Run>
auto guarded(Run&& run) -> decltype(run()) {
  const ExactBudget budget(exact_work);
  try {
    return run();
  } catch (const KernelError& error) {
    return as_diagnostics(error);
  } catch (const ExactTooLarge&) {
    return Diagnostics{
        {"", 0, 0, "",
         "the fractions grow too long for exact arithmetic: compute in decimals, or take fewer or simpler numbers"}};
  } catch (const TraceTooLarge&) {
    return Diagnostics{
        {"", 0, 0, "",
         "the run makes more than " + std::to_string(most_values) + " values: take fewer control points or profiles"}};
  }
}

}  // namespace

template <Scalar S>
Checked<Run<S>> record(const Algorithm& algorithm, const Inputs<Exact>& inputs) {
  return guarded([&]() -> Checked<Run<S>> {
    Run<S> run;
    run.algorithm = &algorithm;
    run.inputs = convert<S>(inputs);
    TraceRecorder<S> recorder;
    try {
      run.outcome = algorithm.runner<S>().recorded(run.inputs, recorder);
    } catch (const KernelError&) {
      // Of infinities and NaNs the kernel may say anything: that profiles coincide, that a weight is 0.
      if (!is_finite(recorder.trace())) return overflow<S>();
      throw;
    }
    run.trace = std::move(recorder).take();
    if (!is_finite(run.outcome) || !is_finite(run.trace)) return overflow<S>();
    describe(algorithm, run.inputs, run.outcome, run.trace.dimension, run.trace.rational);
    return run;
  });
}

template <Scalar S>
Checked<Outcome<S>> run_plain(const Algorithm& algorithm, const Inputs<Exact>& inputs) {
  return guarded([&]() -> Checked<Outcome<S>> {
    try {
      auto outcome = algorithm.runner<S>().plain(convert<S>(inputs));
      if (!is_finite(outcome)) return overflow<S>();
      return outcome;
    } catch (const KernelError&) {
      return record<S>(algorithm, inputs).diagnostics;  // which can tell what is wrong from what comes of an overflow
    }
  });
}

namespace {

// The place of a path such as profiles[2] below `at`: as much of it as the file has (an input may be left out).
Cursor locate(Cursor at, std::string_view path) {
  while (!path.empty()) {
    if (path[0] == '[') {
      const std::size_t end = std::min(path.find(']'), path.size() - 1);
      std::size_t index = 0;
      std::from_chars(path.data() + 1, path.data() + end, index);
      if (!at.is(Json::Kind::array) || index >= at.size()) return at;
      at = at[index];
      path.remove_prefix(end + 1);
    } else {
      if (path[0] == '.') path.remove_prefix(1);
      const std::size_t end = std::min(path.find_first_of(".["), path.size());
      const auto member = at.is(Json::Kind::object) ? at.optional(path.substr(0, end)) : std::nullopt;
      if (!member) return at;
      at = *member;
      path.remove_prefix(end);
    }
  }
  return at;
}

}  // namespace

void report_at(const Cursor& inputs, const Diagnostics& of_run) {
  for (const auto& diagnostic : of_run) locate(inputs, diagnostic.path).error(diagnostic.message);
}

template <Scalar S>
std::string write_input(const InputValue<S>& value) {
  return std::visit(
      [](const auto& x) -> std::string {
        using T = std::decay_t<decltype(x)>;
        if constexpr (std::is_same_v<T, S>) {
          if constexpr (std::is_same_v<S, Exact>)
            return json_quote(x.to_string());
          else
            return format_number(x);
        } else if constexpr (std::is_same_v<T, int>) {
          return std::to_string(x);
        } else if constexpr (std::is_same_v<T, std::string>) {
          return json_quote(x);
        } else if constexpr (std::is_same_v<T, Curve<S>>) {
          return write_curve(x);
        } else if constexpr (std::is_same_v<T, Surface<S>>) {
          return write_surface(x);
        } else if constexpr (std::is_same_v<T, PointRow<S>>) {
          return write_points(x);
        } else if constexpr (std::is_same_v<T, PointNet<S>>) {
          return write_net(x);
        } else {
          std::string text = "[";
          for (std::size_t i = 0; i < x.size(); ++i) {
            text += i > 0 ? ", " : "";
            if constexpr (std::is_same_v<T, std::vector<Curve<S>>>)
              text += write_curve(x[i]);
            else
              text += write_input<S>(InputValue<S>(x[i]));
          }
          return text + "]";
        }
      },
      value);
}

template Checked<Run<double>> record(const Algorithm&, const Inputs<Exact>&);
template Checked<Run<Exact>> record(const Algorithm&, const Inputs<Exact>&);
template Checked<Outcome<double>> run_plain(const Algorithm&, const Inputs<Exact>&);
template Checked<Outcome<Exact>> run_plain(const Algorithm&, const Inputs<Exact>&);
template std::string write_input(const InputValue<double>&);
template std::string write_input(const InputValue<Exact>&);

}  // namespace blossom
