// Every verdict, and the contract of all algorithms: their own answers are right, and any other is not.

#include "grader/helpers.hpp"

using namespace blossom;

namespace {

const std::string tolerances = R"(, "tolerance": {"decimals": 6})";

std::unique_ptr<Grader> standard(const Standard& s) {
  return grader_of(exercise_text(s.algorithm, s.inputs, s.ask, tolerances));
}

std::unique_ptr<Grader> de_boor_grader(const std::string& more = "") {
  return grader_of(exercise_text("de_boor", de_boor_inputs, standards[2].ask, more));
}

}  // namespace

TEST_CASE("a trace's own answers are right, and with any one value changed they are not") {
  for (const Standard& s : standards) {
    const auto grader = standard(s);
    const Exercise& exercise = grader->exercise();
    INFO(s.algorithm);
    const Grade full = grade_answers(*grader, all_answers(exercise));
    CHECK(full.score() == 1);
    for (const PartGrade& p : full.parts) CHECK(p.verdict == Verdict::correct);
    for (const Part& part : exercise.parts)
      for (std::size_t i = 0; i < part.right.size(); ++i) {
        Numbers<Exact> changed = part.right;
        changed[i] += Exact::ratio(1, 3);
        const Grade grade = grade_answers(*grader, all_answers(exercise, {{part.name, typed_text(part, changed)}}));
        INFO(part.name << " " << i);
        CHECK(grade.score() < 1);
        const Verdict made = grade.parts[*exercise.part(part.name)].verdict;
        CHECK(made != Verdict::correct);
        CHECK(made != Verdict::carried);
        for (std::size_t other = 0; other < exercise.parts.size(); ++other)
          if (exercise.parts[other].name != part.name) CHECK(grade.parts[other].verdict == Verdict::correct);
      }
  }
}

TEST_CASE("an early mistake costs its own points and no others") {
  const auto grader = de_boor_grader();
  // alpha[1][3] = 1/2 instead of 8/15; everything behind it follows by the right rules.
  const Grade grade =
      grade_answers(*grader, all_answers(grader->exercise(), {{"alpha[1][3]", "0.5"},
                                                              {"P[1][3]", R"([16, "41/2"])"},
                                                              {"P[2][3]", R"(["66/5", "98/5"])"},
                                                              {"P[2][4]", R"(["1029/50", "487/25"])"},
                                                              {"P[3][4]", R"(["11007/625", "12222/625"])"},
                                                              {"C", R"(["11007/625", "12222/625"])"}}));
  CHECK(verdict(grade, "alpha[1][3]") == "wrong");
  CHECK(verdict(grade, "P[1][3]") == "carried");
  CHECK(verdict(grade, "P[1][2]") == "correct");
  CHECK(grade.parts[0].verdict == Verdict::correct);
}

TEST_CASE("carried values chain through all levels, by the student's own numbers at each") {
  const auto grader = grader_of(exercise_text(
      "de_casteljau", R"({"curve": {"degree": 3, "points": [[0, 0], [2, 4], [6, 4], [8, 0]]}, "u": "1/2"})",
      R"([{"value": "P[1..3][*]", "points": 2}, {"value": "C", "points": 2}])", R"(, "carried": "1/2")"));
  // Right: P1 = (1,2) (4,4) (7,2); P2 = (5/2,3) (11/2,3); P3 = (4,3). The student has P[1][0] = (1,1).
  const Grade grade = grade_answers(*grader, R"({"P[1][0]": [1, 1], "P[1][1]": [4, 4], "P[1][2]": [7, 2],
      "P[2][0]": [2.5, 2.5], "P[2][1]": [5.5, 3], "P[3][0]": [4, 2.75], "C": [4, "11/4"]})");
  CHECK(verdict(grade, "P[1][0]") == "wrong");
  CHECK(verdict(grade, "P[1][1]") == "correct");
  CHECK(verdict(grade, "P[2][0]") == "carried");
  CHECK(verdict(grade, "P[2][1]") == "correct");
  CHECK(verdict(grade, "P[3][0]") == "carried");
  CHECK(verdict(grade, "C") == "carried");
  CHECK(part(grade, "C").points == Exact(1));
  CHECK(grade.points == Exact(9));  // 3 right of 2 points, 3 carried of half of that
  CHECK(part(grade, "C").feedback.starts_with("The right rule on your own earlier value."));
}

