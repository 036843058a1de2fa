// The second half of the canvas: a recorded frame is drawn, and goes where it is wanted.
#include <algorithm>
#include <cassert>
#include <cstddef>

#include "render/gl_canvas.hpp"

namespace blossom {

GlCanvas::ScissorBox GlCanvas::intersection(const ScissorBox& a, const ScissorBox& b) {
  const int left = std::max(a.x, b.x), right = std::min(a.x + a.width, b.x + b.width);
  const int bottom = std::max(a.y, b.y), top = std::min(a.y + a.height, b.y + b.height);
  return {left, bottom, std::max(0, right - left), std::max(0, top - bottom)};
}

GlCanvas::ScissorBox GlCanvas::union_of(const ScissorBox& a, const ScissorBox& b) {
  if (a.width == 0 || a.height == 0) return b;
  if (b.width == 0 || b.height == 0) return a;
  const int left = std::min(a.x, b.x), right = std::max(a.x + a.width, b.x + b.width);
  const int bottom = std::min(a.y, b.y), top = std::max(a.y + a.height, b.y + b.height);
  return {left, bottom, right - left, top - bottom};
}

// Neither 3.3 nor ES 3.0 can start at an instance, so each batch points the attributes at its own first one;
// vertices of triangles are found by their indices.
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
    case Program::images:
      attribute(0, 4, GL_FLOAT, sizeof(ImageVertex), 0);
      attribute(1, 4, GL_UNSIGNED_BYTE, sizeof(ImageVertex), offsetof(ImageVertex, color));
      break;
  }
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
  if (!spans_.empty() && samples_ > 1 && smooth_.framebuffer == 0) make_target(smooth_, samples_);
}

void GlCanvas::upload_atlas() {
  gl_.ActiveTexture(GL_TEXTURE1);
  gl_.BindTexture(GL_TEXTURE_2D, image_texture_);
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

void GlCanvas::set_texture(int width, int height, std::span<const std::uint8_t> coverage) {
  assert(width > 0 && height > 0 &&
         coverage.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  gl_.ActiveTexture(GL_TEXTURE1);
  gl_.BindTexture(GL_TEXTURE_2D, image_texture_);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, coverage.data());
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void GlCanvas::upload_buffers() {
  const auto upload = [&](Program program, const auto& items) {
    if (items.empty()) return;
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffers_[static_cast<std::size_t>(program)]);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(items.size() * sizeof(items[0])), items.data(),
                   GL_STREAM_DRAW);
  };
  upload(Program::triangles, triangle_vertices_);
  upload(Program::strokes, strokes_);
  upload(Program::markers, markers_);
  upload(Program::glyphs, glyphs_);
  upload(Program::images, image_vertices_);
  if (indices_.empty()) return;
  gl_.BindVertexArray(arrays_[static_cast<std::size_t>(Program::triangles)]);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices_.size() * sizeof(std::uint32_t)),
                 indices_.data(), GL_STREAM_DRAW);
}

void GlCanvas::clear(const ScissorBox& box) {
  const auto channel = [](std::uint8_t c) { return static_cast<float>(c) / 255; };
  const Color back = frame_.background;
  gl_.Scissor(box.x, box.y, box.width, box.height);
  gl_.ClearColor(channel(back.r), channel(back.g), channel(back.b), channel(back.a));
  gl_.Clear(GL_COLOR_BUFFER_BIT);
}

void GlCanvas::draw(const Batch& batch, const ScissorBox& box) {
  gl_.Scissor(box.x, box.y, box.width, box.height);
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
  if (!indexed(batch.program)) {
    point_attributes(batch.program, batch.first);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
    return;
  }
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

// Plain pixels cannot be copied into ones with samples (OpenGL ES 3.0, section 4.3.3), so the box is painted anew from
// the frame's first batch on, and its averages replace what is there.
void GlCanvas::draw_smooth(const SmoothSpan& span) {
  if (span.box.width == 0 || span.box.height == 0) return;
  gl_.BindFramebuffer(GL_FRAMEBUFFER, smooth_.framebuffer);
  clear(span.box);
  for (std::size_t i = 0; i < span.last; ++i) {
    const ScissorBox part = intersection(batches_[i].scissor, span.box);
    if (part.width > 0 && part.height > 0) draw(batches_[i], part);
  }
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, plain_.framebuffer);
  const auto& box = span.box;
  gl_.Scissor(box.x, box.y, box.width, box.height);
  gl_.BlitFramebuffer(box.x, box.y, box.x + box.width, box.y + box.height, box.x, box.y, box.x + box.width,
                      box.y + box.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, plain_.framebuffer);
}

void GlCanvas::finish() {
  resize_targets();
  upload_atlas();
  upload_buffers();
  gl_.BindFramebuffer(GL_FRAMEBUFFER, plain_.framebuffer);
  gl_.Viewport(0, 0, frame_.width, frame_.height);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Enable(GL_BLEND);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.DepthFunc(GL_LEQUAL);
  for (std::size_t i = 0; i < program_count; ++i) {
    gl_.UseProgram(programs_[i]);
    gl_.Uniform2f(frame_locations_[i], static_cast<float>(frame_.width), static_cast<float>(frame_.height));
  }
  clear({0, 0, frame_.width, frame_.height});
  auto span = smooth_.framebuffer != 0 ? spans_.begin() : spans_.end();
  for (std::size_t i = 0; i < batches_.size(); ++i) {
    const Batch& batch = batches_[i];
    // What lies wholly in the box of its span comes with the span.
    const bool in_span = span != spans_.end() && i >= span->first;
    if (!in_span || intersection(batch.scissor, span->box) != batch.scissor) draw(batch, batch.scissor);
    if (in_span && i + 1 == span->last) draw_smooth(*span++);
  }
  gl_.BindVertexArray(0);
  gl_.Disable(GL_SCISSOR_TEST);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.DepthMask(GL_TRUE);
}

void GlCanvas::present(GLuint framebuffer, int width, int height) {
  gl_.Disable(GL_SCISSOR_TEST);  // a blit heeds it
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, plain_.framebuffer);
  gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  // Both have their first row at the bottom.
  const bool same_size = width == frame_.width && height == frame_.height;
  gl_.BlitFramebuffer(0, 0, frame_.width, frame_.height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                      same_size ? GL_NEAREST : GL_LINEAR);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
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
