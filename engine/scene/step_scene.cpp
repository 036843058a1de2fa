#include "scene/step_scene.hpp"

#include <algorithm>
#include <cmath>

#include "lesson/prose.hpp"
#include "scene/camera.hpp"
#include "scene/grid.hpp"
#include "scene/panels.hpp"
#include "scene/scene_samples.hpp"

namespace blossom {
namespace {

constexpr double ring_reach = 17;      // of what is drawn around a point
constexpr double fit_margin = 1.18;    // that a fitted camera leaves
constexpr double tall = 1.15;          // from this many widths on, the panels stand below the picture
constexpr double panel_width = 240;    // narrower panels are set smaller
constexpr double least_panel = 0.76;   // down to this size
constexpr double small_picture = 420;  // where numbers at the grid give way to points

// A sheet in page units, made smaller.
void shrink(View& view, double factor) {
  if (factor == 1) return;
  for (Polygon& polygon : view.polygons)
    for (glm::dvec3& point : polygon.points) point *= factor;
  for (Polyline& line : view.polylines)
    for (glm::dvec3& point : line.points) point *= factor;
  for (Marker& marker : view.markers) {
    marker.position *= factor;
    marker.size_scale *= factor;
  }
  for (Label& label : view.labels) {
    label.anchor *= factor;
    label.size_scale *= factor;
    label.max_width *= factor;
  }
}

// Without the numbers at a grid that stand on points; on a very low picture, without any.
void clear_points(View& picture) {
  constexpr double letter = 6, height = 10, reach = 8, low = 120;
  const ViewSize size{picture.width, picture.height};
  std::vector<glm::dvec2> points;
  for (const Marker& marker : picture.markers)
    if (const auto at = to_page(picture.camera, size, marker.position)) points.push_back(*at);
  std::erase_if(picture.labels, [&](const Label& label) {
    if (!label.optional || label.role != Role::text_quiet || label.text.size() != 1) return false;
    if (picture.height < low) return true;
    const auto at = to_page(picture.camera, size, label.anchor);
    const double width = letter * static_cast<double>(label.text[0].text.size());
    return at && std::ranges::any_of(points, [&](const glm::dvec2& p) {
             return p.x > at->x - reach && p.x < at->x + width + reach && p.y > at->y - height - reach &&
                    p.y < at->y + reach;
           });
  });
}

}  // namespace

StepScenes::StepScenes(const StepSource& source)
    : source_(&source), samples_(std::make_unique<const SceneSamples>(source)) {}

StepScenes::~StepScenes() = default;

Camera StepScenes::fitted(double width, double height, const std::optional<Camera>& look) const {
  Camera camera = samples_->fitted(width, height, look);
  // The margin of a small view is too narrow for what is drawn around points.
  for (const double side : {width, height})
    if (side > 3 * ring_reach && side < 2 * ring_reach * fit_margin / (fit_margin - 1))
      camera.height *= side / fit_margin / (side - 2 * ring_reach);
  return camera;
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
  std::string phases;
  for (const std::uint32_t phase : graph.phase_path(graph.step(step).phase))
    phases += (phases.empty() ? "" : "  ›  ") + source.phase_title(phase);
  const Prose prose = read_prose(narration);
  const double narration_width = options.width - 2 * margin, above_narration = phases.empty() ? 14 : 34;
  const auto narration_height = [&](double size) {
    double lines = 0;
    for (const Block& block : prose) {
      const bool formula = std::ranges::any_of(block.spans, [](const Span& span) { return span.math != nullptr; });
      const double characters = static_cast<double>(plain_text({block}).size());
      lines += std::ceil(characters * size * 9 / narration_width) + (block.kind == Block::Kind::formula ? 1.2
                                                                     : formula                          ? 0.4
                                                                                                        : 0);
    }
    return above_narration + lines * 22 * size;
  };
  // A long one on a small page is set smaller; where that is not enough, it gets more room.
  double bottom = 106, narration_size = 1.08;
  while (narration_size > 0.8 && narration_height(narration_size) > bottom) narration_size -= 0.04;
  bottom = std::clamp(narration_height(narration_size), bottom, 0.38 * options.height);
  while (narration_size > 0.5 && narration_height(narration_size) > bottom) narration_size -= 0.04;
  const bool stacked = options.height > tall * options.width;
  const double side = stacked ? options.width - 2 * margin : std::min(440.0, options.width * 0.38);
  const double main_width = stacked ? side : options.width - side - 3 * margin;
  const double room_height = options.height - top - bottom - margin;
  const double main_height = stacked ? std::min(0.55 * room_height, 1.2 * main_width) : room_height;

  Scene scene;
  scene.width = options.width;
  scene.height = options.height;
  scene.title = options.title;
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
       Role::text_quiet, std::min(1.0, 1.1 * title_size))
      .placement = Label::Placement::right;

  // Narration, with the phase it happens in.
  double y = options.height - bottom;
  page.polygons.push_back(
      {{{0, y, 0}, {options.width, y, 0}, {options.width, options.height, 0}, {0, options.height, 0}}, Role::panel, 1});
  y += 24;
  if (!phases.empty()) {
    text(margin, y - 2, {{phases}}, Role::text_quiet,
         std::min(0.85, (options.width - 2 * margin) / (static_cast<double>(phases.size()) * 8)));
    y += 20;
  }
  text(margin, y + 4, rich_text(prose, source.algorithm_at(step)), Role::text, narration_size).max_width =
      narration_width;

  // Side panels, from above; the knots below the picture.
  const double factor = std::clamp(side / panel_width, least_panel, 1.0);
  const double side_top = stacked ? top + main_height + margin : top;
  const double side_height = (stacked ? room_height - main_height - margin : main_height) / factor;
  const double side_width = side / factor - 12;
  Sheet side_sheet;
  View& side_view = side_sheet.view;
  side_view.x = options.width - side - margin;
  side_view.y = side_top;
  side_view.width = side;
  side_view.height = side_height * factor;
  double at = add_pseudo_code(side_sheet, source, step, {}, 6, 0, side_width, side_height / 2);
  const double formula = add_formula(side_sheet, source, step, 6, at, side_width, side_height - at);
  // The scheme stands at the bottom, where it does not move from step to step.
  const double room = side_height - at - 150;
  if (room > 90) {
    Sheet measured;
    const TableauOptions fitting{true, side_width, room};
    const double height = add_tableau(measured, source, step, {}, 6, 0, fitting).height;
    if (height > 0 && at + formula + height <= side_height + 24)
      add_tableau(side_sheet, source, step, {}, 6, side_height - height + 10, fitting);
  }
  shrink(side_view, factor);

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
  if (std::min(picture.width, picture.height) < small_picture) clear_points(picture);
  picture.x = margin;
  picture.y = top;
  scene.views.push_back(std::move(page));
  scene.views.push_back(std::move(picture));
  scene.views.push_back(std::move(side_view));
  if (knots_height > 0) scene.views.push_back(std::move(knots));
  return scene;
}

}  // namespace blossom
