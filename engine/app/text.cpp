#include "app/text.hpp"

#include <algorithm>

#include "base/utf8.hpp"

namespace blossom {

std::string wrapped(std::string_view text, std::size_t indent) {
  constexpr std::size_t width = 110;
  const std::string next_line = "\n" + std::string(indent, ' ');
  std::string out;
  std::size_t column = indent;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
    const std::size_t length = utf8_count(text.substr(at, end - at));
    if (at > 0) {
      const bool breaks = text[at - 1] == '\n';
      if (breaks || (column > indent && column + 1 + length > width)) {
        out += next_line;
        column = indent;
      } else {
        out += ' ';
        ++column;
      }
    }
    out += text.substr(at, end - at);
    column += length;
    at = end + 1;
  }
  return out;
}

std::string heading(const std::string& text) { return text + "\n" + std::string(utf8_count(text), '=') + "\n\n"; }

std::string table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], utf8_count(row[c]));
  }
  std::string out;
  for (const auto& row : rows) {
    out += "  ";
    for (std::size_t c = 0; c < row.size(); ++c)
      out += row[c] + (c + 1 < row.size() ? std::string(widths[c] - utf8_count(row[c]) + 2, ' ') : "\n");
  }
  return out;
}

}  // namespace blossom
