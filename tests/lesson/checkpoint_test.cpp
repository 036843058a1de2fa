// The questions that beats ask.

#include "lesson/checkpoint.hpp"

#include <algorithm>

#include "base/json_write.hpp"
#include "lesson_text.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

std::string asking(const std::string& at, const std::string& checkpoint) {
  return beat_with(at, "\"checkpoint\": {" + checkpoint + "}");
}

Checkpoint checkpoint_of(const std::string& at, const std::string& text, const std::string& run = parabola) {
  return *lesson_of(asking(at, text), run).beats.front().checkpoint;
}

}  // namespace

TEST_CASE("a checkpoint of each kind") {
  const auto predict = checkpoint_of(
      "\"start\"",
      R"("id": "p", "kind": "predict", "value": "P[1][1]", "decimals": 2, "points": 3, "ask": "Where is it at {u}?")");
  CHECK(predict.kind == Checkpoint::Kind::predict);
  CHECK(predict.value == "P[1][1]");
  CHECK(predict.decimals == 2);
  CHECK(predict.points == Exact(3));
  CHECK(predict.right.empty());

  const auto span = checkpoint_of("\"start\"", R"("id": "s", "kind": "span", "ask": "Which span?")", spline);
  CHECK(span.value == "k");  // without a key
  CHECK(span.points == Exact(1));

  const auto line = checkpoint_of("\"start\"", R"("id": "l", "kind": "line", "ask": "Which line?")");
  CHECK(line.line >= 1);
  CHECK(right_letters(line) == std::to_string(line.line));

  const auto choice = checkpoint_of("\"end\"", R"("id": "c", "kind": "choice", "ask": "Which?", "right": "Yes, {C}.",
    "choices": [{"text": "this", "feedback": "No."}, {"text": "that", "right": true}])");
  REQUIRE(choice.choices.size() == 2);
  CHECK(choice.choices[0].feedback == "No.");
  CHECK(right_letters(choice) == "b");

  const auto order =
      checkpoint_of("\"end\"", R"("id": "o", "kind": "order", "ask": "In order?", "items": ["1", "2", "3"])");
  CHECK(order.items.size() == 3);
  CHECK(right_letters(predict).empty());
}

TEST_CASE("an order is never shown as it is right, and its letters lead back to it") {
  Checkpoint checkpoint;
  checkpoint.kind = Checkpoint::Kind::order;
  for (const std::string id : {"a", "b", "order", "the-steps", "in-order-7", "x-1", "x-2", "x-3", "x-4", "x-5"})
    for (std::size_t count = 2; count <= 8; ++count) {
      checkpoint.id = id;
      checkpoint.items.assign(count, LocalText("item"));
      INFO(id << ", " << count);
      const auto shown = shown_order(checkpoint);
      CHECK(shown.size() == count);
      CHECK_FALSE(std::ranges::is_sorted(shown));
      auto sorted = shown;
      std::ranges::sort(sorted);
      for (std::size_t i = 0; i < count; ++i) CHECK(sorted[i] == i);
      CHECK(shown == shown_order(checkpoint));  // always the same
      // Reading the right letters, the items come in the right order.
      const std::string letters = right_letters(checkpoint);
      REQUIRE(letters.size() == count);
      for (std::size_t i = 0; i < count; ++i) CHECK(shown[static_cast<std::size_t>(letters[i] - 'a')] == i);
    }
}

TEST_CASE("which line comes next is that of the next step") {
  const auto lesson = lesson_of(asking("\"P[1][0]\"", R"("id": "l", "kind": "line", "ask": "Which?")"));
  const auto run = record<Exact>(*lesson.algorithm, lesson.inputs);
  CHECK(lesson.beats[0].checkpoint->line == Narrator<Exact>(*run).line(lesson.beats[0].step + 1));
}

