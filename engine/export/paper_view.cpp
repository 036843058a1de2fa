#include "export/paper_view.hpp"

#include <algorithm>

#include "scene/panels.hpp"

namespace blossom {
namespace {

constexpr double functions_height = 112;
constexpr double between = 6;

}  // namespace

void enlarge_letters(View& view, const Theme& theme, const LetterSizes& sizes) {
  for (Label& label : view.labels) {
    const bool number = label.role == Role::text_quiet && label.placement != Label::Placement::around;
    const double least = number ? sizes.numbers : sizes.names;
    label.size_scale = std::max(label.size_scale, least / theme[label.role].text_size);
  }
}

View knots_view(const StoryScene& scene, std::uint32_t step, double width, bool functions) {
  const StepSource& source = scene.source();
  Sheet sheet;
  sheet.view.width = width;
  if (source.curves.size() != 1) return sheet.view;
  const bool result = resulting_knots(source, scene.recording->last()) != absent;
  const double top = functions ? functions_height : 0;
  const Emphasis none;
  const double height =
      add_knot_line(sheet, source, step, none, 0, top, width - (functions ? basis_bar_room : 0), 0, false, result);
  if (height == 0) return sheet.view;
  if (functions) add_basis(sheet, source, step, none, 0, 0, width, functions_height);
  sheet.view.height = top + (result ? knot_lines_height : knot_line_height);
  return sheet.view;
}

Scene picture_with_knots(const StoryScene& scene, std::uint32_t step, double width, double height, const Theme& theme,
                         const LetterSizes& sizes) {
  Scene made;
  made.width = width;
  made.height = height;
  made.views.push_back(scene.picture(step, width, height));
  enlarge_letters(made.views[0], theme, sizes);
  View knots = knots_view(scene, step, width, false);
  if (knots.height == 0) return made;
  enlarge_letters(knots, theme, {sizes.numbers, sizes.numbers});
  knots.y = height + between;
  made.height += between + knots.height;
  made.views.push_back(std::move(knots));
  return made;
}

}  // namespace blossom
