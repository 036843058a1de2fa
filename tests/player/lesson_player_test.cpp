// What a lesson adds to a run: scenes, languages, cameras, pauses, sliders, and questions that one is kept at.
#include <catch2/catch.hpp>

#include "player/action.hpp"
#include "player/doing.hpp"
#include "scene/beat_look.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

const fs::path questions = "tests/play/data/questions.json";

void forward(Player& player) {
  player.move([](Timeline& t) { return t.forward(); });
}

void open_scene(Player& player, std::size_t scene) {
  open(player, questions);
  player.show_scene(scene);
  REQUIRE(player.scene() == scene);
}

}  // namespace

// ---- scenes ---------------------------------------------------------------------------------------------------------

TEST_CASE("A lesson of several scenes is shown one after the other") {
  World world;
  Player& player = world.player();
  open(player, questions);
  CHECK(player.scene_count() == 3);
  CHECK(state(player, "scene") == "1 of 3");
  CHECK(player.scene_heading(0) == "Divide the legs");
  CHECK_FALSE(perform(player, "lesson.previous_scene"));
  CHECK(perform(player, "lesson.next_scene"));
  CHECK(state(player, "heading") == "Find the span");
  CHECK(player.session()->algorithm().id == "de_boor");
  CHECK(perform(player, "lesson.next_scene"));
  CHECK_FALSE(perform(player, "lesson.next_scene"));
  CHECK(player.scene() == 2);
  player.show_scene(7);
  CHECK(player.scene() == 2);
}

TEST_CASE("What one edits in a scene stays while one is in another, and all of it is saved") {
  World world;
  Player& player = world.player();
  open(player, questions);
  REQUIRE(set_u(player, Exact::ratio(1, 3)));
  player.show_scene(1);
  CHECK_FALSE(player.session()->unsaved());
  CHECK(player.unsaved());
  REQUIRE(set_u(player, Exact::ratio(5, 2)));
  player.show_scene(0);
  CHECK(player.session()->inputs().number("u") == Exact::ratio(1, 3));
  CHECK(player.session()->history().can_undo());

  const fs::path saved = world.scratch / "saved.json";
  player.save_lesson(saved, "saved", "Saved");
  INFO(to_string(player.problems().list));
  CHECK_FALSE(player.unsaved());
  const auto document = open_document(saved);
  INFO(to_string(document.diagnostics));
  REQUIRE(document);
  REQUIRE(document->lesson->scene_count() == 3);
  CHECK(document->lesson->scene_at(0).inputs.number("u") == Exact::ratio(1, 3));
  CHECK(document->lesson->scene_at(1).inputs.number("u") == Exact::ratio(5, 2));
  CHECK(document->lesson->scene_at(2).inputs == player.session()->document().lesson->scene_at(2).inputs);
  CHECK(document->lesson->scene_at(1).heading.in("de") == "Das Intervall finden");
  CHECK(document->lesson->scene_at(1).beats.size() == 3);
}

TEST_CASE("Where one was is remembered for each scene, with what one has answered") {
  World world;
  {
    Player& player = world.player();
    open(player, questions);
    player.skip_checkpoint();
    CHECK(state(player, "step") == "1");
    player.show_scene(1);
    player.checkpoints().type({"3"});
    player.submit_checkpoint();
    CHECK(state(player, "checkpoints") == "why=skipped second=open order=open which=right line=open");
    forward(player);
    player.show_scene(2);
    forward(player);
    player.show_scene(1);
    player.keep();
  }
  Player player(options_in(world.scratch), world.desk);
  open(player, questions);
  CHECK(state(player, "scene") == "2 of 3");
  CHECK(state(player, "step") == "1");
  CHECK(state(player, "checkpoints") == "why=skipped second=open order=open which=right line=open");
  const Progress* known = player.progress(fs::absolute(questions));
  REQUIRE(known != nullptr);
  CHECK(known->scene_count == 3);
  CHECK(known->scenes.at("divide").furthest == 1);
  CHECK(known->asked == 5);
  CHECK(known->right == 1);
  CHECK(known->share() > 0);
  CHECK(known->share() < 1);
}

