#include "export/html_canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/json.hpp"
#include "render/marker_form.hpp"

namespace blossom {
namespace {

constexpr std::array<std::string_view, role_count> role_names{
    "grid",    "axis",     "curve",    "made",     "polygon",  "point",    "earlier",   "level-a",  "level-b",
    "level-c", "operand",  "current",  "near",     "far",      "result",   "retired",   "surface",  "isoline",
    "panel",   "rule",     "text",     "quiet",    "strong",   "now",      "highlight", "right",    "mistake",
    "focus",   "object-0", "object-1", "object-2", "object-3", "object-4", "object-5",  "object-6", "object-7"};

// Probe colours. Plain ones are (role, 1, kind). Those of faces are (255, 0, 7 role): whatever the light does to a
// channel c is share * c + gloss, so the first two channels tell both, and the third which role it is.
constexpr std::uint8_t plain = 1, ink = 2, ground = 3;
constexpr int least_lit = 60, role_step = 7, share_steps = 40, gloss_step = 6;

Theme make_probe() {
  Theme probe = light_theme();
  probe.name = "probe";
  probe.background = {0, 1, ground};
  for (std::size_t i = 0; i < probe.roles.size(); ++i) {
    const auto role = static_cast<std::uint8_t>(i);
    probe.roles[i].color = {role, 1, plain};
    probe.roles[i].ink = {role, 1, ink};
    probe.roles[i].face = {255, 0, static_cast<std::uint8_t>(role_step * role)};
  }
  return probe;
}

std::string hex(Color c) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t channel : {c.r, c.g, c.b}) {
    text += digits[channel >> 4];
    text += digits[channel & 15];
  }
  return text;
}

// Places are whole tenths of a unit.
long tenths(double value) { return std::isfinite(value) ? std::lround(std::clamp(value, -1e6, 1e6) * 10) : 0; }

std::string number(long tenth) {
  std::string text = tenth < 0 ? "-" : "";
  const long size = std::abs(tenth);
  if (size >= 10 || size == 0) text += std::to_string(size / 10);
  if (size % 10 != 0) text += "." + std::to_string(size % 10);
  return text;
}
// JSON wants a digit before the point.
std::string json_place(double value) {
  const long tenth = tenths(value);
  return tenth != 0 && std::abs(tenth) < 10 ? (tenth < 0 ? "-0." : "0.") + std::to_string(std::abs(tenth))
                                            : number(tenth);
}
std::string decimals(double value) { return format_short(value, 2); }

void append_pair(std::string& d, long x, long y) {
  const std::string second = number(y);
  d += number(x) + (second[0] == '-' ? "" : " ") + second;
}

std::string outline_of(std::span<const PixelPoint> points, bool closed) {
  std::string d = "M";
  long x = tenths(points[0].x), y = tenths(points[0].y);
  append_pair(d, x, y);
  bool first = true;
  for (const PixelPoint& p : points.subspan(1)) {
    const long to_x = tenths(p.x), to_y = tenths(p.y);
    if (to_x == x && to_y == y && !(first && points.size() == 2)) continue;
    const std::string step = number(to_x - x);
    d += first ? "l" : step[0] == '-' ? "" : " ";
    append_pair(d, to_x - x, to_y - y);
    first = false;
    x = to_x;
    y = to_y;
  }
  return closed ? d + "z" : d;
}

std::string alpha(const char* property, Color c) {
  return c.a < 255 ? std::string(property) + "-opacity:" + decimals(c.a / 255.0) + ";" : "";
}

}  // namespace

std::string_view role_name(Role role) { return role_names[static_cast<std::size_t>(role)]; }

// ---- looks ----------------------------------------------------------------------------------------------------------

const Theme& HtmlLooks::probe() {
  static const Theme probe = make_probe();
  return probe;
}

std::string HtmlLooks::variable(Color c) {
  if (c.r < least_lit) {
    if (c.b == ground) return "--ground";
    return "--" + std::string(role_names[std::min<std::size_t>(c.r, role_count - 1)]) + (c.b == ink ? "-ink" : "");
  }
  const double share = std::max((c.r - c.g) / 255.0, 0.01);
  Shade shade;
  shade.role = std::clamp(static_cast<int>(std::lround((c.b - c.g) / share / role_step)), 0, role_count - 1);
  shade.share = static_cast<int>(std::lround(share * share_steps));
  shade.gloss = (c.g + gloss_step / 2) / gloss_step;
  return "--m" + std::to_string(shades_.emplace(shade, shades_.size()).first->second);
}

std::string HtmlLooks::style(const std::string& declarations) {
  const auto [found, added] = styles_.emplace(declarations, in_order_.size());
  if (added) in_order_.push_back(declarations);
  return "s" + std::to_string(found->second);
}

std::string HtmlLooks::rules() const {
  std::string out;
  for (std::size_t i = 0; i < in_order_.size(); ++i) out += ".s" + std::to_string(i) + "{" + in_order_[i] + "}\n";
  return out;
}

std::string HtmlLooks::properties(const Theme& theme) const {
  std::string out = "color-scheme:" + std::string(theme.name == "dark" ? "dark" : "light") +
                    ";--ground:" + hex(theme.background) +
                    ";--k:" + decimals(theme[Role::curve].line_width / light_theme()[Role::curve].line_width);
  for (std::size_t i = 0; i < role_names.size(); ++i)
    out += ";--" + std::string(role_names[i]) + ":" + hex(theme.roles[i].color) + ";--" + std::string(role_names[i]) +
           "-ink:" + hex(theme.roles[i].ink);
  for (const auto& [shade, i] : shades_) {
    const Color face = theme.roles[static_cast<std::size_t>(shade.role)].face;
    const auto lit = [&, &s = shade](std::uint8_t channel) {
      return static_cast<std::uint8_t>(
          std::clamp<long>(std::lround(1.0 * channel * s.share / share_steps) + s.gloss * gloss_step, 0, 255));
    };
    out += ";--m" + std::to_string(i) + ":" + hex({lit(face.r), lit(face.g), lit(face.b)});
  }
  return out;
}

