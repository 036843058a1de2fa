#include "render/gl_canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "render/dash.hpp"
#include "render/gl_canvas_programs.hpp"

namespace blossom {

Checked<std::unique_ptr<GlCanvas>> GlCanvas::create(const GlFunctions& gl, bool is_es,
                                                    std::shared_ptr<const Fonts> fonts) {
  std::unique_ptr<GlCanvas> canvas(new GlCanvas(gl, std::move(fonts)));
  if (auto wrong = canvas->make_programs(is_es); !wrong.empty()) return wrong;
  canvas->make_vertex_arrays();
  gl.GenTextures(1, &canvas->atlas_texture_);
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
  if (wrong.empty()) {
    const GLuint glyphs = programs_[static_cast<std::size_t>(Program::glyphs)];
    gl_.UseProgram(glyphs);
    gl_.Uniform1i(gl_.GetUniformLocation(glyphs, "atlas"), 0);
  }
  return wrong;
}

void GlCanvas::make_vertex_arrays() {
  gl_.GenVertexArrays(program_count, arrays_);
  gl_.GenBuffers(program_count, buffers_);
  gl_.GenBuffers(1, &index_buffer_);
  for (std::size_t i = 0; i < program_count; ++i) {
    gl_.BindVertexArray(arrays_[i]);
    const bool instanced = static_cast<Program>(i) != Program::triangles;
    for (GLuint k = 0; k < (instanced ? (i == static_cast<std::size_t>(Program::glyphs) ? 3u : 4u) : 2u); ++k) {
      gl_.EnableVertexAttribArray(k);
      if (instanced) gl_.VertexAttribDivisor(k, 1);
    }
    if (!instanced) gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
  }
  gl_.BindVertexArray(0);
}

// Neither 3.3 nor ES 3.0 can start at an instance, so each batch points the attributes at its own first one.
void GlCanvas::point_attributes(Program program, std::size_t first) {
  gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[static_cast<std::size_t>(program)]);
  const auto attribute = [&](GLuint index, GLint size, GLenum type, std::size_t stride, std::size_t offset) {
    const auto* address = reinterpret_cast<const void*>(first * stride + offset);
    gl_.VertexAttribPointer(index, size, type, type == GL_UNSIGNED_BYTE, static_cast<GLsizei>(stride), address);
  };
  switch (program) {
    case Program::triangles:
      attribute(0, 3, GL_FLOAT, sizeof(TriangleVertex), 0);
      attribute(1, 4, GL_UNSIGNED_BYTE, sizeof(TriangleVertex), offsetof(TriangleVertex, color));
      break;
    case Program::strokes:
      attribute(0, 4, GL_FLOAT, sizeof(StrokeInstance), 0);
      attribute(1, 3, GL_FLOAT, sizeof(StrokeInstance), offsetof(StrokeInstance, depth_a));
      attribute(2, 4, GL_FLOAT, sizeof(StrokeInstance), offsetof(StrokeInstance, bisector_ax));
      attribute(3, 4, GL_UNSIGNED_BYTE, sizeof(StrokeInstance), offsetof(StrokeInstance, color));
      break;
    case Program::markers:
      attribute(0, 4, GL_FLOAT, sizeof(MarkerInstance), 0);
      attribute(1, 2, GL_FLOAT, sizeof(MarkerInstance), offsetof(MarkerInstance, shape));
      attribute(2, 4, GL_UNSIGNED_BYTE, sizeof(MarkerInstance), offsetof(MarkerInstance, fill));
      attribute(3, 4, GL_UNSIGNED_BYTE, sizeof(MarkerInstance), offsetof(MarkerInstance, outline));
      break;
    case Program::glyphs:
      attribute(0, 4, GL_FLOAT, sizeof(GlyphInstance), 0);
      attribute(1, 2, GL_FLOAT, sizeof(GlyphInstance), offsetof(GlyphInstance, u));
      attribute(2, 4, GL_UNSIGNED_BYTE, sizeof(GlyphInstance), offsetof(GlyphInstance, color));
      break;
  }
}

