#include <algorithm>
#include <cmath>

#include "scene/knot_parts.hpp"
#include "scene/panels.hpp"
#include "scene/workspace_view.hpp"

namespace blossom {
namespace {

using parts::Box;
using parts::Knot;

// Whether the last p points are the first p and the knots repeat: the knots outside of the domain follow from others.
bool is_closed(const Curve<double>& curve) {
  const auto p = static_cast<std::size_t>(curve.degree), count = curve.points.size();
  if (count < 2 * p) return false;
  for (std::size_t i = 0; i < p; ++i)
    if (curve.points[i] != curve.points[count - p + i]) return false;
  const std::size_t turn = count - p;  // knots from one to the same one round later
  const double period = curve.domain_end() - curve.domain_begin();
  for (std::size_t i = 0; i + turn < curve.knots.size(); ++i)
    if (std::abs(curve.knots[i + turn] - curve.knots[i] - period) > 1e-9 * period) return false;
  return true;
}

}  // namespace

double add_object_knots(Sheet& sheet, const Curve<double>& curve, double u, double x, double y, double width) {
  const auto axis = knot_axis(curve, x, width);
  if (!axis || axis->right <= axis->left) return 0;
  View& view = sheet.view;
  const double line = y + knot_line_at;
  parts::text(view, x, line + 4, {{"U", TextRun::Level::base, true}}, Role::text_quiet, 0.9);
  parts::stroke(view, {{axis->left, line, 0}, {axis->right, line, 0}}, Role::rule_line);
  parts::stroke(view, {{axis->place(curve.domain_begin()), line, 0}, {axis->place(curve.domain_end()), line, 0}},
                Role::polygon);

  const bool closed = is_closed(curve);
  std::vector<Knot> knots;
  for (std::size_t i = 0; i < curve.knots.size(); i += knots.back().count) {
    Knot knot{i, 1, axis->place(curve.knots[i]), {}};
    while (i + knot.count < curve.knots.size() && curve.knots[i + knot.count] == curve.knots[i]) ++knot.count;
    knot.label = parts::knot_label(parts::significant(curve.knots[i], 4), knot.count);
    knot.quiet = closed && (curve.knots[i] < curve.domain_begin() || curve.knots[i] > curve.domain_end());
    view.markers.push_back({{knot.at, line, 0},
                            knot.quiet ? Role::retired : Role::control_point,
                            Marker::Shape::triangle,
                            knot.quiet ? 0.8 : 0.9});
    // Each further one of a multiple knot is a mark above the first.
    for (std::size_t k = 1; k < std::min<std::size_t>(knot.count, 6) && !knot.quiet; ++k)
      parts::stroke(view,
                    {{knot.at - 4, line + 4.5 + 2.6 * static_cast<double>(k), 0},
                     {knot.at + 4, line + 4.5 + 2.6 * static_cast<double>(k), 0}},
                    Role::control_point, 0.7);
    knots.push_back(std::move(knot));
  }
  parts::set_knot_labels(view, knots, line + 6, x, x + width, 2);

  const double at = axis->place(std::clamp(u, curve.domain_begin(), curve.domain_end()));
  view.markers.push_back({{at, line, 0}, Role::current, Marker::Shape::diamond, 1});
  RichText words{{"u", TextRun::Level::base, true}, {" = " + parts::significant(u, 4)}};
  const double half = parts::width_of(words, Role::text_current, 0.85) / 2;
  parts::text(view, std::clamp(at, x + half, std::max(x + half, x + width - half)), line - 12, std::move(words),
              Role::text_current, 0.85, Label::Placement::centre)
      .priority = 10;
  const double height = knot_line_height + 6;
  parts::add_knot_spots(sheet, knots, Box{at - 9, y, 18, knot_line_at + parts::knot_reach}, y + height, line);
  return height;
}

}  // namespace blossom
