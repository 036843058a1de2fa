#pragma once
// Formulas in a small part of TeX, as lessons write them between dollar signs, and their ways out: laid out by
// render/math_layout.hpp, as MathML for pages, as LaTeX, and as one line of plain text.
//
//   letters, digits, + - = < > ( ) [ ] | , ; : . ! / ' and blanks, which mean nothing
//   x_i  x^{(1)}  x_{i,p}^{2}       scripts
//   \frac{a}{b}  \binom{n}{i}  \sqrt{a}  \sqrt[3]{a}  \bar{U}  \vec{v}  \hat{x}
//   \sum_{i=0}^{n}  \prod  \int     large operators
//   \alpha ... \omega, \Gamma ... \Omega
//   \cdot \times \le \ge \ne \approx \to \mapsto \in \subset \cup \cap \infty \ldots \cdots \pm \circ \wedge \partial
//   \sin \cos \tan \log \exp \min \max \det \lim
//   \text{words}  \mathbf{P}  \mathrm{d}  \left( \right)  \,  \quad  \{ \}
//
// What is not in this list is a mistake that says what is meant. Formulas come from files nobody can trust: at most
// 2,000 bytes and 24 levels.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace blossom {

struct Math {
  enum class Kind : std::uint8_t {
    row,       // parts, one after the other
    symbol,    // text: one letter, a number with all its digits, a sign, or words
    scripts,   // parts: base, below, above; a row without parts where there is none
    fraction,  // parts: above, below
    binomial,  // likewise, without a line and in parentheses
    root,      // parts: what is under it, and its degree if it has one
    accent,    // parts: what is below it; text: the mark (a combining character)
    fenced,    // parts: what is between; text: the two fences, a blank for none
  };
  // What stands around a symbol depends on it. word: the name of a function (sin), or, upright, the words of \text;
  // large: what has limits, \lim and \max among them; space: U+2009 for \, and U+2003 for \quad.
  enum class Class : std::uint8_t {
    variable,
    number,
    operation,
    relation,
    open,
    close,
    punctuation,
    word,
    large,
    space
  };
  Kind kind = Kind::row;
  Class of = Class::variable;  // of a symbol
  bool bold = false;           // of a symbol
  bool upright = false;        // of a symbol that is a letter
  std::string text;            // UTF-8
  std::vector<Math> parts;
  bool operator==(const Math&) const = default;
};

struct MathMistake {
  std::size_t at = 0;  // bytes from the beginning
  std::string what;
};

// A row; nothing, with the first mistake, if it is no formula.
std::optional<Math> parse_math(std::string_view tex, MathMistake&);

// In running text: the place behind the formula that the dollar sign, or the two, at `at` begins; nothing if they have
// no partner in the same paragraph.
std::optional<std::size_t> end_of_math(std::string_view text, std::size_t at);
// The same for code, which begins with one or more backticks and ends with as many.
std::optional<std::size_t> end_of_code(std::string_view text, std::size_t at);

// <math>...</math>, with the plain text as its alttext. `display`: set on a line of its own.
std::string mathml(const Math&, bool display = false);
// To stand between dollar signs; reads back as the same formula.
std::string latex(const Math&);
// (u - u₃)/(u₆ - u₃), P₂⁽¹⁾: for terminals, tooltips and screen readers.
std::string plain_math(const Math&);

}  // namespace blossom
