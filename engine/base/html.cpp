#include "base/html.hpp"

#include "base/utf8.hpp"

namespace blossom {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

// A line break and a tab are white space in HTML and harmless.
bool is_harmless(char c) { return c == '\n' || c == '\t'; }

}  // namespace

void append_html(std::string& out, std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    const std::string_view character = text.substr(i, length);
    i += length == 0 ? 1 : length;
    if (length == 0 || (is_control(character) && !is_harmless(character[0]))) {
      out += replacement;
      continue;
    }
    switch (character[0]) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += character;
    }
  }
}

std::string html_escape(std::string_view text) {
  std::string out;
  append_html(out, text);
  return out;
}

std::string script_json(std::string_view json) {
  std::string out;
  for (const char c : json) {
    if (c == '<')
      out += "\\u003C";
    else
      out += c;
  }
  return out;
}

}  // namespace blossom
