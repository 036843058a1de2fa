#pragma once
// Text as it is set, in pieces.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "algorithms/math.hpp"

namespace blossom {

// A piece of a label: the baseline text, a subscript or a superscript (P with a subscript and a superscript is three).
struct TextRun {
  enum class Level : std::uint8_t { base, sub, super };
  std::string text;  // UTF-8
  Level level = Level::base;
  bool italic = false;
  bool bold = false;
  bool monospace = false;
  // A formula, set as one word in place of the text, which is then its plain text.
  std::shared_ptr<const Math> math = nullptr;
  bool display = false;  // of a formula: set as one that has a line of its own

  bool operator==(const TextRun& other) const {
    const bool same_math = math == nullptr ? other.math == nullptr : other.math != nullptr && *math == *other.math;
    return same_math && text == other.text && level == other.level && italic == other.italic && bold == other.bold &&
           monospace == other.monospace && display == other.display;
  }
};
// Lines end at '\n'. Where a line is too long for its place, its rest begins below the last '\t' of it, so that the
// lines of a list's item stand below each other; a tab has no width.
using RichText = std::vector<TextRun>;

}  // namespace blossom
