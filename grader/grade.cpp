#include "grader/grade.hpp"

#include <algorithm>
#include <charconv>
#include <unordered_set>

#include "grader/lesson_grader.hpp"

namespace blossom {
namespace {

constexpr std::string_view verdict_names[verdict_count] = {"correct", "carried", "misconception", "slip",
                                                           "wrong",   "missing", "invalid"};
constexpr std::size_t longest_exact = 20;  // characters; 64 bits hold what fits in them

std::vector<double> roundings(const Part& part, const Typed& typed) {
  if (part.tolerance.kind == Tolerance::Kind::exact) return {};
  std::vector<double> rounding;
  for (std::size_t i = 0; i < typed.texts.size(); ++i)
    rounding.push_back(std::min(rounding_of(typed.texts[i]), slack(part.tolerance, typed.numbers[i]).to_double()));
  return rounding;
}

std::string digits_asked(const Tolerance& tolerance) {
  const auto count = [&](const std::string& what) {
    return std::to_string(tolerance.digits) + " " + what + (tolerance.digits == 1 ? "" : "s");
  };
  switch (tolerance.kind) {
    case Tolerance::Kind::exact:
      return "the fraction";
    case Tolerance::Kind::decimals:
      return count("decimal");
    case Tolerance::Kind::significant:
      return count("significant digit");
    case Tolerance::Kind::absolute:
    case Tolerance::Kind::relative:
      break;
  }
  return "more digits";
}

// alpha[1][4] for alpha[1][3] moved by 1; nothing of a name without an index.
std::optional<std::string> with_last_index_moved(std::string_view name, int by) {
  const std::size_t open = name.rfind('[');
  int index = 0;
  if (open == std::string_view::npos || !name.ends_with(']') ||
      std::from_chars(name.data() + open + 1, name.data() + name.size() - 1, index).ec != std::errc())
    return std::nullopt;
  return std::string(name.substr(0, open + 1)) + std::to_string(index + by) + "]";
}

std::string sentence(std::string_view text) {
  std::string s(text);
  if (!s.empty() && 'a' <= s[0] && s[0] <= 'z') s[0] = static_cast<char>(s[0] - 'a' + 'A');
  if (!s.empty() && s.back() != '.' && s.back() != '!' && s.back() != '?') s += '.';
  return s;
}

}  // namespace

Numbers<Exact> to_carry_on(const Typed& typed) {
  Numbers<Exact> numbers;
  for (std::size_t i = 0; i < typed.numbers.size(); ++i)
    numbers.push_back(typed.texts[i].size() <= longest_exact &&
                              typed.texts[i].find_first_of("eE") == std::string_view::npos
                          ? typed.numbers[i]
                          : Exact::approximate(typed.numbers[i].to_double()));
  return numbers;
}

bool can_carry_on(const Part& part, const Typed& typed) {
  if (!typed.problem.empty()) return false;
  if (part.kind != ValueKind::list) return true;
  return typed.numbers.size() == part.right.size() && std::ranges::is_sorted(typed.numbers);
}

std::string_view verdict_name(Verdict verdict) { return verdict_names[static_cast<std::size_t>(verdict)]; }

std::string advice_of(const Misconception& m) { return sentence(m.title) + " " + std::string(m.advice); }

double Grade::score() const { return (points / exercise->max_points).to_double(); }

Grader::Grader(Exercise exercise) : exercise_(std::move(exercise)), plan_(exercise_), explainer_(exercise_, plan_) {
  const auto& trace = exercise_.run.trace;
  trace.find({});  // builds its index now, so that grading changes nothing
  if (exercise_.is_sheet()) {
    for (Exercise& scene : exercise_.scenes) {
      scene.feedback = exercise_.feedback;
      scenes_.push_back(std::make_unique<const Grader>(scene));
    }
    return;
  }
  leave_out_strange_names();
  Replayed right(exercise_, plan_);
  right.run(std::vector<Given>(exercise_.parts.size(), Given{Given::Kind::right}));
  const auto trivial = right.trivial();
  for (const Part& part : exercise_.parts) {
    right_is_trivial_.push_back(trivial[part.value]);
    any_voided_ = any_voided_ || part.voided != Voided::no;
  }
}

// A rule whose names nobody was asked for, values of a run within the run, tells nothing; and a question of a lesson
// asks for no name at all.
void Grader::leave_out_strange_names() {
  const auto& trace = exercise_.run.trace;
  std::unordered_set<ValueId> asked;
  for (const Part& part : exercise_.parts) asked.insert(part.value);
  for (Part& part : exercise_.parts) {
    const std::string name = trace.name(part.value), scope = trace.scope(part.value);
    const bool is_hidden = !scope.empty() && part.name != name;
    const bool any_strange = std::ranges::any_of(trace.operands(part.value), [&](ValueId o) {
      return !asked.contains(o) && !scope.starts_with(trace.scope(o)) &&
             part.formula.find(trace.name(o)) != std::string::npos;
    });
    if (!is_hidden && !any_strange) continue;
    part.formula.clear();
    part.solution = (is_hidden ? "" : name + " = ") + part.result;
  }
}

// The answers that are not right, with what is known of them so far.
struct Grader::Open {
  std::vector<Typed> typed;     // by part; read only where there is an answer that is not right
  std::vector<char> is_open;    // has an answer of the right shape, and no verdict yet
  std::vector<Given> as_meant;  // right answers stand for the right value
  std::vector<Given> as_typed;  // right answers stand for what was typed, however rounded
  bool rounded = false;         // whether the two can differ
};

Grade Grader::grade(const Checked<JsonDocument>& document, std::string student) const {
  return grade(match_answers(exercise_, document), std::move(student));
}

Grade Grader::grade(const Json& root, std::string student) const {
  return grade(match_answers(exercise_, root), std::move(student));
}

Grade Grader::grade(Answers&& answers, std::string student) const {
  Grade grade;
  grade.exercise = &exercise_;
  grade.student = std::move(student);
  grade.parts.resize(exercise_.parts.size());
  grade.notes = std::move(answers.notes);
  if (!answers.reason.empty()) {
    grade.reason = std::move(answers.reason);
    for (PartGrade& part : grade.parts) part.verdict = Verdict::invalid;
    return grade;
  }
  if (exercise_.is_sheet()) {
    grade_sheet(answers, grade);
    return grade;
  }
  bool all_right = true;
  for (std::size_t i = 0; i < grade.parts.size(); ++i) {
    const Part& part = exercise_.parts[i];
    PartGrade& made = grade.parts[i];
    if (answers.part[i] != nullptr && match(part, *answers.part[i]) == Match::right) {
      made.verdict = Verdict::correct;
      made.points = part.points;
      made.feedback = feedback(part, Verdict::correct, {});
    } else {
      all_right = false;
    }
  }
  if (!all_right) {
    look_closer(answers, grade);
    settle_other_span(answers, grade);
  }
  if (any_voided_) settle_voided(grade);
  for (const PartGrade& part : grade.parts) grade.points += part.points;
  return grade;
}

void Grader::grade_sheet(const Answers& answers, Grade& grade) const {
  const auto said = [&](std::size_t i, const std::string& text) {
    return shows_notes(exercise_.feedback) && !text.empty() ? text : grade.parts[i].feedback;
  };
  std::vector<Grade> scenes;
  for (std::size_t s = 0; s < scenes_.size(); ++s) {
    Answers of_scene;
    for (std::size_t i = 0; i < exercise_.parts.size(); ++i) {
      const Question& question = *exercise_.parts[i].question;
      if (question.scene != s || !question.is_value()) continue;
      const std::size_t part = of_scene.part.size();
      of_scene.part.push_back(answers.part[i]);
      for (const auto& [misnamed, name] : answers.misnamed)
        if (misnamed == i) of_scene.misnamed.emplace_back(part, name);
    }
    scenes.push_back(scenes_[s]->grade(std::move(of_scene), {}));
    if (!scenes.back().explanation) continue;
    // What explains one run explains no other.
    const bool only_one = std::ranges::count_if(scenes, [](const Grade& g) { return g.explanation.has_value(); }) == 1;
    grade.explanation = only_one ? scenes.back().explanation : std::nullopt;
  }
  for (std::size_t i = 0; i < grade.parts.size(); ++i) {
    const Part& part = exercise_.parts[i];
    const Question& question = *part.question;
    if (question.is_value()) {
      grade.parts[i] = scenes[question.scene].parts[question.part];
      if (grade.parts[i].verdict == Verdict::correct) grade.parts[i].feedback = said(i, question.praise);
    } else if (answers.part[i] == nullptr) {
      settle(grade, i, Verdict::missing, 0, {}, {});
    } else {
      const LetterMark mark = mark_letters(question, *answers.part[i]);
      const bool is_right = mark.verdict == Verdict::correct;
      const bool is_choice = mark.verdict != Verdict::invalid && mark.choice < question.feedback.size();
      std::string words = is_choice ? question.feedback[mark.choice] : std::string();
      const std::string& in_general = is_right ? question.praise : question.blame;
      if (!in_general.empty()) words += (words.empty() ? "" : " ") + in_general;
      if (mark.verdict == Verdict::invalid)
        settle(grade, i, mark.verdict, 0, mark.problem, {});
      else if (is_right)
        settle(grade, i, mark.verdict, part.points, {}, {});
      else
        settle(grade, i, mark.verdict, 0, words.empty() ? "Not right." : words, "unknown");
      if (is_right) grade.parts[i].feedback = said(i, words);
    }
    grade.points += grade.parts[i].points;
  }
}

void Grader::look_closer(const Answers& answers, Grade& grade) const {
  const std::size_t count = exercise_.parts.size();
  Open open;
  open.typed.resize(count);
  open.is_open.assign(count, 0);
  open.as_meant.resize(count);
  open.as_typed.resize(count);
  bool any_open = false;
  for (std::size_t i = 0; i < count; ++i) {
    const Part& part = exercise_.parts[i];
    PartGrade& made = grade.parts[i];
    if (answers.part[i] == nullptr) {
      const auto misnamed = std::ranges::find(answers.misnamed, i, &std::pair<std::size_t, std::string>::first);
      if (misnamed != answers.misnamed.end())
        settle(grade, i, Verdict::missing, 0,
               "No answer under " + part.name + "; you wrote " + excerpt(misnamed->second) + ".", "letter-case");
      else
        made.feedback = feedback(part, Verdict::missing, {});
      continue;
    }
    const bool right = made.verdict == Verdict::correct;
    if (right && part.tolerance.kind == Tolerance::Kind::exact) {
      open.as_meant[i].kind = open.as_typed[i].kind = Given::Kind::right;
      continue;
    }
    Typed& typed = open.typed[i];
    typed = read_typed(part, *answers.part[i]);
    if (!typed.problem.empty()) {
      made.verdict = Verdict::invalid;
      made.feedback = feedback(part, Verdict::invalid, typed.problem);
      continue;
    }
    if (can_carry_on(part, typed)) {
      open.as_typed[i] = {Given::Kind::typed, to_carry_on(typed)};
      open.as_meant[i] =
          right ? Given{Given::Kind::right} : Given{Given::Kind::typed, to_carry_on(typed), roundings(part, typed)};
      open.rounded = open.rounded || part.tolerance.kind != Tolerance::Kind::exact;
    }
    if (!right) open.is_open[i] = 1;
    any_open = any_open || !right;
  }
  if (any_open) judge(open, grade);
}

void Grader::settle(Grade& grade, std::size_t i, Verdict verdict, Exact points, std::string_view what,
                    std::string_view note) const {
  PartGrade& made = grade.parts[i];
  made.verdict = verdict;
  made.points = std::move(points);
  made.feedback = feedback(exercise_.parts[i], verdict, what);
  made.note = note;
  made.misconception = verdict == Verdict::misconception ? note : std::string_view();
}

void Grader::judge(const Open& open, Grade& grade) const {
  const std::size_t count = exercise_.parts.size();
  Replayed meant(exercise_, plan_);
  meant.run(open.as_meant);
  std::optional<Replayed> written;
  if (open.rounded) written.emplace(exercise_, plan_, Replayed::Rounding::ignored).run(open.as_typed);
  std::vector<char> left = open.is_open;
  settle_carried(open, meant, written ? &*written : nullptr, left, grade);
  settle_rounded(open, meant, left, grade);

  Symptoms symptoms{&open.as_meant, &meant, written ? &*written : nullptr, &open.typed, {}, {}};
  for (std::size_t i = 0; i < count; ++i) {
    const PartGrade& made = grade.parts[i];
    symptoms.fine.push_back(made.verdict == Verdict::correct || made.verdict == Verdict::carried ||
                            made.note == "rounded");
    if (left[i] != 0) symptoms.open.push_back(i);
  }
  if (symptoms.open.empty()) return;
  Explainer::Case by_rule(explainer_, symptoms);
  settle_slips(symptoms, by_rule, grade);
  grade.explanation = by_rule.explain();
  settle_explained(symptoms, by_rule, grade);
  settle_arithmetic(symptoms, grade);
  settle_contradicted(symptoms, by_rule, grade);
}

// The right rule on their own values, as they meant them or as they wrote them down.
void Grader::settle_carried(const Open& open, const Replayed& meant, const Replayed* written, std::vector<char>& left,
                            Grade& grade) const {
  std::vector<char> trivial;
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i] == 0) continue;
    const Part& part = exercise_.parts[i];
    const auto& typed = open.typed[i].numbers;
    const auto carries = [&](const Replayed& own, const std::vector<double>& widening) {
      return own.operands_changed(part.value) && agrees(part, own.expected(part.value), typed, widening);
    };
    if (!carries(meant, meant.widening(part)) && !(written != nullptr && carries(*written, {}))) continue;
    left[i] = 0;
    if (trivial.empty()) trivial = meant.trivial();
    if (trivial[part.value] != 0 && right_is_trivial_[i] == 0)
      settle(grade, i, Verdict::wrong, 0,
             "It follows from your earlier values, but with those (all equal or zero, or a ratio that only copies a "
             "point) there is nothing left to compute, so it earns no points.",
             "trivial");
    else
      settle(grade, i, Verdict::carried, exercise_.carried * part.points, {}, {});
  }
}

