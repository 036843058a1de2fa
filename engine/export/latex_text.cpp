#include "export/latex_text.hpp"

#include <array>
#include <cstdio>
#include <map>
#include <set>

#include "algorithms/math_symbols.hpp"
#include "render/font.hpp"

namespace blossom {
namespace {

// As they are in a formula: the signs that formulas know, and others that texts have.
const std::map<char32_t, std::string>& commands() {
  static const auto table = [] {
    std::map<char32_t, std::string> all{{U'ο', "o"},        {U'ς', "\\varsigma"},   {U'υ', "\\upsilon"},
                                        {U'Ū', "\\bar{U}"}, {U'·', "\\cdot"},       {U'÷', "\\div"},
                                        {U'−', "-"},        {U'°', "^{\\circ}"},    {U'′', "'"},
                                        {U'″', "''"},       {U'∼', "\\sim"},        {U'≡', "\\equiv"},
                                        {U'←', "\\gets"},   {U'∉', "\\notin"},      {U'∇', "\\nabla"},
                                        {U'√', "\\surd"},   {U'⇒', "\\Rightarrow"}, {U'↔', "\\leftrightarrow"},
                                        {U'‖', "\\|"},      {U'⟨', "\\langle"},     {U'⟩', "\\rangle"},
                                        {U'…', "\\ldots"},  {U'•', "\\bullet"},     {U'⁺', "^{+}"},
                                        {U'⁻', "^{-}"},     {U'⁽', "^{(}"},         {U'⁾', "^{)}"},
                                        {U'ⁿ', "^{n}"},     {U'₊', "_{+}"},         {U'₋', "_{-}"},
                                        {U'₍', "_{(}"},     {U'₎', "_{)}"},         {U'½', "\\tfrac{1}{2}"},
                                        {U'«', "\\ll"},     {U'»', "\\gg"},         {U'‹', "<"},
                                        {U'›', ">"},        {U'✓', "\\surd"}};
    constexpr std::u32string_view raised = U"⁰¹²³⁴⁵⁶⁷⁸⁹", lowered = U"₀₁₂₃₄₅₆₇₈₉";
    for (std::size_t digit = 0; digit < 10; ++digit) {
      all[raised[digit]] = "^{" + std::to_string(digit) + "}";
      all[lowered[digit]] = "_{" + std::to_string(digit) + "}";
    }
    for (const MathSymbol& symbol : math_symbols()) {
      const std::u32string text = decode_utf8(symbol.text);
      if (text.size() == 1 && text[0] >= 0x80) all.emplace(text[0], "\\" + std::string(symbol.command));
    }
    return all;
  }();
  return table;
}

// As they are in text, where LaTeX itself has nothing for them in the fonts that are always there.
const std::map<char32_t, std::string_view>& letters() {
  static const std::map<char32_t, std::string_view> table{
      {U'Ð', "D"},        {U'ð', "d"},      {U'Þ', "Th"},     {U'þ', "th"},       {U'Đ', "D"},      {U'đ', "d"},
      {U'Ą', "A"},        {U'ą', "a"},      {U'Ę', "E"},      {U'ę', "e"},        {U'Į', "I"},      {U'į', "i"},
      {U'Ų', "U"},        {U'ų', "u"},      {U'Ħ', "H"},      {U'ħ', "h"},        {U'ĸ', "q"},      {U'Ŀ', "L"},
      {U'ŀ', "l"},        {U'ŉ', "n"},      {U'Ŋ', "N"},      {U'ŋ', "n"},        {U'Ŧ', "T"},      {U'ŧ', "t"},
      {U'ſ', "s"},        {U'‚', ","},      {U'„', ",,"},     {U'\u00AD', "\\-"}, {U'\u00A0', "~"}, {U'\u2009', "\\,"},
      {U'\u202F', "\\,"}, {U'\u2011', "-"}, {U'\u2010', "-"}, {U'\uFEFF', ""}};
  return table;
}

// What the kernel's own declarations have for the fonts that are always there.
bool known_to_latex(char32_t c) {
  static constexpr std::u32string_view others = U"–—‘’“”€ȘșȚț";
  return (c >= 0xA1 && c <= 0x17F) || others.find(c) != std::u32string_view::npos;
}

std::string number_of(char32_t c) {
  std::array<char, 16> hex{};
  std::snprintf(hex.data(), hex.size(), "%04X", static_cast<unsigned>(c));
  return hex.data();
}

}  // namespace

std::string latex_text(std::string_view utf8) {
  std::string out;
  bool opening = true;  // of the next straight quotation mark
  for (const char32_t c : decode_utf8(utf8)) {
    switch (c) {
      case U'\\':
        out += "\\textbackslash{}";
        break;
      case U'{':
      case U'}':
      case U'$':
      case U'&':
      case U'#':
      case U'%':
      case U'_':
        out += '\\';
        out += static_cast<char>(c);
        break;
      case U'~':
        out += "\\textasciitilde{}";
        break;
      case U'^':
        out += "\\textasciicircum{}";
        break;
      case U'<':
        out += "\\textless{}";
        break;
      case U'>':
        out += "\\textgreater{}";
        break;
      case U'|':
        out += "\\textbar{}";
        break;
      case U'"':
        out += opening ? "``" : "''";
        break;
      case U'-':
        out += out.ends_with('-') ? "{}-" : "-";  // no dashes are meant
        break;
      default:
        if (c >= 0x20 && c != 0x7F)
          out += encode_utf8(c);
        else if (c == U'\n' || c == U'\t')
          out += ' ';
    }
    opening = c == U' ' || c == U'(' || c == U'[' || c == U'\n';
  }
  return out;
}

std::string latex_symbol(std::string_view utf8) {
  const std::u32string symbol = decode_utf8(utf8);
  if (symbol.size() != 1) return "\\mathrm{" + latex_text(utf8) + "}";
  if (const auto found = commands().find(symbol[0]); found != commands().end()) return found->second;
  return latex_text(utf8);
}

std::string unicode_declarations(std::string_view document) {
  std::set<char32_t> used;
  for (const char32_t c : decode_utf8(document))
    if (c >= 0x80) used.insert(c);
  std::string out;
  for (const char32_t c : used) {
    std::string meaning;
    if (const auto math = commands().find(c); math != commands().end())
      meaning = "\\ensuremath{" + math->second + "}";
    else if (const auto text = letters().find(c); text != letters().end())
      meaning = text->second;
    else if (known_to_latex(c))
      continue;
    else
      meaning = "\\texttt{[U+" + number_of(c) + "]}";
    out += "\\DeclareUnicodeCharacter{" + number_of(c) + "}{" + meaning + "}\n";
  }
  return out;
}

}  // namespace blossom
