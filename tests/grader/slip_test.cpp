// What is said of a value in one stable word; slips against misconceptions; voided parts; and that names never raise
// points.

#include <random>

#include "grader/helpers.hpp"

using namespace blossom;

namespace {

std::string note(const Grade& grade, const std::string& name) { return std::string(part(grade, name).note); }

// P1 = (12, 27) (23, 33); P2 = (35/2, 30).
std::unique_ptr<Grader> midpoints(const std::string& more = "") {
  return grader_of(exercise_text("de_casteljau",
                                 R"({"curve": {"degree": 2, "points": [[0, 10], [24, 44], [22, 22]]}, "u": "1/2"})",
                                 R"([{"value": "P[1..2][*]", "points": 1}])", more));
}

// Swapping the weights of (0, 6) and (6, 0) exchanges the coordinates: P1 = (2, 4) (7, 1); P2 = (11/3, 3). With the
// weights swapped: (4, 2) (8, 2).
const char* const mirrored = R"({"curve": {"degree": 2, "points": [[0, 6], [6, 0], [9, 3]]}, "u": "1/3"})";
const std::string shares = R"(, "partial": {"misconception": "1/2", "slip": "1/4"})";

}  // namespace

TEST_CASE("every mistake has its word") {
  const auto grader = midpoints();
  const auto word = [&](const char* answer) {
    return note(grade_answers(*grader, std::string(R"({"P[1][0]": )") + answer + "}"), "P[1][0]");
  };
  CHECK(word("[12, 27]").empty());
  CHECK(word("[-12, 27]") == "sign");
  CHECK(word("[-12, -27]") == "all-signs");
  CHECK(word("[27, 12]") == "coordinates");
  CHECK(word("[12, 72]") == "digits");
  CHECK(word("[12, 28]") == "arithmetic");
  CHECK(word("[13, 28]") == "unknown");
  CHECK(word("[1]").empty());
  const Grade grade = grade_answers(*grader, R"({"P[1][0]": [0, 0], "P[1][1]": [0, 0], "P[2][0]": [0, 0]})");
  CHECK(note(grade, "P[2][0]") == "trivial");
  CHECK(note(grade_answers(*midpoints(), "{}"), "P[2][0]").empty());
}

TEST_CASE("one coordinate off is arithmetic: still wrong, with a hint") {
  const auto grader = midpoints(R"(, "feedback": "hint")");
  Grade grade = grade_answers(*grader, R"({"P[1][0]": [12, 28], "P[1][1]": [23, 33], "P[2][0]": [18, "61/2"]})");
  CHECK(verdict(grade, "P[1][0]") == "wrong");
  CHECK(part(grade, "P[1][0]").points == Exact(0));
  CHECK(part(grade, "P[1][0]").feedback.starts_with("Not the right value. Only y is off: check the arithmetic."));
  // Against what their own values make expected, (35/2, 61/2).
  CHECK(part(grade, "P[2][0]").feedback.starts_with("Not the right value. Only x is off: check the arithmetic."));
}

TEST_CASE("the only wrong value, from which others follow, is arithmetic") {
  const auto grader = midpoints();
  Grade grade = grade_answers(*grader, R"({"P[1][0]": [13, 28], "P[1][1]": [23, 33], "P[2][0]": [18, "61/2"]})");
  CHECK(note(grade, "P[1][0]") == "arithmetic");
  CHECK(part(grade, "P[1][0]").feedback.find("check the arithmetic") != std::string::npos);
  CHECK(verdict(grade, "P[2][0]") == "carried");
  // Nothing follows from it; or it is not the only one.
  grade = grade_answers(*grader, R"({"P[1][0]": [12, 27], "P[1][1]": [23, 33], "P[2][0]": [18, 31]})");
  CHECK(note(grade, "P[2][0]") == "unknown");
  grade = grade_answers(*grader, R"({"P[1][0]": [13, 28], "P[1][1]": [20, 30], "P[2][0]": ["33/2", 29]})");
  CHECK(verdict(grade, "P[2][0]") == "carried");
  CHECK(note(grade, "P[1][0]") == "unknown");
  CHECK(note(grade, "P[1][1]") == "unknown");
}

