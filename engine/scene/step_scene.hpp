#pragma once
// The page of one step: the geometry with what the step does to it, the pseudo-code with its line, the formula with
// numbers, the triangular scheme, the knots, and the narration. The same page for every algorithm, from its tables.

#include <memory>

#include "scene/display_list.hpp"
#include "scene/source.hpp"

namespace blossom {

struct PageOptions {
  double width = 1120;
  double height = 700;
  std::string title;
};

class StepScenes {
 public:
  // Samples the curves once for all pages. `source` must stay.
  explicit StepScenes(const StepSource& source);
  ~StepScenes();

  Scene page(std::uint32_t step, const std::string& narration, const PageOptions&) const;

  // Only the geometry, as a view of this size at (0, 0): for thumbnails, and for a window that has its own panels.
  View viewport(std::uint32_t step, double width, double height) const;

 private:
  struct Samples;
  const StepSource* source_;
  std::unique_ptr<Samples> samples_;
};

}  // namespace blossom
