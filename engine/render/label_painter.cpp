#include "render/label_painter.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/clip.hpp"
#include "render/label_layout.hpp"
#include "render/rich_text.hpp"

namespace blossom {
namespace {

constexpr double halo_width = 2.2;      // page units
constexpr double leader_distance = 20;  // a label farther than this from its anchor is tied to it with a line

// What covering a line costs a label; what the eye follows must stay whole.
double ink_of(Role role) {
  switch (role) {
    case Role::grid:
    case Role::surface:
    case Role::panel:
      return 0;
    case Role::isoline:
      return 0.15;
    case Role::axis:
    case Role::earlier:
    case Role::retired:
    case Role::rule_line:
      return 0.5;
    case Role::current:
    case Role::ratio_near:
    case Role::ratio_far:
    case Role::result:
    case Role::highlight:
      return 2;
    default:
      return 1;
  }
}

double text_size(const Theme& theme, const Label& label) {
  const double factor = std::isfinite(label.size_scale) ? label.size_scale : 1.0;
  return std::clamp(theme[label.role].text_size * factor, 4.0, 200.0);
}

void fill_obstacles(LabelLayout& layout, const View& view, const Projection& project, const PixelRect& visible,
                    const Theme& theme) {
  for (const auto& line : view.polylines) {
    const double ink = ink_of(line.role);
    if (ink == 0) continue;
    for (const auto& piece : clip_line(project, line, 0, visible)) {
      const std::size_t n = piece.points.size();
      for (std::size_t i = 0; i + (piece.closed ? 0 : 1) < n; ++i) {
        const auto &a = piece.points[i], &b = piece.points[(i + 1) % n];
        layout.add_line(a.x, a.y, b.x, b.y, ink);
      }
    }
  }
  for (const auto& marker : view.markers) {
    const auto p = project(marker.position);
    if (!p || !contains(visible, p->x, p->y)) continue;
    const double factor = std::isfinite(marker.size_scale) ? std::clamp(marker.size_scale, 0.0, 100.0) : 1.0;
    layout.add_marker(p->x, p->y, theme[marker.role].marker_size / 2 * factor + 1);
  }
}

}  // namespace

void paint_labels(const View& view, const Projection& project, const PixelRect& visible, const Theme& theme,
                  const Fonts& fonts, Canvas& canvas, const PageMap& map) {
  const bool on_page = view.camera.kind == Camera::Kind::page;
  const auto paint = [&](const Label& label, TextBlock& block, double x, double baseline) {
    TextBlock set = placed(std::move(block), x, baseline, map.scale);
    if (map.origin.x != 0 || map.origin.y != 0) set = placed(std::move(set), map.origin.x, map.origin.y);
    const TextPaint look{theme[label.role].ink, theme.background,
                         on_page ? 0 : static_cast<float>(halo_width * map.scale)};
    paint_text(canvas, set, look);
  };

  std::vector<const Label*> floating;
  std::optional<LabelLayout> layout;
  const bool any_floating = std::any_of(view.labels.begin(), view.labels.end(),
                                        [](const Label& label) { return label.placement == Label::Placement::around; });
  if (any_floating) {
    layout.emplace(visible);
    fill_obstacles(*layout, view, project, visible, theme);
  }

  for (const auto& label : view.labels) {
    const auto anchor = project(label.anchor);
    if (!anchor || label.text.empty()) continue;
    if (label.placement == Label::Placement::around) {
      if (contains(visible, anchor->x, anchor->y)) floating.push_back(&label);
      continue;
    }
    const auto align = label.placement == Label::Placement::left     ? TextAlign::left
                       : label.placement == Label::Placement::centre ? TextAlign::centre
                                                                     : TextAlign::right;
    auto block = set_text(fonts, label.text, text_size(theme, label), align, label.max_width);
    const PixelRect box{anchor->x + block.left, anchor->y + block.top, block.width, block.bottom - block.top};
    if (intersection(box, visible).width <= 0) continue;
    if (layout) layout->add_label(box);
    paint(label, block, anchor->x, anchor->y);
  }

  std::stable_sort(floating.begin(), floating.end(),
                   [](const Label* a, const Label* b) { return a->priority > b->priority; });
  for (const Label* label : floating) {
    const auto anchor = project(label->anchor);
    auto block = set_text(fonts, label->text, text_size(theme, *label), TextAlign::left, label->max_width);
    const auto box = layout->place(block.width, block.bottom - block.top, anchor->x, anchor->y, label->optional);
    if (!box) continue;
    const double near_x = std::clamp(anchor->x, box->x, box->right());
    const double near_y = std::clamp(anchor->y, box->y, box->bottom());
    if (std::hypot(near_x - anchor->x, near_y - anchor->y) > leader_distance) {
      const PixelPoint leader[] = {map(anchor->x, anchor->y, 0), map(near_x, near_y, 0)};
      canvas.polyline(leader, false, {theme[Role::axis].color, static_cast<float>(0.8 * map.scale), 0, 0});
    }
    paint(*label, block, box->x, box->y - block.top);
  }
}

}  // namespace blossom
