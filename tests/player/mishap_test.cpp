// What goes wrong in real life: files that change under one's hands, runs that differ, edits that must not be lost.
#include "player/doing.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

void write(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

// 1/3 and its first 26 decimals are one double: in decimals the profiles have one knot there, in fractions two.
constexpr const char* nearly_equal_knots =
    R"({"schema": "blossom.exercise/1", "id": "near", "title": "Near", "prompt": "p",
  "algorithm": "skinning", "inputs": {"degree_v": 2, "profiles": [
    {"degree": 2, "knots": [0, 0, 0, "1/3", 1, 1, 1], "points": [[0,0,0],[1,2,0],[2,0,0],[3,1,0]]},
    {"degree": 2, "knots": [0, 0, 0, "0.33333333333333333333333333", 1, 1, 1], "points": [[0,0,1],[1,2,1],[2,0,1],[3,1,1]]},
    {"degree": 2, "knots": [0, 0, 0, "1/2", 1, 1, 1], "points": [[0,0,2],[1,2,2],[2,0,2],[3,1,2]]}]},
  "ask": [{"value": "Q[*][*]", "points": 1}], "tolerance": {"absolute": 0.01}})";

}  // namespace

TEST_CASE("in decimals a run may have other steps than in fractions: questions follow their names or end") {
  World world;
  Player& player = world.player();
  write(world.scratch / "near.json", nearly_equal_knots);
  player.settings.exact = true;
  REQUIRE(player.open(world.scratch / "near.json"));
  REQUIRE(player.session()->prediction() != nullptr);
  const auto steps = player.session()->last();
  player.session()->set_exact(false);
  CHECK(player.session()->last() != steps);
  if (const Prediction* prediction = player.session()->prediction())
    for (const AskedValue& question : prediction->questions()) {
      const TraceGraph& graph = player.session()->recording().graph();
      REQUIRE(question.value < graph.value_count());
      CHECK(graph.name(question.value) == question.name);
      CHECK(graph.value(question.value).step == question.step);
    }
}

TEST_CASE("what has the keyboard is looked up by its name after an edit, or let go of") {
  World world;
  Player& player = world.player();
  REQUIRE(player.open(fs::absolute("tests/play/data/22-de-boor.json")));
  const auto id = [&](const char* name) { return *player.session()->recording().graph().find(name); };
  player.focused = {Link::Kind::value, id("P[3][4]")};
  player.settle();
  const Session& s = *player.session();
  REQUIRE(player.edit(set_degree(s.algorithm(), s.inputs(), {"curve", 0}, 2), "degree"));
  player.settle();
  CHECK_FALSE(player.focused);  // there is no third level any more
  player.focused = {Link::Kind::value, id("P[0][3]")};
  player.settle();
  REQUIRE(player.edit(set_number(s.algorithm(), s.inputs(), "u", *Exact::parse("4/5")), "u"));
  player.settle();
  CHECK(player.focused == Link{Link::Kind::value, id("P[0][3]")});
  player.pin({Link::Kind::value, 1'000'000});
  player.ask_why(1'000'000);
  CHECK_FALSE(player.pinned());
  CHECK_FALSE(player.why_asked());
}

TEST_CASE("edits that one goes on without are lost only when there is something to go on to") {
  World world;
  Player& player = world.player();
  REQUIRE(player.open(fs::absolute("tests/play/data/22-de-boor.json")));
  REQUIRE(move(player, 3, 40, 20));
  write(world.scratch / "broken.json", "{");
  player.unless_unsaved([&](Player& p) { p.open(world.scratch / "broken.json"); });
  proceed_after_unsaved(player);
  CHECK(player.problems().list.size() == 1);
  CHECK(player.session()->edited());
  CHECK(player.session()->unsaved());
}

TEST_CASE("a file that changes while something of it is held takes it out of the hand") {
  World world(true);
  Player& player = world.player();
  const fs::path file = world.scratch / "lesson.json";
  write(file, text_of("tests/play/data/22-de-boor.json"));
  REQUIRE(player.open(file));
  player.set_view_size({600, 400});
  const Session& s = *player.session();
  REQUIRE(player.take(PointGrip(s, {"curve", 0, 3}, player.shown_camera(), player.view_size(), {300, 100}, 0)));
  player.drag({320, 110}, {});
  for (const char* other : {"lessons/67-skinning.json", "lessons/28-knot-insertion.json"}) {
    write(file, text_of(other));
    for (int i = 0; i < 4; ++i) player.advance(0.6);
    CHECK(player.problems().list.empty());
    player.drag({340, 120}, {});
    CHECK_FALSE(player.session()->edited());
    CHECK_FALSE(player.camera());
  }
  player.let_go();
}

TEST_CASE("answers stay when the exercise's file changes and asks the same") {
  World world(true);
  Player& player = world.player();
  const fs::path file = world.scratch / "exercise.json";
  std::string text = text_of("exercises/11-de-casteljau.json");
  write(file, text);
  REQUIRE(player.open(file));
  const std::string name = player.session()->prediction()->questions()[0].name;
  const std::size_t numbers = player.session()->prediction()->questions()[0].size;
  REQUIRE_FALSE(player.session()->prediction()->answer(0, std::vector<std::string>(numbers, "1")));
  text.insert(text.find('{') + 1, "\n");
  write(file, text);
  for (int i = 0; i < 4; ++i) player.advance(0.6);
  REQUIRE(player.session()->prediction() != nullptr);
  REQUIRE(player.session()->prediction()->attempt(0));
  CHECK(player.session()->prediction()->questions()[0].name == name);
  CHECK(player.session()->prediction()->attempt(0)->numbers == std::vector<std::string>(numbers, "1"));
}

TEST_CASE("a file whose name is no UTF-8 does not spoil what is remembered of the others") {
  World world;
  Player& player = world.player();
  const fs::path odd = world.scratch / "odd\xff.json";
  write(odd, text_of("tests/play/data/11-de-casteljau.json"));
  REQUIRE(player.open(odd));
  player.keep();
  REQUIRE(player.open(fs::absolute("tests/play/data/22-de-boor.json")));
  player.seek(3);
  player.keep();
  player.keep();
  Diagnostics wrong;
  const auto progress = load_progress(options_in(world.scratch).places, wrong);
  CHECK(to_string(wrong).empty());
  CHECK(progress.contains(fs::absolute("tests/play/data/22-de-boor.json").string()));
}

TEST_CASE("answers to an exercise are not lost without a word; those of practice may be") {
  World world;
  Player& player = world.player();
  int done = 0;
  REQUIRE(player.open(fs::absolute("exercises/22-de-boor.json")));
  player.unless_unsaved([&](Player&) { ++done; });
  CHECK(done == 1);  // nothing was answered
  REQUIRE_FALSE(player.session()->prediction()->answer(0, {"4"}));
  player.unless_unsaved([&](Player&) { ++done; });
  CHECK(done == 1);
  CHECK(player.dialog == Dialog::unsaved);
  player.save_answers(world.scratch / "answers.json");
  CHECK(done == 2);  // saved, it goes on
  player.unless_unsaved([&](Player&) { ++done; });
  CHECK(done == 3);
  CHECK(text_of(world.scratch / "answers.json").find("\"k\": \"4\"") != std::string::npos);

  REQUIRE(player.open(fs::absolute("tests/play/data/11-de-casteljau.json")));
  REQUIRE(player.session()->start_prediction().empty());
  REQUIRE_FALSE(player.session()->prediction()->answer(0, {"1", "1"}));
  player.unless_unsaved([&](Player&) { ++done; });
  CHECK(done == 4);
}
