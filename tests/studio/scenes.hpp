#pragma once
// Scenes for tests: one with a thing of each kind, and random ones, edited as somebody edits who tries everything.

#include <catch2/catch.hpp>
#include <random>

#include "algorithms/inputs.hpp"
#include "studio/edit_workspace.hpp"
#include "studio/scene_file.hpp"

namespace blossom::test {

inline Workspace scene_of(const std::string& objects) {
  const auto document =
      JsonDocument::parse("scene.json", "{\"schema\": \"blossom.scene/1\", \"objects\": [" + objects + "]}");
  INFO(to_string(document.diagnostics));
  REQUIRE(document);
  auto scene = read_scene(*document);
  INFO(to_string(scene.diagnostics));
  REQUIRE(scene);
  return *scene;
}

// What reading the file of a scene gives.
inline Workspace read_back(const Workspace& workspace) {
  const std::string text = write_scene(workspace);
  const auto document = JsonDocument::parse("scene.json", text);
  INFO(text);
  REQUIRE(document);
  auto scene = read_scene(*document);
  INFO(to_string(scene.diagnostics));
  REQUIRE(scene);
  return *scene;
}

inline Workspace taken(Worked worked) {
  INFO(to_string(worked.diagnostics));
  REQUIRE(worked);
  return std::move(*worked);
}

inline const Curve<Exact>& curve_in(const Workspace& workspace, std::string_view name) {
  return std::get<Curve<Exact>>(workspace.find(name)->geometry);
}
inline const Surface<Exact>& surface_in(const Workspace& workspace, std::string_view name) {
  return std::get<Surface<Exact>>(workspace.find(name)->geometry);
}

// A random scene: given things of all kinds, and things made from them, as they are or placed elsewhere.
class RandomScenes {
 public:
  explicit RandomScenes(unsigned seed) : random_(seed) {}

  int whole(int from, int to) { return random_int(random_, from, to); }
  bool one_in(int n) { return whole(1, n) == 1; }
  std::size_t index(std::size_t count) { return static_cast<std::size_t>(whole(0, static_cast<int>(count) - 1)); }
  Exact number() { return Exact::ratio(whole(-40, 40), 8); }
  Point<Exact> place() { return {number(), number(), number()}; }
  Placement placement() {
    Placement result;
    if (one_in(2)) result.scale = {Exact::ratio(whole(1, 6), 3), Exact::ratio(whole(-6, -1), 2), Exact(1)};
    if (one_in(2)) result.turn = {Exact(90 * whole(-4, 4)), Exact(90 * whole(-4, 4)), Exact(90 * whole(-4, 4))};
    if (one_in(2)) result.move = place();
    return result;
  }
  std::mt19937& engine() { return random_; }

  // One that a file can hold; `heavy`: without weights of 0.
  Curve<Exact> curve(int dimension, bool heavy = false) {
    for (;;) {
      const Curve<Exact> drawn = any_curve(random_, dimension);
      if (heavy && std::ranges::any_of(drawn.points, [](const auto& P) { return P.w == Exact(0); })) continue;
      if (auto read = edit::set_dimension(drawn, dimension)) return *read;
    }
  }

  Geometry geometry() {
    switch (whole(0, 5)) {
      case 0:
        return random_surface(random_, whole(1, 3), whole(1, 2), whole(1, 2), !one_in(3), one_in(2));
      case 1: {
        PointRow<Exact> row{{}, whole(2, 3)};
        for (int i = whole(1, 6); i > 0; --i) row.points.push_back(any_place(random_, row.dimension));
        return row;
      }
      case 2: {
        PointNet<Exact> net{whole(2, 4), whole(2, 4), {}};
        for (int i = net.rows * net.columns; i > 0; --i) net.points.push_back(any_place(random_, 3));
        return net;
      }
      case 3: {
        auto closed = edit::set_form(curve(whole(2, 3)), CurveForm::closed);
        if (closed) return *closed;
        return curve(2);
      }
      default:
        return curve(whole(2, 3));
    }
  }

  SceneObject given() {
    SceneObject object;
    object.name = one_in(4) ? "Größe" : "thing";
    object.geometry = geometry();
    object.color = whole(0, object_colors - 1);
    object.hidden = one_in(5);
    object.shows = usual_shows(object.geometry);
    object.shows.set(static_cast<Show>(whole(0, show_count - 1)), one_in(2));
    look_at_middle(object);
    return object;
  }

