#include "scene/beat_look.hpp"

#include <numbers>

#include "algorithms/selector.hpp"
#include "scene/fit.hpp"

namespace blossom {

const BeatCamera* camera_in_force(const std::vector<Beat>& beats, std::uint32_t step) {
  const BeatCamera* found = nullptr;
  for (const Beat& beat : beats)
    if (beat.step <= step && beat.camera) found = &*beat.camera;
  return found;
}

Camera camera_of(const BeatCamera& wanted, const StepScenes& scenes, const StepSource& source, double width,
                 double height) {
  const double degree = std::numbers::pi / 180;
  Camera camera = scenes.fitted(width, height);
  if (wanted.azimuth) camera.azimuth = *wanted.azimuth * degree;
  if (wanted.elevation) camera.elevation = *wanted.elevation * degree;
  camera = scenes.fitted(width, height, camera);

  Bounds bounds;
  std::vector<glm::dvec3> places;
  for (const std::string& text : wanted.fit) {
    std::string error;
    const auto selector = Selector::parse(text, error);
    for (ValueId v = 0; selector && v < source.graph->value_count(); ++v)
      if (source.points[v] && selector->matches(*source.graph, v)) places.push_back(*source.points[v]);
  }
  for (const glm::dvec3& place : places) bounds.add(place);
  if (bounds.diagonal() > 0)
    camera = fitted_camera(camera, width, height, bounds, [&](const auto& see) {
      for (const glm::dvec3& place : places) see(place);
    });
  camera.height /= wanted.zoom;
  return camera;
}

std::vector<std::vector<ValueId>> hulls_in_force(const std::vector<Beat>& beats, const StepSource& source,
                                                 std::uint32_t step) {
  const std::vector<std::string>* found = nullptr;
  for (const Beat& beat : beats)
    if (beat.step <= step && beat.hulls) found = &*beat.hulls;
  std::vector<std::vector<ValueId>> hulls;
  if (found == nullptr) return hulls;
  for (const std::string& selector : *found) {
    auto points = selected_up_to({selector}, step, *source.graph);
    std::erase_if(points, [&](ValueId v) { return !source.points[v]; });
    if (points.size() > 1) hulls.push_back(std::move(points));
  }
  return hulls;
}

}  // namespace blossom