TEST_CASE("a value carried through levels nobody asked is found") {
  const auto grader = grader_of(exercise_text(
      "de_casteljau", R"({"curve": {"degree": 3, "points": [[0, 0], [2, 4], [6, 4], [8, 0]]}, "u": "1/2"})",
      R"([{"value": "P[1][0]", "points": 1}, {"value": "C", "points": 1}])"));
  CHECK(verdict(grade_answers(*grader, R"({"P[1][0]": [1, 1], "C": [4, 2.75]})"), "C") == "carried");
}

TEST_CASE("affine answers of a rational curve carry with the right weights, homogeneous ones with their own") {
  // P = (0, 0), (2, 2), (4, 0) with weights 1, 3, 1 and u = 1/2: P[1] = (3/2, 3/2), (5/2, 3/2) of weight 2; C = (2,
  // 3/2).
  const char* const arc =
      R"({"curve": {"degree": 2, "points": [[0, 0], [2, 2], [4, 0]], "weights": [1, 3, 1]}, "u": "1/2"})";
  const auto affine = grader_of(
      exercise_text("de_casteljau", arc, R"([{"value": "P[*][*]", "points": 1}, {"value": "C", "points": 1}])"));
  Grade grade =
      grade_answers(*affine, R"({"P[1][0]": [1, 0.5], "P[1][1]": [2.5, 1.5], "P[2][0]": [1.75, 1], "C": ["7/4", 1]})");
  CHECK(verdict(grade, "P[1][0]") == "wrong");
  CHECK(verdict(grade, "P[2][0]") == "carried");
  CHECK(verdict(grade, "C") == "carried");
  const auto homogeneous = grader_of(
      exercise_text("de_casteljau", arc,
                    R"([{"value": "P[*][*]", "points": 1, "form": "homogeneous"}, {"value": "C", "points": 1}])"));
  grade = grade_answers(*homogeneous,
                        R"({"P[1][0]": [3, 3, 4], "P[1][1]": [5, 3, 2], "P[2][0]": [4, 3, 3], "C": ["4/3", 1]})");
  CHECK(verdict(grade, "P[1][0]") == "wrong");
  CHECK(verdict(grade, "P[1][1]") == "correct");
  CHECK(verdict(grade, "P[2][0]") == "carried");
  CHECK(verdict(grade, "C") == "carried");
  const auto weights = grader_of(exercise_text(
      "de_casteljau", arc,
      R"([{"value": "P[1][*]", "points": 1, "form": "weight"}, {"value": "P[2][0]", "points": 1, "form": "weight"}])"));
  grade = grade_answers(*weights, R"({"P[1][0]": 3, "P[1][1]": 2, "P[2][0]": 2.5})");
  CHECK(verdict(grade, "P[1][0]") == "wrong");
  CHECK(verdict(grade, "P[2][0]") == "carried");
}

TEST_CASE("a rounded weight carries as the one that was meant") {
  // P[1][0] = (3, 3, 1/3) by mistake, with the right (5, 3, 2): P[2][0] = (4, 3, 7/6) and C = (24/7, 18/7). By 0.33, as
  // it is written down, the second is 2.5751.
  const auto grader = grader_of(
      exercise_text("de_casteljau",
                    R"({"curve": {"degree": 2, "points": [[0, 0], [2, 2], [4, 0]], "weights": [1, 3, 1]}, "u": "1/2"})",
                    R"([{"value": "P[1][0]", "points": 1, "form": "homogeneous"}, {"value": "C", "points": 1}])",
                    R"(, "tolerance": {"decimals": 2})"));
  CHECK(verdict(grade_answers(*grader, R"({"P[1][0]": [3, 3, 0.33], "C": [3.43, 2.57]})"), "C") == "carried");
  CHECK(verdict(grade_answers(*grader, R"({"P[1][0]": [3, 3, 0.33], "C": [3.43, 2.59]})"), "C") == "wrong");
}