TEST_CASE("right values in fewer digits than are asked are rounded, not a slip of arithmetic") {
  const char* const thirds = R"({"curve": {"degree": 2, "points": [[0, 1], [4, 2], [9, 10]]}, "u": "1/3"})";
  const char* const all = R"([{"value": "P[1..2][*]", "points": 1}])";
  // (4/3, 4/3), (17/3, 14/3), (25/9, 22/9)
  const auto exact = grader_of(exercise_text("de_casteljau", thirds, all));
  Grade grade = grade_answers(*exact, R"({"P[1][0]": [1.33, 1.3], "P[1][1]": [5.66, 4.667], "P[2][0]": [2.78, 2.44]})");
  for (const char* name : {"P[1][0]", "P[1][1]", "P[2][0]"}) {
    CHECK(note(grade, name) == "rounded");
    CHECK(verdict(grade, name) == "wrong");
    CHECK(part(grade, name).points == Exact(0));
    CHECK(part(grade, name).feedback.find("give the fraction") != std::string::npos);
  }
  CHECK(!grade.explanation);
  // On their own (1, 1), after which (23/9, 20/9) follows; one digit says nothing; nor is 1.34 what 4/3 rounds to.
  grade = grade_answers(*exact, R"({"P[1][0]": [1, 1], "P[1][1]": ["17/3", "14/3"], "P[2][0]": [2.556, 2.222]})");
  CHECK(note(grade, "P[2][0]") == "rounded");
  for (const char* other : {"[1.3, 1.34]", "[1, 1.33]", "[1.4, 1.3]"})
    CHECK(note(grade_answers(*exact, std::string(R"({"P[1][0]": )") + other + "}"), "P[1][0]") != "rounded");
  const auto decimals = grader_of(exercise_text("de_casteljau", thirds, all, R"(, "tolerance": {"decimals": 3})"));
  grade = grade_answers(*decimals, R"({"P[1][0]": [1.33, 1.333]})");
  CHECK(note(grade, "P[1][0]") == "rounded");
  CHECK(part(grade, "P[1][0]").feedback.find("give 3 decimals") != std::string::npos);
}

TEST_CASE("a misconception that the values made of given numbers contradict is not claimed") {
  // The answers of somebody who has u = 3/4; with the weights swapped, their last levels would follow from their first.
  const auto grader = shipped("11-own-de-casteljau");
  auto level = grader.exercise().run.inputs.curve("curve").points;
  std::string answers;
  for (std::size_t r = 1; r <= 3; ++r)
    for (std::size_t i = 0; i + r <= 3; ++i) {
      level[i] = Exact::ratio(1, 4) * level[i] + Exact::ratio(3, 4) * level[i + 1];
      // Their own points are others.
      if (r == 1) level[i].x += Exact(1);
      answers += (answers.empty() ? "" : ", ") + json_quote("P[" + std::to_string(r) + "][" + std::to_string(i) + "]") +
                 ": [" + json_quote(level[i].x.to_string()) + ", " + json_quote(level[i].y.to_string()) + "]";
    }
  const Grade grade = grade_answers_to(grader, "{" + answers + "}");
  REQUIRE(grade.explanation);
  CHECK(grade.explanation->misconceptions.empty());
  for (const PartGrade& made : grade.parts) CHECK(made.misconception.empty());
  CHECK(part(grade, "P[2][0]").feedback.find("not your other values") != std::string::npos);
}