TEST_CASE("A lesson that changes on disk goes on in the same scene, and keeps the answers") {
  World world(true);
  Player& player = world.player();
  const std::string file = world.scratch.write("mine.json", text_of(questions));
  open(player, file);
  player.checkpoints().choose(0);
  player.submit_checkpoint();
  player.show_scene(1);
  player.skip_checkpoint();
  REQUIRE(state(player, "step") == "1");
  let_pass(player, 2.5);
  // A scene more before it: it is found again by its id.
  std::string text = text_of(questions);
  const auto from = text.find("    {\n      \"id\": \"move\"");
  const auto to = text.find("\n  ]\n}", from);
  const std::string move = text.substr(from, to - from);
  text.erase(text.find_last_of(',', from), to - text.find_last_of(',', from));
  const auto second = text.find("    {\n      \"id\": \"span\"");
  text.insert(second, move + ",\n");
  world.scratch.write("mine.json", text);
  let_pass(player, 2.5);
  INFO(to_string(player.problems().list));
  CHECK(state(player, "scene") == "3 of 3");
  CHECK(state(player, "heading") == "Find the span");
  CHECK(state(player, "step") == "1");
  CHECK(state(player, "checkpoints").find("why=right") != std::string::npos);
  CHECK(state(player, "checkpoints").find("which=skipped") != std::string::npos);

  // Mistakes are shown beside the last good version.
  world.scratch.write("mine.json", replaced(text, "\"kind\": \"span\"", "\"kind\": \"spam\""));
  let_pass(player, 2.5);
  REQUIRE_FALSE(player.problems().list.empty());
  CHECK(player.problems().list[0].line > 0);
  CHECK(state(player, "heading") == "Find the span");
}

// ---- languages ------------------------------------------------------------------------------------------------------

TEST_CASE("Words are in the language one reads, and in the lesson's own where it has no other") {
  World world;
  Player& player = world.player();
  open(player, questions);
  CHECK(player.languages() == std::vector<std::string>{"en", "de"});
  CHECK(state(player, "narration").starts_with("Three points"));
  CHECK(perform(player, "lesson.language"));
  CHECK(player.settings.language == "de");
  CHECK(state(player, "narration").starts_with("Drei Punkte"));
  CHECK(player.title() == "Ein Punkt auf drei Wegen");
  CHECK(player.scene_heading(1) == "Das Intervall finden");
  CHECK(player.beat_text(player.checkpoints().item(0).checkpoint.ask) == "Wo wird der Punkt der Kurve liegen?");
  player.show_scene(1);
  CHECK(state(player, "narration").starts_with("Drei Stücke"));
  CHECK(perform(player, "lesson.language"));
  CHECK(state(player, "narration").starts_with("Three pieces"));
  player.settings.language = "fr";
  player.settle();
  CHECK(state(player, "narration").starts_with("Three pieces"));
}

// ---- cameras and pauses ---------------------------------------------------------------------------------------------

TEST_CASE("The camera of a beat holds until another beat has one; one's own holds until then") {
  World world;
  Player& player = world.player();
  player.settings.reduced_motion = true;
  open_scene(player, 2);
  const auto wanted = [&](std::uint32_t step) {
    const Recording& recording = player.session()->recording();
    return camera_of(*camera_in_force(player.session()->beats(), step), recording.scenes(), recording.source(),
                     player.view_size().width, player.view_size().height);
  };
  CHECK(player.shown_camera() == wanted(0));
  forward(player);
  CHECK(player.shown_camera() == wanted(0));
  player.set_view_size({400, 400});
  CHECK(player.shown_camera() == wanted(0));

  Camera own = player.shown_camera();
  own.height *= 3;
  player.set_camera(own);
  player.set_view_size({500, 400});
  CHECK(player.shown_camera() == own);
  forward(player);
  CHECK(player.shown_camera() == own);
  const std::uint32_t last = player.session()->last();
  player.seek(last);
  CHECK(player.shown_camera() == wanted(last));
  CHECK_FALSE(player.shown_camera() == own);
  // Back: the camera that was in force there.
  player.seek(1);
  CHECK(player.shown_camera() == wanted(0));
}

