#pragma once
// The two scalars everything is computed in: double, and the exact rational.

#include <cmath>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>

#include "base/exact.hpp"

namespace blossom {

template <class S>
concept Scalar = std::same_as<S, double> || std::same_as<S, Exact>;

inline double to_double(double x) { return x; }
inline double to_double(const Exact& x) { return x.to_double(); }

inline bool is_approximate(double) { return false; }
inline bool is_approximate(const Exact& x) { return x.is_approximate(); }

// From an exact value to the scalar of a run: the value itself, or the nearest double.
template <Scalar S>
S from_exact(const Exact& x) {
  if constexpr (std::same_as<S, double>) {
    return x.to_double();
  } else {
    return x;
  }
}

// The text of a number as people read it: a fraction "p/q"; a double with the fewest digits that read back as the same
// double ("0.1", "1e-07", "-3"). Negative zero prints as "0".
std::string format_number(double);
inline std::string format_number(const Exact& x) { return x.to_string(); }

// At most `decimals` digits after the point, trailing zeros removed: for tables and labels.
std::string format_short(double, int decimals);

// For messages: the first that takes at most 20 characters of the fraction, the shortest decimal of the nearest double,
// and 12 significant digits of it.
std::string format_brief(const Exact&);

// The inverse of format_number; what Exact::parse accepts, rounded to S once.
template <Scalar S>
std::optional<S> parse_number(std::string_view text) {
  const auto exact = Exact::parse(text);
  return exact ? std::optional<S>(from_exact<S>(*exact)) : std::nullopt;
}

}  // namespace blossom