// The right rule, in fewer digits than are asked.
void Grader::settle_rounded(const Open& open, const Replayed& meant, std::vector<char>& left, Grade& grade) const {
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i] == 0) continue;
    const Part& part = exercise_.parts[i];
    const bool right = is_rounded(part, exercise_.run.trace.numbers(part.value), open.typed[i]);
    if (!right && !(meant.operands_changed(part.value) && is_rounded(part, meant.expected(part.value), open.typed[i])))
      continue;
    left[i] = 0;
    settle(grade, i, Verdict::wrong, 0,
           (right ? "This is the right value, rounded: give "
                  : "It follows from your earlier values, but is rounded: give ") +
               digits_asked(part.tolerance) + ".",
           "rounded");
  }
}

// Each value for itself: a misconception, a slip, or neither.
void Grader::settle_slips(const Symptoms& symptoms, Explainer::Case& by_rule, Grade& grade) const {
  const Replayed& meant = *symptoms.meant;
  for (std::size_t k = 0; k < symptoms.open.size(); ++k) {
    const std::size_t i = symptoms.open[k];
    const Part& part = exercise_.parts[i];
    const Typed& typed = (*symptoms.typed)[i];
    const Misconception* const alone = by_rule.alone(k);
    std::optional<Slip> slip;
    if (alone == nullptr || by_rule.may_be_slip(k)) {
      slip = find_slip(part, exercise_.run.trace.numbers(part.value), typed);
      if (!slip && meant.operands_changed(part.value)) slip = find_slip(part, meant.expected(part.value), typed);
    }
    if (slip) {
      if (by_rule.may_be_slip(k)) by_rule.is_slip(k);
      const Exact& share = alone == nullptr ? exercise_.slip : std::min(exercise_.slip, exercise_.misconception);
      settle(grade, i, Verdict::slip, share * part.points, slip->text, slip->note);
    } else if (alone != nullptr) {
      settle(grade, i, Verdict::misconception, exercise_.misconception * part.points, advice_of(*alone), alone->id);
    } else {
      settle(grade, i, Verdict::wrong, 0, part.feedback, "unknown");
    }
  }
}

