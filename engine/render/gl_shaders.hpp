#pragma once
// The five programs of the OpenGL canvas, in what GLSL 3.30 and GLSL ES 3.00 share; the canvas puts the #version line
// and `frame`, the size of the picture in pixels, before each. Positions are pixels, y down, depth 0 to 1.

namespace blossom::shaders {

inline constexpr const char* core_header = "#version 330 core\n";
inline constexpr const char* es_header = "#version 300 es\nprecision highp float;\nprecision highp int;\n";

inline constexpr const char* common = R"(
uniform vec2 frame;
)";
inline constexpr const char* common_vertex = R"(
vec4 place(vec2 p, float depth) {
  return vec4(p.x / frame.x * 2.0 - 1.0, 1.0 - p.y / frame.y * 2.0, depth * 2.0 - 1.0, 1.0);
}
vec2 corner() { return vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)); }
)";
inline constexpr const char* common_fragment = R"(
out vec4 result;
vec2 pixel() { return vec2(gl_FragCoord.x, frame.y - gl_FragCoord.y); }
)";

inline constexpr const char* triangle_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 color;
out vec4 shade;
void main() {
  shade = color;
  gl_Position = place(position.xy, position.z);
}
)";
inline constexpr const char* triangle_fragment = R"(
in vec4 shade;
void main() { result = shade; }
)";

// One segment of a line: all pixels within `radius` of it, the last pixel of the edge by its distance. Where segments
// meet, each owns the pixels on its side of the bisector, so no pixel is painted twice and edges stay smooth however
// short the segments are.
inline constexpr const char* stroke_vertex = R"(
layout(location = 0) in vec4 ends;       // a.xy, b.xy
layout(location = 1) in vec3 form;       // depth at a, depth at b, radius
layout(location = 2) in vec4 bisectors;  // direction across the bisector at a, at b; zero: no neighbour
layout(location = 3) in vec4 color;
flat out vec4 segment;
flat out vec4 bounds;
flat out vec4 shade;
flat out float radius;
void main() {
  segment = ends;
  bounds = bisectors;
  shade = color;
  radius = form.z;
  vec2 along = ends.zw - ends.xy;
  float len = length(along);
  along = len > 0.0 ? along / len : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float reach = radius + 1.0;
  vec2 c = corner();
  vec2 p = mix(ends.xy - reach * along, ends.zw + reach * along, c.x) + (2.0 * c.y - 1.0) * reach * across;
  gl_Position = place(p, mix(form.x, form.y, c.x));
}
)";
inline constexpr const char* stroke_fragment = R"(
flat in vec4 segment;
flat in vec4 bounds;
flat in vec4 shade;
flat in float radius;
void main() {
  vec2 p = pixel();
  vec2 from_a = p - segment.xy;
  if (dot(bounds.xy, bounds.xy) > 0.0 && dot(from_a, bounds.xy) < 0.0) discard;
  if (dot(bounds.zw, bounds.zw) > 0.0 && dot(p - segment.zw, bounds.zw) >= 0.0) discard;
  vec2 along = segment.zw - segment.xy;
  float t = clamp(dot(from_a, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
  float coverage = clamp(radius + 0.5 - length(from_a - t * along), 0.0, 1.0);
  if (coverage <= 0.0) discard;
  result = vec4(shade.rgb, shade.a * coverage);
}
)";

inline constexpr const char* marker_vertex = R"(
layout(location = 0) in vec4 spot;   // centre, depth, radius
layout(location = 1) in vec2 form;   // shape, outline width
layout(location = 2) in vec4 color;
layout(location = 3) in vec4 rim;
flat out vec4 centre;
flat out vec2 kind;
flat out vec4 fill;
flat out vec4 edge;
void main() {
  centre = spot;
  kind = form;
  fill = color;
  edge = rim;
  float reach = 1.5 * spot.w + form.y + 1.0;
  gl_Position = place(spot.xy + (2.0 * corner() - 1.0) * reach, spot.z);
}
)";
// Signed distance to the shape's edge, negative inside; the order of shapes is that of Marker::Shape.
inline constexpr const char* marker_fragment = R"(
flat in vec4 centre;
flat in vec2 kind;
flat in vec4 fill;
flat in vec4 edge;
float box(vec2 p, vec2 half_size) {
  vec2 d = abs(p) - half_size;
  return length(max(d, 0.0)) + min(max(d.x, d.y), 0.0);
}
float shape_distance(vec2 p, float r, int shape) {
  if (shape == 0) return length(p) - r;
  if (shape == 1) return abs(length(p) - 0.8 * r) - 0.2 * r;
  if (shape == 2) return box(p, vec2(0.86 * r));
  vec2 turned = vec2(p.x + p.y, p.y - p.x) * 0.70710678;
  if (shape == 3) return box(turned, vec2(0.86 * r));
  if (shape == 4) {  // an equilateral triangle of circumradius 1.3 r, a corner up
    vec2 q = vec2(abs(p.x), p.y);
    return max(dot(q, vec2(0.8660254, -0.5)), q.y) - 0.65 * r;
  }
  return min(box(turned, vec2(1.1 * r, 0.24 * r)), box(turned, vec2(0.24 * r, 1.1 * r)));
}
void main() {
  float d = shape_distance(pixel() - centre.xy, centre.w, int(kind.x + 0.5));
  float inside = clamp(0.5 - d, 0.0, 1.0) * fill.a;
  float whole = clamp(0.5 - (d - kind.y), 0.0, 1.0) * (kind.y > 0.0 ? edge.a : fill.a);
  float alpha = max(inside, whole);
  if (alpha <= 0.0) discard;
  result = vec4(mix(edge.rgb, fill.rgb, kind.y > 0.0 ? inside : 1.0), alpha);
}
)";

inline constexpr const char* glyph_vertex = R"(
layout(location = 0) in vec4 box;    // x, y, width, height: whole pixels
layout(location = 1) in vec2 source; // in the atlas
layout(location = 2) in vec4 color;
out vec2 texel;
flat out vec4 shade;
void main() {
  vec2 c = corner();
  shade = color;
  texel = source + c * box.zw;
  gl_Position = place(box.xy + c * box.zw, 0.0);
}
)";
inline constexpr const char* glyph_fragment = R"(
uniform sampler2D atlas;
in vec2 texel;
flat in vec4 shade;
void main() { result = vec4(shade.rgb, shade.a * texelFetch(atlas, ivec2(texel), 0).r); }
)";

inline constexpr const char* image_vertex = R"(
layout(location = 0) in vec4 corner_and_source;
layout(location = 1) in vec4 color;
out vec2 source;
out vec4 shade;
void main() {
  source = corner_and_source.zw;
  shade = color;
  gl_Position = place(corner_and_source.xy, 0.0);
}
)";
inline constexpr const char* image_fragment = R"(
uniform sampler2D atlas;
in vec2 source;
in vec4 shade;
void main() { result = vec4(shade.rgb, shade.a * texture(atlas, source).r); }
)";

}  // namespace blossom::shaders