TEST_CASE("a derivative of a rational curve may be typed without its weight, which is 0") {
  const Grader derivatives = shipped("46-derivatives");
  CHECK(verdict(grade_answers_to(derivatives, R"({"D[1]": [-1, 0]})"), "D[1]") == "correct");
  CHECK(verdict(grade_answers_to(derivatives, R"({"D[1]": [-1, 0, 0]})"), "D[1]") == "correct");
  CHECK(verdict(grade_answers_to(derivatives, R"({"D[1]": [-1, 1]})"), "D[1]") != "correct");
  // Those of the homogeneous curve have a weight that has to be said.
  CHECK(verdict(grade_answers_to(derivatives, R"({"P[1][1]": [-2, 2]})"), "P[1][1]") == "invalid");
}

TEST_CASE("irrational values carry like others") {
  const auto grader = grader_of(exercise_text(
      "skinning", skinning_inputs,
      R"([{"value": "e[*][*]", "points": 1}, {"value": "e[*]", "points": 1}, {"value": "v[*]", "points": 1},
                                                  {"value": "V[3]", "points": 1}])",
      R"(, "tolerance": {"decimals": 3})"));
  // e[1][0] = 0.3 in place of 0.2536: the mean of 0.3, 0.30500 and 0.23776, then v_1, v_2 = v_1 + 0.50230, and their
  // mean.
  std::map<std::string, std::string> rounded{
      {"e[1][0]", "0.3"}, {"e[1]", "0.281"}, {"v[1]", "0.281"}, {"v[2]", "0.783"}, {"V[3]", "0.532"}};
  const Grade grade = grade_answers(*grader, all_answers(grader->exercise(), rounded));
  CHECK(verdict(grade, "e[1][0]") == "wrong");
  for (const char* name : {"e[1]", "v[1]", "v[2]", "V[3]"}) {
    INFO(name);
    CHECK(verdict(grade, name) == "carried");
  }
  CHECK(verdict(grade, "e[2]") == "correct");
}

TEST_CASE("the right value is correct whatever came before, and then carries as the right one") {
  const auto grader = de_boor_grader();
  const Grade grade = grade_answers(*grader, all_answers(grader->exercise(), {{"alpha[1][3]", "0.5"}}));
  CHECK(verdict(grade, "P[1][3]") == "correct");
  CHECK(verdict(grade, "C") == "correct");
}

TEST_CASE("a rounded value carries: as it was meant, and as it was written down") {
  const auto grader =
      grader_of(exercise_text("de_boor", de_boor_inputs, standards[2].ask, R"(, "tolerance": {"decimals": 2})"));
  // alpha[1][3] = 1/3 by mistake, written as 0.33. With 1/3: P[1][3] = (34/3, 61/3); with 0.33: (11.24, 20.33).
  for (const char* point : {"[11.33, 20.33]", "[11.24, 20.33]"}) {
    INFO(point);
    CHECK(
        verdict(grade_answers(*grader, all_answers(grader->exercise(), {{"alpha[1][3]", "0.33"}, {"P[1][3]", point}})),
                "P[1][3]") == "carried");
  }
  CHECK(verdict(grade_answers(*grader,
                              all_answers(grader->exercise(), {{"alpha[1][3]", "0.33"}, {"P[1][3]", "[11.9, 20.33]"}})),
                "P[1][3]") == "wrong");
  // Right values rounded are no licence: P[1][2] = (8/5, 81/5) by alpha = 0.80.
  CHECK(verdict(grade_answers(*grader,
                              all_answers(grader->exercise(), {{"alpha[1][2]", "0.80"}, {"P[1][2]", "[1.61, 16.2]"}})),
                "P[1][2]") == "wrong");
}

