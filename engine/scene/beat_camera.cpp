#include "scene/beat_camera.hpp"

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

}  // namespace blossom
