// One open document: its run, where one is in it, and what edits do to both.
#include "player/session.hpp"

#include <catch2/catch.hpp>

#include "scratch.hpp"

using namespace blossom;
namespace fs = std::filesystem;

namespace {

Document document(const std::string& file) {
  auto opened = open_document(fs::absolute(file));
  INFO(to_string(opened.diagnostics));
  REQUIRE(opened);
  return std::move(*opened);
}

std::unique_ptr<Session> session(const std::string& file = "tests/play/data/22-de-boor.json", bool exact = true) {
  auto opened = Session::open(document(file), exact);
  INFO(to_string(opened.diagnostics));
  REQUIRE(opened);
  return std::move(*opened);
}

Edited moved(const Session& s, std::size_t point, int x) {
  return move_point(s.algorithm(), s.inputs(), {"curve", 0, point}, Point<Exact>(Exact(x), Exact(1), Exact(0)));
}

std::string made(const Session& s) {
  const ValueId v = s.recording().graph().main_value(s.step());
  return v == absent ? "" : s.recording().graph().name(v);
}

}  // namespace

TEST_CASE("a session begins at step 0, unedited, in the arithmetic one wishes") {
  for (const bool exact : {true, false}) {
    const auto s = session("tests/play/data/22-de-boor.json", exact);
    CHECK(s->step() == 0);
    CHECK(s->last() == 15);
    CHECK_FALSE(s->edited());
    CHECK_FALSE(s->unsaved());
    CHECK(s->recording().source().exact == exact);
  }
}

TEST_CASE("a point whose weight was 0 comes back to where it was, over several gestures and undo") {
  const auto s = session();
  const PointAddress address{"curve", 0, 3};
  const std::string weight = "curve.weights[3]";
  const auto place = [&] { return affine(curve_at(s->inputs(), {"curve", 0}), 3); };
  const Point<Exact> before = place();
  REQUIRE(s->edit(set_weight(s->algorithm(), s->inputs(), address, Exact(3)), "weight"));
  const auto slide = [&](int to) {
    REQUIRE(s->edit(s->with_number_at(weight, Exact(to)), "weight", "slide"));
    CHECK(number_at(s->inputs(), weight) == Exact(to));
  };
  slide(0);
  slide(2);  // in one gesture
  CHECK(place() == before);
  slide(0);
  s->end_gesture();
  slide(4);  // in another one
  s->end_gesture();
  CHECK(place() == before);
  slide(0);
  s->end_gesture();
  REQUIRE(s->undo());
  REQUIRE(s->redo());
  slide(1);
  CHECK(place() == before);
}

TEST_CASE("every edit is a new recording, what refers to the old one may keep it, and an edit of nothing is none") {
  const auto s = session();
  const auto before = s->shared_recording();
  const auto version = s->version();
  REQUIRE(s->edit(moved(*s, 3, 44), "move"));
  CHECK(s->version() > version);
  CHECK(s->shared_recording() != before);
  CHECK(before->graph().step_count() == 16);
  const auto after = s->version();
  REQUIRE(s->edit(moved(*s, 3, 44), "move"));
  CHECK(s->version() == after);
  CHECK(s->history().size() == 2);
}

TEST_CASE("edited and unsaved are about the inputs, not about how one came there") {
  const auto s = session();
  REQUIRE(s->edit(moved(*s, 3, 44), "move"));
  CHECK((s->edited() && s->unsaved()));
  s->mark_saved();
  CHECK((s->edited() && !s->unsaved()));
  REQUIRE(s->undo());
  CHECK((!s->edited() && s->unsaved()));
  REQUIRE(s->redo());
  CHECK_FALSE(s->unsaved());
  CHECK_FALSE(s->redo());
  REQUIRE(s->undo());
  REQUIRE(s->edit(moved(*s, 3, 50), "another way"));
  CHECK_FALSE(s->history().can_redo());  // a new edit ends what was undone
}

TEST_CASE("one stays at the step of the same value wherever its number goes") {
  const auto s = session("tests/play/data/22-de-boor.json");
  for (const char* value : {"k", "s", "alpha[1][3]", "P[1][3]", "P[2][4]", "C"}) {
    INFO(value);
    REQUIRE(s->seek(std::string(value)));
    const std::string here = made(*s);
    // A point more: every knot behind it and every number of the run are others.
    REQUIRE(
        s->edit(insert_point(s->algorithm(), s->inputs(), {"curve", 0, 6}, Point<Exact>(Exact(1), Exact(2), Exact(0))),
                "insert"));
    CHECK(made(*s) == here);
    REQUIRE(s->undo());
    CHECK(made(*s) == here);
  }
}

