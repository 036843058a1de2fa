// What one does with what is chosen, and drawing by clicks.
#include <algorithm>
#include <glm/geometric.hpp>

#include "player/edit.hpp"
#include "player/studio.hpp"

namespace blossom {
namespace {

constexpr int shortest_surface = 4;  // the size of a new net

std::string count_of(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string base_name(CurveKind kind, bool surface) {
  return surface ? "surface" : kind == CurveKind::bezier || kind == CurveKind::rational_bezier ? "bezier" : "curve";
}

SceneObject new_object(const Workspace& workspace, std::string name, Geometry geometry) {
  SceneObject object;
  object.name = free_name(workspace, std::move(name));
  object.shows = usual_shows(geometry);
  object.color = static_cast<int>(workspace.objects.size() % object_colors);
  const Range range = domain_of(geometry);
  const glm::dvec2 middle = (range.first + range.last) / 2.0;
  object.u = Exact(middle.x);
  object.v = Exact(middle.y);
  object.geometry = std::move(geometry);
  return object;
}

}  // namespace

Checked<Curve<Exact>> drawn_curve(CurveKind kind, CurveForm form, int degree, int dimension,
                                  const std::vector<Point<Exact>>& points) {
  Curve<Exact> curve;
  const int highest = static_cast<int>(points.size()) - 1;
  if (highest < 1) return Diagnostics{{"", 0, 0, "points", "a curve has at least two control points"}};
  const bool bezier = kind == CurveKind::bezier || kind == CurveKind::rational_bezier;
  if (bezier && highest > max_degree)
    return Diagnostics{
        {"", 0, 0, "points",
         "a Bezier curve has at most " + std::to_string(max_degree + 1) + " control points; a B-spline can have more"}};
  curve.degree = bezier ? highest : std::clamp(degree, 1, std::min(highest, max_degree));
  curve.dimension = dimension;
  curve.bezier = bezier;
  curve.rational = kind == CurveKind::rational_bezier || kind == CurveKind::nurbs;
  for (const Point<Exact>& p : points) curve.points.push_back({p.x, p.y, dimension == 3 ? p.z : Exact(0), Exact(1)});
  if (bezier) {
    curve.knots = bezier_knots<Exact>(curve.degree);
    return curve;
  }
  const int spans = highest + 1 - curve.degree;
  for (int i = -curve.degree; i <= spans + curve.degree; ++i) curve.knots.emplace_back(std::clamp(i, 0, spans));
  return form == CurveForm::clamped ? Checked(std::move(curve)) : edit::set_form(std::move(curve), form);
}

Range domain_of(const Geometry& geometry) {
  if (const auto* curve = std::get_if<Curve<Exact>>(&geometry))
    return {{curve->domain_begin().to_double(), 0}, {curve->domain_end().to_double(), 0}};
  if (const auto* surface = std::get_if<Surface<Exact>>(&geometry)) {
    Range range;
    const int counts[] = {surface->rows, surface->columns};
    for (int d = 0; d < 2; ++d) {
      const auto& knots = surface->knots[static_cast<std::size_t>(d)];
      range.first[d] = knots[static_cast<std::size_t>(surface->degree[static_cast<std::size_t>(d)])].to_double();
      range.last[d] = knots[static_cast<std::size_t>(counts[d])].to_double();
    }
    return range;
  }
  return {};
}

// ---- new things -----------------------------------------------------------------------------------------------------

bool Studio::add_curve(CurveKind kind, int degree, int dimension, std::vector<Point<Exact>> points) {
  auto curve = drawn_curve(kind, CurveForm::clamped, degree, dimension, points);
  const std::string name = base_name(kind, false);
  if (!curve) return edit(Worked(std::move(curve.diagnostics)), "");
  const bool done = edit(edit::add(workspace(), new_object(workspace(), name, std::move(*curve))), "a curve added");
  if (done) choose(workspace().objects.size() - 1);
  return done;
}

bool Studio::add_surface(CurveKind kind, int rows, int columns, int degree_u, int degree_v) {
  auto surface = edit::set_kind(planar_surface(rows, columns, degree_u, degree_v, Exact(shortest_surface)), kind);
  if (!surface) return edit(Worked(std::move(surface.diagnostics)), "");
  const bool done = edit(edit::add(workspace(), new_object(workspace(), base_name(kind, true), std::move(*surface))),
                         "a surface added");
  if (done) choose(workspace().objects.size() - 1);
  return done;
}

bool Studio::apply(const Algorithm& algorithm) { return apply(recipe_for(algorithm, workspace(), chosen_)); }

bool Studio::apply(const Recipe& recipe) {
  const std::size_t first = workspace().objects.size();
  const std::string title = recipe.algorithm != nullptr ? std::string(recipe.algorithm->title) : "nothing";
  if (!edit(edit::add_made(workspace(), recipe), title)) return false;
  if (first < workspace().objects.size()) choose(first);
  return true;
}

// ---- what is chosen -------------------------------------------------------------------------------------------------

bool Studio::remove() {
  if (!selected_.empty()) {
    const std::string what = count_of(selected_.size(), "point") + " deleted";
    return edit(edit::delete_points(workspace(), selected_), what);
  }
  if (chosen_.empty()) return false;
  const std::size_t here = *current();
  const std::string what = chosen_.size() == 1 ? object()->name : count_of(chosen_.size(), "thing");
  if (!edit(edit::remove(workspace(), chosen_), what + " deleted")) return false;
  // One goes on with the thing before it.
  if (!workspace().objects.empty()) choose(std::min(here > 0 ? here - 1 : 0, workspace().objects.size() - 1));
  return true;
}

bool Studio::duplicate() {
  if (chosen_.empty()) return false;
  const std::size_t first = workspace().objects.size();
  const std::string what = chosen_.size() == 1 ? object()->name : count_of(chosen_.size(), "thing");
  if (!edit(edit::duplicate(workspace(), chosen_), what + " duplicated")) return false;
  choose(std::nullopt);
  for (std::size_t i = first; i < workspace().objects.size(); ++i) choose(i, true);
  return true;
}

bool Studio::hide() {
  if (chosen_.empty()) return false;
  const bool hidden = !object()->hidden;
  const std::string what = chosen_.size() == 1 ? object()->name : count_of(chosen_.size(), "thing");
  return edit(edit::set_hidden(workspace(), chosen_, hidden), what + (hidden ? " hidden" : " shown"));
}

bool Studio::show_all() {
  std::vector<std::size_t> hidden;
  for (std::size_t i = 0; i < workspace().objects.size(); ++i)
    if (workspace().objects[i].hidden) hidden.push_back(i);
  return !hidden.empty() && edit(edit::set_hidden(workspace(), hidden, false), "everything shown");
}

bool Studio::move_by(const Point<Exact>& by, const std::string& gesture) {
  if (!selected_.empty()) {
    const auto& first = selected_.front();
    const SceneObject& of = workspace().objects[first.object];
    const std::string what = selected_.size() == 1 ? of.name + " " + point_name(of.geometry, first.point)
                                                   : count_of(selected_.size(), "point");
    return edit(edit::move_points(workspace(), selected_, by), what + " moved", gesture);
  }
  if (chosen_.empty()) return false;
  Placement placement;
  placement.move = by;
  const std::string what = chosen_.size() == 1 ? object()->name : count_of(chosen_.size(), "thing");
  return edit(
      edit::place(workspace(), chosen_, placement, centre().value_or(Point<Exact>(Exact(0), Exact(0), Exact(0)))),
      what + " moved", gesture);
}

bool Studio::nudge(const glm::dvec3& right_up_toward) {
  if (selected_.empty() && chosen_.empty()) return false;
  const Camera camera = camera_of(pane);
  const auto is_plane = [&](std::size_t i) {
    const auto* curve = std::get_if<Curve<Exact>>(&workspace().objects[i].geometry);
    return curve != nullptr && curve->dimension == 2;
  };
  bool plane = true;
  for (const PointRef& ref : selected_) plane = plane && is_plane(ref.object);
  if (selected_.empty())
    for (const std::size_t i : chosen_) plane = plane && is_plane(i);
  const PageAxis along = nearest_axis(camera, plane ? 2 : 3, right_up_toward);
  const double step = grid_of(pane, pane_sizes[static_cast<std::size_t>(pane)]) / 10;
  Point<Exact> by{Exact(0), Exact(0), Exact(0)};
  by[along.axis] = snapped(along.backwards ? -step : step, step);
  // The view stays: fitted to what has moved, nothing would seem to move.
  cameras[static_cast<std::size_t>(pane)] = camera;
  return move_by(by);
}

bool Studio::show(Show what, bool on) {
  const SceneObject* here = object();
  if (here == nullptr) return false;
  std::vector<std::size_t> which = {*current()};
  if (for_all) {
    which.clear();
    for (std::size_t i = 0; i < workspace().objects.size(); ++i)
      if (workspace().objects[i].geometry.index() == here->geometry.index()) which.push_back(i);
  }
  const auto name = std::ranges::find(show_names(), what, &ShowName::show);
  const std::string title = name != show_names().end() ? std::string(name->title) : "display";
  return edit(edit::set_show(workspace(), which, what, on), title + (on ? " on" : " off"));
}

// ---- drawing --------------------------------------------------------------------------------------------------------

void Studio::set_tool(Tool tool) {
  finish_drawing();
  tool_ = tool;
  stop();
}

bool Studio::redraw_clicked() {
  const bool spatial = std::ranges::any_of(clicked_, [](const Point<Exact>& p) { return p.z != Exact(0); });
  auto curve = drawn_curve(new_kind, new_form, new_degree, spatial ? 3 : 2, clicked_);
  // A closed curve needs more points than an open one; until there are enough it is clamped.
  if (!curve && new_form != CurveForm::clamped)
    curve = drawn_curve(new_kind, CurveForm::clamped, new_degree, spatial ? 3 : 2, clicked_);
  if (!curve) return edit(Worked(std::move(curve.diagnostics)), "");
  const auto known = drawn_.empty() ? std::nullopt : workspace().index_of(drawn_);
  if (!known) {
    SceneObject object = new_object(workspace(), base_name(new_kind, false), std::move(*curve));
    const std::string name = object.name;
    if (!edit(edit::add(workspace(), std::move(object)), "a curve drawn")) return false;
    drawn_ = name;
    choose(workspace().objects.size() - 1);
    return true;
  }
  Workspace changed = workspace();
  const double u = (curve->domain_begin().to_double() + curve->domain_end().to_double()) / 2;
  auto replaced = edit::change(std::move(changed), *known,
                               [&](const Curve<Exact>&) -> edit::EditedCurve { return std::move(*curve); });
  if (replaced) replaced = edit::look_at(std::move(*replaced), *known, Exact(u), Exact(0));
  return edit(std::move(replaced), "a point of " + drawn_ + " drawn");
}

void Studio::click(const Point<Exact>& at) {
  // The second click of a double click says nothing new.
  if (!clicked_.empty() && clicked_.back() == at) return;
  clicked_.push_back(at);
  if (clicked_.size() >= 2 && !redraw_clicked()) clicked_.pop_back();
}

bool Studio::finish_drawing() {
  const bool was = !clicked_.empty();
  clicked_.clear();
  drawn_.clear();
  return was;
}

bool Studio::take_back_click() {
  if (clicked_.empty()) return false;
  clicked_.pop_back();
  if (clicked_.empty()) return true;
  std::vector<Point<Exact>> left = std::exchange(clicked_, {});
  undo();
  clicked_ = std::move(left);
  if (clicked_.size() < 2) drawn_.clear();
  return true;
}

bool Studio::escape() {
  if (running_) return run(false), true;
  if (take_back_click()) return true;
  if (tool_ != Tool::choose) return set_tool(Tool::choose), true;
  if (!selected_.empty()) return select({}), true;
  return false;
}

bool Studio::insert_at(StudioPane which, ViewSize size, glm::dvec2 at, double reach) {
  const SceneObject* here = object();
  if (here == nullptr) return false;
  if (!std::holds_alternative<Curve<Exact>>(here->geometry) && !std::holds_alternative<PointRow<Exact>>(here->geometry))
    return edit(Worked(Diagnostics{{"", 0, 0, "",
                                    "points can be added to curves and rows of points here; a surface "
                                    "gets a row or a column in its shape"}}),
                "");
  const Camera camera = camera_of(which, size);
  const std::size_t count = point_count(here->geometry);
  std::optional<std::size_t> behind;
  glm::dvec3 place{};
  double nearest = reach;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    const auto a = place_of(here->geometry, i), b = place_of(here->geometry, i + 1);
    if (!a || !b) continue;
    const auto on_a = to_page(camera, size, in_world(*a)), on_b = to_page(camera, size, in_world(*b));
    if (!on_a || !on_b) continue;
    const glm::dvec2 leg = *on_b - *on_a;
    const double length = glm::dot(leg, leg);
    const double t = length > 0 ? std::clamp(glm::dot(at - *on_a, leg) / length, 0.0, 1.0) : 0;
    const double distance = glm::length(at - (*on_a + t * leg));
    if (distance >= nearest) continue;
    nearest = distance;
    behind = i;
    place = in_world(*a) + t * (in_world(*b) - in_world(*a));
  }
  if (!behind) return false;
  const double unit = camera.height / size.height;
  const Point<Exact> to{snapped(place.x, unit), snapped(place.y, unit), snapped(place.z, unit)};
  const PointRef ref{*current(), *behind};
  if (!edit(edit::insert_point(workspace(), ref, to), "a point added to " + here->name)) return false;
  select({{ref.object, ref.point + 1}});
  return true;
}

}  // namespace blossom
