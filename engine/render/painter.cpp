#include "render/painter.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "base/scalar.hpp"
#include "render/clip.hpp"
#include "render/label_painter.hpp"
#include "render/projection.hpp"

namespace blossom {
namespace {

// How far things are pulled toward the viewer, in hundredths of the camera's height (see Projection).
constexpr double line_pull = 0.7, marker_pull = 1.2;

double factor(double scale) { return std::isfinite(scale) ? std::clamp(scale, 0.0, 100.0) : 1.0; }

Color faded(Color color, double opacity) {
  const double a = std::isfinite(opacity) ? std::clamp(opacity, 0.0, 1.0) : 1.0;
  color.a = static_cast<std::uint8_t>(std::lround(color.a * a));
  return color;
}

class ViewPainter {
 public:
  // `page`: the part of the page that may be painted.
  ViewPainter(const View& view, const PixelRect& page, const Theme& theme, const Fonts& fonts, Canvas& canvas,
              const PageMap& map)
      : view_(view), theme_(theme), fonts_(fonts), canvas_(canvas), map_(map), scale_(map.scale), project_(view) {
    visible_ = view.clip ? intersection({view.x, view.y, view.width, view.height}, page) : page;
    // What runs out of sight is cut a little beyond the edge, so that its end is not seen.
    constexpr double margin = 40;
    guard_ = {visible_.x - margin, visible_.y - margin, visible_.width + 2 * margin, visible_.height + 2 * margin};
  }

  void paint() {
    if (visible_.width <= 0 || visible_.height <= 0) return;
    canvas_.begin_view(map_(visible_), project_.has_depth());
    if (project_.has_depth()) {
      paint_solids();
      const bool translucent =
          std::any_of(view_.meshes.begin(), view_.meshes.end(), [](const Mesh& m) { return m.opacity < 1; });
      if (translucent) {
        // What is behind shines through the veil; what is in front is painted once more on top of it.
        paint_lines_and_markers();
        for (const auto& mesh : view_.meshes) {
          if (mesh.opacity < 1) paint_mesh(mesh);
        }
      }
    } else {
      for (const auto& mesh : view_.meshes) paint_mesh(mesh);
      for (const auto& polygon : view_.polygons) paint_polygon(polygon);
    }
    paint_lines_and_markers();
    paint_labels(view_, project_, visible_, theme_, fonts_, canvas_, map_);
  }

 private:
  PixelPoint pixel(const PagePoint& p) const { return map_(p.x, p.y, p.depth); }
  bool near_page(const PagePoint& p) const {
    return p.x > guard_.x - 4000 && p.x < guard_.right() + 4000 && p.y > guard_.y - 4000 &&
           p.y < guard_.bottom() + 4000;
  }

  void add_mesh(const Mesh& mesh) {
    const std::size_t n = mesh.positions.size();
    const auto base = static_cast<std::uint32_t>(points_.size());
    std::vector<bool> drawable(n);
    const bool mapped = mesh.map != ColorMap::none && mesh.values.size() == n;
    for (std::size_t i = 0; i < n; ++i) {
      const auto p = project_(mesh.positions[i]);
      drawable[i] = p.has_value() && near_page(*p);
      points_.push_back(drawable[i] ? pixel(*p) : PixelPoint{});
      const Color color = mapped ? map_color(mesh.map, mesh.values[i]) : theme_[mesh.role].face;
      const bool lit = i < mesh.normals.size();
      colors_.push_back(lit ? shaded(color, mesh.normals[i], mesh.positions[i], mapped) : color);
    }
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
      const auto* corners = &mesh.indices[t];
      if (!std::all_of(corners, corners + 3, [&](std::uint32_t i) { return i < n && drawable[i]; })) continue;
      for (int k = 0; k < 3; ++k) indices_.push_back(base + corners[k]);
    }
  }

  // A headlight: bright where the surface faces the viewer, with a faint gloss. The colours of a map stay what they are
  // in its legend as far as one still sees the form.
  Color shaded(Color color, const glm::dvec3& normal, const glm::dvec3& position, bool mapped) const {
    const double facing = std::abs(glm::dot(normal, project_.to_viewer(position)));
    if (!(facing <= 1.01)) return color;
    const double dark = mapped ? 0.66 : 0.38;
    const double diffuse = dark + (1 - dark) * facing, gloss = mapped ? 0 : 0.22 * std::pow(facing, 24.0);
    const auto channel = [&](std::uint8_t c) {
      const double lit = c * diffuse;
      return static_cast<std::uint8_t>(std::lround(std::min(lit + (255 - lit) * gloss, 255.0)));
    };
    return {channel(color.r), channel(color.g), channel(color.b), color.a};
  }

