#pragma once
// How many bytes the UTF-8 character takes that begins at text[i] (Unicode 15, table 3-7: no overlong forms, no
// surrogates, nothing beyond U+10FFFF); 0 if none does.

#include <cstddef>
#include <string_view>

namespace blossom {

constexpr std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0u; };
  const auto continues = [&](std::size_t at) { return (byte(at) & 0xC0u) == 0x80u; };
  const unsigned first = byte(i), second = byte(i + 1);
  if (first < 0x80) return i < text.size() ? 1 : 0;
  if (first < 0xC2 || first > 0xF4 || !continues(i + 1)) return 0;
  if (first < 0xE0) return 2;
  if (!continues(i + 2)) return 0;
  if (first < 0xF0) return (first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) ? 0 : 3;
  if (!continues(i + 3)) return 0;
  return (first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F) ? 0 : 4;
}

}  // namespace blossom
