// PNG files, thumbnails and comparison of pictures.
#include "render/image.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace blossom;

namespace {

Image random_image(unsigned seed, int width, int height, bool opaque) {
  std::mt19937 random(seed);
  Image image(width, height);
  for (auto& byte : image.pixels) byte = static_cast<std::uint8_t>(random());
  for (std::size_t i = 3; opaque && i < image.pixels.size(); i += 4) image.pixels[i] = 255;
  return image;
}

}  // namespace

TEST_CASE("A picture survives PNG") {
  for (const bool opaque : {true, false}) {
    for (unsigned seed = 0; seed < 20; ++seed) {
      INFO("seed " << seed << ", opaque " << opaque);
      const Image image = random_image(seed, 1 + static_cast<int>(seed) * 7, 1 + static_cast<int>(seed) * 3, opaque);
      const std::string bytes = encode_png(image, "title", "description");
      const auto back = decode_png(bytes);
      REQUIRE(back);
      CHECK(*back == image);
      CHECK(bytes == encode_png(image, "title", "description"));
    }
  }
}

TEST_CASE("A PNG carries its title and description") {
  const std::string bytes = encode_png(Image(4, 4), "de Boor", "step 3 of 7");
  CHECK(bytes.find("de Boor") != std::string::npos);
  CHECK(bytes.find("step 3 of 7") != std::string::npos);
  CHECK(encode_png(Image(4, 4)).find("iTXt") == std::string::npos);
}

TEST_CASE("What is no PNG is a diagnostic") {
  const std::string good = encode_png(random_image(1, 40, 30, true));
  CHECK_FALSE(decode_png(""));
  CHECK_FALSE(decode_png("GIF89a"));
  for (std::size_t length = 0; length + 12 < good.size(); length += 97) CHECK_FALSE(decode_png(good.substr(0, length)));
  std::string flipped = good;
  flipped[good.size() / 2] = static_cast<char>(flipped[good.size() / 2] ^ 0x10);
  CHECK_FALSE(decode_png(flipped));
  // A header that promises 2^31 - 1 pixels a side.
  std::string huge = good;
  for (const std::size_t at : {std::size_t{16}, std::size_t{20}}) huge.replace(at, 4, "\x7f\xff\xff\xff");
  CHECK_FALSE(decode_png(huge));
  const auto missing = read_png("/nonexistent/picture.png");
  REQUIRE(missing.diagnostics.size() == 1);
  CHECK(missing.diagnostics[0].file == "/nonexistent/picture.png");
}

TEST_CASE("A thumbnail averages the area each pixel covers") {
  Image image(4, 2, {0, 0, 0, 255});
  for (int y = 0; y < 2; ++y) image.set(1, y, {200, 100, 0, 255}), image.set(2, y, {0, 0, 90, 255});
  const Image half = downscale(image, 2, 1);
  CHECK(half.at(0, 0) == Color{100, 50, 0, 255});
  CHECK(half.at(1, 0) == Color{0, 0, 45, 255});
  // 4 -> 3 columns: the first new pixel is all of column 0 and a third of column 1.
  CHECK(downscale(image, 3, 2).at(0, 0) == Color{50, 25, 0, 255});
  CHECK(downscale(image, 4, 2) == image);
}

TEST_CASE("A contact sheet shows every picture, with its caption below") {
  const auto fonts = Fonts::load();
  REQUIRE(fonts);
  const std::vector<Image> images = {Image(100, 60, {200, 0, 0, 255}), Image(100, 60, {0, 200, 0, 255}),
                                     Image(100, 60, {0, 0, 200, 255})};
  const std::vector<std::string> captions = {"one", "two", "a caption that is much wider than its thumbnail"};
  const Image sheet = contact_sheet(**fonts, light_theme(), images, captions, 2, 50);
  CHECK(sheet.width == 16 + 2 * (50 + 16));
  CHECK(sheet.height == 16 + 2 * (30 + 26 + 16));
  CHECK(sheet.at(16 + 25, 16 + 15) == Color{200, 0, 0, 255});
  CHECK(sheet.at(16 + 66 + 25, 16 + 15) == Color{0, 200, 0, 255});
  CHECK(sheet.at(16 + 25, 16 + 72 + 15) == Color{0, 0, 200, 255});
  int inked = 0, beyond = 0;
  for (int y = 16 + 72 + 32; y < sheet.height; ++y) {
    for (int x = 0; x < sheet.width; ++x) (x < 66 ? inked : beyond) += sheet.at(x, y).r < 128;
  }
  CHECK(inked > 20);
  CHECK(beyond == 0);
}

TEST_CASE("The difference of pictures is the largest and the mean of their channels'") {
  Image a(2, 1, {10, 10, 10, 255}), b = a;
  CHECK(difference(a, b).max == 0);
  b.set(1, 0, {10, 26, 10, 255});
  CHECK(difference(a, b).max == 16);
  CHECK(difference(a, b).mean == Approx(2));
  CHECK(difference(a, Image(1, 1)).max == 255);
}
