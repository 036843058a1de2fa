#pragma once
// Formulas that are said in words.

#include <algorithm>
#include <string_view>

namespace blossom {

// "the index k of the span of U that holds u", not written in symbols: it has two words of letters alone. "(wx, wy) / w
// of P[2][0]" has one. Such a formula is no side of an equation: the value goes first.
inline bool is_sentence(std::string_view formula) {
  int words = 0;
  for (std::size_t begin = 0, end = 0; begin < formula.size(); begin = end + 1) {
    end = std::min(formula.find(' ', begin), formula.size());
    const std::string_view word = formula.substr(begin, end - begin);
    words += word.size() > 1 && std::ranges::all_of(word, [](char c) { return 'a' <= c && c <= 'z'; });
  }
  return words > 1;
}

}  // namespace blossom