TEST_CASE("every mistake of checkpoints, each at its line and column") {
  CHECK(
      mistakes(asking("\"start\"", R"("id": "No", "kind": "predict", "value": "P[3][0]", "decimals": 13,
"points": -1, "ask": "{P[1][0]}?", "choices": [])") +
               ",\n" + asking("\"P[1][1]\"", R"("id": "b", "kind": "predict", "value": "P[1][0]", "ask": " ")") +
               ",\n" + asking("\"P[2][0]\"", R"("id": "c", "kind": "choice", "ask": "?",
"choices": [{"text": "a"}, {"txt": "b"}, {"text": "c {u", "right": "yes"}])") +
               ",\n" + asking("\"end\"", R"("id": "d", "kind": "line", "ask": "?")")) ==
      "lesson.json:4:22: beats[0].checkpoint.id: must be 1 to 64 of a-z, 0-9 and -, such as \"de-boor-2\", not \"No\"\n"
      "lesson.json:4:56: beats[0].checkpoint.value: no value of this run is called \"P[3][0]\"; there are "
      "P[0][0..2], P[1][0..1], P[2][0]\n"
      "lesson.json:4:79: beats[0].checkpoint.decimals: must be a whole number from 0 to 12, not 13\n"
      "lesson.json:5:11: beats[0].checkpoint.points: must be from 0 to 1000\n"
      "lesson.json:5:22: beats[0].checkpoint.ask: \"{P[1][0]}\" names nothing at step 0: it is made at step 1\n"
      "lesson.json:5:36: beats[0].checkpoint: unknown key \"choices\"; the keys here are \"id\", \"kind\", \"ask\", "
      "\"points\", \"right\", \"wrong\", \"value\" and \"decimals\"\n"
      "lesson.json:7:55: beats[1].checkpoint.value: nobody can be asked for \"P[1][0]\" here: it is made at step 1 and "
      "this is step 2; ask at an earlier step\n"
      "lesson.json:7:73: beats[1].checkpoint.ask: must not be empty\n"
      "lesson.json:10:28: beats[2].checkpoint.choices[1]: missing key \"text\"\n"
      "lesson.json:10:29: beats[2].checkpoint.choices[1]: unknown key \"txt\"; did you mean \"text\"?\n"
      "lesson.json:10:51: beats[2].checkpoint.choices[2].text: a { has no } behind it, at \"{u\"\n"
      "lesson.json:10:68: beats[2].checkpoint.choices[2].right: must be true or false, not \"yes\"\n"
      "lesson.json:12:15: beats[3].checkpoint: nobody can be asked which line comes next: this is the last step\n");
  CHECK(mistakes(asking("\"start\"", R"("id": "a", "kind": "guess")") + ",\n" +
                 beat_with("\"P[1][0]\"", R"("checkpoint": "?")")) ==
        "lesson.json:4:35: beats[0].checkpoint.kind: must be \"predict\", \"span\", \"line\", \"order\" or \"choice\", "
        "not "
        "\"guess\"\n"
        "lesson.json:6:15: beats[1].checkpoint: must be an object with keys among \"id\", \"kind\" and \"ask\", not "
        "\"?\"\n");
  CHECK(mistakes(asking("\"start\"", R"("id": "a", "kind": "span", "value": "u", "ask": "?")"), spline) ==
        "lesson.json:5:52: beats[0].checkpoint.value: \"u\" is no index of a knot span\n");
  CHECK(mistakes(asking("\"start\"", R"("id": "a", "kind": "span", "value": "s", "ask": "?")"), spline) ==
        "lesson.json:5:52: beats[0].checkpoint.value: \"s\" is no index of a knot span\n");
  CHECK(mistakes(asking("\"start\"", R"("id": "a", "kind": "order", "items": ["one"], "ask": "?")")) ==
        "lesson.json:4:53: beats[0].checkpoint.items: must have at least 2 items, not 1\n");
}

TEST_CASE("things that read the same cannot be put in order or chosen among") {
  CHECK(mistakes(asking("\"start\"", R"("id": "a", "kind": "order", "items": ["one", "two", "one"], "ask": "?")") +
                 ",\n" + asking("\"P[1][0]\"", R"("id": "b", "kind": "choice", "ask": "?",
"choices": [{"text": "one", "right": true}, {"text": "one"}])")) ==
        "lesson.json:4:68: beats[0].checkpoint.items[2]: reads the same as the one at 0; nobody can tell them apart\n"
        "lesson.json:7:54: beats[1].checkpoint.choices[1].text: reads the same as the one at 0; nobody can tell them "
        "apart\n");
  CHECK(mistakes(asking("\"start\"", R"("id": "a", "kind": "choice", "ask": "?",
"choices": [{"text": "one", "right": "true"}, {"text": "two"}])")) ==
        "lesson.json:5:38: beats[0].checkpoint.choices[0].right: must be true or false, not \"true\"\n");
}

TEST_CASE("a question that is asked at every step is asked at none") {
  CHECK(mistakes(asking("{\"every\": \"P[1][*]\"}", R"("id": "a", "kind": "line", "ask": "?")")) ==
        "lesson.json:4:15: beats[0].checkpoint: must stand at one step, not at every one; put it into a beat of its "
        "own\n");
}

TEST_CASE("checkpoints are written as they are read") {
  for (
      const std::string text :
      {R"({"id": "p", "kind": "predict", "ask": "?", "points": 2, "value": "C", "decimals": 1})",
       R"({"id": "l", "kind": "line", "ask": "?", "right": "Yes.", "wrong": "No."})",
       R"({"id": "o", "kind": "order", "ask": "?", "points": "1/3", "items": ["a", "b"]})",
       R"({"id": "c", "kind": "choice", "ask": "?", "choices": [{"text": "a", "feedback": "No."}, {"text": "b", "right": true}]})"}) {
    const auto document = parsed(text);
    Diagnostics diagnostics;
    const auto made = read_checkpoint(Cursor(document, diagnostics), {}, nullptr, std::nullopt);
    INFO(to_string(diagnostics));
    REQUIRE(made);
    CHECK(write_json(write_checkpoint(*made, {})) == write_json(document.root()));
  }
}
