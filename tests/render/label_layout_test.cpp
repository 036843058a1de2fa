// Labels find room, or are left out.
#include "render/label_layout.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace blossom;

namespace {

bool overlap(const PixelRect& a, const PixelRect& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}
bool inside(const PixelRect& box, const PixelRect& view) {
  return box.x >= view.x && box.y >= view.y && box.right() <= view.right() && box.bottom() <= view.bottom();
}

}  // namespace

TEST_CASE("A lone label stands close to its point, to the upper right") {
  LabelLayout layout({0, 0, 200, 200});
  const auto box = layout.place(30, 16, 100, 100, true);
  REQUIRE(box);
  CHECK(box->x > 100);
  CHECK(box->bottom() < 100);
  CHECK(std::hypot(box->x - 100, box->bottom() - 100) < 8);
}

TEST_CASE("Labels never overlap each other or a marker, and never leave the view") {
  for (unsigned seed = 0; seed < 40; ++seed) {
    INFO("seed " << seed);
    std::mt19937 random(seed);
    const auto uniform = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
    const PixelRect view{uniform(-50, 300), uniform(-50, 300), uniform(80, 900), uniform(60, 600)};
    LabelLayout layout(view);
    struct Disc {
      double x, y, radius;
    };
    std::vector<Disc> markers;
    std::vector<PixelRect> placed;
    for (int i = 0; i < 60; ++i) {
      const Disc disc{uniform(view.x, view.right()), uniform(view.y, view.bottom()), uniform(2, 8)};
      layout.add_marker(disc.x, disc.y, disc.radius);
      markers.push_back(disc);
      layout.add_line(disc.x, disc.y, uniform(view.x, view.right()), uniform(view.y, view.bottom()), 1);
    }
    for (const auto& disc : markers) {
      const auto box = layout.place(uniform(8, 70), uniform(8, 24), disc.x, disc.y, true);
      if (!box) continue;
      CHECK(inside(*box, view));
      for (const auto& other : placed) CHECK_FALSE(overlap(*box, other));
      for (const auto& other : markers) {
        const double dx = std::max({box->x - other.x, other.x - box->right(), 0.0});
        const double dy = std::max({box->y - other.y, other.y - box->bottom(), 0.0});
        CHECK(std::hypot(dx, dy) >= other.radius - 1.5);  // a cell's width
      }
      placed.push_back(*box);
    }
    CHECK(placed.size() > 5);
  }
}

TEST_CASE("An optional label without room is left out; another one is still shown inside the view") {
  const PixelRect view{0, 0, 60, 40};
  LabelLayout layout(view);
  layout.add_label(view);
  CHECK_FALSE(layout.place(20, 12, 30, 20, true));
  const auto forced = layout.place(20, 12, 30, 20, false);
  REQUIRE(forced);
  CHECK(inside(*forced, view));
  CHECK_FALSE(layout.place(100, 12, 30, 20, true));
  CHECK(layout.place(100, 12, 30, 20, false)->x == view.x);
}

TEST_CASE("A label keeps off a line when there is room beside it") {
  LabelLayout layout({0, 0, 200, 200});
  layout.add_line(100, 100, 200, 0, 1);  // straight through the favourite place
  const auto box = layout.place(30, 16, 100, 100, true);
  REQUIRE(box);
  bool crossed = false;
  for (double t = 0; t <= 1; t += 0.001) {
    const double x = 100 + 100 * t, y = 100 - 100 * t;
    crossed = crossed || (x > box->x && x < box->right() && y > box->y && y < box->bottom());
  }
  CHECK_FALSE(crossed);
}
