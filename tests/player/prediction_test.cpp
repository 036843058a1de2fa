#include "player/prediction.hpp"

#include <catch2/catch.hpp>

#include "algorithms/inputs.hpp"
#include "algorithms/selector.hpp"
#include "grader/helpers.hpp"
#include "player/document.hpp"
#include "player/inputs.hpp"
#include "scene/recording.hpp"

using namespace blossom;
using namespace blossom::test;

namespace {

using Texts = std::vector<std::string>;

// P[1][0] = (2/5, 6/5), P[1][1] = (11/5, 17/5), P[1][2] = (24/5, 14/5), P[2][0] = (28/25, 52/25), ...
std::shared_ptr<const Grader> de_casteljau_grader(const std::string& more = "") {
  return grader_of(exercise_text("de_casteljau", de_casteljau_inputs,
                                 R"([{"value": "P[1][*]", "points": 1}, {"value": "P[2][0]", "points": 1}])", more));
}

Prediction predict(std::shared_ptr<const Grader> grader, Marking marking = Marking::at_once) {
  const auto& trace = grader->exercise().run.trace;
  return {std::move(grader), marking, trace};
}

std::size_t question(const Prediction& prediction, const std::string& name) {
  for (std::size_t q = 0; q < prediction.questions().size(); ++q)
    if (prediction.questions()[q].name == name) return q;
  FAIL("no question " << name);
  return 0;
}

std::optional<std::string> answer(Prediction& prediction, const std::string& name, Texts numbers) {
  return prediction.answer(question(prediction, name), std::move(numbers));
}

Texts right(const Prediction& prediction, std::size_t q) {
  Texts numbers;
  for (const Exact& x : prediction.exercise().parts[prediction.questions()[q].part].right)
    numbers.push_back(x.to_string());
  return numbers;
}

std::string verdict_of(const Prediction& prediction, const std::string& name) {
  const auto mark = prediction.mark(question(prediction, name));
  return mark ? std::string(verdict_name(mark->verdict)) : "none";
}

// What blossom-grade says of the file that is handed in.
Grade handed_in(const Prediction& prediction, const Grader& grader) {
  const auto document = JsonDocument::parse("answers.json", prediction.answers_file(), submission_limits);
  INFO(prediction.answers_file() << to_string(document.diagnostics));
  REQUIRE(document);
  const Grade grade = grader.grade(document);
  CHECK(grade.reason.empty());
  CHECK(grade.notes.empty());
  return grade;
}

std::vector<std::filesystem::path> shipped_exercises() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator("exercises"))
    if (const auto name = entry.path().filename().string();
        entry.path().extension() == ".json" && name.find(".schema.") == std::string::npos)
      files.push_back(entry.path());
  std::ranges::sort(files);
  REQUIRE(files.size() >= 14);
  return files;
}

std::shared_ptr<const Grader> practice(const char* algorithm, const Inputs<Exact>& inputs, const Texts& asks = {}) {
  const auto made = practice_exercise(*find_algorithm(algorithm), inputs, asks, "practice", "Practice");
  INFO(to_string(made.diagnostics));
  REQUIRE(made);
  return *made;
}

Texts asked(const Grader& grader) {
  Texts names;
  for (const Part& part : grader.exercise().parts) names.push_back(part.name);
  return names;
}

}  // namespace

TEST_CASE("questions are the asked values, in the order they are made") {
  // Asked in another order than they are made.
  const auto prediction =
      predict(grader_of(exercise_text("de_boor", nurbs_inputs,
                                      R"([{"value": "C", "points": 2}, {"value": "P[1][*]", "points": 1,
                                           "form": "homogeneous"}, {"value": "k", "points": 1}])")));
  const auto& trace = prediction.exercise().run.trace;
  Texts names;
  for (const AskedValue& q : prediction.questions()) {
    names.push_back(q.name);
    CHECK(prediction.exercise().parts[q.part].name == q.name);
    CHECK(trace.name(q.value) == q.name);
    CHECK(trace.value(q.value).step == q.step);
    CHECK(trace.value(q.value).kind == q.kind);
  }
  CHECK(names == Texts{"k", "P[1][2]", "P[1][3]", "P[1][4]", "C"});
  CHECK(prediction.questions()[0].size == 1);
  CHECK(prediction.questions()[1].size == 3);
  CHECK(prediction.questions()[1].form == Form::homogeneous);
  CHECK(prediction.questions()[4].size == 2);
}

