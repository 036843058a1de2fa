// The studio in the player: opened, saved, stepped, recovered.
#include <sys/wait.h>
#include <unistd.h>

#include "player/action.hpp"
#include "player/doing.hpp"
#include "studio/scene_file.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

const fs::path vase = "lessons/scenes/vase.json";

// A process that is gone.
pid_t gone() {
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) _exit(0);
  REQUIRE(waitpid(child, nullptr, 0) == child);
  return child;
}

void pull(Player& player) {
  player.studio()->select({{0, 0}});
  REQUIRE(player.studio()->move_by(Point<Exact>(Exact(1), Exact(0), Exact(0))));
}

}  // namespace

TEST_CASE("A scene opens in the studio, a lesson opens over nothing of it") {
  World world;
  Player& player = world.player();
  open(player, vase);
  CHECK(player.in_studio());
  CHECK(state(player, "studio") == "yes");
  CHECK(state(player, "open") == "no");
  CHECK(state(player, "objects") == "profile, vase");
  CHECK(player.settings.recent.front().filename() == "vase.json");
  open(player, de_boor);
  CHECK(player.studio() == nullptr);
}

TEST_CASE("What was made is stepped by its recipe, and the scene is there again") {
  World world;
  Player& player = world.player();
  open(player, vase);
  player.studio()->choose(1);
  player.tab = "show";
  REQUIRE(perform(player, "studio.step"));
  REQUIRE(player.session() != nullptr);
  CHECK(player.session()->algorithm().id == "revolution");
  CHECK(state(player, "studio") == "behind");
  CHECK(state(player, "title") == "vase: " + std::string(player.session()->algorithm().title));
  player.seek(player.session()->last());
  // What the run makes is what stands in the scene.
  const Geometry& made = player.studio()->workspace().objects[1].geometry;
  const auto* result = std::get_if<Surface<double>>(&player.session()->recording().source().outcome);
  REQUIRE(result != nullptr);
  REQUIRE(std::holds_alternative<Surface<Exact>>(made));
  CHECK(result->points.size() == std::get<Surface<Exact>>(made).points.size());
  REQUIRE(perform(player, "studio.back"));
  CHECK(player.in_studio());
  CHECK(player.tab == "show");
  CHECK(state(player, "current") == "vase");
}

TEST_CASE("What is given is stepped by an algorithm that is asked for") {
  World world;
  Player& player = world.player();
  open(player, vase);
  player.studio()->choose(0);
  REQUIRE(perform(player, "studio.step"));
  CHECK(player.dialog == Dialog::step_with);
  const auto fitting = algorithms_for(player.studio()->workspace(), {0});
  REQUIRE(fitting.size() > 3);
  std::size_t stepped = 0;
  for (const Algorithm* algorithm : fitting) {
    INFO(algorithm->id);
    if (!player.step_with(*algorithm)) {
      // Knots are split where there is one, and not in the middle of the domain.
      CHECK_FALSE(player.problems().list.empty());
      CHECK(player.in_studio());
      continue;
    }
    ++stepped;
    CHECK(&player.session()->algorithm() == algorithm);
    player.back_to_studio();
    REQUIRE(player.in_studio());
  }
  CHECK(2 * stepped > fitting.size());
}

TEST_CASE("Edits of what is stepped are asked about on the way back, those of the scene are not") {
  World world;
  Player& player = world.player();
  open(player, vase);
  pull(player);
  REQUIRE(player.step_made(1));
  player.back_to_studio();
  CHECK(player.in_studio());
  player.unless_unsaved([](Player& p) { p.close(); });
  CHECK(player.dialog == Dialog::unsaved);
  CHECK(player.asks_about_scene());
  proceed_after_unsaved(player);
  CHECK(player.studio() == nullptr);
}

TEST_CASE("A scene is saved under its name, and what is read is the same") {
  World world;
  Player& player = world.player();
  player.new_scene();
  REQUIRE(player.in_studio());
  REQUIRE(player.studio()->add_curve(
      CurveKind::bezier, 3, 2,
      {Point<Exact>(Exact(0), Exact(0), Exact(0)), Point<Exact>(Exact(1), Exact(2), Exact(0))}));
  CHECK(state(player, "unsaved") == "yes");
  REQUIRE(perform(player, "file.save_scene"));
  CHECK(player.dialog == Dialog::save_scene);
  const fs::path file = world.scratch / "mine.json";
  player.save_scene(file, "Mine");
  CHECK(state(player, "unsaved") == "no");
  CHECK(player.dialog == Dialog::none);
  const auto read = load_scene(file);
  INFO(to_string(read.diagnostics));
  REQUIRE(read);
  CHECK(read->title == "Mine");
  CHECK(*read == player.studio()->workspace());
  pull(player);
  REQUIRE(perform(player, "file.save_scene"));  // now without a question
  CHECK(*load_scene(file) == player.studio()->workspace());
}

