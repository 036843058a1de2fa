#pragma once
// How far two pictures are apart: the largest difference of two blocks of 8 x 8 pixels, averaged, of 255. What is drawn
// counts, how its edges are smoothed does not; see tests/golden/README.md.

#include "render/image.hpp"

namespace blossom::test {

inline int block_difference(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) return 255;
  return difference(downscale(a, a.width / 8, a.height / 8), downscale(b, b.width / 8, b.height / 8)).max;
}
constexpr int tolerated_difference = 24;

}  // namespace blossom::test
