#include "grader/explain.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <tuple>

namespace blossom {
namespace {

constexpr double most_by_chance = 1.0 / 40;

// A little more than how far a typed number may be from v, to leave out the exact comparison where it must fail.
double slack_at_most(const Tolerance& tolerance, double v) {
  const double size = std::abs(v);
  double allowed = 1e-9 * std::max(1.0, size);
  switch (tolerance.kind) {
    case Tolerance::Kind::exact:
      break;
    case Tolerance::Kind::decimals:
      allowed += 0.5 * std::pow(10.0, -tolerance.digits);
      break;
    case Tolerance::Kind::significant:
      allowed += 0.5 * std::pow(10.0, 1 - tolerance.digits) * size;
      break;
    case Tolerance::Kind::absolute:
      allowed += tolerance.amount.to_double();
      break;
    case Tolerance::Kind::relative:
      allowed += tolerance.amount.to_double() * size;
      break;
  }
  return allowed * 1.001;
}

// The chance that independent hits tell at least as many bits as those that happened do.
class Bits {
 public:
  void add(double chance, bool happened) {
    chance = std::min(chance, 1.0);
    const auto bits = static_cast<std::size_t>(std::min<double>(most, std::floor(-2 * std::log2(chance))));
    if (happened) told_ = std::min(most, told_ + bits);
    if (bits == 0) return;
    for (std::size_t t = most + 1; t-- > 0;) {
      const double moved = chance_of_[t] * chance;
      chance_of_[t] -= moved;
      chance_of_[std::min(most, t + bits)] += moved;
    }
  }
  double chance_of_as_many() const {
    return std::accumulate(chance_of_.begin() + static_cast<std::ptrdiff_t>(told_), chance_of_.end(), 0.0);
  }

