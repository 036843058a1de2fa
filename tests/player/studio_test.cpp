// The studio without a player: what is chosen, drawing by clicks, drags as one state, what moves.
#include "player/studio.hpp"

#include <catch2/catch.hpp>

#include "player/studio_state.hpp"
#include "studio/seams.hpp"

using namespace blossom;

namespace {

Point<Exact> at(int x, int y, int z = 0) { return {Exact(x), Exact(y), Exact(z)}; }

std::string state(const Studio& studio, const std::string& key) {
  const auto is = studio_state_of(studio, key);
  INFO("no " << key);
  REQUIRE(is);
  return *is;
}

// Four points of a zigzag.
void add_zigzag(Studio& studio) {
  REQUIRE(studio.add_curve(CurveKind::bspline, 3, 2, {at(0, 0), at(1, 2), at(3, 2), at(4, 0)}));
}

constexpr ViewSize size{800, 500};

StudioGrip grip_of(const Studio& studio, PointRef ref) {
  StudioGrip grip;
  grip.kind = StudioGrip::Kind::points;
  grip.pane = StudioPane::xy;
  grip.camera = studio.camera_of(StudioPane::xy, size);
  grip.size = size;
  const auto place = place_of(studio.workspace().objects[ref.object].geometry, ref.point);
  grip.start = to_page(grip.camera, size, in_world(*place)).value();
  grip.grid = studio.grid_of(StudioPane::xy, size);
  grip.held = ref;
  grip.points = {ref};
  return grip;
}

}  // namespace

TEST_CASE("clicks draw a curve whose degree grows with its points, and go back one by one") {
  Studio studio;
  studio.set_tool(Tool::draw);
  studio.click(at(0, 0));
  CHECK(studio.workspace().objects.empty());
  studio.click(at(1, 2));
  CHECK(state(studio, "degree") == "1");
  studio.click(at(3, 2));
  studio.click(at(4, 0));
  studio.click(at(6, 1));
  CHECK(state(studio, "degree") == "3");
  CHECK(state(studio, "object curve points") == "5");
  CHECK(state(studio, "point curve 4") == "6 1 0");
  CHECK(state(studio, "object curve knots") == "0 0 0 0 1 2 2 2 2");
  REQUIRE(studio.take_back_click());
  CHECK(state(studio, "object curve points") == "4");
  REQUIRE(studio.undo());  // the same
  CHECK(state(studio, "object curve points") == "3");
  CHECK(studio.clicked().size() == 3);
  REQUIRE(studio.finish_drawing());
  CHECK(studio.clicked().empty());
  studio.click(at(9, 9));
  studio.click(at(8, 9));
  CHECK(studio.workspace().objects.size() == 2);
}

TEST_CASE("a Bezier curve is drawn with as high a degree as it has points, and in space if a point lies there") {
  Studio studio;
  studio.new_kind = CurveKind::bezier;
  studio.set_tool(Tool::draw);
  for (const auto& p : {at(0, 0), at(1, 2), at(3, 2, 1), at(4, 0), at(5, 5)}) studio.click(p);
  const auto* curve = std::get_if<Curve<Exact>>(&studio.object()->geometry);
  REQUIRE(curve != nullptr);
  CHECK(curve->bezier);
  CHECK(curve->degree == 4);
  CHECK(curve->dimension == 3);
}

TEST_CASE("a drag is one state, and one that is put back or leads back is none") {
  Studio studio;
  add_zigzag(studio);
  const std::size_t states = studio.history().size();
  const StudioGrip grip = grip_of(studio, {0, 1});
  const auto move_on = [&](double dx, double dy) { studio.drag(grip.start + glm::dvec2{dx, dy}, {}); };

  studio.take(grip);
  for (int i = 1; i <= 10; ++i) move_on(4 * i, -3 * i);
  studio.let_go();
  CHECK(studio.history().size() == states + 1);
  CHECK(studio.history().undo_what() == "curve P[1] moved");
  const auto moved = place_of(studio.object()->geometry, 1).value();
  CHECK(moved.x > Exact(1));
  CHECK(moved.y > Exact(2));
  CHECK_FALSE(moved.x.is_approximate());
  REQUIRE(studio.undo());
  CHECK(state(studio, "point curve 1") == "1 2 0");

  studio.take(grip);
  move_on(30, 30);
  REQUIRE(studio.put_back());
  CHECK(state(studio, "point curve 1") == "1 2 0");
  studio.let_go();
  studio.take(grip);
  move_on(30, 30);
  move_on(0, 0);
  studio.let_go();
  CHECK_FALSE(studio.history().undo_what() == "curve P[1] moved");
  CHECK(state(studio, "point curve 1") == "1 2 0");
}

