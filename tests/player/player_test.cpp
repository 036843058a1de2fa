// The whole application without a window: what a person does, and what follows from it.
#include "player/player.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include "player/action.hpp"
#include "player/doing.hpp"

using namespace blossom;
using namespace blossom::test;

// ---- what is open ---------------------------------------------------------------------------------------------------

TEST_CASE("A player begins with nothing open, and opens lessons, exercises and plain inputs") {
  World world;
  Player& player = world.player();
  CHECK(player.session() == nullptr);
  open(player, de_boor);
  CHECK(state(player, "kind") == "lesson");
  CHECK(state(player, "step") == "0");
  CHECK(player.tab == "tableau");
  open(player, "exercises/22-de-boor.json");
  CHECK(state(player, "kind") == "exercise");
  CHECK(state(player, "predicting") == "yes");
  CHECK(player.tab == "predict");
  const auto inputs =
      world.scratch.write("mine.json", R"({"curve": {"degree": 2, "points": [[0,0],[1,2],[2,0]]}, "u": "1/3"})");
  REQUIRE(player.open(inputs, "de_casteljau"));
  CHECK(state(player, "kind") == "inputs");
  CHECK(player.session()->inputs().number("u") == Exact::ratio(1, 3));
  player.close();
  CHECK(player.session() == nullptr);
}

TEST_CASE("What cannot be opened leaves what is open where it is, and is said with line and column") {
  World world;
  Player& player = world.player();
  open(player, de_boor);
  go_to(player, "P[1][3]");
  const auto broken = world.scratch.write("broken.json", replaced(text_of(de_boor), "\"degree\": 3", "\"degree\": 33"));
  for (const std::string& file :
       {broken, world.scratch / "missing.json", world.scratch.path(), world.scratch.write("empty.json", ""),
        world.scratch.write("binary.json", std::string(9, '\0')),
        world.scratch.write("deep.json", std::string(100000, '['))}) {
    INFO(file);
    CHECK_FALSE(player.open(file));
    CHECK(made(player) == "P[1][3]");
    REQUIRE_FALSE(player.problems().list.empty());
    CHECK(player.problems().what.find("cannot be opened") != std::string::npos);
  }
  CHECK_FALSE(player.open(broken));
  CHECK(player.problems().list[0].line == 13);
  CHECK(player.problems().list[0].column > 0);
  player.dismiss_problems();
  CHECK(player.problems().list.empty());
}

TEST_CASE("Opening something else takes nothing along") {
  World world;
  Player& player = world.player();
  open(player, de_boor);
  go_to(player, "P[2][4]");
  player.pin(link_to(player, "P[1][3]"));
  player.ask_why(link_to(player, "P[2][4]").id);
  player.set_camera(Camera{});
  open(player, "tests/play/data/11-de-casteljau.json");
  CHECK_FALSE(player.pinned());
  CHECK_FALSE(player.why_asked());
  CHECK_FALSE(player.camera());
  CHECK(player.motion() == 1);
  CHECK(state(player, "step") == "0");
}

// ---- editing --------------------------------------------------------------------------------------------------------

TEST_CASE("After an edit one is at the same step of the new run") {
  World world;
  Player& player = world.player();
  open(player, de_boor);
  go_to(player, "P[1][3]");
  const std::string before = state(player, "value P[1][3]");
  REQUIRE(move(player, 3, 40, 20));
  CHECK(made(player) == "P[1][3]");
  CHECK(state(player, "value P[1][3]") != before);
  CHECK(state(player, "edited") == "yes");
  CHECK_FALSE(player.animating());

  SECTION("undo and redo show every state again") {
    REQUIRE(move(player, 3, 50, 30));
    const std::string after = state(player, "value P[1][3]");
    REQUIRE(perform(player, "edit.undo"));
    REQUIRE(perform(player, "edit.undo"));
    CHECK(state(player, "value P[1][3]") == before);
    CHECK(state(player, "edited") == "no");
    CHECK_FALSE(perform(player, "edit.undo"));
    REQUIRE(perform(player, "edit.redo"));
    REQUIRE(perform(player, "edit.redo"));
    CHECK(state(player, "value P[1][3]") == after);
    CHECK(made(player) == "P[1][3]");
  }
  SECTION("a drag is one edit, however many places it passed") {
    for (int x = 41; x < 60; ++x) REQUIRE(move(player, 3, x, 20, "drag 3"));
    player.session()->end_gesture();
    for (int x = 59; x > 50; --x) REQUIRE(move(player, 3, x, 20, "drag 3"));
    CHECK(player.session()->history().size() == 4);
    REQUIRE(perform(player, "edit.undo"));
    CHECK(affine(curve_at(player.session()->inputs(), {"curve", 0}), 3).x == Exact(59));
  }
  SECTION("taking all back is an edit, too") {
    REQUIRE(perform(player, "edit.revert"));
    CHECK(state(player, "edited") == "no");
    REQUIRE(perform(player, "edit.undo"));
    CHECK(state(player, "edited") == "yes");
  }
}