TEST_CASE("A scene that is changed on disk is loaded again, and undo leads back") {
  World world(true);
  Player& player = world.player();
  const fs::path file = world.scratch / "vase.json";
  REQUIRE(write_file(file, text_of(vase)));
  open(player, file);
  REQUIRE(write_file(file, replaced(text_of(vase), "\"A vase\"", "\"A jug\"")));
  let_pass(player, 2);
  CHECK(state(player, "title") == "A jug");
  CHECK(state(player, "unsaved") == "no");
  REQUIRE(perform(player, "edit.undo"));
  CHECK(state(player, "title") == "A vase");
}

TEST_CASE("What a crash left of a scene comes back, with the file below it") {
  World world;
  {
    Player player(options_in(world.scratch), world.desk);
    REQUIRE(player.open(fs::absolute(vase)));
    pull(player);
    player.keep();
    for (const auto& entry : fs::directory_iterator(fs::path(world.scratch / "state") / "autosave"))
      fs::copy_file(entry.path(), entry.path().parent_path() / (std::to_string(gone()) + "-0.json"));
    player.quit();
  }
  Player player(options_in(world.scratch), world.desk);
  REQUIRE(player.lost_work().size() == 1);
  player.recover(0);
  INFO(to_string(player.problems().list));
  REQUIRE(player.in_studio());
  CHECK(state(player, "unsaved") == "yes");
  CHECK(state(player, "point profile 0") == "2 0 0");
  REQUIRE(perform(player, "edit.undo"));
  CHECK(state(player, "unsaved") == "no");
  CHECK(player.lost_work().empty());
}

TEST_CASE("A surface and a curve become things of the scene one works on") {
  World world;
  Player& player = world.player();
  const auto curve = world.scratch.write("arc.json", R"({"degree": 2, "points": [[0, 0], [1, 1], [2, 0]]})");
  player.new_scene();
  player.open_asking(curve);
  REQUIRE(player.in_studio());
  CHECK(state(player, "objects") == "arc");
  player.open_asking(curve);
  CHECK(state(player, "objects") == "arc, arc 2");
}

TEST_CASE("Every action of the studio can be asked for at every moment, and a key means one thing in each place") {
  World world;
  Player& player = world.player();
  const auto try_all = [&] {
    for (const ActionGroup* group : ordered_action_groups())
      for (const Action& action : group->actions) {
        INFO(action.id);
        if (action.id == "file.quit" || action.id == "file.new_scene" || action.id == "file.start") continue;
        if (action.checked != nullptr) action.checked(player);
        perform(player, action.id);
        player.dialog = Dialog::none;
      }
  };
  player.new_scene();
  try_all();
  // Copies: one of the actions is to save.
  const fs::path copies = world.scratch / "scenes";
  fs::copy("lessons/scenes", copies);
  for (const auto& item : fs::directory_iterator(copies)) {
    INFO(item.path());
    player.unless_unsaved([&](Player& p) { p.open(item.path()); });
    if (player.dialog == Dialog::unsaved) proceed_after_unsaved(player);
    for (std::size_t i = 0; player.studio() != nullptr && i < 2; ++i) {
      player.back_to_studio();
      player.studio()->choose(i);
      try_all();
    }
  }
  for (const char* place : {"lesson", "studio"}) {
    if (std::string(place) == "lesson")
      open(player, de_boor);
    else
      player.new_scene(), proceed_after_unsaved(player);
    std::vector<std::string_view> keys;
    for (const ActionGroup* group : ordered_action_groups())
      for (const Action* action : actions_here(player, *group))
        for (const std::string_view key : action->keys) {
          INFO(place << " " << key << " " << action->id);
          CHECK(std::ranges::find(keys, key) == keys.end());
          keys.push_back(key);
        }
  }
}
