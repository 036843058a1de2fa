// Formulas on one line of plain text.
#include <algorithm>

#include "algorithms/math_symbols.hpp"
#include "algorithms/typeset.hpp"

namespace blossom {
namespace {

using Kind = Math::Kind;
using Class = Math::Class;

// Inside of scripts nothing stands apart.
std::string written(const Math&, bool tight);

std::string symbol(const Math& math) {
  if (math.text == "−") return "-";
  if (math.of == Class::space) return " ";
  return math.text;
}

bool is_named(const Math* symbol) {
  if (symbol == nullptr) return false;
  return (symbol->of == Class::word && !symbol->upright) ||
         (symbol->of == Class::large && static_cast<unsigned char>(symbol->text[0]) < 0x80);
}

std::string row(const std::vector<Math>& parts, bool tight) {
  std::string text;
  const auto apart = [&] {
    if (!tight && !text.empty() && text.back() != ' ') text += ' ';
  };
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Math* before = i > 0 ? &parts[i - 1] : nullptr;
    const Math* symbol = nucleus(parts[i]);
    const Class of = symbol != nullptr ? symbol->of : Class::variable;
    const bool between = (of == Class::operation && !is_sign(before)) || of == Class::relation;
    const bool after_large = before != nullptr && nucleus(*before) != nullptr && nucleus(*before)->of == Class::large;
    const bool after_named =
        before != nullptr && is_named(nucleus(*before)) && of != Class::open && parts[i].kind != Kind::fenced;
    const bool words = symbol != nullptr && of == Class::word && symbol->upright;
    if (between || (after_large && !after_named && of != Class::open) || is_named(symbol)) apart();
    if (after_named && !text.empty() && text.back() != ' ') text += ' ';  // sin x, in scripts, too
    if (words && text.ends_with(' ') && parts[i].kind == Kind::symbol && symbol->text.starts_with(' ')) text.pop_back();
    text += written(parts[i], tight);
    if (between || of == Class::punctuation) apart();
  }
  while (text.ends_with(' ')) text.pop_back();
  return text;
}

std::string written_in(const Math& math, bool tight) {
  return math.kind == Kind::row ? row(math.parts, tight) : written(math, tight);
}

// In parentheses where something else stands beside it without a sign between.
std::string bracketed(const Math& math, bool tight) {
  const bool one = math.kind == Kind::symbol || math.kind == Kind::accent || math.kind == Kind::fenced ||
                   math.kind == Kind::binomial || math.kind == Kind::root ||
                   (math.kind == Kind::scripts && math.parts[0].kind == Kind::symbol);
  const std::string text = written_in(math, tight);
  return one ? text : "(" + text + ")";
}

std::string script(const Math& math, TextRun::Level level) {
  const std::string text = written_in(math, true);
  return text.empty() ? text : unicode_text({{text, level}});
}

std::string written(const Math& math, bool tight) {
  switch (math.kind) {
    case Kind::row:
      return row(math.parts, tight);
    case Kind::symbol:
      return symbol(math);
    case Kind::scripts: {
      const bool plain = math.parts[0].kind == Kind::row && math.parts[0].parts.empty();
      const std::string base = plain ? "" : bracketed(math.parts[0], tight);
      const Math& above = math.parts[2];
      const bool primes = above.kind == Kind::symbol ? above.text == "′"
                                                     : above.kind == Kind::row && !above.parts.empty() &&
                                                           std::ranges::all_of(above.parts, [](const Math& part) {
                                                             return part.kind == Kind::symbol && part.text == "′";
                                                           });
      const std::string below = script(math.parts[1], TextRun::Level::sub);
      return base + below + (primes ? written_in(above, true) : script(above, TextRun::Level::super));
    }
    case Kind::fraction:
      return bracketed(math.parts[0], tight) + "/" + bracketed(math.parts[1], tight);
    case Kind::binomial:
      return "(" + written_in(math.parts[0], tight) + " choose " + written_in(math.parts[1], tight) + ")";
    case Kind::root: {
      const std::string degree = math.parts.size() > 1 ? script(math.parts[1], TextRun::Level::super) : std::string();
      return degree + "√" + bracketed(math.parts[0], tight);
    }
    case Kind::accent: {
      const std::string text = written_in(math.parts[0], tight);
      return math.parts[0].kind == Kind::symbol ? text + math.text : "(" + text + ")" + math.text;
    }
    case Kind::fenced: {
      std::string text = written_in(math.parts[0], tight);
      if (math.text[0] != ' ') text.insert(0, 1, math.text[0]);
      if (math.text[1] != ' ') text += math.text[1];
      return text;
    }
  }
  return {};
}

}  // namespace

std::string plain_math(const Math& math) { return written_in(math, false); }

}  // namespace blossom
