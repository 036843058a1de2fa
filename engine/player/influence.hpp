#pragma once
// Walks along the graph of values: what a value came from and how much each counted, and what it went into.

#include "scene/source.hpp"
#include "scene/spot.hpp"
#include "trace/why.hpp"

namespace blossom {

// How much each earlier value counts in `v`: the sum over all ways along the graph of the products of the weights. By
// ValueId, up to v; share[v] = 1. For a point of a polynomial B-spline curve the shares of the control points are the
// basis functions N_{i,p}(u) (Ramshaw, "Blossoms are polar forms", 1989); of a rational one they are those of the
// homogeneous points. The weight of an operand is how much the value moves when the operand's point does, by the rule
// itself applied to moved numbers; only points and vectors carry weight, a ratio's own shares are 0.
std::vector<double> shares(const StepSource&, ValueId v);
// How much `v` counts in each later value, likewise. By ValueId, 0 before v.
std::vector<double> shares_onward(const StepSource&, ValueId v);

// What to light for what somebody points at (or has pinned), at this step. A value: itself, values that stand for the
// same (the current occurrence), its line of code, its ancestors with their shares, and for a given control point its
// basis function's values onward; a line of code: what it made so far in the algorithm (of the whole run, or of the
// phase that is an algorithm) that the step belongs to; a knot: the U[i]; u: the value u; a basis function: its control
// point; a phase or a step: what it made so far; nothing for none. Knots and basis functions are the first curve's.
Emphasis emphasis_of(const StepSource&, const Link&, std::uint32_t step);
// Two at once, such as what is pinned and what the mouse is over. Where both have a share or a line, the second's.
Emphasis merged(const Emphasis&, const Emphasis&);

}  // namespace blossom
