#include "grader/exercise.hpp"

#include <algorithm>

#include "algorithms/formula_words.hpp"
#include "algorithms/selector.hpp"
#include "grader/variant_spec.hpp"
#include "lesson/document.hpp"
#include "lesson/file_kind.hpp"
#include "lesson/lesson.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_parts = 2000;  // of an exercise; a submission has at most 4096 values
constexpr std::size_t longest_formula = 300;

// One of several words, named with all of them when it is none.
template <class T>
std::optional<T> one_of(const Cursor& at, const std::vector<std::pair<std::string, T>>& words) {
  const auto text = at.string();
  if (!text) return std::nullopt;
  std::vector<std::string> known;
  std::string message = "must be one of";
  for (const auto& [word, value] : words) {
    if (word == *text) return value;
    message += (known.empty() ? " " : ", ") + json_quote(word);
    known.push_back(word);
  }
  const auto near = did_you_mean(*text, known);
  at.error(message + ", not " + excerpt(*text) + (near ? "; did you mean " + json_quote(*near) + "?" : ""));
  return std::nullopt;
}

std::optional<Exact> number_in(const Cursor& at, const Exact& at_least, const std::optional<Exact>& at_most,
                               const std::string& rule) {
  auto number = at.number();
  if (!number) return std::nullopt;
  if (*number < at_least || (at_most && *at_most < *number)) {
    at.error(rule + ", not " + excerpt(at.json().text));
    return std::nullopt;
  }
  return number;
}

std::optional<Exact> share(const Cursor& at) {
  return number_in(at, Exact(0), Exact(1), "must be a share from 0 to 1");
}

// Where its equation ends: what is computed, and then what is asked of it.
std::string result_text(const Part& part, const Narrator<Exact>& narrator) {
  switch (part.form) {
    case Form::affine:
      break;
    case Form::homogeneous:
      return narrator.operand_text(part.value);
    case Form::weight:
      return narrator.operand_text(part.value) + ": w = " + format_brief(part.right[0]);
  }
  return narrator.made_text(part.value);
}

// Whether Exact::parse reads some text of this number: a fraction or a decimal of at most 400 characters.
bool has_text(const Exact& x) {
  constexpr std::size_t longest = 400, longest_mantissa = 390;
  if (x.to_string().size() <= longest) return true;
  const Exact scaled = x * *Exact::parse("1e400");
  const std::string digits = scaled.to_string();
  return scaled.is_integer() && digits.find_last_not_of('0') < longest_mantissa;
}

class ExerciseReader {
 public:
  explicit ExerciseReader(const Cursor& root) : root_(root) {}

  void read() {
    if (!root_.expect_object({"$schema", "schema", "id", "title", "prompt", "algorithm", "inputs", "ask", "tolerance",
                              "carried", "partial", "feedback", "source", "unit", "marking", "vary"}))
      return;
    expect_schema(root_, "blossom.exercise/1");
    if (const auto at = root_.required("id")) exercise.id = read_id(*at).value_or("");
    if (const auto at = root_.required("title")) exercise.title = read_text(*at).value_or("");
    if (const auto at = root_.required("prompt")) exercise.prompt = read_text(*at).value_or("");
    if (const auto at = root_.optional("source")) exercise.source = at->string().value_or("");
    if (const auto at = root_.optional("unit")) exercise.unit = at->string().value_or("");
    if (const auto at = root_.optional("tolerance"))
      if (auto tolerance = read_tolerance(*at)) exercise.tolerance = std::move(*tolerance);
    if (const auto at = root_.optional("carried"))
      if (auto x = share(*at)) exercise.carried = std::move(*x);
    if (const auto at = root_.optional("partial"); at && at->expect_object({"misconception", "slip"})) {
      if (const auto m = at->optional("misconception"))
        if (auto x = share(*m)) exercise.misconception = std::move(*x);
      if (const auto s = at->optional("slip"))
        if (auto x = share(*s)) exercise.slip = std::move(*x);
    }
    if (const auto at = root_.optional("feedback")) {
      const auto level = one_of<Feedback>(*at, {{"none", Feedback::none},
                                                {"verdict", Feedback::verdict},
                                                {"hint", Feedback::hint},
                                                {"full", Feedback::full}});
      if (level) exercise.feedback = *level;
    }
    if (const auto at = root_.optional("marking")) exercise.marking = read_marking(*at).value_or(exercise.marking);
    const bool ran = run();
    if (const auto at = root_.optional("prompt"); at && ran) fill_prompt(*at);
    const auto ask = root_.required("ask");
    if (!ask || !ask->expect_array(1, most_parts)) return;
    for (std::size_t i = 0; i < ask->size(); ++i) read_ask((*ask)[i], ran);
    if (values_ > submission_limits.values || bytes_ > submission_limits.bytes)
      ask->error("asks for more than can be handed in: a submission has at most " +
                 std::to_string(submission_limits.values) + " values and " + std::to_string(submission_limits.bytes) +
                 " bytes");
    if (const auto at = root_.optional("tolerance")) check_absolute(*at, exercise.tolerance, largest_);
    if (ran && !ask->has_errors() && exercise.max_points == Exact(0))
      ask->error("must be worth more than 0 points in all");
    if (const auto at = root_.optional("vary"); at && ran) read_vary(*at, *root_.optional("inputs"), exercise);
  }

