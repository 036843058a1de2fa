#include <algorithm>
#include <cmath>

#include "kernel/basis.hpp"
#include "scene/panel_parts.hpp"
#include "scene/workspace_view.hpp"

namespace blossom {
namespace {

using parts::Box;
using Level = TextRun::Level;

constexpr double bar_height = 22, heading_room = 20, label_room = 32;
constexpr double name_size = 0.8, value_size = 0.72;

struct Part {
  double value = 0;
  int i = 0, j = -1;
  RichText name;
};

double within(double value, double low, double high) {
  return std::isfinite(value) ? std::clamp(value, low, high) : low;
}

// N_i of the functions in force at u, from i = k - p.
struct InForce {
  int first = 0;
  std::vector<double> values;
};
InForce in_force(const std::vector<double>& knots, int degree, double u) {
  const double at =
      within(u, knots[static_cast<std::size_t>(degree)], knots[knots.size() - static_cast<std::size_t>(degree) - 1]);
  const int k = find_span<double>(knots, degree, at);
  InForce made{k - degree, std::vector<double>(static_cast<std::size_t>(degree) + 1)};
  basis_functions<double>(knots, degree, k, at, made.values);
  return made;
}

RichText function_name(bool rational, bool bezier, int i, int p) {
  return {{rational ? "R" : (bezier ? "B" : "N"), Level::base, true},
          {std::to_string(i) + "," + std::to_string(p), Level::sub}};
}

std::vector<Part> parts_of(const Curve<double>& curve, double u) {
  const InForce N = in_force(curve.knots, curve.degree, u);
  std::vector<Part> made;
  for (int r = 0; r <= curve.degree; ++r) {
    const int i = N.first + r;
    const double weight = curve.rational ? curve.points[static_cast<std::size_t>(i)].w : 1;
    made.push_back({N.values[static_cast<std::size_t>(r)] * weight, i, -1,
                    function_name(curve.rational, curve.bezier, i, curve.degree)});
  }
  return made;
}

std::vector<Part> parts_of(const Surface<double>& surface, double u, double v) {
  const auto [p, q] = surface.degree;
  const InForce M = in_force(surface.knots[0], p, u), N = in_force(surface.knots[1], q, v);
  std::vector<Part> made;
  for (int r = 0; r <= p; ++r)
    for (int s = 0; s <= q; ++s) {
      const int i = M.first + r, j = N.first + s;
      RichText name;
      if (surface.rational) {
        name = {{"R", Level::base, true}, {std::to_string(i) + "," + std::to_string(j), Level::sub}};
      } else {
        const char* letter = surface.bezier ? "B" : "N";
        name = {{letter, Level::base, true},
                {std::to_string(i), Level::sub},
                {letter, Level::base, true},
                {std::to_string(j), Level::sub}};
      }
      made.push_back({M.values[static_cast<std::size_t>(r)] * N.values[static_cast<std::size_t>(s)] *
                          (surface.rational ? surface.at(i, j).w : 1),
                      i, j, std::move(name)});
    }
  return made;
}

// Told apart without colour as well: full, or with lines across or along.
void pattern(View& view, const Box& box, int i, double strength) {
  const Role role = parts::cycle(i);
  const int look = i % parts::cycle_length;
  parts::fill(view, box, role, (look == 0 || look == 3 ? 0.5 : 0.15) * strength);
  if (look == 1 || look == 4)
    for (double at = box.y + 4; at < box.bottom(); at += 5)
      parts::stroke(view, {{box.x, at, 0}, {box.right(), at, 0}}, role, 0.5 * strength);
  if (look == 2 || look == 4)
    for (double at = box.x + 3; at < box.right(); at += 5)
      parts::stroke(view, {{at, box.y, 0}, {at, box.bottom(), 0}}, role, 0.5 * strength);
  parts::stroke(view, {{box.right(), box.y, 0}, {box.right(), box.bottom(), 0}}, Role::text, 0.6);
}

}  // namespace

double add_partition_bar(Sheet& sheet, const Geometry& geometry, double u, double v, double x, double y, double width) {
  std::vector<Part> all;
  if (const auto* curve = std::get_if<Curve<Exact>>(&geometry))
    all = parts_of(convert<double>(*curve), u);
  else if (const auto* surface = std::get_if<Surface<Exact>>(&geometry))
    all = parts_of(convert<double>(*surface), u, v);
  double sum = 0, sizes = 0;
  for (const Part& part : all) sum += part.value;
  if (all.empty() || !(std::abs(sum) > 1e-300)) return 0;  // the weight is 0 here
  for (Part& part : all) {
    part.value /= sum;
    sizes += std::abs(part.value);
  }
  View& view = sheet.view;
  const bool surface = all[0].j >= 0;
  parts::text(view, x, y + 12, {{"Partition of unity", Level::base, false, true}}, Role::text_quiet, 0.85);
  parts::text(view, x + width, y + 12, {{"sum = 1"}}, Role::text_quiet, 0.8, Label::Placement::right);
  double at = x, taken = x - 4;
  const Box bar{x, y + heading_room, width, bar_height};
  for (const Part& part : all) {
    // Negative shares, of negative weights, count by their size and are empty.
    const double length = width * std::abs(part.value) / sizes;
    const Box box{at, bar.y, length, bar.height};
    at += length;
    if (length < 0.5) continue;
    if (part.value > 0) pattern(view, box, part.i, surface && part.j % 2 == 1 ? 0.55 : 1);
    const std::string name =
        surface ? "basis " + std::to_string(part.i) + "," + std::to_string(part.j) : "basis " + std::to_string(part.i);
    sheet.spots.push_back(
        {{Link::Kind::basis, static_cast<std::uint32_t>(part.i), static_cast<std::uint32_t>(std::max(part.j, 0))},
         box.x,
         box.y,
         box.width,
         box.height,
         name});
    const RichText value{{parts::significant(part.value)}};
    const double half = std::max(parts::width_of(part.name, Role::text, name_size),
                                 parts::width_of(value, Role::text_quiet, value_size)) /
                        2;
    const double middle = std::clamp(box.x + length / 2, x + half, std::max(x + half, x + width - half));
    if (middle - half < taken + 4 || half > length / 2 + 14) continue;
    taken = middle + half;
    parts::text(view, middle, bar.bottom() + 15, part.name, Role::text, name_size, Label::Placement::centre);
    parts::text(view, middle, bar.bottom() + 28, value, Role::text_quiet, value_size, Label::Placement::centre);
  }
  parts::outline(view, bar, Role::text, 0.8);
  return heading_room + bar_height + label_room;
}

}  // namespace blossom
