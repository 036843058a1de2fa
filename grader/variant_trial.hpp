#pragma once
// One draw held against all that an acceptable variant must be. VARIANTS.md names the demands.

#include <compare>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "grader/carry.hpp"
#include "grader/variant.hpp"
#include "grader/variant_spec.hpp"

namespace blossom {

// What is demanded. `misconception`, `part` and `requirement` say more where the kind needs it.
struct Demand {
  enum class Kind : std::uint8_t {
    no_knot,
    requirement,   // the words
    inputs,        // the algorithm takes them
    same_steps,    // as the model
    not_zero,      // a part: not 0, and a number not 1
    no_input,      // a part is none of the inputs
    no_operand,    // a part is none of its own operands
    denominators,  // of a part
    likeness,
    misconception,  // shows in a part
    exercise,       // read_exercise takes all of it
  };
  Kind kind;
  std::size_t index = 0;  // of the misconception or the requirement
  std::size_t part = 0;
  auto operator<=>(const Demand&) const = default;
};

// Why a part leaves nothing to compute. What the model itself has is not demanded of variants.
struct Trivial {
  bool zero = false;
  bool input = false;
  bool operand = false;
};

struct VariantMaker::Prepared {
  explicit Prepared(const JsonDocument& exercise);

  JsonDocument document;
  Json inputs;
  Exercise model;
  ReplayPlan plan;
  Json plain;  // the file without "vary"
  Vary vary;
  Exact most_denominator = 0;
  std::size_t digits = 0;        // of all asked values of the model
  std::vector<Trivial> trivial;  // by part

  // The exercise with these inputs, as a document of its own.
  std::string text(const Json& drawn) const;
};

// Values that "vary" names and nobody can be given, each at its place: of "choose" each that gives no run with the
// model's steps, of other ranges an end that the algorithm does not take.
Diagnostics check_ranges(const VariantMaker::Prepared&);

// The next draw of a stream, into inputs that were the model's or drawn before.
void draw(const Vary&, VariantStream&, Json& inputs);

class Trial {
 public:
  // Called with each demand that is not met and what is to be said of it; says whether to go on with the others.
  using Unmet = std::function<bool(const Demand&, const std::function<std::string()>& why)>;

  Trial(const VariantMaker::Prepared& prepared, const Json& inputs);
  // Whether all demands are met. The cheapest are looked at first; those on values only if there is a run with the
  // model's steps.
  bool acceptable(const Unmet& unmet);

  // Whether there is a run with the model's steps.
  bool comes_to_values(const Unmet& unmet) { return check_inputs(unmet) && run(unmet); }

  // The variant, if it is acceptable.
  JsonDocument& document() { return *document_; }
  // What came to a run with the model's steps; for messages.
  const std::optional<Exercise>& exercise() const { return exercise_; }

 private:
  bool check_inputs(const Unmet&);
  bool run(const Unmet&);
  bool check_values(const Unmet&);
  bool check_misconceptions(const Unmet&);
  bool check_whole(const Unmet&);
  bool look(const Unmet&, std::size_t misconception, std::size_t part, NumbersView<Exact> traced);

  const VariantMaker::Prepared* prepared_;
  const Json* inputs_;
  std::optional<Exercise> exercise_;
  std::optional<JsonDocument> document_;
};

}  // namespace blossom
