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

struct ImageVertex {
  float x = 0, y = 0;  // pixels
  float u = 0, v = 0;  // of the texture, 0 to 1
  Color color;
};

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

  // One texture of 8-bit coverage (a user interface's font atlas), which image_triangles paints through; rows from the
  // top. It may be replaced at any time between frames. Until the first it is full everywhere.
  void set_texture(int width, int height, std::span<const std::uint8_t> coverage);
  // Triangles in the vertices' colour, its alpha times the texture's coverage; three indices per triangle, each less
  // than the number of vertices. Cut to `clip` alone: the view begun last stays in force for what is painted later. No
  // depth.
  void image_triangles(std::span<const ImageVertex>, std::span<const std::uint16_t> indices, const PixelRect& clip);

  // Copies the finished frame to a framebuffer without samples (0: the window's back buffer), its top left pixel to the
  // top left pixel; of another size, it is stretched.
  void present(GLuint framebuffer, int width, int height);

  int max_size() const { return max_size_; }  // of a frame, in pixels, either way
  // The finished frame; a diagnostic when OpenGL reported an error or ran out of memory while drawing it.
  Checked<Image> read() const;

 private:
  enum class Program : std::uint8_t { triangles, strokes, markers, glyphs, images };
  static constexpr std::size_t program_count = 5;
  static constexpr bool indexed(Program p) { return p == Program::triangles || p == Program::images; }
  struct ScissorBox {
    int x = 0, y = 0, width = 0, height = 0;  // y up, as OpenGL has it
    bool operator==(const ScissorBox&) const = default;
  };
  static ScissorBox intersection(const ScissorBox&, const ScissorBox&);
  static ScissorBox union_of(const ScissorBox&, const ScissorBox&);  // the smallest box around both
  struct Batch {
    Program program{};
    std::size_t first = 0, count = 0;  // indices, or instances
    ScissorBox scissor;
    bool depth_test = false, depth_write = false, nearest_layer_only = false, clear_depth = false;
  };
  // Meshes are drawn with several samples per pixel, and so is what depth may hide behind them: the batches of a view
  // up to its last such one, within the box around its meshes.
  struct SmoothSpan {
    std::size_t first = 0, last = 0;  // half open
    ScissorBox box;
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
  void upload_buffers();
  void clear(const ScissorBox&);
  void draw(const Batch&, const ScissorBox&);
  void draw_smooth(const SmoothSpan&);
  void point_attributes(Program, std::size_t first);
  ScissorBox box_of(const PixelRect&) const;
  // The last batch when its state is the same, otherwise a new one.
  Batch& batch(Program, std::size_t first, const ScissorBox&, bool depth_test);
  Batch& batch(Program program, std::size_t first) { return batch(program, first, scissor_, depth_); }
  void extend_smooth();
  void stroke_solid(std::span<const PixelPoint>, bool closed, const Stroke&);

  GlFunctions gl_;
  std::shared_ptr<const Fonts> fonts_;
  GlyphAtlas atlas_;
  int atlas_texture_side_ = 0;
  GLuint atlas_texture_ = 0, image_texture_ = 0;
  GLuint programs_[program_count] = {};
  GLint frame_locations_[program_count] = {};
  GLuint arrays_[program_count] = {}, buffers_[program_count] = {};
  GLuint index_buffer_ = 0;

  // The frame is drawn in `plain_`; what has several samples, in `smooth_` first.
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
  std::size_t view_first_ = 0;  // batch
  bool view_is_smooth_ = false;
  std::vector<Batch> batches_;
  std::vector<SmoothSpan> spans_;
  std::vector<TriangleVertex> triangle_vertices_;
  std::vector<ImageVertex> image_vertices_;
  std::vector<std::uint32_t> indices_;  // of both
  std::vector<StrokeInstance> strokes_;
  std::vector<MarkerInstance> markers_;
  std::vector<GlyphInstance> glyphs_;

  struct Direction {
    float x = 0, y = 0;
  };
  std::vector<PixelPoint> scratch_line_;  // of stroke_solid, which a page calls hundreds of times
  std::vector<Direction> scratch_directions_, scratch_bisectors_;
};

}  // namespace blossom
