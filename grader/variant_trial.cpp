#include "grader/variant_trial.hpp"

#include <algorithm>

#include "algorithms/narrate.hpp"
#include "base/json_write.hpp"
#include "grader/diagnose.hpp"

namespace blossom {
namespace {

// Whether these numbers would be accepted as the part's answer.
bool accepted(const Part& part, NumbersView<Exact> typed) {
  return std::ranges::equal(part.right, typed,
                            [&](const Exact& right, const Exact& x) { return within(part.tolerance, right, x); });
}

Numbers<Exact> typed_as(const Part& part, NumbersView<Exact> traced) {
  auto typed = part.as_typed(traced);
  if (part.as_set) std::ranges::sort(typed);
  return typed;
}

Trivial trivial_in(const Exercise& exercise, const Part& part) {
  Trivial trivial;
  if (part.kind == ValueKind::integer) return trivial;
  const auto& trace = exercise.run.trace;
  const auto is = [&](int n, std::size_t count) {
    return std::all_of(part.right.begin(), part.right.begin() + static_cast<std::ptrdiff_t>(count),
                       [&](const Exact& x) { return within(part.tolerance, x, Exact(n)); });
  };
  // A weight does not make a point at the origin another point.
  const bool is_point = !part.is_single() && part.kind != ValueKind::list;
  if (is_point || part.is_single()) trivial.zero = is(0, is_point ? static_cast<std::size_t>(part.dimension) : 1);
  if (part.kind == ValueKind::scalar) trivial.zero = trivial.zero || is(1, 1);
  const auto is_copy = [&](ValueId v) {
    return trace.value(v).kind == part.kind && accepted(part, typed_as(part, trace.numbers(v)));
  };
  for (ValueId v = 0; v < trace.value_count() && !trivial.input; ++v) trivial.input = trace.is_input(v) && is_copy(v);
  trivial.operand = std::ranges::any_of(trace.operands(part.value), is_copy);
  return trivial;
}

// The digits that all exact numbers of a part take as fractions, and their largest denominator.
struct Writing {
  std::size_t digits = 0;
  Exact denominator = 1;
};
Writing writing_of(const Part& part) {
  Writing writing;
  for (const Exact& x : part.right) {
    if (x.is_approximate()) continue;
    const std::string text = x.to_string();
    writing.digits +=
        static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return '0' <= c && c <= '9'; }));
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos) continue;
    // No denominator of more digits is allowed (see read_vary), so its size does not matter.
    const auto denominator = text.size() - slash > 19 ? Exact::parse("1e18") : Exact::parse(text.substr(slash + 1));
    writing.denominator = std::max(writing.denominator, *denominator);
  }
  return writing;
}

// Where two runs differ in steps, names, rules or operands; empty if nowhere.
std::string difference(const TraceGraph& model, const TraceGraph& other) {
  const std::uint32_t count = std::min(model.value_count(), other.value_count());
  for (ValueId v = 0; v < count; ++v) {
    const ValueRecord &a = model.value(v), &b = other.value(v);
    if (!(a.name == b.name) || a.rule != b.rule || a.step != b.step || a.kind != b.kind ||
        !std::ranges::equal(model.operands(v), other.operands(v)))
      return a.name == b.name ? other.name(v) + " is made in another way" : other.name(v) + " for " + model.name(v);
  }
  if (model.value_count() == other.value_count() && model.step_count() == other.step_count()) return "";
  return std::to_string(other.step_count()) + " steps for " + std::to_string(model.step_count());
}

std::optional<Exact> number_of(const Json& json) {
  if (json.kind != Json::Kind::number && json.kind != Json::Kind::string) return std::nullopt;
  return Exact::parse(json.text);
}

// The control points of a curve as far as they are points at all: what is none, its reader refuses.
std::vector<PlainPoint> points_in(const Json& curve) {
  std::vector<PlainPoint> points;
  const Json* list = curve.find("points");
  if (list == nullptr) return points;
  for (const Json& item : list->items) {
    PlainPoint& point = points.emplace_back();
    for (std::size_t c = 0; c < std::min<std::size_t>(item.items.size(), 3); ++c)
      point[c] = number_of(item.items[c]).value_or(Exact(0));
  }
  return points;
}

bool is_knot(const Json& curve, const Exact& u) {
  const Json* knots = curve.find("knots");
  if (knots == nullptr) return u == Exact(0) || u == Exact(1);
  return std::ranges::any_of(knots->items, [&](const Json& knot) { return number_of(knot) == u; });
}