TEST_CASE("A value that an edit takes away is found again when a later edit brings it back") {
  World world;
  Player& player = world.player();
  open(player, de_boor);
  go_to(player, "P[1][2]");
  REQUIRE(set_u(player, Exact::ratio(1, 2)));  // a knot: one level and the leftmost point less
  CHECK_FALSE(player.session()->recording().graph().find("P[1][2]"));
  REQUIRE(set_u(player, Exact::ratio(3, 10)));
  CHECK(made(player) == "P[1][2]");
}

TEST_CASE("An edit that is refused changes nothing and says where and why") {
  World world;
  Player& player = world.player();
  open(player, de_boor);
  go_to(player, "P[1][3]");
  const auto version = player.session()->version();
  const auto& session = *player.session();
  CHECK_FALSE(player.edit(set_knot(session.algorithm(), session.inputs(), {"curve", 0}, 4, Exact(9)), "a knot"));
  CHECK(session.version() == version);
  CHECK(session.history().size() == 1);
  REQUIRE_FALSE(session.rejected().empty());
  CHECK(session.rejected()[0].path.find("knots[4]") != std::string::npos);
  REQUIRE(move(player, 3, 1, 1));
  CHECK(session.rejected().empty());
}

TEST_CASE("What is pinned or asked about stays pinned through edits, by its name") {
  World world;
  Player& player = world.player();
  open(player, de_boor);
  go_to(player, "P[3][4]");
  player.pin(link_to(player, "P[1][2]"));
  player.ask_why(link_to(player, "P[2][4]").id);
  REQUIRE(set_u(player, Exact::ratio(1, 2)));
  CHECK_FALSE(player.pinned());  // for the time being
  REQUIRE(set_u(player, Exact::ratio(3, 10)));
  CHECK(player.pinned() == link_to(player, "P[1][2]"));
  CHECK(player.why_asked() == link_to(player, "P[2][4]").id);
  player.pin(link_to(player, "P[1][2]"));  // again: off
  CHECK_FALSE(player.pinned());
}

TEST_CASE("Before edits are lost one is asked") {
  World world;
  Player& player = world.player();
  open(player, de_boor);
  int done = 0;
  player.unless_unsaved([&](Player&) { ++done; });
  CHECK(done == 1);  // nothing to lose
  REQUIRE(move(player, 3, 40, 20));
  player.unless_unsaved([&](Player&) { ++done; });
  CHECK(done == 1);
  CHECK(player.dialog == Dialog::unsaved);
  SECTION("staying does nothing") {
    player.dialog = Dialog::none;
    CHECK(done == 1);
    CHECK(player.session()->unsaved());
  }
  SECTION("going on does it once") {
    proceed_after_unsaved(player);
    CHECK(done == 2);
    CHECK(player.dialog == Dialog::none);
    proceed_after_unsaved(player);
    CHECK(done == 2);
  }
  SECTION("after saving it goes on, and nobody asks") {
    player.save_lesson(world.scratch / "saved.json", "mine", "Mine");
    CHECK(done == 2);
    player.unless_unsaved([&](Player&) { ++done; });
    CHECK(done == 3);
  }
  SECTION("what was cancelled is not done by a later saving") {
    player.cancel_dialog();
    CHECK(player.dialog == Dialog::none);
    player.save_lesson(world.scratch / "saved.json", "mine", "Mine");
    CHECK(done == 1);
  }
  SECTION("quitting waits for the answer") {
    perform(player, "file.quit");
    CHECK_FALSE(player.wants_to_quit());
    proceed_after_unsaved(player);
    CHECK(player.wants_to_quit());
  }
}

TEST_CASE("Edited inputs are saved as a lesson that opens with them") {
  World world;
  Player& player = world.player();
  open(player, de_boor);
  REQUIRE(move(player, 3, 41, 19));
  const auto inputs = player.session()->inputs();
  const auto file = world.scratch / "mine.json";
  player.save_lesson(file, "mine", "My own numbers");
  CHECK_FALSE(player.session()->unsaved());
  CHECK(player.notice().find("mine.json") != std::string::npos);
  open(player, file);
  CHECK(state(player, "title") == "My own numbers");
  CHECK(player.session()->inputs() == inputs);

  player.save_lesson(world.scratch / "no-such-folder/mine.json", "mine", "Mine");
  CHECK_FALSE(player.problems().list.empty());
}

// ---- files that change ----------------------------------------------------------------------------------------------

