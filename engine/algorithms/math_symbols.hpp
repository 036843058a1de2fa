#pragma once
// The commands of formulas (math.hpp) that stand for a sign or a word by themselves.

#include <span>
#include <string_view>

#include "algorithms/math.hpp"

namespace blossom {

struct MathSymbol {
  std::string_view command;  // without its backslash
  std::string_view text;     // UTF-8
  Math::Class of;
  bool upright = false;  // of a letter
};
std::span<const MathSymbol> math_symbols();

// The accents, by their combining characters.
struct MathAccent {
  std::string_view command, mark;
};
std::span<const MathAccent> math_accents();

// Whether an operation stands between two things here, or is the sign of what follows: the minus of -x, as TeX tells
// them apart by what stands before (nullptr: nothing).
bool is_sign(const Math* before);
// The symbol that says what stands around a part: the base of its scripts, and so on; nullptr if there is none.
const Math* nucleus(const Math&);

}  // namespace blossom