  Exercise exercise;

 private:
  bool run() {
    const Algorithm* algorithm = read_algorithm(root_);
    if (algorithm == nullptr) return false;
    auto run = read_run(root_, *algorithm);
    if (!run) return false;
    exercise.run = std::move(*run);
    narrator_.emplace(exercise.run);
    return true;
  }

  // Its placeholders name what is given: {u}, {P[0][1]}.
  void fill_prompt(const Cursor& at) {
    if (const auto open = open_brace(exercise.prompt))
      return at.error("a { has no } behind it, at " + excerpt(std::string_view(exercise.prompt).substr(*open)));
    const auto& trace = exercise.run.trace;
    std::vector<std::string> unknown;
    auto filled = narrator_->fill(exercise.prompt, 0, &unknown);
    for (const std::string& placeholder : unknown) {
      const std::string_view name = std::string_view(placeholder).substr(placeholder.starts_with('#') ? 1 : 0);
      std::string message = excerpt("{" + placeholder + "}") + " names nothing that is given";
      if (trace.find(name))
        message += ": it is computed";
      else if (const auto near = nearest_name(trace, name))
        message += "; did you mean " + excerpt(*near) + "?";
      at.error(message);
    }
    std::vector<ProseMistake> mistakes;
    read_prose(filled, &mistakes);
    for (const ProseMistake& mistake : mistakes)
      at.error(mistake.what + ", at " + excerpt(std::string_view(filled).substr(std::min(mistake.at, filled.size()))));
    exercise.prompt = std::move(filled);
  }

