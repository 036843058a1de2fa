#include "render/svg_canvas.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>

#include "render/dash.hpp"
#include "render/font.hpp"

namespace blossom {
namespace {

// At most two decimals, no trailing zeros, no negative zero.
std::string number(double value) {
  const double rounded = std::round(value * 100) / 100;
  std::array<char, 64> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), rounded == 0 ? 0.0 : rounded,
                                 std::chars_format::fixed, 2);
  std::string text(buffer.data(), end.ptr);
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string attribute(const char* name, double value) { return std::string(" ") + name + "=\"" + number(value) + "\""; }

std::string hex(Color c) {
  constexpr const char* digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t channel : {c.r, c.g, c.b}) {
    text += digits[channel >> 4];
    text += digits[channel & 15];
  }
  return text;
}

// fill="#rrggbb", with fill-opacity when it is translucent.
std::string paint(const char* name, Color c) {
  std::string text = std::string(" ") + name + "=\"" + hex(c) + "\"";
  if (c.a < 255) text += std::string(" ") + name + "-opacity=\"" + number(c.a / 255.0) + "\"";
  return text;
}

// What XML 1.0 cannot hold, even escaped, becomes U+FFFD.
std::string escape(std::string_view text) {
  std::string result;
  for (const char32_t c : decode_utf8(text)) {
    switch (c) {
      case U'&':
        result += "&amp;";
        break;
      case U'<':
        result += "&lt;";
        break;
      case U'>':
        result += "&gt;";
        break;
      case U'"':
        result += "&quot;";
        break;
      default: {
        const bool allowed = c == '\t' || c == '\n' || (c >= 0x20 && c != 0x7F && c != 0xFFFE && c != 0xFFFF);
        result += encode_utf8(allowed ? c : U'\uFFFD');
      }
    }
  }
  return result;
}

std::string place(const PixelPoint& p) { return number(p.x) + " " + number(p.y); }

std::string outline_of(std::span<const PixelPoint> points, bool closed) {
  std::string d = "M" + place(points[0]);
  for (std::size_t i = 1; i < points.size(); ++i) d += "L" + place(points[i]);
  return closed ? d + "Z" : d;
}

}  // namespace

void SvgCanvas::begin(const Frame& frame) {
  frame_ = frame;
  views_ = 0;
  in_view_ = depth_ = false;
  const std::string width = std::to_string(frame.width), height = std::to_string(frame.height);
  out_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width +
         "\" height=\"" + height + "\" viewBox=\"0 0 " + width + " " + height +
         "\" role=\"img\" aria-labelledby=\"title desc\" font-family=\"DejaVu Sans, Verdana, sans-serif\" "
         "fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n<title id=\"title\">" +
         escape(frame.title) + "</title>\n<desc id=\"desc\">" + escape(frame.description) + "</desc>\n<rect width=\"" +
         width + "\" height=\"" + height + "\"" + paint("fill", frame.background) + "/>\n";
}

void SvgCanvas::end_view() {
  if (in_view_) out_ += "</g>\n";
  in_view_ = false;
}

void SvgCanvas::begin_view(const PixelRect& clip, bool depth) {
  end_view();
  const std::string name = "view" + std::to_string(++views_);
  out_ += "<clipPath id=\"" + name + "\"><rect" + attribute("x", clip.x) + attribute("y", clip.y) +
          attribute("width", clip.width) + attribute("height", clip.height) + "/></clipPath>\n<g clip-path=\"url(#" +
          name + ")\">\n";
  in_view_ = true;
  depth_ = depth;
  if (!depth) return;
  left_ = static_cast<int>(std::floor(clip.x));
  top_ = static_cast<int>(std::floor(clip.y));
  columns_ = std::max(1, static_cast<int>(std::ceil(clip.right())) - left_);
  rows_ = std::max(1, static_cast<int>(std::ceil(clip.bottom())) - top_);
  nearest_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 2.0f);
}

bool SvgCanvas::hidden(float x, float y, float depth) const {
  const float column = std::floor(x) - static_cast<float>(left_), row = std::floor(y) - static_cast<float>(top_);
  if (!depth_ || column < 0 || row < 0 || column >= static_cast<float>(columns_) || row >= static_cast<float>(rows_)) {
    return false;
  }
  return depth > nearest_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                          static_cast<std::size_t>(column)];
}

