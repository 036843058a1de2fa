#pragma once
// What an algorithm is to everybody but itself: its inputs, how to run it, and everything that explains, draws, asks
// about and marks its values. One algorithm is one file in this folder, which defines `const Algorithm& NAME()` for a
// file NAME.cpp; the table of all of them is written by the build.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/json.hpp"
#include "geometry/geometry.hpp"
#include "trace/trace_recorder.hpp"

namespace blossom {

// ---- inputs and results ---------------------------------------------------------------------------------------------

template <Scalar S>
using InputValue = std::variant<S, int, std::string, Curve<S>, Surface<S>, std::vector<Curve<S>>, std::vector<S>,
                                PointRow<S>, PointNet<S>>;

template <Scalar S>
struct Inputs {
  std::map<std::string, InputValue<S>, std::less<>> values;

  const S& number(std::string_view name) const { return std::get<S>(values.find(name)->second); }
  int integer(std::string_view name) const { return std::get<int>(values.find(name)->second); }
  const std::string& choice(std::string_view name) const { return std::get<std::string>(values.find(name)->second); }
  const Curve<S>& curve(std::string_view name) const { return std::get<Curve<S>>(values.find(name)->second); }
  const Surface<S>& surface(std::string_view name) const { return std::get<Surface<S>>(values.find(name)->second); }
  const std::vector<Curve<S>>& curves(std::string_view name) const {
    return std::get<std::vector<Curve<S>>>(values.find(name)->second);
  }
  const std::vector<S>& numbers(std::string_view name) const {
    return std::get<std::vector<S>>(values.find(name)->second);
  }
  const PointRow<S>& points(std::string_view name) const { return std::get<PointRow<S>>(values.find(name)->second); }
  const PointNet<S>& net(std::string_view name) const { return std::get<PointNet<S>>(values.find(name)->second); }
  bool operator==(const Inputs&) const = default;
};

template <Scalar S>
Inputs<S> convert(const Inputs<Exact>&);

struct InputSpec {
  enum class Type {
    number,
    integer,
    choice,
    curve,
    surface,
    curves,   // several
    numbers,  // in a row
    points,   // in a row: [[x, y], ...]
    net,      // rows of points
  };
  std::string_view name;
  Type type;
  std::string_view description;
  int at_least = 0;  // integers; the number of curves, numbers or points
  int at_most = 0;
  std::vector<std::string_view> choices = {};
  std::string_view fallback = {};  // JSON text of the value when the file leaves it out; empty: required
};

template <Scalar S>
using Outcome = std::variant<HPoint<S>, Curve<S>, Surface<S>, std::vector<Curve<S>>, std::vector<Surface<S>>>;

// ---- what explains the values ---------------------------------------------------------------------------------------

// One family of values, e.g. P[r][i]: all values of this symbol with this many indices.
struct ValueSpec {
  enum class Draw {
    none,
    point,    // a point of its own
    level,    // a point of a triangular scheme: the points of one first index form a polyline
    polygon,  // all of them in a row form one polyline
    net,      // rows and columns form a control net
  };
  std::string_view symbol;
  std::vector<std::string_view> indices;  // what the indices are called: r, i
  std::string_view meaning;               // for tooltips, schemas and help: "the point i of level r"
  int line = 0;                           // of the pseudo-code, from 1; 0: none (an input)
  std::string_view narration = {};        // a template, see narrate.hpp
  Draw draw = Draw::none;
  bool tableau = false;  // belongs into the triangular scheme (column: first index, of two)

  // Other words, or another line, in special cases. The first that applies counts: made by this rule (empty: any), and
  // this sum of whole numbers, as in a template's index, is positive (empty: always).
  struct Case {
    std::string_view rule = {};
    std::string_view positive = {};
    int line = 0;                     // 0: the line above
    std::string_view narration = {};  // empty: the narration above
  };
  std::vector<Case> cases = {};

  // A vector that is seen as an arrow standing at a point: the name of that point, with the vector's own index or
  // another one: "C", "D[0]", "D[k]". What is its own foot is a point.
  std::string_view foot = {};
  bool ray = false;  // a line from the origin leads to it
};

struct PhaseSpec {
  std::string_view id;
  std::string_view title;  // a template: "Profile {index}: raise the degree"
  int line = 0;
  std::string_view narration;
};

// ---- what marks them ------------------------------------------------------------------------------------------------

// The value v of an exact trace as the person sees it who made it: operands() gives the numbers they had.
class Site {
 public:
  virtual ~Site() = default;
  virtual const Trace<Exact>& trace() const = 0;
  virtual const Inputs<Exact>& inputs() const = 0;
  virtual ValueId value() const = 0;
  virtual NumbersView<Exact> numbers(ValueId v) const = 0;  // what that person has for v: their own answer, where given