TEST_CASE("Without reduced motion one is taken to the camera of a beat, and arrives") {
  World world;
  Player& player = world.player();
  open_scene(player, 2);
  let_pass(player, 1);
  const Camera before = player.shown_camera();
  player.seek(player.session()->last());
  CHECK(player.animating());
  let_pass(player, 1);
  CHECK_FALSE(player.animating());
  CHECK_FALSE(player.shown_camera() == before);
}

TEST_CASE("Playing stops where a beat waits, and stays longer where it says so") {
  World world;
  Player& player = world.player();
  open_scene(player, 2);
  player.settings.speed = 10;
  REQUIRE(perform(player, "step.play"));
  let_pass(player, 3);
  CHECK(state(player, "step") == "1");
  CHECK(state(player, "playing") == "no");
  CHECK(player.waits_here());
  REQUIRE(perform(player, "step.play"));
  CHECK_FALSE(player.waits_here());
  let_pass(player, 1);
  CHECK(state(player, "step") == "2");
  CHECK(state(player, "playing") == "yes");
  let_pass(player, 3);
  CHECK(player.session()->step() > 2);
}

// ---- sliders --------------------------------------------------------------------------------------------------------

TEST_CASE("A slider edits the number at its path, one gesture being one state") {
  World world;
  Player& player = world.player();
  open_scene(player, 2);
  forward(player);
  REQUIRE(player.sliders().size() == 3);
  for (int i = 2; i <= 6; ++i) player.slide(0, Exact::ratio(i, 8));
  player.end_slide();
  CHECK(state(player, "u") == "\"3/4\"");
  CHECK(state(player, "undo") == "u moved");
  // What the beat says is meant for the numbers that it lets one choose.
  CHECK(state(player, "narration").find("now u is 3/4") != std::string::npos);
  player.slide(1, Exact(6));
  CHECK(number_at(player.session()->inputs(), "curve.points[1][0]") == Exact(6));
  CHECK(number_at(player.session()->inputs(), "curve.points[1][1]") == Exact(8));
  player.end_slide();
  REQUIRE(perform(player, "edit.undo"));
  REQUIRE(perform(player, "edit.undo"));
  CHECK_FALSE(player.session()->edited());
  CHECK_FALSE(perform(player, "edit.undo"));
}

TEST_CASE("A slider stays within its range, and goes by its steps") {
  World world;
  Player& player = world.player();
  open_scene(player, 2);
  forward(player);
  player.slide(0, Exact(5));
  CHECK(number_at(player.session()->inputs(), "u") == Exact(1));
  player.slide_by(0, -3);
  CHECK(state(player, "u") == "\"5/8\"");
  player.slide_by(0, -99);
  CHECK(number_at(player.session()->inputs(), "u") == Exact(0));
  player.slide(9, Exact(1));  // there is none
}

TEST_CASE("A slider that is refused says why, and nothing moves") {
  World world;
  Player& player = world.player();
  open_scene(player, 1);
  go_to(player, "s");
  player.session()->seek(2);
  REQUIRE(player.sliders().size() == 2);
  player.slide(0, Exact(2));
  player.end_slide();
  const auto before = player.session()->inputs();
  player.slide(1, Exact(1));  // below the knot before it
  CHECK(player.slide_refused().slider == 1);
  CHECK_FALSE(player.slide_refused().why.empty());
  CHECK(player.session()->inputs() == before);
  player.slide(1, Exact::ratio(5, 2));
  CHECK(player.slide_refused().why.empty());
  CHECK(number_at(player.session()->inputs(), "curve.knots[4]") == Exact::ratio(5, 2));
}

