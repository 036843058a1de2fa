// Prose for LaTeX's text mode, in UTF-8; links need \usepackage{hyperref}, formulas amsmath.
#include "algorithms/math_symbols.hpp"
#include "algorithms/typeset.hpp"
#include "base/utf8.hpp"
#include "lesson/prose_scan.hpp"
#include "lesson/prose_text.hpp"

namespace blossom {
namespace {

using Level = TextRun::Level;

std::string escaped_character(std::string_view character) {
  static constexpr std::string_view plain = "{}$&#%_";
  if (character.size() == 1 && plain.find(character[0]) != std::string_view::npos) return "\\" + std::string(character);
  if (character == "\\") return "\\textbackslash{}";
  if (character == "^") return "\\textasciicircum{}";
  if (character == "~") return "\\textasciitilde{}";
  if (character == "<") return "\\textless{}";
  if (character == ">") return "\\textgreater{}";
  if (character == "|") return "\\textbar{}";
  if (character == "\"") return "\\textquotedbl{}";
  if (character == "−") return "$-$";
  // Signs that text fonts lack.
  if (character.size() > 1 && character != "…")
    for (const MathSymbol& symbol : math_symbols())
      if (symbol.text == character) return "$\\" + std::string(symbol.command) + "$";
  return is_control(character) ? " " : std::string(character);
}

std::string escaped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = std::max<std::size_t>(utf8_length(text, i), 1);
    out += utf8_length(text, i) == 0 ? "?" : escaped_character(text.substr(i, length));
    i += length;
  }
  return out;
}

std::string escaped_address(std::string_view address) {
  std::string out;
  for (const char c : address) {
    if (c == '%' || c == '#' || c == '&' || c == '_' || c == '$') out += '\\';
    if (c == '~')
      out += "\\string~";
    else
      out += c;
  }
  return out;
}

// A name, its subscript and its superscript are one formula.
std::string typeset(const RichText& runs) {
  std::string out;
  for (std::size_t i = 0; i < runs.size();) {
    std::size_t end = i + 1;
    while (end < runs.size() && runs[end].level != Level::base) ++end;
    if (runs[i].italic || end > i + 1 || runs[i].level != Level::base)
      out += "$" +
             tex_name(RichText(runs.begin() + static_cast<std::ptrdiff_t>(i),
                               runs.begin() + static_cast<std::ptrdiff_t>(end))) +
             "$";
    else
      out += escaped(runs[i].text);
    i = end;
  }
  return out;
}

std::string span_latex(const Span& span, const Algorithm& algorithm) {
  std::string out;
  if (span.math != nullptr) {
    out = "$" + latex(*span.math) + "$";
  } else if (span.kind == Span::Kind::code) {
    out = "\\texttt{" + escaped(span.text) + "}";
  } else {
    Span plain = span;
    plain.bold = plain.italic = false;
    out = typeset(typeset_span(plain, algorithm));
  }
  if (span.italic) out = "\\emph{" + out + "}";
  if (span.bold) out = "\\textbf{" + out + "}";
  if (!span.link.empty() && is_safe_address(span.link)) out = "\\href{" + escaped_address(span.link) + "}{" + out + "}";
  return out;
}

}  // namespace

std::string prose_latex(const Prose& prose, const Algorithm& algorithm) {
  std::string out;
  std::vector<std::string_view> lists;
  const auto close_to = [&](std::size_t level) {
    for (; lists.size() > level; lists.pop_back()) out += "\\end{" + std::string(lists.back()) + "}\n";
  };
  bool after_paragraph = false;
  for (const Block& block : prose) {
    std::string words;
    for (const Span& span : block.spans) words += span_latex(span, algorithm);
    const auto level = static_cast<std::size_t>(block.level);
    if (block.kind == Block::Kind::item) {
      const std::string_view list = block.number > 0 ? "enumerate" : "itemize";
      close_to(level + 1);
      if (lists.size() == level + 1 && lists.back() != list) close_to(level);
      while (lists.size() <= level) {
        out += "\\begin{" + std::string(list) + "}\n";
        lists.push_back(list);
      }
      out += block.number > 0 ? "\\item[" + std::to_string(block.number) + ".] " : std::string("\\item ");
      // Words that begin with a bracket are no argument of \item.
      out += (words.starts_with('[') ? "{}" : "") + words + "\n";
      after_paragraph = false;
      continue;
    }
    close_to(level);
    if (block.kind == Block::Kind::formula) {
      out += "\\[";
      for (const Span& span : block.spans) out += span.math != nullptr ? latex(*span.math) : escaped(span.text);
      out += "\\]\n";
      after_paragraph = false;
    } else {
      if (after_paragraph || level > 0) out += "\n";
      out += words + "\n";
      after_paragraph = true;
    }
  }
  close_to(0);
  return out;
}

}  // namespace blossom