  const Name& name() const { return trace().value(value()).name; }
  // The value `name` in this value's scope; nothing if there is none.
  std::optional<ValueId> sibling(Name name) const;
  std::optional<NumbersView<Exact>> sibling_numbers(Name name) const;
  NumbersView<Exact> operand(std::size_t i) const { return numbers(trace().operands(value())[i]); }
};

struct Misconception {
  std::string_view id;      // stable: reports count it
  std::string_view title;   // "the weights 1-u and u are swapped"
  std::string_view advice;  // one sentence to the student
  // What somebody with this misconception gets for the value of the site, likeliest first (a span can be off by one
  // either way); empty where the misconception does not apply.
  std::vector<Numbers<Exact>> (*wrong)(const Site&);
};

// ---- the algorithm --------------------------------------------------------------------------------------------------

template <Scalar S>
struct Runner {
  Outcome<S> (*recorded)(const Inputs<S>&, TraceRecorder<S>&) = nullptr;
  Outcome<S> (*plain)(const Inputs<S>&) = nullptr;
};

// What an algorithm is for: the menus of what can be done with a curve or a surface are made of these.
enum class Family : std::uint8_t {
  evaluation,         // a point of a curve or surface
  curve_technique,    // a curve from a curve
  fitting,            // a curve or surface from points
  surface_technique,  // a surface from a surface
  construction,       // a surface from curves
};

struct Algorithm {
  std::string_view id;
  Family family = Family::evaluation;
  std::string_view title;
  std::string_view summary;  // one sentence
  std::string_view source;   // where to read on
  std::vector<InputSpec> inputs;
  std::vector<std::string_view> pseudo_code;
  std::vector<ValueSpec> values;
  std::vector<PhaseSpec> phases;
  std::string_view given_narration;  // of step 0, a template
  std::vector<const RuleInfo*> rules;
  std::vector<Misconception> misconceptions;
  std::vector<std::string_view> asks;  // selectors of what exercises usually ask
  // What the kernel's preconditions demand of inputs that are each valid alone ("u must lie in the domain [0, 5]").
  // `at("u")` is the place to report at.
  void (*check)(const Inputs<Exact>&, const std::function<Cursor(std::string_view)>& at) = nullptr;
  // Curves that its inputs stand for though none of them is one, for pictures: the curve of given coefficients, the
  // line through two points.
  std::vector<Curve<double>> (*pictured)(const Inputs<double>&) = nullptr;
  // It works in space on a rational plane curve (kernel/lift.hpp): weights are heights, its points have none, and the
  // picture shows the curve in the plane at height 1 and the one in space above it.
  bool lifts = false;
  Runner<double> in_double;
  Runner<Exact> in_exact;

  template <Scalar S>
  const Runner<S>& runner() const {
    if constexpr (std::same_as<S, double>)
      return in_double;
    else
      return in_exact;
  }
  const ValueSpec* spec(const Name& name) const;
  const PhaseSpec* phase(std::string_view id) const;
  const InputSpec* input(std::string_view name) const;
};

// Fills in both runners from one generic callable: `run(const Inputs<S>&, R& recorder) -> Outcome<S>`.
template <auto run>
void set_runners(Algorithm& algorithm) {
  const auto fill = []<Scalar S>(Runner<S>& runner) {
    runner.recorded = [](const Inputs<S>& inputs, TraceRecorder<S>& recorder) -> Outcome<S> {
      return run(inputs, recorder);
    };
    runner.plain = [](const Inputs<S>& inputs) -> Outcome<S> {
      NoRecorder<S> recorder;
      return run(inputs, recorder);
    };
  };
  fill(algorithm.in_double);
  fill(algorithm.in_exact);
}

// All algorithms, in the order of their ids; one by id, or nullptr; their ids.
const std::vector<const Algorithm*>& algorithms();
const Algorithm* find_algorithm(std::string_view id);
std::vector<std::string> algorithm_ids();
// A rule by its name, of any algorithm; nullptr if there is none.
const RuleInfo* find_rule(std::string_view name);

}  // namespace blossom
