#include "player/history.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace blossom;

TEST_CASE("undo goes back one state at a time to the first, redo forward to the last") {
  History<int> history(0);
  CHECK_FALSE(history.can_undo());
  CHECK_FALSE(history.undo());
  history.push(1, "one");
  history.push(2, "two");
  CHECK(history.current() == 2);
  CHECK(history.undo_what() == "two");
  CHECK(history.undo());
  CHECK(history.current() == 1);
  CHECK(history.undo_what() == "one");
  CHECK(history.redo_what() == "two");
  CHECK(history.undo());
  CHECK(history.current() == 0);
  CHECK(history.undo_what().empty());
  CHECK_FALSE(history.undo());
  CHECK(history.redo());
  CHECK(history.redo());
  CHECK_FALSE(history.redo());
  CHECK(history.current() == 2);
}

TEST_CASE("what is new after an undo takes the place of what was undone") {
  History<int> history(0);
  history.push(1, "one");
  history.push(2, "two");
  history.undo();
  history.undo();
  history.push(3, "three");
  CHECK_FALSE(history.can_redo());
  CHECK(history.size() == 2);
  CHECK(history.undo());
  CHECK(history.current() == 0);
}

TEST_CASE("a gesture is one state, until it ends") {
  History<int> history(0);
  for (const int x : {1, 2, 3}) history.push(x, "drag", "P1");
  CHECK(history.size() == 2);
  CHECK(history.current() == 3);
  for (const int x : {4, 5}) history.push(x, "drag", "P2");  // another gesture
  CHECK(history.size() == 3);
  history.end_gesture();
  history.push(6, "drag", "P2");  // the same point again, but later
  CHECK(history.size() == 4);
  history.push(7, "type");
  history.push(8, "type");  // no gestures: each is a state
  CHECK(history.size() == 6);
  for (const int x : {7, 6, 5, 3, 0}) {
    CHECK(history.undo());
    CHECK(history.current() == x);
  }
}

TEST_CASE("a gesture that goes on after an undo begins a new state") {
  History<int> history(0);
  history.push(1, "drag", "P1");
  history.undo();
  history.redo();
  history.push(2, "drag", "P1");
  CHECK(history.size() == 3);
  CHECK(history.undo());
  CHECK(history.current() == 1);
}

TEST_CASE("any walk through a history shows what a list of all states shows") {
  const unsigned seed = 20240611;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  History<int> history(0);
  std::vector<int> states{0};
  std::size_t at = 0;
  for (int i = 1; i < 2000; ++i) {
    switch (random() % 3) {
      case 0:
        history.push(i, std::to_string(i));
        states.resize(++at);
        states.push_back(i);
        break;
      case 1:
        CHECK(history.undo() == (at > 0));
        at -= at > 0 ? 1 : 0;
        break;
      default:
        CHECK(history.redo() == (at + 1 < states.size()));
        at += at + 1 < states.size() ? 1 : 0;
    }
    REQUIRE(history.current() == states[at]);
    REQUIRE(history.size() == states.size());
    REQUIRE(history.undo_what() == (at > 0 ? std::to_string(states[at]) : ""));
  }
}
