#include "player/prediction.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "algorithms/selector.hpp"

namespace blossom {
namespace {

// The numbers as a part's answer stands in the file, as typed.
std::string answer_text(const Part& part, const std::vector<std::string>& numbers) {
  std::string text;
  for (const std::string& number : numbers) text += (text.empty() ? "" : ", ") + json_quote(number);
  if (part.is_single() && numbers.size() == 1) return text;
  return part.as_set ? "{\"set\": [" + text + "]}" : "[" + text + "]";
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::string wanted_numbers(const Part& part) {
  if (part.kind == ValueKind::integer) return "one whole number is asked";
  if (part.is_single()) return "one number is asked";
  const std::string w = part.form == Form::homogeneous ? "w " : "";
  std::string names = w + "x";
  names += part.dimension == 3 ? ", " + w + "y" : "";
  names += (w.empty() ? " and " : ", ") + w + (part.dimension == 3 ? "z" : "y");
  if (!w.empty()) names += " and the weight w";
  return std::to_string(part.size()) + " numbers are asked: " + names;
}

// Why an answer was refused, to somebody who typed numbers into fields and never saw the file.
std::string refusal(const Part& part, const std::vector<std::string>& numbers, const std::string& problem) {
  if (numbers.empty()) return "nothing was typed";
  if (part.size() != 0 && numbers.size() != part.size())
    return wanted_numbers(part) + ", not " + std::to_string(numbers.size());
  for (const std::string& number : numbers) {
    if (number.empty()) return "a number is missing";
    if (!parse_typed(number)) return excerpt(number) + " is no number such as 3, -0.4 or 2/5";
  }
  return "it " + problem;
}

}  // namespace

Prediction::Prediction(std::shared_ptr<const Grader> grader, Marking marking, const TraceGraph& graph)
    : grader_(std::move(grader)), marking_(marking) {
  const auto& parts = exercise().parts;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part& part = parts[i];
    const auto value = graph.find(part.name);
    if (!value) continue;
    questions_.push_back({*value, part.name, graph.value(*value).step, i, part.kind, part.size(), part.form});
  }
  std::ranges::sort(questions_, {}, &AskedValue::value);  // values are numbered as they are made
  attempts_.resize(questions_.size());
  line_guesses_.resize(questions_.size());
  was_shown_.resize(questions_.size());
  grade_ = grade_now();
}

std::optional<std::size_t> Prediction::open() const {
  for (std::size_t q = 0; q < questions_.size(); ++q)
    if (!attempts_[q]) return q;
  return std::nullopt;
}

std::size_t Prediction::answered() const {
  return static_cast<std::size_t>(std::ranges::count_if(attempts_, [](const auto& a) { return a.has_value(); }));
}

bool Prediction::rebind(const TraceGraph& graph) {
  for (AskedValue& question : questions_) {
    const auto value = graph.find(question.name);
    if (!value) return false;
    question.value = *value;
    question.step = graph.value(*value).step;
  }
  return true;
}

void Prediction::carry_over(const Prediction& other) {
  for (std::size_t q = 0; q < questions_.size(); ++q)
    for (std::size_t o = 0; o < other.questions_.size(); ++o) {
      const AskedValue &mine = questions_[q], &theirs = other.questions_[o];
      if (mine.name != theirs.name || mine.size != theirs.size || mine.form != theirs.form) continue;
      attempts_[q] = other.attempts_[o];
      line_guesses_[q] = other.line_guesses_[o];
      was_shown_[q] = other.was_shown_[o];
    }
  undos_ = other.undos_;
  shown_ = other.shown_;
  finished_ = other.finished_;
  mark_all();
}

bool Prediction::veiled(std::uint32_t step) const {
  if (finished()) return false;
  // What is marked at the end stays open to the end, answered or not.
  const std::size_t first = marking_ == Marking::at_end ? 0 : *open();
  return questions_[first].step <= step;
}

std::optional<std::string> Prediction::answer(std::size_t question, std::vector<std::string> numbers) {
  for (std::string& number : numbers) number = trimmed(number);
  const Part& part = exercise().parts[questions_[question].part];
  // Read within the whole file, for that is limited, too.
  const auto file =
      JsonDocument::parse("answers", answers_text(question, answer_text(part, numbers)), submission_limits);
  if (!file) return "the answers are too long all together: " + file.diagnostics.front().message;
  const Json* own = match_answers(exercise(), file).part[questions_[question].part];
  const Typed typed = read_typed(part, *own);
  if (!typed.problem.empty()) return refusal(part, numbers, typed.problem);
  if (numbers.empty()) return refusal(part, numbers, {});  // a list of nothing
  if (mark(question)) return "this answer is marked already; Undo takes it back, and counts as a help";
  make({question, attempts_[question], Attempt{std::move(numbers), was_shown_[question] != 0, {}},
        line_guesses_[question], line_guesses_[question]});
  return std::nullopt;
}

void Prediction::show_me(std::size_t question) {
  Attempt right;
  right.shown = true;
  for (const Exact& x : exercise().parts[questions_[question].part].right) right.numbers.push_back(x.to_string());
  if (was_shown_[question] == 0) ++shown_;
  was_shown_[question] = 1;
  make({question, attempts_[question], std::move(right), line_guesses_[question], line_guesses_[question]});
}

void Prediction::guess_line(std::size_t question, int picked, int right) {
  make({question, attempts_[question], attempts_[question], line_guesses_[question], LineGuess{picked, right}});
}

void Prediction::make(Move move) {
  moves_.resize(at_);
  moves_.push_back(std::move(move));
  redo();
}

bool Prediction::undo() {
  if (at_ == 0) return false;
  const Move& move = moves_[--at_];
  attempts_[move.question] = move.before;
  line_guesses_[move.question] = move.line_before;
  ++undos_;
  mark_all();
  return true;
}

std::string Prediction::undo_what() const {
  const Move& move = moves_[at_ - 1];
  const std::string& name = questions_[move.question].name;
  const bool line = move.line_before.has_value() != move.line_after.has_value() ||
                    (move.line_before && move.line_before->picked != move.line_after->picked);
  if (line) return "the line picked for " + name;
  return (move.after && move.after->shown ? "what was shown of " : "the answer to ") + name;
}

bool Prediction::redo() {
  if (at_ == moves_.size()) return false;
  const Move& move = moves_[at_++];
  attempts_[move.question] = move.after;
  line_guesses_[move.question] = move.line_after;
  mark_all();
  return true;
}

void Prediction::finish() {
  finished_ = true;
  mark_all();
}

bool Prediction::finished() const { return finished_ || !open(); }

// One answer changes what later ones are carried from, so all marks are made again.
void Prediction::mark_all() {
  grade_ = grade_now();
  const bool told = exercise().feedback != Feedback::none && (marking_ == Marking::at_once || finished());
  for (std::size_t q = 0; q < questions_.size(); ++q)
    if (auto& attempt = attempts_[q])
      attempt->mark = told && !attempt->shown ? std::optional(grade_.parts[questions_[q].part]) : std::nullopt;
}

std::optional<PartGrade> Prediction::mark(std::size_t question) const {
  if (const auto& attempt = attempts_[question]) return attempt->mark;
  if (!finished_ || exercise().feedback == Feedback::none) return std::nullopt;
  return grade_.parts[questions_[question].part];
}

std::optional<Grade> Prediction::grade() const {
  if (!finished() || exercise().feedback == Feedback::none) return std::nullopt;
  return grade_;
}

Grade Prediction::grade_now() const {
  return grader_->grade(JsonDocument::parse("answers", answers_file(), submission_limits));
}

std::string Prediction::answers_file() const { return answers_text(std::nullopt, {}); }

std::string Prediction::answers_text(std::optional<std::size_t> instead, const std::string& text) const {
  std::string answers;
  for (std::size_t q = 0; q < questions_.size(); ++q) {
    const bool replaced = q == instead;
    const auto& attempt = attempts_[q];
    if (!replaced && (!attempt || attempt->shown)) continue;
    answers += (answers.empty() ? "\n    " : ",\n    ") + json_quote(questions_[q].name) + ": " +
               (replaced ? text : answer_text(exercise().parts[questions_[q].part], attempt->numbers));
  }
  return "{\n  \"schema\": \"blossom.answers/1\",\n  \"exercise\": " + json_quote(exercise().id) +
         ",\n  \"answers\": {" + answers + (answers.empty() ? "" : "\n  ") + "}\n}\n";
}

// ---- in words -------------------------------------------------------------------------------------------------------

namespace {

constexpr std::size_t longest_reason = 300;

std::vector<std::string> indices_of(const std::string& name) {
  std::vector<std::string> indices;
  const std::string own = name.substr(name.rfind('.') == std::string::npos ? 0 : name.rfind('.') + 1);
  for (std::size_t open = own.find('['); open != std::string::npos; open = own.find('[', open + 1))
    indices.push_back(own.substr(open + 1, own.find(']', open) - open - 1));
  return indices;
}

// "the point i of level r" of P[1][2] is the point 2 of level 1. Only whole words are indices: not the i of "point".
std::string filled(std::string_view meaning, const ValueSpec& spec, const std::vector<std::string>& indices) {
  const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
  std::string text;
  for (std::size_t i = 0; i < meaning.size();) {
    std::size_t end = i;
    while (end < meaning.size() && is_letter(meaning[end])) ++end;
    if (end == i) {
      text += meaning[i++];
      continue;
    }
    const std::string_view word = meaning.substr(i, end - i);
    const auto index = static_cast<std::size_t>(std::ranges::find(spec.indices, word) - spec.indices.begin());
    text += index < indices.size() && index < spec.indices.size() ? indices[index] : std::string(word);
    i = end;
  }
  return text;
}

}  // namespace

std::string asked_words(const AskedValue& question, const StepSource& source) {
  const ValueSpec* spec = source.spec(question.value);
  std::string text = "What is " + question.name + "?";
  if (spec != nullptr && !spec->meaning.empty())
    text += " It is " + filled(spec->meaning, *spec, indices_of(question.name)) + ".";
  return text;
}

std::string answer_words(const AskedValue& question, const std::vector<std::string>& numbers) {
  std::string list;
  for (const std::string& number : numbers) list += (list.empty() ? "" : ", ") + number;
  return question.name + " = " + (question.size == 1 ? list : "(" + list + ")");
}

std::string reason_words(const AskedValue& question, const StepSource& source) {
  const std::string formula = source.formula(question.value);
  if (formula.empty() || formula.size() > longest_reason) return {};
  const std::string numbers = source.numbers(question.value);
  const bool with_numbers = !numbers.empty() && numbers != formula && numbers.size() <= longest_reason;
  return question.name + " = " + formula + (with_numbers ? " = " + numbers : "");
}

std::vector<std::string> split_numbers(const std::string& text) {
  std::vector<std::string> numbers;
  std::string number;
  for (const char c : text + ",") {
    if (std::string_view(",; \t\r\n()[]").find(c) == std::string_view::npos) {
      number += c;
    } else if (!number.empty()) {
      numbers.push_back(std::exchange(number, {}));
    }
  }
  return numbers;
}

// ---- by a click -----------------------------------------------------------------------------------------------------

std::vector<std::string> prefilled(const AskedValue& question, const glm::dvec3& clicked, double unit) {
  if (question.kind != ValueKind::point || question.form != Form::affine) return {};
  constexpr int most_decimals = 12;
  int decimals = most_decimals;
  if (unit > 0) decimals = static_cast<int>(std::clamp(std::ceil(-std::log10(unit) - 1e-9), 0.0, 1.0 * most_decimals));
  std::vector<std::string> numbers;
  for (int c = 0; c < static_cast<int>(question.size); ++c) numbers.push_back(format_short(clicked[c], decimals));
  return numbers;
}

// ---- practice -------------------------------------------------------------------------------------------------------

namespace {

constexpr std::size_t most_usual = 40;  // values, when nobody said what to ask
constexpr double share_of_picture = 0.02;
constexpr double number_tolerance = 0.01;
// The reader of exercises wants an absolute tolerance to be at most a tenth of the largest number; here in double
// precision, so a little less.
constexpr double share_of_largest = 0.099;

// The longest side of the box around all given points.
double extent(const Inputs<Exact>& inputs) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  glm::dvec3 low(infinity), high(-infinity);
  const auto add = [&](const HPoint<Exact>& P) {
    const double w = P.w.to_double();
    if (w == 0) return;
    const glm::dvec3 at{P.x.to_double() / w, P.y.to_double() / w, P.z.to_double() / w};
    low = glm::min(low, at);
    high = glm::max(high, at);
  };
  for (const auto& [name, value] : inputs.values) {
    if (const auto* c = std::get_if<Curve<Exact>>(&value)) std::ranges::for_each(c->points, add);
    if (const auto* s = std::get_if<Surface<Exact>>(&value)) std::ranges::for_each(s->points, add);
    if (const auto* cs = std::get_if<std::vector<Curve<Exact>>>(&value))
      for (const auto& c : *cs) std::ranges::for_each(c.points, add);
  }
  const glm::dvec3 size = high - low;
  return std::max({size.x, size.y, size.z, 0.0});
}

}  // namespace

