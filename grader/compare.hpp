#pragma once
// Tolerances: when a typed number counts as the right one. A number is judged by its own text, as the exact rational
// that was typed, and at the boundary inclusively, so that the verdict is the same on every machine.

#include <optional>
#include <string>
#include <string_view>

#include "base/scalar.hpp"

namespace blossom {

struct Tolerance {
  enum class Kind : std::uint8_t {
    exact,        // |t - v| = 0
    decimals,     // |t - v| <= 1/2 10^-digits: v rounded to so many decimals, halves either way, or anything nearer
    significant,  // |t - v| <= 1/2 10^(e - digits + 1), 10^e <= |v| < 10^(e+1); v = 0 allows 0 only
    absolute,     // |t - v| <= amount
    relative,     // |t - v| <= amount |v|
  };
  Kind kind = Kind::exact;
  int digits = 0;
  Exact amount = 0;
};

// How far t may be from v. A v known in double precision only is allowed 1e-9 max(1, |v|) at least.
Exact slack(const Tolerance&, const Exact& v);

// All numbers that count as v: [low, high]. Nearest doubles are monotonic, so the double of a typed number decides
// unless it is the double of a boundary.
struct Window {
  Exact low;
  Exact high;
  double low_double = 0;
  double high_double = 0;
};
Window window(const Tolerance&, const Exact& v);

// `widening`: what else is granted on both sides, because v itself is known only so well.
bool within(const Tolerance&, const Exact& v, const Exact& typed, double widening = 0);

// The nearest double of a short plain number such as "-0.25", "3" or "2/5"; nothing when it takes a closer look.
std::optional<double> quick_double(std::string_view text);

// A number as a person may type it: what Exact::parse accepts, below the largest double.
std::optional<Exact> parse_typed(std::string_view text);

enum class Fit : std::uint8_t { inside, outside, no_number };
Fit fit(const Window&, std::string_view typed);

// One unit of the last digit of a typed decimal: 0.01 of "3.25", 1 of "325"; 0 of a fraction.
double last_place(std::string_view typed);

// How far the number behind a typed decimal may be from it: half a unit of its last digit; 0 for whole numbers and
// fractions, which are what they are.
double rounding_of(std::string_view typed);

}  // namespace blossom