  void read_ask(const Cursor& at, bool ran) {
    if (!at.expect_object({"value", "points", "form", "as", "tolerance", "feedback", "void"})) return;
    Part model;
    model.tolerance = exercise.tolerance;
    if (const auto points = at.required("points"))
      if (auto n = number_in(*points, Exact(0), Exact(1'000'000), "must be from 0 to 1000000"))
        model.points = std::move(*n);
    std::optional<Cursor> form = at.optional("form");
    if (form) {
      const auto found =
          one_of<Form>(*form, {{"affine", Form::affine}, {"homogeneous", Form::homogeneous}, {"weight", Form::weight}});
      if (found) model.form = *found;
    }
    std::optional<Cursor> as = at.optional("as");
    if (as) {
      const auto found = one_of<bool>(*as, {{"set", true}, {"list", false}});
      model.as_set = found && *found;
    }
    if (const auto voided = at.optional("void"))
      model.voided = one_of<Voided>(*voided, {{"credit", Voided::credit}, {"drop", Voided::drop}}).value_or(Voided::no);
    if (model.voided == Voided::drop) model.points = 0;
    const auto own_tolerance = at.optional("tolerance");
    if (own_tolerance)
      if (auto found = read_tolerance(*own_tolerance)) model.tolerance = std::move(*found);
    if (const auto feedback = at.optional("feedback"))
      if (auto found = feedback->string()) model.feedback = std::move(*found);

    const auto value = at.required("value");
    const auto text = value ? value->string() : std::nullopt;
    if (!text) return;
    std::string problem;
    const auto selector = Selector::parse(*text, problem);
    if (!selector) {
      value->error(excerpt(*text) + " is no selector: " + problem);
      return;
    }
    if (!ran) return;
    const auto& trace = exercise.run.trace;
    auto values = selector->select(trace);
    if (values.empty()) {
      const auto near = nearest_name(trace, *text);
      value->error(excerpt(*text) + " matches no value of this run; " +
                   (near ? "did you mean " + json_quote(*near) + "?" : usual()));
      return;
    }
    // P[*][*] means the points that are computed.
    std::erase_if(values, [&](ValueId v) { return trace.is_input(v); });
    if (values.empty()) value->error(excerpt(*text) + " is given and cannot be asked; " + usual());
    const std::size_t first = exercise.parts.size();
    for (const ValueId v : values) {
      Part part = model;
      part.value = v;
      part.name = trace.name(v);
      part.kind = trace.value(v).kind;
      if (exercise.part_of_name.contains(part.name)) {
        value->error(json_quote(part.name) + " is asked twice");
      } else if (exercise.parts.size() == most_parts) {
        value->error("too many values are asked; at most " + std::to_string(most_parts));
        return;
      } else {
        add(std::move(part), *value, form, as);
      }
    }
    Exact largest = 0;
    for (std::size_t i = first; i < exercise.parts.size(); ++i)
      if (exercise.parts[i].kind != ValueKind::integer)
        for (const Exact& x : exercise.parts[i].right) largest = std::max(largest, abs(x));
    if (own_tolerance)
      check_absolute(*own_tolerance, model.tolerance, largest);
    else
      largest_ = std::max(largest_, largest);
  }

  // Whether an absolute tolerance tells the asked numbers from 0, of which `largest` is the size of the largest.
  void check_absolute(const Cursor& at, const Tolerance& tolerance, const Exact& largest) const {
    if (tolerance.kind != Tolerance::Kind::absolute || largest == Exact(0)) return;
    const Exact most = largest / Exact(10);
    if (most < tolerance.amount)
      at.error("accepts nearly everything: an absolute tolerance must be at most " + format_number(most.to_double()) +
               ", a tenth of the largest number it is for");
  }

  // What exercises on this algorithm usually ask.
  std::string usual() const {
    std::string text;
    for (const auto& ask : exercise.run.algorithm->asks)
      text += (text.empty() ? "usually asked: " : ", ") + std::string(ask);
    return text;
  }

  void add(Part part, const Cursor& value, const std::optional<Cursor>& form, const std::optional<Cursor>& as) {
    const bool is_point = part.kind == ValueKind::point || part.kind == ValueKind::vector;
    if (form && !(is_point && exercise.run.trace.rational)) {
      form->error("is for points of rational curves and surfaces; " + json_quote(part.name) + " is typed as it is");
      return;
    }
    if (as && part.kind != ValueKind::list) {
      as->error("is for lists, such as knot vectors; " + json_quote(part.name) + " is no list");
      return;
    }
    complete_part(part, *narrator_);
    if (part.right.empty()) {
      value.error(json_quote(part.name) +
                  " has weight 0 and no affine point; ask for it with \"form\": \"homogeneous\"");
      return;
    }
    const bool irrational = std::ranges::any_of(part.right, [](const Exact& x) { return x.is_approximate(); });
    if (irrational && part.tolerance.kind == Tolerance::Kind::exact) {
      value.error(json_quote(part.name) +
                  " is irrational and cannot be asked exactly; give a \"tolerance\" such as {\"decimals\": 4}");
      return;
    }
    if (!can_be_typed(part)) {
      value.error(json_quote(part.name) +
                  " has more digits than can be typed; give a \"tolerance\" such as {\"significant\": 4}");
      return;
    }
    exercise.max_points += part.points;
    exercise.part_of_name.emplace(part.name, exercise.parts.size());
    exercise.parts.push_back(std::move(part));
  }

