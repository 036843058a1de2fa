#pragma once
// A start for who writes a lesson or an exercise: a file that works, about any algorithm, with comments on its parts.

#include <filesystem>
#include <string>

#include "algorithms/run.hpp"
#include "base/json.hpp"

namespace blossom {

// Inputs that the algorithm accepts, as a file has them: those of the first lesson of the folder that is about it, else
// small ready-made ones of each type of input, tried until the algorithm accepts them. Diagnostics where neither does.
Checked<Json> starting_inputs(const Algorithm&, const std::filesystem::path& lessons);

struct Start {
  std::string id;
  std::string language = "en";
  std::string schema;  // where the JSON Schema is, for editors; empty: not said
};

// The text of the file: four to six beats (fewer where the run has fewer steps) at the start, at the first value of
// each kind, and at the end; a checkpoint; a slider where an input is a number. Precondition: the algorithm accepts the
// inputs.
std::string starting_lesson(const Algorithm&, const Json& inputs, const Start&);
// A prompt, what is asked, a tolerance and feedback. Likewise.
std::string starting_exercise(const Algorithm&, const Json& inputs, const Start&);

}  // namespace blossom
