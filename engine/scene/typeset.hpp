#pragma once
// Names and formulas as they stand in books: P with subscript 4 and superscript (1) for P[1][4], a Greek letter for
// alpha, u with subscript k for u_k or u_{k+1}.

#include <string_view>

#include "algorithms/algorithm.hpp"
#include "scene/display_list.hpp"

namespace blossom {

// A value's name without its scope. What its indices mean is looked up in the algorithm's table: a first index called r
// is a level and becomes the superscript (r), left out for level 0; others are all subscripts.
RichText typeset_name(const Name&, const Algorithm&);

// Running text with such names in it.
RichText typeset_text(std::string_view text, const Algorithm&);

}  // namespace blossom
