// One explanation of the whole answer: students who hold one misconception or two throughout, with slips, gaps and
// rounding, and answers that are nothing but noise.

#include <random>
#include <set>

#include "grader/helpers.hpp"

using namespace blossom;

namespace {

// What somebody has who makes every value by these wrong rules where the first of them applies, and by the right rule
// on what they have elsewhere. Made from the trace alone.
class Student final : public Site {
 public:
  Student(const Exercise& exercise, const std::vector<const Misconception*>& holds) : run_(&exercise.run) {
    const auto& trace = run_->trace;
    own_.resize(trace.value_count());
    for (value_ = 0; value_ < trace.value_count(); ++value_) {
      if (trace.is_input(value_)) {
        const auto given = trace.numbers(value_);
        own_[value_].assign(given.begin(), given.end());
        continue;
      }
      std::vector<NumbersView<Exact>> operands;
      for (const ValueId o : trace.operands(value_)) operands.push_back(own_[o]);
      if (!trace.value(value_).rule->replay<Exact>()(operands, own_[value_])) own_[value_].clear();
      for (const Misconception* m : holds)
        if (auto wrong = m->wrong(*this); !wrong.empty()) {
          own_[value_] = std::move(wrong.front());
          break;
        }
    }
  }
  const Trace<Exact>& trace() const override { return run_->trace; }
  const Inputs<Exact>& inputs() const override { return run_->inputs; }
  ValueId value() const override { return value_; }
  NumbersView<Exact> numbers(ValueId v) const override {
    return own_[v].empty() ? run_->trace.numbers(v) : NumbersView<Exact>(own_[v]);
  }

 private:
  const Run<Exact>* run_;
  ValueId value_ = 0;
  std::vector<Numbers<Exact>> own_;
};

using Answered = std::map<std::string, std::string>;

Answered answers_of(const Exercise& exercise, const std::vector<const Misconception*>& holds) {
  const Student student(exercise, holds);
  Answered answers;
  for (const Part& part : exercise.parts) {
    const auto typed = part.as_typed(student.numbers(part.value));
    answers[part.name] = typed_text(part, typed.empty() ? part.right : typed);
  }
  return answers;
}

// The same rounded to so many decimals, as it is written down.
Answered rounded(const Exercise& exercise, const std::vector<const Misconception*>& holds, int decimals) {
  const Student student(exercise, holds);
  Answered answers;
  for (const Part& part : exercise.parts) {
    std::string text;
    for (const Exact& x : part.as_typed(student.numbers(part.value))) {
      char digits[40];
      std::snprintf(digits, sizeof digits, "%.*f", part.kind == ValueKind::integer ? 0 : decimals, x.to_double());
      text += (text.empty() ? "" : ", ") + std::string(digits);
    }
    answers[part.name] = part.is_single() ? text : "[" + text + "]";
  }
  return answers;
}

std::string json_of(const Answered& answers) {
  std::string text = "{";
  for (const auto& [name, answer] : answers) text += (text.size() > 1 ? ", " : "") + json_quote(name) + ": " + answer;
  return text + "}";
}

// "swapped-weights wrong-span", "unknown", or nothing.
std::string explained(const Grade& grade) {
  if (!grade.explanation) return {};
  std::string ids;
  for (const Misconception* m : grade.explanation->misconceptions) ids += (ids.empty() ? "" : " ") + std::string(m->id);
  return ids.empty() ? "unknown" : ids;
}

const Misconception* known(const Exercise& exercise, std::string_view id) {
  for (const Misconception& m : exercise.run.algorithm->misconceptions)
    if (m.id == id) return &m;
  FAIL("no misconception " << id);
  return nullptr;
}

std::unique_ptr<Grader> standard(const Standard& s, const std::string& more = "") {
  return grader_of(exercise_text(s.algorithm, s.inputs, s.ask, R"(, "tolerance": {"decimals": 6})" + more));
}

}  // namespace

TEST_CASE("every misconception held throughout is the explanation, or one that makes the same answers") {
  // They show in whole numbers alone: in a span, in how often a sign changes.
  const std::set<std::string> only_whole{"knot_insertion wrong-span", "projection wrong-span",
                                         "variation_diminishing zero-counted", "variation_diminishing points-counted"};
  std::set<std::string> named;
  for (const Standard& s : standards) {
    const auto grader = standard(s);
    const Exercise& exercise = grader->exercise();
    for (const Misconception& m : exercise.run.algorithm->misconceptions) {
      const auto answers = answers_of(exercise, {&m});
      const Grade grade = grade_answers(*grader, json_of(answers));
      if (!grade.explanation) continue;  // it does not show in these numbers
      INFO(s.algorithm << " " << m.id << ": " << explained(grade) << ", " << grade.explanation->covered << " of "
                       << grade.explanation->wrong << ", chance " << grade.explanation->chance);
      const std::string id(m.id);
      // A whole number off by one is not enough to say that somebody holds something.
      const bool whole = std::ranges::all_of(exercise.parts, [&](const Part& p) {
        const Verdict v = part(grade, p.name).verdict;
        return v == Verdict::correct || v == Verdict::carried || p.kind == ValueKind::integer;
      });
      if (whole) {
        CHECK(explained(grade) == "unknown");
        continue;
      }
      CHECK(grade.explanation->covered == grade.explanation->wrong);
      CHECK((explained(grade) == id ||
             json_of(answers_of(exercise, {known(exercise, explained(grade))})) == json_of(answers)));
      if (explained(grade) == id) named.insert(std::string(s.algorithm) + " " + id);
      CHECK(std::ranges::count(grade.parts, "unknown", &PartGrade::note) == 0);
    }
  }
  for (const Algorithm* algorithm : algorithms())
    for (const Misconception& m : algorithm->misconceptions) {
      const std::string expected = std::string(algorithm->id) + " " + std::string(m.id);
      INFO(expected);
      if (!only_whole.contains(expected)) CHECK(named.contains(expected));
    }
}

