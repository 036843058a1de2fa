#pragma once
// Pictures in memory, as PNG files, side by side, and compared.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics.hpp"
#include "render/font.hpp"
#include "render/theme.hpp"

namespace blossom {

struct Image {  // RGBA, not premultiplied, rows from the top
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;  // 4 * width * height

  Image() = default;
  Image(int w, int h, Color fill = {255, 255, 255, 255});
  Color at(int x, int y) const;
  void set(int x, int y, Color);
  bool operator==(const Image&) const = default;
};

// The same picture gives the same bytes. An opaque one is written without its alpha. Title and description become
// metadata (iTXt, UTF-8) when they are not empty.
std::string encode_png(const Image&, std::string_view title = {}, std::string_view description = {});
// At most 64 million pixels. Any PNG: colour types and depths are converted.
Checked<Image> decode_png(std::string_view bytes);
Checked<Image> read_png(const std::filesystem::path&);
Checked<bool> write_png(const std::filesystem::path&, const Image&, std::string_view title = {},
                        std::string_view description = {});

// Each pixel is the average of the area it covers. Precondition: 0 < width <= image.width, height likewise.
Image downscale(const Image&, int width, int height);

// A grid of thumbnails, row by row, each `thumbnail_width` wide with its caption below (cut to the width).
// Precondition: as many captions as images; columns > 0; thumbnail_width > 0.
Image contact_sheet(const Fonts&, const Theme&, std::span<const Image> images, std::span<const std::string> captions,
                    int columns, int thumbnail_width);

// Differences of channels, 0 to 255. Images of different sizes differ by 255.
struct ImageDifference {
  int max = 0;
  double mean = 0;
};
ImageDifference difference(const Image&, const Image&);

}  // namespace blossom