// The file without "vary".
Json without_vary(const Json& root) {
  Json json = root;
  const auto at = std::ranges::find(json.keys, "vary") - json.keys.begin();
  json.keys.erase(json.keys.begin() + at);
  json.items.erase(json.items.begin() + at);
  return json;
}

}  // namespace

VariantMaker::Prepared::Prepared(const JsonDocument& exercise)
    : document(exercise),
      inputs(*exercise.root().find("inputs")),
      model(*read_exercise(exercise)),
      plan(model),
      plain(without_vary(exercise.root())) {
  Diagnostics none_expected;
  const Cursor root(document, none_expected);
  vary = read_vary(*root.optional("vary"), *root.optional("inputs"), model);
  Exact largest = 100;
  for (Part& part : model.parts) {
    if (vary.tolerance && part.kind != ValueKind::integer) part.tolerance = *vary.tolerance;
    const auto writing = writing_of(part);
    digits += writing.digits;
    largest = std::max(largest, writing.denominator);
    trivial.push_back(trivial_in(model, part));
  }
  most_denominator = vary.denominator.value_or(largest);
}

std::string VariantMaker::Prepared::text(const Json& drawn) const {
  Json json = plain;
  json.items[static_cast<std::size_t>(std::ranges::find(json.keys, "inputs") - json.keys.begin())] = drawn;
  return write_json(json) + "\n";
}

void draw(const Vary& vary, VariantStream& stream, Json& inputs) {
  for (const Slot& slot : vary.slots) {
    const Choices& choices = vary.choices[slot.choices];
    at_path(inputs, slot.path) = choices.value(stream.below(choices.count));
  }
}

Trial::Trial(const VariantMaker::Prepared& prepared, const Json& inputs) : prepared_(&prepared), inputs_(&inputs) {}

bool Trial::acceptable(const Unmet& unmet) {
  return comes_to_values(unmet) && check_values(unmet) && check_misconceptions(unmet) && check_whole(unmet);
}

bool Trial::check_inputs(const Unmet& unmet) {
  const Vary& vary = prepared_->vary;
  for (const JsonPath& path : vary.no_knots) {
    const auto u = number_of(at_path(*inputs_, path));
    if (!u || !is_knot(at_path(*inputs_, vary.knots_of), *u)) continue;
    if (!unmet({Demand::Kind::no_knot}, [&] { return u->to_string() + " is a knot"; })) return false;
  }
  for (const JsonPath& path : vary.points_of) {
    if (vary.require.empty()) break;
    const auto points = points_in(at_path(*inputs_, path));
    for (std::size_t i = 0; i < vary.require.size(); ++i)
      if (!vary.require[i]->met(points) &&
          !unmet({Demand::Kind::requirement, i}, [&] { return json_quote(vary.require[i]->words) + " is not met"; }))
        return false;
  }
  return true;
}

bool Trial::run(const Unmet& unmet) {
  const Algorithm& algorithm = *prepared_->model.run.algorithm;
  const auto refuse = [&](const Diagnostics& why) {
    unmet({Demand::Kind::inputs}, [&] {
      return "the algorithm does not take the inputs: " +
             (why.empty() ? std::string() : (why[0].path.empty() ? "" : why[0].path + " ") + why[0].message);
    });
    return false;
  };
  const auto document = JsonDocument::parse("inputs", write_json(*inputs_));
  if (!document) return refuse(document.diagnostics);
  Diagnostics diagnostics;
  const auto inputs = read_inputs(algorithm, Cursor(*document, diagnostics));
  if (!inputs) return refuse(diagnostics);
  auto made = record<Exact>(algorithm, *inputs);
  if (!made) return refuse(made.diagnostics);
  if (const auto other = difference(prepared_->model.run.trace, made->trace);
      !other.empty() || made->trace.rational != prepared_->model.run.trace.rational ||
      made->trace.dimension != prepared_->model.run.trace.dimension) {
    unmet({Demand::Kind::same_steps}, [&] {
      return "the run has not the model's steps and values: " + (other.empty() ? "another kind of curve" : other);
    });
    return false;
  }
  Exercise& exercise = exercise_.emplace();
  exercise.run = std::move(*made);
  exercise.tolerance = prepared_->model.tolerance;
  exercise.parts = prepared_->model.parts;
  for (Part& part : exercise.parts) {
    part.right = typed_as(part, exercise.run.trace.numbers(part.value));
    if (!part.right.empty()) continue;
    exercise_.reset();
    return refuse({{"", 0, 0, part.name, "lies at infinity"}});
  }
  return true;
}

