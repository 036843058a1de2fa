#pragma once
// Where a beat stands: a place that can be looked for in any run of the lesson's algorithm, also with other inputs.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/json.hpp"
#include "trace/trace.hpp"

namespace blossom {

// In files:
//   "start", "end"      the step that shows the inputs; the last step
//   a selector          the step that makes the first value it matches: "P[2][*]"
//   {"last": selector}  the one that makes the last
//   {"every": selector} each step that makes one (several steps: see steps_of)
//   {"level": r}        the first step that makes a value of level r, which is its first index called r
//   {"phase": label}    the step that introduces this phase: "parameters", "raise[1]", "raise[1].decompose"
//   {"after": label}    the first step behind it
//   {"step": n}         the step n
struct Place {
  enum class Kind : std::uint8_t { start, end, step, phase, after, value, last, every, level };
  Kind kind = Kind::start;
  std::uint32_t step = 0;  // of kind step; the level
  std::string text;        // a phase's labels, or a selector, which is known to be one

  bool operator==(const Place&) const = default;
};

// As "at" has it in a file, in its form only. Nothing, with a diagnostic, if it is no place in any run.
std::optional<Place> read_place(const Cursor& at);
// The JSON text that read_place reads.
std::string write_place(const Place&);

// The step of this place in a run, of several the first; nothing if the run has no such place.
std::optional<std::uint32_t> step_of(const Place&, const TraceGraph&);
// All of them, ascending.
std::vector<std::uint32_t> steps_of(const Place&, const TraceGraph&);
// Why the run, which has no such place, has none; and what may be meant.
std::string why_nowhere(const Place&, const TraceGraph&);

// The values that selectors select of those made up to a step: each once, in the order they are made.
std::vector<ValueId> selected_up_to(const std::vector<std::string>& selectors, std::uint32_t step, const TraceGraph&);

}  // namespace blossom