TEST_CASE("carried credit is refused where the own values leave nothing to compute") {
  const auto grader = grader_of(exercise_text(
      "de_casteljau", R"({"curve": {"degree": 3, "points": [[0, 0], [2, 4], [6, 4], [8, 0]]}, "u": "1/2"})",
      R"([{"value": "P[1..3][*]", "points": 2}, {"value": "C", "points": 2}])"));
  for (const char* same : {"[0, 0]", "[5, 7]"}) {
    INFO(same);
    std::map<std::string, std::string> all_same;
    for (const Part& p : grader->exercise().parts) all_same[p.name] = same;
    const Grade grade = grade_answers(*grader, all_answers(grader->exercise(), all_same));
    for (const char* name : {"P[2][0]", "P[2][1]", "P[3][0]"}) CHECK(verdict(grade, name) == "wrong");
    CHECK(grade.points <= Exact(2));  // C is the same point as P[3][0], and copying it is all there is to do
    CHECK(part(grade, "P[2][0]").feedback.find("all equal or zero") != std::string::npos);
  }
  // Of levels nobody asked as well.
  const auto sparse = grader_of(exercise_text(
      "de_casteljau", R"({"curve": {"degree": 3, "points": [[0, 0], [2, 4], [6, 4], [8, 0]]}, "u": "1/2"})",
      R"([{"value": "P[1][*]", "points": 1}, {"value": "C", "points": 1}])"));
  CHECK(verdict(grade_answers(*sparse, R"({"P[1][0]": [5, 7], "P[1][1]": [5, 7], "P[1][2]": [5, 7], "C": [5, 7]})"),
                "C") == "wrong");
}

TEST_CASE("own values that are equal to within the tolerance, zero, or copied by a ratio of 0 earn nothing") {
  const Grader grader = shipped("22-de-boor");
  // What these answers earn, all other points being `rest`.
  const auto points = [&](std::map<std::string, std::string> answers, const std::string& rest) {
    std::string text;
    for (const Part& p : grader.exercise().parts)
      if (p.name.starts_with("P[")) answers.try_emplace(p.name, rest);
    for (const auto& [name, answer] : answers) text += (text.empty() ? "" : ", ") + json_quote(name) + ": " + answer;
    return grade_answers_to(grader, "{" + text + "}").points;
  };
  CHECK(points({{"P[1][2]", "[7, 7]"}, {"P[1][3]", R"(["7.0001", 7])"}}, "[7, 7]") == Exact(0));
  // Rounded values widen what counts as carried, and what counts as a copy with it.
  CHECK(points({{"P[1][2]", R"(["7.00", "7.00"])"}, {"P[1][3]", R"(["7.0035", 7])"}}, "[7, 7]") == Exact(0));
  const std::map<std::string, std::string> no_ratio{{"alpha[1][2]", "0"}, {"alpha[1][3]", "0"}, {"alpha[1][4]", "0"}};
  CHECK(points(no_ratio, "[0, 0]") == Exact(0));
  // With alpha = 0 the points of a level are those of the level before.
  std::map<std::string, std::string> copied = no_ratio;
  copied.insert({{"P[1][2]", "[0, 0]"}, {"P[1][3]", "[0, 20]"}, {"P[1][4]", "[30, 20]"}});
  CHECK(points(copied, "[0, 0]") == Exact(0));
  // And the same through levels that nobody asked.
  const auto sparse = grader_of(exercise_text("de_boor", de_boor_inputs,
                                              R"([{"value": "P[1][*]", "points": 1}, {"value": "C", "points": 1}])",
                                              R"(, "tolerance": {"absolute": 0.001})"));
  CHECK(grade_answers(*sparse, R"({"P[1][2]": [7, 7], "P[1][3]": ["7.0001", 7], "P[1][4]": [7, 7], "C": [7, 7]})")
            .points == Exact(0));
}

