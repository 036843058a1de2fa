// Names and values in the TeX of formulas.
#include <array>
#include <cctype>
#include <string>

#include "algorithms/math_symbols.hpp"
#include "algorithms/typeset.hpp"

namespace blossom {
namespace {

bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

// One number: "3/5", "0.25", "1e-07"; its sign stands before it.
std::string tex_number(std::string_view number) {
  if (const auto slash = number.find('/'); slash != std::string_view::npos)
    return "\\frac{" + std::string(number.substr(0, slash)) + "}{" + std::string(number.substr(slash + 1)) + "}";
  const auto e = number.find('e');
  if (e == std::string_view::npos) return std::string(number);
  std::string_view power = number.substr(e + 1);
  const bool negative = power.starts_with('-');
  power.remove_prefix(std::min(power.find_first_not_of("+-0"), power.size()));
  return std::string(number.substr(0, e)) + " \\cdot 10^{" + (negative ? "-" : "") + std::string(power) + "}";
}

std::string tex_symbol(const std::string& letter) {
  if (letter == "Ū") return "\\bar{U}";
  for (const MathSymbol& known : math_symbols())
    if (known.text == letter && known.of == Math::Class::variable) return "\\" + std::string(known.command);
  return letter.size() == 1 ? letter : "\\mathrm{" + letter + "}";
}

}  // namespace

std::string tex_value(std::string_view text) {
  std::string tex;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    if (is_digit(text[i])) {
      const auto goes_on = [&](std::size_t at) {
        const char c = text[at];
        if (is_digit(c) || c == '.' || c == '/' || c == 'e') return true;
        return (c == '-' || c == '+') && text[at - 1] == 'e';
      };
      while (end < text.size() && goes_on(end)) ++end;
      tex += tex_number(text.substr(i, end - i));
    } else if (is_letter(text[i])) {
      while (end < text.size() && (is_letter(text[end]) || text[end] == ' ')) ++end;
      const std::string words(text.substr(i, end - i));
      const bool single = words.size() == 1 || (words.size() == 2 && words[1] == ' ');  // the w of "w = 2"
      tex += single ? words : "\\text{" + words + "}";
    } else {
      end = i + 1;
      tex += text[i];
    }
    i = end;
  }
  return tex;
}

std::string tex_name(const RichText& name) {
  std::string tex;
  for (const TextRun& run : name) {
    if (run.level == TextRun::Level::base)
      tex += tex_symbol(run.text);
    else
      tex += (run.level == TextRun::Level::sub ? "_{" : "^{") + run.text + "}";
  }
  return tex;
}

}  // namespace blossom