GlCanvas::~GlCanvas() {
  delete_targets();
  for (const GLuint program : programs_) gl_.DeleteProgram(program);
  gl_.DeleteVertexArrays(program_count, arrays_);
  gl_.DeleteBuffers(program_count, buffers_);
  gl_.DeleteBuffers(1, &index_buffer_);
  gl_.DeleteTextures(1, &atlas_texture_);
}

void GlCanvas::begin(const Frame& frame) {
  frame_ = frame;
  scissor_ = {0, 0, frame.width, frame.height};
  depth_ = has_meshes_ = false;
  batches_.clear();
  triangle_vertices_.clear();
  triangle_indices_.clear();
  strokes_.clear();
  markers_.clear();
  glyphs_.clear();
  if (atlas_.full()) atlas_.clear();
}

void GlCanvas::begin_view(const PixelRect& clip, bool depth) {
  const auto pixel = [](double v, int limit) {
    return static_cast<int>(std::lround(std::clamp(v, 0.0, double(limit))));
  };
  const int left = pixel(clip.x, frame_.width), right = pixel(clip.right(), frame_.width);
  const int top = pixel(clip.y, frame_.height), bottom = pixel(clip.bottom(), frame_.height);
  scissor_ = {left, frame_.height - bottom, std::max(0, right - left), std::max(0, bottom - top)};
  depth_ = depth;
  if (depth) {
    Batch clear;
    clear.scissor = scissor_;
    clear.clear_depth = clear.depth_write = true;
    batches_.push_back(clear);
  }
}

GlCanvas::Batch& GlCanvas::batch(Program program, std::size_t first) {
  if (!batches_.empty()) {
    Batch& last = batches_.back();
    if (last.program == program && last.scissor == scissor_ && last.depth_test == depth_ && !last.depth_write) {
      return last;
    }
  }
  Batch fresh;
  fresh.program = program;
  fresh.first = first;
  fresh.scissor = scissor_;
  fresh.depth_test = depth_;
  batches_.push_back(fresh);
  return batches_.back();
}

void GlCanvas::polyline(std::span<const PixelPoint> points, bool closed, const Stroke& stroke) {
  if (stroke.gap <= 0) return stroke_solid(points, closed, stroke);
  for (const auto& piece : split_dashes(points, closed, stroke.dash, stroke.gap)) stroke_solid(piece, false, stroke);
}

void GlCanvas::stroke_solid(std::span<const PixelPoint> points, bool closed, const Stroke& stroke) {
  // Points without distance have no direction to join in; a line of one place is a dot.
  std::vector<PixelPoint> line;
  line.reserve(points.size());
  for (const auto& p : points) {
    if (line.empty() || std::abs(p.x - line.back().x) + std::abs(p.y - line.back().y) > 1e-3f) line.push_back(p);
  }
  if (line.empty()) return;
  if (line.size() == 1) line.push_back(line.front());
  const std::size_t n = line.size(), segments = closed && n > 2 ? n : n - 1;
  const bool ring = segments == n;

  struct Direction {
    float x = 0, y = 0;
  };
  std::vector<Direction> directions(segments), bisectors(n);
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
  const std::size_t first_index = triangle_indices_.size();
  const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
    for (const std::size_t i : {a, b, c}) triangle_indices_.push_back(base + static_cast<std::uint32_t>(i));
  };
  for (std::size_t i = 1; i + 1 < n; ++i) add(0, 2 * i, 2 * i + 2);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t in = 2 * i, next = 2 * ((i + 1) % n);
    add(in, in + 1, next + 1);
    add(in, next + 1, next);
  }
  batch(Program::triangles, first_index).count += triangle_indices_.size() - first_index;
}

