#pragma once
// DejaVu Sans through FreeType: metrics without hinting, so that a layout is the same at every scale and on every
// canvas, and anti-aliased glyph bitmaps. Italics are the upright faces slanted by 11 degrees, which is how DejaVu's
// own oblique is drawn; so the package fonts-dejavu-core suffices.

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"
#include "base/utf8.hpp"
#include "render/canvas.hpp"

namespace blossom {

// The code point at text[i], and i behind it; what is no valid UTF-8 becomes U+FFFD, byte by byte.
inline char32_t next_code_point(std::string_view text, std::size_t& i) {
  const auto first = static_cast<unsigned char>(text[i]);
  if (first < 0x80) return ++i, first;
  const std::size_t length = utf8_length(text, i);
  char32_t c = first & 0x7Fu >> length;
  for (std::size_t k = 1; k < length; ++k) c = c << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3Fu);
  i += std::max<std::size_t>(length, 1);
  return length > 0 ? c : U'\uFFFD';
}
std::u32string decode_utf8(std::string_view);
std::string encode_utf8(char32_t);

struct GlyphBitmap {
  int width = 0, height = 0;
  int left = 0;                        // pixels from the pen (rounded down) to the first column
  int top = 0;                         // pixels from the baseline up to the upper edge of the first row
  std::vector<std::uint8_t> coverage;  // height rows of width
};

class Fonts {
 public:
  static constexpr double slant = 0.2;  // of italics: to the right, for each unit up
  // From the folder BLOSSOM_FONT_DIR of the environment, else from where they were found when Blossom was built.
  static Checked<std::shared_ptr<const Fonts>> load();
  static std::filesystem::path file(FontStyle);  // of the upright face of that style
  ~Fonts();
  Fonts(const Fonts&) = delete;
  Fonts& operator=(const Fonts&) = delete;

  // In ems.
  double advance(FontStyle, char32_t) const;
  double kerning(FontStyle, char32_t left, char32_t right) const;
  double width(FontStyle, std::string_view utf8) const;
  // The box around a letter's ink, from the pen and the baseline, y up; nothing but zeros for a blank.
  struct Ink {
    double left = 0, right = 0, bottom = 0, top = 0;
  };
  Ink ink(FontStyle, char32_t) const;
  static constexpr double ascent = 0.76, descent = 0.24;  // of letters: capitals and p, without accents

  // The pen stands at `quarter`/4 pixels right of a pixel's left edge. With halo > 0: the letter grown by that many
  // pixels. An empty bitmap for a blank. Precondition: 1 <= pixels <= max_pixels.
  GlyphBitmap bitmap(FontStyle, char32_t, double pixels, int quarter, double halo) const;
  static constexpr double max_pixels = 512;

 private:
  struct Impl;
  explicit Fonts(std::unique_ptr<Impl>);
  std::unique_ptr<Impl> impl_;
};

// Calls visit(code point, pen x in pixels) for every glyph of the run.
template <class Visit>
void for_each_glyph(const Fonts& fonts, const GlyphRun& run, Visit&& visit) {
  double pen = run.x;
  char32_t previous = 0;
  for (std::size_t i = 0; i < run.text.size();) {
    const char32_t c = next_code_point(run.text, i);
    if (previous != 0) pen += fonts.kerning(run.style, previous, c) * run.size;
    visit(c, pen);
    pen += fonts.advance(run.style, c) * run.size;
    previous = c;
  }
}

}  // namespace blossom
