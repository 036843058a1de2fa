#include "export/slider_stops.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/json_write.hpp"
#include "lesson/slider_check.hpp"
#include "scene/camera.hpp"

namespace blossom {
namespace {

// So many at most, that a page does not become too large. Of a step: both ends and the lesson's own number of four
// sliders.
constexpr std::size_t most_of_slider = 33, most_of_step = 81, most_of_lesson = 600;
// The values of all runs of a page, and the work of one run in fractions: a lesson of numbers without end is written in
// a minute, too.
constexpr std::size_t most_recorded = 1'000'000;
constexpr std::uint64_t patient_work = 10'000'000;
// What reaches further than so many times the picture of the step runs out of it.
constexpr double most_growth = 3;

constexpr JsonLimits own_text{UINT32_MAX, 32, SIZE_MAX};

// The object of inputs as a file has it.
Json inputs_json(const Inputs<Exact>& inputs) {
  std::vector<std::pair<std::string, Json>> members;
  for (const auto& [name, value] : inputs.values)
    if (const auto document = JsonDocument::parse("", write_input<Exact>(value), own_text))
      members.emplace_back(name, document->root());
  return json_object(std::move(members));
}

// A slider's numbers: every so manyth of its steps.
class Grid {
 public:
  Grid(const Slider& slider, Exact own, bool whole) : from_(slider.from), to_(slider.to), own_(std::move(own)) {
    const Exact hundredth = (to_ - from_) / Exact(100);
    step_ = slider.step.value_or(whole ? Exact(1) : hundredth);
    constexpr double most_steps = 1e12;
    if (!(((to_ - from_) / step_).to_double() < most_steps)) step_ = hundredth;
    steps_ = static_cast<std::int64_t>(std::ceil(((to_ - from_) / step_).to_double()));
    if (steps_ > 2 * static_cast<std::int64_t>(most_of_slider)) every_ = steps_ / most_of_slider;
    while (scale().values.size() > most_of_slider) thin_out();
  }

  bool coarse() const { return every_ > 1; }
  bool can_be_thinner() const { return every_ < steps_; }
  void thin_out() {
    const std::int64_t inner = steps_ / every_, next = steps_ / inner + 1;
    every_ = next;
    // The last of its steps is as long as the others where that can be.
    constexpr std::int64_t near = 1000;
    for (std::int64_t even = next; even <= std::min(2 * next, near); ++even)
      if (steps_ % even == 0) return void(every_ = even);
  }

  // Both ends and the lesson's own number are always among them.
  StepSliders::Scale scale() const {
    StepSliders::Scale made;
    for (std::int64_t i = 0; i < steps_; i += every_)
      if (Exact at = from_ + Exact(i) * step_; at < to_) made.values.push_back(std::move(at));
    made.values.push_back(to_);
    const auto place = std::ranges::lower_bound(made.values, own_);
    made.own = static_cast<std::size_t>(place - made.values.begin());
    if (place == made.values.end() || *place != own_) made.values.insert(place, own_);
    return made;
  }

