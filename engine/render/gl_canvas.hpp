#pragma once
// The OpenGL canvas, for OpenGL 3.3 core and OpenGL ES 3.0. A frame is recorded and drawn at finish() in as few calls
// as its order allows. Programs, buffers and the glyph atlas live as long as the canvas; framebuffers as long as the
// frame keeps its size. A context must be current in every call and in the destructor.

#include <memory>
#include <vector>

#include "render/canvas.hpp"
#include "render/gl_functions.hpp"
#include "render/glyph_atlas.hpp"
#include "render/image.hpp"

namespace blossom {

class GlCanvas final : public Canvas {
 public:
  static Checked<std::unique_ptr<GlCanvas>> create(const GlFunctions&, bool is_es, std::shared_ptr<const Fonts>);
  ~GlCanvas() override;

  void begin(const Frame&) override;
  void begin_view(const PixelRect& clip, bool depth) override;
  void polyline(std::span<const PixelPoint>, bool closed, const Stroke&) override;
  void polygon(std::span<const PixelPoint>, Color) override;
  void marker(const PixelPoint&, Marker::Shape, const MarkerPaint&) override;
  void triangles(std::span<const PixelPoint>, std::span<const Color>, std::span<const std::uint32_t> indices,
                 double opacity) override;
  void text(std::span<const GlyphRun>, const TextPaint&) override;
  void finish() override;

  int max_size() const { return max_size_; }  // of a frame, in pixels, either way
  // The finished frame; a diagnostic when OpenGL reported an error or ran out of memory while drawing it.
  Checked<Image> read() const;

 private:
  enum class Program : std::uint8_t { triangles, strokes, markers, glyphs };
  static constexpr std::size_t program_count = 4;
  struct ScissorBox {
    int x = 0, y = 0, width = 0, height = 0;  // y up, as OpenGL has it
    bool operator==(const ScissorBox&) const = default;
  };
  struct Batch {
    Program program{};
    std::size_t first = 0, count = 0;  // indices of triangles; instances of the others
    ScissorBox scissor;
    bool depth_test = false, depth_write = false, nearest_layer_only = false, clear_depth = false;
  };
  struct TriangleVertex {
    float x, y, depth;
    Color color;
  };
  struct StrokeInstance {
    float ax, ay, bx, by, depth_a, depth_b, radius;
    float bisector_ax, bisector_ay, bisector_bx, bisector_by;
    Color color;
  };
  struct MarkerInstance {
    float x, y, depth, radius, shape, outline_width;
    Color fill, outline;
  };
  struct GlyphInstance {
    float x, y, width, height, u, v;
    Color color;
  };

  GlCanvas(const GlFunctions& gl, std::shared_ptr<const Fonts> fonts)
      : gl_(gl), fonts_(std::move(fonts)), atlas_(fonts_) {}
  Diagnostics make_programs(bool is_es);
  void make_vertex_arrays();
  void resize_targets();
  void delete_targets();
  void upload_atlas();
  void draw(const Batch&);
  void point_attributes(Program, std::size_t first);
  Batch& batch(Program, std::size_t first);  // the last one when its state is the same, otherwise a new one
  void stroke_solid(std::span<const PixelPoint>, bool closed, const Stroke&);

  GlFunctions gl_;
  std::shared_ptr<const Fonts> fonts_;
  GlyphAtlas atlas_;
  int atlas_texture_side_ = 0;
  GLuint atlas_texture_ = 0;
  GLuint programs_[program_count] = {};
  GLint frame_locations_[program_count] = {};
  GLuint arrays_[program_count] = {}, buffers_[program_count] = {};
  GLuint index_buffer_ = 0;

  // The frame is drawn to `drawing_` (4 samples when it has triangles) and ends in `plain_`.
  struct Target {
    GLuint framebuffer = 0, color = 0, depth = 0;
  };
  void make_target(Target&, int samples);
  Target plain_, smooth_;
  int target_width_ = 0, target_height_ = 0;
  int max_size_ = 0, samples_ = 0;
  bool complete_ = true;

  Frame frame_;
  ScissorBox scissor_;
  bool depth_ = false;
  bool has_meshes_ = false;
  std::vector<Batch> batches_;
  std::vector<TriangleVertex> triangle_vertices_;
  std::vector<std::uint32_t> triangle_indices_;
  std::vector<StrokeInstance> strokes_;
  std::vector<MarkerInstance> markers_;
  std::vector<GlyphInstance> glyphs_;
};

}  // namespace blossom