TEST_CASE("every pair of misconceptions held throughout is found, or what makes as many of the answers") {
  std::size_t found = 0, tried = 0;
  for (const Standard& s : standards) {
    const auto grader = standard(s);
    const Exercise& exercise = grader->exercise();
    const auto& list = exercise.run.algorithm->misconceptions;
    for (std::size_t a = 0; a < list.size(); ++a)
      for (std::size_t b = a + 1; b < list.size(); ++b) {
        const auto answers = answers_of(exercise, {&list[a], &list[b]});
        // Where one hides the other there is no pair to be found.
        if (answers == answers_of(exercise, {&list[a]}) || answers == answers_of(exercise, {&list[b]})) continue;
        const Grade grade = grade_answers(*grader, json_of(answers));
        REQUIRE(grade.explanation);
        INFO(s.algorithm << " " << list[a].id << " + " << list[b].id << ": " << explained(grade) << ", "
                         << grade.explanation->covered << " of " << grade.explanation->wrong << ", chance "
                         << grade.explanation->chance);
        ++tried;
        const bool both = explained(grade) == std::string(list[a].id) + " " + std::string(list[b].id);
        found += both ? 1 : 0;
        CHECK(explained(grade) != "unknown");
        // What one of the two makes only once may be too little to claim it; the value is named for itself.
        CHECK(grade.explanation->covered + (both ? 0 : 1) == grade.explanation->wrong);
      }
  }
  INFO(found << " of " << tried);
  CHECK(3 * found >= 2 * tried);
}

TEST_CASE("swapped weights and a wrong span together are named value by value") {
  const auto grader = standard(standards[2], R"(, "partial": {"misconception": "1/2"})");
  const Exercise& exercise = grader->exercise();
  const auto answers = answers_of(exercise, {known(exercise, "swapped-weights"), known(exercise, "wrong-span")});
  const Grade grade = grade_answers(*grader, json_of(answers));
  CHECK(explained(grade) == "swapped-weights wrong-span");
  for (const char* name : {"P[1][2]", "P[2][3]", "P[3][4]"})
    CHECK(part(grade, name).misconception == "swapped-weights");
  for (const char* name : {"k", "C"}) CHECK(part(grade, name).misconception == "wrong-span");
}

TEST_CASE("two misconceptions in one value that no single one explains") {
  // Ratios by the wrong knots, then the weights swapped; only the result is asked.
  const auto grader = grader_of(exercise_text("de_boor", de_boor_inputs, R"([{"value": "C", "points": 1}])",
                                              R"(, "partial": {"misconception": 1})"));
  const Exercise& exercise = grader->exercise();
  const Grade grade = grade_answers(
      *grader, json_of(answers_of(exercise, {known(exercise, "swapped-weights"), known(exercise, "neighbour-knot")})));
  CHECK(explained(grade) == "swapped-weights neighbour-knot");
  CHECK(verdict(grade, "C") == "misconception");
  CHECK(part(grade, "C").points == Exact(0));  // the share is for what one wrong rule makes
}

TEST_CASE("one misconception throughout and one slip: the misconception, and one value that it does not cover") {
  const auto grader = grader_of(exercise_text("de_casteljau", de_casteljau_inputs, standards[0].ask));
  const Exercise& exercise = grader->exercise();
  auto answers = answers_of(exercise, {known(exercise, "swapped-weights")});
  answers["P[1][1]"] = R"(["-14/5", "17/5"])";  // right: (11/5, 17/5)
  const Grade grade = grade_answers(*grader, json_of(answers));
  CHECK(explained(grade) == "swapped-weights");
  CHECK(grade.explanation->wrong == grade.explanation->covered + 1);
  CHECK(verdict(grade, "P[1][1]") == "wrong");
  CHECK(part(grade, "P[1][1]").note == "arithmetic");
}

