#pragma once
// Texts of others in LaTeX files: whatever they hold, the file compiles and shows them.

#include <string>
#include <string_view>

namespace blossom {

// To stand in text: what TeX would obey is written out. Other than ASCII is kept, for unicode_declarations.
std::string latex_text(std::string_view utf8);

// A letter or a word in a formula: \alpha, u, \mathrm{deg}.
std::string latex_symbol(std::string_view utf8);

// The lines for the preamble that say what the characters of this document are that LaTeX does not know by itself:
// Greek letters and signs in text and in formulas; what no font of a small TeX has is shown by its number.
std::string unicode_declarations(std::string_view document);

}  // namespace blossom