TEST_CASE("with Ctrl a point goes onto the grid, with Shift along one axis") {
  Studio studio;
  add_zigzag(studio);
  const StudioGrip grip = grip_of(studio, {0, 1});
  studio.take(grip);
  studio.drag(grip.start + glm::dvec2{61, -7}, {.along = true, .snap = false});
  auto place = place_of(studio.object()->geometry, 1).value();
  CHECK(place.x > Exact(1));
  CHECK(place.y == Exact(2));
  studio.drag(grip.start + glm::dvec2{61, -57}, {.along = false, .snap = true});
  place = place_of(studio.object()->geometry, 1).value();
  const double x = place.x.to_double() / grip.grid, y = place.y.to_double() / grip.grid;
  CHECK(x == Approx(std::round(x)));
  CHECK(y == Approx(std::round(y)));
  studio.let_go();
}

TEST_CASE("what is chosen stays chosen when things before it go, and points go with theirs") {
  Studio studio;
  add_zigzag(studio);
  add_zigzag(studio);
  add_zigzag(studio);
  CHECK(state(studio, "objects") == "curve, curve 2, curve 3");
  studio.select({{2, 1}});
  CHECK(state(studio, "current") == "curve 3");
  REQUIRE(studio.edit(edit::remove(studio.workspace(), {0}), "one less"));
  CHECK(state(studio, "current") == "curve 3");
  CHECK(state(studio, "selected") == "curve 3 P[1]");
  REQUIRE(studio.undo());
  CHECK(state(studio, "selected") == "curve 3 P[1]");
  REQUIRE(studio.edit(edit::rename(studio.workspace(), 2, "wave"), "a name"));
  CHECK(state(studio, "selected") == "wave P[1]");
  REQUIRE(studio.edit(edit::remove(studio.workspace(), {2}), "gone"));
  CHECK(studio.selected().empty());
  CHECK_FALSE(studio.current());
}

TEST_CASE("the next thing is the next one that is seen, around the end") {
  Studio studio;
  add_zigzag(studio);
  add_zigzag(studio);
  add_zigzag(studio);
  studio.choose(1);
  REQUIRE(studio.hide());
  studio.choose(0);
  studio.choose_next(1);
  CHECK(state(studio, "current") == "curve 3");
  studio.choose_next(1);
  CHECK(state(studio, "current") == "curve");
  studio.choose_next(-1);
  CHECK(state(studio, "current") == "curve 3");
  REQUIRE(studio.show_all());
  CHECK(state(studio, "hidden") == "none");
}

TEST_CASE("u runs along the domain in 6 seconds and around its end; where it stops one looks from then on") {
  Studio studio;
  add_zigzag(studio);
  REQUIRE(studio.look_at(Exact(0), Exact(0)));
  const std::size_t states = studio.history().size();
  studio.run(true);
  for (int i = 0; i < 20; ++i) CHECK(studio.advance(0.1));
  CHECK(studio.u() == Approx(2.0 / 6));
  for (int i = 0; i < 50; ++i) studio.advance(0.1);
  CHECK(studio.u() == Approx(1.0 / 6));
  CHECK(studio.history().size() == states);  // nothing was edited
  studio.run(false);
  CHECK(studio.u() == Approx(1.0 / 6).margin(1e-3));
  CHECK_FALSE(studio.advance(1));
  studio.ride(true);
  CHECK(studio.riding());
  CHECK(studio.camera_of(StudioPane::space, size).perspective);
  CHECK(studio.escape());
  CHECK_FALSE(studio.riding());
}

