#pragma once
// How far two pictures are apart: the largest difference of two blocks of 8 x 8 pixels, averaged, of 255. What is drawn
// counts, how its edges are smoothed does not; see tests/golden/README.md.

#include <catch2/catch.hpp>
#include <cstdlib>

#include "render/image.hpp"

namespace blossom::test {

inline int block_difference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return 255;
  return difference(downscale(a, a.width / 8, a.height / 8), downscale(b, b.width / 8, b.height / 8)).max;
}
constexpr int tolerated_difference = 24;

// Whether it is the picture kept in this file; with BLOSSOM_UPDATE_GOLDEN it is kept from now on.
inline void check_golden(const std::string& file, const Image& made) {
  if (std::getenv("BLOSSOM_UPDATE_GOLDEN") != nullptr) {
    REQUIRE(write_png(file, made));
    WARN("written: " << file);
    return;
  }
  INFO(file << " differs; if that is meant: BLOSSOM_UPDATE_GOLDEN=1");
  const auto kept = read_png(file);
  INFO(to_string(kept.diagnostics));
  REQUIRE(kept);
  CHECK(difference(made, *kept).mean < 2);
  CHECK(block_difference(made, *kept) <= tolerated_difference);
}

}  // namespace blossom::test
