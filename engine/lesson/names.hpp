#pragma once
// The values of a run by families, and what may be meant by a name that none of them has.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "trace/trace.hpp"

namespace blossom {

// The values whose names differ in nothing but numbers: P[0][0], P[1][0], ...; column[0].P[1][1], column[1].P[1][1].
struct NameFamily {
  std::string form;             // with nothing in the brackets: "P[][]", "column[].P[][]"
  std::vector<ValueId> values;  // in the order they are made
  std::string ranges;           // "P[0][0..2], P[1][0..1], P[2][0]"; "column[0..3].P[0..2][0..2]" of more numbers
};
std::vector<NameFamily> name_families(const TraceGraph&);

// What follows the message that a name, a selector or a placeholder names nothing in a run: "; did you mean "C"?", or
// which values of this form there are, or which families. `words` may be meant, too.
std::string meant_values(std::string_view text, const TraceGraph&, std::span<const std::string_view> words = {});

}  // namespace blossom