 private:
  static constexpr std::size_t most = 80;  // half bits
  std::array<double, most + 1> chance_of_{1};
  std::size_t told_ = 0;
};

template <class Apply>
void for_each_of(Held set, Apply&& apply) {
  for (; set != 0; set &= set - 1) apply(static_cast<std::size_t>(std::countr_zero(set)));
}

}  // namespace

Explainer::Explainer(const Exercise& exercise, const ReplayPlan& plan)
    : exercise_(&exercise), plan_(&plan), predictions_(exercise, plan) {}

Explainer::Case::Case(const Explainer& explainer, const Symptoms& symptoms)
    : predictions_(&explainer.predictions_),
      exercise_(explainer.exercise_),
      plan_(explainer.plan_),
      symptoms_(&symptoms),
      size_(symptoms.open.size()),
      count_(std::min(exercise_->run.algorithm->misconceptions.size(), most_misconceptions)),
      fits_(size_ * count_) {
  for (std::size_t k = 0; k < size_; ++k) first_typed_.push_back(typed(k).empty() ? 0 : typed(k)[0].to_double());
  compare_with_known();
  find_what_is_hidden();
  compare_with_own();
}

// ---- fits -----------------------------------------------------------------------------------------------------------

void Explainer::Case::compare_with_known() {
  const auto& known = predictions_->of_singles();
  for (std::size_t k = 0; k < size_; ++k)
    for (const MistakenValue& prediction : known[symptoms_->open[k]]) {
      if (!agrees(part(k), prediction, typed(k), first_typed_[k])) continue;
      Fit& made = fit(static_cast<std::size_t>(std::countr_zero(prediction.held)), k);
      made.known = made.covered = true;
    }
}

void Explainer::Case::find_what_is_hidden() {
  const auto& trace = exercise_->run.trace;
  const auto& act_on = predictions_->act_on();
  std::vector<Held> before(trace.value_count(), 0);
  const auto before_of = [&](ValueId v) {
    Held held = 0;
    for (const ValueId o : trace.operands(v)) held |= before[o];
    return held;
  };
  bool any_missing = false;
  for (const ValueId v : plan_->order) {
    const std::int32_t i = plan_->part_of[v];
    const bool asked = i != ReplayPlan::not_asked;
    if (asked && (*symptoms_->given)[static_cast<std::size_t>(i)].kind != Given::Kind::nothing) continue;
    any_missing = any_missing || asked;
    before[v] = before_of(v) | act_on[v];
  }
  const Replayed* const written = symptoms_->written;
  for (std::size_t k = 0; k < size_; ++k) {
    const ValueId v = part(k).value;
    const bool changed = symptoms_->meant->operands_changed(v) || (written != nullptr && written->operands_changed(v));
    hidden_.push_back(before_of(v));
    on_own_.push_back(changed || (any_missing && hidden_.back() != 0));
    // A wrong rule spreads rounding about as the right one does.
    auto& wide = widening_.emplace_back(changed ? symptoms_->meant->widening(part(k)) : std::vector<double>());
    for (double& w : wide) w *= 2;
  }
}

void Explainer::Case::compare_with_own() {
  const auto& list = exercise_->run.algorithm->misconceptions;
  std::vector<std::size_t> k_of(exercise_->parts.size());
  for (std::size_t k = 0; k < size_; ++k) k_of[symptoms_->open[k]] = k;
  for (std::size_t m = 0; m < count_; ++m) {
    // On values nobody answered it acts in a replay of its own.
    std::vector<std::size_t> behind_hidden;
    for (std::size_t k = 0; k < size_; ++k)
      if (on_own_[k] != 0 && (hidden_[k] & held(m)) != 0) behind_hidden.push_back(symptoms_->open[k]);
    if (!behind_hidden.empty()) {
      if (!scratch_) scratch_.emplace(*exercise_, *plan_, Replayed::Rounding::ignored);
      replay_with(*exercise_, {&list[m]}, *scratch_, *symptoms_->given, behind_hidden,
                  [&](std::size_t i, NumbersView<Exact> traced) { compare_with_own(m, k_of[i], traced, true); });
    }
    for (const Replayed* replayed : {symptoms_->meant, symptoms_->written}) {
      if (replayed == nullptr) continue;
      OwnSite site(*exercise_, *replayed);
      for (std::size_t k = 0; k < size_; ++k) {
        const ValueId v = part(k).value;
        if ((hidden_[k] & held(m)) != 0 || fit(m, k).covered || !replayed->operands_changed(v)) continue;
        if ((predictions_->act_on()[v] & held(m)) == 0) continue;
        for (const auto& candidate : site.candidates(list[m], v))
          compare_with_own(m, k, candidate, replayed == symptoms_->meant);
      }
    }
  }
}

bool Explainer::Case::is_near(std::size_t k, const Numbers<Exact>& predicted) const {
  const auto& answer = typed(k);
  const auto& wide = widening_[k];
  if (predicted.empty() || predicted.size() != answer.size()) return false;
  const double first = predicted[0].to_double();
  if (std::abs(first - first_typed_[k]) > slack_at_most(part(k).tolerance, first) + (wide.empty() ? 0 : wide[0]))
    return false;
  for (std::size_t i = 0; i < predicted.size(); ++i)
    if (!within(part(k).tolerance, predicted[i], answer[i], i < wide.size() ? wide[i] : 0)) return false;
  return true;
}

void Explainer::Case::compare_with_own(std::size_t m, std::size_t k, NumbersView<Exact> traced, bool strictly) {
  Fit& made = fit(m, k);
  if (made.tries < 255) ++made.tries;
  auto predicted = part(k).as_typed(traced);
  if (part(k).as_set) std::ranges::sort(predicted);
  if (!is_near(k, predicted)) return;
  made.covered = true;
  made.own = made.own || (strictly && agrees(part(k), traced, typed(k)));
}

const Misconception* Explainer::Case::alone(std::size_t k) const {
  const auto& list = exercise_->run.algorithm->misconceptions;
  for (std::size_t m = 0; m < count_; ++m)
    if (fit(m, k).known) return &list[m];
  if (!symptoms_->meant->operands_changed(part(k).value)) return nullptr;
  for (std::size_t m = 0; m < count_; ++m)
    if (fit(m, k).own) return &list[m];
  return nullptr;
}

// ---- slips ----------------------------------------------------------------------------------------------------------

std::size_t Explainer::Case::contradicted(Held held) const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < exercise_->parts.size(); ++i)
    if (symptoms_->fine[i] != 0 && exercise_->parts[i].voided == Voided::no)
      count += (predictions_->differ_at()[i] & held) != 0 ? 1 : 0;
  return count;
}

bool Explainer::Case::may_be_slip(std::size_t k) const {
  for (std::size_t m = 0; m < count_; ++m) {
    if (!fit(m, k).covered) continue;
    bool elsewhere = false;
    for (std::size_t other = 0; other < size_; ++other) elsewhere = elsewhere || (other != k && fit(m, other).covered);
    if (elsewhere || contradicted(held(m)) == 0) return false;
  }
  return true;
}

void Explainer::Case::is_slip(std::size_t k) {
  for (std::size_t m = 0; m < count_; ++m) fit(m, k).covered = false;
}

// ---- explanations ---------------------------------------------------------------------------------------------------

std::vector<Explainer::Case::Hypothesis> Explainer::Case::singles() const {
  std::vector<Hypothesis> made;
  for (std::size_t m = 0; m < count_; ++m) {
    Hypothesis one;
    for (std::size_t k = 0; k < size_; ++k) {
      const bool covers = counts(k) && fit(m, k).covered;
      one.covered += covers ? 1 : 0;
      one.covers.push_back(covers);
    }
    if (one.covered == 0) continue;
    one.held = held(m);
    one.contradicted = contradicted(one.held);
    made.push_back(std::move(one));
  }
  return made;
}

