#include "render/glyph_atlas.hpp"

#include <algorithm>
#include <cmath>

namespace blossom {

void GlyphAtlas::clear() {
  places_.clear();
  side_ = first_side;
  pixels_.assign(std::size_t{first_side} * first_side, 0);
  shelf_x_ = shelf_y_ = shelf_height_ = 0;
  changed_first_ = 0;
  changed_last_ = side_;
  full_ = false;
}

std::pair<int, int> GlyphAtlas::take_changed_rows() {
  return {std::exchange(changed_first_, side_), std::exchange(changed_last_, 0)};
}

void GlyphAtlas::grow() {
  const int old_side = std::exchange(side_, 2 * side_);
  std::vector<std::uint8_t> larger(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_), 0);
  for (int row = 0; row < old_side; ++row) {
    std::copy_n(pixels_.begin() + static_cast<std::ptrdiff_t>(row) * old_side, old_side,
                larger.begin() + static_cast<std::ptrdiff_t>(row) * side_);
  }
  pixels_ = std::move(larger);
  changed_first_ = 0;
  changed_last_ = side_;
}

bool GlyphAtlas::allocate(int width, int height, int& x, int& y) {
  for (;;) {
    if (shelf_x_ + width > side_) {
      shelf_y_ += shelf_height_;
      shelf_x_ = shelf_height_ = 0;
    }
    if (width <= side_ && shelf_y_ + height <= side_) break;
    if (side_ == last_side) return false;
    grow();
  }
  x = shelf_x_;
  y = shelf_y_;
  shelf_x_ += width;
  shelf_height_ = std::max(shelf_height_, height);
  return true;
}

const GlyphAtlas::Place& GlyphAtlas::find(FontStyle style, char32_t c, double size, int quarter, double halo) {
  const auto size64 = static_cast<std::uint64_t>(std::lround(size * 64));
  const auto halo64 = static_cast<std::uint64_t>(std::lround(halo * 64));
  const std::uint64_t look = (style.bold ? 1u : 0u) | (style.italic ? 2u : 0u) | (style.monospace ? 4u : 0u) |
                             static_cast<std::uint64_t>(quarter) << 3;
  const Key key{std::uint64_t{c} << 8 | look, size64 << 32 | halo64};
  if (const auto found = places_.find(key); found != places_.end()) return found->second;
  const auto bitmap =
      fonts_->bitmap(style, c, static_cast<double>(size64) / 64, quarter, static_cast<double>(halo64) / 64);
  Place place{0, 0, bitmap.width, bitmap.height, bitmap.left, bitmap.top};
  if (bitmap.width == 0 || bitmap.height == 0) {
    place = {};
  } else if (!allocate(bitmap.width, bitmap.height, place.x, place.y)) {
    full_ = true;
    place = {};
  } else {
    for (int row = 0; row < place.height; ++row) {
      std::copy_n(bitmap.coverage.begin() + static_cast<std::ptrdiff_t>(row) * bitmap.width, bitmap.width,
                  pixels_.begin() + static_cast<std::ptrdiff_t>(place.y + row) * side_ + place.x);
    }
    changed_first_ = std::min(changed_first_, place.y);
    changed_last_ = std::max(changed_last_, place.y + place.height);
  }
  return places_[key] = place;
}

}  // namespace blossom
