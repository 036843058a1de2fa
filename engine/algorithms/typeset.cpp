#include "algorithms/typeset.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

namespace blossom {
namespace {

using Level = TextRun::Level;

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '\''; }  // let's

// "a curve", and "A curve", "I see" where a sentence begins: words, not names of values. "A is", "a times" are about a
// value.
bool is_little_word(std::string_view text, std::size_t begin, std::size_t end) {
  if (end != begin + 1 || std::string_view("AIa").find(text[begin]) == std::string_view::npos) return false;
  if (end == text.size() || (text[end] != ' ' && text[end] != '\n')) return false;
  std::size_t stop = end + 1;
  while (stop < text.size() && std::islower(static_cast<unsigned char>(text[stop])) != 0) ++stop;
  const std::string_view next = text.substr(end + 1, stop - end - 1);
  static constexpr std::array<std::string_view, 7> after_names{"is", "and", "or", "to", "has", "lies", "times"};
  if (next.size() < 2 || std::ranges::find(after_names, next) != after_names.end()) return false;
  const std::size_t before = text.substr(0, begin).find_last_not_of(" \n\"(");
  return text[begin] != 'A' || before == std::string_view::npos ||
         std::string_view(".:!?").find(text[before]) != std::string_view::npos;
}

std::optional<std::string_view> letter_of(std::string_view symbol) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 5> letters{
      {{"alpha", "α"}, {"beta", "β"}, {"gamma", "γ"}, {"theta", "θ"}, {"Ubar", "Ū"}}};
  for (const auto& [name, letter] : letters)
    if (name == symbol) return letter;
  return std::nullopt;
}

bool has_levels(const Algorithm& algorithm, std::string_view symbol, std::size_t arity) {
  for (const ValueSpec& spec : algorithm.values)
    if (spec.symbol == symbol && spec.indices.size() == arity) return arity == 2 && spec.indices[0] == "r";
  return arity == 2 && letter_of(symbol).has_value();
}

// As books have it, U is a knot vector and u_3 a knot of it; a value that an algorithm computes keeps its own letter.
bool is_knot(const Algorithm& algorithm, std::string_view symbol, std::size_t arity) {
  if (symbol != "U" || arity == 0) return false;
  const auto spec = std::ranges::find_if(
      algorithm.values, [&](const ValueSpec& s) { return s.symbol == symbol && s.indices.size() == arity; });
  return spec != algorithm.values.end() ? spec->line == 0 : arity == 1;
}

// The homogeneous coordinates of a rational curve's points.
bool is_coordinate(std::string_view symbol) {
  return symbol == "w" || symbol == "wx" || symbol == "wy" || symbol == "wz";
}

void add_name(RichText& out, std::string_view symbol, const std::vector<std::string>& indices,
              const Algorithm& algorithm) {
  const std::string_view written = is_knot(algorithm, symbol, indices.size()) ? "u" : symbol;
  const bool levels = has_levels(algorithm, symbol, indices.size());
  out.push_back({std::string(letter_of(symbol).value_or(written)), Level::base, true});
  if (indices.empty()) return;
  if (levels && indices.size() == 2) {
    out.push_back({indices[1], Level::sub});
    if (indices[0] != "0") out.push_back({"(" + indices[0] + ")", Level::super});
    return;
  }
  std::string sub = indices[0];
  for (std::size_t i = 1; i < indices.size(); ++i) sub += "," + indices[i];
  out.push_back({sub, Level::sub});
}

void add_text(RichText& out, std::string_view text) {
  if (text.empty()) return;
  if (!out.empty() && out.back().level == Level::base && !out.back().italic)
    out.back().text += text;
  else
    out.push_back({std::string(text)});
}

}  // namespace

RichText typeset_name(const Name& name, const Algorithm& algorithm) {
  std::vector<std::string> indices;
  for (int i = 0; i < name.arity; ++i) indices.push_back(std::to_string(name.index[i]));
  RichText out;
  add_name(out, name.symbol.text(), indices, algorithm);
  return out;
}