TEST_CASE("two misconceptions of one value each, in an answer that speaks against both, are not claimed") {
  // u was misread as 0.35.
  const auto grader = shipped("22-de-boor");
  const Grade grade = grade_answers_to(grader, R"({"k": 4, "alpha[1][2]": "7/10", "P[1][2]": [0, 14],
      "alpha[1][3]": "7/15", "P[1][3]": [14, 20], "alpha[1][4]": "2/15", "P[1][4]": [30, "52/3"],
      "P[2][3]": ["49/5", "91/5"], "P[2][4]": ["86/5", "292/15"], "P[3][4]": ["319/25", "1403/75"]})");
  REQUIRE(grade.explanation);
  CHECK(grade.explanation->misconceptions.empty());
  for (const char* name : {"P[2][4]", "P[3][4]"}) {
    CHECK(verdict(grade, name) == "wrong");
    CHECK(note(grade, name) == "unknown");
  }
}

TEST_CASE("a value that a slip and a misconception both give") {
  const auto all =
      grader_of(exercise_text("de_casteljau", mirrored, R"([{"value": "P[1..2][*]", "points": 1}])", shares));
  // The weights are right elsewhere: the coordinates were exchanged.
  Grade grade = grade_answers(*all, R"({"P[1][0]": [4, 2], "P[1][1]": [7, 1], "P[2][0]": ["11/3", 3]})");
  CHECK(verdict(grade, "P[1][0]") == "slip");
  CHECK(note(grade, "P[1][0]") == "coordinates");
  CHECK(part(grade, "P[1][0]").points == Exact::ratio(1, 4));
  REQUIRE(grade.explanation);
  CHECK(grade.explanation->misconceptions.empty());
  CHECK(grade.explanation->wrong == 1);
  // They are swapped elsewhere as well.
  grade = grade_answers(*all, R"({"P[1][0]": [4, 2], "P[1][1]": [8, 2], "P[2][0]": ["11/3", 3]})");
  CHECK(note(grade, "P[1][0]") == "swapped-weights");
  CHECK(note(grade, "P[1][1]") == "swapped-weights");
  CHECK(part(grade, "P[1][0]").points == Exact::ratio(1, 2));
  // There is no other value in which it could show.
  const auto one = grader_of(exercise_text("de_casteljau", mirrored, R"([{"value": "P[1][0]", "points": 1}])", shares));
  CHECK(note(grade_answers(*one, R"({"P[1][0]": [4, 2]})"), "P[1][0]") == "swapped-weights");
  // A slip that would earn more does not.
  const auto dear = grader_of(exercise_text("de_casteljau", mirrored, R"([{"value": "P[1..2][*]", "points": 1}])",
                                            R"(, "partial": {"misconception": 0, "slip": 1})"));
  grade = grade_answers(*dear, R"({"P[1][0]": [4, 2], "P[1][1]": [7, 1], "P[2][0]": ["11/3", 3]})");
  CHECK(verdict(grade, "P[1][0]") == "slip");
  CHECK(part(grade, "P[1][0]").points == Exact(0));
}

TEST_CASE("a voided part gives its points to everybody, or to nobody") {
  const auto grader = grader_of(exercise_text(
      "de_casteljau", mirrored,
      R"([{"value": "P[1][0]", "points": 2, "void": "credit"}, {"value": "P[1][1]", "points": 4, "void": "drop"},
          {"value": "P[2][0]", "points": 3}])",
      R"(, "feedback": "verdict")"));
  CHECK(grader->exercise().max_points == Exact(5));
  const auto check = [&](const char* answers, const char* first, const Exact& points) {
    INFO(answers);
    const Grade grade = grade_answers(*grader, answers);
    CHECK(verdict(grade, "P[1][0]") == first);
    CHECK(part(grade, "P[1][0]").points == Exact(2));
    CHECK(part(grade, "P[1][0]").feedback ==
          "This part was voided: everybody whose answers could be read gets its points.");
    CHECK(part(grade, "P[1][1]").points == Exact(0));
    CHECK(part(grade, "P[1][1]").feedback == "This part was voided: it counts for nobody.");
    CHECK(grade.points == points);
  };
  check("{}", "missing", 2);
  check(R"({"P[1][0]": "two", "P[1][1]": [7, 1]})", "invalid", 2);
  check(R"({"P[1][0]": [9, 9], "P[1][1]": [9, 8]})", "wrong", 2);
  check(R"({"P[1][0]": [2, 4], "P[1][1]": [7, 1], "P[2][0]": ["11/3", 3]})", "correct", 5);
  // They are no evidence of anything.
  CHECK(!grade_answers(*grader, R"({"P[1][0]": [4, 2], "P[1][1]": [8, 2]})").explanation);
  // What cannot be read is nothing handed in.
  CHECK(grade_text(*grader, "[").points == Exact(0));
}

