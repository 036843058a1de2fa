#include "algorithms/math_symbols.hpp"

#include <array>

namespace blossom {

std::span<const MathSymbol> math_symbols() {
  using Class = Math::Class;
  static constexpr std::array all = std::to_array<MathSymbol>({
      {"alpha", "α", Class::variable},
      {"beta", "β", Class::variable},
      {"gamma", "γ", Class::variable},
      {"delta", "δ", Class::variable},
      {"epsilon", "ε", Class::variable},
      {"zeta", "ζ", Class::variable},
      {"eta", "η", Class::variable},
      {"theta", "θ", Class::variable},
      {"iota", "ι", Class::variable},
      {"kappa", "κ", Class::variable},
      {"lambda", "λ", Class::variable},
      {"mu", "μ", Class::variable},
      {"nu", "ν", Class::variable},
      {"xi", "ξ", Class::variable},
      {"pi", "π", Class::variable},
      {"rho", "ρ", Class::variable},
      {"sigma", "σ", Class::variable},
      {"tau", "τ", Class::variable},
      {"upsilon", "υ", Class::variable},
      {"phi", "φ", Class::variable},
      {"chi", "χ", Class::variable},
      {"psi", "ψ", Class::variable},
      {"omega", "ω", Class::variable},
      {"Gamma", "Γ", Class::variable, true},
      {"Delta", "Δ", Class::variable, true},
      {"Theta", "Θ", Class::variable, true},
      {"Lambda", "Λ", Class::variable, true},
      {"Xi", "Ξ", Class::variable, true},
      {"Pi", "Π", Class::variable, true},
      {"Sigma", "Σ", Class::variable, true},
      {"Upsilon", "Υ", Class::variable, true},
      {"Phi", "Φ", Class::variable, true},
      {"Psi", "Ψ", Class::variable, true},
      {"Omega", "Ω", Class::variable, true},
      {"cdot", "⋅", Class::operation},
      {"times", "×", Class::operation},
      {"pm", "±", Class::operation},
      {"circ", "∘", Class::operation},
      {"wedge", "∧", Class::operation},
      {"cup", "∪", Class::operation},
      {"cap", "∩", Class::operation},
      {"le", "≤", Class::relation},
      {"ge", "≥", Class::relation},
      {"ne", "≠", Class::relation},
      {"approx", "≈", Class::relation},
      {"to", "→", Class::relation},
      {"mapsto", "↦", Class::relation},
      {"in", "∈", Class::relation},
      {"subset", "⊂", Class::relation},
      {"infty", "∞", Class::variable, true},
      {"partial", "∂", Class::variable, true},
      {"ldots", "…", Class::variable, true},
      {"cdots", "⋯", Class::variable, true},
      {"sum", "∑", Class::large},
      {"prod", "∏", Class::large},
      {"int", "∫", Class::large},
      {"lim", "lim", Class::large},
      {"max", "max", Class::large},
      {"min", "min", Class::large},
      {"det", "det", Class::large},
      {"sin", "sin", Class::word},
      {"cos", "cos", Class::word},
      {"tan", "tan", Class::word},
      {"log", "log", Class::word},
      {"exp", "exp", Class::word},
      {"{", "{", Class::open},
      {"}", "}", Class::close},
      {",", "\u2009", Class::space},
      {"quad", "\u2003", Class::space},
  });
  return all;
}

std::span<const MathAccent> math_accents() {
  static constexpr std::array all =
      std::to_array<MathAccent>({{"bar", "\u0304"}, {"vec", "\u20D7"}, {"hat", "\u0302"}});
  return all;
}

const Math* nucleus(const Math& math) {
  const Math* at = &math;
  while (at->kind == Math::Kind::scripts) at = &at->parts[0];
  return at->kind == Math::Kind::symbol ? at : nullptr;
}

bool is_sign(const Math* before) {
  if (before == nullptr) return true;
  const Math* symbol = nucleus(*before);
  if (symbol == nullptr) return false;
  switch (symbol->of) {
    case Math::Class::operation:
    case Math::Class::relation:
    case Math::Class::open:
    case Math::Class::punctuation:
    case Math::Class::large:
      return true;
    default:
      return false;
  }
}

}  // namespace blossom
