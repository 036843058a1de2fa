#pragma once
// Finds room for labels around their anchors. The view is a raster of small cells; a cell is blocked (by a marker, by a
// label) or carries ink (lines), which a label avoids when it can. Works in page units, so that a picture has the same
// layout at every scale and on every canvas.

#include <cstdint>
#include <optional>
#include <vector>

#include "render/canvas.hpp"

namespace blossom {

class LabelLayout {
 public:
  explicit LabelLayout(const PixelRect& view);
  ~LabelLayout();
  LabelLayout(const LabelLayout&) = delete;
  LabelLayout& operator=(const LabelLayout&) = delete;

  void add_marker(double x, double y, double radius);
  void add_label(const PixelRect&);  // one whose place is given
  // `ink`: the cost of covering two units of the line, in units of distance from the anchor.
  void add_line(double ax, double ay, double bx, double by, double ink);

  // A place for a label of that size around the anchor, inside the view, on no other label and no marker; it is taken
  // from then on. The candidates stand on rings around the anchor; the cheapest counts distance, ink covered, and a
  // taste for the upper right. When every one is blocked: nothing for an optional label, else the least covered one.
  std::optional<PixelRect> place(double width, double height, double anchor_x, double anchor_y, bool optional);

 private:
  struct Cells {
    int left, top, right, bottom;  // half open
  };
  struct Cost {
    double ink = 0;
    int blocked = 0;
  };
  Cells cells_of(const PixelRect&) const;
  Cost cost_of(const PixelRect&, bool stop_when_blocked) const;
  void block(const PixelRect&);

  PixelRect view_;
  double cell_ = 1.5;  // page units
  int columns_ = 0, rows_ = 0;
  struct Raster {
    std::vector<std::uint8_t> blocked;
    std::vector<float> ink;
  };
  static Raster& spare();
  Raster raster_;
};

}  // namespace blossom