std::string HtmlLooks::themes(const LessonColors& colors) const {
  const auto of = [&](std::string_view name) { return properties(with_colors(**find_theme(name), colors)); };
  const std::string light = of("light"), dark = of("dark"), contrast = of("contrast");
  // Paper is white, whatever the screen was.
  return ":root{" + light + "}\n@media screen{\n@media (prefers-color-scheme:dark){:root:not([data-theme]){" + dark +
         "}}\n@media (prefers-contrast:more){:root:not([data-theme]){" + contrast + "}}\n:root[data-theme=dark]{" +
         dark + "}\n:root[data-theme=contrast]{" + contrast + "}\n}\n";
}

// ---- the canvas -----------------------------------------------------------------------------------------------------

void HtmlCanvas::add(const std::string& style, const std::string& path) {
  elements_.push_back("[\"" + style + "\",\"" + path + "\"]");
}

void HtmlCanvas::polyline(std::span<const PixelPoint> points, bool closed, const Stroke& stroke) {
  cells_.visible_parts(points, closed, stroke, [&](auto part, bool part_closed, const Stroke& look) {
    std::string style = "stroke:var(" + looks_.variable(look.color) + ");" + alpha("stroke", look.color) +
                        "stroke-width:calc(var(--k)*" + decimals(look.width) + "px)";
    if (look.gap > 0) style += ";stroke-dasharray:" + decimals(std::max(look.dash, 0.01f)) + " " + decimals(look.gap);
    add(looks_.style(style), outline_of(part, part_closed));
  });
}

void HtmlCanvas::polygon(std::span<const PixelPoint> points, Color color) {
  if (points.size() < 3 || cells_.hidden_polygon(points)) return;
  add(looks_.style("fill:var(" + looks_.variable(color) + ");" + alpha("fill", color)), outline_of(points, true));
}

void HtmlCanvas::marker(const PixelPoint& at, Marker::Shape shape, const MarkerPaint& look) {
  if (cells_.hidden(at)) return;
  const MarkerForm form = marker_form(at, shape, look.radius);
  const float rim = look.outline_width;
  const std::string fill = "var(" + looks_.variable(look.fill) + ")",
                    around = "var(" + looks_.variable(look.outline) + ")";
  std::string path;
  if (form.circle == 0)
    for (const auto& line : form.lines) path += outline_of(line, form.stroke == 0);
  const auto element = [&](const std::string& declarations) {
    const std::string style = looks_.style(declarations);
    if (form.circle > 0)
      elements_.push_back("[\"" + style + "\"," + json_place(at.x) + "," + json_place(at.y) + "," +
                          json_place(form.circle) + "]");
    else
      add(style, path);
  };
  if (form.stroke > 0) {
    const std::string butt = form.circle > 0 ? "" : ";stroke-linecap:butt";
    if (rim > 0) element("stroke:" + around + ";stroke-width:" + decimals(form.stroke + 2 * rim) + butt);
    element("stroke:" + fill + ";stroke-width:" + decimals(form.stroke) + butt);
    return;
  }
  std::string style = "fill:" + fill;
  if (rim > 0) style += ";stroke:" + around + ";stroke-width:" + decimals(2 * rim) + ";paint-order:stroke";
  element(style);
}

void HtmlCanvas::triangles(std::span<const PixelPoint> points, std::span<const Color> colors,
                           std::span<const std::uint32_t> indices, double opacity) {
  if (indices.size() < 3) return;
  // Neighbours of one shade are one path. Each has a thin rim of its own colour, so that no seams shine through.
  std::string group, path, style;
  const auto flush = [&] {
    if (!path.empty()) group += (group.empty() ? "[\"" : ",[\"") + style + "\",\"" + path + "\"]";
    path.clear();
  };
  for (const auto& triangle : cells_.in_order(points, colors, indices)) {
    const std::string color = looks_.variable(triangle.color);
    const std::string next = looks_.style("fill:var(" + color + ");stroke:var(" + color + ");stroke-width:.6");
    if (next != style) flush();
    style = next;
    path += outline_of(triangle.corners, true);
  }
  flush();
  if (!group.empty()) elements_.push_back("[" + decimals(std::min(opacity, 1.0)) + ",[" + group + "]]");
  cells_.add(points, indices);
}

void HtmlCanvas::text(std::span<const GlyphRun> runs, const TextPaint& look) {
  if (runs.empty()) return;
  std::string style = "fill:var(" + looks_.variable(look.color) + ")";
  if (look.halo_width > 0)
    style += ";stroke:var(" + looks_.variable(look.halo) + ");stroke-width:" + decimals(2 * look.halo_width) +
             ";paint-order:stroke";
  std::string made = "[\"" + looks_.style(style) + "\",[";
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const GlyphRun& run = runs[i];
    const int flags = (run.style.bold ? 1 : 0) + (run.style.italic ? 2 : 0) + (run.style.monospace ? 4 : 0);
    made += (i == 0 ? "[" : ",[") + json_place(run.x) + "," + json_place(run.baseline) + "," + json_place(run.size) +
            "," + json_quote(run.text);
    if (flags != 0) made += "," + std::to_string(flags);
    made += "]";
  }
  elements_.push_back(made + "]]");
}

}  // namespace blossom
