#pragma once
// Names and formulas as they stand in books: P with subscript 4 and superscript (1) for P[1][4], a Greek letter for
// alpha, u with subscript k for u_k or u_{k+1}.

#include <string>
#include <string_view>

#include "algorithms/algorithm.hpp"
#include "algorithms/text_run.hpp"

namespace blossom {

// A value's name without its scope; a single knot U[3] is u with subscript 3. What its indices mean is looked up in the
// algorithm's table: a first index called r is a level and becomes the superscript (r), left out for level 0; others
// are all subscripts.
RichText typeset_name(const Name&, const Algorithm&);

// Running text with such names in it. The phase of a name stands before it: "round[1].Q[2]" is round (subscript 1), a
// dot, and Q with subscript 2.
RichText typeset_text(std::string_view text, const Algorithm&);

// The same on one line of plain text, for tooltips and messages: P₂⁽¹⁾, Q₁,₂, u₃, P_i.
std::string unicode_text(const RichText&);

// In the TeX of formulas (math.hpp): a typeset name, P_{2}^{(1)}; and a value as it is shown, "(3, 1/2)" as
// (3, \frac{1}{2}).
std::string tex_name(const RichText&);
std::string tex_value(std::string_view shown);
inline std::string plain_name(const Name& name, const Algorithm& algorithm) {
  return unicode_text(typeset_name(name, algorithm));
}

}  // namespace blossom
