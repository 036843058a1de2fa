#pragma once
// The panels of a page beside the geometry. Each fills a view of page coordinates (x right, y down, from its top left)
// and returns how much of its height it used.

#include "scene/display_list.hpp"
#include "scene/source.hpp"

namespace blossom {

// The pseudo-code of the algorithm at this step, its current line marked.
double add_pseudo_code(View&, const StepSource&, std::uint32_t step, double x, double y, double width);
// Name, formula, formula with numbers, value and polar label of what the step makes. What has no room within the height
// is left out, the last of it first.
double add_formula(View&, const StepSource&, std::uint32_t step, double x, double y, double width, double height);
// The triangular scheme: one column per level, cells filled so far, the step's operands and result marked. Nothing, and
// height 0, for an algorithm without one, or when it has more cells than the width can show.
double add_tableau(View&, const StepSource&, std::uint32_t step, double x, double y, double width, double height);
// The knots of the input curve as multiplicity(value) on a line, with u and its span. Nothing without knots.
double add_knot_line(View&, const StepSource&, std::uint32_t step, double x, double y, double width);

}  // namespace blossom
