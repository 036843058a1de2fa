#pragma once
// Glyph bitmaps packed into one growing picture, the source of the canvas's texture. Places are in pixels and stay
// valid while the atlas grows.

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "render/font.hpp"

namespace blossom {

class GlyphAtlas {
 public:
  struct Place {
    int x = 0, y = 0, width = 0, height = 0;  // in the atlas; width 0: nothing to draw
    int left = 0, top = 0;                    // as in GlyphBitmap
  };

  explicit GlyphAtlas(std::shared_ptr<const Fonts> fonts) : fonts_(std::move(fonts)) { clear(); }

  // `size` and `halo` in pixels, rounded to 1/64; `quarter` as for Fonts::bitmap. A glyph that finds no room any more
  // (a page of tens of thousands of different ones) is empty until the atlas is cleared.
  const Place& find(FontStyle, char32_t, double size, int quarter, double halo);
  void clear();
  bool full() const { return full_; }

  int side() const { return side_; }
  const std::vector<std::uint8_t>& pixels() const { return pixels_; }  // side rows of side
  // Rows changed since the last call, [first, last).
  std::pair<int, int> take_changed_rows();

 private:
  struct Key {
    std::uint64_t letter, size;
    bool operator==(const Key&) const = default;
  };
  struct KeyHash {
    std::size_t operator()(const Key& key) const {
      return static_cast<std::size_t>((key.letter * 0x9E3779B97F4A7C15u) ^ (key.size * 0xC2B2AE3D27D4EB4Fu));
    }
  };
  bool allocate(int width, int height, int& x, int& y);
  void grow();

  static constexpr int first_side = 1024, last_side = 4096;
  std::shared_ptr<const Fonts> fonts_;
  std::unordered_map<Key, Place, KeyHash> places_;
  std::vector<std::uint8_t> pixels_;
  int side_ = 0;
  int shelf_x_ = 0, shelf_y_ = 0, shelf_height_ = 0;  // glyphs stand in rows, left to right
  int changed_first_ = 0, changed_last_ = 0;
  bool full_ = false;
};

}  // namespace blossom
