// Each misconception of each algorithm's list is found: where it is answered, where it is not asked but its effect is,
// and on the student's own earlier values.

#include <set>

#include "grader/helpers.hpp"
#include "kernel/span.hpp"

using namespace blossom;

namespace {

// The right values, as somebody who made no mistake before has them.
class RightSite final : public Site {
 public:
  RightSite(const Run<Exact>& run, ValueId v) : run_(&run), value_(v) {}
  const Trace<Exact>& trace() const override { return run_->trace; }
  const Inputs<Exact>& inputs() const override { return run_->inputs; }
  ValueId value() const override { return value_; }
  NumbersView<Exact> numbers(ValueId v) const override { return run_->trace.numbers(v); }

 private:
  const Run<Exact>* run_;
  ValueId value_;
};

std::string found_id(const Grade& grade, const std::string& name) {
  const PartGrade& p = part(grade, name);
  return p.verdict == Verdict::misconception ? std::string(p.misconception) : std::string(verdict_name(p.verdict));
}

}  // namespace

TEST_CASE("every misconception of every algorithm is found where it is answered") {
  std::set<std::string> found;
  for (const Standard& s : standards) {
    const auto grader = grader_of(exercise_text(s.algorithm, s.inputs, s.ask, R"(, "tolerance": {"decimals": 6})"));
    const Exercise& exercise = grader->exercise();
    for (const Misconception& misconception : exercise.run.algorithm->misconceptions)
      for (const Part& asked : exercise.parts)
        for (const auto& candidate : misconception.wrong(RightSite(exercise.run, asked.value))) {
          const auto typed = asked.as_typed(candidate);
          if (typed.empty() || agrees(asked, exercise.run.trace.numbers(asked.value), typed)) continue;
          const Grade grade = grade_answers(*grader, all_answers(exercise, {{asked.name, typed_text(asked, typed)}}));
          INFO(s.algorithm << " " << misconception.id << " at " << asked.name);
          // Two of them may give the same number at one place; it is never called anything else.
          CHECK(verdict(grade, asked.name) == "misconception");
          if (found_id(grade, asked.name) == misconception.id) {
            found.insert(std::string(s.algorithm) + " " + std::string(misconception.id));
            CHECK(part(grade, asked.name).feedback.find(misconception.advice) != std::string::npos);
          }
        }
  }
  // At some place each of them is the one that is named.
  for (const Algorithm* algorithm : algorithms())
    for (const Misconception& misconception : algorithm->misconceptions) {
      const std::string expected = std::string(algorithm->id) + " " + std::string(misconception.id);
      INFO(expected);
      CHECK(found.contains(expected));
    }
}

TEST_CASE("a misconception in ratios nobody asked shows in the points") {
  const auto grader = grader_of(exercise_text("de_boor", de_boor_inputs, R"([{"value": "P[2..3][*]", "points": 1}])"));
  // By hand, with alpha[r][i] = (u - u_i) / (u_{i+p} - u_i) on every level: 4/5, 8/15, 1/5; 8/15, 1/5; 1/5.
  const auto& curve = grader->exercise().run.inputs.curve("curve");
  const Exact u = Exact::ratio(2, 5);
  std::vector<HPoint<Exact>> P = curve.points;
  std::map<std::string, std::string> wrong;
  for (int r = 1; r <= 3; ++r)
    for (int i = 4; i >= 1 + r; --i) {
      const Exact alpha = (u - curve.knots[i]) / (curve.knots[i + 3] - curve.knots[i]);
      P[i] = (Exact(1) - alpha) * P[i - 1] + alpha * P[i];
      wrong["P[" + std::to_string(r) + "][" + std::to_string(i) + "]"] =
          "[\"" + P[i].x.to_string() + "\", \"" + P[i].y.to_string() + "\"]";
    }
  const Grade grade = grade_answers(*grader, all_answers(grader->exercise(), wrong));
  CHECK(found_id(grade, "P[2][3]") == "neighbour-knot");
  CHECK(found_id(grade, "P[2][4]") == "neighbour-knot");
  CHECK(found_id(grade, "P[3][4]") == "neighbour-knot");
}

TEST_CASE("swapped weights throughout show in the result alone") {
  const auto grader = grader_of(exercise_text("de_casteljau", de_casteljau_inputs, R"([{"value": "C", "points": 1}])"));
  // The curve at 1 - u = 3/5: Bernstein weights 8, 36, 54, 27 over 125.
  CHECK(found_id(grade_answers(*grader, R"({"C": ["414/125", "351/125"]})"), "C") == "swapped-weights");
}

