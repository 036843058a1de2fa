#pragma once
// What the panels share: boxes, labels, and how wide text will be. A scene knows no fonts, so widths are estimates from
// the letters of DejaVu Sans, in the theme with the largest text, and rather too wide than too narrow.

#include <string>
#include <string_view>
#include <vector>

#include "scene/source.hpp"
#include "scene/spot.hpp"

namespace blossom::parts {

struct Box {
  double x = 0, y = 0, width = 0, height = 0;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
  bool meets(const Box& other, double gap = 0) const {
    return x < other.right() + gap && other.x < right() + gap && y < other.bottom() + gap && other.y < bottom() + gap;
  }
};

double ems(std::string_view utf8, bool bold = false, bool monospace = false);
double ems(const RichText&);
// In page units, set in a role at a size.
double width_of(double ems, Role, double size);
inline double width_of(const RichText& text, Role role, double size) { return width_of(ems(text), role, size); }

// The largest size up to `most` at which the text is at most `width` wide.
double size_to_fit(double ems, Role, double width, double most);

// Broken at blanks into lines of at most so many ems, `hanging` less behind the first; words that are longer are broken
// where they must.
std::vector<std::string> wrapped(std::string_view text, double most_ems, bool bold = false, bool monospace = false,
                                 double hanging = 0);
// The beginning and the end of a text of at most so many characters.
std::string shortened(std::string_view text, std::size_t most);

// To so many significant digits: 0.00123, 12.3, 45600.
std::string significant(double value, int digits = 3);

void fill(View&, const Box&, Role, double opacity = 1);
void outline(View&, const Box&, Role, double width_scale = 1, bool dashed = false);
void stroke(View&, std::vector<glm::dvec3> points, Role, double width_scale = 1, bool dashed = false);
Label& text(View&, double x, double y, RichText, Role, double size = 1, Label::Placement = Label::Placement::left);
// Adds the heading of a panel, smaller where it would be wider than that; its height.
double heading(View&, double x, double y, const std::string& words, double width = 1e9);

// The other share of a division, in the manner of the first: 3/5 beside 2/5.
std::string other_share(const std::string& share, double value);

// The numbers on the arrows into a value of a scheme, one for each operand; empty where the rule gives none.
std::vector<std::string> weights_of(const StepSource&, ValueId);

// How much of a value came from another one: as a fraction where the run is exact and a short one fits.
std::string share_text(const StepSource&, double share);

// The role of the i-th of several things of one kind. Five, for a cubic curve has four basis functions in each span.
inline constexpr int cycle_length = 5;
inline Role cycle(int i) {
  static constexpr Role roles[cycle_length] = {Role::level_a, Role::level_b, Role::level_c, Role::curve_result,
                                               Role::ratio_near};
  return roles[i % cycle_length];
}

}  // namespace blossom::parts
