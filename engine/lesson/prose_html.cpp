// Prose as part of a page. Everything that comes from a file is escaped, and only addresses that are safe become links.
#include "base/html.hpp"
#include "lesson/prose_scan.hpp"
#include "lesson/prose_text.hpp"

namespace blossom {
namespace {

using Level = TextRun::Level;

std::string element(std::string_view name, const std::string& content) {
  return "<" + std::string(name) + ">" + content + "</" + std::string(name) + ">";
}

std::string span_html(const Span& span, const Algorithm& algorithm) {
  std::string out;
  if (span.math != nullptr) {
    out = mathml(*span.math);
  } else if (span.kind == Span::Kind::code) {
    out = element("code", html_escape(span.text));
  } else {
    Span plain = span;
    plain.bold = plain.italic = false;
    for (const TextRun& run : typeset_span(plain, algorithm)) {
      const std::string text = html_escape(run.text);
      out += run.level == Level::sub     ? element("sub", text)
             : run.level == Level::super ? element("sup", text)
             : run.italic                ? element("i", text)
                                         : text;
    }
  }
  if (span.italic) out = element("em", out);
  if (span.bold) out = element("strong", out);
  if (!span.link.empty() && is_safe_address(span.link))
    out = "<a href=\"" + html_escape(span.link) + "\">" + out + "</a>";
  return out;
}

}  // namespace

std::string prose_html(const Prose& prose, const Algorithm& algorithm) {
  std::string out;
  std::vector<std::string_view> lists;  // that are open, each with an open item
  const auto close_to = [&](std::size_t level) {
    for (; lists.size() > level; lists.pop_back()) out += "</li></" + std::string(lists.back()) + ">\n";
  };
  for (const Block& block : prose) {
    std::string words;
    for (const Span& span : block.spans) words += span_html(span, algorithm);
    const auto level = static_cast<std::size_t>(block.level);
    if (block.kind == Block::Kind::item) {
      const std::string_view list = block.number > 0 ? "ol" : "ul";
      close_to(level + 1);
      if (lists.size() == level + 1 && lists.back() != list) close_to(level);
      if (lists.size() == level + 1) out += "</li>\n";
      while (lists.size() <= level) {
        out += "<" + std::string(list);
        if (block.number > 1) out += " start=\"" + std::to_string(block.number) + "\"";
        out += ">\n";
        lists.push_back(list);
        if (lists.size() <= level) out += "<li>";
      }
      out += "<li>" + words;
      continue;
    }
    close_to(level);
    if (block.kind == Block::Kind::formula) {
      out += "<div class=\"formula\">";
      for (const Span& span : block.spans)
        out += span.math != nullptr ? mathml(*span.math, true) : span_html(span, algorithm);
      out += "</div>\n";
    } else {
      out += "<p>" + words + "</p>\n";
    }
  }
  close_to(0);
  return out;
}

}  // namespace blossom