double click_tolerance(const Inputs<Exact>& inputs) { return share_of_picture * extent(inputs); }

namespace {

// What can be asked of a selection: what is made, each value once, and no point at infinity.
class Choice {
 public:
  explicit Choice(const Trace<double>& trace) : trace_(trace), chosen_(trace.value_count()) {}

  // The values of the selector that can be asked and were not chosen yet.
  std::vector<ValueId> open(const Selector& selector) const {
    auto values = selector.select(trace_);
    std::erase_if(values, [&](ValueId v) { return chosen_[v] || !can_be_asked(v); });
    return values;
  }
  void take(const std::vector<ValueId>& values) {
    for (const ValueId v : values) chosen_[v] = true;
    count_ += values.size();
  }
  std::size_t count() const { return count_; }

  std::string asks(double click_tolerance) const {
    std::string text;
    double largest_coordinate = 0;
    for (ValueId v = 0; v < trace_.value_count(); ++v) {
      if (!chosen_[v]) continue;
      const auto numbers = trace_.numbers(v);
      text += (text.empty() ? "{\"value\": " : ", {\"value\": ") + json_quote(trace_.name(v)) + ", \"points\": 1";
      const ValueKind kind = trace_.value(v).kind;
      double largest = 0;
      if (is_point(v)) {
        const double w = trace_.rational && kind == ValueKind::point ? numbers[3] : 1;
        for (int c = 0; c < trace_.dimension; ++c)
          largest_coordinate = std::max(largest_coordinate, std::abs(numbers[static_cast<std::size_t>(c)] / w));
      } else if (kind != ValueKind::integer) {
        for (const double x : numbers) largest = std::max(largest, std::abs(x));
        text += ", \"tolerance\": " + absolute(number_tolerance, largest);
      }
      text += "}";
    }
    return "\"ask\": [" + text + "], \"tolerance\": " + absolute(click_tolerance, largest_coordinate);
  }

