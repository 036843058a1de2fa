// The application while somebody predicts: what one is asked, how an answer is given, what must not be lost.
#include "player/action.hpp"
#include "player/doing.hpp"

using namespace blossom;
using namespace blossom::test;

TEST_CASE("While one predicts, no move goes beyond the open question") {
  World world;
  Player& player = world.player();
  open(player, "exercises/22-de-boor.json");
  const Prediction& prediction = *player.session()->prediction();
  const std::uint32_t before = prediction.questions()[0].step - 1;
  for (const char* action : {"step.last", "step.forward", "step.over", "step.out", "step.next_mark"}) {
    for (int i = 0; i < 80; ++i) perform(player, action);
    INFO(action);
    CHECK(player.session()->step() <= before);
  }
  player.seek(player.session()->last());
  CHECK(player.session()->step() == before);
  CHECK(player.tab == "predict");
  CHECK_FALSE(player.notice().empty());
  player.session()->move([](Timeline& t) { return t.play(), true; });
  let_pass(player, 5);
  CHECK(player.session()->step() == before);
  CHECK_FALSE(player.session()->timeline().playing());
}

TEST_CASE("An answer is typed, refused while it has not the right shape, and taken") {
  World world;
  Player& player = world.player();
  open(player, "exercises/22-de-boor.json");
  const auto question = player.asked();
  REQUIRE(question == std::size_t{0});
  player.set_draft(0, "two fifths");
  player.submit_draft();
  CHECK_FALSE(player.draft().problem.empty());
  CHECK(player.asked() == question);
  player.set_draft(0, "1");
  CHECK(player.draft().problem.empty());  // typing on, one is no longer told off

  const Prediction& prediction = *player.session()->prediction();
  const AskedValue& asked = prediction.questions()[*question];
  const auto& right = prediction.exercise().parts[asked.part].right;
  for (std::size_t i = 0; i < right.size(); ++i) player.set_draft(i, right[i].to_string());
  player.submit_draft();
  REQUIRE(prediction.attempt(*question));
  CHECK(player.asked() == std::size_t{1});
  CHECK(player.draft().numbers.empty());
  if (prediction.marking() == Marking::at_once) CHECK(player.session()->step() == asked.step);
  // Undo is the answers' now.
  REQUIRE(perform(player, "edit.undo"));
  CHECK(player.asked() == question);
  CHECK(prediction.undos() == 1);
}

TEST_CASE("Show me shows the chosen question, and a lesson goes on to its step") {
  World world;
  Player& player = world.player();
  open(player, "exercises/22-de-boor.json");
  const Prediction& exercise = *player.session()->prediction();
  const std::size_t last = exercise.questions().size() - 1;
  player.choose_question(last);
  player.show_me();
  REQUIRE(exercise.attempt(last));
  CHECK(exercise.attempt(last)->shown);
  CHECK_FALSE(exercise.attempt(0));
  CHECK(player.last_said() == last);
  CHECK(player.asked() == std::size_t{0});
  CHECK(player.session()->step() == 0);

  open(player, de_boor);
  player.start_predicting();
  player.show_me();
  CHECK(player.session()->step() == player.session()->prediction()->questions()[0].step);
}

TEST_CASE("Answers are lost, and open questions given up, only after one was asked") {
  World world;
  Player& player = world.player();
  open(player, "exercises/22-de-boor.json");
  player.set_draft(0, "4");
  player.submit_draft();
  player.stop_predicting();
  CHECK(player.doubt() == Player::Doubt::stop);
  player.resolve_doubt(false);
  REQUIRE(player.session()->prediction() != nullptr);
  CHECK(player.session()->prediction()->answered() == 1);
  player.finish_predicting();
  CHECK_FALSE(player.session()->prediction()->finished());
  player.resolve_doubt(true);
  CHECK(player.session()->prediction()->finished());
  CHECK_FALSE(player.asked());
  player.stop_predicting();
  player.resolve_doubt(true);
  CHECK(player.session()->prediction() == nullptr);
  player.start_predicting();
  player.stop_predicting();  // nothing is lost
  CHECK(player.session()->prediction() == nullptr);
}

TEST_CASE("A pair that is typed into one field fills both, and an answer is seen again where its question is") {
  World world;
  Player& player = world.player();
  open(player, "exercises/22-de-boor.json");
  const Prediction& prediction = *player.session()->prediction();
  const auto point = static_cast<std::size_t>(std::ranges::find(prediction.questions(), "P[1][3]", &AskedValue::name) -
                                              prediction.questions().begin());
  player.choose_question(point);
  player.set_draft(0, "(16, 20)");
  CHECK(player.draft().numbers == std::vector<std::string>{"16", "20"});
  player.submit_draft();
  player.choose_question(point);
  player.set_draft(1, "21");
  CHECK(player.draft().numbers == std::vector<std::string>{"16", "21"});
}

TEST_CASE("An edit ends the prediction: its questions were about other numbers") {
  World world;
  Player& player = world.player();
  open(player, de_boor);
  REQUIRE(perform(player, "predict.toggle"));
  CHECK(state(player, "predicting") == "yes");
  REQUIRE(move(player, 3, 40, 20));
  CHECK(state(player, "predicting") == "no");
}
