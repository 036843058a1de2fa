#pragma once
// Errors, bounds on them, and whether they are small enough. What rounding leaves of zero is zero: the double and the
// exact run must decide alike, so both allow 1e-9 of the size of the points beyond the tolerance.

#include "kernel/rules.hpp"

namespace blossom {

// Whether an error keeps the tolerance: 1 or 0. The formula leaves out what counts as rounding.
struct Within {
  static constexpr std::string_view name = "within";
  static constexpr std::string_view formula = "1 if {0} <= {1}, else 0";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static int apply(const S& error, const S& tolerance, const S& rounding) {
    return error <= tolerance + rounding ? 1 : 0;
  }
};

// The largest of several numbers
struct Largest {
  static constexpr std::string_view name = "largest";
  static constexpr std::string_view formula = "largest of {*}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(std::span<const S> a) {
    return *std::max_element(a.begin(), a.end());
  }
  template <Scalar S>
  static bool defined(std::span<const S> a) {
    return !a.empty();
  }
};

// 1e-9 of the largest coordinate or weight
template <Scalar S>
S rounding_of(std::span<const HPoint<S>> points) {
  S size(0);
  for (const auto& P : points) {
    for (int c = 0; c < 4; ++c) {
      const S coordinate = P[c] < S(0) ? S(-P[c]) : P[c];
      if (size < coordinate) size = coordinate;
    }
  }
  return size / S(1000000000);
}

}  // namespace blossom
