#pragma once
// What lessons say, in a small part of Markdown, and its ways out. Of CommonMark: paragraphs (an empty line between
// them), **bold**, *emphasis*, `code`, [words](address), lists ("- " and "1. "), a backslash before a character that is
// to stand for itself; and $formula$, $$formula on a line of its own$$ (algorithms/math.hpp). Headings, quotes,
// pictures, tables and HTML are mistakes: a beat is a few sentences. Addresses are https: or http: or mailto:, or files
// beside the lesson. Names of values in the text (P[1][0], u_3, alpha[1][2]) are typeset by themselves, and their
// brackets, stars and underscores are no marks: emphasis begins and ends at the edges of words, and _ never emphasizes.
// The Markdown is md4c's; a text has at most 20,000 bytes.
//
// Placeholders (algorithms/narrate.hpp) are filled in before: what is read here has none.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/algorithm.hpp"
#include "algorithms/math.hpp"
#include "algorithms/text_run.hpp"

namespace blossom {

struct Span {
  enum class Kind : std::uint8_t { text, code, math };
  Kind kind = Kind::text;
  std::string text;  // UTF-8; of a formula its TeX
  bool bold = false, italic = false;
  std::string link;                  // empty: none
  std::shared_ptr<const Math> math;  // of a formula
};

struct Block {
  enum class Kind : std::uint8_t { paragraph, item, formula };
  Kind kind = Kind::paragraph;
  int level = 0;   // of an item: how deep in lists, from 0; of what stands in an item behind its words: one more
  int number = 0;  // of an item: its number; 0: a bullet
  std::vector<Span> spans;
};
using Prose = std::vector<Block>;

struct ProseMistake {
  std::size_t at = 0;  // bytes from the beginning of the text
  std::string what;    // and what would be right
};

// Whatever the text is, something that can be shown; mistakes are all told. Bounded in time by its length.
Prose read_prose(std::string_view text, std::vector<ProseMistake>* mistakes = nullptr);

// Where a brace of a template is left open, if one is. Inside of formulas braces are TeX's.
std::optional<std::size_t> open_brace(std::string_view text);

// Names of values are typeset as the algorithm's table has them.
RichText rich_text(const Prose&, const Algorithm&);       // blocks on lines of their own
std::string prose_html(const Prose&, const Algorithm&);   // <p>, <ul>, <ol>, <i>P</i><sub>1</sub>, MathML
std::string prose_latex(const Prose&, const Algorithm&);  // as LaTeX's text mode has it
std::string prose_markdown(const Prose&);                 // Markdown again, formulas between dollar signs
std::string plain_text(const Prose&);                     // for terminals and screen readers

}  // namespace blossom