  void flush_triangles(double opacity) {
    if (!indices_.empty()) canvas_.triangles(points_, colors_, indices_, opacity);
    points_.clear();
    colors_.clear();
    indices_.clear();
  }

  void paint_mesh(const Mesh& mesh) {
    add_mesh(mesh);
    flush_triangles(std::isfinite(mesh.opacity) ? std::clamp(mesh.opacity, 0.0, 1.0) : 1.0);
  }

  // All opaque faces of the view at once: a canvas without a depth buffer sorts them together.
  void paint_solids() {
    for (const auto& mesh : view_.meshes) {
      if (!(mesh.opacity < 1)) add_mesh(mesh);
    }
    for (const auto& polygon : view_.polygons) {
      if (!(polygon.opacity < 1)) add_fan(polygon);
    }
    flush_triangles(1);
    for (const auto& polygon : view_.polygons) {
      if (!(polygon.opacity < 1)) continue;
      add_fan(polygon);
      flush_triangles(std::max(polygon.opacity, 0.0));
    }
  }

  void add_fan(const Polygon& polygon) {
    const auto base = static_cast<std::uint32_t>(points_.size());
    for (const auto& position : polygon.points) {
      const auto p = project_(position);
      if (!p || !near_page(*p)) return points_.resize(base), colors_.resize(base);
      points_.push_back(pixel(*p));
      colors_.push_back(theme_[polygon.role].color);
    }
    for (std::uint32_t i = 2; i < polygon.points.size(); ++i) {
      for (const std::uint32_t k : {0u, i - 1, i}) indices_.push_back(base + k);
    }
  }

  void paint_polygon(const Polygon& polygon) {
    std::vector<PagePoint> corners;
    for (const auto& position : polygon.points) {
      if (const auto p = project_(position)) corners.push_back(*p);
    }
    corners = clip_polygon(std::move(corners), guard_);
    std::vector<PixelPoint> pixels;
    for (const auto& corner : corners) pixels.push_back(pixel(corner));
    if (pixels.size() > 2) canvas_.polygon(pixels, faded(theme_[polygon.role].color, polygon.opacity));
  }

