#include "studio/edit_workspace.hpp"

#include <algorithm>
#include <cmath>

#include "studio/edit_parts.hpp"

namespace blossom {
namespace edit {

using namespace parts;

namespace {

// ---- what all of them share -----------------------------------------------------------------------------------------

std::optional<Diagnostics> no_such_object(const Workspace& workspace, std::size_t object) {
  if (object < workspace.objects.size()) return std::nullopt;
  return refused("", "there is no such thing in the scene");
}
std::optional<Diagnostics> no_such_object(const Workspace& workspace, const std::vector<std::size_t>& objects) {
  for (const std::size_t i : objects)
    if (auto none = no_such_object(workspace, i)) return none;
  return std::nullopt;
}

// Files hold no more.
Worked within_bounds(Workspace workspace) {
  if (workspace.objects.size() > most_objects)
    return refused("", "a scene has at most " + std::to_string(most_objects) + " things");
  if (point_count(workspace) > most_scene_points)
    return refused("", "a scene has at most " + std::to_string(most_scene_points) + " control points in all");
  return workspace;
}

// After the geometry of these has changed.
Worked followed(Workspace workspace, const std::vector<std::size_t>& changed, bool quick) {
  for (const std::size_t i : changed) keep_in_domain(workspace.objects[i]);
  remake_after(workspace, changed, quick);
  return within_bounds(std::move(workspace));
}

// From now on it is given: what files can hold.
std::optional<Diagnostics> make_given(SceneObject& object) {
  if (!object.recipe) return std::nullopt;
  auto geometry = as_read(object.geometry);
  if (!geometry) return about_object(object, geometry.diagnostics);
  object.geometry = std::move(*geometry);
  object.recipe.reset();
  object.problem.clear();
  keep_in_domain(object);
  return std::nullopt;
}

std::optional<Diagnostics> wrong_name(const Workspace& workspace, const std::string& name,
                                      std::optional<std::size_t> own = std::nullopt) {
  if (auto problem = problem_of_name(name)) return refused("name", *problem);
  const auto other = workspace.index_of(name);
  if (other && other != own) return refused("name", excerpt(name) + " is the name of another thing");
  return std::nullopt;
}

// A name from an algorithm's id.
std::string words(std::string_view id) {
  std::string text(id);
  std::ranges::replace(text, '_', ' ');
  std::ranges::replace(text, '-', ' ');
  return text;
}

bool refers_to(const SceneObject& object, const std::string& name) {
  return object.recipe && std::ranges::count(sources_of(*object.recipe), name) > 0;
}

template <class Change>
void change_references(Recipe& recipe, Change&& change) {
  for (auto& [input, ingredient] : recipe.inputs)
    if (auto* references = std::get_if<std::vector<Reference>>(&ingredient))
      for (Reference& reference : *references) change(reference);
}

}  // namespace

// ---- things ---------------------------------------------------------------------------------------------------------

Worked add(Workspace workspace, SceneObject object) {
  object.name = free_name(workspace, object.name);
  if (auto wrong = wrong_name(workspace, object.name)) return *wrong;
  const std::size_t index = workspace.objects.size();
  if (object.recipe) {
    auto pieces = made_by(workspace, *object.recipe, index);
    if (!pieces) return pieces.diagnostics;
    if (object.recipe->which >= pieces->size()) return refused("", "there is no such piece");
    object.geometry = std::move((*pieces)[object.recipe->which]);
    object.problem.clear();
  } else {
    auto geometry = as_read(object.geometry);
    if (!geometry) return about_object(object, geometry.diagnostics);
    object.geometry = std::move(*geometry);
  }
  object.color = std::clamp(object.color, 0, object_colors - 1);
  keep_in_domain(object);
  workspace.objects.push_back(std::move(object));
  return within_bounds(std::move(workspace));
}

Worked add_made(Workspace workspace, const Recipe& recipe) {
  auto pieces = made_by(workspace, recipe, workspace.objects.size());
  if (!pieces) return pieces.diagnostics;
  for (std::size_t i = 0; i < pieces->size(); ++i) {
    SceneObject object;
    object.name = free_name(workspace, words(recipe.algorithm->id));
    object.geometry = std::move((*pieces)[i]);
    object.recipe = recipe;
    object.recipe->which = i;
    object.color = static_cast<int>(workspace.objects.size()) % object_colors;
    object.shows = usual_shows(object.geometry);
    look_at_middle(object);
    workspace.objects.push_back(std::move(object));
  }
  return within_bounds(std::move(workspace));
}

Worked set_recipe(Workspace workspace, std::size_t index, const Recipe& recipe) {
  if (auto none = no_such_object(workspace, index)) return *none;
  auto pieces = made_by(workspace, recipe, index);
  if (!pieces) return pieces.diagnostics;
  if (recipe.which >= pieces->size())
    return refused(
        "", "there are " + std::to_string(pieces->size()) + " pieces, none of number " + std::to_string(recipe.which));
  SceneObject& object = workspace.objects[index];
  const bool other_kind = object.geometry.index() != (*pieces)[recipe.which].index();
  object.geometry = std::move((*pieces)[recipe.which]);
  object.recipe = recipe;
  object.problem.clear();
  if (other_kind) {
    object.shows = usual_shows(object.geometry);
    object.map = SurfaceMap::none;
    look_at_middle(object);
  }
  return followed(std::move(workspace), {index}, false);
}

Worked remove(Workspace workspace, const std::vector<std::size_t>& objects) {
  if (auto none = no_such_object(workspace, objects)) return *none;
  std::vector<bool> goes(workspace.objects.size(), false);
  for (const std::size_t i : objects) goes[i] = true;
  for (std::size_t i = 0; i < workspace.objects.size(); ++i) {
    SceneObject& object = workspace.objects[i];
    if (goes[i] || !object.recipe) continue;
    const auto sources = sources_of(*object.recipe);
    const bool loses = std::ranges::any_of(sources, [&](const std::string& name) {
      const auto source = workspace.index_of(name);
      return source && goes[*source];
    });
    if (loses)
      if (auto wrong = make_given(object)) return *wrong;
  }
  std::vector<SceneObject> kept;
  for (std::size_t i = 0; i < goes.size(); ++i)
    if (!goes[i]) kept.push_back(std::move(workspace.objects[i]));
  workspace.objects = std::move(kept);
  return workspace;
}

namespace {

// About a tenth of the thing's size, a power of ten; to the right and up.
Point<Exact> a_little(const Geometry& geometry) {
  double least = 0, most = 0;
  bool first = true;
  for (std::size_t i = 0; i < point_count(geometry); ++i) {
    const auto P = place_of(geometry, i);
    if (!P) continue;
    for (const Exact& x : {P->x, P->y, P->z}) {
      least = first ? x.to_double() : std::min(least, x.to_double());
      most = first ? x.to_double() : std::max(most, x.to_double());
      first = false;
    }
  }
  const double size = most - least;
  const int power = size > 1e-9 && size < 1e9 ? static_cast<int>(std::floor(std::log10(size))) - 1 : 0;
  const Exact by = Exact::parse("5e" + std::to_string(power)).value_or(Exact(1));
  return {by, by, Exact(0)};
}

}  // namespace

// What is made of things that are copied, too, is made of the copies.
Worked duplicate(Workspace workspace, const std::vector<std::size_t>& objects) {
  if (auto none = no_such_object(workspace, objects)) return *none;
  std::vector<std::size_t> order = objects;
  std::ranges::sort(order);
  order.erase(std::unique(order.begin(), order.end()), order.end());
  std::map<std::string, std::string> copies;
  for (const std::size_t i : order) {
    SceneObject copy = workspace.objects[i];
    bool follows = false;
    if (copy.recipe)
      change_references(*copy.recipe, [&](Reference& reference) {
        const auto found = copies.find(reference.object);
        if (found == copies.end()) return;
        reference.object = found->second;
        follows = true;
      });
    copy.name = free_name(workspace, copy.name);
    copies[workspace.objects[i].name] = copy.name;
    if (!follows) {
      if (auto wrong = make_given(copy)) return *wrong;
      const Placement place{.move = a_little(copy.geometry)};
      auto moved =
          as_read(std::visit([&](const auto& each) -> Geometry { return placed(each, place); }, copy.geometry));
      if (!moved) return about_object(copy, moved.diagnostics);
      copy.geometry = std::move(*moved);
    }
    workspace.objects.push_back(std::move(copy));
  }
  std::vector<std::size_t> added;
  for (std::size_t i = workspace.objects.size() - order.size(); i < workspace.objects.size(); ++i) added.push_back(i);
  return followed(std::move(workspace), added, false);
}

Worked rename(Workspace workspace, std::size_t object, const std::string& name) {
  if (auto none = no_such_object(workspace, object)) return *none;
  if (auto wrong = wrong_name(workspace, name, object)) return *wrong;
  const std::string before = std::exchange(workspace.objects[object].name, name);
  for (SceneObject& other : workspace.objects)
    if (other.recipe)
      change_references(*other.recipe, [&](Reference& reference) {
        if (reference.object == before) reference.object = name;
      });
  return workspace;
}

Worked move_to(Workspace workspace, std::size_t object, std::size_t place) {
  if (auto none = no_such_object(workspace, object)) return *none;
  place = std::min(place, workspace.objects.size() - 1);
  const SceneObject& moving = workspace.objects[object];
  for (std::size_t i = object; i-- > place;)
    if (refers_to(moving, workspace.objects[i].name))
      return refused(moving.name,
                     "is made from " + excerpt(workspace.objects[i].name) + ", which must stand before it");
  for (std::size_t i = object + 1; i <= place; ++i)
    if (refers_to(workspace.objects[i], moving.name))
      return refused(moving.name, excerpt(workspace.objects[i].name) + " is made from it and must stand behind it");
  SceneObject taken = std::move(workspace.objects[object]);
  erase_at(workspace.objects, object);
  insert_at(workspace.objects, place, std::move(taken));
  return workspace;
}

Worked detach(Workspace workspace, std::size_t object) {
  if (auto none = no_such_object(workspace, object)) return *none;
  if (auto wrong = make_given(workspace.objects[object])) return *wrong;
  return workspace;
}

Worked set_color(Workspace workspace, std::size_t object, int color) {
  if (auto none = no_such_object(workspace, object)) return *none;
  if (color < 0 || color >= object_colors)
    return refused("color",
                   "must be from 0 to " + std::to_string(object_colors - 1) + ", not " + std::to_string(color));
  workspace.objects[object].color = color;
  return workspace;
}

Worked set_hidden(Workspace workspace, const std::vector<std::size_t>& objects, bool hidden) {
  if (auto none = no_such_object(workspace, objects)) return *none;
  for (const std::size_t i : objects) workspace.objects[i].hidden = hidden;
  return workspace;
}

Worked set_show(Workspace workspace, const std::vector<std::size_t>& objects, Show show, bool on) {
  if (auto none = no_such_object(workspace, objects)) return *none;
  for (const std::size_t i : objects) workspace.objects[i].shows.set(show, on);
  return workspace;
}

Worked set_map(Workspace workspace, std::size_t index, SurfaceMap map) {
  if (auto none = no_such_object(workspace, index)) return *none;
  SceneObject& object = workspace.objects[index];
  if (map != SurfaceMap::none && !std::holds_alternative<Surface<Exact>>(object.geometry))
    return refused(object.name, "is no surface, and only those have maps");
  object.map = map;
  return workspace;
}

Worked look_at(Workspace workspace, std::size_t index, const Exact& u, const Exact& v) {
  if (auto none = no_such_object(workspace, index)) return *none;
  SceneObject& object = workspace.objects[index];
  object.u = u;
  object.v = v;
  keep_in_domain(object);
  return workspace;
}

}  // namespace edit
}  // namespace blossom