void Grader::settle_explained(const Symptoms& symptoms, Explainer::Case& by_rule, Grade& grade) const {
  for (std::size_t k = 0; k < symptoms.open.size(); ++k) {
    const std::size_t i = symptoms.open[k];
    const PartGrade& made = grade.parts[i];
    const Misconception* const acts = by_rule.acts_at(k);
    if (acts == nullptr || acts->id == made.misconception) continue;
    settle(grade, i, Verdict::misconception, std::min(made.points, exercise_.misconception * exercise_.parts[i].points),
           advice_of(*acts), acts->id);
  }
}

// A wrong value of which one coordinate only is off, or which is the only wrong one while others follow from it: the
// rule was known, and what is to be checked is the arithmetic.
void Grader::settle_arithmetic(const Symptoms& symptoms, Grade& grade) const {
  const bool is_only_one = std::ranges::all_of(grade.parts,
                                               [](const PartGrade& made) {
                                                 return made.verdict == Verdict::correct ||
                                                        made.verdict == Verdict::carried || made.note == "unknown";
                                               }) &&
                           std::ranges::count(grade.parts, "unknown", &PartGrade::note) == 1;
  const bool others_follow = std::ranges::count(grade.parts, Verdict::carried, &PartGrade::verdict) > 0;
  for (const std::size_t i : symptoms.open) {
    if (grade.parts[i].note != "unknown") continue;
    const Part& part = exercise_.parts[i];
    const Typed& typed = (*symptoms.typed)[i];
    auto off = only_wrong_coordinate(part, exercise_.run.trace.numbers(part.value), typed, {});
    if (!off && symptoms.meant->operands_changed(part.value))
      off = only_wrong_coordinate(part, symptoms.meant->expected(part.value), typed, symptoms.meant->widening(part));
    std::string hint = near_miss(part, exercise_.run.trace.numbers(part.value), typed);
    if (hint.empty() && symptoms.meant->operands_changed(part.value))
      hint = near_miss(part, symptoms.meant->expected(part.value), typed);
    if (!hint.empty())
      hint = "Near, but " + hint + ".";
    else if (off)
      hint = "Only " + *off + " is off: check the arithmetic.";
    else if (is_only_one && others_follow && part.kind != ValueKind::integer && part.kind != ValueKind::list)
      hint = "All else is right or follows from it: check the arithmetic.";
    else
      continue;
    const std::string what = part.feedback.empty() ? "Not the right value." : sentence(part.feedback);
    settle(grade, i, Verdict::wrong, 0, what + " " + hint, "arithmetic");
  }
}