  std::vector<std::size_t> some(const Workspace& workspace, int at_most) {
    std::vector<std::size_t> objects;
    for (int i = whole(1, at_most); i > 0 && !workspace.objects.empty(); --i) {
      const std::size_t object = index(workspace.objects.size());
      if (std::ranges::find(objects, object) == objects.end()) objects.push_back(object);
    }
    return objects;
  }

  // Something made from some of the things; as it was if nothing can be.
  Workspace with_made(Workspace workspace) {
    const auto objects = some(workspace, 2);
    const auto candidates = algorithms_for(workspace, objects);
    if (candidates.empty()) return workspace;
    Recipe recipe = recipe_for(*candidates[index(candidates.size())], workspace, objects);
    for (auto& [input, ingredient] : recipe.inputs)
      if (auto* references = std::get_if<std::vector<Reference>>(&ingredient); references != nullptr && one_in(3))
        references->front().place = placement();
    auto made = edit::add_made(workspace, recipe);
    return made ? *made : workspace;
  }

  Workspace scene(int given_things, int made_things) {
    Workspace workspace;
    workspace.id = "random-" + std::to_string(whole(0, 99));
    workspace.title = "At random";
    if (one_in(2)) workspace.look = Look{static_cast<Look::From>(whole(0, 3)), whole(-300, 300) / 97.0, 0.1, one_in(2)};
    while (given_things > 0)
      if (auto added = edit::add(workspace, given())) {
        workspace = *added;
        --given_things;
      }
    while (made_things-- > 0) workspace = with_made(workspace);
    return workspace;
  }

  struct Edit {
    std::string what;
    Worked worked;
  };
  // Anything, possible or not.
  Edit next(const Workspace& w) {
    if (w.objects.empty()) return {"add", edit::add(w, given())};
    const std::size_t object = index(w.objects.size());
    const std::string name = w.objects[object].name;
    const PointRef point{object, index(point_count(w.objects[object].geometry) + 1)};
    const std::string place_name = name + "." + std::to_string(point.point);
    switch (whole(0, 23)) {
      case 0:
        return {"add", edit::add(w, given())};
      case 1:
        return {"make", with_made(w)};
      case 2:
        return {"remove " + name, edit::remove(w, {object})};
      case 3:
        return {"duplicate " + name, edit::duplicate(w, some(w, 3))};
      case 4:
        return {"rename " + name,
                edit::rename(w, object, one_in(3) ? "thing" : "name " + std::to_string(whole(0, 99)))};
      case 5:
        return {"reorder " + name, edit::move_to(w, object, index(w.objects.size()))};
      case 6:
        return {"detach " + name, edit::detach(w, object)};
      case 7:
        return {"colour " + name, edit::set_color(w, object, whole(-1, object_colors))};
      case 8:
        return {"hide " + name, edit::set_hidden(w, some(w, 3), one_in(2))};
      case 9:
        return {"show " + name, edit::set_show(w, some(w, 3), static_cast<Show>(whole(0, show_count - 1)), one_in(2))};
      case 10:
        return {"map " + name, edit::set_map(w, object, static_cast<SurfaceMap>(whole(0, surface_map_count - 1)))};
      case 11:
        return {"look at " + name, edit::look_at(w, object, number(), number())};
      case 12:
        return {"move " + place_name, edit::move_points(w, {point, {index(w.objects.size()), 0}}, place())};
      case 13:
        return {"place " + place_name, edit::set_place(w, point, place())};
      case 14:
        return {"weight " + place_name, edit::set_weight(w, point, Exact::ratio(whole(-1, 8), 4))};
      case 15:
        return {"insert behind " + place_name, edit::insert_point(w, point, place())};
      case 16:
        return {"delete " + place_name, edit::delete_points(w, {point, {object, 0}})};
      case 17:
        return {"place " + name, edit::place(w, some(w, 2), placement(), place())};
      case 18:
        return {"place instance of " + name, place_some_instance(w, object)};
      case 19:
        return {"place points of " + name, edit::place(w, std::vector<PointRef>{point}, placement(), place())};
      default:
        return std::holds_alternative<Surface<Exact>>(w.objects[object].geometry) ? change_surface(w, object)
                                                                                  : change_curve(w, object);
    }
  }