TEST_CASE("rounded answers show a misconception, whether they went on with what they wrote down or not") {
  const auto grader = grader_of(exercise_text(
      "de_boor", de_boor_inputs, R"([{"value": "alpha[*][*]", "points": 1}, {"value": "P[1..3][*]", "points": 1}])",
      R"(, "tolerance": {"decimals": 2})"));
  const Exercise& exercise = grader->exercise();
  const auto* swapped = known(exercise, "swapped-weights");
  const Grade kept = grade_answers(*grader, json_of(rounded(exercise, {swapped}, 2)));
  CHECK(explained(kept) == "swapped-weights");
  CHECK(kept.explanation->covered == 6);
  // By hand with two decimals at each step: alpha = 0.80, 0.53, 0.20; 0.80, 0.30; 0.60.
  const double alpha[4][5] = {{}, {0, 0, 0.80, 0.53, 0.20}, {0, 0, 0, 0.80, 0.30}, {0, 0, 0, 0, 0.60}};
  double P[5][2] = {{10, 0}, {0, 1}, {2, 20}, {30, 21}, {33, 0}};
  auto answers = rounded(exercise, {swapped}, 2);
  for (int r = 1; r <= 3; ++r)
    for (int i = 4; i > r; --i) {
      char text[60];
      for (int c = 0; c < 2; ++c) {
        std::snprintf(text, sizeof text, "%.2f", alpha[r][i] * P[i - 1][c] + (1 - alpha[r][i]) * P[i][c]);
        P[i][c] = std::strtod(text, nullptr);
      }
      std::snprintf(text, sizeof text, "[%.2f, %.2f]", P[i][0], P[i][1]);
      answers["P[" + std::to_string(r) + "][" + std::to_string(i) + "]"] = text;
    }
  const Grade again = grade_answers(*grader, json_of(answers));
  CHECK(explained(again) == "swapped-weights");
  CHECK(again.explanation->covered == again.explanation->wrong);
}

TEST_CASE("answers that are partly missing are explained by what is there") {
  const auto grader = grader_of(exercise_text("de_casteljau", de_casteljau_inputs, standards[0].ask));
  const Exercise& exercise = grader->exercise();
  auto answers = answers_of(exercise, {known(exercise, "swapped-weights")});
  for (const char* name : {"P[1][0]", "P[1][2]", "P[2][1]"}) answers.erase(name);
  const Grade grade = grade_answers(*grader, json_of(answers));
  CHECK(explained(grade) == "swapped-weights");
  CHECK(grade.explanation->covered == grade.explanation->wrong);
  CHECK(verdict(grade, "P[1][0]") == "missing");
}

TEST_CASE("a whole number off by one is named, but is no explanation; nothing wrong needs none") {
  const auto grader = standard(standards[2]);
  Grade grade = grade_answers(*grader, all_answers(grader->exercise(), {{"k", "3"}}));
  CHECK(part(grade, "k").note == "wrong-span");
  CHECK(explained(grade) == "unknown");
  grade = grade_answers(*grader, all_answers(grader->exercise()));
  CHECK(!grade.explanation);
  CHECK(!grade_answers(*grader, "{}").explanation);
  CHECK(!grade_text(*grader, "nothing").explanation);
}

TEST_CASE("of answers that are noise at most every twentieth gets a name") {
  const unsigned seed = 20260704;
  INFO("seed " << seed);
  std::mt19937 random(seed);
  for (const char* tolerance : {R"("exact")", R"({"decimals": 3})", R"({"absolute": "0.09"})"}) {
    for (const Standard& s : {standards[0], standards[2], standards[5]}) {
      const auto grader =
          grader_of(exercise_text(s.algorithm, s.inputs, s.ask, std::string(R"(, "tolerance": )") + tolerance));
      const Exercise& exercise = grader->exercise();
      int named = 0;
      for (int round = 0; round < 1000; ++round) {
        Answered answers;
        for (const Part& p : exercise.parts) {
          Numbers<Exact> typed;
          const auto number = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
          const int denominator = 1 + number(10);
          for (std::size_t i = 0; i < p.right.size(); ++i)
            typed.push_back(p.kind == ValueKind::integer  ? Exact(number(8))
                            : p.kind == ValueKind::scalar ? Exact::ratio(number(denominator + 1), denominator)
                            : p.kind == ValueKind::list   ? Exact::ratio(number(5), 4)
                                                          : Exact::ratio(number(35 * denominator), denominator));
          answers[p.name] = typed_text(p, typed);
        }
        const Grade grade = grade_answers(*grader, json_of(answers));
        if (grade.explanation && !grade.explanation->misconceptions.empty()) ++named;
      }
      INFO(s.algorithm << " " << tolerance);
      CHECK(named <= 50);
    }
  }
}

TEST_CASE("one name for one misconception, where another one gives a value too") {
  for (const Standard& s : standards) {
    const auto grader = standard(s);
    const Exercise& exercise = grader->exercise();
    for (const Misconception& m : exercise.run.algorithm->misconceptions) {
      const Grade grade = grade_answers(*grader, json_of(answers_of(exercise, {&m})));
      if (!grade.explanation || grade.explanation->misconceptions.size() != 1) continue;
      INFO(s.algorithm << " " << m.id);
      std::size_t named = 0;
      for (const PartGrade& p : grade.parts) named += p.misconception == grade.explanation->misconceptions[0]->id;
      CHECK(named >= grade.explanation->covered);
    }
  }
}
