// Formulas as LaTeX, in the commands they are read from.
#include <algorithm>

#include "algorithms/math_symbols.hpp"

namespace blossom {
namespace {

using Kind = Math::Kind;

bool is_prime(const Math& math) { return math.kind == Kind::symbol && math.text == "′"; }

std::string written(const Math&);

std::string row(const std::vector<Math>& parts, std::size_t from = 0) {
  std::string tex;
  for (std::size_t i = from; i < parts.size(); ++i) {
    std::string part = written(parts[i]);
    const auto digit = [](char c) { return '0' <= c && c <= '9'; };
    // Two numbers beside each other stay two.
    if (!tex.empty() && digit(tex.back()) && (digit(part[0]) || part[0] == '.')) part = "{" + part + "}";
    tex += part;
  }
  return tex;
}

std::string group(const Math& math) {
  return "{" + (math.kind == Kind::row ? row(math.parts) : is_prime(math) ? "'" : written(math)) + "}";
}

std::string symbol(const Math& math) {
  if (is_prime(math)) return "{'}";
  if (math.text == "−") return "-";
  if (math.of == Math::Class::word && math.upright) return "\\text{" + math.text + "}";
  for (const MathSymbol& known : math_symbols())
    if (known.text == math.text && known.of == math.of && known.upright == math.upright)
      return "\\" + std::string(known.command) +
             (std::string_view("{},").find(known.command) == std::string::npos ? " " : "");
  const auto letter = [](char c) { return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9'); };
  if (math.of == Math::Class::variable && math.upright && std::ranges::all_of(math.text, letter))
    return (math.bold ? "\\mathbf{" : "\\mathrm{") + math.text + "}";
  return math.text;
}

std::string scripts(const Math& math) {
  const Math &base = math.parts[0], &below = math.parts[1], &above = math.parts[2];
  const auto there = [](const Math& part) { return part.kind != Kind::row || !part.parts.empty(); };
  std::string tex = base.kind == Kind::row || base.kind == Kind::scripts ? group(base) : written(base);
  if (tex.ends_with(' ')) tex.pop_back();
  if (there(below)) tex += "_" + group(below);
  if (!there(above)) return there(below) ? tex : tex + "^{}";
  if (is_prime(above)) return tex + "'";
  std::size_t primes = 0;
  while (above.kind == Kind::row && primes < above.parts.size() && is_prime(above.parts[primes])) ++primes;
  tex.append(primes, '\'');
  if (primes == 0) return tex + "^" + group(above);
  return primes == above.parts.size() ? tex : tex + "^{" + row(above.parts, primes) + "}";
}

std::string fence(char c, std::string_view command) {
  const std::string brace = c == '{' || c == '}' ? "\\" : "";
  return std::string(command) + brace + (c == ' ' ? '.' : c);
}

std::string written(const Math& math) {
  switch (math.kind) {
    case Kind::row:
      return "{" + row(math.parts) + "}";
    case Kind::symbol:
      return symbol(math);
    case Kind::scripts:
      return scripts(math);
    case Kind::fraction:
      return "\\frac" + group(math.parts[0]) + group(math.parts[1]);
    case Kind::binomial:
      return "\\binom" + group(math.parts[0]) + group(math.parts[1]);
    case Kind::root: {
      if (math.parts.size() < 2) return "\\sqrt" + group(math.parts[0]);
      return "\\sqrt[" + group(math.parts[1]) + "]" + group(math.parts[0]);
    }
    case Kind::accent:
      for (const MathAccent& accent : math_accents())
        if (accent.mark == math.text) return "\\" + std::string(accent.command) + group(math.parts[0]);
      return group(math.parts[0]);
    case Kind::fenced: {
      const Math& inside = math.parts[0];
      std::string tex = fence(math.text[0], "\\left");
      tex += inside.kind == Kind::row ? row(inside.parts) : is_prime(inside) ? "{'}" : written(inside);
      return tex + fence(math.text[1], "\\right");
    }
  }
  return {};
}

}  // namespace

std::string latex(const Math& math) {
  std::string tex = math.kind == Kind::row ? row(math.parts) : written(math);
  if (tex.ends_with(' ')) tex.pop_back();
  return tex;
}

}  // namespace blossom
