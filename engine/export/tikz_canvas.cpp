#include "export/tikz_canvas.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "render/marker_form.hpp"

namespace blossom {
namespace {

// At most so many decimals, no trailing zeros, no negative zero.
std::string number(double value, int decimals = 1) {
  const double unit = std::pow(10.0, decimals), rounded = std::round(value * unit) / unit;
  std::array<char, 400> buffer;
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), rounded == 0 ? 0.0 : rounded,
                                 std::chars_format::fixed, decimals);
  std::string text(buffer.data(), end.ptr);
  if (decimals == 0) return text;
  while (text.back() == '0') text.pop_back();
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string place(const PixelPoint& p) { return "(" + number(p.x) + "," + number(p.y) + ")"; }

// Douglas and Peucker (1973): of a line the points without which it would leave its place by more than this.
std::vector<PixelPoint> simplified(std::span<const PixelPoint> points, double tolerance) {
  std::vector<bool> kept(points.size());
  kept.front() = kept.back() = true;
  std::vector<std::array<std::size_t, 2>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const PixelPoint &a = points[first], &b = points[last];
    const double dx = double{b.x} - a.x, dy = double{b.y} - a.y, length = std::hypot(dx, dy);
    double farthest = tolerance;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double x = double{points[i].x} - a.x, y = double{points[i].y} - a.y;
      const double distance = length > 1e-9 ? std::abs(x * dy - y * dx) / length : std::hypot(x, y);
      // Beyond the ends a line turns back, and that is seen, too.
      const double along = length > 1e-9 ? (x * dx + y * dy) / length : 0;
      const double off = std::max({distance, -along, along - length});
      if (off > farthest) farthest = off, at = i;
    }
    if (at == first) continue;
    kept[at] = true;
    open.push_back({first, at});
    open.push_back({at, last});
  }
  std::vector<PixelPoint> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) result.push_back(points[i]);
  return result;
}

std::string outline_of(std::span<const PixelPoint> points, bool closed) {
  std::string text = place(points[0]);
  for (const auto& p : points.subspan(1)) text += " -- " + place(p);
  return closed ? text + " -- cycle" : text;
}

// Sizes for which there are letters without asking for others: those of the standard classes.
double standard_size(double points) {
  static constexpr std::array sizes = {5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 10.95, 12.0, 14.4, 17.28, 20.74, 24.88};
  return *std::ranges::min_element(sizes, {}, [points](double size) { return std::abs(size - points); });
}

// Two triangles that share an edge and lie side by side, as one outline; empty if they do not.
std::vector<PixelPoint> joined(const FlatTriangle& a, const FlatTriangle& b) {
  const auto same = [](const PixelPoint& p, const PixelPoint& q) { return p.x == q.x && p.y == q.y; };
  const auto missing = [&](const FlatTriangle& in, const FlatTriangle& from) {
    int at = -1, count = 0;
    for (int k = 0; k < 3; ++k) {
      const auto& corner = in.corners[static_cast<std::size_t>(k)];
      if (std::ranges::none_of(from.corners, [&](const auto& other) { return same(corner, other); })) at = k, ++count;
    }
    return count == 1 ? at : -1;
  };
  const int lone = missing(a, b), other = missing(b, a);
  if (lone < 0 || other < 0) return {};
  const auto corner = [&](int k) { return a.corners[static_cast<std::size_t>((lone + k) % 3)]; };
  std::vector<PixelPoint> outline{corner(0), corner(1), b.corners[static_cast<std::size_t>(other)], corner(2)};
  // A fold is no face: all turns must go one way.
  int left = 0, right = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto &p = outline[i], &q = outline[(i + 1) % 4], &r = outline[(i + 2) % 4];
    const double turn = (double{q.x} - p.x) * (double{r.y} - q.y) - (double{q.y} - p.y) * (double{r.x} - q.x);
    (turn < 0 ? left : right) += turn == 0 ? 0 : 1;
  }
  return left > 0 && right > 0 ? std::vector<PixelPoint>{} : outline;
}

bool alike(Color a, Color b) { return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b) < 24; }

}  // namespace

TikzCanvas::TikzCanvas(std::shared_ptr<const Fonts> fonts, double points_per_pixel)
    : fonts_(std::move(fonts)), points_(points_per_pixel) {}

std::string TikzCanvas::preamble(const Colors& colors) {
  std::string text =
      "% A face: its colour, then its corners.\n"
      "\\makeatletter\n"
      "\\def\\blossomface#1 #2 #3 {\\pgfsys@color@rgb#1\\pgfpathmoveto{\\pgfqpointxy{#2}{#3}}\\blossomcorner}\n"
      "\\def\\blossomcorner#1 #2 {\\pgfpathlineto{\\pgfqpointxy{#1}{#2}}"
      "\\@ifnextchar;{\\pgfpathclose\\pgfusepathqfillstroke\\@gobble}{\\blossomcorner}}\n"
      "\\makeatother\n";
  for (const auto& color : colors) text += "\\definecolor{b" + color + "}{HTML}{" + color + "}\n";
  return text;
}

std::string TikzCanvas::color(Color c) {
  constexpr const char* digits = "0123456789ABCDEF";
  std::string name;
  for (const std::uint8_t channel : {c.r, c.g, c.b}) {
    name += digits[channel >> 4];
    name += digits[channel & 15];
  }
  colors_.insert(name);
  return "b" + name;
}