RichText typeset_text(std::string_view text, const Algorithm& algorithm) {
  RichText out;
  std::size_t plain = 0;  // text from here on is not yet in out
  for (std::size_t i = 0; i < text.size();) {
    if (!is_letter(text[i]) || (i > plain && is_word(text[i - 1]))) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && is_letter(text[end])) ++end;
    const std::string_view symbol = text.substr(i, end - i);
    std::vector<std::string> indices;
    std::size_t after = end;
    if (after + 1 < text.size() && text[after] == '_') {  // u_k, u_{k+1}
      std::size_t stop = after + 1;
      if (text[stop] == '{') {
        stop = text.find('}', stop);
        if (stop != std::string_view::npos) {
          indices.emplace_back(text.substr(after + 2, stop - after - 2));
          after = stop + 1;
        }
      } else if (text[stop] == '(') {  // N_(3,2)
        const std::size_t close = text.find_first_not_of("0123456789,", stop + 1);
        if (close != std::string_view::npos && text[close] == ')' && close > stop + 1) {
          indices.emplace_back(text.substr(stop + 1, close - stop - 1));
          after = close + 1;
        }
      } else {
        while (stop < text.size() && std::isalnum(static_cast<unsigned char>(text[stop])) != 0) ++stop;
        indices.emplace_back(text.substr(after + 1, stop - after - 1));
        after = stop;
      }
    } else {
      while (after < text.size() && text[after] == '[' && indices.size() < 2) {
        const std::size_t stop = text.find(']', after);
        if (stop == std::string_view::npos || stop - after > 12 || stop == after + 1) break;
        indices.emplace_back(text.substr(after + 1, stop - after - 1));
        after = stop + 1;
      }
    }
    // A word is a name when it has indices, is a Greek letter, or is a single letter of the algorithm's table.
    const bool single = symbol.size() == 1 && algorithm.spec({Symbol::of(symbol), {0, 0}, 0}) != nullptr &&
                        !is_little_word(text, i, end);
    if (indices.empty() && !letter_of(symbol) && !single && !is_coordinate(symbol)) {
      i = end;
      continue;
    }
    add_text(out, text.substr(plain, i - plain));
    if (after + 1 < text.size() && text[after] == '.' && is_letter(text[after + 1]) && !indices.empty()) {
      add_text(out, symbol);  // the phase that a name belongs to
      out.push_back({indices[0], Level::sub});
      plain = after;
      i = after + 1;
      continue;
    }
    add_name(out, symbol, indices, algorithm);
    plain = i = after;
  }
  add_text(out, text.substr(plain));
  return out;
}

namespace {

// A subscript or superscript in the characters that Unicode has for it; nothing where it has none.
std::optional<std::string> raised_or_lowered(std::string_view text, bool low) {
  static constexpr std::array<std::string_view, 10> high{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  static constexpr std::array<std::string_view, 10> below{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  std::string made;
  for (const char c : text) {
    if (std::isdigit(static_cast<unsigned char>(c)) != 0)
      made += (low ? below : high)[static_cast<std::size_t>(c - '0')];
    else if (c == '+')
      made += low ? "₊" : "⁺";
    else if (c == '-')
      made += low ? "₋" : "⁻";
    else if (c == '(')
      made += low ? "₍" : "⁽";
    else if (c == ')')
      made += low ? "₎" : "⁾";
    else if (c == ',' && low)
      made += ',';
    else
      return std::nullopt;
  }
  return made;
}

}  // namespace

std::string unicode_text(const RichText& runs) {
  std::string text;
  for (const TextRun& run : runs) {
    const bool low = run.level == Level::sub;
    if (run.level == Level::base)
      text += run.text;
    else if (const auto made = raised_or_lowered(run.text, low))
      text += *made;
    else
      text += (low ? "_" : "^") + (run.text.size() == 1 ? run.text : "{" + run.text + "}");
  }
  return text;
}

}  // namespace blossom
