#pragma once
// What a lesson's beats say of the picture: from where it is seen, and which convex hulls it shows.

#include "lesson/beat.hpp"
#include "scene/step_scene.hpp"

namespace blossom {

// The camera that holds at a step: that of the last beat up to it which has one; nullptr: all is shown.
const BeatCamera* camera_in_force(const std::vector<Beat>&, std::uint32_t step);

// As a camera of a view of this size. `source` is the run's that the scenes are of.
Camera camera_of(const BeatCamera&, const StepScenes&, const StepSource& source, double width, double height);

// Those of the last beat up to a step that says: for each of its selectors the points that are made by then.
std::vector<std::vector<ValueId>> hulls_in_force(const std::vector<Beat>&, const StepSource& source,
                                                 std::uint32_t step);

}  // namespace blossom