TEST_CASE("a list made of parameters that fell on an end or on each other earns nothing") {
  for (const char* id : {"67-skinning-parameters", "67-skinning-hull"}) {
    const Grader grader = shipped(id);
    const auto knots = [&](const std::string& v1, const std::string& v2, const std::string& middle) {
      return part(grade_answers_to(grader, R"({"v[1]": )" + v1 + R"(, "v[2]": )" + v2 + R"(, "V": [0, 0, 0, )" +
                                               middle + ", 1, 1, 1]}"),
                  "V")
          .verdict;
    };
    INFO(id);
    CHECK(knots("0", "0", "0") == Verdict::wrong);
    CHECK(knots("1", "1", "1") == Verdict::wrong);
    CHECK(knots("\"0.25\"", "\"0.25\"", "\"0.25\"") == Verdict::wrong);
    CHECK(knots("\"0.25\"", "\"0.75\"", "\"0.5\"") == Verdict::carried);
  }
  // To within the tolerance, too.
  const Grader hull = shipped("67-skinning-hull");
  for (const char* answers : {R"({"v[1]": 0, "v[2]": 0.0004, "V": [0, 0, 0, 0.0002, 1, 1, 1]})",
                              R"({"v[1]": 0.3, "v[2]": 0.3001, "V": [0, 0, 0, 0.3, 1, 1, 1]})"})
    CHECK(grade_answers_to(hull, answers).points == Exact(0));
}

TEST_CASE("points that coincide in the exercise itself are no trick") {
  const auto grader = grader_of(
      exercise_text("de_casteljau", R"({"curve": {"degree": 2, "points": [[0, 0], [2, 2], [2, 2]]}, "u": "1/2"})",
                    R"([{"value": "P[1..2][*]", "points": 1}, {"value": "C", "points": 1}])"));
  const Grade grade =
      grade_answers(*grader, R"({"P[1][0]": [5, 3], "P[1][1]": [2, 2], "P[2][0]": [3.5, 2.5], "C": [3.5, 2.5]})");
  CHECK(verdict(grade, "P[2][0]") == "carried");
  CHECK(verdict(grade, "C") == "carried");
}

TEST_CASE("slips: a sign, all signs, exchanged coordinates, transposed digits") {
  const auto grader = grader_of(
      exercise_text("de_casteljau", R"({"curve": {"degree": 2, "points": [[0, 10], [24, 44], [22, 22]]}, "u": "1/2"})",
                    R"([{"value": "P[1..2][*]", "points": 1}])", R"(, "partial": {"slip": "1/4"})"));
  // P1 = (12, 27) (23, 33); P2 = (35/2, 30).
  const auto slip = [&](const char* answer) {
    return part(grade_answers(*grader, std::string(R"({"P[1][0]": )") + answer + "}"), "P[1][0]");
  };
  CHECK(slip("[-12, 27]").feedback.starts_with("The sign of x is wrong."));
  CHECK(slip("[12, -27]").feedback.starts_with("The sign of y is wrong."));
  CHECK(slip("[-12, -27]").feedback.starts_with("All signs are wrong."));
  CHECK(slip("[27, 12]").feedback.starts_with("Two numbers are exchanged: x and y."));
  CHECK(slip("[12, 72]").feedback.starts_with("Two digits are transposed in y."));
  CHECK(slip("[12, 72]").verdict == Verdict::slip);
  CHECK(slip("[12, 72]").points == Exact::ratio(1, 4));
  CHECK(slip("[13, 28]").verdict == Verdict::wrong);
  // With a tolerance the digits that count must be those of the right number; those behind them explain nothing.
  const auto rounded =
      grader_of(exercise_text("de_casteljau", R"({"curve": {"degree": 1, "points": [[0, 0], [32, 40]]}, "u": "1/2"})",
                              R"([{"value": "P[1][0]", "points": 1}])", R"(, "tolerance": {"absolute": "0.001"})"));
  CHECK(verdict(grade_answers(*rounded, R"({"P[1][0]": ["16.0010000001", 20]})"), "P[1][0]") == "wrong");
  CHECK(verdict(grade_answers(*rounded, R"({"P[1][0]": ["61", 20]})"), "P[1][0]") == "slip");
  CHECK(verdict(grade_answers(*rounded, R"({"P[1][0]": ["61.0", 20]})"), "P[1][0]") == "slip");
  const auto thirds =
      grader_of(exercise_text("de_casteljau", R"({"curve": {"degree": 1, "points": [[0, 0], [14, 4]]}, "u": "1/3"})",
                              R"([{"value": "P[1][0]", "points": 1}])", R"(, "tolerance": {"decimals": 2})"));
  CHECK(verdict(grade_answers(*thirds, R"({"P[1][0]": ["4.76", 1.33]})"), "P[1][0]") == "slip");  // 4.67
  CHECK(verdict(grade_answers(*thirds, R"({"P[1][0]": ["4.76", 1.3]})"), "P[1][0]") == "wrong");
  // A slip is also told from what the own values make expected: P[1][0] = (14, 27) makes P[2][0] = (37/2, 30).
  CHECK(verdict(grade_answers(*grader, R"({"P[1][0]": [14, 27], "P[1][1]": [23, 33], "P[2][0]": [-18.5, 30]})"),
                "P[2][0]") == "slip");
}

