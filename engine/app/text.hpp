#pragma once
// Text for a terminal. Widths are counted in characters (UTF-8 code points), not in bytes.

#include <string>
#include <string_view>
#include <vector>

namespace blossom {

// The text broken at blanks into lines of at most 110 characters, the first of which begins at column `indent` already
// and the others behind as many blanks; line breaks of the text stay. A word longer than a line has a line of its own.
std::string wrapped(std::string_view text, std::size_t indent = 0);

// The text underlined, and an empty line.
std::string heading(const std::string& text);

// A table: each row indented by two blanks, the columns two blanks apart and aligned left.
std::string table(const std::vector<std::vector<std::string>>& rows);

}  // namespace blossom