TEST_CASE("a question is put only where the run that is stepped through has its value") {
  const auto grader = de_casteljau_grader();
  auto inputs = grader->exercise().run.inputs;
  auto& curve = std::get<Curve<Exact>>(inputs.values["curve"]);
  curve.degree = 2;
  curve.points.pop_back();
  curve.knots = bezier_knots<Exact>(2);
  const auto shorter = record<double>(*find_algorithm("de_casteljau"), inputs);
  REQUIRE(shorter);
  const Prediction prediction(grader, Marking::at_once, shorter->trace);
  Texts names;
  for (const AskedValue& q : prediction.questions()) names.push_back(shorter->trace.name(q.value));
  CHECK(names == Texts{"P[1][0]", "P[1][1]", "P[2][0]"});  // P[1][2] is gone
}

TEST_CASE("what is open, and which steps would tell the answer") {
  auto prediction = predict(de_casteljau_grader());
  const auto step = [&](std::size_t q) { return prediction.questions()[q].step; };
  CHECK(prediction.open() == 0u);
  CHECK_FALSE(prediction.veiled(step(0) - 1));
  CHECK(prediction.veiled(step(0)));
  CHECK(prediction.veiled(step(3)));

  CHECK_FALSE(prediction.answer(0, {"2/5", "6/5"}));
  CHECK(prediction.open() == 1u);
  CHECK_FALSE(prediction.veiled(step(0)));
  CHECK(prediction.veiled(step(1)));

  prediction.show_me(1);
  CHECK_FALSE(prediction.answer(3, {"0", "0"}));
  CHECK(prediction.open() == 2u);
  CHECK_FALSE(prediction.finished());
  CHECK_FALSE(prediction.answer(2, {"0", "0"}));
  CHECK(prediction.open() == std::nullopt);
  CHECK_FALSE(prediction.veiled(step(3)));
  CHECK(prediction.finished());
}

TEST_CASE("all shipped exercises answered rightly earn everything; shown or wrong answers do not") {
  for (const auto& file : shipped_exercises()) {
    INFO(file);
    auto exercise = load_exercise(file);
    REQUIRE(exercise);
    const auto grader = std::make_shared<const Grader>(std::move(*exercise));
    const auto& parts = grader->exercise().parts;

    auto prediction = predict(grader);
    CHECK(prediction.questions().size() == parts.size());
    for (std::size_t q = 0; q < prediction.questions().size(); ++q) {
      INFO(prediction.questions()[q].name);
      CHECK(prediction.answer(q, right(prediction, q)) == std::nullopt);
    }
    CHECK(handed_in(prediction, *grader).score() == 1);
    REQUIRE(prediction.grade());
    CHECK(prediction.grade()->score() == 1);

    // The first one wrong.
    auto careless = predict(grader);
    const std::size_t first_part = careless.questions()[0].part;
    auto wrong = right(careless, 0);
    wrong[0] = (*Exact::parse(wrong[0]) + Exact(17)).to_string();
    CHECK(careless.answer(0, wrong) == std::nullopt);
    for (std::size_t q = 1; q < careless.questions().size(); ++q)
      CHECK(careless.answer(q, right(careless, q)) == std::nullopt);
    const Grade with_one_wrong = handed_in(careless, *grader);
    CHECK(with_one_wrong.parts[first_part].verdict != Verdict::correct);
    CHECK(with_one_wrong.points == careless.grade()->points);
    CHECK(with_one_wrong.points < grader->exercise().max_points);

    // Every other one shown.
    auto helped = predict(grader);
    Exact shown = 0;
    for (std::size_t q = 0; q < helped.questions().size(); ++q) {
      if (q % 2 == 0) {
        helped.show_me(q);
        CHECK(helped.attempt(q)->numbers == right(helped, q));
        shown += parts[helped.questions()[q].part].points;
      } else {
        CHECK(helped.answer(q, right(helped, q)) == std::nullopt);
      }
    }
    const Grade with_help = handed_in(helped, *grader);
    CHECK(with_help.points == grader->exercise().max_points - shown);
    CHECK(with_help.parts[first_part].verdict == Verdict::missing);
    CHECK(helped.shown() == static_cast<int>((helped.questions().size() + 1) / 2));
  }
}

