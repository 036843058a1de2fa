#include "render/image.hpp"

#include <png.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "base/json.hpp"

namespace blossom {
namespace {

// libpng reports errors by longjmp, so the functions that call setjmp hold no object with a destructor.
void keep_message(png_structp png, png_const_charp message) {
  if (auto* kept = static_cast<std::string*>(png_get_error_ptr(png)); kept != nullptr) *kept = message;
  png_longjmp(png, 1);
}
void ignore_warning(png_structp, png_const_charp) {}

struct WriteJob {
  const Image* image;
  std::vector<std::uint8_t>* row;  // scratch
  std::string* output;
  std::string* message;
  png_text* texts;
  int text_count;
  bool opaque;
};

bool run(const WriteJob& job) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, job.message, keep_message, ignore_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_set_write_fn(
      png, job.output,
      [](png_structp p, png_bytep data, std::size_t size) {
        static_cast<std::string*>(png_get_io_ptr(p))->append(reinterpret_cast<const char*>(data), size);
      },
      [](png_structp) {});
  const auto width = static_cast<png_uint_32>(job.image->width), height = static_cast<png_uint_32>(job.image->height);
  png_set_IHDR(png, info, width, height, 8, job.opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  // Flat areas and thin lines: a low level and one filter come within a few percent of the best, several times faster.
  png_set_compression_level(png, 4);
  png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
  if (job.text_count > 0) png_set_text(png, info, job.texts, job.text_count);
  png_write_info(png, info);
  const std::size_t channels = job.opaque ? 3 : 4;
  for (png_uint_32 y = 0; y < height; ++y) {
    const std::uint8_t* from = job.image->pixels.data() + std::size_t{4} * width * y;
    std::uint8_t* to = job.row->data();
    for (png_uint_32 x = 0; x < width; ++x, from += 4, to += channels) std::memcpy(to, from, channels);
    png_write_row(png, job.row->data());
  }
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return true;
}

struct ReadJob {
  std::string_view rest;
  Image* image;
  std::vector<png_bytep>* rows;
  std::string* message;
};

bool run(ReadJob& job) {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, job.message, keep_message, ignore_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_read_struct(&png, &info, nullptr);
    return false;
  }
  png_set_read_fn(png, &job.rest, [](png_structp p, png_bytep to, std::size_t size) {
    auto& rest = *static_cast<std::string_view*>(png_get_io_ptr(p));
    if (rest.size() < size) png_error(p, "the file ends too early");
    std::memcpy(to, rest.data(), size);
    rest.remove_prefix(size);
  });
  png_read_info(png, info);
  const png_uint_32 width = png_get_image_width(png, info), height = png_get_image_height(png, info);
  if (std::uint64_t{width} * height > 64'000'000) png_error(png, "more than 64 million pixels");
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  *job.image = Image(static_cast<int>(width), static_cast<int>(height));
  job.rows->resize(height);
  for (png_uint_32 y = 0; y < height; ++y) (*job.rows)[y] = job.image->pixels.data() + std::size_t{4} * width * y;
  png_read_image(png, job.rows->data());
  png_read_end(png, nullptr);
  png_destroy_read_struct(&png, &info, nullptr);
  return true;
}

// A line of text straight into an image.
void write_text(Image& image, const Fonts& fonts, const GlyphRun& run, Color color) {
  for_each_glyph(fonts, run, [&](char32_t c, double pen) {
    const int whole = static_cast<int>(std::floor(pen)), quarter = static_cast<int>((pen - whole) * 4);
    const auto glyph = fonts.bitmap(run.style, c, run.size, quarter, 0);
    for (int y = 0; y < glyph.height; ++y) {
      for (int x = 0; x < glyph.width; ++x) {
        const int px = whole + glyph.left + x, py = static_cast<int>(std::lround(run.baseline)) - glyph.top + y;
        if (px < 0 || py < 0 || px >= image.width || py >= image.height) continue;
        const int alpha = glyph.coverage[static_cast<std::size_t>(y * glyph.width + x)];
        const Color below = image.at(px, py);
        const auto mix = [&](int from, int to) {
          return static_cast<std::uint8_t>((from * (255 - alpha) + to * alpha + 127) / 255);
        };
        image.set(px, py, {mix(below.r, color.r), mix(below.g, color.g), mix(below.b, color.b), below.a});
      }
    }
  });
}

// The text, or as much of it as fits with an ellipsis.
std::string cut_to_width(const Fonts& fonts, const std::string& text, double ems) {
  if (fonts.width({}, text) <= ems) return text;
  std::string kept;
  for (const char32_t c : decode_utf8(text)) {
    const std::string longer = kept + encode_utf8(c);
    if (fonts.width({}, longer + "\u2026") > ems) break;
    kept = longer;
  }
  return kept + "\u2026";
}

}  // namespace

Image::Image(int w, int h, Color fill) : width(w), height(h) {
  assert(w >= 0 && h >= 0);
  pixels.resize(std::size_t{4} * static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  for (std::size_t i = 0; i < pixels.size(); i += 4) {
    pixels[i] = fill.r, pixels[i + 1] = fill.g, pixels[i + 2] = fill.b, pixels[i + 3] = fill.a;
  }
}

Color Image::at(int x, int y) const {
  assert(x >= 0 && y >= 0 && x < width && y < height);
  const std::uint8_t* p =
      &pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
  return {p[0], p[1], p[2], p[3]};
}

void Image::set(int x, int y, Color c) {
  assert(x >= 0 && y >= 0 && x < width && y < height);
  std::uint8_t* p =
      &pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x))];
  p[0] = c.r, p[1] = c.g, p[2] = c.b, p[3] = c.a;
}

