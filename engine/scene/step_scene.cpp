#include "scene/step_scene.hpp"

#include <algorithm>
#include <cmath>

#include "lesson/prose.hpp"
#include "scene/grid.hpp"
#include "scene/panels.hpp"
#include "scene/scene_samples.hpp"

namespace blossom {

StepScenes::StepScenes(const StepSource& source)
    : source_(&source), samples_(std::make_unique<const SceneSamples>(source)) {}

StepScenes::~StepScenes() = default;

Camera StepScenes::fitted(double width, double height, const std::optional<Camera>& look) const {
  return samples_->fitted(width, height, look);
}

double StepScenes::grid_step(const Camera& camera, double width, double height) const {
  return camera.kind == Camera::Kind::orbit ? ground_grid_step(samples_->bounds)
                                            : plane_grid_step(camera, width, height);
}

Scene StepScenes::page(std::uint32_t step, const std::string& narration, const PageOptions& options) const {
  const StepSource& source = *source_;
  const TraceGraph& graph = *source.graph;
  const double margin = 18;
  const double top = 54;
  const double bottom = 106;
  const double side = std::min(440.0, options.width * 0.38);
  const double main_width = options.width - side - 3 * margin;
  const double main_height = options.height - top - bottom - margin;

  Scene scene;
  scene.width = options.width;
  scene.height = options.height;
  scene.title = options.title;
  const Prose prose = read_prose(narration);
  scene.description = plain_text(prose);

  View page;
  page.width = options.width;
  page.height = options.height;
  const auto text = [&](double x, double y, RichText runs, Role role, double size) -> Label& {
    Label label;
    label.anchor = {x, y, 0};
    label.text = std::move(runs);
    label.role = role;
    label.size_scale = size;
    page.labels.push_back(std::move(label));
    return page.labels.back();
  };
  const double room_for_title = options.width - 2 * margin - 130;  // beside the step's number
  const double title_size = std::min(
      1.35, room_for_title / (static_cast<double>(options.title.size()) * 12.2));  // of the theme with the largest text
  text(margin, 34, {{options.title, TextRun::Level::base, false, true}}, Role::text_strong, title_size);
  text(options.width - margin, 34, {{"step " + std::to_string(step) + " / " + std::to_string(graph.step_count() - 1)}},
       Role::text_quiet, 1)
      .placement = Label::Placement::right;

  // Narration, with the phase it happens in.
  double y = options.height - bottom;
  page.polygons.push_back(
      {{{0, y, 0}, {options.width, y, 0}, {options.width, options.height, 0}, {0, options.height, 0}}, Role::panel, 1});
  y += 24;
  std::string phases;
  for (const std::uint32_t phase : graph.phase_path(graph.step(step).phase))
    phases += (phases.empty() ? "" : "  ›  ") + source.phase_title(phase);
  if (!phases.empty()) {
    text(margin, y - 2, {{phases}}, Role::text_quiet,
         std::min(0.85, (options.width - 2 * margin) / (static_cast<double>(phases.size()) * 8)));
    y += 20;
  }
  // A long one on a small page is set smaller, so that its last line is still on it.
  const double narration_width = options.width - 2 * margin;
  const auto narration_height = [&](double size) {
    double lines = 0;
    for (const Block& block : prose) {
      const bool formula = std::ranges::any_of(block.spans, [](const Span& span) { return span.math != nullptr; });
      const double characters = static_cast<double>(plain_text({block}).size());
      lines += std::ceil(characters * size * 9 / narration_width) + (block.kind == Block::Kind::formula ? 1.2
                                                                     : formula                          ? 0.4
                                                                                                        : 0);
    }
    return lines * 22 * size;
  };
  double narration_size = 1.08;
  while (narration_size > 0.7 && y - 10 + narration_height(narration_size) > options.height) narration_size -= 0.04;
  text(margin, y + 4, rich_text(prose, source.algorithm_at(step)), Role::text, narration_size).max_width =
      narration_width;

  // Side panels, from above; the knots below the picture.
  Sheet side_sheet;
  View& side_view = side_sheet.view;
  side_view.x = options.width - side - margin;
  side_view.y = top;
  side_view.width = side;
  side_view.height = main_height;
  double at = add_pseudo_code(side_sheet, source, step, {}, 6, 0, side - 12, main_height / 2);
  const double formula = add_formula(side_sheet, source, step, 6, at, side - 12, main_height - at);
  // The scheme stands at the bottom, where it does not move from step to step.
  const double room = main_height - at - 150;
  if (room > 90) {
    Sheet measured;
    const TableauOptions fitting{true, side - 12, room};
    const double height = add_tableau(measured, source, step, {}, 6, 0, fitting).height;
    if (height > 0 && at + formula + height <= main_height + 24)
      add_tableau(side_sheet, source, step, {}, 6, main_height - height + 10, fitting);
  }

  Sheet knots_sheet;
  View& knots = knots_sheet.view;
  knots.x = margin;
  knots.width = main_width;
  knots.height = 56;
  const double knots_height =
      source.curves.size() == 1 ? add_knot_line(knots_sheet, source, step, {}, 0, 0, main_width) : 0;
  knots.y = top + main_height - knots_height;

  const double picture_height = main_height - knots_height;
  View picture =
      options.picture ? options.picture(main_width, picture_height) : viewport(step, main_width, picture_height);
  picture.x = margin;
  picture.y = top;
  scene.views.push_back(std::move(page));
  scene.views.push_back(std::move(picture));
  scene.views.push_back(std::move(side_view));
  if (knots_height > 0) scene.views.push_back(std::move(knots));
  return scene;
}

}  // namespace blossom
