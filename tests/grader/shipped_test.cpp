// The exercises that are shipped: what they ask tells who knows the rule from who does not.

#include <filesystem>
#include <set>

#include "grader/helpers.hpp"

using namespace blossom;

namespace {

// A value with what somebody has for it and all others.
class OwnValues final : public Site {
 public:
  OwnValues(const Run<Exact>& run, const Replayed& own) : run_(&run), own_(&own) {}
  void go_to(ValueId v) { value_ = v; }
  const Trace<Exact>& trace() const override { return run_->trace; }
  const Inputs<Exact>& inputs() const override { return run_->inputs; }
  ValueId value() const override { return value_; }
  NumbersView<Exact> numbers(ValueId v) const override {
    return own_->own(v).empty() ? run_->trace.numbers(v) : own_->own(v);
  }

 private:
  const Run<Exact>* run_;
  const Replayed* own_;
  ValueId value_ = absent;
};

// What a misconception makes of an exercise.
struct Effect {
  bool applies = false;            // somewhere in the run
  std::set<std::string> shows;     // asked values that it makes wrong
  std::set<std::string> accepted;  // asked values that it changes, and that count as right nevertheless
};

Effect effect_of(const Exercise& exercise, const Misconception& misconception) {
  Effect effect;
  const ReplayPlan plan(exercise);
  Replayed own(exercise, plan);
  OwnValues site(exercise.run, own);
  const auto candidates = [&](ValueId v) {
    site.go_to(v);
    return misconception.wrong(site);
  };
  const auto look = [&](const Part& part, NumbersView<Exact> traced) {
    const auto typed = part.as_typed(traced);
    if (typed.empty() || typed == part.right) return;
    const bool right = agrees(part, exercise.run.trace.numbers(part.value), typed);
    (right ? effect.accepted : effect.shows).insert(part.name);
  };
  // Its own slip in an otherwise right answer, and all that follows if it is made throughout.
  const std::vector<Given> right(exercise.parts.size(), Given{Given::Kind::right});
  own.run(right);
  for (const ValueId v : plan.order) effect.applies = effect.applies || !candidates(v).empty();
  for (const Part& part : exercise.parts)
    for (const auto& candidate : candidates(part.value)) look(part, candidate);
  for (const auto& given : {right, std::vector<Given>(exercise.parts.size())}) {
    own.run(given, [&](ValueId v) {
      auto all = candidates(v);
      return all.empty() ? Numbers<Exact>() : std::move(all.front());
    });
    for (const Part& part : exercise.parts) {
      look(part, own.expected(part.value));
      look(part, own.own(part.value));
    }
  }
  return effect;
}

// Where a misconception makes no difference to what is asked, and why that is as it should be.
const std::map<std::string, std::string> shows_nowhere{
    {"heavy-weight swapped-weights", "u = 1/2: both weights are the same, and the exercise is on the division"},
    {"cut-a-cubic neighbour-knot", "on a Bezier curve each ratio is u, whatever the level"},
    {"own-halves neighbour-knot", "on a Bezier curve each ratio is u, whatever the level"},
    {"velocities knots-forgotten", "the knots of a Bezier curve are 1 apart"},
    {"velocities whole-support", "the knots of a Bezier curve are 1 apart"},
    {"local-interpolation swapped-weights", "uniform parameters: both slopes count one half"},
    {"own-tangents swapped-weights", "uniform parameters: both slopes count one half"},
    {"blossom neighbour-knot", "on a Bezier curve each ratio is the argument, whatever the level"},
    {"closed-curve swapped-weights", "uniform knots, at a knot: both weights are 1/2"},
    {"knot-removal swapped-weights", "the knot is in the middle: both weights are 1/2"},
    {"moved-weight swapped-quotients", "u = 1/2 on a Bezier curve: both quotients are the same"},
    {"moved-weight whole-support", "on a Bezier curve all knots are 0 or 1"},
    {"own-blossom neighbour-knot", "on a Bezier curve each ratio is the argument, whatever the level"},
    {"own-derivative same-degree", "only the first derivative is asked"},
    {"own-weight whole-support", "on a Bezier curve all knots are 0 or 1"},
    {"projection neighbour-knot", "on a Bezier curve each ratio is u, whatever the level"},
    {"projection swapped-weights", "u = 1/2: both weights are the same, and the exercise is on lifting"},
    {"coons-by-hand evenly-spaced", "on Bezier curves the means of the knots are evenly spaced"},
    {"own-coons evenly-spaced", "on Bezier curves the means of the knots are evenly spaced"},
    {"crease larger-span", "the knot is in the middle: both spans are the same"},
    {"own-crease larger-span", "the knot is in the middle: both spans are the same"},
    {"surface-knot-less swapped-weights", "the knot is in the middle: both weights are 1/2"},
    {"own-surface-knot-less swapped-weights", "the knot is in the middle: both weights are 1/2"},
    {"swung-frame height-scaled", "no scale is given: it is 1"},
    {"own-swung height-scaled", "no scale is given: it is 1"},
    {"translated one-weight", "the trajectory is polynomial: its weights are 1"},
    {"own-translated one-weight", "the trajectory is polynomial: its weights are 1"},
    {"turned-segment equal-weights", "points are typed without weights: the corners' places are right"},
    {"own-turned-segment equal-weights", "points are typed without weights: the corners' places are right"},
    {"vase-arcs equal-weights", "points are typed without weights: the corners' places are right"},
    {"own-vase equal-weights", "points are typed without weights: the corners' places are right"},
};

}  // namespace

TEST_CASE("No shipped exercise takes a known misconception for the right rule") {
  std::size_t exercises = 0;
  std::set<std::string> silent;
  for (const auto& file : std::filesystem::directory_iterator("exercises")) {
    if (file.path().extension() != ".json" || file.path().stem().extension() == ".schema") continue;
    ++exercises;
    const auto exercise = load_exercise(file.path());
    INFO(to_string(exercise.diagnostics));
    REQUIRE(exercise);
    for (const Misconception& misconception : exercise->run.algorithm->misconceptions) {
      const Effect effect = effect_of(*exercise, misconception);
      const std::string here = exercise->id + " " + std::string(misconception.id);
      for (const std::string& name : effect.accepted) {
        INFO(here << " is right at " << name);
        CHECK(effect.accepted.empty());
      }
      if (effect.applies && effect.shows.empty()) silent.insert(here);
    }
  }
  CHECK(exercises >= 12);
  std::set<std::string> expected;
  for (const auto& [here, reason] : shows_nowhere) expected.insert(here);
  CHECK(silent == expected);
}