  void paint_lines_and_markers() {
    for (const auto& line : view_.polylines) paint_line(line);
    // Of markers, too, the nearest is on top.
    std::vector<std::size_t> order(view_.markers.size());
    std::iota(order.begin(), order.end(), 0);
    if (project_.has_depth()) {
      std::vector<double> depths;
      for (const auto& marker : view_.markers) {
        const auto p = project_(marker.position);
        depths.push_back(p ? p->depth : 0);
      }
      std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return depths[a] > depths[b]; });
    }
    for (const std::size_t i : order) paint_marker(view_.markers[i]);
  }

  void paint_line(const Polyline& line) {
    const RoleStyle& style = theme_[line.role];
    const double width = style.line_width * factor(line.width_scale);
    Stroke stroke{style.color, static_cast<float>(width * scale_), 0, 0};
    if (style.gap > 0) {
      stroke.dash = static_cast<float>(style.dash * scale_);
      stroke.gap = static_cast<float>((style.gap + width) * scale_);  // round caps eat one width of the pause
    } else if (line.dashed) {
      stroke.dash = static_cast<float>((3 + 1.5 * width) * scale_);
      stroke.gap = static_cast<float>((2.5 + 2 * width) * scale_);
    }
    auto pieces = clip_line(project_, line, line_pull, guard_);
    const auto head = line.arrow && !pieces.empty() ? cut_arrow(pieces.back().points, width) : std::vector<PagePoint>{};
    for (const auto& piece : pieces) {
      std::vector<PixelPoint> pixels;
      pixels.reserve(piece.points.size());
      for (const auto& p : piece.points) pixels.push_back(pixel(p));
      canvas_.polyline(pixels, piece.closed, stroke);
    }
    if (!head.empty()) {
      std::vector<PixelPoint> pixels;
      for (const auto& p : head) pixels.push_back(pixel(p));
      canvas_.polygon(pixels, style.color);
    }
  }

  // Shortens the line by the arrow head at its end and gives the head's three corners.
  static std::vector<PagePoint> cut_arrow(std::vector<PagePoint>& line, double width) {
    const double length = 6 + 2.6 * width, half = 0.38 * length;
    const PagePoint tip = line.back();
    // The head's back is where the line enters the circle around the tip.
    std::size_t i = line.size() - 1;
    while (i > 0 && std::hypot(line[i - 1].x - tip.x, line[i - 1].y - tip.y) < length) --i;
    PagePoint back = line.front();
    if (i > 0) {
      const PagePoint a = line[i - 1], b = line[i];
      double low = 0, high = 1;
      for (int step = 0; step < 30; ++step) {
        const double t = (low + high) / 2;
        (std::hypot(a.x + t * (b.x - a.x) - tip.x, a.y + t * (b.y - a.y) - tip.y) > length ? low : high) = t;
      }
      back = {a.x + low * (b.x - a.x), a.y + low * (b.y - a.y), a.depth + low * (b.depth - a.depth)};
    }
    const double dx = tip.x - back.x, dy = tip.y - back.y, size = std::hypot(dx, dy);
    if (!(size > 1e-6)) return {};
    line.resize(std::max<std::size_t>(i, 1));
    // The line ends inside the head, its round cap hidden by it.
    line.push_back({back.x + 0.3 * dx, back.y + 0.3 * dy, back.depth});
    const double nx = -dy / size * half, ny = dx / size * half;
    return {tip, {back.x + nx, back.y + ny, back.depth}, {back.x - nx, back.y - ny, back.depth}};
  }

  void paint_marker(const Marker& marker) {
    const auto p = project_(marker.position, marker_pull);
    if (!p || !contains(guard_, p->x, p->y)) return;
    const RoleStyle& style = theme_[marker.role];
    const Marker::Shape shape = marker.shape == Marker::Shape::disc ? style.marker_shape : marker.shape;
    MarkerPaint paint;
    paint.radius = static_cast<float>(style.marker_size / 2 * factor(marker.size_scale) * scale_);
    paint.fill = style.color;
    paint.outline = theme_.background;
    paint.outline_width = static_cast<float>(1.3 * scale_);
    canvas_.marker(pixel(*p), shape, paint);
  }

  const View& view_;
  const Theme& theme_;
  const Fonts& fonts_;
  Canvas& canvas_;
  PageMap map_;
  double scale_;
  Projection project_;
  PixelRect visible_, guard_;
  std::vector<PixelPoint> points_;  // of the triangles being gathered
  std::vector<Color> colors_;
  std::vector<std::uint32_t> indices_;
};

void paint_part(const View& view, const PixelRect& page, const Theme& theme, const Fonts& fonts, Canvas& canvas,
                const PageMap& map) {
  const bool finite =
      std::isfinite(view.x) && std::isfinite(view.y) && std::isfinite(view.width) && std::isfinite(view.height);
  if (finite && view.width > 0 && view.height > 0) ViewPainter(view, page, theme, fonts, canvas, map).paint();
}

}  // namespace

Checked<Frame> frame_of(const Scene& scene, const Theme& theme, double scale, int largest) {
  const double width = scene.width * scale, height = scene.height * scale;
  const bool fits = width >= 0.5 && height >= 0.5 && width <= largest && height <= largest && width * height <= 64e6;
  if (!(fits && scale > 0)) {
    return Diagnostics{{"", 0, 0, "",
                        "a picture of " + format_short(width, 1) + " x " + format_short(height, 1) +
                            " pixels cannot be drawn; each side must be 1 to " + std::to_string(largest) +
                            ", and all of it at most 64 million pixels"}};
  }
  return Frame{std::max(1, static_cast<int>(std::lround(width))), std::max(1, static_cast<int>(std::lround(height))),
               theme.background, scene.title, scene.description};
}

void paint_view(const View& view, const Theme& theme, const Fonts& fonts, Canvas& canvas, double scale,
                glm::dvec2 origin, const PixelRect& clip) {
  assert(scale > 0);
  const PageMap map{scale, {std::round(origin.x), std::round(origin.y)}};
  paint_part(view, map.back(clip), theme, fonts, canvas, map);
}

void paint(const Scene& scene, const Theme& theme, const Fonts& fonts, Canvas& canvas, double scale) {
  const auto frame = frame_of(scene, theme, scale);
  assert(frame);
  canvas.begin(*frame);
  for (const auto& view : scene.views) {
    paint_part(view, {0, 0, scene.width, scene.height}, theme, fonts, canvas, {scale, {0, 0}});
  }
  canvas.finish();
}

}  // namespace blossom
