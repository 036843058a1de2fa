#pragma once
// Text as it is set, in pieces.

#include <cstdint>
#include <string>
#include <vector>

namespace blossom {

// A piece of a label: the baseline text, a subscript or a superscript (P with a subscript and a superscript is three).
struct TextRun {
  enum class Level : std::uint8_t { base, sub, super };
  std::string text;  // UTF-8
  Level level = Level::base;
  bool italic = false;
  bool bold = false;
  bool monospace = false;
  bool operator==(const TextRun&) const = default;
};
using RichText = std::vector<TextRun>;

}  // namespace blossom
