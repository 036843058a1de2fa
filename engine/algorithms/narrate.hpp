#pragma once
// A run in words: narration of each step, formula of each value, the triangular scheme as a table.
//
// A template is text with placeholders in braces:
//   {P[r-1][i]}   the value of that name, as the run shows numbers; indices are sums and differences of whole numbers,
//                 of the indices' names at this step, and of whole-number values such as k, s, p; also element i of a
//                 list
//   {#P[r-1][i]}  its name: P[0][3]
//   {~P[r-1][i]}  its value as a formula takes it: a point of a rational curve as (wx, wy, w); all else as above
//   {value} {name} {formula} {numbers}   of the step's main value: its value, its name, its formula with names, and the
//                 formula with numbers filled in
//   {made}        its value behind an equals sign: of a rational curve's point (wx, wy, w), then the point itself
//   {@0} {@1} ... the values of its operands
//   {chain} {result}   formula = numbers = value, and numbers = value, without saying anything twice
//   {polar}       the polar label of the main value
//   {r}           an index of the main value, by its name in the algorithm's table; {index}: the phase's index
//   {k-p}         a sum of such whole numbers
// Step 0 shows all that is given and has no main value. A brace that is to be seen is written \{ or \}.
// In a formula ($...$ and $$...$$, see math.hpp) braces are TeX's. There a placeholder is \value{P[r-1][i]}, which
// stands for the value in TeX, (3, \frac{1}{2}), and takes what stands for values above: \value{value}, \value{@0},
// \value{r}, \value{~P[1][0]}; or \name{P[r-1][i]}, which stands for the name as books write it, P_{3}^{(1)}. A dollar
// sign that begins no formula is written \$. A placeholder that names nothing is a mistake: fill tells it.

#include <span>

#include "algorithms/run.hpp"

namespace blossom {

// The placeholders that are words, all about a step's own value: value, name, formula, ...
std::span<const std::string_view> placeholder_words();

// How values are shown as text: fractions or shortest decimals; points as (x, y), with their weight where rational.
template <Scalar S>
class Narrator {
 public:
  // With `digits` > 0, decimals are rounded to that many significant digits, for pictures and for reading; otherwise
  // they are the shortest that read back as the same number. Fractions are always whole.
  explicit Narrator(const Run<S>& run, int digits = 0);
  Narrator(const Narrator&) = delete;

  const Run<S>& run() const { return *run_; }
  const Trace<S>& trace() const { return run_->trace; }

  // The algorithm whose text explains this step: the run's own, or that of the phase around it.
  const Algorithm& algorithm_at(std::uint32_t step) const;
  std::string kind(std::uint32_t step) const;  // "given", "phase", or the rule's name
  int line(std::uint32_t step) const;          // of algorithm_at(step)'s pseudo-code; 0: none
  std::string text(std::uint32_t step) const;  // the narration
  // The template of that narration: of the words for special cases those that apply to this step.
  std::string text_template(std::uint32_t step) const;
  std::string value_text(ValueId) const;    // "(1/2, 3)", "(1, 2), w = 2", "2/5", "(0, 0, 1, 1)"
  std::string operand_text(ValueId) const;  // the same, but a point of a rational curve as (wx, wy, w)
  // Where an equation ends: of a rational curve's point (wx, wy, w), which is what was computed, and then the point.
  std::string made_text(ValueId) const;
  // Knots are written u_3 there, as in books.
  std::string formula(ValueId) const;  // with names:   (1 - u) P[0][0] + u P[0][1]
  // The name on the left of that formula, and of an operand in it: without the phases that both are in. The left one
  // names its phase only where an operand of another phase has the same name.
  std::string own_name(ValueId) const;
  std::string operand_name(ValueId, ValueId operand) const;
  std::string numbers(ValueId) const;  // with numbers: (1 - 2/5) (0, 0) + 2/5 (1, 2)
  std::string polar(ValueId) const;    // "b(0, 2/5, 1)" or ""
  std::string phase_title(std::uint32_t phase) const;

  // Fills a template in at a step. Mistakes (a placeholder that names nothing there) go to `errors`, if given, and
  // stand in the text as they were written.
  std::string fill(std::string_view text, std::uint32_t step, std::vector<std::string>* errors = nullptr) const;

  // The triangular scheme of the values up to a step as lines of text, one column for each first index. Empty if the
  // algorithm has none.
  std::string tableau(std::uint32_t step) const;

 private:
  struct Context;
  Context context_at(std::uint32_t step) const;
  const ValueSpec::Case* case_at(const Context&) const;
  std::string chain(ValueId, bool with_names) const;
  std::optional<std::string> placeholder(std::string_view inside, const Context&) const;
  std::optional<std::string> math_placeholder(std::string_view command, std::string_view inside, const Context&) const;
  std::string fill_in(std::string_view text, const Context&, std::vector<std::string>* errors) const;
  std::string fill_math(std::string_view tex, const Context&, std::vector<std::string>* errors) const;
  struct Found {
    ValueId value;
    int element;  // of a list; -1: the value itself
  };
  std::optional<Found> resolve(std::string_view reference, const Context&) const;
  std::optional<int> index(std::string_view expression, const Context&) const;

  // In an exact run, `decimals` writes what is known exactly as a decimal, too: beside numbers that are not.
  std::string number(const S&, bool decimals = false) const;
  std::string list(NumbersView<S>, bool decimals = false) const;
  std::string value_text(ValueId, bool decimals) const;
  std::string operand_text(ValueId, bool decimals) const;
  bool approximate(ValueId) const;

  const Run<S>* run_;
  int digits_;
  std::vector<PolarLabel<S>> labels_;
};

extern template class Narrator<double>;
extern template class Narrator<Exact>;

}  // namespace blossom
