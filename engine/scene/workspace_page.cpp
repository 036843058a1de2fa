// A picture of a scene: its title and what it is, the scene, and what the marks in it mean.
#include <algorithm>
#include <cmath>

#include "scene/panel_parts.hpp"
#include "scene/workspace_builder.hpp"

namespace blossom {
namespace {

constexpr double margin = 18, text_line = 19, legend_line = 21, swatch = 26, between = 20;
constexpr double legend_size = 0.85, summary_size = 0.95;

struct Meaning {
  Show show;
  Role role;
  Marker::Shape shape;
  bool line;
  const char* words;
};
// In the order of the legend.
constexpr Meaning meanings[] = {
    {Show::knots, Role::control_point, Marker::Shape::square, false, "knots"},
    {Show::net, Role::level_a, Marker::Shape::disc, true, "de Boor's net, level by level"},
    {Show::hull, Role::ratio_far, Marker::Shape::disc, true, "convex hull of the points in force"},
    {Show::circle, Role::ratio_near, Marker::Shape::disc, true, "circle of curvature, radius ρ"},
    {Show::sphere, Role::level_b, Marker::Shape::square, true, "sphere of curvature, radius R"},
    {Show::comb, Role::result, Marker::Shape::disc, true, "curvature comb"},
    {Show::hodograph, Role::level_b, Marker::Shape::cross, true, "hodograph: the derivative, from the origin"},
    {Show::projection, Role::level_b, Marker::Shape::disc, true, "the B-spline (wx, wy, w) it is projected from"},
    {Show::principal, Role::current, Marker::Shape::disc, true, "principal directions"},
};

struct Item {
  Role role;
  Marker::Shape shape;
  bool line;
  std::string words;
};

std::vector<Item> items_of(const Workspace& workspace) {
  const auto any = [&](Show show, bool of_curves, bool of_surfaces) {
    return std::ranges::any_of(workspace.objects, [&](const SceneObject& object) {
      const bool curve = std::holds_alternative<Curve<Exact>>(object.geometry);
      const bool surface = std::holds_alternative<Surface<Exact>>(object.geometry);
      return !object.hidden && object.shows[show] && ((curve && of_curves) || (surface && of_surfaces));
    });
  };
  std::vector<Item> items;
  for (const Meaning& meaning : meanings) {
    const auto& names = show_names();
    const auto name = std::ranges::find(names, meaning.show, &ShowName::show);
    if (any(meaning.show, name->of_curves, name->of_surfaces && meaning.show != Show::knots))
      items.push_back({meaning.role, meaning.shape, meaning.line, meaning.words});
  }
  if (any(Show::triad, true, false)) {
    const bool transport = any(Show::transport, true, false);
    items.push_back(
        {Role::current, Marker::Shape::disc, true,
         transport ? "T tangent, R and S turning as little as possible" : "T tangent, N normal, B binormal"});
  }
  if (any(Show::triad, false, true))
    items.push_back({Role::current, Marker::Shape::disc, true, "tangents and normal N"});
  return items;
}

// Sets the legend into rows; its height.
double add_items(View& view, const std::vector<Item>& items, double x, double y, double width) {
  double at = x, row = y;
  for (const Item& item : items) {
    const double length = swatch + 8 + parts::width_of(parts::ems(item.words), Role::text_quiet, legend_size);
    if (at > x && at + length > x + width) {
      at = x;
      row += legend_line;
    }
    if (item.line)
      parts::stroke(view, {{at, row - 4, 0}, {at + swatch, row - 4, 0}}, item.role,
                    item.role == Role::current || item.role == Role::ratio_near ? 0.6 : 1);
    view.markers.push_back({{at + swatch / 2, row - 4, 0},
                            item.role,
                            item.shape,
                            item.role == Role::current || item.role == Role::result ? 0.5 : 0.8});
    parts::text(view, at + swatch + 8, row, {{item.words}}, Role::text_quiet, legend_size);
    at += length + between;
  }
  return items.empty() ? 0 : row - y + legend_line;
}

}  // namespace

std::optional<std::size_t> mapped_object(const Workspace& workspace, std::size_t current) {
  const auto mapped = [](const SceneObject& object) {
    return !object.hidden && object.map != SurfaceMap::none && object.shows[Show::faces] &&
           std::holds_alternative<Surface<Exact>>(object.geometry);
  };
  const auto& all = workspace.objects;
  if (current < all.size() && mapped(all[current])) return current;
  const auto first = std::ranges::find_if(all, mapped);
  return first == all.end() ? std::nullopt : std::optional(static_cast<std::size_t>(first - all.begin()));
}

Scene WorkspaceScenes::page(const Workspace& workspace, const WorkspaceLook& look, double width, double height) const {
  Scene scene;
  scene.width = width;
  scene.height = height;
  scene.title = workspace.title;
  scene.description = workspace.summary;
  Sheet page;
  View& text = page.view;
  text.width = width;
  text.height = height;
  const double room = width - 2 * margin;

  double top = 0;
  if (!workspace.title.empty()) {
    const RichText title{{workspace.title, TextRun::Level::base, false, true}};
    parts::text(text, margin, 34, title, Role::text_strong,
                parts::size_to_fit(parts::ems(title), Role::text_strong, room, 1.3));
    top = 46;
  }
  const double ems = room / parts::width_of(1, Role::text, summary_size);
  for (const std::string& row : parts::wrapped(workspace.summary, ems)) {
    if (row.empty() || top > height / 4) break;
    top += text_line;
    parts::text(text, margin, top, {{row}}, Role::text_quiet, summary_size);
  }
  top += 12;

  const auto items = look.handles ? items_of(workspace) : std::vector<Item>{};
  View measured;
  const double legend = add_items(measured, items, margin, 0, room);
  const double bottom = height - (legend > 0 ? legend + 14 : margin / 2);
  if (legend > 0) {
    parts::fill(text, {0, bottom, width, height - bottom}, Role::panel);
    add_items(text, items, margin, bottom + 22, room);
  }

  Sheet drawn = view(workspace, width, std::max(bottom - top, 40.0), look);
  drawn.view.y = top;
  const auto mapped = mapped_object(workspace, look.current);
  scene.views.push_back(std::move(text));
  scene.views.push_back(std::move(drawn.view));
  if (mapped) {
    Sheet map;
    const double high =
        add_map_legend(map, workspace.objects[*mapped], map_range(workspace, *mapped, look), 10, 8, map_legend_width);
    map.view.x = margin;
    map.view.y = bottom - high - 22;
    map.view.width = map_legend_width + 20;
    map.view.height = high + 12;
    parts::Box box{0, 0, map.view.width, map.view.height};
    // Beneath, in a view of its own: filled areas are painted over meshes.
    View ground = map.view;
    ground.meshes.clear();
    ground.labels.clear();
    ground.polylines.clear();
    parts::fill(ground, box, Role::panel, 0.92);
    scene.views.push_back(std::move(ground));
    scene.views.push_back(std::move(map.view));
  }
  return scene;
}

}  // namespace blossom