TEST_CASE("a misconception on the student's own values is found") {
  const auto grader = grader_of(
      exercise_text("de_casteljau", R"({"curve": {"degree": 2, "points": [[0, 0], [3, 6], [9, 3]]}, "u": "1/3"})",
                    R"([{"value": "P[1..2][*]", "points": 1}])"));
  // Right: (1, 2) (5, 5); (7/3, 3). Own P[1][0] = (2, 2), then weights swapped: 1/3 (2, 2) + 2/3 (5, 5).
  const Grade grade = grade_answers(*grader, R"({"P[1][0]": [2.5, 2], "P[1][1]": [5, 5], "P[2][0]": ["25/6", 4]})");
  CHECK(found_id(grade, "P[1][0]") == "wrong");
  CHECK(found_id(grade, "P[2][0]") == "swapped-weights");
}

TEST_CASE("the division by the weight forgotten in every answer is found in every one") {
  const auto grader = grader_of(exercise_text("de_casteljau", rational_bezier_inputs, standards[1].ask));
  const Exercise& exercise = grader->exercise();
  std::map<std::string, std::string> undivided;
  for (const Part& p : exercise.parts) {
    const auto numbers =
        exercise.run.trace.numbers(p.name == "C" ? exercise.parts[*exercise.part("P[3][0]")].value : p.value);
    undivided[p.name] = "[" + json_quote(numbers[0].to_string()) + ", " + json_quote(numbers[1].to_string()) + "]";
  }
  const Grade grade = grade_answers(*grader, all_answers(exercise, undivided));
  for (const Part& p : exercise.parts)
    if (p.name != "C") CHECK(found_id(grade, p.name) == "missing-division");
}

TEST_CASE("a control point that enters with its own coordinates, not multiplied by the weight") {
  // P[1][1] = 2/3 (1, 1, 1) + 1/3 (0, 1, 2) with (0, 1, 2) for (0, 2, 2).
  const auto grader = shipped("40-rational-quarter-circle");
  const Grade grade = grade_answers_to(grader, R"({"P[1][0]": [1, "1/3", 1], "P[1][1]": ["2/3", 1, "4/3"]})");
  CHECK(found_id(grade, "P[1][1]") == "unweighted-coordinates");
  // The equation ends in what is asked.
  CHECK(part(grade, "P[1][1]").feedback.ends_with("(1 - 1/3) (1, 1, 1) + 1/3 (0, 2, 2) = (2/3, 4/3, 4/3)."));
}

TEST_CASE("the triangle of another span is said to be that") {
  const auto grader = shipped("22-de-boor");
  const char* const answers = R"({"k": 3, "alpha[1][1]": "8/5", "P[1][1]": [-6, 0], "alpha[1][2]": "4/5",
      "P[1][2]": [0, 16], "alpha[1][3]": "8/15", "P[1][3]": [16, 20], "P[2][2]": ["18/5", "128/5"],
      "P[2][3]": ["64/5", "96/5"], "P[3][3]": ["458/25", "384/25"])";
  const Grade grade = grade_answers_to(grader, answers + std::string("}"));
  const auto says = [](const Grade& made, const char* name) {
    return part(made, name).feedback.find("computed the triangle of the span k = 3") != std::string::npos;
  };
  for (const char* name : {"k", "alpha[1][4]", "P[1][4]", "P[2][4]", "P[3][4]"}) CHECK(says(grade, name));
  CHECK(verdict(grade, "P[3][4]") == "missing");
  // Something else was handed in, too; or nothing of that span.
  CHECK(!says(grade_answers_to(grader, answers + std::string(R"(, "P[9][9]": 1})")), "k"));
  CHECK(!says(grade_answers_to(grader, R"({"k": 3})"), "k"));
}

TEST_CASE("the span one too early, at a knot and between knots") {
  const auto grader = grader_of(exercise_text("de_boor", de_boor_inputs,
                                              R"([{"value": "k", "points": 1}, {"value": "C", "points": 1}])",
                                              R"(, "partial": {"misconception": 0.5})"));
  const Grade grade = grade_answers(*grader, R"({"k": 5})");
  CHECK(found_id(grade, "k") == "wrong-span");
  CHECK(grade.points == Exact::ratio(1, 2));
  CHECK(found_id(grade_answers(*grader, R"({"k": 3})"), "k") == "wrong-span");
  CHECK(found_id(grade_answers(*grader, R"({"k": 9})"), "k") == "wrong");
}

TEST_CASE("elevation with i/p, swapped weights, and knots not raised") {
  const auto grader = grader_of(exercise_text("degree_elevation",
                                              R"({"curve": {"degree": 3, "points": [[0, 0], [3, 9], [6, 0], [9, 3]]}})",
                                              R"([{"value": "Q[*]", "points": 1}])"));
  // Right: Q[1] = 1/4 P0 + 3/4 P1 = (9/4, 27/4). With 1/3: (2, 6). Swapped: (3/4, 9/4).
  CHECK(found_id(grade_answers(*grader, R"({"Q[1]": [2, 6]})"), "Q[1]") == "elevation-ratio");
  CHECK(found_id(grade_answers(*grader, R"({"Q[1]": [0.75, 2.25]})"), "Q[1]") == "swapped-weights");
}
