#pragma once
// What lines with knots on them share, wherever the knots come from.

#include <optional>

#include "scene/panel_parts.hpp"

namespace blossom::parts {

// Equal knots.
struct Knot {
  std::size_t first = 0, count = 0;  // among all
  double at = 0;                     // on the line, in page units
  RichText label;
  bool quiet = false;
};

// The knot's value, and how often it is there: "1/2 ×3".
RichText knot_label(const std::string& value, std::size_t count);

inline constexpr double knot_reach = 8;  // of a knot's spot around the line

// In a second row where one is not enough; and where two are not, in one row, as many as there is room for.
void set_knot_labels(View&, const std::vector<Knot>&, double line, double left, double right, int most_rows);

// One rectangle each, without overlaps: neighbours share the room between them, and u goes before the knot it is at.
void add_knot_spots(Sheet&, const std::vector<Knot>&, const std::optional<Box>& u, double bottom, double line);

}  // namespace blossom::parts