TEST_CASE("missing and invalid parts, with the reason") {
  const auto grader = de_boor_grader();
  const auto invalid = [&](const char* name, const char* answer) {
    const Grade grade = grade_answers(*grader, "{" + json_quote(name) + ": " + answer + "}");
    INFO(name << " " << answer);
    CHECK(verdict(grade, name) == "invalid");
    CHECK(grade.reason.empty());
    CHECK(grade.points == Exact(0));
    return part(grade, name).feedback;
  };
  CHECK(invalid("k", "[4]").find("must be a whole number such as 3, not an array of 1") != std::string::npos);
  CHECK(invalid("P[1][2]", "[1, 2, 3]").find("must be an array of 2 numbers") != std::string::npos);
  CHECK(invalid("P[1][2]", "{\"x\": 1, \"y\": 2}").find("not an object") != std::string::npos);
  for (const char* answer : {"null", "true", "\"NaN\"", "\"1/0\"", "\"1e999999999\"", "\"\"", "\"four\"", "{}", "[]",
                             "[[4]]", "\"1 000\"", "\"0x4\"", "\"inf\""})
    invalid("k", answer);
  invalid("k", ("\"" + std::string(10000, '7') + "\"").c_str());
  invalid("P[1][2]", "[1, null]");
  invalid("P[1][2]", "[1, [2]]");
  invalid("P[1][2]", "[1, \"2/0\"]");
  const Grade empty = grade_answers(*grader, "{}");
  for (const PartGrade& p : empty.parts) CHECK(p.verdict == Verdict::missing);
  CHECK(empty.score() == 0);
}

TEST_CASE("what cannot be read as a number is told with what to write") {
  const auto grader = de_boor_grader();
  const auto told = [&](const std::string& answer) {
    return part(grade_answers(*grader, "{\"k\": " + json_quote(answer) + "}"), "k").feedback;
  };
  CHECK(told("3,625").find("a comma for its decimal point: write \"3.625\"") != std::string::npos);
  CHECK(told("30 ").find("a blank in it: write \"30\"") != std::string::npos);
  CHECK(told("four").find("no number such as 0.4") != std::string::npos);
  CHECK(told("four").find("400") == std::string::npos);
  CHECK(told(std::string(401, '7')).find("400 characters") != std::string::npos);
}

TEST_CASE("of a number that is near but not near enough the accuracy that is asked is told") {
  const auto feedback = [](const std::string& tolerance, const std::string& k) {
    const auto grader = grader_of(exercise_text("de_boor", de_boor_inputs, R"([{"value": "alpha[1][2]", "points": 1}])",
                                                R"(, "tolerance": )" + tolerance));
    return part(grade_answers(*grader, "{\"alpha[1][2]\": " + k + "}"), "alpha[1][2]").feedback;
  };
  // alpha[1][2] = (2/5 - 0) / (1/2 - 0) = 4/5
  CHECK(feedback(R"({"decimals": 3})", "0.804").find("Near, but 3 decimals are asked.") != std::string::npos);
  CHECK(feedback(R"({"significant": 1})", "0.9").find("Near, but 1 significant digit is asked.") != std::string::npos);
  CHECK(feedback(R"({"absolute": 0.001})", "0.81").find("off by at most 0.001") != std::string::npos);
  CHECK(feedback(R"({"relative": 0.01})", "0.82").find("off by at most 1 %") != std::string::npos);
  CHECK(feedback(R"({"decimals": 3})", "0.82").find("Near") == std::string::npos);
  CHECK(feedback("\"exact\"", "0.804").find("Near") == std::string::npos);
}

