#pragma once
// A rule as data: what a trace stores about the function that made a value, and how to apply it again to other operands
// (a student's, say) in either scalar.

#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include "kernel/rules.hpp"

namespace blossom {

enum class ValueKind : std::uint8_t {
  integer,  // one number, whole
  scalar,   // one number
  point,    // four: w x, w y, w z, w
  vector,   // four, but no point of the curve (a right-hand side on the way through an elimination)
  list,     // any number: a knot vector
};

std::string_view kind_name(ValueKind);

// A value as plain numbers, in the order given at its kind.
template <Scalar S>
using Numbers = std::vector<S>;
template <Scalar S>
using NumbersView = std::span<const S>;

// Applies a rule. False, and nothing in `result`, when the operands are not of the rule's kinds or break its
// preconditions (a zero divisor).
template <Scalar S>
using Replay = bool (*)(std::span<const NumbersView<S>> operands, Numbers<S>& result);

struct RuleInfo {
  std::string_view name;
  std::string_view formula;
  Polar polar;
  ValueKind makes;
  Replay<double> replay_double;
  Replay<Exact> replay_exact;
  bool (*accepts)(std::span<const ValueKind> operands);  // whether the operands are of its kinds, and as many

  template <Scalar S>
  Replay<S> replay() const {
    if constexpr (std::same_as<S, double>)
      return replay_double;
    else
      return replay_exact;
  }
};

namespace detail {

template <class F>
struct Signature;
template <class Result, class... Arguments>
struct Signature<Result (*)(Arguments...)> {
  using Made = Result;
  using Operands = std::tuple<std::remove_cvref_t<Arguments>...>;
};
template <class Rule, Scalar S>
using RuleSignature = Signature<decltype(&Rule::template apply<S>)>;

template <class T>
inline constexpr bool is_span = false;
template <class T>
inline constexpr bool is_span<std::span<const T>> = true;

template <class T>
constexpr ValueKind kind_of() {
  if constexpr (std::is_same_v<T, int>)
    return ValueKind::integer;
  else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, Exact>)
    return ValueKind::scalar;
  else if constexpr (std::is_same_v<T, HPoint<double>> || std::is_same_v<T, HPoint<Exact>>)
    return ValueKind::point;
  else
    return ValueKind::list;
}

template <class Rule>
constexpr ValueKind rule_makes() {
  if constexpr (requires { Rule::makes_vector; }) return ValueKind::vector;
  return kind_of<typename RuleSignature<Rule, double>::Made>();
}

inline bool to_int(double x, int& out) {
  if (!(x >= -1e9 && x <= 1e9) || x != std::floor(x)) return false;
  out = static_cast<int>(x);
  return true;
}
inline bool to_int(const Exact& x, int& out) { return x.is_integer() && to_int(x.to_double(), out); }

// Reads one operand as T; a span takes either one list or, being last, all operands that are left.
template <Scalar S, class T>
bool read_operand(std::span<const NumbersView<S>> operands, std::size_t& at, bool last, std::vector<S>& gathered,
                  T& out) {
  if constexpr (is_span<T>) {
    if (last && !(operands.size() == at + 1 && operands[at].size() != 1)) {
      gathered.clear();
      for (; at < operands.size(); ++at) gathered.insert(gathered.end(), operands[at].begin(), operands[at].end());
      out = gathered;
      return true;
    }
    if (at >= operands.size()) return false;
    out = operands[at++];
    return true;
  } else {
    if (at >= operands.size()) return false;
    const auto numbers = operands[at++];
    if constexpr (std::is_same_v<T, int>) {
      return numbers.size() == 1 && to_int(numbers[0], out);
    } else if constexpr (std::is_same_v<T, S>) {
      if (numbers.size() != 1) return false;
      out = numbers[0];
      return true;
    } else {
      if (numbers.size() != 4) return false;
      out = {numbers[0], numbers[1], numbers[2], numbers[3]};
      return true;
    }
  }
}

template <class T>
bool accepts_operand(std::span<const ValueKind> operands, std::size_t& at, bool last) {
  const auto is_number = [](ValueKind kind) { return kind == ValueKind::integer || kind == ValueKind::scalar; };
  if constexpr (is_span<T>) {
    if (last && at < operands.size() && operands[at] != ValueKind::list) {
      while (at < operands.size() && is_number(operands[at])) ++at;
      return at == operands.size();
    }
    return at < operands.size() && operands[at++] == ValueKind::list;
  } else {
    if (at >= operands.size()) return false;
    const ValueKind kind = operands[at++];
    if constexpr (std::is_same_v<T, int>) return kind == ValueKind::integer;
    if constexpr (kind_of<T>() == ValueKind::scalar) return is_number(kind);
    return kind == ValueKind::point || kind == ValueKind::vector;
  }
}

template <class Rule>
bool accepts(std::span<const ValueKind> operands) {
  using Operands = typename RuleSignature<Rule, double>::Operands;
  constexpr std::size_t count = std::tuple_size_v<Operands>;
  std::size_t at = 0;
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return (accepts_operand<std::tuple_element_t<I, Operands>>(operands, at, I + 1 == count) && ...);
  }
  (std::make_index_sequence<count>{}) && at == operands.size();
}

inline void write_result(int made, Numbers<double>& out) { out.assign(1, made); }
inline void write_result(int made, Numbers<Exact>& out) { out.assign(1, Exact(made)); }
template <Scalar S>
void write_result(const S& made, Numbers<S>& out) {
  out.assign(1, made);
}
template <Scalar S>
void write_result(const HPoint<S>& made, Numbers<S>& out) {
  out.assign({made.x, made.y, made.z, made.w});
}
template <Scalar S>
void write_result(std::vector<S>&& made, Numbers<S>& out) {
  out = std::move(made);
}

template <class Rule, Scalar S>
bool replay(std::span<const NumbersView<S>> operands, Numbers<S>& result) {
  using Operands = typename RuleSignature<Rule, S>::Operands;
  constexpr std::size_t count = std::tuple_size_v<Operands>;
  Operands arguments;
  std::vector<S> gathered;
  std::size_t at = 0;
  const bool read = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return (read_operand<S>(operands, at, I + 1 == count, gathered, std::get<I>(arguments)) && ...);
  }
  (std::make_index_sequence<count>{});
  if (!read || at != operands.size()) return false;
  return std::apply(
      [&](const auto&... a) {
        if constexpr (requires { Rule::template defined<S>(a...); })
          if (!Rule::template defined<S>(a...)) return false;
        write_result(Rule::template apply<S>(a...), result);
        return true;
      },
      arguments);
}

}  // namespace detail

template <class Rule>
inline constexpr RuleInfo rule_info{Rule::name,
                                    Rule::formula,
                                    Rule::polar,
                                    detail::rule_makes<Rule>(),
                                    &detail::replay<Rule, double>,
                                    &detail::replay<Rule, Exact>,
                                    &detail::accepts<Rule>};

}  // namespace blossom
