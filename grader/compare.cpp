#include "grader/compare.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace blossom {
namespace {

Exact make_power_of_ten(int e) {
  const auto power = Exact::parse("1e" + std::to_string(std::clamp(e, -400, 400)));
  return power ? *power : Exact(0);
}

// Those of the digits that tolerances have are made once.
Exact power_of_ten(int e) {
  constexpr int usual = 16;
  static const auto made = [] {
    std::array<Exact, 2 * usual + 1> powers;
    for (int i = -usual; i <= usual; ++i) powers[static_cast<std::size_t>(i + usual)] = make_power_of_ten(i);
    return powers;
  }();
  return -usual <= e && e <= usual ? made[static_cast<std::size_t>(e + usual)] : make_power_of_ten(e);
}

// e with 10^e <= |v| < 10^(e+1); v != 0
int decimal_exponent(const Exact& v) {
  const Exact size = abs(v);
  const double rough = size.to_double();
  if (!(rough > 0) || !std::isfinite(rough)) return rough > 0 ? 308 : -308;
  int e = static_cast<int>(std::floor(std::log10(rough)));
  while (power_of_ten(e) > size) --e;
  while (power_of_ten(e + 1) <= size) ++e;
  return e;
}

// v as the rational that stands for it; nothing if it overflowed on the way.
std::optional<Exact> rational(const Exact& v) {
  if (!v.is_approximate()) return v;
  const double x = v.to_double();
  return std::isfinite(x) ? std::optional(Exact(x)) : std::nullopt;
}

bool all_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return '0' <= c && c <= '9'; });
}

}  // namespace

Exact slack(const Tolerance& tolerance, const Exact& v) {
  Exact allowed = 0;
  switch (tolerance.kind) {
    case Tolerance::Kind::exact:
      break;
    case Tolerance::Kind::decimals:
      allowed = Exact::ratio(1, 2) * power_of_ten(-tolerance.digits);
      break;
    case Tolerance::Kind::significant:
      if (v != Exact(0)) allowed = Exact::ratio(1, 2) * power_of_ten(decimal_exponent(v) - tolerance.digits + 1);
      break;
    case Tolerance::Kind::absolute:
      allowed = tolerance.amount;
      break;
    case Tolerance::Kind::relative:
      allowed = tolerance.amount * abs(v);
      break;
  }
  if (v.is_approximate()) allowed = std::max(allowed, Exact::ratio(1, 1'000'000'000) * std::max(Exact(1), abs(v)));
  return allowed;
}

Window window(const Tolerance& tolerance, const Exact& v) {
  const auto centre = rational(v);
  if (!centre) return {Exact(1), Exact(-1), 1, -1};  // nothing counts as infinity
  const auto allowed = rational(slack(tolerance, v));
  Window w{*centre - *allowed, *centre + *allowed};
  w.low_double = w.low.to_double();
  w.high_double = w.high.to_double();
  return w;
}

bool within(const Tolerance& tolerance, const Exact& v, const Exact& typed, double widening) {
  if (widening == 0 && typed == v) return true;
  const auto centre = rational(v);
  if (!centre) return false;
  const auto allowed = rational(slack(tolerance, v));
  // Doubles decide unless it is close: each of the three is off by half a unit of its 53rd bit, and so is what is made
  // of them.
  const double v_double = centre->to_double(), typed_double = typed.to_double();
  const double most = allowed->to_double() + (widening > 0 && std::isfinite(widening) ? widening : 0);
  const double distance_double = std::abs(typed_double - v_double);
  const double doubt = 1e-15 * (std::abs(typed_double) + std::abs(v_double) + most) + 1e-300;
  if (distance_double > most + doubt) return false;
  if (distance_double < most - doubt) return true;
  const Exact distance = abs(typed - *centre);
  return distance <= (widening > 0 && std::isfinite(widening) ? *allowed + Exact(widening) : *allowed);
}

std::optional<double> quick_double(std::string_view text) {
  constexpr std::size_t longest = 64;
  constexpr std::size_t digits_of_whole_double = 15;  // every whole number of so many digits is a double
  if (text.size() > longest) return std::nullopt;
  std::size_t slash = std::string_view::npos;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (('0' <= c && c <= '9') || c == '.' || (c == '-' && i == 0)) continue;
    if (c != '/' || slash != std::string_view::npos) return std::nullopt;
    slash = i;
  }
  const auto read = [](std::string_view t, double& out) {
    const auto [end, error] = std::from_chars(t.data(), t.data() + t.size(), out);
    return error == std::errc() && end == t.data() + t.size();
  };
  double x = 0;
  if (slash == std::string_view::npos) return read(text, x) ? std::optional(x) : std::nullopt;
  const std::string_view above = text.substr(0, slash);
  const std::string_view below = text.substr(slash + 1);
  double d = 0;
  if (above.size() > digits_of_whole_double || below.size() > digits_of_whole_double || !all_digits(below) ||
      !all_digits(above.substr(above.starts_with('-') ? 1 : 0)) || !read(above, x) || !read(below, d) || d == 0)
    return std::nullopt;
  return x / d;  // the division of two doubles rounds once
}

std::optional<Exact> parse_typed(std::string_view text) {
  // Zeros at the end of decimals mean nothing, but make long numbers.
  constexpr std::size_t longest = 64;
  if (text.size() <= longest && text.find('.') != std::string_view::npos &&
      text.find_first_of("eE/") == std::string_view::npos)
    while (text.ends_with("00")) text.remove_suffix(1);
  auto number = Exact::parse(text);
  if (number && !std::isfinite(number->to_double())) return std::nullopt;
  return number;
}

Fit fit(const Window& window, std::string_view typed) {
  if (const auto x = quick_double(typed)) {
    if (*x < window.low_double || *x > window.high_double) return Fit::outside;
    if (*x > window.low_double && *x < window.high_double) return Fit::inside;
  }
  const auto number = parse_typed(typed);
  if (!number) return Fit::no_number;
  return window.low <= *number && *number <= window.high ? Fit::inside : Fit::outside;
}

double last_place(std::string_view typed) {
  if (typed.find('/') != std::string_view::npos) return 0;
  const std::size_t exponent_at = typed.find_first_of("eE");
  const std::string_view mantissa = typed.substr(0, exponent_at);
  const std::size_t point = mantissa.find('.');
  const std::size_t decimals = point == std::string_view::npos ? 0 : mantissa.size() - point - 1;
  int e = 0;
  if (exponent_at != std::string_view::npos) {
    std::string_view digits = typed.substr(exponent_at + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    std::from_chars(digits.data(), digits.data() + digits.size(), e);
  }
  return power_of_ten(e - static_cast<int>(decimals)).to_double();
}

double rounding_of(std::string_view typed) {
  return typed.find('.') == std::string_view::npos ? 0 : last_place(typed) / 2;
}

}  // namespace blossom