TEST_CASE("Numbers of inputs are found and set by their paths, in every kind of input") {
  for (const auto& [file, path, to] : {std::tuple("tests/play/data/22-de-boor.json", "curve.knots[4]", "1/3"),
                                       std::tuple("tests/play/data/22-de-boor.json", "u", "0.6"),
                                       std::tuple("tests/play/data/22-de-boor.json", "curve.points[2][1]", "-3/7"),
                                       std::tuple("lessons/40-rational-quarter-circle.json", "curve.weights[1]", "3/4"),
                                       std::tuple("lessons/71-interpolation.json", "points[1][0]", "1/2")}) {
    INFO(file << " " << path);
    const auto document = open_document(file);
    INFO(to_string(document.diagnostics));
    REQUIRE(document);
    REQUIRE(number_at(document->inputs, path));
    const auto edited = set_number_at(*document->algorithm, document->inputs, path, *Exact::parse(to));
    INFO(to_string(edited.diagnostics));
    REQUIRE(edited);
    CHECK(number_at(*edited, path) == Exact::parse(to));
  }
  const auto document = open_document("tests/play/data/22-de-boor.json");
  for (const char* path : {"", "v", "curve", "curve.points", "curve.points[9][0]", "curve.points[1", "curve.knots[x]",
                           "curve.knots[4].x", "u[0]", "u.", "curve..knots[4]"}) {
    INFO(path);
    CHECK_FALSE(number_at(document->inputs, path));
    CHECK_FALSE(set_number_at(*document->algorithm, document->inputs, path, Exact(1)));
  }
  // A knot out of order is refused, and says where.
  const auto refused = set_number_at(*document->algorithm, document->inputs, "curve.knots[4]", Exact(7));
  REQUIRE_FALSE(refused);
  CHECK(refused.diagnostics[0].path.starts_with("curve.knots"));
}

// ---- questions ------------------------------------------------------------------------------------------------------

TEST_CASE("No step behind an open question is shown without asking, and one can always go on") {
  World world;
  Player& player = world.player();
  open(player, questions);
  CHECK(player.tab == "checkpoint");
  CHECK(state(player, "checkpoint") == "why");
  forward(player);
  CHECK(state(player, "step") == "0");
  CHECK(state(player, "skips") == "yes");
  forward(player);  // a key that repeats by itself does not skip it
  CHECK(state(player, "step") == "0");
  let_pass(player, 0.5);
  forward(player);
  CHECK(state(player, "step") == "1");
  CHECK(state(player, "checkpoints").starts_with("why=skipped second=open"));

  // From afar one comes as far as the question.
  player.seek(player.session()->last());
  CHECK(state(player, "step") == "1");
  player.stay_at_checkpoint();
  CHECK(state(player, "skips") == "no");
  player.checkpoints().type({"5", "6"});
  player.submit_checkpoint();
  CHECK(state(player, "checkpoints").starts_with("why=skipped second=right"));
  player.seek(player.session()->last());
  CHECK(state(player, "step") == "2");
  CHECK(state(player, "checkpoint") == "order");
  player.seek(0);
  CHECK(state(player, "step") == "0");
  // What was skipped can be answered.
  player.checkpoint_key("A");
  player.checkpoint_key("Enter");
  CHECK(state(player, "checkpoints").starts_with("why=right second=right"));
}

TEST_CASE("Playing stops at an open question, and the mouse on the timeline skips none") {
  World world;
  Player& player = world.player();
  open(player, questions);
  player.skip_checkpoint();
  REQUIRE(state(player, "step") == "1");
  REQUIRE(perform(player, "step.play"));
  let_pass(player, 3);
  CHECK(state(player, "step") == "1");
  CHECK(state(player, "playing") == "no");
  for (int i = 0; i < 5; ++i) {
    player.scrub(3);
    let_pass(player, 0.5);
  }
  CHECK(state(player, "step") == "1");
  CHECK(state(player, "skips") == "yes");
}

