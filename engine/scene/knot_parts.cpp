#include "scene/knot_parts.hpp"

#include <algorithm>
#include <array>

namespace blossom::parts {
namespace {

constexpr std::array<double, 2> label_rows{19, 28.5};  // below the line
constexpr double label_size = 0.72;

// Where labels stand, row by row, so that none overlaps another; the ends of the axis come first. Row -1: no room.
struct PlacedLabel {
  double x = 0;
  int row = -1;
};
std::vector<PlacedLabel> placed(const std::vector<Knot>& knots, int rows, double left, double right) {
  constexpr double apart = 3;
  std::vector<PlacedLabel> labels(knots.size());
  std::vector<double> half(knots.size());
  for (std::size_t i = 0; i < knots.size(); ++i) {
    half[i] = width_of(knots[i].label, Role::text_quiet, label_size) / 2;
    labels[i].x = std::clamp(knots[i].at, left + half[i], std::max(left + half[i], right - half[i]));
  }
  labels.front().row = 0;
  labels.back().row = 0;
  const double end = labels.back().x - half.back();
  std::vector<double> taken(static_cast<std::size_t>(rows), left - apart);
  taken[0] = labels.front().x + half.front();
  for (std::size_t i = 1; i + 1 < knots.size(); ++i)
    for (int row = 0; row < rows && labels[i].row < 0; ++row) {
      auto& edge = taken[static_cast<std::size_t>(row)];
      if (labels[i].x - half[i] < edge + apart) continue;
      if (row == 0 && labels[i].x + half[i] + apart > end) continue;
      labels[i].row = row;
      edge = labels[i].x + half[i];
    }
  return labels;
}

}  // namespace

RichText knot_label(const std::string& value, std::size_t count) {
  return {{value + (count > 1 ? " ×" + std::to_string(count) : "")}};
}

void set_knot_labels(View& view, const std::vector<Knot>& knots, double line, double left, double right,
                     int most_rows) {
  auto labels = placed(knots, most_rows, left, right);
  if (std::ranges::any_of(labels, [](const PlacedLabel& label) { return label.row < 0; }))
    labels = placed(knots, 1, left, right);
  for (std::size_t i = 0; i < knots.size(); ++i)
    if (labels[i].row >= 0)
      text(view, labels[i].x, line + label_rows[static_cast<std::size_t>(labels[i].row)], knots[i].label,
           Role::text_quiet, label_size, Label::Placement::centre);
}

void add_knot_spots(Sheet& sheet, const std::vector<Knot>& knots, const std::optional<Box>& u, double bottom,
                    double line) {
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const double at = knots[i].at;
    const double widest = std::max(9.0, width_of(knots[i].label, Role::text_quiet, label_size) / 2);
    const double before = i > 0 ? std::min(widest, (at - knots[i - 1].at) / 2) : widest;
    const double after = i + 1 < knots.size() ? std::min(widest, (knots[i + 1].at - at) / 2) : widest;
    Box box{at - before, line - knot_reach, before + after, 0};
    if (u && box.x < u->right() && u->x < box.right()) box.y = u->bottom();
    box.height = bottom - box.y;
    sheet.spots.push_back({{Link::Kind::knot, static_cast<std::uint32_t>(knots[i].first)},
                           box.x,
                           box.y,
                           box.width,
                           box.height,
                           "knot " + std::to_string(knots[i].first)});
  }
  if (u) sheet.spots.push_back({{Link::Kind::parameter, 0}, u->x, u->y, u->width, u->height, "u"});
}

}  // namespace blossom::parts
