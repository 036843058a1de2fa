#pragma once
// What a text in UTF-8 is made of (Unicode 15, table 3-7: no overlong forms, no surrogates, nothing beyond U+10FFFF).

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace blossom {

// How many bytes the character takes that begins at text[i]; 0 if none does.
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

// How many characters (code points) the text has; a byte that is none counts as one.
constexpr std::size_t utf8_count(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++count) i += std::max<std::size_t>(utf8_length(text, i), 1);
  return count;
}

// A character that does something to the text around it rather than being seen: U+0000..U+001F, U+007F..U+009F (a
// terminal obeys them), U+2028 and U+2029 (they break the line), U+202A..U+202E and U+2066..U+2069 (they turn its
// direction). `character` is one valid character.
constexpr bool is_control(std::string_view character) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(character[at]); };
  if (character.size() == 1) return byte(0) < 0x20 || byte(0) == 0x7F;
  if (character.size() == 2) return byte(0) == 0xC2 && byte(1) < 0xA0;
  if (character.size() != 3 || byte(0) != 0xE2) return false;
  return (byte(1) == 0x80 && 0xA8 <= byte(2) && byte(2) <= 0xAE) ||
         (byte(1) == 0x81 && 0xA6 <= byte(2) && byte(2) <= 0xA9);
}

}  // namespace blossom
