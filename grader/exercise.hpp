#pragma once
// An exercise: a run of an algorithm of which some values are asked.
//
//   {"schema": "blossom.exercise/1", "id", "title", "prompt", "algorithm", "inputs",
//    "ask": [{"value": selector, "points": n, "form"?, "as"?, "tolerance"?, "feedback"?: text,
//             "void"?: "credit" | "drop"}, ...],
//    "tolerance"?, "carried"?: 0..1, "partial"?: {"misconception"?: 0..1, "slip"?: 0..1}, "feedback"?, "source"?,
//    "unit"?, "marking"?: "at-once" | "at-end", "vary"?: see variant.hpp}
//
// The prompt is a template of the run's first step (algorithms/narrate.hpp): "at u = {u}", "{P[0][1]}".
// `points` are for each value the selector selects; of its values those that are given are left out.
// exercises/exercise.schema.json describes every key.

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "algorithms/narrate.hpp"
#include "grader/compare.hpp"
#include "lesson/document.hpp"

namespace blossom {

// How a point of a rational curve is typed. A point of a polynomial one is its coordinates, `affine`.
enum class Form : std::uint8_t {
  affine,       // [x, y]
  homogeneous,  // [w x, w y, w]
  weight,       // w
};

enum class Feedback : std::uint8_t {
  none,     // the score, nothing else
  verdict,  // what each part counts as
  hint,     // and what is wrong with it, without the right value
  full,     // and the right value with its formula
};

// A part that turned out to be at fault after it was handed out.
enum class Voided : std::uint8_t {
  no,
  credit,  // everybody whose answers could be read gets its points
  drop,    // it counts for nobody: it is worth no points
};

struct Question;

// One asked value.
struct Part {
  ValueId value = absent;
  std::string name;
  ValueKind kind = ValueKind::scalar;
  Form form = Form::affine;
  bool as_set = false;  // a list in any order
  Voided voided = Voided::no;
  Tolerance tolerance;
  Exact points = 0;
  std::string feedback;  // the exercise's own words to who gets it wrong

  int dimension = 2;
  bool rational = false;
  Numbers<Exact> right;         // as it is typed
  std::vector<Window> windows;  // of each number of it

  std::string formula;    // P[1][0] = (1 - u) P[0][0] + u P[0][1]
  bool in_words = false;  // of the formula: the index k of the span of U that holds u
  std::string result;     // the right value: (0, 1)
  std::string solution;   // formula, numbers and result

  std::shared_ptr<const Question> question;  // of a part of a lesson's sheet (lesson_grader.hpp), which is no value

  // How many numbers are typed for it; 0: any number of them (a list).
  std::size_t size() const;
  bool is_single() const { return kind == ValueKind::integer || kind == ValueKind::scalar || form == Form::weight; }
  // From the numbers of a trace to those that are typed, and back. A point typed without its weight takes it from
  // `model`, a weight typed alone its point. Nothing where that is impossible (a point at infinity has no coordinates).
  Numbers<Exact> as_typed(NumbersView<Exact> traced) const;
  Numbers<Exact> as_traced(NumbersView<Exact> typed, NumbersView<Exact> model) const;
};

// Whether typed numbers are `traced`, within the part's tolerance and, if given, a widening for each number.
bool agrees(const Part&, NumbersView<Exact> traced, const Numbers<Exact>& typed,
            const std::vector<double>& widening = {});

// Looks names up without making strings of them.
struct NameHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view name) const { return std::hash<std::string_view>()(name); }
};

struct Exercise {
  std::string id;
  std::string title;
  std::string prompt;
  std::string source;
  std::string unit;
  Tolerance tolerance;
  Exact carried = 1;        // the share of its points a carried value earns
  Exact misconception = 0;  // likewise
  Exact slip = 0;
  Feedback feedback = Feedback::full;
  Marking marking = Marking::at_end;  // in the player; files that are handed in are marked as a whole
  Run<Exact> run;
  std::vector<Part> parts;
  Exact max_points = 0;
  // Of the sheet of a lesson: by scene, an exercise with those of its checkpoints that are values, of the scene's
  // title. Of the sheet itself the run is the first scene's.
  std::vector<Exercise> scenes;

  bool is_sheet() const { return !scenes.empty(); }
  std::optional<std::size_t> part(std::string_view name) const;
  std::unordered_map<std::string, std::size_t, NameHash, std::equal_to<>> part_of_name;
};

// "exact" or {"decimals": n} and so on; nothing, with a diagnostic, if it is no tolerance.
std::optional<Tolerance> read_tolerance(const Cursor&);

// The right numbers of a part, their windows and the formula, which follow from the run and from what else is said of
// the part. A point of weight 0 that is asked without its weight has no right numbers: they stay empty.
void complete_part(Part&, const Narrator<Exact>&);

// The misconception of this id that the exercise's algorithm, or one of its scenes', knows; or nullptr.
const Misconception* find_misconception(const Exercise&, std::string_view id);

// Every mistake at once, at its line and column.
Checked<Exercise> read_exercise(const JsonDocument&);
Checked<Exercise> load_exercise(const std::filesystem::path&);

}  // namespace blossom
