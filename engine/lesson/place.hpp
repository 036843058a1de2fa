#pragma once
// Where a beat stands: a place that can be looked for in any run of the lesson's algorithm, also with other inputs.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/json.hpp"
#include "trace/trace.hpp"

namespace blossom {

struct Place {
  enum class Kind : std::uint8_t { start, end, step, phase, value };
  Kind kind = Kind::start;
  std::uint32_t step = 0;  // of kind step
  std::string text;        // a phase's labels, or a selector, which is known to be one

  bool operator==(const Place&) const = default;
};

// As "at" has it in a file, in its form only. Nothing, with a diagnostic, if it is no place in any run.
std::optional<Place> read_place(const Cursor& at);
// The JSON text that read_place reads.
std::string write_place(const Place&);

// The step of this place in a run; nothing if the run has no such place.
std::optional<std::uint32_t> step_of(const Place&, const TraceGraph&);
// Why the run, which has no such place, has none; and what may be meant.
std::string why_nowhere(const Place&, const TraceGraph&);

// The values that selectors select of those made up to a step: each once, in the order they are made.
std::vector<ValueId> selected_up_to(const std::vector<std::string>& selectors, std::uint32_t step, const TraceGraph&);

}  // namespace blossom
