#include "render/gl_canvas.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "render/dash.hpp"
#include "render/gl_canvas_programs.hpp"

namespace blossom {

Checked<std::unique_ptr<GlCanvas>> GlCanvas::create(const GlFunctions& gl, bool is_es,
                                                    std::shared_ptr<const Fonts> fonts) {
  std::unique_ptr<GlCanvas> canvas(new GlCanvas(gl, std::move(fonts)));
  if (auto wrong = canvas->make_programs(is_es); !wrong.empty()) return wrong;
  canvas->make_vertex_arrays();
  gl.GenTextures(1, &canvas->atlas_texture_);
  gl.GenTextures(1, &canvas->image_texture_);
  constexpr std::uint8_t full = 255;
  canvas->set_texture(1, 1, {&full, 1});
  GLint largest_buffer = 0, samples = 0;
  gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest_buffer);
  gl.GetIntegerv(GL_MAX_SAMPLES, &samples);
  canvas->max_size_ = std::min(largest_buffer, 16384);
  canvas->samples_ = std::min(samples, 4);
  return canvas;
}

Diagnostics GlCanvas::make_programs(bool is_es) {
  Diagnostics wrong;
  for (std::size_t i = 0; i < program_count; ++i) {
    auto program = make_program(gl_, is_es, program_sources[i]);
    if (!program) {
      wrong.insert(wrong.end(), program.diagnostics.begin(), program.diagnostics.end());
      continue;
    }
    programs_[i] = *program;
    frame_locations_[i] = gl_.GetUniformLocation(*program, "frame");
  }
  if (!wrong.empty()) return wrong;
  for (const Program textured : {Program::glyphs, Program::images}) {
    const GLuint program = programs_[static_cast<std::size_t>(textured)];
    gl_.UseProgram(program);
    gl_.Uniform1i(gl_.GetUniformLocation(program, "atlas"), textured == Program::glyphs ? 0 : 1);
  }
  return {};
}

void GlCanvas::make_vertex_arrays() {
  gl_.GenVertexArrays(program_count, arrays_);
  gl_.GenBuffers(program_count, buffers_);
  gl_.GenBuffers(1, &index_buffer_);
  constexpr std::array<GLuint, program_count> attributes = {2, 4, 4, 3, 2};
  for (std::size_t i = 0; i < program_count; ++i) {
    const auto program = static_cast<Program>(i);
    gl_.BindVertexArray(arrays_[i]);
    for (GLuint k = 0; k < attributes[i]; ++k) {
      gl_.EnableVertexAttribArray(k);
      if (!indexed(program)) gl_.VertexAttribDivisor(k, 1);
    }
    if (!indexed(program)) continue;
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
    point_attributes(program, 0);
  }
  gl_.BindVertexArray(0);
}

GlCanvas::~GlCanvas() {
  delete_targets();
  for (const GLuint program : programs_) gl_.DeleteProgram(program);
  gl_.DeleteVertexArrays(program_count, arrays_);
  gl_.DeleteBuffers(program_count, buffers_);
  gl_.DeleteBuffers(1, &index_buffer_);
  gl_.DeleteTextures(1, &atlas_texture_);
  gl_.DeleteTextures(1, &image_texture_);
}

void GlCanvas::begin(const Frame& frame) {
  frame_ = frame;
  scissor_ = {0, 0, frame.width, frame.height};
  depth_ = view_is_smooth_ = false;
  view_first_ = 0;
  batches_.clear();
  spans_.clear();
  triangle_vertices_.clear();
  image_vertices_.clear();
  indices_.clear();
  strokes_.clear();
  markers_.clear();
  glyphs_.clear();
  if (atlas_.full()) atlas_.clear();
}

GlCanvas::ScissorBox GlCanvas::box_of(const PixelRect& clip) const {
  const auto pixel = [](double v, int limit) {
    return static_cast<int>(std::lround(std::clamp(v, 0.0, double(limit))));
  };
  const int left = pixel(clip.x, frame_.width), right = pixel(clip.right(), frame_.width);
  const int top = pixel(clip.y, frame_.height), bottom = pixel(clip.bottom(), frame_.height);
  return {left, frame_.height - bottom, std::max(0, right - left), std::max(0, bottom - top)};
}

void GlCanvas::begin_view(const PixelRect& clip, bool depth) {
  scissor_ = box_of(clip);
  depth_ = depth;
  view_first_ = batches_.size();
  view_is_smooth_ = false;
  if (depth) {
    Batch clear;
    clear.scissor = scissor_;
    clear.clear_depth = clear.depth_write = true;
    batches_.push_back(clear);
  }
}