TEST_CASE("A file that changes on disk is shown anew at the same step") {
  World world(true);
  Player& player = world.player();
  const std::string text = text_of(de_boor);
  const auto file = world.scratch.write("lesson.json", text);
  open(player, file);
  go_to(player, "P[1][3]");
  const std::string before = state(player, "value P[1][3]");

  world.scratch.write("lesson.json", replaced(text, "[30, 20]", "[40, 25]"));
  let_pass(player, 3);
  CHECK(made(player) == "P[1][3]");
  const std::string after = state(player, "value P[1][3]");
  CHECK(after != before);
  CHECK_FALSE(player.session()->unsaved());

  SECTION("mistakes are listed with line and column while the last good version stays") {
    world.scratch.write("lesson.json", replaced(text, "\"2/5\"", "\"2/\""));
    let_pass(player, 3);
    REQUIRE(player.problems().list.size() == 1);
    CHECK(player.problems().list[0].line == 17);
    CHECK(player.problems().list[0].column > 0);
    CHECK(player.problems().what.find("last good version") != std::string::npos);
    CHECK(state(player, "value P[1][3]") == after);
    // Put right, it is shown, and nothing is wrong any more.
    world.scratch.write("lesson.json", text);
    let_pass(player, 3);
    CHECK(player.problems().list.empty());
    CHECK(state(player, "value P[1][3]") == before);
    CHECK(made(player) == "P[1][3]");
  }
  SECTION("a file that is gone, or half of it, changes nothing") {
    fs::remove(file);
    let_pass(player, 3);
    CHECK(state(player, "value P[1][3]") == after);
    world.scratch.write("lesson.json", text.substr(0, 300));
    let_pass(player, 3);
    CHECK(state(player, "value P[1][3]") == after);
    CHECK_FALSE(player.problems().list.empty());
  }
  SECTION("one's own edits are below it in the history") {
    REQUIRE(move(player, 3, 70, 70));
    world.scratch.write("lesson.json", text);
    let_pass(player, 3);
    CHECK(state(player, "value P[1][3]") == before);
    REQUIRE(perform(player, "edit.undo"));
    CHECK(affine(curve_at(player.session()->inputs(), {"curve", 0}), 3).x == Exact(70));
  }
  SECTION("words that change without the inputs are read again") {
    player.seek(0);
    world.scratch.write("lesson.json", replaced(text, "Seven control points", "Sieben Punkte"));
    let_pass(player, 3);
    CHECK(state(player, "narration").starts_with("Sieben Punkte"));
  }
}

TEST_CASE("Edits survive a crash: they are offered at the next start, and come back at the same step") {
  const Scratch scratch;
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    FakeDesk desk;
    Player player(options_in(scratch), desk);
    const bool ready = player.open(fs::absolute(de_boor)) && move(player, 3, 47, 11);
    player.session()->seek(std::string("P[1][3]"));
    let_pass(player, 3);  // written by and by, not at the end: there will be none
    _exit(ready ? 0 : 1);
  }
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  REQUIRE((WIFEXITED(status) && WEXITSTATUS(status) == 0));

  FakeDesk desk;
  Player player(options_in(scratch), desk);
  REQUIRE(player.lost_work().size() == 1);
  CHECK(player.lost_work()[0].origin == fs::absolute(de_boor));
  SECTION("taken") {
    player.recover(0);
    REQUIRE(player.session() != nullptr);
    CHECK(made(player) == "P[1][3]");
    CHECK(affine(curve_at(player.session()->inputs(), {"curve", 0}), 3).x == Exact(47));
    CHECK(player.session()->unsaved());
    CHECK(player.lost_work().empty());
    REQUIRE(perform(player, "edit.undo"));
    CHECK_FALSE(player.session()->edited());
  }
  SECTION("given up") {
    player.forget_lost(0);
    CHECK(player.lost_work().empty());
  }
  FakeDesk other_desk;
  CHECK(Player(options_in(scratch), other_desk).lost_work().empty());
}

TEST_CASE("Who quits has given up the edits; whom the system ends has not") {
  const Scratch scratch;
  const fs::path folder = fs::path(scratch / "state") / "autosave";
  {
    FakeDesk desk;
    Player player(options_in(scratch), desk);
    open(player, de_boor);
    REQUIRE(move(player, 3, 47, 11));
    player.keep();
    CHECK_FALSE(fs::is_empty(folder));
    player.quit();
  }
  CHECK(fs::is_empty(folder));
  {
    FakeDesk desk;
    Player player(options_in(scratch), desk);
    open(player, de_boor);
    REQUIRE(move(player, 3, 47, 11));
  }
  CHECK_FALSE(fs::is_empty(folder));
}

