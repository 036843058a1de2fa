#pragma once
// The first half of reading prose: what of CommonMark is wanted stays, everything else is escaped, so that a name such
// as P[1][*], an interval [0, 1] or a product (a, b) * 2 is only text. Formulas, whose braces and stars are TeX's, and
// the addresses of links are taken out and numbered: a formula is U+E001, its number, U+E002; an address its number.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lesson/prose.hpp"

namespace blossom {

inline constexpr std::string_view formula_begin = "\uE001", formula_end = "\uE002";

struct ScannedProse {
  struct Formula {
    std::string tex;
    std::size_t at = 0;  // of its TeX in the text
    bool display = false;
  };
  std::string markdown;
  std::vector<std::uint32_t> origin;  // of each byte of it, in the text
  std::vector<Formula> formulas;
  std::vector<std::string> addresses;  // "" for one that is not allowed
};
ScannedProse scan_prose(std::string_view text, std::vector<ProseMistake>& mistakes);

// https:, http:, mailto:, or a file beside the lesson.
bool is_safe_address(std::string_view);

}  // namespace blossom
