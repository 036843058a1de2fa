// Edits of the points of things in a scene, and their placing.

#include <algorithm>
#include <cmath>
#include <set>

#include "studio/edit_parts.hpp"
#include "studio/edit_workspace.hpp"

namespace blossom {

std::optional<Point<Exact>> place_of(const Geometry& geometry, std::size_t point) {
  return std::visit(
      [&](const auto& each) -> std::optional<Point<Exact>> {
        if (point >= each.points.size() || each.points[point].w == Exact(0)) return std::nullopt;
        return affine(each.points[point]);
      },
      geometry);
}

namespace edit {

using namespace parts;

namespace {

// Changes the geometry of one thing after another, each of which is given from then on, and makes anew what follows.
class Changes {
 public:
  explicit Changes(Workspace workspace) : workspace_(std::move(workspace)) {}

  const SceneObject* object(std::size_t index) {
    if (index < workspace_.objects.size()) return &workspace_.objects[index];
    refuse(refused("", "there is no such thing in the scene"));
    return nullptr;
  }
  // `change(geometry)`: Checked<Geometry>
  template <class Change>
  void apply(std::size_t index, Change&& change) {
    if (!refusals_.empty() || object(index) == nullptr) return;
    SceneObject& object = workspace_.objects[index];
    auto before = object.recipe ? as_read(object.geometry) : Checked<Geometry>(object.geometry);
    auto after = before ? change(std::move(*before)) : std::move(before);
    if (!after) return refuse(about_object(object, after.diagnostics));
    object.geometry = std::move(*after);
    object.recipe.reset();
    object.problem.clear();
    keep_in_domain(object);
    changed_.insert(index);
  }
  void refuse(Diagnostics diagnostics) { refusals_.insert(refusals_.end(), diagnostics.begin(), diagnostics.end()); }
  Worked done(bool quick) && {
    if (!refusals_.empty()) return std::move(refusals_);
    remake_after(workspace_, {changed_.begin(), changed_.end()}, quick);
    if (point_count(workspace_) > most_scene_points)
      return refused("", "a scene has at most " + std::to_string(most_scene_points) + " control points in all");
    return std::move(workspace_);
  }

