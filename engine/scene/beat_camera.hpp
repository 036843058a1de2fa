#pragma once
// What a lesson's beats say is seen, as a camera of a view.

#include "lesson/beat.hpp"
#include "scene/step_scene.hpp"

namespace blossom {

// The camera that holds at a step: that of the last beat up to it which has one; nullptr: all is shown.
const BeatCamera* camera_in_force(const std::vector<Beat>&, std::uint32_t step);

// As a camera of a view of this size. `source` is the run's that the scenes are of.
Camera camera_of(const BeatCamera&, const StepScenes&, const StepSource& source, double width, double height);

}  // namespace blossom
