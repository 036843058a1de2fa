#include "grader/diagnose.hpp"

#include <algorithm>

namespace blossom {
namespace {

constexpr std::size_t most_candidates = 4;  // of one misconception for one value

// A value with what somebody has for it and for all others. Where their values make one impossible, the right one
// stands.
class OwnSite final : public Site {
 public:
  OwnSite(const Exercise& exercise, const Replayed& replayed) : exercise_(&exercise), replayed_(&replayed) {}
  void go_to(ValueId v) { value_ = v; }

  const Trace<Exact>& trace() const override { return exercise_->run.trace; }
  const Inputs<Exact>& inputs() const override { return exercise_->run.inputs; }
  ValueId value() const override { return value_; }
  NumbersView<Exact> numbers(ValueId v) const override {
    const auto own = replayed_->own(v);
    return own.empty() ? trace().numbers(v) : own;
  }

 private:
  const Exercise* exercise_;
  const Replayed* replayed_;
  ValueId value_ = absent;
};

// Replays with one misconception, once for each of its candidates, and calls seen(part, traced) with all that it makes
// of the parts.
template <class Seen>
void with_misconception(const Exercise& exercise, const Misconception& misconception, Replayed& replayed,
                        const std::vector<Given>& given, Seen&& seen) {
  OwnSite site(exercise, replayed);
  const auto candidates_at = [&](ValueId v) {
    site.go_to(v);
    return misconception.wrong(site);
  };
  std::size_t most = 1;
  for (std::size_t choice = 0; choice < most; ++choice) {
    replayed.run(given, [&](ValueId v) {
      auto candidates = candidates_at(v);
      if (candidates.empty()) return Numbers<Exact>();
      most = std::max(most, std::min(candidates.size(), most_candidates));
      return std::move(candidates[std::min(choice, candidates.size() - 1)]);
    });
    for (std::size_t i = 0; i < exercise.parts.size(); ++i) {
      const ValueId v = exercise.parts[i].value;
      for (const auto& candidate : candidates_at(v)) seen(i, NumbersView<Exact>(candidate));
      seen(i, replayed.expected(v));
    }
  }
}

}  // namespace

KnownMistakes::KnownMistakes(const Exercise& exercise, const ReplayPlan& plan)
    : exercise_(&exercise), of_part_(exercise.parts.size()) {
  Replayed replayed(exercise, plan);
  const std::vector<Given> nothing(exercise.parts.size());
  const std::vector<Given> right(exercise.parts.size(), Given{Given::Kind::right});
  for (const Misconception& misconception : exercise.run.algorithm->misconceptions) {
    const auto note = [&](std::size_t i, NumbersView<Exact> traced) {
      const Part& part = exercise.parts[i];
      auto typed = part.as_typed(traced);
      if (part.as_set) std::ranges::sort(typed);
      if (typed.empty() || typed == part.right) return;
      auto& known = of_part_[i];
      if (std::ranges::none_of(known, [&](const Mistake& m) { return m.typed == typed; }))
        known.push_back({&misconception, std::move(typed)});
    };
    with_misconception(exercise, misconception, replayed, right, note);
    with_misconception(exercise, misconception, replayed, nothing, note);
  }
}

const Misconception* KnownMistakes::find(std::size_t part, const Numbers<Exact>& typed) const {
  const Part& asked = exercise_->parts[part];
  for (const Mistake& mistake : of_part_[part]) {
    if (mistake.typed.size() != typed.size()) continue;
    bool same = true;
    for (std::size_t i = 0; same && i < typed.size(); ++i) same = within(asked.tolerance, mistake.typed[i], typed[i]);
    if (same) return mistake.misconception;
  }
  return nullptr;
}

std::vector<const Misconception*> OwnMistakes::find(const std::vector<Given>& given,
                                                    const std::vector<Numbers<Exact>>& typed) const {
  std::vector<const Misconception*> found(typed.size(), nullptr);
  Replayed replayed(*exercise_, *plan_);
  for (const Misconception& misconception : exercise_->run.algorithm->misconceptions)
    with_misconception(*exercise_, misconception, replayed, given, [&](std::size_t i, NumbersView<Exact> traced) {
      if (found[i] == nullptr && !typed[i].empty() && agrees(exercise_->parts[i], traced, typed[i]))
        found[i] = &misconception;
    });
  return found;
}

std::optional<std::string> find_slip(const Part& part, NumbersView<Exact> expected, const Typed& typed) {
  constexpr std::string_view coordinate[] = {"x", "y", "z"};
  const std::size_t count = typed.numbers.size();
  auto right = part.as_typed(expected);
  if (right.size() != count) return std::nullopt;
  if (part.as_set) std::ranges::sort(right);
  const auto is = [&](const Numbers<Exact>& numbers) {
    return std::ranges::equal(numbers, right,
                              [&](const Exact& t, const Exact& v) { return within(part.tolerance, v, t); });
  };
  const auto place = [&](std::size_t i) -> std::string {
    if (count == 1) return "the number";
    if (part.kind == ValueKind::list) return "number " + std::to_string(i + 1);
    return i < static_cast<std::size_t>(part.dimension) ? std::string(coordinate[i]) : "the weight";
  };
  Numbers<Exact> changed = typed.numbers;
  for (std::size_t i = 0; i < count; ++i) {
    changed[i] = -changed[i];
    if (is(changed)) return "The sign of " + place(i) + " is wrong.";
    changed[i] = typed.numbers[i];
  }
  if (count > 1) {
    for (Exact& x : changed) x = -x;
    if (is(changed)) return "All signs are wrong.";
    changed = typed.numbers;
  }
  const bool is_point = part.kind == ValueKind::point || part.kind == ValueKind::vector;
  for (std::size_t i = 0; is_point && i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j) {
      std::swap(changed[i], changed[j]);
      if (is(changed)) return "Two numbers are exchanged: " + place(i) + " and " + place(j) + ".";
      std::swap(changed[i], changed[j]);
    }
  for (std::size_t i = 0; i < count; ++i) {
    std::string text(typed.texts[i]);
    for (std::size_t c = 1; c < text.size() && text.size() <= 32; ++c) {
      const auto is_digit = [&](std::size_t at) { return '0' <= text[at] && text[at] <= '9'; };
      if (!is_digit(c - 1) || !is_digit(c) || text[c] == text[c - 1]) continue;
      std::swap(text[c - 1], text[c]);
      // The digits before they were transposed are those of the right number, as far as they go.
      auto number = parse_typed(text);
      if (number && abs(*number - right[i]) <= Exact(last_place(text) / 2)) {
        changed[i] = std::move(*number);
        if (is(changed)) return "Two digits are transposed in " + place(i) + ".";
        changed[i] = typed.numbers[i];
      }
      std::swap(text[c - 1], text[c]);
    }
  }
  return std::nullopt;
}

}  // namespace blossom