bool Explainer::Case::may_act_jointly(Held pair, std::size_t k) const {
  const Held there = (hidden_[k] | predictions_->act_on()[part(k).value]) & pair;
  return on_own_[k] != 0 && (hidden_[k] & pair) != 0 && there == pair;
}

// Pairs can only be better than the best single one where they cover more.
void Explainer::Case::add_pairs(std::vector<Hypothesis>& made) {
  std::size_t best = 0;
  for (const Hypothesis& one : made) best = std::max(best, one.covered);
  struct JointHit {
    Held held;
    std::size_t k;
  };
  std::vector<JointHit> hits;
  const auto& known = predictions_->of_pairs();
  for (std::size_t k = 0; k < size_; ++k)
    for (const MistakenValue& prediction : known[symptoms_->open[k]])
      if (counts(k) && agrees(part(k), prediction, typed(k), first_typed_[k])) hits.push_back({prediction.held, k});
  for (std::size_t a = 0; a < count_; ++a)
    for (std::size_t b = a + 1; b < count_; ++b) {
      const Held pair = held(a) | held(b);
      std::size_t either = 0, possible = 0;
      for (std::size_t k = 0; k < size_; ++k) {
        if (!counts(k)) continue;
        const bool covers = fit(a, k).covered || fit(b, k).covered;
        either += covers ? 1 : 0;
        possible += !covers && may_act_jointly(pair, k) ? 1 : 0;
      }
      const auto together =
          static_cast<std::size_t>(std::ranges::count_if(hits, [&](const JointHit& hit) { return hit.held == pair; }));
      if (either + together + possible <= best) continue;
      Hypothesis two;
      two.held = pair;
      two.covers.assign(size_, 0);
      two.chance_jointly.assign(size_, 0);
      for (std::size_t k = 0; k < size_; ++k) {
        two.covers[k] = counts(k) && (fit(a, k).covered || fit(b, k).covered);
        for (const MistakenValue& prediction : known[symptoms_->open[k]])
          if (prediction.held == pair) two.chance_jointly[k] += prediction.chance;
      }
      for (const JointHit& hit : hits) {
        if (hit.held != pair || two.covers[hit.k] != 0) continue;
        two.covers[hit.k] = 1;
        two.jointly = true;
      }
      if (possible > 0) replay_pair(two);
      two.covered = static_cast<std::size_t>(std::ranges::count(two.covers, 1));
      if (two.covered <= best) continue;
      two.contradicted = contradicted(pair);
      made.push_back(std::move(two));
    }
}

void Explainer::Case::replay_pair(Hypothesis& pair) {
  const auto& list = exercise_->run.algorithm->misconceptions;
  std::vector<const Misconception*> both;
  for_each_of(pair.held, [&](std::size_t m) { both.push_back(&list[m]); });
  std::vector<std::size_t> parts, k_of(exercise_->parts.size());
  for (std::size_t k = 0; k < size_; ++k) {
    if (!counts(k) || pair.covers[k] != 0 || !may_act_jointly(pair.held, k)) continue;
    parts.push_back(symptoms_->open[k]);
    k_of[symptoms_->open[k]] = k;
  }
  if (parts.empty()) return;
  if (!scratch_) scratch_.emplace(*exercise_, *plan_, Replayed::Rounding::ignored);
  replay_with(*exercise_, both, *scratch_, *symptoms_->given, parts, [&](std::size_t i, NumbersView<Exact> traced) {
    const std::size_t k = k_of[i];
    auto predicted = part(k).as_typed(traced);
    if (part(k).as_set) std::ranges::sort(predicted);
    pair.chance_jointly[k] += predictions_->guessing().chance(part(k), predicted);
    if (!is_near(k, predicted)) return;
    pair.covers[k] = 1;
    pair.jointly = true;
  });
}

double Explainer::Case::guess(std::size_t m, std::size_t k) const {
  double known = 0, largest = 0;
  for (const MistakenValue& prediction : predictions_->of_singles()[symptoms_->open[k]])
    if (prediction.held == held(m)) {
      known += prediction.chance;
      largest = std::max(largest, prediction.chance);
    }
  const std::size_t tries = fit(m, k).tries;
  if (tries > 0 && largest == 0) largest = predictions_->guessing().chance(part(k), part(k).right);
  return known + static_cast<double>(tries) * largest;
}

