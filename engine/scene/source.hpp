#pragma once
// A recorded run, made ready to be drawn: everything that pictures need of it, in double, whatever the run's scalar.

#include <functional>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "algorithms/narrate.hpp"

namespace blossom {

class Schemes;

struct StepSource {
  const TraceGraph* graph = nullptr;
  const Algorithm* algorithm = nullptr;
  int dimension = 2;
  bool rational = false;
  std::vector<Curve<double>> curves;  // of the inputs, in the order of the inputs' names
  std::vector<Curve<double>> lifted;  // the curves in space above them, where the algorithm lifts; they lie at height 1
  std::vector<Surface<double>> surfaces;
  std::vector<Curve<double>> pictured;            // that the inputs stand for, see Algorithm::pictured
  std::optional<double> parameter;                // the input u, if there is one
  std::vector<std::optional<glm::dvec3>> points;  // of each value that is a point of its own and finite
  std::vector<double> scalars;                    // of each value that is a number, else 0
  bool exact = false;                             // whether the run was in exact arithmetic
  Outcome<double> outcome;

  // Text, from the narrator of the run's own scalar; valid as long as that narrator.
  std::function<const Algorithm&(std::uint32_t step)> algorithm_at;
  std::function<int(std::uint32_t step)> line;
  std::function<std::string(ValueId)> value_text, made_text, formula, own_name, numbers, polar;
  std::function<std::string(ValueId, ValueId operand)> operand_name;  // as the formula has it
  std::function<std::string(std::uint32_t phase)> phase_title;
  std::function<std::string(std::uint32_t step)> text;  // the algorithm's own narration
  std::function<std::vector<double>(ValueId)> raw;      // a value's numbers, as a rule takes them

  mutable std::shared_ptr<Schemes> schemes;  // worked out at the first look, see scene/scheme.hpp

  bool spatial() const { return dimension == 3; }
  const ValueSpec* spec(ValueId) const;  // of the algorithm around it or the whole one; nullptr if neither knows it
};

template <Scalar S>
StepSource make_source(const Narrator<S>&);

// The name of the point where a vector stands whose table entry has a foot.
Name foot_of(const Name& vector, const ValueSpec&);

}  // namespace blossom