bool Trial::check_values(const Unmet& unmet) {
  std::size_t digits = 0;
  for (std::size_t i = 0; i < exercise_->parts.size(); ++i) {
    const Part& part = exercise_->parts[i];
    const auto trivial = trivial_in(*exercise_, part);
    const Trivial& allowed = prepared_->trivial[i];
    const auto says = [&](const char* what) { return [&part, what] { return part.name + what; }; };
    if (trivial.zero && !allowed.zero &&
        !unmet({Demand::Kind::not_zero, 0, i}, says(part.kind == ValueKind::scalar ? " is 0 or 1" : " is 0")))
      return false;
    if (trivial.input && !allowed.input && !unmet({Demand::Kind::no_input, 0, i}, says(" is one of the inputs")))
      return false;
    if (trivial.operand && !allowed.operand &&
        !unmet({Demand::Kind::no_operand, 0, i}, says(" is what it is made from")))
      return false;
    const auto writing = writing_of(part);
    digits += writing.digits;
    if (prepared_->most_denominator < writing.denominator && !unmet({Demand::Kind::denominators, 0, i}, [&] {
          return part.name + " has the denominator " + format_brief(writing.denominator) + ", more than " +
                 format_brief(prepared_->most_denominator);
        }))
      return false;
  }
  const Exact here(static_cast<std::int64_t>(digits)), there(static_cast<std::int64_t>(prepared_->digits));
  const Exact& likeness = prepared_->vary.likeness;
  return (here <= likeness * there && there <= likeness * here) || unmet({Demand::Kind::likeness}, [&] {
           return "all asked values have " + std::to_string(digits) + " digits, and " +
                  std::to_string(prepared_->digits) + " in the model, which is not alike within " +
                  format_brief(likeness);
         });
}

bool Trial::check_misconceptions(const Unmet& unmet) {
  const auto& misconceptions = exercise_->run.algorithm->misconceptions;
  const auto& parts = exercise_->parts;
  const auto& trace = exercise_->run.trace;
  Replayed replayed(*exercise_, prepared_->plan);
  const Replayed right(*exercise_, prepared_->plan);
  OwnSite own(*exercise_, replayed), locally(*exercise_, right);
  const std::vector<Given> nothing(parts.size());
  for (std::size_t m = 0; m < misconceptions.size(); ++m) {
    // Only here, with everything before it right.
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (const auto& wrong : locally.candidates(misconceptions[m], parts[i].value))
        if (!look(unmet, m, i, wrong)) return false;
    // Throughout.
    std::size_t most = 1;
    for (std::size_t choice = 0; choice < most; ++choice) {
      std::vector<char> touched(trace.value_count(), 0);
      replayed.run(nothing, [&](ValueId v) {
        auto wrong = own.candidates(misconceptions[m], v);
        touched[v] = !wrong.empty() || std::ranges::any_of(trace.operands(v), [&](ValueId o) { return touched[o]; });
        if (wrong.empty()) return Numbers<Exact>();
        most = std::max(most, std::min(wrong.size(), most_candidates));
        return std::move(wrong[std::min(choice, wrong.size() - 1)]);
      });
      for (std::size_t i = 0; i < parts.size(); ++i)
        if (touched[parts[i].value] != 0 && !look(unmet, m, i, replayed.own(parts[i].value))) return false;
    }
  }
  return true;
}

// What a misconception makes of a part must not be accepted there.
bool Trial::look(const Unmet& unmet, std::size_t misconception, std::size_t i, NumbersView<Exact> traced) {
  const Part& part = exercise_->parts[i];
  if (prepared_->vary.except[misconception][i] != 0) return true;
  const auto typed = typed_as(part, traced);
  if (typed.empty() || !accepted(part, typed)) return true;
  return unmet({Demand::Kind::misconception, misconception, i}, [&] {
    const Narrator<Exact> narrator(exercise_->run);
    std::string wrong;
    for (const Exact& x : typed) wrong += (wrong.empty() ? "" : ", ") + x.to_string();
    if (!part.is_single()) wrong = "(" + wrong + ")";
    return part.name + " = " + narrator.formula(part.value) + " = " + narrator.numbers(part.value) + " = " +
           narrator.value_text(part.value) + ", and " +
           std::string(exercise_->run.algorithm->misconceptions[misconception].id) + " makes " + wrong + " of it";
  });
}

bool Trial::check_whole(const Unmet& unmet) {
  auto document = JsonDocument::parse(prepared_->document.name(), prepared_->text(*inputs_));
  Diagnostics why = document.diagnostics;
  if (document) {
    why = read_exercise(*document).diagnostics;
    document_ = std::move(*document);
  }
  return why.empty() || unmet({Demand::Kind::exercise}, [&] {
           return "the exercise is in order no longer: " + why[0].path + " " + why[0].message;
         });
}

}  // namespace blossom
