#include "grader/page/student_run.hpp"

#include <algorithm>
#include <cmath>

#include "base/utf8.hpp"

namespace blossom {
namespace {

constexpr int digits = 7;                      // of decimals on the page
constexpr std::size_t longest_fraction = 24;   // characters; longer ones are shown as decimals
constexpr std::size_t longest_typed = 80;      // characters of an answer that are shown
constexpr std::uint32_t all_steps_up_to = 80;  // longer runs are told by what is asked
constexpr std::size_t most_steps = 200;        // that are told

std::string shortened(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  std::size_t characters = 0;
  for (std::size_t i = 0; i < text.size(); i += std::max<std::size_t>(utf8_length(text, i), 1))
    if (++characters == longest_typed) {
      text.resize(i);
      return text + "…";
    }
  return text;
}

bool is_plain(const Json& json) { return json.kind == Json::Kind::number || json.kind == Json::Kind::string; }

bool is_decimal(std::string_view typed) { return typed.find_first_of(".eE") != std::string_view::npos; }

// What came of decimals is shown in decimals.
Exact shown(const Exact& x, bool decimal) {
  if (x.is_approximate() || (!decimal && x.to_string().size() <= longest_fraction) || x.is_integer()) return x;
  const double near = x.to_double();
  return std::isfinite(near) ? Exact::approximate(near) : x;
}

}  // namespace

Standing standing_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::correct:
      return Standing::right;
    case Verdict::carried:
      return Standing::carried;
    case Verdict::missing:
      return Standing::missing;
    case Verdict::invalid:
      return Standing::unreadable;
    case Verdict::misconception:
    case Verdict::slip:
    case Verdict::wrong:
      break;
  }
  return Standing::wrong;
}

std::string typed_text(const Json& json) {
  if (is_plain(json)) return shortened(json.text);
  if (json.kind == Json::Kind::null) return "null";
  if (json.kind == Json::Kind::boolean) return json.boolean ? "true" : "false";
  const bool is_set = json.kind == Json::Kind::object && json.items.size() == 1 && json.keys[0] == "set";
  const Json& list = is_set ? json.items[0] : json;
  if (list.kind != Json::Kind::array) return "an object";
  if (!std::ranges::all_of(list.items, is_plain)) return "a list of more than numbers";
  std::string text = is_set ? "{" : "(";
  for (const Json& item : list.items) {
    text += (text.size() > 1 ? ", " : "") + item.text;
    if (text.size() > 8 * longest_typed) break;  // it is cut off anyway
  }
  return shortened(text + (is_set ? "}" : ")"));
}

// The right trace with their numbers in it, of the same names and operands.
class StudentRun::OwnTrace : public Trace<Exact> {
 public:
  explicit OwnTrace(const Trace<Exact>& right) : Trace<Exact>(right) {}
  void put(ValueId v, NumbersView<Exact> numbers, bool decimal) {
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers_[values_[v].numbers_at + i] = shown(numbers[i], decimal);
  }
};

StudentRun::StudentRun(const ExerciseResult& result)
    : exercise_(result.grade ? result.grade->exercise : &result.grader->exercise()),
      right_(exercise_->run, digits),
      plan_(*exercise_) {
  const std::size_t count = trace().value_count();
  standing_.assign(count, Standing::made);
  known_.assign(count, 0);
  differs_.assign(count, 0);
  decimal_.assign(count, 0);
  shown_.assign(count, 0);
  expected_.resize(count);
  expected_text_.resize(count);
  needed_.assign(count, 0);
  answers_.assign(exercise_->parts.size(), nullptr);
  for (const ValueId v : plan_.order) needed_[v] = 1;
  for (ValueId v = 0; v < count; ++v)
    if (trace().is_input(v)) standing_[v] = Standing::given, known_[v] = 1;
  tells_right_ = exercise_->feedback == Feedback::full && !exercise_->is_sheet();
  read_answers(result);
  if (any_told()) choose_steps();
  if (tells_own_) replay();
}

void StudentRun::read_answers(const ExerciseResult& result) {
  if (exercise_->feedback == Feedback::none || !result.grade || !result.grade->reason.empty() || !result.answers)
    return;
  grade_ = &*result.grade;
  answers_ = match_answers(*exercise_, result.answers->root()).part;
  answers_.resize(exercise_->parts.size(), nullptr);
  const bool told = tells_right_ || exercise_->feedback == Feedback::hint;
  if (exercise_->is_sheet()) return;  // of several runs, or of none: what was typed is all there is to tell
  bool any = false, all_right = true;
  for (std::size_t i = 0; i < answers_.size(); ++i) {
    const Verdict verdict = grade_->parts[i].verdict;
    standing_[exercise_->parts[i].value] = standing_of(verdict);
    any = any || answers_[i] != nullptr;
    all_right = all_right && verdict == Verdict::correct;
  }
  // Beside the right run, one that is right throughout has nothing to tell.
  tells_own_ = told && any && !(tells_right_ && all_right);
}

