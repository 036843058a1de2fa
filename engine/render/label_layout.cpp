#include "render/label_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace blossom {
namespace {

constexpr double most_cells = 400'000;
constexpr double edge = 2;  // labels keep away from the edge of the view by this much

// Distances of the rings from the anchor, in page units; the first clears a point without marker.
constexpr std::array<double, 11> rings = {5, 8, 11, 15, 20, 27, 36, 48, 64, 90, 130};

struct Direction {
  double cosine, sine;  // y down
  double taste;         // what a label costs there
};
const std::array<Direction, 16>& directions() {
  static const auto all = [] {
    std::array<Direction, 16> made{};
    for (std::size_t k = 0; k < made.size(); ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(made.size());
      made[k] = {std::cos(angle), -std::sin(angle), 3 * (1 - std::cos(angle - std::numbers::pi / 4)) / 2};
    }
    return made;
  }();
  return all;
}

}  // namespace

// The memory of a thread's last layout, for its next one: asking the system for a megabyte in every frame takes four
// times as long as placing the labels of a page.
LabelLayout::Raster& LabelLayout::spare() {
  thread_local Raster raster;
  return raster;
}

LabelLayout::~LabelLayout() { spare() = std::move(raster_); }

LabelLayout::LabelLayout(const PixelRect& view) : view_(view), raster_(std::exchange(spare(), {})) {
  cell_ = std::max(1.5, std::sqrt(view.width * view.height / most_cells));
  columns_ = std::max(1, static_cast<int>(std::ceil(view.width / cell_)));
  rows_ = std::max(1, static_cast<int>(std::ceil(view.height / cell_)));
  raster_.blocked.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
  raster_.ink.assign(raster_.blocked.size(), 0);
}

LabelLayout::Cells LabelLayout::cells_of(const PixelRect& box) const {
  const auto cell = [this](double offset, int limit, bool up) {
    const double c = up ? std::ceil(offset / cell_) : std::floor(offset / cell_);
    return static_cast<int>(std::clamp(c, 0.0, static_cast<double>(limit)));
  };
  return {cell(box.x - view_.x, columns_, false), cell(box.y - view_.y, rows_, false),
          cell(box.right() - view_.x, columns_, true), cell(box.bottom() - view_.y, rows_, true)};
}

void LabelLayout::block(const PixelRect& box) {
  const Cells cells = cells_of(box);
  for (int row = cells.top; row < cells.bottom; ++row) {
    const auto start = raster_.blocked.begin() + static_cast<std::ptrdiff_t>(row) * columns_;
    if (cells.left < cells.right) std::fill(start + cells.left, start + cells.right, std::uint8_t{1});
  }
}

void LabelLayout::add_marker(double x, double y, double radius) {
  const Cells rows = cells_of({x - radius, y - radius, 2 * radius, 2 * radius});
  for (int row = rows.top; row < rows.bottom; ++row) {
    // The chord of the disc at the row's nearest height.
    const double top = view_.y + row * cell_, height = std::clamp(y, top, top + cell_) - y;
    const double half = std::sqrt(std::max(0.0, radius * radius - height * height));
    block({x - half, top + cell_ / 4, 2 * half, cell_ / 2});
  }
}

void LabelLayout::add_label(const PixelRect& box) { block(box); }

void LabelLayout::add_line(double ax, double ay, double bx, double by, double ink) {
  const double length = std::hypot(bx - ax, by - ay);
  const double most_steps = 4.0 * (columns_ + rows_);
  const int steps = static_cast<int>(std::clamp(std::ceil(length / cell_ * 1.5), 1.0, most_steps));
  // In cells from here on; a number that is none, or far outside, must not become an int.
  const double column = (ax - view_.x) / cell_, row = (ay - view_.y) / cell_;
  const double across = (bx - ax) / cell_ / steps, down = (by - ay) / cell_ / steps;
  const auto cost = static_cast<float>(ink * cell_ / 2);
  for (int i = 0; i <= steps; ++i) {
    const double x = column + i * across, y = row + i * down;
    if (!(x >= 0 && x < columns_ && y >= 0 && y < rows_)) continue;
    float& cell =
        raster_.ink[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)];
    cell = std::max(cell, cost);
  }
}

LabelLayout::Cost LabelLayout::cost_of(const PixelRect& box, bool stop_when_blocked) const {
  Cost cost;
  const Cells cells = cells_of(box);
  for (int row = cells.top; row < cells.bottom; ++row) {
    for (int column = cells.left; column < cells.right; ++column) {
      const std::size_t i =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
      cost.ink += raster_.ink[i];
      cost.blocked += raster_.blocked[i];
      if (stop_when_blocked && cost.blocked > 0) return cost;
    }
  }
  return cost;
}

std::optional<PixelRect> LabelLayout::place(double width, double height, double anchor_x, double anchor_y,
                                            bool optional) {
  // A label larger than the view can only start at its upper left corner.
  const double x_least = view_.x + edge, x_most = view_.right() - edge - width;
  const double y_least = view_.y + edge, y_most = view_.bottom() - edge - height;
  if (x_most < x_least || y_most < y_least) {
    if (optional) return std::nullopt;
    const PixelRect box{std::max(view_.x, std::min(x_least, x_most)), std::max(view_.y, std::min(y_least, y_most)),
                        width, height};
    block(box);
    return box;
  }

  std::optional<PixelRect> best, least_covered;
  double best_cost = std::numeric_limits<double>::infinity();
  int least_blocked = std::numeric_limits<int>::max();
  for (const double ring : rings) {
    if (ring - rings[0] >= best_cost) break;  // farther rings cannot be cheaper
    for (const auto& [cosine, sine, taste] : directions()) {
      // The box touches the ring from outside where it can: its centre moves on a rounded rectangle.
      const double centre_x = anchor_x + cosine * ring + std::clamp(cosine * 1.42, -1.0, 1.0) * width / 2;
      const double centre_y = anchor_y + sine * ring + std::clamp(sine * 1.42, -1.0, 1.0) * height / 2;
      PixelRect box{centre_x - width / 2, centre_y - height / 2, width, height};
      const bool outside = box.x < x_least || box.x > x_most || box.y < y_least || box.y > y_most;
      if (outside && optional) continue;
      box.x = std::clamp(box.x, x_least, x_most);
      box.y = std::clamp(box.y, y_least, y_most);
      const Cost found = cost_of(box, optional);
      if (found.blocked > 0) {
        if (!optional && found.blocked < least_blocked) {
          least_blocked = found.blocked;
          least_covered = box;
        }
        continue;
      }
      const double moved = outside ? 4 : 0;
      const double cost = ring - rings[0] + found.ink + taste + moved;
      if (cost < best_cost) {
        best_cost = cost;
        best = box;
      }
    }
  }
  if (!best && !optional) best = least_covered;
  if (best) block(*best);
  return best;
}

}  // namespace blossom