TEST_CASE("Where the numbers were changed nothing is asked of them, and nobody is kept") {
  World world;
  Player& player = world.player();
  open(player, questions);
  REQUIRE(set_u(player, Exact::ratio(1, 3)));
  CHECK_FALSE(player.wants_checkpoint_key("A"));
  forward(player);
  CHECK(state(player, "step") == "1");
  REQUIRE(perform(player, "edit.revert"));
  CHECK(player.wants_checkpoint_key("Enter"));
}

TEST_CASE("A place that is clicked is typed, on the grid of the pixels") {
  World world;
  Player& player = world.player();
  open(player, questions);
  player.skip_checkpoint();
  REQUIRE(player.checkpoint_asks_place());
  player.checkpoint_click({5.0001, 5.9999, 0});
  REQUIRE(player.checkpoints().reply().numbers.size() == 2);
  CHECK(typed_number(player.checkpoints().reply().numbers[0])->to_double() == Approx(5).margin(0.05));
  CHECK(typed_number(player.checkpoints().reply().numbers[1])->to_double() == Approx(6).margin(0.05));
}

TEST_CASE("A click that is near enough is right, one far away is not, and what is typed counts as typed") {
  const auto answered = [](const auto& answer) {
    World world;
    Player& player = world.player();
    open(player, questions);
    player.skip_checkpoint();
    answer(player);
    player.submit_checkpoint();
    return state(player, "checkpoints").substr(0, 24);
  };
  CHECK(answered([](Player& p) { p.checkpoint_click({5.03, 5.96, 0}); }) == "why=skipped second=right");
  CHECK(answered([](Player& p) { p.checkpoint_click({5.6, 6.4, 0}); }) == "why=skipped second=wrong");
  CHECK(answered([](Player& p) { p.checkpoints().type({"5.03", "5.96"}); }) == "why=skipped second=wrong");
  CHECK(answered([](Player& p) {
          p.checkpoint_click({5.03, 5.96, 0});
          p.checkpoints().type(0, "7");
        }) == "why=skipped second=wrong");
}

TEST_CASE("Who tries again begins anew") {
  World world;
  Player& player = world.player();
  open(player, questions);
  player.skip_checkpoint();
  player.checkpoints().type({"1", "2"});
  player.submit_checkpoint();
  player.checkpoints().try_again();
  CHECK(player.checkpoints().takes());
  CHECK(player.checkpoints().reply().numbers.empty());
}

TEST_CASE("What only sliders moved is not asked about, other edits are") {
  World world;
  Player& player = world.player();
  open_scene(player, 2);
  forward(player);
  REQUIRE_FALSE(player.sliders().empty());
  player.slide(0, Exact::ratio(5, 8));
  player.end_slide();
  CHECK(player.unsaved());
  CHECK_FALSE(player.would_be_missed());
  bool went = false;
  player.unless_unsaved([&](Player&) { went = true; });
  CHECK(went);
  REQUIRE(player.edit(move_point(player.session()->algorithm(), player.session()->inputs(), {"curve", 0, 0},
                                 Point<Exact>(Exact(-3), Exact(-2), Exact(0))),
                      "move"));
  CHECK(player.would_be_missed());
}

TEST_CASE("At the end of a lesson its questions are summed up, and the answers can be saved") {
  World world;
  Player& player = world.player();
  open(player, questions);
  player.checkpoints().choose(0);
  player.submit_checkpoint();
  const fs::path file = world.scratch / "answers.json";
  player.save_checkpoints(file);
  CHECK(text_of(file) == player.checkpoints().answers_file());
  CHECK_FALSE(player.has_all_been_said());
  player.go_to_checkpoint(4);
  CHECK(state(player, "scene") == "2 of 3");
  CHECK(state(player, "checkpoint") == "which");  // which is open and comes before it
  player.show_scene(2);
  player.tab = "tableau";
  player.seek(player.session()->last());
  CHECK(player.has_all_been_said());
  CHECK(player.tab == "checkpoint");
}
