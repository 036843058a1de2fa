#include "base/scalar.hpp"

#include <algorithm>
#include <charconv>

namespace blossom {
namespace {

// Never "-0": a reader would take the sign for a meaning.
std::string without_negative_zero(std::string text) {
  return text.starts_with('-') && text.find_first_not_of("-0.") == std::string::npos ? text.substr(1) : text;
}

}  // namespace

std::string format_number(double x) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, x);
  return without_negative_zero({buffer, end});
}

std::string format_short(double x, int decimals) {
  if (!std::isfinite(x)) return format_number(x);
  char buffer[400];  // the largest double has 309 digits before the point
  const int shown = decimals < 0 ? 0 : decimals > 60 ? 60 : decimals;
  // From 10^15 on the digits before the point are more than a label can use, and more than a double knows.
  const auto format = std::abs(x) < 1e15 ? std::chars_format::fixed : std::chars_format::scientific;
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, x, format, shown);
  std::string text(buffer, end);
  const std::size_t exponent = std::min(text.find('e'), text.size());
  if (text.find('.') < exponent) {
    std::size_t last = text.find_last_not_of('0', exponent - 1);
    if (text[last] == '.') --last;
    text.erase(last + 1, exponent - last - 1);
  }
  return without_negative_zero(text);
}

std::string format_brief(const Exact& x) {
  constexpr std::size_t longest = 20;
  const double rounded = x.to_double();
  for (std::string text : {x.to_string(), format_number(rounded)})
    if (text.size() <= longest) return text;
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, rounded, std::chars_format::general, 12);
  return {buffer, end};
}

}  // namespace blossom