TEST_CASE("the answers file holds what was typed, as it was typed") {
  auto prediction =
      predict(grader_of(exercise_text("knot_insertion", insertion_inputs,
                                      R"([{"value": "k", "points": 1}, {"value": "Ubar", "points": 1, "as": "set"},
                                          {"value": "Q[1][2]", "points": 1}])")));
  CHECK(prediction.answers_file() ==
        "{\n  \"schema\": \"blossom.answers/1\",\n  \"exercise\": \"test\",\n  \"answers\": {}\n}\n");
  CHECK_FALSE(answer(prediction, "Q[1][2]", {" -0.40 ", "4/10"}));
  CHECK_FALSE(answer(prediction, "k", {"4"}));
  CHECK_FALSE(answer(prediction, "Ubar", {"1", "0"}));
  CHECK(
      prediction.answers_file() ==
      "{\n  \"schema\": \"blossom.answers/1\",\n  \"exercise\": \"test\",\n  \"answers\": {\n"
      "    \"k\": \"4\",\n    \"Q[1][2]\": [\"-0.40\", \"4/10\"],\n    \"Ubar\": {\"set\": [\"1\", \"0\"]}\n  }\n}\n");
}

TEST_CASE("an answer of another shape is refused in plain words, and nothing changes") {
  auto prediction = predict(grader_of(exercise_text("knot_insertion", insertion_inputs,
                                                    R"([{"value": "k", "points": 1}, {"value": "Q[1][2]", "points": 1},
                                          {"value": "Q[1][3]", "points": 1, "form": "homogeneous"},
                                          {"value": "Ubar", "points": 1}])")));
  CHECK_FALSE(answer(prediction, "k", {"3"}));
  const std::string before = prediction.answers_file();

  CHECK(answer(prediction, "k", {}) == "nothing was typed");
  CHECK(answer(prediction, "k", {" "}) == "a number is missing");
  CHECK(answer(prediction, "k", {"1", "2"}) == "one whole number is asked, not 2");
  CHECK(answer(prediction, "k", {"four"}) == "\"four\" is no number such as 3, -0.4 or 2/5");
  CHECK(answer(prediction, "Q[1][2]", {"1", "2", "3"}) == "2 numbers are asked: x and y, not 3");
  CHECK(answer(prediction, "Q[1][2]", {"1", "2/0"}) == "\"2/0\" is no number such as 3, -0.4 or 2/5");
  CHECK(answer(prediction, "Q[1][3]", {"1", "2"}) == "3 numbers are asked: w x, w y and the weight w, not 2");
  CHECK(answer(prediction, "Ubar", {}) == "nothing was typed");
  CHECK(answer(prediction, "Ubar", {"0", "1\", \"2"}));  // no way out of the quotes
  const auto too_long = answer(prediction, "Ubar", Texts(5000, "1"));
  REQUIRE(too_long);
  CHECK(too_long->starts_with("the answers are too long all together: "));

  CHECK(prediction.answers_file() == before);
  CHECK_FALSE(prediction.attempt(question(prediction, "Ubar")));
  CHECK(prediction.undo());
  CHECK_FALSE(prediction.undo());  // refused answers are no part of the history
}

TEST_CASE("at once, each answer is marked as the grader marks it, carried and misconceptions included") {
  auto prediction = predict(de_casteljau_grader());
  CHECK(verdict_of(prediction, "P[1][0]") == "none");
  CHECK_FALSE(answer(prediction, "P[1][0]", {"0.4", "1.2"}));
  CHECK(verdict_of(prediction, "P[1][0]") == "correct");
  CHECK(prediction.mark(0)->points == Exact(1));
  CHECK(prediction.attempt(0)->mark->feedback == "Correct.");

  CHECK_FALSE(answer(prediction, "P[1][1]", {"7", "7"}));
  CHECK(verdict_of(prediction, "P[1][1]") == "wrong");
  CHECK(prediction.mark(1)->feedback.find("Right is P[1][1] = ") != std::string::npos);
  // 3/5 (2/5, 6/5) + 2/5 (7, 7)
  CHECK_FALSE(answer(prediction, "P[2][0]", {"76/25", "88/25"}));
  CHECK(verdict_of(prediction, "P[2][0]") == "carried");
  // 2/5 (4, 4) + 3/5 (6, 1)
  CHECK_FALSE(answer(prediction, "P[1][2]", {"26/5", "11/5"}));
  CHECK(verdict_of(prediction, "P[1][2]") == "misconception");
  CHECK(prediction.mark(2)->misconception == "swapped-weights");

  // A marked answer stands: what was told with the mark is no help to a better one, unless it is taken back, counted.
  const auto refused = answer(prediction, "P[1][1]", {"11/5", "17/5"});
  REQUIRE(refused);
  CHECK(refused->find("marked already") != std::string::npos);
  CHECK(verdict_of(prediction, "P[2][0]") == "carried");
  REQUIRE(prediction.grade());
  CHECK(prediction.grade()->points == Exact(2));
}

TEST_CASE("at the end, nothing is told before the last answer or the student's own end") {
  auto prediction = predict(de_casteljau_grader(), Marking::at_end);
  CHECK(prediction.marking() == Marking::at_end);
  CHECK_FALSE(prediction.answer(0, {"2/5", "6/5"}));
  CHECK_FALSE(prediction.answer(1, {"0", "0"}));
  CHECK(prediction.mark(0) == std::nullopt);
  CHECK(prediction.veiled(prediction.questions()[0].step));  // its step would tell
  CHECK_FALSE(prediction.attempt(0)->mark);
  CHECK_FALSE(prediction.grade());

  auto given_up = prediction;
  given_up.finish();
  CHECK(given_up.finished());
  CHECK(verdict_of(given_up, "P[1][0]") == "correct");
  CHECK(verdict_of(given_up, "P[1][1]") == "wrong");
  CHECK(verdict_of(given_up, "P[1][2]") == "missing");
  REQUIRE(given_up.grade());
  CHECK(given_up.grade()->points == Exact(1));

  CHECK_FALSE(prediction.answer(2, {"24/5", "14/5"}));
  CHECK_FALSE(prediction.mark(2));
  CHECK_FALSE(prediction.answer(3, {"28/25", "52/25"}));
  CHECK(prediction.finished());
  CHECK(verdict_of(prediction, "P[1][0]") == "correct");
  CHECK(verdict_of(prediction, "P[1][1]") == "wrong");
  CHECK(prediction.grade()->points == Exact(3));
}

TEST_CASE("an exercise's feedback bounds what is told") {
  auto silent = predict(de_casteljau_grader(R"(, "feedback": "none")"));
  auto verdicts = predict(de_casteljau_grader(R"(, "feedback": "verdict")"));
  for (std::size_t q = 0; q < 4; ++q) {
    CHECK_FALSE(silent.answer(q, {"1", "1"}));
    CHECK_FALSE(verdicts.answer(q, {"1", "1"}));
    CHECK_FALSE(silent.mark(q));
    CHECK_FALSE(silent.attempt(q)->mark);
    REQUIRE(verdicts.mark(q));
    CHECK(verdicts.mark(q)->feedback.empty());
  }
  CHECK(silent.finished());
  CHECK_FALSE(silent.grade());
  CHECK(verdicts.grade());
}

TEST_CASE("undo takes answers back one by one, redo puts them back, a new answer ends what could be redone") {
  auto prediction = predict(de_casteljau_grader(), Marking::at_end);
  CHECK_FALSE(prediction.undo());
  CHECK_FALSE(prediction.redo());
  CHECK_FALSE(prediction.answer(0, {"1", "1"}));
  CHECK_FALSE(prediction.answer(0, {"2", "2"}));
  prediction.guess_line(0, 3, 4);
  REQUIRE(prediction.line_guess(0));
  CHECK(prediction.line_guess(0)->picked == 3);
  CHECK(prediction.line_guess(0)->right == 4);
  CHECK(prediction.answers_file().find("line") == std::string::npos);

  CHECK(prediction.undo());
  CHECK_FALSE(prediction.line_guess(0));
  CHECK(prediction.attempt(0)->numbers == Texts{"2", "2"});
  CHECK(prediction.undo());
  CHECK(prediction.attempt(0)->numbers == Texts{"1", "1"});
  CHECK(prediction.undo());
  CHECK_FALSE(prediction.attempt(0));
  CHECK_FALSE(prediction.undo());
  CHECK(prediction.undos() == 3);

  CHECK(prediction.redo());
  CHECK(prediction.attempt(0)->numbers == Texts{"1", "1"});
  CHECK_FALSE(prediction.mark(0));
  CHECK_FALSE(prediction.answer(1, {"5", "5"}));
  CHECK_FALSE(prediction.redo());
  CHECK(prediction.undos() == 3);
}

TEST_CASE("what was shown stays shown: taken back, it is still counted, and an answer afterwards earns nothing") {
  auto prediction = predict(de_casteljau_grader());
  CHECK_FALSE(prediction.answer(1, {"11/5", "17/5"}));
  prediction.show_me(0);
  CHECK(prediction.attempt(0)->shown);
  CHECK(prediction.attempt(0)->numbers == Texts{"2/5", "6/5"});
  CHECK_FALSE(prediction.mark(0));
  CHECK(prediction.shown() == 1);
  prediction.show_me(0);
  CHECK(prediction.shown() == 1);  // nothing new was learned

  CHECK(prediction.undo());
  CHECK(prediction.undo());
  CHECK_FALSE(prediction.attempt(0));
  CHECK(prediction.shown() == 1);
  CHECK(prediction.undos() == 2);

  CHECK_FALSE(prediction.answer(0, {"2/5", "6/5"}));
  CHECK(prediction.attempt(0)->shown);
  CHECK_FALSE(prediction.mark(0));
  CHECK(prediction.answers_file().find("P[1][0]") == std::string::npos);
  prediction.finish();
  CHECK(prediction.grade()->points == Exact(1));

  // An answer from before it was shown is the student's own, and comes back as that.
  prediction.show_me(1);
  CHECK(prediction.grade()->points == Exact(0));
  CHECK(prediction.undo());
  CHECK(verdict_of(prediction, "P[1][1]") == "correct");
  CHECK(prediction.shown() == 2);
}

TEST_CASE("a clicked place is typed as finely as a pixel means it, in the shape of the question") {
  AskedValue point{0, "P[1][0]", 1, 0, ValueKind::point, 2, Form::affine};
  const glm::dvec3 at{1.23456, -0.0004, 7.5};
  CHECK(prefilled(point, at, 0.01) == Texts{"1.23", "0"});
  CHECK(prefilled(point, at, 0.03) == Texts{"1.23", "0"});
  CHECK(prefilled(point, at, 0.1) == Texts{"1.2", "0"});
  CHECK(prefilled(point, at, 25) == Texts{"1", "0"});
  CHECK(prefilled(point, at, 0.0001) == Texts{"1.2346", "-0.0004"});
  point.size = 3;
  CHECK(prefilled(point, at, 0.5) == Texts{"1.2", "0", "7.5"});

  AskedValue homogeneous = point;
  homogeneous.form = Form::homogeneous;
  CHECK(prefilled(homogeneous, at, 0.01).empty());
  AskedValue weight = point;
  weight.form = Form::weight;
  CHECK(prefilled(weight, at, 0.01).empty());
  for (const ValueKind kind : {ValueKind::integer, ValueKind::scalar, ValueKind::vector, ValueKind::list})
    CHECK(prefilled({0, "x", 1, 0, kind, 1, Form::affine}, at, 0.01).empty());
}

TEST_CASE("practice asks what exercises on the algorithm usually ask, each value once and not too many") {
  const auto grader = practice("de_boor", inputs_from("de_boor", de_boor_inputs));
  CHECK(asked(*grader) == Texts{"k", "alpha[1][2]", "P[1][2]", "alpha[1][3]", "P[1][3]", "alpha[1][4]", "P[1][4]",
                                "P[2][3]", "P[2][4]", "P[3][4]", "C"});
  CHECK(grader->exercise().feedback == Feedback::full);
  CHECK(grader->exercise().title == "Practice");

  // Degree 20: all 210 points are too many, and so is the first level with its ratios beside k, which is left whole.
  std::string points;
  for (int i = 0; i <= 20; ++i)
    points += (i > 0 ? ", [" : "[") + std::to_string(i) + ", " + std::to_string(i * i % 7) + "]";
  const auto high = practice("de_casteljau", inputs_from("de_casteljau", R"({"curve": {"degree": 20, "points": [)" +
                                                                             points + R"(]}, "u": "1/3"})"));
  CHECK(high->exercise().parts.size() == 21);
  CHECK(high->exercise().part("P[1][19]"));
  CHECK(high->exercise().part("C"));
  CHECK_FALSE(high->exercise().part("P[2][0]"));
}

TEST_CASE("practice asks what a lesson says, without what is given or not there") {
  const auto inputs = inputs_from("de_boor", de_boor_inputs);
  const auto grader = practice("de_boor", inputs, {"P[0..1][*]", "P[*][3]", "P[9][*]"});
  CHECK(asked(*grader) == Texts{"P[1][2]", "P[1][3]", "P[1][4]", "P[2][3]"});

  const auto& algorithm = *find_algorithm("de_boor");
  CHECK(to_string(practice_exercise(algorithm, inputs, {"P[9][*]"}, "a", "A").diagnostics) ==
        "there is nothing to predict in this run\n");
  CHECK(to_string(practice_exercise(algorithm, inputs, {"P[1"}, "a", "A").diagnostics)
            .starts_with("\"P[1\" is no selector"));
  CHECK_FALSE(practice_exercise(algorithm, inputs, {"k"}, "No Id", "A"));
}

TEST_CASE("in practice a click near a point counts, a number must be near to 1/100, a span must be the one") {
  auto prediction = predict(practice("de_boor", inputs_from("de_boor", de_boor_inputs)));  // 33 wide: 0.66
  // P[1][2] = 1/5 (0, 1) + 4/5 (2, 20), alpha[1][3] = 8/15
  CHECK_FALSE(answer(prediction, "P[1][2]", {"2.2", "15.6"}));
  CHECK(verdict_of(prediction, "P[1][2]") == "correct");
  CHECK(prediction.undo());
  CHECK_FALSE(answer(prediction, "P[1][2]", {"2.3", "16.2"}));
  CHECK(verdict_of(prediction, "P[1][2]") != "correct");
  CHECK_FALSE(answer(prediction, "alpha[1][3]", {"0.54"}));
  CHECK(verdict_of(prediction, "alpha[1][3]") == "correct");
  CHECK(prediction.undo());
  CHECK_FALSE(answer(prediction, "alpha[1][3]", {"0.55"}));
  CHECK(verdict_of(prediction, "alpha[1][3]") != "correct");
  CHECK_FALSE(answer(prediction, "k", {"4.001"}));
  CHECK(verdict_of(prediction, "k") != "correct");
  CHECK(prediction.undo());
  CHECK_FALSE(answer(prediction, "k", {"4"}));
  CHECK(verdict_of(prediction, "k") == "correct");
}

TEST_CASE("practice can be had of any run, and its right answers are right") {
  test::for_each_run(25, [](const Algorithm& algorithm, const Inputs<Exact>& inputs) {
    const auto made = practice_exercise(algorithm, inputs, {}, "any", "");
    INFO(to_string(made.diagnostics));
    REQUIRE(made);
    auto prediction = predict(*made);
    CHECK(prediction.questions().size() <= 40);
    for (std::size_t q = 0; q < prediction.questions().size(); ++q) {
      CHECK_FALSE(prediction.answer(q, right(prediction, q)));
      CHECK(verdict_of(prediction, prediction.questions()[q].name) == "correct");
    }
    CHECK(prediction.grade()->score() == 1);
  });
}

TEST_CASE("a question says which of its kind is asked, an answer stands as one writes it") {
  const auto document = open_document("tests/play/data/11-de-casteljau.json");
  REQUIRE(document);
  const auto recording = Recording::make(*document->algorithm, document->inputs, true);
  REQUIRE(recording);
  const StepSource& source = (*recording)->source();
  const Prediction prediction = predict(de_casteljau_grader());
  const AskedValue& point = prediction.questions()[question(prediction, "P[1][1]")];
  CHECK(asked_words(point, source).starts_with("What is P[1][1]? It is the point 1 of level 1"));
  CHECK(answer_words(point, {"0", "16"}) == "P[1][1] = (0, 16)");
  CHECK(reason_words(point, source).starts_with("P[1][1] = (1 - u) P[0][1] + u P[0][2] = "));
}

TEST_CASE("numbers are split at commas, semicolons, blanks and brackets") {
  CHECK(split_numbers("(16, 20)") == Texts{"16", "20"});
  CHECK(split_numbers("0;1/2 1") == Texts{"0", "1/2", "1"});
  CHECK(split_numbers("2/5") == Texts{"2/5"});
  CHECK(split_numbers(" ( ) ").empty());
}

TEST_CASE("what undo would take back is named") {
  auto prediction = predict(de_casteljau_grader(), Marking::at_end);
  CHECK_FALSE(prediction.can_undo());
  prediction.show_me(0);
  CHECK(prediction.undo_what() == "what was shown of " + prediction.questions()[0].name);
  prediction.guess_line(1, 2, 3);
  CHECK(prediction.undo_what() == "the line picked for " + prediction.questions()[1].name);
  CHECK(prediction.undo_question() == 1);
  REQUIRE_FALSE(answer(prediction, "P[1][1]", {"1", "2"}));
  CHECK(prediction.undo_what() == "the answer to P[1][1]");
  CHECK(prediction.answered() == 2);
  CHECK_FALSE(prediction.can_redo());
  REQUIRE(prediction.undo());
  CHECK(prediction.can_redo());
}