void SvgCanvas::fill_depth(const PixelPoint& a, const PixelPoint& b, const PixelPoint& c) {
  const double area = (double{b.x} - a.x) * (double{c.y} - a.y) - (double{b.y} - a.y) * (double{c.x} - a.x);
  if (area == 0) return;
  const auto range = [](float low, float high, int origin, int limit) {
    return std::pair{std::max(0, static_cast<int>(std::floor(low)) - origin),
                     std::min(limit - 1, static_cast<int>(std::ceil(high)) - origin)};
  };
  const auto [x0, x1] = range(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), left_, columns_);
  const auto [y0, y1] = range(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), top_, rows_);
  for (int row = y0; row <= y1; ++row) {
    for (int column = x0; column <= x1; ++column) {
      const double x = left_ + column + 0.5, y = top_ + row + 0.5;
      const double wb = ((x - a.x) * (double{c.y} - a.y) - (y - a.y) * (double{c.x} - a.x)) / area;
      const double wc = ((double{b.x} - a.x) * (y - a.y) - (double{b.y} - a.y) * (x - a.x)) / area;
      if (wb < 0 || wc < 0 || wb + wc > 1) continue;
      auto& cell = nearest_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                            static_cast<std::size_t>(column)];
      cell = std::min(cell, static_cast<float>(a.depth + wb * (b.depth - a.depth) + wc * (c.depth - a.depth)));
    }
  }
}

void SvgCanvas::path(std::span<const PixelPoint> points, bool closed, const Stroke& stroke) {
  out_ += "<path d=\"" + outline_of(points, closed) + "\"" + paint("stroke", stroke.color) +
          attribute("stroke-width", stroke.width);
  if (stroke.gap > 0) {
    // Dashes of no length are drawn as dots by round caps, but not by every viewer.
    out_ += " stroke-dasharray=\"" + number(std::max(stroke.dash, 0.01f)) + " " + number(stroke.gap) + "\"";
  }
  out_ += "/>\n";
}

void SvgCanvas::polyline(std::span<const PixelPoint> points, bool closed, const Stroke& stroke) {
  if (points.size() < 2) return;
  if (!depth_) return path(points, closed, stroke);
  Stroke solid = stroke;
  solid.dash = solid.gap = 0;
  if (stroke.gap > 0) {
    for (const auto& piece : split_dashes(points, closed, stroke.dash, stroke.gap)) visible_parts(piece, solid);
    return;
  }
  std::vector<PixelPoint> line(points.begin(), points.end());
  if (closed) line.push_back(line.front());
  visible_parts(line, solid);
}

void SvgCanvas::visible_parts(std::span<const PixelPoint> points, const Stroke& stroke) {
  std::vector<PixelPoint> part;
  const auto flush = [&] {
    if (part.size() > 1) path(part, false, stroke);
    part.clear();
  };
  if (points.size() == 1 && !hidden(points[0].x, points[0].y, points[0].depth)) part = {points[0], points[0]};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const PixelPoint a = points[i], b = points[i + 1];
    const int steps = std::max(1, static_cast<int>(std::ceil(std::hypot(b.x - a.x, b.y - a.y))));
    for (int k = i == 0 ? 0 : 1; k <= steps; ++k) {
      const float t = static_cast<float>(k) / static_cast<float>(steps);
      const PixelPoint p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.depth + t * (b.depth - a.depth)};
      if (hidden(p.x, p.y, p.depth)) {
        flush();
        continue;
      }
      // Of a straight visible stretch only the ends are kept: an inner step replaces the one before it.
      if (k >= 2 && part.size() >= 2) {
        part.back() = p;
      } else {
        part.push_back(p);
      }
    }
  }
  flush();
}

void SvgCanvas::polygon(std::span<const PixelPoint> points, Color color) {
  if (points.size() < 3) return;
  PixelPoint centre;
  for (const auto& p : points) {
    const auto n = static_cast<float>(points.size());
    centre = {centre.x + p.x / n, centre.y + p.y / n, centre.depth + p.depth / n};
  }
  if (hidden(centre.x, centre.y, centre.depth)) return;
  out_ += "<path d=\"" + outline_of(points, true) + "\"" + paint("fill", color) + "/>\n";
}

