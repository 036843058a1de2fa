#include "render/font.hpp"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_GLYPH_H
#include FT_OUTLINE_H
#include FT_STROKER_H

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <unordered_map>

namespace blossom {

std::u32string decode_utf8(std::string_view text) {
  std::u32string result;
  result.reserve(text.size());
  for (std::size_t i = 0; i < text.size();) result += next_code_point(text, i);
  return result;
}

std::string encode_utf8(char32_t c) {
  const auto byte = [](char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
  if (c < 0x80) return {byte(c)};
  if (c < 0x800) return {byte(0xC0 | c >> 6), byte(0x80 | (c & 0x3F))};
  if (c < 0x10000) return {byte(0xE0 | c >> 12), byte(0x80 | (c >> 6 & 0x3F)), byte(0x80 | (c & 0x3F))};
  return {byte(0xF0 | c >> 18), byte(0x80 | (c >> 12 & 0x3F)), byte(0x80 | (c >> 6 & 0x3F)), byte(0x80 | (c & 0x3F))};
}

struct Fonts::Impl {
  // Measured once: in a table what most text is made of, in a map the rest. In ems.
  struct Face {
    static constexpr double unknown = std::numeric_limits<double>::infinity();
    static constexpr char32_t common_letters = 0x180, common_pairs = 0x80;
    Face() {
      common_advances.fill(unknown);
      common_kernings.assign(std::size_t{common_pairs} * common_pairs, unknown);
    }
    double& advance(char32_t c) {
      return c < common_letters ? common_advances[c] : advances.try_emplace(c, unknown).first->second;
    }
    double& kerning(char32_t left, char32_t right) {
      if (left < common_pairs && right < common_pairs) return common_kernings[left * common_pairs + right];
      return kernings.try_emplace(std::uint64_t{left} << 32 | right, unknown).first->second;
    }

    FT_Face face = nullptr;
    std::array<double, common_letters> common_advances;
    std::vector<double> common_kernings;
    std::unordered_map<char32_t, double> advances;
    std::unordered_map<std::uint64_t, double> kernings;
  };
  FT_Library library = nullptr;
  FT_Stroker stroker = nullptr;
  std::array<Face, 4> faces;  // sans, sans bold, mono, mono bold

  Face& face(FontStyle style) { return faces[(style.monospace ? 2u : 0u) + (style.bold ? 1u : 0u)]; }
  ~Impl() {
    for (auto& f : faces) FT_Done_Face(f.face);
    FT_Stroker_Done(stroker);
    FT_Done_FreeType(library);
  }
};

Fonts::Fonts(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Fonts::~Fonts() = default;

std::filesystem::path Fonts::file(FontStyle style) {
  static constexpr std::array files = {"DejaVuSans.ttf", "DejaVuSans-Bold.ttf", "DejaVuSansMono.ttf",
                                       "DejaVuSansMono-Bold.ttf"};
  const char* from_environment = std::getenv("BLOSSOM_FONT_DIR");
  const std::filesystem::path folder = from_environment != nullptr && *from_environment != '\0'
                                           ? std::filesystem::path(from_environment)
                                           : std::filesystem::path(BLOSSOM_FONT_DIR);
  return folder / files[(style.monospace ? 2u : 0u) + (style.bold ? 1u : 0u)];
}

Checked<std::shared_ptr<const Fonts>> Fonts::load() {
  auto impl = std::make_unique<Impl>();
  if (FT_Init_FreeType(&impl->library) != 0 || FT_Stroker_New(impl->library, &impl->stroker) != 0) {
    return Diagnostics{{"", 0, 0, "", "FreeType cannot be started: out of memory?"}};
  }
  Diagnostics wrong;
  for (std::size_t i = 0; i < impl->faces.size(); ++i) {
    const auto path = file({.bold = i % 2 == 1, .monospace = i >= 2});
    if (FT_New_Face(impl->library, path.c_str(), 0, &impl->faces[i].face) != 0) {
      impl->faces[i].face = nullptr;
      wrong.push_back({path.string(), 0, 0, "",
                       "the font cannot be read; install the package fonts-dejavu-core, or set BLOSSOM_FONT_DIR to the "
                       "folder that holds it"});
    }
  }
  if (!wrong.empty()) return wrong;
  return std::shared_ptr<const Fonts>(new Fonts(std::move(impl)));
}

double Fonts::advance(FontStyle style, char32_t c) const {
  auto& face = impl_->face(style);
  double& kept = face.advance(c);
  if (kept != Impl::Face::unknown) return kept;
  const bool known = FT_Load_Char(face.face, c, FT_LOAD_NO_SCALE) == 0;
  return kept = known ? static_cast<double>(face.face->glyph->metrics.horiAdvance) / face.face->units_per_EM : 0;
}

double Fonts::kerning(FontStyle style, char32_t left, char32_t right) const {
  auto& face = impl_->face(style);
  if (style.monospace || !FT_HAS_KERNING(face.face)) return 0;
  double& kept = face.kerning(left, right);
  if (kept != Impl::Face::unknown) return kept;
  FT_Vector delta{};
  const bool known = FT_Get_Kerning(face.face, FT_Get_Char_Index(face.face, left), FT_Get_Char_Index(face.face, right),
                                    FT_KERNING_UNSCALED, &delta) == 0;
  return kept = known ? static_cast<double>(delta.x) / face.face->units_per_EM : 0;
}

Fonts::Ink Fonts::ink(FontStyle style, char32_t c) const {
  const FT_Face face = impl_->face(style).face;
  if (FT_Load_Char(face, c, FT_LOAD_NO_SCALE) != 0) return {};
  const FT_Glyph_Metrics& metrics = face->glyph->metrics;
  const auto ems = [&](FT_Pos units) { return static_cast<double>(units) / face->units_per_EM; };
  Ink box{ems(metrics.horiBearingX), ems(metrics.horiBearingX + metrics.width),
          ems(metrics.horiBearingY - metrics.height), ems(metrics.horiBearingY)};
  if (style.italic) {  // the slanted box: what is wide at the top may be less so at the bottom, but not by much
    box.left += slant * box.bottom;
    box.right += slant * box.top;
  }
  return box;
}

double Fonts::width(FontStyle style, std::string_view utf8) const {
  double result = 0;
  char32_t previous = 0;
  for (std::size_t i = 0; i < utf8.size();) {
    const char32_t c = next_code_point(utf8, i);
    if (previous != 0) result += kerning(style, previous, c);
    result += advance(style, c);
    previous = c;
  }
  return result;
}

GlyphBitmap Fonts::bitmap(FontStyle style, char32_t c, double pixels, int quarter, double halo) const {
  assert(pixels >= 1 && pixels <= max_pixels && quarter >= 0 && quarter < 4 && halo >= 0);
  const FT_Face face = impl_->face(style).face;
  GlyphBitmap result;
  if (FT_Set_Char_Size(face, 0, static_cast<FT_F26Dot6>(std::lround(pixels * 64)), 72, 72) != 0) return result;
  // Light hinting aligns stems with the pixel rows only; widths stay as measured.
  if (FT_Load_Char(face, c, FT_LOAD_NO_BITMAP | FT_LOAD_TARGET_LIGHT) != 0) return result;
  if (face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) return result;
  if (style.italic) {
    const FT_Matrix slanted{0x10000, static_cast<FT_Fixed>(slant * 0x10000), 0, 0x10000};  // 0.2 = tan(11.3 degrees)
    FT_Outline_Transform(&face->glyph->outline, &slanted);
  }
  FT_Outline_Translate(&face->glyph->outline, quarter * 16, 0);
  FT_Glyph glyph = nullptr;
  if (FT_Get_Glyph(face->glyph, &glyph) != 0) return result;
  if (halo > 0) {
    FT_Stroker_Set(impl_->stroker, static_cast<FT_Fixed>(std::lround(halo * 64)), FT_STROKER_LINECAP_ROUND,
                   FT_STROKER_LINEJOIN_ROUND, 0);
    FT_Glyph_StrokeBorder(&glyph, impl_->stroker, /*inside=*/0, /*destroy=*/1);
  }
  if (FT_Glyph_To_Bitmap(&glyph, FT_RENDER_MODE_NORMAL, nullptr, /*destroy=*/1) == 0) {
    const auto* rendered = reinterpret_cast<FT_BitmapGlyph>(glyph);
    const FT_Bitmap& from = rendered->bitmap;
    result.width = static_cast<int>(from.width);
    result.height = static_cast<int>(from.rows);
    result.left = rendered->left;
    result.top = rendered->top;
    result.coverage.resize(std::size_t{from.width} * from.rows);
    for (unsigned row = 0; row < from.rows; ++row) {
      std::copy_n(from.buffer + static_cast<std::ptrdiff_t>(row) * from.pitch, from.width,
                  result.coverage.begin() + static_cast<std::ptrdiff_t>(std::size_t{row} * from.width));
    }
  }
  FT_Done_Glyph(glyph);
  return result;
}

}  // namespace blossom