// What a misconception gives in one place while it is contradicted in others is not asserted.
void Grader::settle_contradicted(const Symptoms& symptoms, const Explainer::Case& by_rule, Grade& grade) const {
  for (std::size_t k = 0; k < symptoms.open.size(); ++k) {
    const std::size_t i = symptoms.open[k];
    const PartGrade& made = grade.parts[i];
    if (made.verdict != Verdict::misconception || by_rule.acts_at(k) != nullptr) continue;
    const auto& list = exercise_.run.algorithm->misconceptions;
    const auto m = std::ranges::find(list, made.misconception, &Misconception::id);
    if (m == list.end() || !by_rule.is_contradicted(static_cast<std::size_t>(m - list.begin()))) continue;
    settle(grade, i, Verdict::wrong, made.points,
           "Not the right value. One mistake would make it, but not your other values: " + std::string(m->title) + ".",
           "unknown");
  }
}

// Somebody who took the span k + d computes values of which the indices are shifted by d: those at the end that is not
// asked are ignored, those at the other are missing.
void Grader::settle_other_span(const Answers& answers, Grade& grade) const {
  const auto k = exercise_.part("k");
  if (!k || answers.ignored.empty() || grade.parts[*k].note != "wrong-span") return;
  const auto typed = read_typed(exercise_.parts[*k], *answers.part[*k]);
  const double shift = (typed.numbers[0] - exercise_.parts[*k].right[0]).to_double();
  std::unordered_set<std::string> theirs;
  for (const Part& part : exercise_.parts)
    if (auto name = with_last_index_moved(part.name, static_cast<int>(shift))) theirs.insert(std::move(*name));
  if (!std::ranges::all_of(answers.ignored, [&](const std::string* name) { return theirs.contains(*name); })) return;
  const std::string span = "the span k = " + typed.numbers[0].to_string();
  const Misconception* const wrong_span =
      &*std::ranges::find(exercise_.run.algorithm->misconceptions, "wrong-span", &Misconception::id);
  settle(grade, *k, grade.parts[*k].verdict, grade.parts[*k].points,
         advice_of(*wrong_span) + " You computed the triangle of " + span + ".", "wrong-span");
  for (std::size_t i = 0; i < grade.parts.size(); ++i) {
    const Part& part = exercise_.parts[i];
    if (grade.parts[i].verdict == Verdict::missing && part.name.ends_with(']') && !theirs.contains(part.name))
      grade.parts[i].feedback =
          feedback(part, Verdict::missing, "No answer: you computed the triangle of " + span + ", without it.");
  }
}