double Explainer::Case::chance_by_itself(const Hypothesis& hypothesis, std::size_t m) const {
  const Held other = hypothesis.held & ~held(m);
  Bits bits;
  Held rivals = 0;
  bool jointly = false;
  for (std::size_t k = 0; k < size_; ++k) {
    if (!counts(k)) continue;
    if (other != 0 && fit(static_cast<std::size_t>(std::countr_zero(other)), k).covered) continue;
    const double together = other != 0 ? hypothesis.chance_jointly[k] : 0;
    const double by_chance = guess(m, k) + together;
    const bool covers = hypothesis.covers[k] != 0;
    if (by_chance > 0) bits.add(by_chance, covers);
    if (!covers) continue;
    jointly = jointly || !fit(m, k).covered;
    for (const MistakenValue& prediction : predictions_->of_singles()[symptoms_->open[k]]) rivals |= prediction.held;
  }
  const double among = std::max(1, std::popcount(rivals | held(m)));
  return (jointly ? among * among : among) * bits.chance_of_as_many();
}

double Explainer::Case::chance(const Hypothesis& hypothesis) const {
  double worst = 0;
  for_each_of(hypothesis.held, [&](std::size_t m) { worst = std::max(worst, chance_by_itself(hypothesis, m)); });
  return std::min(worst, 1.0);
}

std::optional<Explanation> Explainer::Case::explain() {
  Explanation made;
  for (std::size_t k = 0; k < size_; ++k) made.wrong += counts(k) ? 1 : 0;
  if (made.wrong == 0) return std::nullopt;
  auto hypotheses = singles();
  if (std::ranges::none_of(hypotheses, [&](const Hypothesis& one) { return one.covered == made.wrong; }))
    add_pairs(hypotheses);
  std::ranges::stable_sort(hypotheses, [](const Hypothesis& a, const Hypothesis& b) {
    const auto rank = [](const Hypothesis& h) {
      return std::tuple(-static_cast<std::ptrdiff_t>(h.covered), std::popcount(h.held), h.contradicted);
    };
    return rank(a) < rank(b);
  });
  for (Hypothesis& hypothesis : hypotheses) {
    bool denied = false;
    for_each_of(hypothesis.held, [&](std::size_t m) { denied = denied || is_denied(m, hypothesis.covers); });
    if (denied) continue;
    const double by_chance = chance(hypothesis);
    made.chance = std::min(made.chance, by_chance);
    if (by_chance >= most_by_chance) continue;
    for_each_of(hypothesis.held,
                [&](std::size_t m) { made.misconceptions.push_back(&exercise_->run.algorithm->misconceptions[m]); });
    made.covered = hypothesis.covered;
    made.chance = by_chance;
    best_ = std::move(hypothesis);
    break;
  }
  return made;
}

bool Explainer::Case::is_denied(std::size_t m, const std::vector<char>& explained) const {
  struct Count {
    std::size_t covered = 0, denied = 0;
    bool speaks_against() const { return denied > 1 && denied > covered; }
  } all, first;
  std::size_t unexplained = 0, elsewhere = contradicted(held(m));
  for (std::size_t k = 0; k < size_; ++k) {
    if (!counts(k)) continue;
    const bool covers = fit(m, k).covered;
    const bool acts = ((predictions_->differ_at()[symptoms_->open[k]] | hidden_[k]) & held(m)) != 0;
    unexplained += !covers && explained[k] == 0 ? 1 : 0;
    elsewhere += !covers && acts ? 1 : 0;
    const bool is_first = !symptoms_->meant->operands_changed(part(k).value);
    const auto add = [&](std::size_t Count::*what) {
      ++(all.*what);
      if (is_first) ++(first.*what);
    };
    if (covers)
      add(&Count::covered);
    else if (acts && explained[k] == 0)
      add(&Count::denied);
  }
  const bool stray = all.covered < 2 && unexplained > 1 && elsewhere > 1;
  return all.speaks_against() || first.speaks_against() || stray;
}

bool Explainer::Case::is_contradicted(std::size_t m) const {
  return m < count_ && is_denied(m, best_ ? best_->covers : std::vector<char>(size_, 0));
}

const Misconception* Explainer::Case::acts_at(std::size_t k) const {
  if (!best_ || best_->covers[k] == 0) return nullptr;
  // Of two that cover it, the one that covers more; of what only both make, the one whose rule makes the value.
  std::optional<std::size_t> chosen;
  std::size_t most = 0;
  for_each_of(best_->held, [&](std::size_t m) {
    std::size_t covered = 0;
    for (std::size_t other = 0; other < size_; ++other) covered += counts(other) && fit(m, other).covered ? 1 : 0;
    const bool here = fit(m, k).covered;
    if (here && (!chosen || covered > most)) {
      chosen = m;
      most = covered;
    }
  });
  if (!chosen) {
    const Held here = best_->held & predictions_->act_on()[part(k).value];
    chosen = static_cast<std::size_t>(std::countr_zero(here != 0 ? here : best_->held));
  }
  return &exercise_->run.algorithm->misconceptions[*chosen];
}

}  // namespace blossom