TEST_CASE("notes and the explanation are for those whom the exercise gives hints") {
  CHECK(!shows_notes(Feedback::none));
  CHECK(!shows_notes(Feedback::verdict));
  CHECK(shows_notes(Feedback::hint));
  CHECK(shows_notes(Feedback::full));
  for (const char* level : {"none", "verdict", "hint", "full"}) {
    const auto grader = grader_of(exercise_text("de_casteljau", mirrored, R"([{"value": "P[1..2][*]", "points": 1}])",
                                                std::string(R"(, "feedback": ")") + level + "\""));
    const Grade grade = grade_answers(*grader, R"({"P[1][0]": [4, 2], "P[1][1]": [8, 2]})");
    CHECK(note(grade, "P[1][0]") == "swapped-weights");
    std::string json;
    write_json(grade, json);
    INFO(json);
    const bool told =
        json.find(R"("explanation":{"misconceptions":["swapped-weights"],"covered":2,"wrong":2})") != std::string::npos;
    CHECK(told == shows_notes(grader->exercise().feedback));
    CHECK((json.find(R"("note")") != std::string::npos) == shows_notes(grader->exercise().feedback));
  }
}

// ---- names never raise points ---------------------------------------------------------------------------------------

namespace {

using Typings = std::map<std::string, Numbers<Exact>>;

// Points by each value for itself, the slow way: is it one misconception's on right values, on none, or on their own;
// is it a slip; else nothing. What is right or carried is as it was found.
Exact points_value_by_value(const Exercise& exercise, const Typings& typed, const Grade& grade) {
  const ReplayPlan plan(exercise);
  const std::size_t count = exercise.parts.size();
  std::vector<std::size_t> all;
  std::vector<Given> given(count);
  for (std::size_t i = 0; i < count; ++i) {
    all.push_back(i);
    const auto found = typed.find(exercise.parts[i].name);
    if (found == typed.end()) continue;
    if (found->second == exercise.parts[i].right)
      given[i].kind = Given::Kind::right;
    else
      given[i] = {Given::Kind::typed, found->second};
  }
  Replayed own(exercise, plan);
  own.run(given);
  std::vector<char> by_misconception(count, 0);
  Replayed scratch(exercise, plan);
  for (const Misconception& m : exercise.run.algorithm->misconceptions) {
    const auto look = [&](const std::vector<Given>& before, bool only_changed) {
      replay_with(exercise, {&m}, scratch, before, all, [&](std::size_t i, NumbersView<Exact> traced) {
        const Part& part = exercise.parts[i];
        if (given[i].kind != Given::Kind::typed || (only_changed && !own.operands_changed(part.value))) return;
        if (agrees(part, traced, given[i].numbers)) by_misconception[i] = 1;
      });
    };
    look(std::vector<Given>(count, Given{Given::Kind::right}), false);
    look(std::vector<Given>(count), false);
    look(given, true);
  }
  Exact points = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Part& part = exercise.parts[i];
    const PartGrade& made = grade.parts[i];
    const bool settled = made.verdict == Verdict::correct || made.verdict == Verdict::carried || made.note == "trivial";
    if (settled || given[i].kind != Given::Kind::typed) {
      points += made.points;
    } else if (by_misconception[i] != 0) {
      points += exercise.misconception * part.points;
    } else {
      Typed slip;
      std::vector<std::string> texts;
      for (const Exact& x : given[i].numbers) texts.push_back(x.to_string());
      slip.texts.assign(texts.begin(), texts.end());
      slip.numbers = given[i].numbers;
      if (find_slip(part, exercise.run.trace.numbers(part.value), slip) ||
          (own.operands_changed(part.value) && find_slip(part, own.expected(part.value), slip)))
        points += exercise.slip * part.points;
    }
  }
  return points;
}

}  // namespace