  // Whether each right number is one that Exact::parse reads. Counts what the right answers take in a submission.
  bool can_be_typed(const Part& part) {
    constexpr std::size_t rounded = 25;  // a double's digits, where there is a tolerance
    values_ += 1 + part.right.size();
    bytes_ += part.name.size() + 8;
    for (const Exact& x : part.right) {
      const std::size_t size = x.to_string().size();
      const bool exact = part.tolerance.kind == Tolerance::Kind::exact;
      if (exact && !has_text(x)) return false;
      bytes_ += 4 + (exact ? size : std::min(size, rounded));
    }
    return true;
  }

  const Cursor& root_;
  std::optional<Narrator<Exact>> narrator_;
  std::size_t values_ = 6;  // of the right answers as a submission: the object, "schema", "exercise", "answers", ...
  std::size_t bytes_ = 200;
  Exact largest_ = 0;  // size of an asked number with the exercise's tolerance
};

}  // namespace

std::optional<Tolerance> read_tolerance(const Cursor& at) {
  constexpr int most_digits = 15;
  Tolerance tolerance;
  if (at.is(Json::Kind::string)) {
    if (one_of<int>(at, {{"exact", 0}})) return tolerance;
    return std::nullopt;
  }
  const std::vector<std::string> kinds{"decimals", "significant", "absolute", "relative"};
  const auto commented = static_cast<std::size_t>(std::ranges::count(at.json().keys, "$comment"));
  if (!at.is(Json::Kind::object) || at.size() != 1 + commented) {
    at.error(
        "must be \"exact\" or one of {\"decimals\": n}, {\"significant\": n}, {\"absolute\": x}, {\"relative\": x}");
    return std::nullopt;
  }
  if (!at.expect_object(kinds)) return std::nullopt;
  if (const auto digits = at.optional("decimals")) {
    const auto n = digits->integer(0, most_digits);
    if (!n) return std::nullopt;
    return Tolerance{Tolerance::Kind::decimals, *n, 0};
  }
  if (const auto digits = at.optional("significant")) {
    const auto n = digits->integer(1, most_digits);
    if (!n) return std::nullopt;
    return Tolerance{Tolerance::Kind::significant, *n, 0};
  }
  if (const auto amount = at.optional("absolute")) {
    auto x = number_in(*amount, Exact(0), std::nullopt, "must not be negative");
    if (!x) return std::nullopt;
    return Tolerance{Tolerance::Kind::absolute, 0, std::move(*x)};
  }
  if (const auto amount = at.optional("relative")) {
    const char* const rule = "must be at least 0 and below 1";
    auto x = number_in(*amount, Exact(0), Exact(1), rule);
    if (!x) return std::nullopt;
    if (*x == Exact(1)) {
      amount->error(std::string(rule) + ", or 0 would be right everywhere");
      return std::nullopt;
    }
    return Tolerance{Tolerance::Kind::relative, 0, std::move(*x)};
  }
  return std::nullopt;
}

std::size_t Part::size() const {
  if (is_single()) return 1;
  if (kind == ValueKind::list) return 0;
  return static_cast<std::size_t>(dimension) + (form == Form::homogeneous ? 1 : 0);
}

Numbers<Exact> Part::as_typed(NumbersView<Exact> traced) const {
  if (kind != ValueKind::point && kind != ValueKind::vector) return {traced.begin(), traced.end()};
  if (traced.size() != 4) return {};
  const Exact& w = traced[3];
  if (form == Form::weight) return {w};
  Numbers<Exact> typed(traced.begin(), traced.begin() + dimension);
  if (form == Form::homogeneous) {
    typed.push_back(w);
  } else if (rational) {
    if (w == Exact(0)) return {};
    for (Exact& x : typed) x /= w;
  }
  return typed;
}

