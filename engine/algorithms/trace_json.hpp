#pragma once
// A run as a file, and back: {"schema": "blossom.trace/1", ...}.
//
//   algorithm, inputs   the id; the inputs as in lesson and exercise files
//   exact               true: the numbers of values are strings, "3", "2/5", or a decimal where only that is known
//   dimension, rational of the points
//   phases   [{"id", "index"?, "scoped"?, "algorithm"?, "parent"?, "first_step", "last_step"}]   a parent stands before
//            its children and is told by its place in this list; the first step only introduces the phase
//   steps    [{"index", "kind", "line", "phase": [labels from the outermost], "text"}]
//   values   [{"name", "kind", "value", "weight"?, "homogeneous"?, "approximate"?, "step", "retired"?, "rule", "from",
//   "polar"?}]
//            kind: integer, scalar, point, vector, list; rule: "input" for what is given; from: names of earlier values
//   result   {"point": [...]} | {"curve": {...}} | {"surface": {...}}, as in geometry files
//
// The value of a point is its 2 or 3 coordinates, with its weight in a rational trace; where the weight is 0, value is
// the direction (wx, wy, wz). "homogeneous" (wx, wy, wz, w) is added where value times weight would not give the same
// bits again. A vector shows its four numbers. "approximate" is true, or lists the numbers (of the four, of a point)
// that an exact trace knows only in double precision.

#include <variant>

#include "algorithms/narrate.hpp"

namespace blossom {

template <Scalar S>
std::string write_trace(const Narrator<S>&);

// A run read from a file is the run that was written: its trace is equal, number by number. Its inputs and its outcome
// are, in double and where there are weights, equal up to the rounding of w x / w.
using StoredTrace = std::variant<Run<double>, Run<Exact>>;

// Every mistake is named: a rule that does not exist or does not take such operands, operands that are not made before,
// two values of one name, phases that do not nest, a polar label that does not follow from the operands' labels.
Checked<StoredTrace> read_trace(const JsonDocument&);

}  // namespace blossom