void GlCanvas::marker(const PixelPoint& at, Marker::Shape shape, const MarkerPaint& paint) {
  batch(Program::markers, markers_.size()).count += 1;
  markers_.push_back(
      {at.x, at.y, at.depth, paint.radius, static_cast<float>(shape), paint.outline_width, paint.fill, paint.outline});
}

void GlCanvas::triangles(std::span<const PixelPoint> points, std::span<const Color> colors,
                         std::span<const std::uint32_t> indices, double opacity) {
  if (indices.empty()) return;
  has_meshes_ = true;
  const auto base = static_cast<std::uint32_t>(triangle_vertices_.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    Color color = colors[i];
    color.a = static_cast<std::uint8_t>(std::lround(color.a * std::clamp(opacity, 0.0, 1.0)));
    triangle_vertices_.push_back({points[i].x, points[i].y, points[i].depth, color});
  }
  Batch mesh;
  mesh.first = triangle_indices_.size();
  mesh.count = indices.size();
  mesh.scissor = scissor_;
  mesh.depth_test = mesh.depth_write = depth_;
  mesh.nearest_layer_only = depth_ && opacity < 1;
  for (const std::uint32_t i : indices) triangle_indices_.push_back(base + i);
  batches_.push_back(mesh);
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
  const bool depth = std::exchange(depth_, false);  // text is never hidden
  if (glyphs_.size() > first) batch(Program::glyphs, first).count += glyphs_.size() - first;
  depth_ = depth;
}

void GlCanvas::delete_targets() {
  for (Target* target : {&plain_, &smooth_}) {
    gl_.DeleteFramebuffers(1, &target->framebuffer);
    gl_.DeleteRenderbuffers(1, &target->color);
    gl_.DeleteRenderbuffers(1, &target->depth);
    *target = {};
  }
}

void GlCanvas::make_target(Target& target, int samples) {
  const auto storage = [&](GLenum format) {
    if (samples > 1) {
      gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, target_width_, target_height_);
    } else {
      gl_.RenderbufferStorage(GL_RENDERBUFFER, format, target_width_, target_height_);
    }
  };
  gl_.GenFramebuffers(1, &target.framebuffer);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  gl_.GenRenderbuffers(1, &target.color);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, target.color);
  storage(GL_RGBA8);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target.color);
  gl_.GenRenderbuffers(1, &target.depth);
  gl_.BindRenderbuffer(GL_RENDERBUFFER, target.depth);
  storage(GL_DEPTH_COMPONENT24);
  gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth);
  complete_ = complete_ && gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void GlCanvas::resize_targets() {
  if (frame_.width != target_width_ || frame_.height != target_height_) {
    delete_targets();
    complete_ = true;
    target_width_ = frame_.width;
    target_height_ = frame_.height;
    make_target(plain_, 1);
  }
  if (has_meshes_ && samples_ > 1 && smooth_.framebuffer == 0) make_target(smooth_, samples_);
}

void GlCanvas::upload_atlas() {
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, atlas_texture_);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const auto [first, last] = atlas_.take_changed_rows();
  const int side = atlas_.side();
  if (side != atlas_texture_side_) {
    atlas_texture_side_ = side;
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, side, side, 0, GL_RED, GL_UNSIGNED_BYTE, atlas_.pixels().data());
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  } else if (first < last) {
    gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, first, side, last - first, GL_RED, GL_UNSIGNED_BYTE,
                      atlas_.pixels().data() + static_cast<std::ptrdiff_t>(first) * side);
  }
}