TEST_CASE("a file that is no answers file is told in one sentence") {
  const auto grader = de_boor_grader();
  const auto reason = [&](const std::string& text) { return grade_text(*grader, text).reason; };
  CHECK(reason(R"({"schema": "blossom.answers/1", "exercise": "test", "answer": {}})") ==
        "\"answers\" is missing; did you mean it by \"answer\"?");
  CHECK(reason(R"({"schema": "blossom.exercise/1", "id": "test"})") == "is an exercise, not an answers file");
  CHECK(reason(std::string("PK\x03\x04\0\0", 6)).find("zip archive or an office document") != std::string::npos);
  CHECK(reason("%PDF-1.7").find("a PDF document, not JSON") != std::string::npos);
}

TEST_CASE("an answer nobody asked is a note, and costs nothing") {
  const auto grader = de_boor_grader();
  const Grade grade = grade_answers(*grader, R"({"P[1][02]": 1, "k": 4, "zzz\u001b[2J": 2})");
  CHECK(verdict(grade, "k") == "correct");
  REQUIRE(grade.notes.size() == 2);
  CHECK(grade.notes[0] == "\"P[1][02]\" is not asked and was ignored; did you mean \"P[1][2]\"?");
  // What is given or exists is no misspelling; another index is no typing mistake.
  const Grade other = grade_answers(
      *grader,
      R"({"P[0][1]": [0, 1], "P[9][9]": 1, "p[1][3]": 1, "P[1,3]": 1, "alhpa[1][3]": 1, "U[3]": 0, "P13": 1})");
  CHECK(other.notes ==
        std::vector<std::string>{"\"P[0][1]\" is given and was ignored", "\"P[9][9]\" is not asked and was ignored",
                                 "\"P[1,3]\" is not asked and was ignored; did you mean \"P[1][3]\"?",
                                 "\"alhpa[1][3]\" is not asked and was ignored; did you mean \"alpha[1][3]\"?",
                                 "\"U[3]\" is given and was ignored", "\"P13\" is not asked and was ignored"});
  CHECK(part(other, "P[1][3]").feedback.starts_with("No answer under P[1][3]; you wrote \"p[1][3]\"."));
  CHECK(part(other, "P[1][3]").note == "letter-case");
  CHECK(verdict(other, "P[1][3]") == "missing");
  CHECK(part(other, "P[1][2]").note.empty());
  std::string many = "{";
  for (int i = 0; i < 100; ++i) many += (i > 0 ? ", \"x" : "\"x") + std::to_string(i) + "\": 1";
  CHECK(grade_answers(*grader, many + "}").notes.back() == "90 more were ignored");
}

TEST_CASE("knot vectors are lists, or sets where the exercise says so") {
  const auto grader =
      grader_of(exercise_text("knot_insertion", insertion_inputs, R"([{"value": "Ubar", "points": 1, "as": "set"}])"));
  const auto list = grader_of(exercise_text("knot_insertion", insertion_inputs, R"([{"value": "Ubar", "points": 1}])"));
  const std::string in_order = R"([0, 0, 0, 0, 0.25, 0.4, 0.4, 0.5, 0.75, 1, 1, 1, 1])";
  const std::string mixed = R"([0.4, 1, 1, 1, 1, 0, 0.25, 0, 0, 0.4, 0, 0.5, 0.75])";
  const std::string once = R"([0, 0, 0, 0, 0.25, 0.4, 0.5, 0.75, 1, 1, 1, 1])";
  CHECK(verdict(grade_answers(*list, R"({"Ubar": )" + in_order + "}"), "Ubar") == "correct");
  CHECK(verdict(grade_answers(*list, R"({"Ubar": )" + mixed + "}"), "Ubar") == "wrong");
  CHECK(verdict(grade_answers(*list, R"({"Ubar": )" + once + "}"), "Ubar") == "wrong");
  CHECK(verdict(grade_answers(*list, R"({"Ubar": []})"), "Ubar") == "wrong");
  CHECK(verdict(grade_answers(*grader, R"({"Ubar": )" + mixed + "}"), "Ubar") == "correct");
  CHECK(verdict(grade_answers(*grader, R"({"Ubar": {"set": )" + mixed + "}}"), "Ubar") == "correct");
  CHECK(verdict(grade_answers(*grader, R"({"Ubar": {"set": )" + once + "}}"), "Ubar") ==
        "wrong");  // multiplicity counts
  CHECK(verdict(grade_answers(*grader, R"({"Ubar": {"sets": []}})"), "Ubar") == "invalid");
}

TEST_CASE("each ask may have its own tolerance") {
  const auto grader = grader_of(exercise_text("de_boor", de_boor_inputs,
                                              R"([{"value": "alpha[1][3]", "points": 1},
                                                  {"value": "alpha[2][4]", "points": 1, "tolerance": {"absolute": "1/50"}}])",
                                              R"(, "tolerance": {"decimals": 2})"));
  const Grade grade = grade_answers(*grader, R"({"alpha[1][3]": 0.53, "alpha[2][4]": 0.32})");  // 8/15 and 3/10
  CHECK(verdict(grade, "alpha[1][3]") == "correct");
  CHECK(verdict(grade, "alpha[2][4]") == "correct");
}

