// "vary" and the prompt's placeholders: what is refused, where, and with which advice.

#include "grader/helpers.hpp"
#include "grader/variant.hpp"

using namespace blossom;

namespace {

// The mistakes of a de Casteljau exercise with these ranges and further members of "vary".
std::string mistakes(const std::string& ranges, const std::string& more = "", const std::string& prompt = "P") {
  std::string text = exercise_text("de_casteljau", rational_bezier_inputs, R"([{"value": "P[1][*]", "points": 1}])",
                                   ", \"vary\": {\"inputs\": " + ranges + more + "}");
  text.replace(text.find("\"prompt\": \"P\""), 13, "\"prompt\": " + json_quote(prompt));
  const auto document = JsonDocument::parse("x.json", text);
  REQUIRE(document);
  return to_string(read_exercise(*document).diagnostics);
}

const std::string good = R"([{"at": "u", "integers": [0, 1]}])";

struct Mistake {
  const char* ranges;
  const char* says;
};

}  // namespace

TEST_CASE("Ranges in order are accepted") {
  for (
      const char* ranges :
      {R"([{"at": "u", "fractions": {"denominators": [3, 4], "from": 0, "to": 1}, "not": "a knot"}])",
       R"([{"at": "curve.points[*]", "grid": {"from": [-3, "1/2"], "to": [3, 4], "step": "1/2"}}])",
       R"([{"at": "curve.points[1..2][0]", "integers": [2, 2]}, {"at": "curve.points[0]", "choose": [[1, 2], ["1/2", 3]]}])",
       R"([{"at": "curve.weights[*]", "integers": [1, 5]}])",
       R"([{"at": "curve", "choose": [{"degree": 1, "points": [[0, 0], [1, 1]]}]}])"}) {
    INFO(ranges);
    CHECK(mistakes(ranges) == "");
  }
  CHECK(mistakes(good, R"(, "require": ["points distinct", "points convex"], "denominator": 60, "likeness": 2,
                          "tolerance": {"decimals": 3},
                          "except": [{"misconception": "swapped-weights", "value": "P[1][*]"}])") == "");
}

TEST_CASE("Mistakes in ranges are named at their places") {
  const auto mistake = GENERATE(values<Mistake>({
      {R"([])", "vary.inputs: "},
      {R"([{"at": "u"}])", "vary.inputs[0]: must have one of"},
      {R"([{"at": "u", "integers": [0, 1], "choose": [1]}])", "vary.inputs[0]: must have one of"},
      {R"([{"at": "u", "integer": [0, 1]}])", "did you mean \"integers\"?"},
      {R"([{"integers": [0, 1]}])", "\"at\""},
      {R"([{"at": "", "integers": [0, 1]}])", "must be a path into \"inputs\""},
      {R"([{"at": "v", "integers": [0, 1]}])", "has no member \"v\""},
      {R"([{"at": "curve.point[1]", "grid": {"from": [0, 0], "to": [1, 1]}}])", "did you mean \"points\"?"},
      {R"([{"at": "curve.points[4]", "grid": {"from": [0, 0], "to": [1, 1]}}])", "there is no item 4"},
      {R"([{"at": "curve.points[2..1]", "grid": {"from": [0, 0], "to": [1, 1]}}])", "has the index \"2..1\""},
      {R"([{"at": "curve.points[-1]", "grid": {"from": [0, 0], "to": [1, 1]}}])", "has the index \"-1\""},
      {R"([{"at": "curve.points[1", "grid": {"from": [0, 0], "to": [1, 1]}}])", "has a [ without a ]"},
      {R"([{"at": "curve[1]", "choose": [1]}])", "it is no array"},
      {R"([{"at": "u.v", "choose": [1]}])", "it is no object"},
      {R"([{"at": "u[0]x", "choose": [1]}])", "it is no array"},
      {R"([{"at": "curve.points[0]x", "choose": [1]}])", "has no . or ["},
      {R"([{"at": "curve.points[1]", "integers": [0, 1]}])", "for points there is \"grid\""},
      {R"([{"at": "curve.weights", "integers": [0, 1]}])", "\"curve.weights[*]\""},
      {R"([{"at": "curve", "integers": [0, 1]}])", "\"curve\" is none"},
      {R"([{"at": "u", "grid": {"from": [0, 0], "to": [1, 1]}}])", "is for points"},
      {R"([{"at": "curve.points", "grid": {"from": [0, 0], "to": [1, 1]}}])", "is for points"},
      {R"([{"at": "curve.points[0]", "grid": {"from": [0, 0, 0], "to": [1, 1, 1]}}])", "has 3 coordinates"},
      {R"([{"at": "curve.points[0]", "grid": {"from": [0, 2], "to": [1, 1]}}])", "must not be less than"},
      {R"([{"at": "curve.points[0]", "grid": {"from": [0, 0], "to": [1, 1], "step": 0}}])", "must be greater than 0"},
      {R"([{"at": "curve.points[0]", "grid": {"from": [0, 0], "to": [1, 1], "step": "1/9999999"}}])", "million steps"},
      {R"([{"at": "u", "integers": [1, 0]}])", "the smaller number first"},
      {R"([{"at": "u", "integers": [0, 1, 2]}])", "vary.inputs[0].integers: "},
      {R"([{"at": "u", "integers": [0, 1e9]}])", "vary.inputs[0].integers[1]: "},
      {R"([{"at": "u", "fractions": {"denominators": [3], "from": "2/5", "to": "3/5"}}])", "no such fraction"},
      {R"([{"at": "u", "fractions": {"denominators": [9999], "from": 0, "to": 999999}}])", "more than 100000"},
      {R"([{"at": "u", "fractions": {"denominators": [0], "from": 0, "to": 1}}])", "denominators[0]: "},
      {R"([{"at": "u", "choose": []}])", "vary.inputs[0].choose: "},
      {R"([{"at": "u", "integers": [0, 1], "not": "knot"}])", "must be \"a knot\""},
      {R"([{"at": "curve", "choose": [1], "not": "a knot"}])", "is for numbers"},
      {R"([{"at": "u", "integers": [0, 1]}, {"at": "u", "choose": [1]}])", "\"u\" is drawn twice"},
      {R"([{"at": "curve.points[*]", "grid": {"from": [0, 0], "to": [1, 1]}}, {"at": "curve.points[1][0]", "choose": [1]}])",
       "\"curve.points[1][0]\" is drawn twice: \"curve.points[1]\" varies already"},
  }));
  INFO(mistake.ranges);
  const auto said = mistakes(mistake.ranges);
  INFO(said);
  CHECK(said.find("x.json:1:") == 0);
  CHECK(said.find(mistake.says) != std::string::npos);
}

TEST_CASE("Mistakes in what a draw must be are named at their places") {
  const auto mistake = GENERATE(values<Mistake>({
      {R"("require": ["points convx"])", "did you mean \"points convex\"?"},
      {R"("require": "points convex")", "vary.require: "},
      {R"("denominator": 0)", "vary.denominator: "},
      {R"("likeness": "1/2")", "must be at least 1"},
      {R"("tolerance": {"decimal": 3})", "vary.tolerance"},
      {R"("except": [{"misconception": "swapped-weight", "value": "P[1][0]"}])", "did you mean \"swapped-weights\"?"},
      {R"("except": [{"misconception": "zzz", "value": "P[1][0]"}])", "there are swapped-weights, missing-division"},
      {R"("except": [{"misconception": "swapped-weights", "value": "P[2][0]"}])", "selects nothing that is asked"},
      {R"("except": [{"misconception": "swapped-weights", "value": "P["}])", "is no selector"},
      {R"("except": [{"misconception": "swapped-weights"}])", "vary.except[0]"},
      {R"("excpt": [])", "did you mean \"except\"?"},
  }));
  INFO(mistake.ranges);
  const auto said = mistakes(good, ", " + std::string(mistake.ranges));
  INFO(said);
  CHECK(said.find(mistake.says) != std::string::npos);
}

TEST_CASE("A prompt is filled in with what is given, and with nothing else") {
  const auto exercise = [](const std::string& prompt) {
    std::string text = exercise_text("de_boor", de_boor_inputs, R"([{"value": "k", "points": 1}])");
    text.replace(text.find("\"prompt\": \"P\""), 13, "\"prompt\": " + json_quote(prompt));
    return read_exercise(*JsonDocument::parse("x.json", text));
  };
  CHECK(exercise("At u = {u}, from {P[0][1]} on, with {U}.")->prompt ==
        "At u = 2/5, from (0, 1) on, with (0, 0, 0, 0, 1/4, 1/2, 3/4, 1, 1, 1, 1).");
  CHECK(exercise("No braces.")->prompt == "No braces.");
  const auto says = [&](const std::string& prompt) { return to_string(exercise(prompt).diagnostics); };
  CHECK(says("Where is {C}?").find("prompt: \"{C}\" names nothing that is given: it is computed") != std::string::npos);
  CHECK(says("{k}").find("it is computed") != std::string::npos);
  CHECK(says("{P[0][99]}").find("names nothing that is given") != std::string::npos);
  CHECK(says("Open {u").find("a { has no } behind it") != std::string::npos);
}
