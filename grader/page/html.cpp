#include "grader/page/html.hpp"

#include "grader/page/student_page.hpp"

namespace blossom {

std::string math_html(const RichText& runs) {
  using Level = TextRun::Level;
  std::string out;
  bool in_name = false;  // a letter with what belongs to it, which is not broken between lines
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const TextRun& run = runs[i];
    const bool stacked = run.level == Level::sub && i + 1 < runs.size() && runs[i + 1].level == Level::super;
    const std::string_view tag = run.level == Level::sub ? "sub" : run.level == Level::super ? "sup" : "i";
    if (run.level == Level::base && !run.italic) {
      append_html(out, run.text);
      continue;
    }
    if (run.level == Level::base && i + 1 < runs.size() && runs[i + 1].level != Level::base) {
      in_name = true;
      out += "<span class=\"v\">";
    }
    // Both at one place, the superscript above: the subscript comes first for whoever listens or copies.
    if (stacked) out += "<span class=\"ss\">";
    out.append("<").append(tag).append(">");
    append_html(out, run.text);
    out.append("</").append(tag).append(">");
    if (stacked) {
      out += "<sup>";
      append_html(out, runs[++i].text);
      out += "</sup></span>";
    }
    if (in_name && run.level != Level::base && (i + 1 == runs.size() || runs[i + 1].level == Level::base)) {
      in_name = false;
      out += "</span>";
    }
  }
  return out;
}

std::string page_head(std::string_view title, std::string_view css) {
  std::string out =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "
      "script-src 'unsafe-inline'; img-src data:\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<meta name=\"referrer\" content=\"no-referrer\">\n<title>";
  append_html(out, title);
  out.append("</title>\n<style>\n").append(css).append("</style>\n</head>\n<body>\n");
  return out;
}

std::string number_text(const Exact& x) { return format_short(x.to_double(), 2); }
std::string percent_text(double share) { return format_short(100 * share, 1) + " %"; }

}  // namespace blossom
