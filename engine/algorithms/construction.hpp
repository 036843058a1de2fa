#pragma once
// What the constructions of surfaces from curves say alike: how curves are made compatible (kernel/compatible.hpp).

#include "algorithms/common.hpp"
#include "kernel/construction.hpp"

namespace blossom {

// The values, phases and rules of making curves compatible, at this line of the pseudo-code. The curves themselves,
// P[l][i] over U[l][j], are the algorithm's own.
inline void add_compatible(Algorithm& a, int line) {
  const std::vector<ValueSpec> values = {
      {"U", {}, "the knots of a curve as one vector", line, "Its knot vector so far: {value}."},
      {"U",
       {"i"},
       "a knot, mapped to [0, 1]; in the phase merge: the knots of curve i",
       line,
       "{name} = {result}.",
       ValueSpec::Draw::none,
       false,
       {{"gather", "", 0, "The knots of curve {i}: {value}."}}},
      {"P",
       {"i"},
       "a control point, over the mapped knots",
       line,
       "The control points stay where they are.",
       ValueSpec::Draw::polygon},
      {"W",
       {"l"},
       "the union of the knots of curves 0..l",
       line,
       "All knots that curves 0 to {l} need: {value}.",
       ValueSpec::Draw::none,
       false,
       {{"", "1-l", 0, "Curve 0 needs the knots {value}."}}}};
  const std::vector<PhaseSpec> phases = {
      {"compatible", "Make the curves compatible", line,
       "First the curves get one degree and one knot vector, without changing shape."},
      {"clamp", "Clamp curve {index}", line, "Curve {index} is not clamped: its domain's ends are inserted."},
      {"end", "End {index}", line, "Insert the end of the domain until it has full multiplicity."},
      {"raise", "Raise the degree of curve {index}", line, "Curve {index} has too low a degree: it is elevated."},
      {"domain", "Map curve {index} to [0, 1]", line,
       "The domains differ: the knots of curve {index} are mapped to [0, 1]."},
      {"merge", "Merge the knots", line, "Which knots do all curves together need?"},
      {"refine", "Refine curve {index}", line, "Curve {index} lacks some of them: they are inserted."},
      {"knot", "Insert knot {index}", line, "The next knot that is missing is inserted as often as it is missing."}};
  const std::vector<const RuleInfo*> rules = {&rule_info<Gather>, &rule_info<UniteKnots>, &rule_info<Ratio>,
                                              &rule_info<SameNumber>, &rule_info<Reparametrize>};
  a.values.insert(a.values.end(), values.begin(), values.end());
  a.phases.insert(a.phases.end(), phases.begin(), phases.end());
  a.rules.insert(a.rules.end(), rules.begin(), rules.end());
}

// What the site's person has for another value of its symbol and scope; nothing where there is none.
inline std::vector<Numbers<Exact>> value_instead(const Site& site, const Name& name) {
  const auto numbers = site.sibling_numbers(name);
  if (!numbers) return {};
  return {Numbers<Exact>(numbers->begin(), numbers->end())};
}

// The last first index of the symbol's values with that second index, counted from `i`.
inline int last_row(const Site& site, Name name) {
  while (site.sibling(name)) ++name.index[0];
  return name.index[0] - 1;
}

}  // namespace blossom
