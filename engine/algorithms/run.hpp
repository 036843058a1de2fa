#pragma once
// From a file's inputs to a run: read and check them, run with or without recording, and keep all of it together.

#include "algorithms/algorithm.hpp"

namespace blossom {

// Reads the object of inputs at the cursor as this algorithm's. Nothing, with every mistake, if any is wrong.
std::optional<Inputs<Exact>> read_inputs(const Algorithm&, const Cursor&);

// Reads one of them.
std::optional<InputValue<Exact>> read_input(const InputSpec&, const Cursor&);

// A run that was recorded.
template <Scalar S>
struct Run {
  const Algorithm* algorithm = nullptr;
  Inputs<S> inputs;
  Trace<S> trace;
  Outcome<S> outcome;
};

// Diagnostics when the inputs turn out impossible on the way (the weight at u is 0, a number overflows): what comes out
// of a run is finite. Their paths begin at the inputs ("profiles[2]"); report_at says them at their places in a file.
template <Scalar S>
Checked<Run<S>> record(const Algorithm&, const Inputs<Exact>&);
template <Scalar S>
Checked<Outcome<S>> run_plain(const Algorithm&, const Inputs<Exact>&);

// What record or run_plain say of inputs that were read at this cursor, as mistakes in that file.
void report_at(const Cursor& inputs, const Diagnostics& of_run);

// The input as JSON text, as write_curve does it.
template <Scalar S>
std::string write_input(const InputValue<S>&);

}  // namespace blossom