GlCanvas::Batch& GlCanvas::batch(Program program, std::size_t first, const ScissorBox& scissor, bool depth_test) {
  if (batches_.empty() || batches_.back().program != program || batches_.back().scissor != scissor ||
      batches_.back().depth_test != depth_test || batches_.back().depth_write) {
    Batch fresh;
    fresh.program = program;
    fresh.first = first;
    fresh.scissor = scissor;
    fresh.depth_test = depth_test;
    batches_.push_back(fresh);
  }
  if (depth_test) extend_smooth();
  return batches_.back();
}

void GlCanvas::extend_smooth() {
  if (view_is_smooth_) spans_.back().last = batches_.size();
}

void GlCanvas::polyline(std::span<const PixelPoint> points, bool closed, const Stroke& stroke) {
  if (stroke.gap <= 0) return stroke_solid(points, closed, stroke);
  for (const auto& piece : split_dashes(points, closed, stroke.dash, stroke.gap)) stroke_solid(piece, false, stroke);
}

void GlCanvas::stroke_solid(std::span<const PixelPoint> points, bool closed, const Stroke& stroke) {
  // Points without distance have no direction to join in; a line of one place is a dot.
  auto& line = scratch_line_;
  line.clear();
  for (const auto& p : points) {
    if (line.empty() || std::abs(p.x - line.back().x) + std::abs(p.y - line.back().y) > 1e-3f) line.push_back(p);
  }
  if (line.empty()) return;
  if (line.size() == 1) line.push_back(line.front());
  const std::size_t n = line.size(), segments = closed && n > 2 ? n : n - 1;
  const bool ring = segments == n;

  auto &directions = scratch_directions_, &bisectors = scratch_bisectors_;
  directions.assign(segments, {});
  bisectors.assign(n, {});
  for (std::size_t i = 0; i < segments; ++i) {
    const float x = line[(i + 1) % n].x - line[i].x, y = line[(i + 1) % n].y - line[i].y, length = std::hypot(x, y);
    if (length > 0) directions[i] = {x / length, y / length};
  }
  for (std::size_t i = ring ? 0 : 1; i < segments; ++i) {
    const Direction from = directions[(i + segments - 1) % segments], to = directions[i];
    // At a turn right back there is no bisector: both segments paint all of their pixels.
    if (from.x * to.x + from.y * to.y > -0.95f) bisectors[i] = {from.x + to.x, from.y + to.y};
  }
  // A line thinner than a pixel is a paler line of one pixel.
  const float width = std::max(stroke.width, 1.0f);
  Color color = stroke.color;
  color.a = static_cast<std::uint8_t>(std::lround(float(color.a) * std::min(stroke.width, 1.0f)));
  batch(Program::strokes, strokes_.size()).count += segments;
  for (std::size_t i = 0; i < segments; ++i) {
    const PixelPoint a = line[i], b = line[(i + 1) % n];
    const Direction at_a = bisectors[i], at_b = bisectors[(i + 1) % n];
    strokes_.push_back({a.x, a.y, b.x, b.y, a.depth, b.depth, width / 2, at_a.x, at_a.y, at_b.x, at_b.y, color});
  }
}

void GlCanvas::polygon(std::span<const PixelPoint> points, Color color) {
  const std::size_t n = points.size();
  if (n < 3) return;
  double area = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto &a = points[i], &b = points[(i + 1) % n];
    area += double{a.x} * b.y - double{b.x} * a.y;
  }
  // The edge fades over the pixel it runs through: an inner and an outer ring, half a pixel from the edge.
  const float outward = area > 0 ? 0.5f : -0.5f;
  const auto base = static_cast<std::uint32_t>(triangle_vertices_.size());
  Color clear = color;
  clear.a = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto &before = points[(i + n - 1) % n], &p = points[i], &after = points[(i + 1) % n];
    const auto normal = [&](const PixelPoint& a, const PixelPoint& b) {
      const float x = b.x - a.x, y = b.y - a.y, length = std::max(std::hypot(x, y), 1e-6f);
      return std::array{y / length, -x / length};
    };
    const auto first = normal(before, p), second = normal(p, after);
    float x = first[0] + second[0], y = first[1] + second[1];
    const float square = std::max(x * x + y * y, 0.5f);  // long spikes at sharp corners are cut
    x *= 2 / square * outward, y *= 2 / square * outward;
    triangle_vertices_.push_back({p.x - x, p.y - y, p.depth, color});
    triangle_vertices_.push_back({p.x + x, p.y + y, p.depth, clear});
  }
  const std::size_t first_index = indices_.size();
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t i : {a, b, c}) indices_.push_back(base + static_cast<std::uint32_t>(i));
  };
  for (std::size_t i = 1; i + 1 < n; ++i) add(0, 2 * i, 2 * i + 2);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t in = 2 * i, next = 2 * ((i + 1) % n);
    add(in, in + 1, next + 1);
    add(in, next + 1, next);
  }
  batch(Program::triangles, first_index).count += indices_.size() - first_index;
}

