// The player with a mouse and a keyboard in its hands.
#include <catch2/catch.hpp>

#include "player/action.hpp"
#include "player/player.hpp"

using namespace blossom;

namespace {

class NoDesk final : public Desk {
 public:
  void set_clipboard(const std::string&) override {}
  std::string clipboard() override { return {}; }
  bool choose_file(bool, const std::filesystem::path&, std::function<void(std::filesystem::path)>) override {
    return false;
  }
  Checked<bool> save_picture(const Scene&, const std::filesystem::path&) override { return true; }
};

struct Opened {
  NoDesk desk;
  Player player{PlayerOptions{{}, "lessons", "exercises", false}, desk};
  explicit Opened(const char* file = "tests/play/data/22-de-boor.json") { REQUIRE(player.open(file)); }

  Session& session() { return *player.session(); }
  ValueId value(const std::string& name) { return session().recording().graph().find(name).value(); }
  std::string text(const std::string& name) { return session().recording().source().value_text(value(name)); }
  void take_point(const std::string& name) {
    player.take(grip_of_value(session(), value(name), player.shown_camera(), player.view_size(), {0, 0}));
  }
  std::size_t points() { return session().inputs().curve("curve").points.size(); }
};

constexpr KnotAxis axis{0, 1, 0, 1000};

}  // namespace

TEST_CASE("a drag is one state of the history, however many places it went through") {
  Opened open;
  open.take_point("P[0][3]");
  for (int i = 1; i <= 10; ++i) open.player.drag({10.0 * i, 0}, {});
  CHECK(open.text("P[0][3]") != "(30, 20)");
  open.player.let_go();
  CHECK(open.session().history().size() == 2);
  CHECK(open.session().history().undo_what() == "P[0][3] moved");
  CHECK(open.session().undo());
  CHECK(open.text("P[0][3]") == "(30, 20)");
}

TEST_CASE("the camera stands still while a point is dragged out of the picture") {
  Opened open;
  const Camera before = open.player.shown_camera();
  open.take_point("P[0][3]");
  open.player.drag({3000, 0}, {});
  CHECK(open.player.shown_camera() == before);
}

TEST_CASE("what is put back leaves no trace, and moves no more until the button is released") {
  Opened open;
  open.take_point("P[0][3]");
  open.player.drag({50, 50}, {});
  CHECK(open.player.put_back());
  CHECK_FALSE(open.session().edited());
  CHECK_FALSE(open.session().history().can_redo());
  open.player.drag({90, 50}, {});
  CHECK_FALSE(open.session().edited());
  CHECK(open.player.holding());
  CHECK(open.player.held() == nullptr);
  CHECK_FALSE(open.player.put_back());
  open.player.let_go();
  CHECK_FALSE(open.player.holding());
}

TEST_CASE("a drag that ends where it began is none") {
  Opened open;
  open.take_point("P[0][3]");
  open.player.drag({50, 50}, {});
  open.player.drag({0, 0}, {});
  open.player.let_go();
  CHECK_FALSE(open.session().history().can_undo());
}

TEST_CASE("a knot that is dragged too far is refused, and the run is as before the drag") {
  Opened open;
  CHECK(open.player.take(KnotGrip(open.session(), {"curve", 0}, 5, axis, 500)));
  open.player.drag({600, 0}, {});
  CHECK(open.session().edited());
  open.player.drag({900, 0}, {});
  CHECK(open.session().rejected().size() == 1);
  CHECK_FALSE(open.session().edited());
  open.player.drag({650, 0}, {});
  CHECK(open.session().rejected().empty());
  CHECK(open.session().edited());
  open.player.drag({900, 0}, {});
  open.player.let_go();
  CHECK(open.session().rejected().empty());
  CHECK_FALSE(open.session().edited());
  CHECK_FALSE(open.session().history().can_undo());
}

TEST_CASE("one stays at the step while u is dragged into another span and back") {
  Opened open;
  REQUIRE(open.session().seek("P[1][3]"));
  CHECK(open.player.take(ParameterGrip(open.session(), axis, 400, false)));
  open.player.drag({600, 0}, {});
  CHECK(open.text("k") == "5");
  open.player.drag({400, 0}, {});
  const TraceGraph& graph = open.session().recording().graph();
  CHECK(graph.name(graph.main_value(open.session().step())) == "P[1][3]");
}

TEST_CASE("keys move the chosen point by a tenth of the grid, and add and delete points") {
  Opened open;
  CHECK_FALSE(perform(open.player, "edit.nudge_left"));  // nothing is chosen
  open.player.pin({Link::Kind::value, open.value("P[0][3]")});
  const double grid = grid_spacing(open.session(), open.player.shown_camera(), open.player.view_size());
  CHECK(grid == 5);
  CHECK(perform(open.player, "edit.nudge_left"));
  CHECK(perform(open.player, "edit.nudge_up"));
  CHECK(open.text("P[0][3]") == "(59/2, 41/2)");
  CHECK_FALSE(perform(open.player, "edit.nudge_nearer"));  // in the plane there is no such way
  CHECK(perform(open.player, "edit.insert_point"));
  CHECK(open.points() == 8);
  CHECK(open.player.pinned() == Link{Link::Kind::value, open.value("P[0][4]")});
  CHECK(perform(open.player, "edit.delete_point"));
  CHECK(open.points() == 7);
  for (int i = 0; i < 3; ++i) CHECK(perform(open.player, "edit.delete_point"));
  CHECK(open.points() == 4);
  CHECK(perform(open.player, "edit.delete_point"));  // a cubic has four
  CHECK(open.points() == 4);
  CHECK(open.player.notice().find("at least 4 control points") != std::string::npos);
}

TEST_CASE("a click is an answer while a point is asked, and what is given stays as it is") {
  Opened open;
  CHECK_FALSE(open.player.asks_place());
  REQUIRE(open.session().start_prediction().empty());
  const Prediction& prediction = *open.session().prediction();
  std::size_t point = 0;
  while (prediction.questions()[point].kind != ValueKind::point) ++point;
  open.player.choose_question(point);
  REQUIRE(open.player.asks_place());
  open.player.predict_click({1.26, 2, 0});
  CHECK(open.player.predicted_place == glm::dvec3{1.26, 2, 0});
  const auto said = open.player.said_place(point);
  REQUIRE(said);
  CHECK(said->x == Approx(1.26).margin(0.051));
  open.take_point("P[0][3]");
  open.player.drag({50, 50}, {});
  open.player.let_go();
  CHECK_FALSE(open.session().edited());
  CHECK(open.session().prediction() != nullptr);
}
