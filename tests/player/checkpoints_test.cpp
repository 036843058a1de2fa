// The questions of a lesson: answered, marked, tried again, skipped, written and remembered.
#include "player/checkpoints.hpp"

#include <catch2/catch.hpp>

using namespace blossom;

namespace {

Lesson lesson() {
  const auto document = JsonDocument::load("tests/play/data/questions.json");
  REQUIRE(document);
  auto loaded = load_lesson(*document);
  INFO(to_string(loaded.diagnostics));
  REQUIRE(loaded);
  return *std::move(loaded);
}

Checkpoints checkpoints() { return Checkpoints(std::make_shared<const Lesson>(lesson())); }

std::size_t place(const Checkpoints& all, std::string_view id) {
  const auto found = all.find(id);
  INFO(id);
  REQUIRE(found);
  return *found;
}

std::string right_order(const Checkpoints& all) { return right_letters(all.item(place(all, "order")).checkpoint); }

// Brings the shown items into the order of these letters, one place after the other.
void put_in_order(Checkpoints& all, const std::string& letters) {
  for (std::size_t to = 0; to < letters.size(); ++to)
    for (std::size_t from = to; from < letters.size(); ++from)
      if (letter_of(all.reply().order[from])[0] == letters[to])
        for (std::size_t at = from; at > to; --at) all.move(at, -1);
}

}  // namespace

TEST_CASE("The questions of all scenes are asked in the order of the lesson") {
  const Checkpoints all = checkpoints();
  std::string ids;
  for (const auto& item : all.items()) ids += item.checkpoint.id + std::to_string(item.scene) + " ";
  CHECK(ids == "why0 second0 order0 which1 line1 ");
  CHECK(all.answered() == 0);
  CHECK_FALSE(all.find("nothing"));
}

TEST_CASE("A choice is made by its letter and marked at once, with what the lesson says to it") {
  Checkpoints all = checkpoints();
  all.look_at(place(all, "why"), 1);
  CHECK_FALSE(all.submit());
  CHECK(all.reply().problem == "Choose one first.");
  CHECK(all.wants_key("B"));
  CHECK_FALSE(all.wants_key("D"));
  all.key("B");
  CHECK(all.reply().problem.empty());
  CHECK(all.submit("de"));
  const auto& item = all.item(place(all, "why"));
  REQUIRE(item.first);
  CHECK_FALSE(item.first->right);
  CHECK(item.first->answer == "\"b\"");
  CHECK(item.first->words.find("nur die erste Teilung") != std::string::npos);
  CHECK(item.first->words.find("Mittel dreier Punkte") != std::string::npos);
}

TEST_CASE("The first answer stands; trying again is practice") {
  Checkpoints all = checkpoints();
  all.look_at(place(all, "why"), 1);
  all.choose(2);
  REQUIRE(all.submit());
  all.choose(0);
  CHECK_FALSE(all.submit());
  all.try_again();
  all.choose(0);
  CHECK(all.submit());
  const auto& item = all.item(place(all, "why"));
  CHECK_FALSE(item.first->right);
  CHECK(item.again->right);
  CHECK(item.last() == &*item.again);
  CHECK(all.right() == 0);
  CHECK(all.answers().at("why") == "\"c\"");
}

TEST_CASE("A value is typed as a fraction or a decimal; what is no number is refused and nothing is marked") {
  for (const auto& [x, y, right] : {std::tuple("5", "6", true), std::tuple("10/2", "6.0", true),
                                    std::tuple("5.0004", "6", true), std::tuple("7", "2", false)}) {
    INFO(x << ", " << y);
    Checkpoints all = checkpoints();
    const std::size_t second = place(all, "second");
    all.look_at(second, 2);
    all.type(0, "5x");
    CHECK_FALSE(all.submit());
    CHECK_FALSE(all.reply().problem.empty());
    CHECK_FALSE(all.item(second).first);
    all.type({x, y});
    REQUIRE(all.submit());
    CHECK(all.item(second).first->right == right);
  }
}

TEST_CASE("A span is typed by its index, a line picked by its number") {
  Checkpoints all = checkpoints();
  all.look_at(place(all, "which"), 1);
  all.type({"3"});
  REQUIRE(all.submit());
  CHECK(all.item(place(all, "which")).first->right);

  const std::size_t line = place(all, "line");
  const int right = all.item(line).checkpoint.line;
  all.look_at(line, 1);
  CHECK_FALSE(all.wants_key("Enter"));
  CHECK_FALSE(all.submit_line(999));
  CHECK_FALSE(all.item(line).first);
  CHECK(all.submit_line(right));
  CHECK(all.item(line).first->right);
  CHECK(all.answers().at("line") == std::to_string(right));
}

TEST_CASE("Items are put in order by buttons, or by letters and arrows") {
  Checkpoints all = checkpoints();
  const std::size_t order = place(all, "order");
  all.look_at(order, 1);
  CHECK_FALSE(all.wants_key("Up"));
  all.key("C");
  CHECK(all.wants_key("Up"));
  CHECK(letter_of(all.reply().order[2]) == "c");
  all.key("Up");
  all.key("Up");
  all.key("Up");  // it is the first already
  CHECK(letter_of(all.reply().order[0]) == "c");
  all.key("Down");
  CHECK(letter_of(all.reply().order[1]) == "c");

  put_in_order(all, right_order(all));
  all.key("Enter");
  REQUIRE(all.item(order).first);
  CHECK(all.item(order).first->right);
  CHECK(all.item(order).first->answer == "\"" + right_order(all) + "\"");
}

TEST_CASE("A question that is skipped is open no more, and can still be answered") {
  Checkpoints all = checkpoints();
  const std::size_t why = place(all, "why");
  CHECK(all.item(why).open());
  all.skip(why);
  CHECK_FALSE(all.item(why).open());
  CHECK(all.skipped() == std::vector<std::string>{"why"});
  all.look_at(why, 1);
  CHECK(all.takes());
  all.choose(0);
  REQUIRE(all.submit());
  CHECK(all.skipped().empty());
  all.skip(why);
  CHECK(all.skipped().empty());
}

TEST_CASE("The answers file has the first answers, and what is remembered comes back marked") {
  Checkpoints all = checkpoints();
  all.look_at(place(all, "why"), 1);
  all.choose(0);
  REQUIRE(all.submit());
  all.look_at(place(all, "second"), 2);
  all.type({"1/3", "6"});
  REQUIRE(all.submit());
  all.skip(place(all, "which"));
  CHECK(all.answers_file() == R"({
  "schema": "blossom.answers/1",
  "exercise": "questions",
  "answers": {
    "why": "a",
    "second": ["1/3", 6]
  }
}
)");
  const auto parsed = JsonDocument::parse("answers", all.answers_file());
  REQUIRE(parsed);

  Checkpoints again = checkpoints();
  auto answers = all.answers();
  answers["line"] = "\"no line\"";  // from another version of the lesson
  answers["gone"] = "1";
  again.restore(answers, all.skipped());
  CHECK(again.answers() == all.answers());
  CHECK(again.skipped() == all.skipped());
  CHECK(again.right() == all.right());
  CHECK(again.item(place(again, "line")).open());
}
