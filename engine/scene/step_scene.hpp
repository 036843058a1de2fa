#pragma once
// The page of one step: the geometry with what the step does to it, the pseudo-code with its line, the formula with
// numbers, the triangular scheme, the knots, and the narration. The same page for every algorithm, from its tables.

#include <functional>
#include <memory>
#include <optional>

#include "scene/display_list.hpp"
#include "scene/source.hpp"
#include "scene/spot.hpp"

namespace blossom {

struct SceneSamples;

struct PageOptions {
  double width = 1120;
  double height = 700;
  std::string title;
  std::function<View(double width, double height)> picture = {};  // instead of the viewport
};

struct ViewportOptions {
  std::optional<Camera> camera;  // otherwise the fitted one
  Emphasis emphasis;
  std::vector<std::vector<ValueId>> hulls = {};  // the convex hull of each of these
  // How far the step has come: below 1 the new point is on its way from one operand to the other (of a division), or
  // appears.
  double motion = 1;
  bool grid = true;
  bool labels = true;
  bool curves = true;       // the given curves
  bool surface_net = true;  // control net and isoparametric curves on a finished surface
};

class StepScenes {
 public:
  // Samples the curves once for all pages. `source` must stay.
  explicit StepScenes(const StepSource& source);
  ~StepScenes();

  Scene page(std::uint32_t step, const std::string& narration, const PageOptions&) const;

  // Only the geometry, as a view of this size at (0, 0): for thumbnails, and for a window that has its own panels.
  View viewport(std::uint32_t step, double width, double height) const;
  // The same as a window shows it. Spots: the points of the step, nearest to the viewer last.
  Sheet viewport(std::uint32_t step, double width, double height, const ViewportOptions&) const;

  // The camera that shows all of it; `look` says from where (its kind, azimuth, elevation and perspective are kept).
  Camera fitted(double width, double height, const std::optional<Camera>& look = {}) const;
  // How far apart the lines of the grid are that such a view has.
  double grid_step(const Camera&, double width, double height) const;

 private:
  const StepSource* source_;
  std::unique_ptr<const SceneSamples> samples_;
};

}  // namespace blossom