void GlCanvas::draw(const Batch& batch) {
  gl_.Scissor(batch.scissor.x, batch.scissor.y, batch.scissor.width, batch.scissor.height);
  gl_.DepthMask(batch.depth_write ? GL_TRUE : GL_FALSE);
  if (batch.clear_depth) {
    gl_.Clear(GL_DEPTH_BUFFER_BIT);
    return;
  }
  const auto index = static_cast<std::size_t>(batch.program);
  const auto count = static_cast<GLsizei>(batch.count);
  (batch.depth_test ? gl_.Enable : gl_.Disable)(GL_DEPTH_TEST);
  gl_.UseProgram(programs_[index]);
  gl_.BindVertexArray(arrays_[index]);
  if (batch.program != Program::triangles) {
    point_attributes(batch.program, batch.first);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    return;
  }
  point_attributes(batch.program, 0);
  const auto* offset = reinterpret_cast<const void*>(batch.first * sizeof(std::uint32_t));
  if (batch.nearest_layer_only) {
    // First only the depth; then only the triangles that are at that depth leave their colour.
    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_.DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, offset);
    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.DepthFunc(GL_EQUAL);
    gl_.DepthMask(GL_FALSE);
  }
  gl_.DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, offset);
  gl_.DepthFunc(GL_LEQUAL);
}

void GlCanvas::finish() {
  resize_targets();
  upload_atlas();
  const bool smooth = has_meshes_ && smooth_.framebuffer != 0;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, smooth ? smooth_.framebuffer : plain_.framebuffer);
  gl_.Viewport(0, 0, frame_.width, frame_.height);
  gl_.Disable(GL_SCISSOR_TEST);
  const auto channel = [](std::uint8_t c) { return static_cast<float>(c) / 255; };
  const Color back = frame_.background;
  gl_.ClearColor(channel(back.r), channel(back.g), channel(back.b), channel(back.a));
  gl_.Clear(GL_COLOR_BUFFER_BIT);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Enable(GL_BLEND);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.DepthFunc(GL_LEQUAL);

  const auto upload = [&](Program program, const auto& items) {
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[static_cast<std::size_t>(program)]);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(items.size() * sizeof(items[0])), items.data(),
                   GL_STREAM_DRAW);
  };
  upload(Program::triangles, triangle_vertices_);
  upload(Program::strokes, strokes_);
  upload(Program::markers, markers_);
  upload(Program::glyphs, glyphs_);
  gl_.BindVertexArray(arrays_[static_cast<std::size_t>(Program::triangles)]);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangle_indices_.size() * sizeof(std::uint32_t)),
                 triangle_indices_.data(), GL_STREAM_DRAW);
  for (std::size_t i = 0; i < program_count; ++i) {
    gl_.UseProgram(programs_[i]);
    gl_.Uniform2f(frame_locations_[i], static_cast<float>(frame_.width), static_cast<float>(frame_.height));
  }
  for (const auto& batch : batches_) draw(batch);
  gl_.BindVertexArray(0);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.DepthMask(GL_TRUE);

  if (smooth) {
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, smooth_.framebuffer);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, plain_.framebuffer);
    gl_.BlitFramebuffer(0, 0, frame_.width, frame_.height, 0, 0, frame_.width, frame_.height, GL_COLOR_BUFFER_BIT,
                        GL_NEAREST);
  }
}

Checked<Image> GlCanvas::read() const {
  Image image(frame_.width, frame_.height);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, plain_.framebuffer);
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, frame_.width, frame_.height, GL_RGBA, GL_UNSIGNED_BYTE, image.pixels.data());
  const GLenum error = gl_.GetError();
  if (!complete_ || error != GL_NO_ERROR) {
    return Diagnostics{{"", 0, 0, "",
                        "OpenGL cannot draw a picture of " + std::to_string(frame_.width) + " x " +
                            std::to_string(frame_.height) + " pixels (error " + std::to_string(error) +
                            "); try a smaller scale"}};
  }
  // OpenGL's rows start at the bottom.
  const auto row = static_cast<std::ptrdiff_t>(4) * frame_.width;
  for (int y = 0; y < frame_.height / 2; ++y) {
    std::swap_ranges(image.pixels.begin() + y * row, image.pixels.begin() + (y + 1) * row,
                     image.pixels.begin() + (frame_.height - 1 - y) * row);
  }
  return image;
}

}  // namespace blossom