TEST_CASE("where one looks is nothing to be saved, what one moves is") {
  Studio studio;
  add_zigzag(studio);
  studio.mark_saved("somewhere.json");
  REQUIRE(studio.look_at(0.25, 0));
  CHECK_FALSE(studio.unsaved());
  studio.select({{0, 0}});
  REQUIRE(studio.move_by(at(1, 0)));
  CHECK(studio.unsaved());
  REQUIRE(studio.undo());
  CHECK_FALSE(studio.unsaved());
}

TEST_CASE("a click in the xy pane lies in the plane of what is there, in exact numbers") {
  Studio studio;
  add_zigzag(studio);
  const Camera camera = studio.camera_of(StudioPane::xy, size);
  const auto page = to_page(camera, size, {2.5, 1.25, 0}).value();
  const auto place = studio.place_at(StudioPane::xy, size, page, 0);
  REQUIRE(place);
  CHECK(place->x.to_double() == Approx(2.5).margin(camera.height / size.height));
  CHECK(place->y.to_double() == Approx(1.25).margin(camera.height / size.height));
  CHECK(place->z == Exact(0));
  const auto on_grid = studio.place_at(StudioPane::xy, size, page, 1);
  REQUIRE(on_grid);
  CHECK((on_grid->y == Exact(1)));
}

TEST_CASE("handles move, turn by whole degrees, and scale about the middle") {
  Studio studio;
  add_zigzag(studio);
  StudioGrip grip = grip_of(studio, {0, 0});
  grip.kind = StudioGrip::Kind::handle;
  grip.points.clear();
  grip.objects = {0};
  grip.centre = studio.centre().value();
  CHECK(grip.centre == Point<Exact>(Exact(2), Exact(1), Exact(0)));
  const auto middle = to_page(grip.camera, size, in_world(grip.centre)).value();
  grip.before = std::make_shared<const Workspace>(studio.workspace());
  grip.start = middle + glm::dvec2{100, 0};
  grip.handle = Handle::turn_z;
  CHECK(placement(grip, middle + glm::dvec2{0, -100}, {}).turn.z == Exact(90));  // up on the page
  grip.handle = Handle::scale;
  CHECK(placement(grip, middle + glm::dvec2{150, 0}, {}).scale.x == Exact::ratio(3, 2));
  grip.handle = Handle::move_x;
  const auto moved = placement(grip, grip.start + glm::dvec2{50, 20}, {}).move;
  CHECK(moved.x.to_double() == Approx(50 * grip.camera.height / size.height).margin(grip.camera.height / size.height));
  CHECK(moved.y == Exact(0));
}

TEST_CASE("a refused edit changes nothing and says why") {
  Studio studio;
  add_zigzag(studio);
  const auto version = studio.version();
  CHECK_FALSE(studio.edit(
      edit::change(studio.workspace(), 0, [](Curve<Exact> c) { return edit::set_degree(std::move(c), 9); }), "degree"));
  CHECK(studio.version() == version);
  CHECK(studio.refusals() == 1);
  CHECK_FALSE(studio.problems().empty());
}

TEST_CASE("kept smooth, the other part of a curve that was cut follows, in one state of the history") {
  Studio studio;
  REQUIRE(studio.add_curve(CurveKind::bezier, 3, 2, {at(0, 0), at(1, 2), at(3, 2), at(4, 0)}));
  REQUIRE(studio.apply(*find_algorithm("subdivision")));
  REQUIRE(studio.workspace().objects.size() == 3);
  const auto smooth = [&] {
    const auto& objects = studio.workspace().objects;
    return share_smooth_border(objects[1].geometry, objects[2].geometry);
  };
  REQUIRE(smooth());
  studio.select({{1, 3}});  // the border
  REQUIRE(studio.move_by({Exact(0), Exact(1), Exact(0)}));
  CHECK_FALSE(smooth());
  REQUIRE(studio.undo());
  studio.keep_smooth = true;
  studio.select({{1, 3}});
  const std::size_t states = studio.history().size();
  REQUIRE(studio.move_by({Exact(0), Exact(1), Exact(0)}));
  CHECK(smooth());
  CHECK(studio.history().size() == states);  // the undone one is replaced
}