std::string TikzCanvas::options(const char* key, Color c) {
  std::string text = std::string(key) + "=" + color(c);
  if (c.a < 255) text += ",opacity=" + number(c.a / 255.0, 2);
  return text;
}

std::string TikzCanvas::length(double pixels) const { return number(pixels * points_, 2) + "pt"; }

void TikzCanvas::begin(const Frame& frame) {
  const std::string corner = "(" + std::to_string(frame.width) + "," + std::to_string(frame.height) + ")";
  out_ = "\\begin{tikzpicture}[x=" + number(points_, 3) + "pt,y=-" + number(points_, 3) +
         "pt,line cap=round,line join=round,every node/.style={inner sep=0.8pt,rounded corners=1pt}]\n"
         "\\useasboundingbox (0,0) rectangle " +
         corner + ";\n";
  if (frame.background != Color{255, 255, 255, 255})
    out_ += "\\fill[" + options("fill", frame.background) + "] (0,0) rectangle " + corner + ";\n";
  in_view_ = false;
  cells_.begin_view({}, false);
}

void TikzCanvas::end_view() {
  if (in_view_) out_ += "\\end{scope}\n";
  in_view_ = false;
}

void TikzCanvas::begin_view(const PixelRect& clip, bool depth) {
  end_view();
  out_ += "\\begin{scope}\n\\clip (" + number(clip.x) + "," + number(clip.y) + ") rectangle (" + number(clip.right()) +
          "," + number(clip.bottom()) + ");\n";
  in_view_ = true;
  cells_.begin_view(clip, depth);
}

void TikzCanvas::polyline(std::span<const PixelPoint> points, bool closed, const Stroke& stroke) {
  cells_.visible_parts(points, closed, stroke, [&](auto part, bool part_closed, const Stroke& look) {
    out_ += "\\draw[" + options("draw", look.color) + ",line width=" + length(look.width);
    if (look.gap > 0) out_ += ",dash pattern=on " + length(std::max(look.dash, 0.1f)) + " off " + length(look.gap);
    out_ += "] " + outline_of(simplified(part, 0.1), part_closed) + ";\n";
  });
}

void TikzCanvas::polygon(std::span<const PixelPoint> points, Color c) {
  if (points.size() < 3 || cells_.hidden_polygon(points)) return;
  out_ += "\\fill[" + options("fill", c) + "] " + outline_of(points, true) + ";\n";
}

void TikzCanvas::marker(const PixelPoint& at, Marker::Shape shape, const MarkerPaint& look) {
  if (cells_.hidden(at)) return;
  const MarkerForm form = marker_form(at, shape, look.radius);
  std::string path;
  if (form.circle > 0) path = " " + place(at) + " circle[radius=" + length(form.circle) + "]";
  for (const auto& line : form.lines) path += " " + outline_of(line, form.stroke == 0);
  const std::string cap = form.circle == 0 && form.stroke > 0 ? ",line cap=butt" : "";
  // The rim lies under the form and reaches out of it.
  if (look.outline_width > 0)
    out_ += "\\draw[" + options("draw", look.outline) + ",line width=" + length(form.stroke + 2 * look.outline_width) +
            cap + "]" + path + ";\n";
  if (form.stroke > 0)
    out_ += "\\draw[" + options("draw", look.fill) + ",line width=" + length(form.stroke) + cap + "]" + path + ";\n";
  else
    out_ += "\\fill[" + options("fill", look.fill) + "]" + path + ";\n";
}

void TikzCanvas::triangles(std::span<const PixelPoint> points, std::span<const Color> colors,
                           std::span<const std::uint32_t> indices, double opacity) {
  if (indices.size() < 3) return;
  const auto order = cells_.in_order(points, colors, indices);
  // Each face has a thin rim of its own colour, so that no seams shine through.
  out_ += "\\begin{scope}[line width=0.2pt";
  if (opacity < 1) out_ += ",transparency group,opacity=" + number(opacity, 2);
  out_ += "]\n";
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::vector<PixelPoint> outline;
    if (i + 1 < order.size() && alike(order[i].color, order[i + 1].color)) outline = joined(order[i], order[i + 1]);
    const Color c = order[i].color;
    if (outline.empty())
      outline.assign(order[i].corners.begin(), order[i].corners.end());
    else
      ++i;
    out_ += "\\blossomface{" + number(c.r / 255.0, 2) + "}{" + number(c.g / 255.0, 2) + "}{" + number(c.b / 255.0, 2) +
            "} ";
    for (const auto& p : outline) out_ += number(p.x) + " " + number(p.y) + " ";
    out_ += ";\n";
  }
  out_ += "\\end{scope}\n";
  cells_.add(points, indices);
}

void TikzCanvas::text(std::span<const GlyphRun> runs, const TextPaint& look) {
  for (const auto& line : latex_lines(*fonts_, runs)) {
    const double size = standard_size(line.size * points_);
    out_ += "\\node[anchor=base,text=" + color(look.color);
    if (look.halo_width > 0) out_ += ",fill=" + color(look.halo) + ",fill opacity=0.8,text opacity=1";
    out_ += ",font=\\fontsize{" + number(size, 2) + "}{" + number(1.2 * size, 2) + "}\\selectfont] at (" +
            number(line.x) + "," + number(line.baseline) + ") {" + line.text + "};\n";
  }
}

void TikzCanvas::finish() {
  end_view();
  out_ += "\\end{tikzpicture}\n";
}

}  // namespace blossom