std::string encode_png(const Image& image, std::string_view title, std::string_view description) {
  assert(image.width > 0 && image.height > 0);
  bool opaque = true;
  for (std::size_t i = 3; opaque && i < image.pixels.size(); i += 4) opaque = image.pixels[i] == 255;
  // libpng wants NUL-terminated texts that it may change.
  std::string keywords[] = {"Title", "Description"}, contents[] = {std::string(title), std::string(description)};
  png_text texts[2] = {};
  int text_count = 0;
  for (int i = 0; i < 2; ++i) {
    if (contents[i].empty()) continue;
    png_text& text = texts[text_count++];
    text.compression = PNG_ITXT_COMPRESSION_NONE;
    text.key = keywords[i].data();
    text.text = contents[i].data();
  }
  std::vector<std::uint8_t> row(std::size_t{4} * static_cast<std::size_t>(image.width));
  std::string output, message;
  output.reserve(image.pixels.size() / 16 + 1024);
  [[maybe_unused]] const bool written = run(WriteJob{&image, &row, &output, &message, texts, text_count, opaque});
  assert(written);
  return output;
}

Checked<Image> decode_png(std::string_view bytes) {
  Image image;
  std::vector<png_bytep> rows;
  std::string message = "out of memory";
  ReadJob job{bytes, &image, &rows, &message};
  if (!run(job)) return Diagnostics{{"", 0, 0, "", "not a readable PNG picture: " + message}};
  return image;
}

Checked<Image> read_png(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return Diagnostics{{path.string(), 0, 0, "", std::string("cannot be read: ") + std::strerror(errno)}};
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  auto image = decode_png(bytes);
  for (auto& diagnostic : image.diagnostics) diagnostic.file = path.string();
  return image;
}

Checked<bool> write_png(const std::filesystem::path& path, const Image& image, std::string_view title,
                        std::string_view description) {
  return write_file(path, encode_png(image, title, description));
}

Image downscale(const Image& image, int width, int height) {
  assert(width > 0 && height > 0 && width <= image.width && height <= image.height);
  Image result(width, height);
  // Pixel weights along one axis: how much of source pixel i lies in [from, to).
  const auto share = [](double from, double to, int i) { return std::min(to, i + 1.0) - std::max(from, double(i)); };
  for (int y = 0; y < height; ++y) {
    const double top = double(y) * image.height / height, bottom = double(y + 1) * image.height / height;
    for (int x = 0; x < width; ++x) {
      const double left = double(x) * image.width / width, right = double(x + 1) * image.width / width;
      double sum[4] = {}, total = 0;
      for (int j = static_cast<int>(top); j < std::min(image.height, static_cast<int>(std::ceil(bottom))); ++j) {
        for (int i = static_cast<int>(left); i < std::min(image.width, static_cast<int>(std::ceil(right))); ++i) {
          const double weight = share(left, right, i) * share(top, bottom, j);
          const Color c = image.at(i, j);
          sum[0] += weight * c.r, sum[1] += weight * c.g, sum[2] += weight * c.b, sum[3] += weight * c.a;
          total += weight;
        }
      }
      const auto channel = [&](int k) { return static_cast<std::uint8_t>(std::lround(sum[k] / total)); };
      result.set(x, y, {channel(0), channel(1), channel(2), channel(3)});
    }
  }
  return result;
}

Image contact_sheet(const Fonts& fonts, const Theme& theme, std::span<const Image> images,
                    std::span<const std::string> captions, int columns, int thumbnail_width) {
  assert(images.size() == captions.size() && columns > 0 && thumbnail_width > 0);
  constexpr int gap = 16, caption_height = 26;
  constexpr double caption_size = 12;
  int thumbnail_height = 1;
  for (const auto& image : images) {
    thumbnail_height =
        std::max(thumbnail_height, static_cast<int>(std::lround(double(thumbnail_width) * image.height / image.width)));
  }
  const int count = static_cast<int>(images.size());
  const int used_columns = std::max(1, std::min(columns, count)), rows = (count + used_columns - 1) / used_columns;
  Image sheet(gap + used_columns * (thumbnail_width + gap), gap + rows * (thumbnail_height + caption_height + gap),
              theme.background);
  const Color frame = theme[Role::rule_line].color;
  for (int i = 0; i < count; ++i) {
    const Image& image = images[static_cast<std::size_t>(i)];
    const int left = gap + i % used_columns * (thumbnail_width + gap);
    const int top = gap + i / used_columns * (thumbnail_height + caption_height + gap);
    const int width = std::min(thumbnail_width, image.width);
    const int height = std::clamp(static_cast<int>(std::lround(double(width) * image.height / image.width)), 1,
                                  std::min(image.height, thumbnail_height));
    const Image small = downscale(image, width, height);
    for (int y = -1; y <= height; ++y) {
      for (int x = -1; x <= width; ++x) {
        const bool edge = x < 0 || y < 0 || x == width || y == height;
        sheet.set(left + x, top + y, edge ? frame : small.at(x, y));
      }
    }
    const std::string text = cut_to_width(fonts, captions[static_cast<std::size_t>(i)], thumbnail_width / caption_size);
    write_text(sheet, fonts, {text, double(left), double(top + height + 18), caption_size, {}}, theme[Role::text].ink);
  }
  return sheet;
}

ImageDifference difference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return {255, 255};
  ImageDifference result;
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const int d = std::abs(int{a.pixels[i]} - int{b.pixels[i]});
    result.max = std::max(result.max, d);
    sum += d;
  }
  result.mean = a.pixels.empty() ? 0 : sum / static_cast<double>(a.pixels.size());
  return result;
}

}  // namespace blossom
