#include "studio/workspace.hpp"

#include <algorithm>
#include <array>

#include "base/utf8.hpp"

namespace blossom {
namespace {

constexpr std::size_t most_characters = 64;

}  // namespace

std::string_view geometry_key(const Geometry& geometry) {
  constexpr std::array<std::string_view, 4> keys{"curve", "surface", "points", "net"};
  return keys[geometry.index()];
}

const std::vector<ShowName>& show_names() {
  static const std::vector<ShowName> names{
      {Show::points, "points", "Control points", true, true},
      {Show::indices, "indices", "Indices", true, true},
      {Show::polygon, "polygon", "Control polygon or net", true, true},
      {Show::knots, "knots", "Knots", true, true},
      {Show::point, "point", "Point at u, or (u, v)", true, true},
      {Show::hull, "hull", "Convex hull in force", true, false},
      {Show::net, "net", "De Casteljau or de Boor net", true, true},
      {Show::triad, "triad", "Moving triad", true, true},
      {Show::transport, "transport", "Rotation-minimising frame", true, false},
      {Show::circle, "circle", "Circle of curvature", true, false},
      {Show::sphere, "sphere", "Sphere of curvature", true, false},
      {Show::comb, "comb", "Curvature comb", true, false},
      {Show::hodograph, "hodograph", "Hodograph", true, false},
      {Show::projection, "projection", "Projected from one dimension up", true, false},
      {Show::isolines, "isolines", "Isoparametric curves", false, true},
      {Show::principal, "principal", "Principal directions", false, true},
      {Show::faces, "faces", "Shaded faces", false, true},
  };
  return names;
}

Shows usual_shows(const Geometry& geometry) {
  Shows shows;
  shows.set(Show::points, true);
  shows.set(Show::polygon, true);
  if (std::holds_alternative<Surface<Exact>>(geometry)) {
    shows.set(Show::faces, true);
    shows.set(Show::isolines, true);
  }
  return shows;
}

namespace {

struct MapName {
  std::string_view id, title;
};
constexpr std::array<MapName, surface_map_count> map_names{{{"none", "None"},
                                                            {"gaussian", "Gaussian curvature"},
                                                            {"mean", "Mean curvature"},
                                                            {"largest", "Largest curvature"},
                                                            {"smallest", "Smallest curvature"},
                                                            {"isophotes", "Isophotes"},
                                                            {"reflection", "Reflection lines"}}};

}  // namespace

std::string_view surface_map_id(SurfaceMap map) { return map_names[static_cast<std::size_t>(map)].id; }
std::string_view surface_map_title(SurfaceMap map) { return map_names[static_cast<std::size_t>(map)].title; }

std::optional<std::size_t> Workspace::index_of(std::string_view name) const {
  const auto found = std::find_if(objects.begin(), objects.end(), [&](const auto& each) { return each.name == name; });
  if (found == objects.end()) return std::nullopt;
  return static_cast<std::size_t>(found - objects.begin());
}

const SceneObject* Workspace::find(std::string_view name) const {
  const auto index = index_of(name);
  return index ? &objects[*index] : nullptr;
}

std::optional<std::pair<Exact, Exact>> domain_of(const Geometry& geometry, int direction) {
  if (const auto* curve = std::get_if<Curve<Exact>>(&geometry); curve != nullptr && direction == 0)
    return std::pair(curve->domain_begin(), curve->domain_end());
  if (const auto* surface = std::get_if<Surface<Exact>>(&geometry)) {
    const auto d = static_cast<std::size_t>(direction);
    const auto count = static_cast<std::size_t>(direction == 0 ? surface->rows : surface->columns);
    return std::pair(surface->knots[d][static_cast<std::size_t>(surface->degree[d])], surface->knots[d][count]);
  }
  return std::nullopt;
}

void look_at_middle(SceneObject& object) {
  const auto middle = [&](int direction) {
    const auto domain = domain_of(object.geometry, direction);
    return domain ? (domain->first + domain->second) / Exact(2) : Exact(0);
  };
  object.u = middle(0);
  object.v = middle(1);
}

void keep_in_domain(SceneObject& object) {
  const auto kept = [&](const Exact& x, int direction) {
    const auto domain = domain_of(object.geometry, direction);
    return domain ? std::clamp(x, domain->first, domain->second) : Exact(0);
  };
  object.u = kept(object.u, 0);
  object.v = kept(object.v, 1);
}

std::optional<std::string> problem_of_name(std::string_view name) {
  if (name.empty() || utf8_count(name) > most_characters)
    return "must have 1 to " + std::to_string(most_characters) + " characters";
  if (name.front() == ' ' || name.back() == ' ') return "must not begin or end with a blank";
  for (std::size_t i = 0; i < name.size();) {
    const std::size_t length = utf8_length(name, i);
    if (length == 0 || is_control(name.substr(i, length))) return "must be of characters that can be seen, on one line";
    i += length;
  }
  return std::nullopt;
}

// A number that the name ends with already is counted on: "curve 2" is followed by "curve 3".
std::string free_name(const Workspace& workspace, std::string name) {
  if (workspace.find(name) == nullptr) return name;
  const std::size_t blank = name.rfind(' ');
  const std::string digits = blank == std::string::npos ? "" : name.substr(blank + 1);
  if (!digits.empty() && digits.size() < 6 && digits.find_first_not_of("0123456789") == std::string::npos)
    name.resize(blank);
  constexpr std::size_t longest = most_characters - 5;  // room for the number
  std::size_t end = 0;
  for (std::size_t count = 0; count < longest && end < name.size(); ++count)
    end += std::max<std::size_t>(utf8_length(name, end), 1);
  name.resize(end);
  while (!name.empty() && name.back() == ' ') name.pop_back();
  for (int i = 2;; ++i)
    if (std::string other = name + " " + std::to_string(i); workspace.find(other) == nullptr) return other;
}

}  // namespace blossom
