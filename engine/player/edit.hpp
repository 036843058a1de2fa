#pragma once
// Edits of a run's inputs: pure functions from inputs to new inputs, or to what is wrong. What is valid is decided in
// one place, by the readers of files (read_input and the algorithm's check): what an edit changes goes through them, so
// no edit can make inputs that a file could not have. Paths of diagnostics begin at the inputs ("curve.knots[4]",
// "profiles[1].points[0]", "u").
//
// An edit of a curve that leaves another input unfit takes that one along: u moves to the nearest place in the domain
// where the algorithm can run (the domain's end, or the middle of a span), and a whole number (times, degree_v) goes
// down as far as it must. So one can change knots, degrees and kinds without caring about u first.

#include "algorithms/run.hpp"
#include "studio/edit_curve.hpp"

namespace blossom {

// One control point: of the curve that is the input of this name, or of its `curve`-th one.
struct PointAddress {
  std::string input;
  std::size_t curve = 0;
  std::size_t point = 0;
  bool operator==(const PointAddress&) const = default;
};
// The curves among the inputs, in the order in which panels number them (by input name, then index).
struct CurveAddress {
  std::string input;
  std::size_t curve = 0;
  bool operator==(const CurveAddress&) const = default;
};
std::vector<CurveAddress> curves_of(const Inputs<Exact>&);
const Curve<Exact>& curve_at(const Inputs<Exact>&, const CurveAddress&);

// The control point that a value of the trace is, if it is one that was given; and back.
std::optional<PointAddress> address_of(const TraceGraph&, const Inputs<Exact>&, ValueId);
std::optional<ValueId> value_of(const TraceGraph&, const Inputs<Exact>&, const PointAddress&);

using Edited = Checked<Inputs<Exact>>;

// Inputs around a curve: the middle of its domain for a parameter, all else as when a file leaves it out.
Edited inputs_around(const Algorithm&, const Curve<Exact>&);

// What is done to one curve, and how, is said in studio/edit_curve.hpp.
Edited move_point(const Algorithm&, const Inputs<Exact>&, const PointAddress&, const Point<Exact>& to);
Edited set_weight(const Algorithm&, const Inputs<Exact>&, const PointAddress&, const Exact& weight);
Edited insert_point(const Algorithm&, const Inputs<Exact>&, const PointAddress& behind, const Point<Exact>& at);
Edited delete_point(const Algorithm&, const Inputs<Exact>&, const PointAddress&);
Edited set_knot(const Algorithm&, const Inputs<Exact>&, const CurveAddress&, std::size_t index, const Exact& value);
Edited set_equal_knots(const Algorithm&, const Inputs<Exact>&, const CurveAddress&, std::size_t index,
                       const Exact& value);
Edited set_degree(const Algorithm&, const Inputs<Exact>&, const CurveAddress&, int degree);
Edited set_kind(const Algorithm&, const Inputs<Exact>&, const CurveAddress&, CurveKind);

// A copy, moved on as the row of curves goes.
Edited add_curve(const Algorithm&, const Inputs<Exact>&, const CurveAddress& behind);
Edited delete_curve(const Algorithm&, const Inputs<Exact>&, const CurveAddress&);

Edited set_number(const Algorithm&, const Inputs<Exact>&, std::string_view input, const Exact&);
Edited set_integer(const Algorithm&, const Inputs<Exact>&, std::string_view input, int);
Edited set_choice(const Algorithm&, const Inputs<Exact>&, std::string_view input, std::string_view choice);

// The number at a path into the inputs as a file has them: "u", "curve.points[1][0]", "curve.knots[4]"; nothing where
// there is none. Put in its place, it goes through the readers of files; the other inputs are made to fit.
std::optional<Exact> number_at(const Inputs<Exact>&, std::string_view path);
Edited set_number_at(const Algorithm&, const Inputs<Exact>&, std::string_view path, const Exact&);

// What a drag means: the nearest multiple of the smallest of 1, 2, 5, 10, 0.1, ... that is not finer than `unit` (a
// pixel in the world). With `grid` > 0: the nearest multiple of that.
Exact snapped(double value, double unit, double grid = 0);

// The inputs as a file's "inputs" object, with decimals where they are exact; and as its text, which is indented by
// `indent` blanks after the first line.
Json json_of(const Inputs<Exact>&);
std::string write_inputs(const Inputs<Exact>&, int indent = 0);

}  // namespace blossom
