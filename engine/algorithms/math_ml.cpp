// Formulas as MathML Core, with the plain text for readers that know none.
#include <algorithm>

#include "algorithms/math_symbols.hpp"
#include "base/html.hpp"
#include "base/utf8.hpp"

namespace blossom {
namespace {

using Kind = Math::Kind;
using Class = Math::Class;

std::string element(std::string_view name, std::string_view content, std::string_view attributes = "") {
  std::string out = "<" + std::string(name);
  if (!attributes.empty()) out += " " + std::string(attributes);
  return out + ">" + std::string(content) + "</" + std::string(name) + ">";
}

// MathML Core knows bold letters by their own code points (U+1D400 and on) only.
std::string bold(std::string_view text) {
  std::string out;
  for (const char c : text) {
    char32_t code = static_cast<unsigned char>(c);
    if ('A' <= c && c <= 'Z') code = 0x1D400 + static_cast<char32_t>(c - 'A');
    if ('a' <= c && c <= 'z') code = 0x1D41A + static_cast<char32_t>(c - 'a');
    if ('0' <= c && c <= '9') code = 0x1D7CE + static_cast<char32_t>(c - '0');
    if (code < 0x80) {
      out += c;
      continue;
    }
    for (const int shift : {18, 12, 6, 0})
      out += static_cast<char>((shift == 18 ? 0xF0u : 0x80u) | (code >> shift & (shift == 18 ? 0x07u : 0x3Fu)));
  }
  return out;
}

std::string symbol(const Math& math) {
  const std::string text = html_escape(math.text);
  switch (math.of) {
    case Class::number:
      return element("mn", text);
    case Class::word:
      return math.upright ? element("mtext", text) : element("mi", text);
    case Class::space:
      return math.text == "\u2003" ? "<mspace width=\"1em\"></mspace>" : "<mspace width=\"0.167em\"></mspace>";
    case Class::large:
      return math.text.size() > 3 || math.text[0] < 0 ? element("mo", text)
                                                      : element("mo", text, "movablelimits=\"true\"");
    case Class::open:
    case Class::close:
      return element("mo", text, "stretchy=\"false\"");
    case Class::operation:
    case Class::relation:
    case Class::punctuation:
      return element("mo", text);
    case Class::variable:
      break;
  }
  if (math.bold) return element("mi", bold(math.text));
  if (!math.upright) return element("mi", text);
  const bool letters = std::ranges::all_of(
      math.text, [](char c) { return c < 0 || std::string_view("|/.").find(c) == std::string_view::npos; });
  if (!letters) return element("mo", text, "stretchy=\"false\" lspace=\"0\" rspace=\"0\"");
  if (math.text == "′") return element("mo", text, "lspace=\"0\" rspace=\"0\"");
  return utf8_count(math.text) == 1 ? element("mi", text, "mathvariant=\"normal\"") : element("mi", text);
}

std::string written(const Math&);

// A function and what follows it stand apart, if that is no parenthesis.
bool stands_apart(const Math& part, const Math& next) {
  const Math *function = nucleus(part), *behind = nucleus(next);
  const bool named = function != nullptr && ((function->of == Class::word && !function->upright) ||
                                             (function->of == Class::large && utf8_count(function->text) > 1));
  return named && next.kind != Kind::fenced && (behind == nullptr || behind->of != Class::open);
}

std::string row(const std::vector<Math>& parts) {
  std::string out;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    out += written(parts[i]);
    if (i + 1 < parts.size() && stands_apart(parts[i], parts[i + 1])) out += "<mspace width=\"0.167em\"></mspace>";
  }
  return parts.size() == 1 ? out : element("mrow", out);
}

std::string fence(char c, std::string_view form) {
  return c == ' '
             ? std::string()
             : element("mo", std::string(1, c), "form=\"" + std::string(form) + "\" fence=\"true\" stretchy=\"true\"");
}

std::string scripts(const Math& math) {
  const auto there = [](const Math& part) { return part.kind != Kind::row || !part.parts.empty(); };
  const bool below = there(math.parts[1]), above = there(math.parts[2]);
  const Math* base = math.parts[0].kind == Kind::symbol ? &math.parts[0] : nullptr;
  const bool limits = base != nullptr && base->of == Class::large && base->text != "∫";
  std::string out = written(math.parts[0]);
  if (below) out += written(math.parts[1]);
  if (above || !below) out += written(math.parts[2]);
  if (below && (above || !below)) return element(limits ? "munderover" : "msubsup", out);
  return element(below ? (limits ? "munder" : "msub") : (limits ? "mover" : "msup"), out);
}

std::string written(const Math& math) {
  switch (math.kind) {
    case Kind::row:
      return row(math.parts);
    case Kind::symbol:
      return symbol(math);
    case Kind::scripts:
      return scripts(math);
    case Kind::fraction:
      return element("mfrac", written(math.parts[0]) + written(math.parts[1]));
    case Kind::binomial:
      return element("mrow",
                     fence('(', "prefix") +
                         element("mfrac", written(math.parts[0]) + written(math.parts[1]), "linethickness=\"0\"") +
                         fence(')', "postfix"));
    case Kind::root:
      if (math.parts.size() > 1) return element("mroot", written(math.parts[0]) + written(math.parts[1]));
      return element("msqrt", written(math.parts[0]));
    case Kind::accent: {
      // The marks that stand by themselves; a combining character alone would sit on the tag.
      const std::string_view mark = math.text == "\u0304" ? "\u00AF" : math.text == "\u20D7" ? "→" : "^";
      return element("mover", written(math.parts[0]) + element("mo", mark, "stretchy=\"false\""), "accent=\"true\"");
    }
    case Kind::fenced:
      return element("mrow", fence(math.text[0], "prefix") + written(math.parts[0]) + fence(math.text[1], "postfix"));
  }
  return {};
}

}  // namespace

std::string mathml(const Math& math, bool display) {
  return element(
      "math", math.kind == Kind::row ? row(math.parts) : written(math),
      std::string(display ? "display=\"block\" " : "") + "alttext=\"" + html_escape(plain_math(math)) + "\"");
}

}  // namespace blossom