 private:
  bool is_point(ValueId v) const {
    const ValueKind kind = trace_.value(v).kind;
    return kind == ValueKind::point || kind == ValueKind::vector;
  }
  bool can_be_asked(ValueId v) const {
    if (trace_.is_input(v)) return false;
    if (trace_.value(v).kind == ValueKind::scalar && is_rounding(trace_.numbers(v)[0])) return false;
    if (trace_.value(v).kind != ValueKind::point || !trace_.rational) return true;
    const auto P = trace_.numbers(v);  // a weight that is 0 but for rounding counts as 0
    return std::abs(P[3]) > 1e-12 * std::max({1.0, std::abs(P[0]), std::abs(P[1]), std::abs(P[2])});
  }
  // 0 but for rounding: nobody can tell its digits, nor which tolerance suits it.
  static bool is_rounding(double x) { return x != 0 && std::abs(x) < 1e-12; }
  static std::string absolute(double amount, double largest) {
    if (largest > 0) amount = std::min(amount, share_of_largest * largest);
    return "{\"absolute\": " + format_number(amount) + "}";
  }

  const Trace<double>& trace_;
  std::vector<bool> chosen_;
  std::size_t count_ = 0;
};

// What exercises on the algorithm usually ask: selectors that fit whole into what may be asked; when not even one does,
// the beginning of the first.
void choose_usual(const Algorithm& algorithm, Choice& choice) {
  std::vector<ValueId> first;
  for (const std::string_view text : algorithm.asks) {
    std::string problem;
    const auto selector = Selector::parse(text, problem);
    if (!selector) continue;
    auto values = choice.open(*selector);
    if (choice.count() + values.size() <= most_usual)
      choice.take(values);
    else if (first.empty())
      first = std::move(values);
  }
  if (choice.count() > 0) return;
  first.resize(std::min(first.size(), most_usual));
  choice.take(first);
}

}  // namespace