 private:
  Exact from_, to_, own_, step_;
  std::int64_t steps_ = 1, every_ = 1;
};

// Few enough stops, as far as their number can be made less.
StepSliders few_of(std::vector<Grid> grids, std::size_t most) {
  for (;;) {
    StepSliders made;
    for (const Grid& grid : grids) made.scales.push_back(grid.scale());
    made.coarse = std::ranges::any_of(grids, &Grid::coarse);
    if (made.count() <= most) return made;
    std::size_t longest = grids.size();
    for (std::size_t i = 0; i < grids.size(); ++i)
      if (grids[i].can_be_thinner() &&
          (longest == grids.size() || made.scales[i].values.size() > made.scales[longest].values.size()))
        longest = i;
    if (longest == grids.size()) return made;
    grids[longest].thin_out();
  }
}

// Of each slider; nothing where a path leads to no number.
std::optional<std::vector<Grid>> grids_of(const StoryScene& scene, const Beat& beat) {
  std::vector<Grid> grids;
  Json inputs = inputs_json(scene.inputs);
  for (const Slider& slider : beat.sliders) {
    const Json* number = find_number(inputs, slider.input);
    auto own = number != nullptr ? Exact::parse(number->text) : std::nullopt;
    if (!own) return std::nullopt;
    const InputSpec* spec = scene.recording->algorithm().input(slider.input);
    grids.emplace_back(slider, *std::move(own), spec != nullptr && spec->type == InputSpec::Type::integer);
  }
  return grids;
}

}  // namespace

std::size_t StepSliders::count() const {
  std::size_t count = 1;
  for (const Scale& scale : scales) count *= scale.values.size();
  return count;
}

std::size_t StepSliders::own() const {
  std::size_t stop = 0;
  for (const Scale& scale : scales) stop = stop * scale.values.size() + scale.own;
  return stop;
}

std::vector<Exact> StepSliders::values(std::size_t stop) const {
  std::vector<Exact> values(scales.size());
  for (std::size_t i = scales.size(); i-- > 0; stop /= scales[i].values.size())
    values[i] = scales[i].values[stop % scales[i].values.size()];
  return values;
}

SliderStops::SliderStops(const Story& story) {
  const auto has_sliders = [](const StoryStep& step) { return step.beat != nullptr && !step.beat->sliders.empty(); };
  std::size_t with = 0;
  for (const StoryScene& scene : story.scenes)
    with += static_cast<std::size_t>(std::ranges::count_if(scene.steps, has_sliders));
  if (with == 0) return;
  const std::size_t share = std::clamp<std::size_t>(most_of_lesson / with, 1, most_of_step);
  for (const StoryScene& scene : story.scenes)
    for (const StoryStep& step : scene.steps) {
      if (!has_sliders(step)) continue;
      auto grids = grids_of(scene, *step.beat);
      if (!grids) continue;
      StepSliders sliders = few_of(*std::move(grids), share);
      if (count_ + sliders.count() > most_of_lesson) {
        ++still_;
        continue;
      }
      count_ += sliders.count() - 1;
      coarse_ += sliders.coarse ? 1 : 0;
      steps_.emplace(&step, std::move(sliders));
    }
}

const StepSliders* SliderStops::of(const StoryStep& step) const {
  const auto found = steps_.find(&step);
  return found != steps_.end() ? &found->second : nullptr;
}

std::optional<StoryScene> SliderStops::run(const StoryScene& scene, const StoryStep& step, std::size_t stop) {
  const std::vector<Exact> values = of(step)->values(stop);
  Json moved = inputs_json(scene.inputs);
  for (std::size_t i = 0; i < values.size(); ++i)
    *find_number(moved, step.beat->sliders[i].input) = json_number(values[i]);
  std::optional<StoryScene> made;
  const auto document = JsonDocument::parse("", write_json(moved), own_text);
  Diagnostics unused;
  auto inputs = document && recorded_ < most_recorded
                    ? read_inputs(scene.recording->algorithm(), Cursor(*document, unused))
                    : std::nullopt;
  if (inputs) {
    const ExactBudget patience(patient_work);
    made = with_inputs(scene, step, *std::move(inputs));
  }
  if (made) recorded_ += made->recording->graph().value_count();
  gaps_ += made ? 0 : 1;
  return made;
}

std::vector<std::string> SliderStops::notes() const {
  std::vector<std::string> notes;
  const auto steps = [](std::size_t count) {
    return count == 1 ? std::string("one step") : std::to_string(count) + " steps";
  };
  if (coarse_ > 0)
    notes.push_back("the sliders of " + steps(coarse_) +
                    " stop at fewer numbers than in the window: a page holds at most " +
                    std::to_string(most_of_slider) + " numbers of a slider and " + std::to_string(most_of_step) +
                    " runs of a step");
  if (still_ > 0)
    notes.push_back("the sliders of " + steps(still_) + " are left out: a page holds at most " +
                    std::to_string(most_of_lesson) + " runs");
  if (gaps_ > 0)
    notes.push_back("its sliders pass over " + std::to_string(gaps_) + " of " + std::to_string(count_) +
                    " stops, where the run fails, takes too long or does not come to the same beat");
  return notes;
}

Camera common_camera(const StoryScene& scene, std::uint32_t step, const std::vector<std::optional<StoryScene>>& stops,
                     double width, double height) {
  const Camera own = scene.seen_from(step, width, height);
  const ViewAxes axes = axes_of(own);
  struct Box {
    glm::dvec2 low, high;
    glm::dvec2 size() const { return high - low; }
  };
  // Both lengths of what a camera shows are known from pictures that are very wide and very high.
  const auto box_of = [&](const StoryScene& of, std::uint32_t at) {
    constexpr double far = 1e6;
    const Camera wide = of.seen_from(at, far, 1), high = of.seen_from(at, 1, far);
    const glm::dvec3 offset = wide.centre - own.centre;
    const glm::dvec2 centre{glm::dot(offset, axes.right), glm::dot(offset, axes.up)};
    const glm::dvec2 half = 0.5 * glm::dvec2{high.height / far, wide.height};
    return Box{centre - half, centre + half};
  };
  const Box mine = box_of(scene, step);
  Box all = mine;
  const double most = most_growth * std::max(mine.size().x, mine.size().y);
  for (const auto& stop : stops) {
    if (!stop) continue;
    const Box box = box_of(*stop, stop->steps.front().step);
    const Box both{glm::min(mine.low, box.low), glm::max(mine.high, box.high)};
    if (!(both.size().x <= most && both.size().y <= most)) continue;
    all = {glm::min(all.low, box.low), glm::max(all.high, box.high)};
  }
  Camera camera = own;
  const glm::dvec2 centre = 0.5 * (all.low + all.high);
  camera.centre += centre.x * axes.right + centre.y * axes.up;
  camera.height = std::max(all.size().y, all.size().x * height / width);
  // Where the stops take no more room, the picture is the one that all other formats have.
  const bool grown =
      camera.height > own.height * (1 + 1e-9) || glm::length(camera.centre - own.centre) > 1e-9 * own.height;
  return grown ? camera : own;
}

}  // namespace blossom