void StudentRun::choose_steps() {
  const std::uint32_t count = trace().step_count();
  const bool everything = tells_right_ && count <= all_steps_up_to;
  std::vector<char> asked(trace().value_count(), 0);
  for (const Part& part : exercise_->parts) {
    asked[part.value] = 1;
    for (const ValueId o : trace().operands(part.value)) asked[o] = 1;
  }
  const auto choose = [&](const std::vector<char>& of) {
    steps_.assign(1, 0);
    for (std::uint32_t k = 1; k < count; ++k) {
      const auto [first, end] = trace().values_of(k);
      bool wanted = false;
      for (ValueId v = first; v < end; ++v) wanted = wanted || (of[v] != 0 && !trace().is_input(v));
      if (wanted) steps_.push_back(k);
    }
  };
  if (everything) {
    steps_.clear();
    for (std::uint32_t k = 0; k < count; ++k) steps_.push_back(k);
  } else {
    choose(needed_);
    if (steps_.size() > most_steps) choose(asked);
    if (steps_.size() > most_steps) steps_.resize(most_steps);
  }
  left_out_ = count - steps_.size();
  if (!everything) return;
  // All of it is told, so all of it is made again from their values.
  plan_.order.clear();
  for (ValueId v = 0; v < trace().value_count(); ++v)
    if (!trace().is_input(v)) plan_.order.push_back(v);
}

void StudentRun::replay() {
  const std::size_t parts = exercise_->parts.size();
  std::vector<Given> as_meant(parts);
  typed_.resize(parts);
  std::vector<char> typed(trace().value_count(), 0);
  for (std::size_t i = 0; i < parts; ++i) {
    const Part& part = exercise_->parts[i];
    if (answers_[i] == nullptr) continue;
    typed_[i] = read_typed(part, *answers_[i]);
    if (!typed_[i].problem.empty()) continue;
    typed[part.value] = 1;
    decimal_[part.value] = std::ranges::any_of(typed_[i].texts, is_decimal) ? 1 : 0;
    if (grade_->parts[i].verdict == Verdict::correct)
      as_meant[i].kind = Given::Kind::right;
    else if (can_carry_on(part, typed_[i]))
      as_meant[i] = {Given::Kind::typed, to_carry_on(typed_[i])};
  }
  Replayed replayed(*exercise_, plan_);
  replayed.run(as_meant);

  OwnTrace own(trace());
  for (const ValueId v : plan_.order) {
    const std::int32_t i = plan_.part_of[v];
    if (typed[v] != 0) {
      const Part& part = exercise_->parts[static_cast<std::size_t>(i)];
      const Typed& as_typed = typed_[static_cast<std::size_t>(i)];
      const auto model = replayed.expected(v).empty() ? trace().numbers(v) : replayed.expected(v);
      const auto numbers =
          can_carry_on(part, as_typed) ? part.as_traced(to_carry_on(as_typed), model) : Numbers<Exact>();
      if (!numbers.empty()) own.put(v, numbers, decimal_[v] != 0);
      // A weight that was not typed is the right one: nothing that is made of it may be told but in full.
      const bool whole = !part.rational || part.form == Form::homogeneous || part.is_single();
      shown_[v] = numbers.empty() ? 0 : 1;
      known_[v] = tells_right_ || (whole && !numbers.empty() && part.form != Form::weight) ? 1 : 0;
    } else {
      if (!replayed.own(v).empty()) {
        for (const ValueId o : trace().operands(v))
          if (decimal_[o] != 0 && replayed.changed(v)) decimal_[v] = 1;
        own.put(v, replayed.own(v), decimal_[v] != 0);
      }
      known_[v] = tells_right_ && !replayed.own(v).empty() ? 1 : 0;
    }
    differs_[v] = replayed.changed(v) || standing_[v] == Standing::wrong ? 1 : 0;
    const bool departs = standing_[v] == Standing::wrong && typed[v] != 0;
    if (tells_right_ && departs && replayed.operands_changed(v) && !replayed.expected(v).empty())
      expected_[v].assign(replayed.expected(v).begin(), replayed.expected(v).end());
  }
  put_in(own);
}

namespace {

Run<Exact> run_with(const Run<Exact>& run, const Trace<Exact>& trace) {
  return {run.algorithm, run.inputs, trace, run.outcome};
}

}  // namespace

void StudentRun::put_in(const OwnTrace& own) {
  own_run_ = std::make_unique<Run<Exact>>(run_with(exercise_->run, own));
  own_trace_ = &own_run_->trace;
  own_.emplace(*own_run_, digits);
  if (std::ranges::all_of(expected_, [](const auto& numbers) { return numbers.empty(); })) return;
  OwnTrace expected(own);
  for (ValueId v = 0; v < expected_.size(); ++v)
    if (!expected_[v].empty()) expected.put(v, expected_[v], decimal_[v] != 0);
  const Run<Exact> run = run_with(exercise_->run, expected);
  const Narrator<Exact> narrator(run, digits);
  for (ValueId v = 0; v < expected_.size(); ++v)
    if (!expected_[v].empty()) expected_text_[v] = text_of(narrator, v);
}

std::string StudentRun::own_text(ValueId v) const {
  const std::int32_t i = plan_.part_of[v];
  if (i != ReplayPlan::not_asked && answers_[static_cast<std::size_t>(i)] != nullptr)
    return typed_text(*answers_[static_cast<std::size_t>(i)]);
  return known_[v] != 0 && own_ ? text_of(*own_, v) : std::string();
}

std::string StudentRun::right_text(ValueId v) const { return text_of(right_, v); }

// A value that is asked is told in the form in which it is typed.
std::string StudentRun::text_of(const Narrator<Exact>& narrator, ValueId v) const {
  const std::int32_t i = plan_.part_of[v];
  const bool homogeneous =
      i != ReplayPlan::not_asked && exercise_->parts[static_cast<std::size_t>(i)].form == Form::homogeneous;
  return homogeneous ? narrator.operand_text(v) : narrator.value_text(v);
}

std::string StudentRun::own_numbers(ValueId v) const {
  if (!own_ || trace().is_input(v)) return {};
  for (const ValueId o : trace().operands(v))
    if (known_[o] == 0) return {};
  return own_->numbers(v);
}

}  // namespace blossom
