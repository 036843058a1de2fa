#pragma once
// Is this well-formed XML? Enough of XML 1.0 for what we write: no DTD, no CDATA, no comments.

#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace blossom {

// What is wrong first, or an empty text.
inline std::string xml_mistake(std::string_view text) {
  std::size_t i = 0;
  const auto rest = [&] { return text.substr(i); };
  const auto at_end = [&] { return i >= text.size(); };
  const auto skip_blanks = [&] {
    while (!at_end() && std::isspace(static_cast<unsigned char>(text[i])) != 0) ++i;
  };
  const auto name = [&] {
    const std::size_t start = i;
    while (!at_end() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == ':' || text[i] == '-'))
      ++i;
    return std::string(text.substr(start, i - start));
  };
  const auto reference = [&] {
    for (const std::string_view known : {"&amp;", "&lt;", "&gt;", "&quot;", "&apos;"}) {
      if (rest().starts_with(known)) {
        i += known.size();
        return true;
      }
    }
    return false;
  };
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t') return "a control character";
  }
  if (rest().starts_with("<?xml ")) i = text.find("?>") + 2;
  std::vector<std::string> open;
  bool root = false;
  while (!at_end()) {
    if (text[i] == '&') {
      if (!reference()) return "an unknown reference";
    } else if (text[i] != '<') {
      if (open.empty() && std::isspace(static_cast<unsigned char>(text[i])) == 0) return "text outside of the root";
      ++i;
    } else if (rest().starts_with("</")) {
      i += 2;
      const std::string closing = name();
      if (open.empty() || open.back() != closing || at_end() || text[i] != '>') return "closing tag " + closing;
      open.pop_back();
      ++i;
    } else {
      ++i;
      const std::string element = name();
      if (element.empty() || (open.empty() && root)) return "a wrong tag " + element;
      root = true;
      std::set<std::string> attributes;
      for (skip_blanks(); !at_end() && text[i] != '>' && text[i] != '/'; skip_blanks()) {
        const std::string attribute = name();
        if (attribute.empty() || !attributes.insert(attribute).second) return "a wrong attribute of " + element;
        if (!rest().starts_with("=\"")) return "no value of " + attribute;
        for (i += 2; !at_end() && text[i] != '"';) {
          if (text[i] == '<') return "< in " + attribute;
          if (text[i] == '&' ? !reference() : (++i, false)) return "an unknown reference in " + attribute;
        }
        ++i;
      }
      const bool empty = rest().starts_with("/>");
      i += empty ? 2 : 1;
      if (i > text.size()) return "an unfinished tag " + element;
      if (!empty) open.push_back(element);
    }
  }
  return !open.empty() ? "not closed: " + open.back() : root ? "" : "no root";
}

}  // namespace blossom