TEST_CASE("a step that makes nothing is found again by its phase") {
  const auto s = session("lessons/32-degree-elevation-bspline.json");
  const TraceGraph& graph = s->recording().graph();
  std::uint32_t phase = 0;
  while (phase < graph.phases().size() && graph.phases()[phase].label() != "elevate") ++phase;
  REQUIRE(phase < graph.phases().size());
  s->seek(graph.phases()[phase].first_step);
  REQUIRE(s->edit(moved(*s, 1, 9), "move"));
  const TraceGraph& after = s->recording().graph();
  std::string path;
  for (const std::uint32_t p : after.phase_path(after.step(s->step()).phase)) path += after.phases()[p].label() + " ";
  CHECK(path.find("elevate") != std::string::npos);
}

TEST_CASE("bookmarks, a repeated range, speed and playing stay through an edit") {
  const auto s = session();
  s->seek(3);
  s->toggle_bookmark();
  s->seek(14);
  s->toggle_bookmark();
  s->move([](Timeline& t) { return t.set_loop(2, 9), t.set_speed(3), t.seek(4); });
  s->move([](Timeline& t) { return t.play(), true; });
  REQUIRE(s->edit(moved(*s, 3, 44), "move"));
  CHECK(s->bookmarks() == std::vector<std::uint32_t>{3, 14});
  CHECK(s->timeline().loop() == std::pair<std::uint32_t, std::uint32_t>{2, 9});
  CHECK(s->timeline().speed() == 3);
  CHECK(s->timeline().playing());
  // A run with fewer steps has no place for the later one.
  REQUIRE(s->edit(set_number(s->algorithm(), s->inputs(), "u", Exact::ratio(1, 2)), "u"));
  REQUIRE(s->last() < 14);
  CHECK(s->bookmarks() == std::vector<std::uint32_t>{3});
  s->seek(3);
  s->toggle_bookmark();
  CHECK(s->bookmarks().empty());
}

TEST_CASE("what is refused is kept until the next edit, and changes nothing") {
  const auto s = session();
  const auto version = s->version();
  CHECK_FALSE(s->edit(set_knot(s->algorithm(), s->inputs(), {"curve", 0}, 5, Exact(-3)), "knot"));
  CHECK_FALSE(s->rejected().empty());
  CHECK(s->version() == version);
  s->forget_rejected();
  CHECK(s->rejected().empty());
}

TEST_CASE("of edited numbers the algorithm speaks first, and the lesson's words stand by") {
  const auto s = session();
  CHECK(s->words().text.starts_with("Seven control points"));
  CHECK(s->words().lesson.empty());
  REQUIRE(s->edit(moved(*s, 3, 44), "move"));
  CHECK_FALSE(s->words().text.starts_with("Seven control points"));
  CHECK(s->words().lesson.starts_with("Seven control points"));
  REQUIRE(s->undo());
  CHECK(s->words().lesson.empty());
}

TEST_CASE("without a lesson the beginnings of the phases are the stations") {
  auto opened = example_document("degree_elevation", "lessons");
  INFO(to_string(opened.diagnostics));
  REQUIRE(opened);
  auto made = Session::open(std::move(*opened), true);
  REQUIRE(made);
  CHECK_FALSE((*made)->timeline().marks().empty());
}

TEST_CASE("fractions and decimals are the same run at the same step") {
  const auto s = session();
  s->seek(std::string("P[2][4]"));
  CHECK(s->recording().source().value_text(*s->recording().graph().find("P[2][4]")) == "(101/5, 94/5)");
  s->set_exact(false);
  CHECK(made(*s) == "P[2][4]");
  CHECK(s->recording().source().value_text(*s->recording().graph().find("P[2][4]")) == "(20.2, 18.8)");
  s->set_exact(true);
  CHECK(made(*s) == "P[2][4]");
}

TEST_CASE("a file that changed is the new original, and the edits made before are below it") {
  const auto s = session();
  s->seek(std::string("P[1][3]"));
  REQUIRE(s->edit(moved(*s, 3, 44), "move"));
  REQUIRE(s->reload(document("tests/play/data/22-de-boor.json")).empty());
  CHECK(made(*s) == "P[1][3]");
  CHECK_FALSE(s->edited());
  CHECK(s->history().undo_what() == "the file was changed on disk");
  REQUIRE(s->undo());
  CHECK(s->edited());

  // Another algorithm's inputs are nothing that could be undone to.
  REQUIRE(s->reload(document("tests/play/data/11-de-casteljau.json")).empty());
  CHECK(s->algorithm().id == "de_casteljau");
  CHECK_FALSE(s->history().can_undo());
}