 private:
  Workspace workspace_;
  std::set<std::size_t> changed_;
  Diagnostics refusals_;
};

Checked<Geometry> as_geometry(EditedCurve curve) {
  if (!curve) return std::move(curve.diagnostics);
  return Geometry(std::move(*curve));
}
Checked<Geometry> as_geometry(EditedSurface surface) {
  if (!surface) return std::move(surface.diagnostics);
  return Geometry(std::move(*surface));
}

Checked<Geometry> with_point_at(Geometry geometry, std::size_t point, const Point<Exact>& to) {
  if (point >= point_count(geometry)) return refused(at("points", point), "there is no such control point");
  if (auto* curve = std::get_if<Curve<Exact>>(&geometry)) return as_geometry(move_point(std::move(*curve), point, to));
  if (auto* surface = std::get_if<Surface<Exact>>(&geometry)) {
    const int i = static_cast<int>(point) / surface->columns, j = static_cast<int>(point) % surface->columns;
    return as_geometry(move_point(std::move(*surface), i, j, to));
  }
  if (auto* row = std::get_if<PointRow<Exact>>(&geometry)) row->points[point] = weighted(to, Exact(1), row->dimension);
  if (auto* net = std::get_if<PointNet<Exact>>(&geometry)) net->points[point] = weighted(to, Exact(1), 3);
  if (is_readable(to, Exact(1))) return geometry;
  return as_read(geometry);
}

// The points of each thing, each once.
std::map<std::size_t, std::set<std::size_t>> by_object(const std::vector<PointRef>& refs) {
  std::map<std::size_t, std::set<std::size_t>> result;
  for (const PointRef& ref : refs) result[ref.object].insert(ref.point);
  return result;
}

// Each of the points goes where `to` says, by where it was.
template <class To>
Worked move_each(Workspace workspace, const std::vector<PointRef>& refs, To&& to, bool quick) {
  Changes changes(std::move(workspace));
  for (const auto& [index, points] : by_object(refs))
    changes.apply(index, [&, &chosen = points](Geometry geometry) -> Checked<Geometry> {
      const Geometry before = geometry;
      for (const std::size_t point : chosen) {
        const auto place = place_of(before, point);
        auto moved = with_point_at(std::move(geometry), point, place ? to(*place) : Point<Exact>(0, 0, 0));
        if (!moved) return moved;
        geometry = std::move(*moved);
      }
      return geometry;
    });
  return std::move(changes).done(quick);
}

}  // namespace

// ---- points ---------------------------------------------------------------------------------------------------------

Worked move_points(Workspace workspace, const std::vector<PointRef>& points, const Point<Exact>& by, bool quick) {
  return move_each(
      std::move(workspace), points,
      [&](const Point<Exact>& P) { return Point<Exact>(P.x + by.x, P.y + by.y, P.z + by.z); }, quick);
}

Worked set_place(Workspace workspace, const PointRef& point, const Point<Exact>& to, bool quick) {
  return move_each(
      std::move(workspace), {point}, [&](const Point<Exact>&) { return to; }, quick);
}

Worked set_weight(Workspace workspace, const PointRef& ref, const Exact& weight, bool quick) {
  Changes changes(std::move(workspace));
  changes.apply(ref.object, [&](Geometry geometry) -> Checked<Geometry> {
    if (auto* curve = std::get_if<Curve<Exact>>(&geometry))
      return as_geometry(set_weight(std::move(*curve), ref.point, weight));
    auto* surface = std::get_if<Surface<Exact>>(&geometry);
    if (surface == nullptr)
      return refused(at("weights", ref.point), "points that are no control points have no weights");
    if (ref.point >= surface->points.size()) return refused(at("weights", ref.point), "there is no such control point");
    const int i = static_cast<int>(ref.point) / surface->columns, j = static_cast<int>(ref.point) % surface->columns;
    return as_geometry(set_weight(std::move(*surface), i, j, weight));
  });
  return std::move(changes).done(quick);
}

Worked insert_point(Workspace workspace, const PointRef& behind, const Point<Exact>& to) {
  Changes changes(std::move(workspace));
  changes.apply(behind.object, [&](Geometry geometry) -> Checked<Geometry> {
    if (auto* curve = std::get_if<Curve<Exact>>(&geometry))
      return as_geometry(insert_point(std::move(*curve), behind.point, to));
    auto* row = std::get_if<PointRow<Exact>>(&geometry);
    if (row == nullptr) return refused("points", "are in rows and columns: add a whole row or column");
    if (behind.point != SIZE_MAX && behind.point >= row->points.size())
      return refused(at("points", behind.point), "there is no such point");
    insert_at(row->points, behind.point + 1, weighted(to, Exact(1), row->dimension));
    return as_read(geometry);
  });
  return std::move(changes).done(false);
}

namespace {

Checked<Geometry> without(Geometry geometry, std::set<std::size_t> points) {
  if (auto* curve = std::get_if<Curve<Exact>>(&geometry)) {
    EditedCurve edited = std::move(*curve);
    if (form_of(*edited) == CurveForm::closed) {
      std::set<std::size_t> own;
      for (const std::size_t point : points)
        if (point < edited->points.size()) own.insert(point % own_points(*edited));
      points = std::move(own);
    }
    for (auto point = points.rbegin(); point != points.rend(); ++point) {
      edited = delete_point(std::move(*edited), *point);
      if (!edited) break;
    }
    return as_geometry(std::move(edited));
  }
  auto* row = std::get_if<PointRow<Exact>>(&geometry);
  if (row == nullptr) return refused("points", "are in rows and columns: delete a whole row or column");
  for (auto point = points.rbegin(); point != points.rend(); ++point) {
    if (*point >= row->points.size()) return refused(at("points", *point), "there is no such point");
    if (row->points.size() == 1) return refused(at("points", *point), "is the last one; delete the whole row instead");
    erase_at(row->points, *point);
  }
  return as_read(geometry);
}

}  // namespace

Worked delete_points(Workspace workspace, const std::vector<PointRef>& refs) {
  Changes changes(std::move(workspace));
  for (const auto& [index, points] : by_object(refs))
    changes.apply(index, [&chosen = points](Geometry geometry) { return without(std::move(geometry), chosen); });
  return std::move(changes).done(false);
}

// ---- any edit of one curve or surface -------------------------------------------------------------------------------

Worked change(Workspace workspace, std::size_t object, const std::function<EditedCurve(Curve<Exact>)>& edit,
              bool quick) {
  Changes changes(std::move(workspace));
  changes.apply(object, [&](Geometry geometry) -> Checked<Geometry> {
    auto* curve = std::get_if<Curve<Exact>>(&geometry);
    if (curve == nullptr) return refused("", "is no curve");
    return as_geometry(edit(std::move(*curve)));
  });
  return std::move(changes).done(quick);
}

Worked change(Workspace workspace, std::size_t object, const std::function<EditedSurface(Surface<Exact>)>& edit,
              bool quick) {
  Changes changes(std::move(workspace));
  changes.apply(object, [&](Geometry geometry) -> Checked<Geometry> {
    auto* surface = std::get_if<Surface<Exact>>(&geometry);
    if (surface == nullptr) return refused("", "is no surface");
    return as_geometry(edit(std::move(*surface)));
  });
  return std::move(changes).done(quick);
}

// ---- placing --------------------------------------------------------------------------------------------------------

Worked place(Workspace workspace, const std::vector<std::size_t>& objects, const Placement& placement,
             const Point<Exact>& centre, bool quick) {
  const Placement around = about(placement, centre);
  Changes changes(std::move(workspace));
  for (const std::size_t index : std::set<std::size_t>(objects.begin(), objects.end()))
    changes.apply(index, [&](const Geometry& geometry) {
      return as_read(std::visit([&](const auto& each) -> Geometry { return placed(each, around); }, geometry));
    });
  return std::move(changes).done(quick);
}

Worked place(Workspace workspace, const std::vector<PointRef>& points, const Placement& placement,
             const Point<Exact>& centre, bool quick) {
  const Placement around = about(placement, centre);
  return move_each(
      std::move(workspace), points, [&](const Point<Exact>& P) { return placed(P, around); }, quick);
}

Worked place_instance(Workspace workspace, std::size_t index, std::string_view input, std::size_t which,
                      const Placement& placement, bool quick) {
  if (index >= workspace.objects.size() || !workspace.objects[index].recipe)
    return refused("", "there is no such made thing in the scene");
  SceneObject& object = workspace.objects[index];
  const auto ingredient = object.recipe->inputs.find(input);
  auto* references =
      ingredient == object.recipe->inputs.end() ? nullptr : std::get_if<std::vector<Reference>>(&ingredient->second);
  if (references == nullptr || which >= references->size())
    return refused(at(input, which), "there is no such instance");
  (*references)[which].place = placement;
  auto pieces = made_by(workspace, *object.recipe, index, quick);
  if (!pieces) return pieces.diagnostics;
  if (object.recipe->which >= pieces->size()) return refused("", "there are fewer pieces then");
  object.geometry = std::move((*pieces)[object.recipe->which]);
  object.problem.clear();
  keep_in_domain(object);
  remake_after(workspace, {index}, quick);
  return workspace;
}

}  // namespace edit
}  // namespace blossom