void Grader::settle_voided(Grade& grade) const {
  for (std::size_t i = 0; i < grade.parts.size(); ++i) {
    const Part& part = exercise_.parts[i];
    if (part.voided == Voided::no) continue;
    const bool credit = part.voided == Voided::credit;
    if (credit) grade.parts[i].points = part.points;
    if (exercise_.feedback == Feedback::none) continue;
    grade.parts[i].feedback = credit ? "This part was voided: everybody whose answers could be read gets its points."
                                     : "This part was voided: it counts for nobody.";
  }
}

std::string Grader::feedback(const Part& part, Verdict verdict, std::string_view what) const {
  if (exercise_.feedback == Feedback::none || exercise_.feedback == Feedback::verdict) return {};
  std::string text;
  switch (verdict) {
    case Verdict::correct:
      return "Correct.";
    case Verdict::carried:
      text = "The right rule on your own earlier value.";
      break;
    case Verdict::misconception:
    case Verdict::slip:
      text = what;
      break;
    case Verdict::wrong:
      text = what.empty() ? "Not the right value." : sentence(what);
      break;
    case Verdict::missing:
      text = what.empty() ? "No answer." : std::string(what);
      break;
    case Verdict::invalid:
      text = "The answer cannot be read: it " + std::string(what) + ".";
      break;
  }
  if (exercise_.feedback == Feedback::full) return text + " Right is " + part.solution + ".";
  // The rule is a help where it is not known yet; not to who already used it.
  if (!part.formula.empty() && (verdict == Verdict::wrong || verdict == Verdict::missing))
    text += (part.in_words ? " It is " : " The rule is ") + part.formula + ".";
  return text;
}

}  // namespace blossom
