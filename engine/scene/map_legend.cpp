#include <array>

#include "scene/panel_parts.hpp"
#include "scene/workspace_builder.hpp"

namespace blossom {
namespace {

constexpr double heading_room = 20, bar_height = 14, numbers_room = 18, line_room = 15;
constexpr double small = 0.78;

// What the two ends of the colours mean.
std::array<const char*, 2> meaning(SurfaceMap map) {
  switch (map) {
    case SurfaceMap::gaussian:
      return {"saddle", "dome or bowl"};
    case SurfaceMap::mean:
    case SurfaceMap::largest:
    case SurfaceMap::smallest:
      return {"away from the normal", "towards it"};
    default:
      return {"", ""};
  }
}

void add_colors(View& view, double x, double y, double width, ColorMap map, int count) {
  Mesh band;
  band.map = map;
  const bool stripes = map == ColorMap::bands;
  for (int i = 0; i < count; ++i)
    for (const int end : {0, 1}) {
      const double at = x + width * (i + end) / count;
      for (const double edge : {y, y + bar_height}) band.positions.push_back({at, edge, 0});
      const float value =
          stripes ? static_cast<float>((i + 1) % 2) : static_cast<float>(i + end) / static_cast<float>(count);
      band.values.insert(band.values.end(), {value, value});
      if (end == 0) continue;
      const auto first = static_cast<std::uint32_t>(band.positions.size()) - 4;
      band.indices.insert(band.indices.end(), {first, first + 1, first + 3, first, first + 3, first + 2});
    }
  view.meshes.push_back(std::move(band));
}

}  // namespace

double add_map_legend(Sheet& sheet, const SceneObject& object, double range, double x, double y, double width) {
  if (object.map == SurfaceMap::none) return 0;
  View& view = sheet.view;
  const std::string title(surface_map_title(object.map));
  parts::text(view, x, y + 12, {{title, TextRun::Level::base, false, true}}, Role::text_quiet, 0.85);
  const double bar = y + heading_room;
  const parts::Box box{x, bar, width, bar_height};
  double at = bar + bar_height;
  if (!has_range(object.map)) {
    add_colors(view, x, bar, width, ColorMap::bands, 12);
    parts::outline(view, box, Role::rule_line);
    const char* words =
        object.map == SurfaceMap::isophotes
            ? "Along the edge of a stripe the light falls at one angle. A stripe that breaks: a crease; "
              "one with a kink: a jump of the curvature."
            : "Rows of lamps, mirrored. Stripes that wave show a bump; one that breaks, a crease.";
    const double size = small;
    at += 6;
    for (const std::string& row : parts::wrapped(words, width / parts::width_of(1, Role::text_quiet, size))) {
      at += line_room - 1;
      parts::text(view, x, at, {{row}}, Role::text_quiet, size);
    }
    return at + 6 - y;
  }
  add_colors(view, x, bar, width, ColorMap::diverging, 32);
  parts::outline(view, box, Role::rule_line);
  at += numbers_room - 3;
  const std::string most = range > 0 ? parts::significant(range, 2) : "0";
  parts::text(view, x, at, {{range > 0 ? "−" + most : most}}, Role::text_quiet, small);
  parts::text(view, x + width / 2, at, {{"0"}}, Role::text_quiet, small, Label::Placement::centre);
  parts::text(view, x + width, at, {{most}}, Role::text_quiet, small, Label::Placement::right);
  const auto [less, more] = meaning(object.map);
  const double size = parts::size_to_fit(parts::ems(less) + parts::ems(more) + 1, Role::text_quiet, width, small);
  at += line_room - 1;
  parts::text(view, x, at, {{less}}, Role::text_quiet, size);
  parts::text(view, x + width, at, {{more}}, Role::text_quiet, size, Label::Placement::right);
  return at + 6 - y;
}

}  // namespace blossom
