#pragma once
// The panels beside the geometry, as sheets: each function adds its panel at (x, y) in page coordinates (x right, y
// down) with the spots in it, and returns how much height it used. The same panels stand on pages (pictures) and in the
// window.

#include "scene/source.hpp"
#include "scene/spot.hpp"

namespace blossom {

// The pseudo-code of the algorithm at this step, its current line marked. Where it is too wide its letters get smaller,
// then its lines are broken; if it is then higher than `most_height`, only the current line is shown. Spots: the lines.
double add_pseudo_code(Sheet&, const StepSource&, std::uint32_t step, const Emphasis&, double x, double y, double width,
                       double most_height = 1e9);

// Name, formula, formula with numbers, value and polar label of what the step makes. What has no room within the height
// is left out, the last of it first. For pictures; the window sets the formula itself, term by term.
double add_formula(Sheet&, const StepSource&, std::uint32_t step, double x, double y, double width, double height);

// The triangular computing scheme that the step belongs to: that of the phase around it, or of the whole run. One
// column per level, cells filled so far, arrows from operands to values (of the current step with their weights), the
// step's operands and result marked, shares of the emphasis tinted and written. Spots: the cells.
struct TableauOptions {
  // Within this size, by smaller cells without numbers, or not at all (0 is returned): a page. Otherwise cells have
  // their full size and the sheet's size is what they need: a window scrolls it.
  bool fit = true;
  double width = 0, height = 0;  // of the room
  // Of a scheme that is scrolled: only cells that touch this part (y from, y to) of it are set.
  double visible_from = 0, visible_to = 1e9;
};
struct TableauSize {
  double width = 0, height = 0;         // 0 x 0: there is no scheme here
  double current_x = 0, current_y = 0;  // the middle of the step's cell, to scroll to
};
TableauSize add_tableau(Sheet&, const StepSource&, std::uint32_t step, const Emphasis&, double x, double y,
                        const TableauOptions&);
// Where there is none: the values that the part of the run around the step has made so far, the last ones of many, as
// rows "name = value" with the step's own marked. Spots: the rows.
TableauSize add_value_table(Sheet&, const StepSource&, std::uint32_t step, const Emphasis&, double x, double y,
                            double width);
// The same scheme as LaTeX (an array environment, values as fractions or decimals as the run shows them).
std::string latex_tableau(const StepSource&, std::uint32_t step);
// A value as LaTeX: P_{4}^{(1)} = \left(\tfrac{3}{5},\ 2\right)
std::string latex_value(const StepSource&, ValueId);

// Where parameters stand between the left and the right edge of a knot line and a plot of basis functions, so that one
// stands exactly above the other.
struct KnotAxis {
  double first = 0, last = 1;  // u_0, u_m
  double left = 0, right = 1;  // page units
  double place(double u) const { return left + (u - first) / (last - first) * (right - left); }
  double parameter(double at) const { return first + (at - left) / (right - left) * (last - first); }
};
// Of the input curve that the panels are about: profile `curve` of several. Nothing when there is none, or its knots
// are all one number.
std::optional<KnotAxis> knot_axis(const StepSource&, std::size_t curve, double x, double width);
std::optional<KnotAxis> knot_axis(const Curve<double>&, double x, double width);

// The knots of an input curve on a line, each with its value and how often it is there ("1/2 ×3"), with the domain, u,
// its span once it is known, and what a ratio measures. Spots: the knots, u. Nothing without knots (`always`: also for
// a Bezier curve's 0 and 1). With `result`, the knot vector that the run makes of them has a second line, once it is
// there.
inline constexpr double knot_line_at = 26;                              // below y, where the line is
inline constexpr double knot_line_height = 56, knot_lines_height = 85;  // of one line; of two
double add_knot_line(Sheet&, const StepSource&, std::uint32_t step, const Emphasis&, double x, double y, double width,
                     std::size_t curve = 0, bool always = false, bool result = false);
// The value that the second line shows: a knot vector of the result; nothing where a run makes none, or of several
// curves. The newest up to a step.
ValueId resulting_knots(const StepSource&, std::uint32_t step);

// The basis functions N_{i,p} (B_{i,p} of a Bezier curve, R_{i,p} of a rational one) over the same axis, told apart by
// colour, dash and label; those that are not zero at u are loud, with a dot at u; beside them the bar at u: their
// values piled up to 1. The bar takes `basis_bar_room` of the width: the functions stand exactly above a knot line of
// width - basis_bar_room. Spots: a basis function at its peak and at its part of the bar.
inline constexpr double basis_bar_room = 64;
double add_basis(Sheet&, const StepSource&, std::uint32_t step, const Emphasis&, double x, double y, double width,
                 double height, std::size_t curve = 0, bool at_u = true);

// The nested phases as an indented list, those around the step open, with the numbers of their steps. `open` are the
// phases that are unfolded besides. Spots: the phases. Nothing for an algorithm in one piece.
double add_phase_tree(Sheet&, const StepSource&, std::uint32_t step, const std::vector<std::uint32_t>& open, double x,
                      double y, double width);

}  // namespace blossom
