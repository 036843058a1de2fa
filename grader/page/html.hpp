#pragma once
// Pieces of HTML that both pages are made of.

#include <string>
#include <string_view>

#include "algorithms/typeset.hpp"
#include "base/html.hpp"
#include "base/scalar.hpp"

namespace blossom {

// Text with names in it as they stand in books: <i>P</i> with sub- and superscript for P[1][3].
std::string math_html(const RichText&);
inline std::string math_html(std::string_view text, const Algorithm& algorithm) {
  return math_html(typeset_text(text, algorithm));
}

// The beginning of a page, up to and with <body>: it loads nothing and runs only what stands in it.
std::string page_head(std::string_view title, std::string_view css);

std::string number_text(const Exact&);   // two decimals at most
std::string percent_text(double share);  // "83.3 %"

}  // namespace blossom
