#pragma once
// The sliders of a lesson's beats on a page that runs no algorithm: at which numbers each of them stops, and what is
// there where the same beat stands in the run with these numbers.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "export/story.hpp"

namespace blossom {

// The sliders of one step. Their stops are numbered so that the last slider's numbers go fastest.
struct StepSliders {
  struct Scale {
    std::vector<Exact> values;  // ascending
    std::size_t own = 0;        // which of them is the lesson's
  };
  std::vector<Scale> scales;  // of the sliders of the beat
  bool coarse = false;        // not all steps of the sliders are among them

  std::size_t count() const;
  std::size_t own() const;                            // the stop that is the step itself
  std::vector<Exact> values(std::size_t stop) const;  // of each slider
};

class SliderStops {
 public:
  explicit SliderStops(const Story&);  // which has to stay

  const StepSliders* of(const StoryStep&) const;  // nullptr: it has none that can be moved
  std::size_t count() const { return count_; }    // of all stops that are not the lesson's own

  // The scene of one step at a stop; nothing where there is no such step (see with_inputs), or the work is too much.
  std::optional<StoryScene> run(const StoryScene&, const StoryStep&, std::size_t stop);

  // What the sliders cannot do here, as sentences; after all stops were run.
  std::vector<std::string> notes() const;

 private:
  std::map<const StoryStep*, StepSliders> steps_;
  std::size_t count_ = 0, recorded_ = 0;           // recorded: the values of all runs
  std::size_t still_ = 0, coarse_ = 0, gaps_ = 0;  // steps whose sliders stay, or are coarse; stops without a step
};

// From where a step and its stops are all seen, so that nothing but what moves seems to move.
Camera common_camera(const StoryScene&, std::uint32_t step, const std::vector<std::optional<StoryScene>>& stops,
                     double width, double height);

}  // namespace blossom
