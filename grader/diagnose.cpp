#include "grader/diagnose.hpp"

#include <cmath>
#include <cstdlib>
#include <numeric>

namespace blossom {
namespace {

constexpr double least_chance = 1.0 / (1 << 20);
constexpr double chance_of_integer = 0.25;

// Infinite of an irrational number.
double denominator(const Exact& x) {
  if (x.is_approximate()) return HUGE_VAL;
  if (x.is_integer()) return 1;
  const std::string text = x.to_string();
  return std::strtod(text.c_str() + text.find('/') + 1, nullptr);
}

// Of a decimal as typed: 3 of "-0.0250".
int significant_digits(std::string_view typed) {
  int count = 0;
  for (const char c : typed.substr(0, typed.find_first_of("eE")))
    count += '0' <= c && c <= '9' && (count > 0 || c != '0') ? 1 : 0;
  return count;
}

std::string coordinate_name(const Part& part, std::size_t i) {
  constexpr std::string_view coordinate[] = {"x", "y", "z"};
  return i < static_cast<std::size_t>(part.dimension) ? std::string(coordinate[i]) : "the weight";
}

}  // namespace

// ---- guessing -------------------------------------------------------------------------------------------------------

std::pair<ValueKind, Form> Guessing::kind_of(const Part& part) { return {part.kind, part.form}; }

Guessing::Guessing(const Exercise& exercise) {
  const auto& trace = exercise.run.trace;
  for (const Part& part : exercise.parts) {
    auto& spans = spans_[kind_of(part)];
    if (!spans.empty() || part.kind == ValueKind::integer) continue;
    const bool is_point = part.kind == ValueKind::point || part.kind == ValueKind::vector;
    std::vector<double> low, high;
    for (ValueId v = 0; v < trace.value_count(); ++v) {
      // A point is made of those that are given; a ratio is no knot.
      if (trace.value(v).kind != part.kind || (!is_point && trace.is_input(v))) continue;
      const auto typed = part.as_typed(trace.numbers(v));
      for (std::size_t i = 0; i < typed.size(); ++i) {
        const double x = typed[i].to_double();
        const std::size_t at = is_point ? i : 0;
        if (low.size() <= at) {
          low.push_back(is_point ? x : std::min(x, 0.0));
          high.push_back(is_point ? x : std::max(x, 0.0));
        }
        low[at] = std::min(low[at], x);
        high[at] = std::max(high[at], x);
      }
    }
    for (std::size_t i = 0; i < low.size(); ++i) spans.push_back(high[i] - low[i]);
  }
}

double Guessing::chance(const Part& part, const Numbers<Exact>& typed) const {
  if (part.kind == ValueKind::integer) return chance_of_integer;
  const auto& spans = spans_.at(kind_of(part));
  double chance = 1;
  for (std::size_t i = 0; i < typed.size() && !spans.empty(); ++i) {
    const double span = spans[std::min(i, spans.size() - 1)];
    if (!(span > 0)) continue;  // all have the same here: it says nothing
    const double d = denominator(typed[i]);
    const double as_window = 2 * slack(part.tolerance, typed[i]).to_double() / span;
    const double as_fraction = 1 / (1 + span * (0.3 * d * d + 0.7 * d));
    chance *= std::min(1.0, std::max(as_window, as_fraction));
  }
  return std::max(chance, least_chance);
}

// ---- predictions ----------------------------------------------------------------------------------------------------

struct MistakenValues::Singles {
  explicit Singles(const Exercise& exercise) : guessing(exercise), of_part(exercise.parts.size()) {}
  Guessing guessing;
  std::vector<std::vector<MistakenValue>> of_part;
  std::vector<Held> act_on;     // by value
  std::vector<Held> differ_at;  // by part
};

MistakenValues::MistakenValues(const Exercise& exercise, const ReplayPlan& plan) : exercise_(&exercise), plan_(&plan) {}
MistakenValues::~MistakenValues() = default;

const MistakenValues::Singles& MistakenValues::singles() const {
  std::call_once(singles_made_, [this] {
    const auto& list = exercise_->run.algorithm->misconceptions;
    singles_ = std::make_unique<Singles>(*exercise_);
    singles_->act_on.assign(exercise_->run.trace.value_count(), 0);
    singles_->differ_at.assign(exercise_->parts.size(), 0);
    Replayed right(*exercise_, *plan_);
    right.run(std::vector<Given>(exercise_->parts.size(), Given{Given::Kind::right}));
    OwnSite site(*exercise_, right);
    for (std::size_t m = 0; m < list.size() && m < most_misconceptions; ++m) {
      predict(held(m), {&list[m]}, singles_->of_part);
      for (const ValueId v : plan_->order) {
        const auto candidates = site.candidates(list[m], v);
        if (candidates.empty()) continue;
        singles_->act_on[v] |= held(m);
        if (plan_->part_of[v] == ReplayPlan::not_asked) continue;
        const auto i = static_cast<std::size_t>(plan_->part_of[v]);
        const Part& part = exercise_->parts[i];
        if (std::ranges::none_of(candidates, [&](const auto& c) { return agrees(part, c, part.right); }))
          singles_->differ_at[i] |= held(m);
      }
    }
  });
  return *singles_;
}

const std::vector<std::vector<MistakenValue>>& MistakenValues::of_singles() const { return singles().of_part; }
const std::vector<Held>& MistakenValues::act_on() const { return singles().act_on; }
const std::vector<Held>& MistakenValues::differ_at() const { return singles().differ_at; }
const Guessing& MistakenValues::guessing() const { return singles().guessing; }

const std::vector<std::vector<MistakenValue>>& MistakenValues::of_pairs() const {
  const Singles& alone = singles();
  std::call_once(pairs_made_, [&] {
    const auto& list = exercise_->run.algorithm->misconceptions;
    pairs_.resize(exercise_->parts.size());
    Held somewhere = 0;
    for (const Held h : alone.act_on) somewhere |= h;
    for (std::size_t a = 0; a < list.size() && a < most_misconceptions; ++a)
      for (std::size_t b = a + 1; b < list.size() && b < most_misconceptions; ++b)
        if ((somewhere & held(a)) != 0 && (somewhere & held(b)) != 0) {
          predict(held(a) | held(b), {&list[a], &list[b]}, pairs_);
        }
  });
  return pairs_;
}

void MistakenValues::predict(Held who, const std::vector<const Misconception*>& misconceptions,
                             std::vector<std::vector<MistakenValue>>& of_part) const {
  const std::size_t count = exercise_->parts.size();
  Replayed replayed(*exercise_, *plan_);
  const auto note = [&](std::size_t i, NumbersView<Exact> traced) {
    const Part& part = exercise_->parts[i];
    auto typed = part.as_typed(traced);
    if (part.as_set) std::ranges::sort(typed);
    if (typed.empty() || typed == part.right) return;
    const auto is_known = [&](const std::vector<MistakenValue>& known) {
      return std::ranges::any_of(known,
                                 [&](const MistakenValue& p) { return (p.held & ~who) == 0 && p.typed == typed; });
    };
    if (is_known(of_part[i]) || is_known(singles_->of_part[i])) return;
    MistakenValue& made = of_part[i].emplace_back();
    made.held = who;
    made.first = window(part.tolerance, typed[0]);
    made.chance = singles_->guessing.chance(part, typed);
    made.typed = std::move(typed);
  };
  std::vector<std::size_t> all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  replay_with(*exercise_, misconceptions, replayed, std::vector<Given>(count, Given{Given::Kind::right}), all, note);
  replay_with(*exercise_, misconceptions, replayed, std::vector<Given>(count), all, note);
}

bool agrees(const Part& part, const MistakenValue& prediction, const Numbers<Exact>& typed, double first_typed) {
  if (prediction.typed.size() != typed.size() || first_typed < prediction.first.low_double ||
      prediction.first.high_double < first_typed)
    return false;
  for (std::size_t i = 0; i < typed.size(); ++i)
    if (!within(part.tolerance, prediction.typed[i], typed[i])) return false;
  return true;
}

// ---- slips ----------------------------------------------------------------------------------------------------------

std::optional<Slip> find_slip(const Part& part, NumbersView<Exact> expected, const Typed& typed) {
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
    return coordinate_name(part, i);
  };
  Numbers<Exact> changed = typed.numbers;
  for (std::size_t i = 0; i < count; ++i) {
    changed[i] = -changed[i];
    if (is(changed)) return Slip{"sign", "The sign of " + place(i) + " is wrong."};
    changed[i] = typed.numbers[i];
  }
  if (count > 1) {
    for (Exact& x : changed) x = -x;
    if (is(changed)) return Slip{"all-signs", "All signs are wrong."};
    changed = typed.numbers;
  }
  const bool is_point = part.kind == ValueKind::point || part.kind == ValueKind::vector;
  for (std::size_t i = 0; is_point && i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j) {
      std::swap(changed[i], changed[j]);
      if (is(changed)) return Slip{"coordinates", "Two numbers are exchanged: " + place(i) + " and " + place(j) + "."};
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
        if (is(changed)) return Slip{"digits", "Two digits are transposed in " + place(i) + "."};
        changed[i] = typed.numbers[i];
      }
      std::swap(text[c - 1], text[c]);
    }
  }
  return std::nullopt;
}

