#include "render/svg_canvas.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "render/font.hpp"
#include "render/marker_form.hpp"

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
  in_view_ = false;
  cells_.begin_view({}, false);
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
  cells_.begin_view(clip, depth);
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
  cells_.visible_parts(points, closed, stroke,
                       [&](auto part, bool part_closed, const Stroke& look) { path(part, part_closed, look); });
}

void SvgCanvas::polygon(std::span<const PixelPoint> points, Color color) {
  if (points.size() < 3 || cells_.hidden_polygon(points)) return;
  out_ += "<path d=\"" + outline_of(points, true) + "\"" + paint("fill", color) + "/>\n";
}

void SvgCanvas::marker(const PixelPoint& at, Marker::Shape shape, const MarkerPaint& look) {
  if (cells_.hidden(at)) return;
  const MarkerForm form = marker_form(at, shape, look.radius);
  const float rim = look.outline_width;
  std::string element;
  if (form.circle > 0) {
    element = "<circle" + attribute("cx", at.x) + attribute("cy", at.y) + attribute("r", form.circle);
  } else {
    element = form.stroke > 0 ? "<path stroke-linecap=\"butt\" d=\"" : "<path d=\"";
    for (const auto& line : form.lines) element += outline_of(line, form.stroke == 0);
    element += "\"";
  }
  if (form.stroke > 0) {
    if (rim > 0)
      out_ += element + paint("stroke", look.outline) + attribute("stroke-width", form.stroke + 2 * rim) + "/>\n";
    out_ += element + paint("stroke", look.fill) + attribute("stroke-width", form.stroke) + "/>\n";
    return;
  }
  if (rim > 0)
    out_ += element + paint("fill", look.outline) + paint("stroke", look.outline) + attribute("stroke-width", 2 * rim) +
            "/>\n";
  out_ += element + paint("fill", look.fill) + "/>\n";
}

void SvgCanvas::triangles(std::span<const PixelPoint> points, std::span<const Color> colors,
                          std::span<const std::uint32_t> indices, double opacity) {
  if (indices.size() < 3) return;
  // Each triangle has a thin rim of its own colour, so that no seams shine through.
  out_ += "<g stroke-width=\"0.6\"";
  if (opacity < 1) out_ += attribute("opacity", opacity);
  out_ += ">\n";
  for (const auto& triangle : cells_.in_order(points, colors, indices)) {
    const std::string color = hex(triangle.color);
    out_ +=
        "<path d=\"" + outline_of(triangle.corners, true) + "\" fill=\"" + color + "\" stroke=\"" + color + "\"/>\n";
  }
  out_ += "</g>\n";
  cells_.add(points, indices);
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
