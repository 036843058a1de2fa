#include <algorithm>
#include <cmath>

#include "scene/panel_parts.hpp"
#include "scene/workspace_view.hpp"

namespace blossom {
namespace {

using parts::Box;
using Level = TextRun::Level;

constexpr double left_room = 46, bottom_room = 40, top_room = 20, right_room = 14;
constexpr double label_size = 0.72, reach = 8;

struct Knot {
  std::size_t first = 0, count = 0;
  double value = 0;
};

// Those of the domain.
std::vector<Knot> knots_within(const std::vector<double>& knots, double begin, double end) {
  std::vector<Knot> found;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (knots[i] < begin || knots[i] > end) continue;
    if (!found.empty() && found.back().value == knots[i])
      ++found.back().count;
    else
      found.push_back({i, 1, knots[i]});
  }
  return found;
}

std::string words(const Knot& knot) { return std::to_string(knot.count) + "(" + parts::significant(knot.value) + ")"; }

double ratio(double value, double first, double last) { return last > first ? (value - first) / (last - first) : 0.5; }

}  // namespace

glm::dvec2 DomainSquare::place(glm::dvec2 uv) const {
  return {left + side * ratio(uv.x, first.x, last.x), top + side * (1 - ratio(uv.y, first.y, last.y))};
}

glm::dvec2 DomainSquare::parameter(glm::dvec2 at) const {
  if (!(side > 0)) return first;
  const glm::dvec2 share = glm::clamp(glm::dvec2{(at.x - left) / side, 1 - (at.y - top) / side}, 0.0, 1.0);
  return first + share * (last - first);
}

DomainSquare add_domain_square(Sheet& sheet, const Surface<double>& surface, glm::dvec2 uv, double x, double y,
                               double size) {
  DomainSquare square;
  square.left = x + left_room;
  square.top = y + top_room;
  square.side = std::max(size - std::max(left_room + right_room, top_room + bottom_room), 1.0);
  const auto [p, q] = surface.degree;
  square.first = {surface.knots[0][static_cast<std::size_t>(p)], surface.knots[1][static_cast<std::size_t>(q)]};
  square.last = {surface.knots[0][static_cast<std::size_t>(surface.rows)],
                 surface.knots[1][static_cast<std::size_t>(surface.columns)]};
  uv = glm::clamp(uv, square.first, square.last);
  View& view = sheet.view;
  const double left = square.left, top = square.top, right = left + square.side, bottom = top + square.side;
  const Box box{left, top, square.side, square.side};
  parts::fill(view, box, Role::panel);
  const auto in_u = knots_within(surface.knots[0], square.first.x, square.last.x);
  const auto in_v = knots_within(surface.knots[1], square.first.y, square.last.y);
  for (const Knot& knot : in_u) {
    const double at = square.place({knot.value, square.first.y}).x;
    parts::stroke(view, {{at, top, 0}, {at, bottom, 0}}, Role::rule_line);
    view.markers.push_back({{at, bottom, 0}, Role::control_point, Marker::Shape::triangle, 0.8});
  }
  for (const Knot& knot : in_v) {
    const double at = square.place({square.first.x, knot.value}).y;
    parts::stroke(view, {{left, at, 0}, {right, at, 0}}, Role::rule_line);
    view.markers.push_back({{left, at, 0}, Role::control_point, Marker::Shape::square, 0.7});
  }
  parts::outline(view, box, Role::polygon, 0.8);

  // Labels that have room, both ends first.
  std::vector<Box> taken;
  const auto label = [&](const Knot& knot, bool along_u) {
    const RichText text{{words(knot)}};
    const double width = parts::width_of(text, Role::text_quiet, label_size);
    const glm::dvec2 at =
        square.place(along_u ? glm::dvec2{knot.value, square.first.y} : glm::dvec2{square.first.x, knot.value});
    const Box place = along_u ? Box{std::min(at.x - width / 2, x + size - width), bottom + 9, width, 12}
                              : Box{left - 8 - width, at.y - 6, width, 12};
    if (std::ranges::any_of(taken, [&](const Box& other) { return place.meets(other, 2); })) return;
    taken.push_back(place);
    parts::text(view, place.x, place.y + 10, text, Role::text_quiet, label_size);
  };
  for (const bool along_u : {true, false}) {
    const auto& knots = along_u ? in_u : in_v;
    if (knots.empty()) continue;
    label(knots.front(), along_u);
    label(knots.back(), along_u);
    for (std::size_t i = 1; i + 1 < knots.size(); ++i) label(knots[i], along_u);
  }

  const glm::dvec2 at = square.place(uv);
  parts::stroke(view, {{left, at.y, 0}, {right, at.y, 0}}, Role::result, 0.45);
  parts::stroke(view, {{at.x, top, 0}, {at.x, bottom, 0}}, Role::result, 0.45);
  view.markers.push_back({{at.x, at.y, 0}, Role::result, Marker::Shape::diamond, 1});
  const auto number = [](const char* name, double value) {
    return RichText{{name, Level::base, true}, {" = " + parts::significant(value)}};
  };
  parts::text(view, left, top - 7, number("v", uv.y), Role::text_current, 0.85);
  parts::text(view, right, bottom + 36, number("u", uv.x), Role::text_current, 0.85, Label::Placement::right);

  // Each knot's spot goes as far as halfway to its neighbours.
  for (const bool along_u : {true, false}) {
    const auto& knots = along_u ? in_u : in_v;
    const auto place = [&](std::size_t i) {
      return along_u ? square.place({knots[i].value, 0}).x : square.place({0, knots[i].value}).y;
    };
    for (std::size_t i = 0; i < knots.size(); ++i) {
      double half = reach;
      if (i > 0) half = std::min(half, std::abs(place(i) - place(i - 1)) / 2);
      if (i + 1 < knots.size()) half = std::min(half, std::abs(place(i) - place(i + 1)) / 2);
      const Link link{Link::Kind::knot, static_cast<std::uint32_t>(knots[i].first), along_u ? 0u : 1u};
      const std::string name = std::string(along_u ? "u" : "v") + " knot " + std::to_string(knots[i].first);
      if (along_u)
        sheet.spots.push_back({link, place(i) - half, bottom - reach, 2 * half, 26, name});
      else
        sheet.spots.push_back({link, x, place(i) - half, left_room + reach, 2 * half, name});
    }
  }
  sheet.spots.push_back({{Link::Kind::parameter, 0}, at.x - 10, at.y - 10, 20, 20, "(u, v)"});
  return square;
}

}  // namespace blossom
