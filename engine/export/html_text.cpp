#include "export/html_text.hpp"

#include "algorithms/typeset.hpp"

namespace blossom {
namespace {

using Level = TextRun::Level;

// "<sub>1</sub><sup>(2)</sup>" is one thing for the style sheet. In text that comes from files there are no such marks:
// their angle brackets are escaped.
std::string stacked(std::string_view html) {
  constexpr std::string_view open = "<sub>", between = "</sub><sup>", close = "</sup>";
  std::string out;
  std::size_t at = 0;
  for (;;) {
    const std::size_t middle = html.find(between, at);
    if (middle == std::string_view::npos) return out.append(html.substr(at));
    const std::size_t begin = html.rfind(open, middle), end = html.find(close, middle) + close.size();
    out.append(html.substr(at, begin - at)).append("<span class=\"ss\">").append(html.substr(begin, end - begin));
    out.append("</span>");
    at = end;
  }
}

}  // namespace

std::string html_names(const RichText& runs) {
  std::string out;
  for (const TextRun& run : runs) {
    const std::string text = html_escape(run.text);
    out += run.level == Level::sub     ? "<sub>" + text + "</sub>"
           : run.level == Level::super ? "<sup>" + text + "</sup>"
           : run.italic                ? "<i>" + text + "</i>"
                                       : text;
  }
  return stacked(out);
}

std::string html_typeset(std::string_view text, const Algorithm& algorithm) {
  return html_names(typeset_text(text, algorithm));
}

std::string html_prose(const Prose& prose, const Algorithm& algorithm) { return stacked(prose_html(prose, algorithm)); }

std::string filled(std::string_view words, std::string_view key, std::string_view with) {
  std::string out(words);
  const std::string place = "{" + std::string(key) + "}";
  if (const std::size_t at = out.find(place); at != std::string::npos) out.replace(at, place.size(), with);
  return out;
}

}  // namespace blossom