void GlCanvas::marker(const PixelPoint& at, Marker::Shape shape, const MarkerPaint& paint) {
  batch(Program::markers, markers_.size()).count += 1;
  markers_.push_back(
      {at.x, at.y, at.depth, paint.radius, static_cast<float>(shape), paint.outline_width, paint.fill, paint.outline});
}

void GlCanvas::triangles(std::span<const PixelPoint> points, std::span<const Color> colors,
                         std::span<const std::uint32_t> indices, double opacity) {
  if (indices.empty()) return;
  const auto base = static_cast<std::uint32_t>(triangle_vertices_.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Color color = colors[i];
    color.a = static_cast<std::uint8_t>(std::lround(color.a * std::clamp(opacity, 0.0, 1.0)));
    triangle_vertices_.push_back({points[i].x, points[i].y, points[i].depth, color});
  }
  Batch mesh;
  mesh.first = indices_.size();
  mesh.count = indices.size();
  mesh.depth_test = mesh.depth_write = depth_;
  mesh.nearest_layer_only = depth_ && opacity < 1;
  PixelPoint low = points[indices[0]], high = low;
  for (const std::uint32_t i : indices) {
    indices_.push_back(base + i);
    low = {std::min(low.x, points[i].x), std::min(low.y, points[i].y)};
    high = {std::max(high.x, points[i].x), std::max(high.y, points[i].y)};
  }
  const ScissorBox box = box_of({low.x - 1.0, low.y - 1.0, high.x - low.x + 2.0, high.y - low.y + 2.0});
  mesh.scissor = intersection(scissor_, box);
  batches_.push_back(mesh);
  if (!view_is_smooth_) spans_.push_back({view_first_, 0, mesh.scissor});
  view_is_smooth_ = true;
  spans_.back().box = union_of(spans_.back().box, mesh.scissor);
  extend_smooth();
}

void GlCanvas::image_triangles(std::span<const ImageVertex> vertices, std::span<const std::uint16_t> indices,
                               const PixelRect& clip) {
  const ScissorBox box = box_of(clip);
  if (indices.empty() || box.width == 0 || box.height == 0) return;
  // Of vertices that many calls share, only those between the first and the last of this one are kept.
  std::uint16_t least = indices[0], most = least;
  for (const std::uint16_t i : indices) {
    least = std::min(least, i);
    most = std::max(most, i);
  }
  assert(most < vertices.size());
  const std::size_t first = indices_.size();
  const auto base = static_cast<std::uint32_t>(image_vertices_.size()) - least;  // modulo 2^32, like the sums below
  image_vertices_.insert(image_vertices_.end(), vertices.begin() + least, vertices.begin() + most + 1);
  indices_.resize(first + indices.size());
  std::uint32_t* to = indices_.data() + first;
  for (std::size_t i = 0; i < indices.size(); ++i) to[i] = base + indices[i];
  batch(Program::images, first, box, false).count += indices.size();
}

void GlCanvas::text(std::span<const GlyphRun> runs, const TextPaint& paint) {
  const std::size_t first = glyphs_.size();
  const auto add = [&](const GlyphRun& run, double halo, Color color) {
    const double baseline = std::round(run.baseline);
    for_each_glyph(*fonts_, run, [&](char32_t c, double pen) {
      const double quarters = std::floor(pen * 4 + 0.5), whole = std::floor(quarters / 4);
      const auto& place = atlas_.find(run.style, c, run.size, static_cast<int>(quarters - 4 * whole), halo);
      if (place.width == 0) return;
      glyphs_.push_back({static_cast<float>(whole + place.left), static_cast<float>(baseline - place.top),
                         static_cast<float>(place.width), static_cast<float>(place.height), static_cast<float>(place.x),
                         static_cast<float>(place.y), color});
    });
  };
  if (paint.halo_width > 0) {
    for (const auto& run : runs) add(run, paint.halo_width, paint.halo);
  }
  for (const auto& run : runs) add(run, 0, paint.color);
  // Text is never hidden.
  if (glyphs_.size() > first) batch(Program::glyphs, first, scissor_, false).count += glyphs_.size() - first;
}

}  // namespace blossom