void SvgCanvas::marker(const PixelPoint& at, Marker::Shape shape, const MarkerPaint& look) {
  if (hidden(at.x, at.y, at.depth)) return;
  const float r = look.radius, rim = look.outline_width;
  const auto circle = [&](float radius) {
    return "<circle" + attribute("cx", at.x) + attribute("cy", at.y) + attribute("r", radius);
  };
  const auto shape_path = [&](std::initializer_list<std::array<float, 2>> corners) {
    std::vector<PixelPoint> points;
    for (const auto& [x, y] : corners) points.push_back({at.x + x, at.y + y, 0});
    return "<path d=\"" + outline_of(points, true) + "\"";
  };
  // The rim lies under the fill and reaches out by its width.
  const auto filled = [&](const std::string& element) {
    if (rim > 0)
      out_ += element + paint("fill", look.outline) + paint("stroke", look.outline) +
              attribute("stroke-width", 2 * rim) + "/>\n";
    out_ += element + paint("fill", look.fill) + "/>\n";
  };
  const auto stroked = [&](const std::string& element, float width) {
    if (rim > 0) out_ += element + paint("stroke", look.outline) + attribute("stroke-width", width + 2 * rim) + "/>\n";
    out_ += element + paint("stroke", look.fill) + attribute("stroke-width", width) + "/>\n";
  };
  const float side = 0.86f * r, corner = 1.2162f * r, arm = 0.7778f * r;
  switch (shape) {
    case Marker::Shape::disc:
      return filled(circle(r));
    case Marker::Shape::ring:
      return stroked(circle(0.8f * r), 0.4f * r);
    case Marker::Shape::square:
      return filled(shape_path({{-side, -side}, {side, -side}, {side, side}, {-side, side}}));
    case Marker::Shape::diamond:
      return filled(shape_path({{0, -corner}, {corner, 0}, {0, corner}, {-corner, 0}}));
    case Marker::Shape::triangle:
      return filled(shape_path({{0, -1.3f * r}, {1.1258f * r, 0.65f * r}, {-1.1258f * r, 0.65f * r}}));
    case Marker::Shape::cross: {
      const auto bar = [&](float dx, float dy) {
        return "M" + place({at.x - dx, at.y - dy, 0}) + "L" + place({at.x + dx, at.y + dy, 0});
      };
      return stroked("<path stroke-linecap=\"butt\" d=\"" + bar(arm, arm) + bar(arm, -arm) + "\"", 0.48f * r);
    }
  }
}

void SvgCanvas::triangles(std::span<const PixelPoint> points, std::span<const Color> colors,
                          std::span<const std::uint32_t> indices, double opacity) {
  const std::size_t count = indices.size() / 3;
  if (count == 0) return;
  const auto corner = [&](std::size_t triangle, std::size_t k) -> const PixelPoint& {
    return points[indices[3 * triangle + k]];
  };
  const auto mean_depth = [&](std::size_t t) {
    return (corner(t, 0).depth + corner(t, 1).depth + corner(t, 2).depth) / 3;
  };
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  if (depth_) {
    // What stands behind earlier triangles is left out; the rest is painted from back to front.
    std::erase_if(order, [&](std::size_t t) {
      const auto &a = corner(t, 0), &b = corner(t, 1), &c = corner(t, 2);
      return hidden((a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, mean_depth(t));
    });
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return mean_depth(a) > mean_depth(b); });
  }
  // Each triangle has a thin rim of its own colour, so that no seams shine through.
  out_ += "<g stroke-width=\"0.6\"";
  if (opacity < 1) out_ += attribute("opacity", opacity);
  out_ += ">\n";
  for (const std::size_t t : order) {
    int r = 0, g = 0, b = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Color c = colors[indices[3 * t + k]];
      r += c.r, g += c.g, b += c.b;
    }
    const auto third = [](int sum) { return static_cast<std::uint8_t>((sum + 1) / 3); };
    const std::string color = hex({third(r), third(g), third(b)});
    const std::array outline = {corner(t, 0), corner(t, 1), corner(t, 2)};
    out_ += "<path d=\"" + outline_of(outline, true) + "\" fill=\"" + color + "\" stroke=\"" + color + "\"/>\n";
  }
  out_ += "</g>\n";
  if (!depth_) return;
  for (std::size_t t = 0; t < count; ++t) fill_depth(corner(t, 0), corner(t, 1), corner(t, 2));
}

void SvgCanvas::runs(std::span<const GlyphRun> all) {
  for (const auto& run : all) {
    out_ += "<tspan" + attribute("x", run.x) + attribute("y", run.baseline) + attribute("font-size", run.size);
    if (run.style.bold) out_ += " font-weight=\"bold\"";
    if (run.style.italic) out_ += " font-style=\"italic\"";
    if (run.style.monospace) out_ += " font-family=\"DejaVu Sans Mono, monospace\"";
    out_ += ">" + escape(run.text) + "</tspan>";
  }
  out_ += "</text>\n";
}

void SvgCanvas::text(std::span<const GlyphRun> all, const TextPaint& look) {
  if (all.empty()) return;
  if (look.halo_width > 0) {
    out_ += "<text aria-hidden=\"true\" xml:space=\"preserve\"" + paint("stroke", look.halo) +
            attribute("stroke-width", 2 * look.halo_width) + ">";
    runs(all);
  }
  out_ += "<text xml:space=\"preserve\"" + paint("fill", look.color) + ">";
  runs(all);
}

void SvgCanvas::finish() {
  end_view();
  out_ += "</svg>\n";
}

}  // namespace blossom