Checked<std::shared_ptr<const Grader>> practice_exercise(const Algorithm& algorithm, const Inputs<Exact>& inputs,
                                                         const std::vector<std::string>& asks, const std::string& id,
                                                         const std::string& title) {
  const auto run = record<double>(algorithm, inputs);
  if (!run) return run.diagnostics;
  Choice choice(run->trace);
  for (const std::string& ask : asks) {
    std::string problem;
    const auto selector = Selector::parse(ask, problem);
    if (!selector) return Diagnostics{{"", 0, 0, "", excerpt(ask) + " is no selector: " + problem}};
    choice.take(choice.open(*selector));  // of edited inputs a lesson's selector may find nothing
  }
  if (asks.empty()) choose_usual(algorithm, choice);
  if (choice.count() == 0) return Diagnostics{{"", 0, 0, "", "there is nothing to predict in this run"}};

  std::string given;
  for (const auto& [name, value] : inputs.values)
    given += (given.empty() ? "" : ", ") + json_quote(name) + ": " + write_input(value);
  const std::string text =
      "{\"schema\": \"blossom.exercise/1\", \"id\": " + json_quote(id) +
      ", \"title\": " + json_quote(title.empty() ? std::string(algorithm.title) : title) +
      ", \"prompt\": \"Predict each value before it is shown.\", \"algorithm\": " + json_quote(algorithm.id) +
      ", \"inputs\": {" + given + "}, " + choice.asks(click_tolerance(inputs)) + ", \"feedback\": \"full\"}";
  const auto document = JsonDocument::parse("practice", text);
  if (!document) return document.diagnostics;
  auto exercise = read_exercise(*document);
  if (!exercise) return exercise.diagnostics;
  return std::shared_ptr<const Grader>(std::make_shared<const Grader>(std::move(*exercise)));
}

}  // namespace blossom
