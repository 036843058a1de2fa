#pragma once
// What the ways out of prose share.

#include <string_view>

#include "lesson/prose.hpp"

namespace blossom {

// A span's words as they are typeset: names of values, bold and emphasis; code as it is. Not for formulas.
RichText typeset_span(const Span&, const Algorithm&);

}  // namespace blossom
