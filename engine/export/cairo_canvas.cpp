#include "export/cairo_canvas.hpp"

#include <cairo-ft.h>
#include <cairo-pdf.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "render/marker_form.hpp"

namespace blossom {
namespace {

// A font file as cairo knows it. Cairo keeps fonts for later when nobody holds them any more, so a face and the library
// it belongs to go when cairo lets go of them, whenever that is.
struct FaceOwner {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  ~FaceOwner() {
    if (face != nullptr) FT_Done_Face(face);
    if (library != nullptr) FT_Done_FreeType(library);
  }
};
const cairo_user_data_key_t owner_key{};

struct Face {
  FT_Face glyphs = nullptr;  // belongs to the font below
  cairo_font_face_t* font = nullptr;
};

bool open_face(const std::filesystem::path& path, Face& face) {
  auto owner = std::make_unique<FaceOwner>();
  if (FT_Init_FreeType(&owner->library) != 0) return false;
  if (FT_New_Face(owner->library, path.c_str(), 0, &owner->face) != 0) return owner->face = nullptr, false;
  face = {owner->face, cairo_ft_font_face_create_for_ft_face(owner->face, 0)};
  const auto let_go = [](void* kept) { delete static_cast<FaceOwner*>(kept); };
  if (cairo_font_face_set_user_data(face.font, &owner_key, owner.get(), let_go) != CAIRO_STATUS_SUCCESS) return false;
  owner.release();  // cairo's now
  return true;
}

std::size_t face_index(FontStyle style) { return (style.monospace ? 2u : 0u) + (style.bold ? 1u : 0u); }

cairo_status_t append(void* bytes, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

struct CairoCanvas::Pdf {
  std::shared_ptr<const Fonts> fonts;
  double points_per_pixel = 1;
  std::array<Face, 4> faces;
  cairo_font_options_t* unhinted = nullptr;
  std::string bytes;
  cairo_surface_t* surface = nullptr;
  cairo_t* cr = nullptr;
  int pages = 0;

  ~Pdf() {
    cairo_destroy(cr);
    cairo_surface_destroy(surface);
    if (unhinted != nullptr) cairo_font_options_destroy(unhinted);
    for (auto& face : faces) cairo_font_face_destroy(face.font);
  }

  void start(const Frame& frame, double width, double height) {
    surface = cairo_pdf_surface_create_for_stream(append, &bytes, width, height);
    cairo_pdf_surface_restrict_to_version(surface, CAIRO_PDF_VERSION_1_5);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, frame.title.c_str());
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_SUBJECT, frame.description.c_str());
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "Blossom");
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
    cr = cairo_create(surface);
    cairo_set_line_join(cr, CAIRO_LINE_JOIN_ROUND);
    cairo_set_tolerance(cr, 0.05);
  }

  void color(Color c) { cairo_set_source_rgba(cr, c.r / 255.0, c.g / 255.0, c.b / 255.0, c.a / 255.0); }

  void font(const GlyphRun& run) {
    cairo_set_font_face(cr, faces[face_index(run.style)].font);
    cairo_matrix_t size;
    cairo_matrix_init(&size, run.size, 0, run.style.italic ? -0.2 * run.size : 0, run.size, 0, 0);
    cairo_set_font_matrix(cr, &size);
    cairo_set_font_options(cr, unhinted);
  }

  std::vector<cairo_glyph_t> glyphs(const GlyphRun& run) const {
    std::vector<cairo_glyph_t> result;
    const FT_Face face = faces[face_index(run.style)].glyphs;
    for_each_glyph(*fonts, run, [&](char32_t c, double x) {
      result.push_back({FT_Get_Char_Index(face, c), x, run.baseline});
    });
    return result;
  }
};

CairoCanvas::CairoCanvas(std::unique_ptr<Pdf> pdf) : pdf_(std::move(pdf)) {}
CairoCanvas::~CairoCanvas() = default;