Numbers<Exact> Part::as_traced(NumbersView<Exact> typed, NumbersView<Exact> model) const {
  if (kind != ValueKind::point && kind != ValueKind::vector) return {typed.begin(), typed.end()};
  if (model.size() != 4) return {};
  const auto d = static_cast<std::size_t>(dimension);
  Numbers<Exact> traced(model.begin(), model.end());
  if (form == Form::weight) {
    if (model[3] == Exact(0)) return {};
    for (std::size_t i = 0; i < d; ++i) traced[i] = model[i] / model[3] * typed[0];
    traced[3] = typed[0];
    return traced;
  }
  for (std::size_t i = 0; i < d; ++i) traced[i] = form == Form::affine && rational ? typed[i] * model[3] : typed[i];
  if (form == Form::homogeneous) traced[3] = typed[d];
  return traced;
}

bool agrees(const Part& part, NumbersView<Exact> traced, const Numbers<Exact>& typed,
            const std::vector<double>& widening) {
  auto numbers = part.as_typed(traced);
  if (numbers.empty() || numbers.size() != typed.size()) return false;
  if (part.as_set) std::ranges::sort(numbers);
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!within(part.tolerance, numbers[i], typed[i], i < widening.size() ? widening[i] : 0)) return false;
  return true;
}

void complete_part(Part& part, const Narrator<Exact>& narrator) {
  const auto& trace = narrator.trace();
  part.dimension = trace.dimension;
  part.rational = trace.rational;
  if (part.kind == ValueKind::integer) part.tolerance = {};
  if (part.kind == ValueKind::vector && part.rational && part.form == Form::affine) part.form = Form::homogeneous;
  part.right = part.as_typed(trace.numbers(part.value));
  if (part.right.empty()) return;
  if (part.as_set) std::ranges::sort(part.right);
  for (const Exact& x : part.right) part.windows.push_back(window(part.tolerance, x));
  const std::string name = trace.name(part.value), formula = narrator.formula(part.value);
  const std::string& result = part.result = result_text(part, narrator);
  part.in_words = is_sentence(formula);
  part.formula = part.in_words ? formula : name + " = " + formula;
  part.solution = name + " = ";
  if (part.in_words) {
    part.solution += result + ", " + formula;
    return;
  }
  const auto with_numbers = narrator.numbers(part.value);
  const bool copied = result.starts_with(with_numbers);
  if (with_numbers.size() <= longest_formula) part.solution += formula + " = " + (copied ? "" : with_numbers + " = ");
  part.solution += result;
}

const Misconception* find_misconception(const Exercise& exercise, std::string_view id) {
  const auto of = [&](const Algorithm& algorithm) -> const Misconception* {
    const auto found = std::ranges::find(algorithm.misconceptions, id, &Misconception::id);
    return found != algorithm.misconceptions.end() ? &*found : nullptr;
  };
  if (id.empty()) return nullptr;
  if (const Misconception* found = of(*exercise.run.algorithm)) return found;
  for (const Exercise& scene : exercise.scenes)
    if (const Misconception* found = of(*scene.run.algorithm)) return found;
  return nullptr;
}

std::optional<std::size_t> Exercise::part(std::string_view name) const {
  const auto found = part_of_name.find(name);
  return found == part_of_name.end() ? std::nullopt : std::optional(found->second);
}

Checked<Exercise> read_exercise(const JsonDocument& document) {
  Diagnostics diagnostics;
  const Cursor root(document, diagnostics);
  // Of a file of another kind everything would be wrong.
  if (const FileKind kind = file_kind(document.root()); kind != FileKind::exercise && kind != FileKind::unknown) {
    root.error("is " + with_article(kind) + ", where an exercise is wanted (schema blossom.exercise/1)");
    return diagnostics;
  }
  ExerciseReader reader(root);
  reader.read();
  if (!diagnostics.empty()) return diagnostics;
  return std::move(reader.exercise);
}

Checked<Exercise> load_exercise(const std::filesystem::path& path) {
  const auto document = JsonDocument::load(path);
  if (!document) return document.diagnostics;
  return read_exercise(*document);
}

}  // namespace blossom