bool is_rounded(const Part& part, NumbersView<Exact> expected, const Typed& typed) {
  auto right = part.as_typed(expected);
  if (part.kind == ValueKind::integer || right.empty() || right.size() != typed.numbers.size()) return false;
  if (part.as_set) std::ranges::sort(right);
  bool any = false;
  for (std::size_t i = 0; i < right.size(); ++i) {
    const Exact& number = typed.numbers[i];
    if (within(part.tolerance, right[i], number)) continue;
    const std::string_view text = typed.texts[i];
    if (text.find('.') == std::string_view::npos || significant_digits(text) < 2) return false;
    const double place = last_place(text), off = std::abs((right[i] - number).to_double());
    const bool cut_off = off < place && abs(number) < abs(right[i]);
    if (off > place / 2 * (1 + 1e-12) && !cut_off) return false;
    any = true;
  }
  return any;
}

std::optional<std::string> only_wrong_coordinate(const Part& part, NumbersView<Exact> expected, const Typed& typed,
                                                 const std::vector<double>& widening) {
  const bool is_point = part.kind == ValueKind::point || part.kind == ValueKind::vector;
  const auto right = part.as_typed(expected);
  if (!is_point || right.size() < 2 || right.size() != typed.numbers.size()) return std::nullopt;
  std::optional<std::size_t> wrong;
  for (std::size_t i = 0; i < right.size(); ++i) {
    if (within(part.tolerance, right[i], typed.numbers[i], i < widening.size() ? widening[i] : 0)) continue;
    if (wrong) return std::nullopt;
    wrong = i;
  }
  return wrong ? std::optional(coordinate_name(part, *wrong)) : std::nullopt;
}

}  // namespace blossom
