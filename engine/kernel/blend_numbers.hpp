#pragma once

#include "kernel/rules.hpp"

namespace blossom {

// (1 - a) x + a y of numbers
struct BlendNumbers {
  static constexpr std::string_view name = "blend_numbers";
  static constexpr std::string_view formula = Blend::formula;
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a, const S& x, const S& y) {
    return (S(1) - a) * x + a * y;
  }
};

}  // namespace blossom