Checked<std::unique_ptr<CairoCanvas>> CairoCanvas::create(std::shared_ptr<const Fonts> fonts, double points_per_pixel) {
  auto pdf = std::make_unique<Pdf>();
  pdf->fonts = std::move(fonts);
  pdf->points_per_pixel = points_per_pixel;
  for (std::size_t i = 0; i < pdf->faces.size(); ++i) {
    const auto path = Fonts::file({.bold = i % 2 == 1, .monospace = i >= 2});
    if (!open_face(path, pdf->faces[i]))
      return Diagnostics{{path.string(), 0, 0, "", "the font cannot be read; install the package fonts-dejavu-core"}};
  }
  pdf->unhinted = cairo_font_options_create();
  cairo_font_options_set_hint_style(pdf->unhinted, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(pdf->unhinted, CAIRO_HINT_METRICS_OFF);
  return std::unique_ptr<CairoCanvas>(new CairoCanvas(std::move(pdf)));
}

void CairoCanvas::begin(const Frame& frame) {
  const double scale = pdf_->points_per_pixel, width = frame.width * scale, height = frame.height * scale;
  if (pdf_->surface == nullptr) pdf_->start(frame, width, height);
  cairo_pdf_surface_set_size(pdf_->surface, width, height);
  ++pdf_->pages;
  cairo_save(pdf_->cr);
  cairo_scale(pdf_->cr, scale, scale);
  in_view_ = false;
  cells_.begin_view({}, false);
  if (frame.background == Color{255, 255, 255, 255}) return;  // as paper is
  pdf_->color(frame.background);
  cairo_paint(pdf_->cr);
}

void CairoCanvas::end_view() {
  if (in_view_) cairo_restore(pdf_->cr);
  in_view_ = false;
}

void CairoCanvas::begin_view(const PixelRect& clip, bool depth) {
  end_view();
  cairo_save(pdf_->cr);
  cairo_rectangle(pdf_->cr, clip.x, clip.y, clip.width, clip.height);
  cairo_clip(pdf_->cr);
  in_view_ = true;
  cells_.begin_view(clip, depth);
}

void CairoCanvas::path(std::span<const PixelPoint> points, bool closed) {
  cairo_t* cr = pdf_->cr;
  cairo_move_to(cr, points[0].x, points[0].y);
  for (const auto& p : points.subspan(1)) cairo_line_to(cr, p.x, p.y);
  if (closed) cairo_close_path(cr);
}

void CairoCanvas::polyline(std::span<const PixelPoint> points, bool closed, const Stroke& stroke) {
  cairo_t* cr = pdf_->cr;
  cairo_set_line_cap(cr, CAIRO_LINE_CAP_ROUND);
  cells_.visible_parts(points, closed, stroke, [&](auto part, bool part_closed, const Stroke& look) {
    const std::array dashes = {double{look.dash}, double{look.gap}};
    cairo_set_dash(cr, dashes.data(), look.gap > 0 ? 2 : 0, 0);
    cairo_set_line_width(cr, look.width);
    pdf_->color(look.color);
    path(part, part_closed);
    cairo_stroke(cr);
  });
  cairo_set_dash(cr, nullptr, 0, 0);
}

void CairoCanvas::polygon(std::span<const PixelPoint> points, Color color) {
  if (points.size() < 3 || cells_.hidden_polygon(points)) return;
  pdf_->color(color);
  path(points, true);
  cairo_fill(pdf_->cr);
}

void CairoCanvas::marker(const PixelPoint& at, Marker::Shape shape, const MarkerPaint& look) {
  if (cells_.hidden(at)) return;
  cairo_t* cr = pdf_->cr;
  const MarkerForm form = marker_form(at, shape, look.radius);
  const auto draw = [&] {
    cairo_new_path(cr);
    if (form.circle > 0) cairo_arc(cr, at.x, at.y, form.circle, 0, 2 * std::numbers::pi);
    if (form.circle > 0) cairo_close_path(cr);
    for (const auto& line : form.lines) path(line, form.stroke == 0);
  };
  cairo_set_line_cap(cr, CAIRO_LINE_CAP_BUTT);
  if (look.outline_width > 0) {
    draw();
    cairo_set_line_width(cr, form.stroke + 2 * look.outline_width);
    pdf_->color(look.outline);
    cairo_stroke(cr);
  }
  draw();
  cairo_set_line_width(cr, form.stroke);
  pdf_->color(look.fill);
  form.stroke > 0 ? cairo_stroke(cr) : cairo_fill(cr);
}

void CairoCanvas::triangles(std::span<const PixelPoint> points, std::span<const Color> colors,
                            std::span<const std::uint32_t> indices, double opacity) {
  if (indices.size() < 3) return;
  cairo_t* cr = pdf_->cr;
  if (opacity < 1) cairo_push_group(cr);
  // Each triangle has a thin rim of its own colour, so that no seams shine through.
  cairo_set_line_width(cr, 0.3 / pdf_->points_per_pixel);
  for (const auto& triangle : cells_.in_order(points, colors, indices)) {
    pdf_->color(triangle.color);
    path(triangle.corners, true);
    cairo_fill_preserve(cr);
    cairo_stroke(cr);
  }
  if (opacity < 1) {
    cairo_pop_group_to_source(cr);
    cairo_paint_with_alpha(cr, opacity);
  }
  cells_.add(points, indices);
}

void CairoCanvas::text(std::span<const GlyphRun> runs, const TextPaint& look) {
  cairo_t* cr = pdf_->cr;
  if (look.halo_width > 0) {
    // As outlines, so that the text is found once.
    cairo_new_path(cr);
    for (const auto& run : runs) {
      const auto glyphs = pdf_->glyphs(run);
      pdf_->font(run);
      cairo_glyph_path(cr, glyphs.data(), static_cast<int>(glyphs.size()));
    }
    pdf_->color(look.halo);
    cairo_set_line_width(cr, 2 * look.halo_width);
    cairo_stroke(cr);
  }
  pdf_->color(look.color);
  for (const auto& run : runs) {
    if (run.text.empty()) continue;
    const auto glyphs = pdf_->glyphs(run);
    std::vector<cairo_text_cluster_t> clusters;
    std::string text;  // as it was shown: what is no UTF-8 was replaced
    for (const char32_t c : decode_utf8(run.text)) {
      const std::string letter = encode_utf8(c);
      clusters.push_back({static_cast<int>(letter.size()), 1});
      text += letter;
    }
    pdf_->font(run);
    cairo_show_text_glyphs(cr, text.data(), static_cast<int>(text.size()), glyphs.data(),
                           static_cast<int>(glyphs.size()), clusters.data(), static_cast<int>(clusters.size()), {});
  }
}

void CairoCanvas::bookmark(const std::string& title, double y) {
  const std::string place =
      "page=" + std::to_string(pdf_->pages) + " pos=[0 " + std::to_string(y * pdf_->points_per_pixel) + "]";
  cairo_pdf_surface_add_outline(pdf_->surface, CAIRO_PDF_OUTLINE_ROOT, title.c_str(), place.c_str(), {});
}

void CairoCanvas::finish() {
  end_view();
  cairo_restore(pdf_->cr);
  cairo_show_page(pdf_->cr);
}

Checked<std::string> CairoCanvas::take() && {
  if (pdf_->surface == nullptr) return std::string();
  cairo_status_t status = cairo_status(pdf_->cr);
  cairo_surface_finish(pdf_->surface);
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(pdf_->surface);
  if (status != CAIRO_STATUS_SUCCESS) {
    return Diagnostics{{"", 0, 0, "", std::string("the PDF cannot be made: ") + cairo_status_to_string(status)}};
  }
  return std::move(pdf_->bytes);
}

}  // namespace blossom