  // An edit of a curve, with what it is.
  std::pair<std::string, std::function<edit::EditedCurve(Curve<Exact>)>> curve_edit(const Curve<Exact>& curve) {
    const std::size_t point = index(curve.points.size()), knot = index(curve.knots.size());
    const Exact value = curve.knots[knot] + Exact::ratio(whole(-3, 3), 4), weight = Exact::ratio(whole(-1, 8), 4);
    const Point<Exact> to = place();
    const std::string at = std::to_string(point), of = std::to_string(knot) + " to " + value.to_string();
    const int degree = whole(0, 6);
    const auto kind = static_cast<CurveKind>(whole(0, 3));
    const auto form = static_cast<CurveForm>(whole(0, 2));
    const int dimension = whole(2, 3);
    switch (whole(0, 9)) {
      case 0:
        return {"move " + at, [=](Curve<Exact> c) { return edit::move_point(std::move(c), point, to); }};
      case 1:
        return {"weight of " + at, [=](Curve<Exact> c) { return edit::set_weight(std::move(c), point, weight); }};
      case 2:
        return {"insert behind " + at, [=](Curve<Exact> c) { return edit::insert_point(std::move(c), point, to); }};
      case 3:
        return {"delete " + at, [=](Curve<Exact> c) { return edit::delete_point(std::move(c), point); }};
      case 4:
        return {"knot " + of, [=](Curve<Exact> c) { return edit::set_knot(std::move(c), knot, value); }};
      case 5:
        return {"knots like " + of, [=](Curve<Exact> c) { return edit::set_equal_knots(std::move(c), knot, value); }};
      case 6:
        return {"degree " + std::to_string(degree),
                [=](Curve<Exact> c) { return edit::set_degree(std::move(c), degree); }};
      case 7:
        return {"kind " + std::string(curve_kind_name(kind)),
                [=](Curve<Exact> c) { return edit::set_kind(std::move(c), kind); }};
      case 8:
        return {"form " + std::string(curve_form_name(form)),
                [=](Curve<Exact> c) { return edit::set_form(std::move(c), form); }};
      default:
        return {"dimension", [=](Curve<Exact> c) { return edit::set_dimension(std::move(c), dimension); }};
    }
  }

 private:
  Worked place_some_instance(const Workspace& w, std::size_t object) {
    const auto& recipe = w.objects[object].recipe;
    const std::string input = recipe && !recipe->inputs.empty() ? recipe->inputs.begin()->first : "none";
    return edit::place_instance(w, object, input, 0, placement());
  }

  Edit change_curve(const Workspace& w, std::size_t object) {
    const auto* curve = std::get_if<Curve<Exact>>(&w.objects[object].geometry);
    if (curve == nullptr) return {"detach", edit::detach(w, object)};
    const auto [what, change] = curve_edit(*curve);
    return {what + " of " + w.objects[object].name, edit::change(w, object, change)};
  }

  Edit change_surface(const Workspace& w, std::size_t object) {
    const auto& surface = std::get<Surface<Exact>>(w.objects[object].geometry);
    const int direction = whole(0, 1), row = whole(-1, 5), degree = whole(0, 5);
    const auto& U = surface.knots[static_cast<std::size_t>(direction)];
    const std::size_t knot = index(U.size());
    const Exact value = U[knot] + Exact::ratio(whole(-3, 3), 4);
    const auto kind = static_cast<CurveKind>(whole(0, 3));
    const std::string of = " of " + w.objects[object].name;
    const auto done = [&](const std::string& what, auto&& change) {
      return Edit{what + of, edit::change(w, object, std::function<edit::EditedSurface(Surface<Exact>)>(change))};
    };
    switch (whole(0, 5)) {
      case 0:
        return done("insert row", [=](Surface<Exact> s) { return edit::insert_row(std::move(s), direction, row); });
      case 1:
        return done("delete row", [=](Surface<Exact> s) { return edit::delete_row(std::move(s), direction, row); });
      case 2:
        return done("degree", [=](Surface<Exact> s) { return edit::set_degree(std::move(s), direction, degree); });
      case 3:
        return done("kind", [=](Surface<Exact> s) { return edit::set_kind(std::move(s), kind); });
      case 4:
        return done("knot", [=](Surface<Exact> s) { return edit::set_knot(std::move(s), direction, knot, value); });
      default:
        return done("knots",
                    [=](Surface<Exact> s) { return edit::set_equal_knots(std::move(s), direction, knot, value); });
    }
  }

  std::mt19937 random_;
};

}  // namespace blossom::test