TEST_CASE("Where one was, one's bookmarks and settings are there the next time") {
  const Scratch scratch;
  {
    FakeDesk desk;
    Player player(options_in(scratch), desk);
    open(player, de_boor);
    player.seek(5);
    perform(player, "step.bookmark");
    player.seek(7);
    perform(player, "view.next_theme");
    perform(player, "view.larger");
    perform(player, "step.faster");
  }
  FakeDesk desk;
  Player player(options_in(scratch), desk);
  CHECK(player.settings.theme == "dark");
  CHECK(player.settings.text_scale > 1);
  CHECK(player.settings.speed > 1);
  REQUIRE(player.settings.recent.size() == 1);
  open(player, de_boor);
  CHECK(state(player, "step") == "7");
  CHECK(state(player, "bookmarks") == "5");
  CHECK_FALSE(player.notice().empty());
  // At its end a lesson begins anew.
  player.seek(player.session()->last());
  open(player, "tests/play/data/11-de-casteljau.json");
  open(player, de_boor);
  CHECK(state(player, "step") == "0");
}

// ---- time and motion ------------------------------------------------------------------------------------------------

TEST_CASE("A step moves for a moment, another one interrupts it, and motion can be switched off") {
  World world;
  Player& player = world.player();
  open(player, de_boor);
  player.seek(4);
  CHECK(player.motion() == 0);
  CHECK(player.animating());
  player.advance(0.2);
  CHECK((player.motion() > 0 && player.motion() < 1));
  player.seek(5);
  CHECK(player.motion() == 0);
  let_pass(player, 1);
  CHECK(player.motion() == 1);
  CHECK_FALSE(player.animating());
  player.settings.reduced_motion = true;
  player.seek(6);
  CHECK(player.motion() == 1);
  CHECK_FALSE(player.animating());
}

TEST_CASE("Playing goes on at the speed that is set, and stops at the end") {
  World world;
  Player& player = world.player();
  open(player, de_boor);
  player.settings.speed = 2;
  perform(player, "step.play");
  let_pass(player, 3.05);
  CHECK(player.session()->step() == 6);
  player.settings.speed = 10;
  let_pass(player, 10);
  CHECK(player.session()->step() == player.session()->last());
  CHECK_FALSE(player.session()->timeline().playing());
}

TEST_CASE("A notice goes away by itself, and only that is a reason to draw") {
  World world;
  Player& player = world.player();
  open(player, "tests/play/data/11-de-casteljau.json");
  player.notice("Look here.");
  CHECK_FALSE(player.advance(4.9));
  CHECK(player.notice() == "Look here.");
  CHECK(player.advance(0.2));
  CHECK(player.notice().empty());
  for (int i = 0; i < 100; ++i) CHECK_FALSE(player.advance(0.1));
}

TEST_CASE("What one points at is lit, with its ancestors by their shares, which are 1 together") {
  World world;
  Player& player = world.player();
  open(player, de_boor);
  go_to(player, "P[3][4]");
  player.hover(link_to(player, "P[3][4]"));
  const Emphasis& emphasis = player.emphasis();
  CHECK(emphasis.lights(link_to(player, "P[3][4]").id));
  const auto& inputs_shares = emphasis.shares;
  double sum = 0;
  for (const auto& [v, share] : inputs_shares)
    if (player.session()->recording().graph().is_input(v) &&
        player.session()->recording().graph().name(v).starts_with("P[0]"))
      sum += share;
  CHECK(sum == Approx(1));
  CHECK(state(player, "hovered") == "P[3][4]");
  player.hover({});
  CHECK(player.emphasis().shares.empty());
}

TEST_CASE("The value of a step goes to the clipboard, and the scheme as LaTeX") {
  World world;
  Player& player = world.player();
  open(player, de_boor);
  go_to(player, "P[1][3]");
  REQUIRE(perform(player, "file.copy_value"));
  CHECK(world.desk.text == state(player, "value P[1][3]"));
  REQUIRE(perform(player, "file.copy_tableau"));
  CHECK(world.desk.text.find("\\begin{array}") != std::string::npos);
}

TEST_CASE("Every action can be asked for at every moment without harm") {
  World world;
  Player& player = world.player();
  const auto try_all = [&] {
    for (const ActionGroup* group : ordered_action_groups())
      for (const Action& action : group->actions) {
        INFO(action.id);
        if (action.checked != nullptr) action.checked(player);
        perform(player, action.id);
        player.dialog = Dialog::none;
      }
  };
  try_all();
  for (const auto& file : {de_boor, fs::path("lessons/67-skinning.json"), fs::path("exercises/21-spans.json"),
                           fs::path("lessons/29-subdivision.json")}) {
    open(player, file);
    player.seek(player.session()->last() / 2);
    try_all();
  }
}