TEST_CASE("feedback tells as much as the exercise allows") {
  const auto told = [](const char* level) {
    const auto grader = de_boor_grader(std::string(R"(, "feedback": ")") + level + "\"");
    return part(grade_answers(*grader, R"({"alpha[1][3]": 0.7})"), "alpha[1][3]").feedback;
  };
  CHECK(told("none").empty());
  CHECK(told("verdict").empty());
  CHECK(told("hint") == "Not the right value. The rule is alpha[1][3] = (u - u_3) / (u_6 - u_3).");
  CHECK(told("full").starts_with("Not the right value. Right is alpha[1][3] = (u - u_3) / (u_6 - u_3) = "));
  CHECK(told("full").ends_with(" = 8/15."));
}

TEST_CASE("a rule is told if it helps: in words as words, and none of names that nobody was asked for") {
  const auto told = [](const std::string& algorithm, const std::string& inputs, const std::string& value,
                       const std::string& level, const std::string& more = "") {
    const auto grader =
        grader_of(exercise_text(algorithm, inputs, "[{\"value\": \"" + value + "\", \"points\": 1}" + more + "]",
                                ", \"feedback\": \"" + level + "\""));
    return part(grade_answers(*grader, "{}"), value).feedback;
  };
  CHECK(told("de_boor", de_boor_inputs, "k", "hint") == "No answer. It is the index k of the span of U that holds u.");
  const std::string surface =
      R"({"surface": {"degree": [1, 2], "points": [[[0, 0, 0], [0, 2, 4], [0, 8, 8]],
                      [[6, 0, 4], [6, 2, 6], [6, 8, 4]]]}, "direction": "v", "t": "1/2"})";
  CHECK(told("surface_subdivision", surface, "L[0][1]", "hint") == "No answer.");
  CHECK(told("surface_subdivision", surface, "L[0][1]", "full") == "No answer. Right is L[0][1] = (0, 1, 2).");
  const std::string row = R"(, {"value": "row[0].Q[1][1]", "points": 1})";
  CHECK(told("surface_subdivision", surface, "L[0][1]", "hint", row) ==
        "No answer. The rule is L[0][1] = row[0].Q[1][1].");
}