TEST_CASE("the explanation of the whole never raises the points of a value") {
  const unsigned seed = 4711;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  const auto below = [&](std::size_t n) { return random() % n; };
  std::size_t renamed = 0;
  for (const char* partial : {R"(, "partial": {"misconception": "1/2", "slip": "1/4"})",
                              R"(, "partial": {"misconception": "1/4", "slip": "3/4"})"})
    for (const std::size_t s : {std::size_t{0}, std::size_t{2}, std::size_t{4}, std::size_t{5}}) {
      const auto grader =
          grader_of(exercise_text(standards[s].algorithm, standards[s].inputs, standards[s].ask, partial));
      const Exercise& exercise = grader->exercise();
      const auto& list = exercise.run.algorithm->misconceptions;
      const ReplayPlan plan(exercise);
      Replayed replayed(exercise, plan);
      for (int round = 0; round < 250; ++round) {
        // Two misconceptions throughout, or one, or none; then up to three mutations.
        Typings typed;
        for (const Part& part : exercise.parts) typed[part.name] = part.right;
        std::vector<const Misconception*> holds;
        for (std::size_t n = below(3); n > 0; --n) holds.push_back(&list[below(list.size())]);
        if (!holds.empty())
          replay_with(exercise, holds, replayed, std::vector<Given>(exercise.parts.size()), {0}, [&](auto, auto) {});
        for (std::size_t i = 0; i < exercise.parts.size() && !holds.empty(); ++i)
          if (auto made = exercise.parts[i].as_typed(replayed.own(exercise.parts[i].value)); !made.empty())
            typed[exercise.parts[i].name] = made;
        for (std::size_t n = below(4); n > 0; --n) {
          const Part& part = exercise.parts[below(exercise.parts.size())];
          if (!typed.contains(part.name)) continue;
          auto& numbers = typed[part.name];
          Exact& x = numbers[below(numbers.size())];
          switch (below(5)) {
            case 0:
              x = -x;
              break;
            case 1:
              if (part.kind != ValueKind::integer) x += Exact::ratio(1, 3);
              break;
            case 2:
              std::swap(numbers.front(), numbers.back());
              break;
            case 3:
              typed.erase(part.name);
              break;
            default:
              x += Exact(1);
          }
        }
        std::string answers = "{";
        for (const Part& part : exercise.parts)
          if (const auto found = typed.find(part.name); found != typed.end())
            answers +=
                (answers.size() > 1 ? ", " : "") + json_quote(part.name) + ": " + typed_text(part, found->second);
        answers += "}";
        const Grade grade = grade_answers(*grader, answers);
        INFO(standards[s].algorithm << " " << answers);
        CHECK(grade.points <= points_value_by_value(exercise, typed, grade));
        for (std::size_t i = 0; i < grade.parts.size(); ++i) {
          const Exact most = exercise.misconception * exercise.parts[i].points;
          if (grade.parts[i].verdict != Verdict::misconception) continue;
          CHECK(grade.parts[i].points <= most);
          renamed += grade.parts[i].points < most ? 1 : 0;
        }
      }
    }
  CHECK(renamed > 0);  // otherwise nothing was tried
}
