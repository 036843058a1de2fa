// What `blossom lint` says of ranges that cannot give what is demanded of variants.

#include "grader/helpers.hpp"
#include "grader/variant.hpp"

using namespace blossom;

namespace {

JsonDocument exercise(const std::string& algorithm, const std::string& inputs, const std::string& ask,
                      const std::string& vary) {
  auto document = JsonDocument::parse("x.json", exercise_text(algorithm, inputs, ask, ",\n\"vary\": " + vary));
  REQUIRE(document);
  const auto read = read_exercise(*document);
  INFO(to_string(read.diagnostics));
  REQUIRE(read);
  return std::move(*document);
}

std::string lint(const JsonDocument& document) { return to_string(check_variants(document)); }
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

const std::string quadratic = R"({"curve": {"degree": 2, "points": [[1, 1], [3, 6], [8, 2]]}, "u": "1/3"})";
const std::string all = R"([{"value": "P[1..2][*]", "points": 1}])";
const std::string points = R"({"at": "curve.points[*]", "grid": {"from": [1, 1], "to": [9, 9]}})";

}  // namespace

TEST_CASE("Ranges that give acceptable variants are in order") {
  const auto document = exercise("de_casteljau", quadratic, all,
                                 R"({"inputs": [)" + points + R"(, {"at": "u", "choose": ["1/3", "2/3"]}]})");
  CHECK(lint(document) == "");
}

TEST_CASE("A misconception that the ranges hide is named with the values it is hidden in, and numbers") {
  // At u = 1/2 it makes no difference which of two weights is which.
  const auto half =
      exercise("de_casteljau", R"({"curve": {"degree": 2, "points": [[1, 1], [3, 6], [8, 2]]}, "u": "1/2"})", all,
               R"({"inputs": [)" + points + "]}");
  const auto said = lint(half);
  INFO(said);
  CHECK(said.find("x.json:2:9: vary: \"swapped-weights\" gives the right value of P[1][0], P[1][1], P[2][0] in each of "
                  "64 draws") == 0);
  CHECK(has(said, "P[1][0] = (1 - u) P[0][0] + u P[0][1] = (1 - 1/2) ("));
  CHECK(has(said, "\"except\""));
  CHECK_FALSE(has(said, "wrong-pair"));

  const auto variant = make_variant(half, "s17", "correct horse battery");
  CHECK_FALSE(variant);
  CHECK(has(to_string(variant.diagnostics),
            "no variant for \"s17\" was found in 20000 draws: \"swapped-weights\" gives "
            "the right value of P[1][0]"));

  SECTION("unless the pair is excepted") {
    const auto excepted = exercise(
        "de_casteljau", R"({"curve": {"degree": 2, "points": [[1, 1], [3, 6], [8, 2]]}, "u": "1/2"})", all,
        R"({"inputs": [)" + points + R"(], "except": [{"misconception": "swapped-weights", "value": "P[*][*]"}]})");
    CHECK(lint(excepted) == "");
    CHECK(make_variant(excepted, "s17", "correct horse battery"));
  }
  SECTION("and the exception is for that pair alone") {
    const auto excepted = exercise(
        "de_casteljau", R"({"curve": {"degree": 2, "points": [[1, 1], [3, 6], [8, 2]]}, "u": "1/2"})", all,
        R"({"inputs": [)" + points + R"(], "except": [{"misconception": "swapped-weights", "value": "P[1][0]"}]})");
    CHECK(has(lint(excepted), "\"swapped-weights\" gives the right value of P[1][1], P[2][0] in each"));
  }
}

TEST_CASE("A misconception that the tolerance hides is named") {
  // All points are near each other, and half a unit counts as right.
  const auto near = [](const std::string& more) {
    return exercise(
        "de_casteljau", R"({"curve": {"degree": 2, "points": [[11, 11], [12, 16], [18, 12]]}, "u": "1/3"})",
        R"([{"value": "P[1..2][*]", "points": 1, "tolerance": {"absolute": 1}}])",
        R"({"inputs": [{"at": "curve.points[*]", "grid": {"from": [11, 11], "to": [13, 13]}}])" + more + "}");
  };
  CHECK(has(lint(near("")), "\"swapped-weights\" gives the right value of P[1][0]"));
  CHECK_FALSE(has(lint(near(R"(, "tolerance": "exact")")), "swapped-weights"));
}

TEST_CASE("Demands on values that are never met are named") {
  const auto said = [](const std::string& inputs, const std::string& vary, const std::string& ask = all) {
    return lint(exercise("de_casteljau", inputs, ask, vary));
  };
  SECTION("denominators") {
    const auto text = said(quadratic, R"({"inputs": [{"at": "u", "choose": ["10/13", "4/13"]}], "denominator": 4})");
    CHECK(has(text, "P[1][0] has the denominator 13, more than 4"));
  }
  SECTION("likeness") {
    const auto text = said(quadratic, R"({"inputs": [)" + points +
                                          R"(, {"at": "u", "choose": ["1001/9001"]}], "denominator": 900000000})");
    CHECK(has(text, "which is not alike within 3/2"));
  }
  SECTION("steps") {
    const auto text =
        said(quadratic, R"({"inputs": [{"at": "curve", "choose": [{"degree": 1, "points": [[1, 2], [3, 5]]}]}]})");
    CHECK(has(text, "no draw is acceptable"));
    CHECK(has(text, "has not the model's steps and values"));
  }
  SECTION("inputs that the algorithm refuses") {
    const auto text = said(quadratic, R"({"inputs": [{"at": "u", "integers": [2, 3]}]})");
    CHECK(has(text, "the algorithm does not take the inputs: u must lie in the domain [0, 1]"));
  }
  SECTION("a requirement") {
    const auto text = said(quadratic, R"({"inputs": [{"at": "curve.points[*]", "choose": [[1, 1]]}],
                                          "require": ["points distinct"]})");
    CHECK(has(text, "of 4000 draws, in 4000 \"points distinct\" is not met"));
  }
  SECTION("a knot") {
    const auto text = said(quadratic, R"({"inputs": [{"at": "u", "integers": [0, 1], "not": "a knot"}]})");
    CHECK(has(text, "is a knot"));
  }
  SECTION("something to compute") {
    // All control points at one place: every point is a copy of its operands.
    const auto text = said(quadratic, R"({"inputs": [{"at": "curve.points[*]", "choose": [[1, 1]]}]})");
    CHECK(has(text, "P[1][0] is one of the inputs"));
    CHECK(has(text, "P[1][0] is what it is made from"));
  }
  SECTION("in a file that would have mistakes itself") {
    // An absolute tolerance must be small against what it is for.
    const auto text = said(R"({"curve": {"degree": 2, "points": [[100, 1], [300, 6], [800, 2]]}, "u": "1/3"})",
                           R"({"inputs": [)" + points + R"(], "likeness": 9, "tolerance": "exact"})",
                           R"([{"value": "P[1..2][*]", "points": 1, "tolerance": {"absolute": 3}}])");
    CHECK(has(text, "the exercise is in order no longer"));
  }
}

TEST_CASE("A value that nobody can be given is named at its place") {
  const auto said = [](const std::string& vary) {
    return lint(exercise("de_casteljau", quadratic, all, "{\"inputs\": [" + points + ", " + vary + "]}"));
  };
  const std::string text = said(R"({"at": "u", "choose": ["1/3", "x", "2/3", 5]})");
  INFO(text);
  CHECK(has(text, "vary.inputs[1].choose[1]: nobody can be given this: with u = x the algorithm does not take"));
  CHECK(has(text, "vary.inputs[1].choose[3]: nobody can be given this: with u = 5 the algorithm does not take"));
  CHECK_FALSE(has(text, "choose[0]"));
  CHECK_FALSE(has(text, "choose[2]"));
  CHECK(has(said(R"({"at": "u", "choose": ["1/3", 1], "not": "a knot"})"),
            "choose[1]: nobody can be given this: with u = 1 "));
  CHECK(has(said(R"({"at": "u", "fractions": {"denominators": [3], "from": 0, "to": 2}})"),
            "fractions.to: nobody can be given this: with u = 5/3 "));

  SECTION("unless other numbers that vary, too, make it possible") {
    const auto spline = exercise(
        "de_boor",
        R"({"curve": {"degree": 2, "knots": [0, 0, 0, 2, 2, 2], "points": [[1, 1], [3, 6], [8, 2]]}, "u": "2/3"})",
        R"([{"value": "P[1][*]", "points": 1}])",
        R"({"inputs": [)" + points + R"(, {"at": "curve.knots", "choose": [[0, 0, 0, 2, 2, 2], [0, 0, 0, 5, 5, 5]]},
                       {"at": "u", "choose": ["2/3", "5/3", "10/3"]}]})");
    CHECK(lint(spline) == "");
  }
}

TEST_CASE("A range of which one value alone gives the model's steps is named") {
  const std::string text = lint(exercise(
      "de_casteljau", quadratic, all, "{\"inputs\": [" + points + R"(, {"at": "curve.degree", "integers": [2, 4]}]})"));
  INFO(text);
  CHECK(has(text, "vary.inputs[1].integers[1]: nobody can be given this: with curve.degree = 4 "));
}

TEST_CASE("What is chosen may be anything: what the algorithm does not take is not acceptable") {
  for (const char* chosen :
       {R"({"at": "profiles", "choose": [[], 7, null, {"a": 1}]})",
        R"({"at": "profiles[1]", "choose": [[], 7, null, {"points": 3}, {"points": [[], 1, ["x"]]}]})",
        R"({"at": "profiles[1].points", "choose": [[], "x", [[[[1]]]]]})"}) {
    const auto document =
        exercise("skinning", skinning_inputs, R"([{"value": "v[1]", "points": 1, "tolerance": {"decimals": 3}}])",
                 R"({"inputs": [)" + std::string(chosen) + R"(], "require": ["no three points collinear"]})");
    INFO(chosen);
    CHECK(has(lint(document), "no draw is acceptable"));
    CHECK_FALSE(make_variant(document, "s17", "correct horse battery"));
  }
}

TEST_CASE("Ranges of which less than one draw in 200 is acceptable are named with what is most in the way") {
  const auto rare = exercise(
      "de_casteljau", quadratic, all,
      R"({"inputs": [)" + points + R"(, {"at": "u", "fractions": {"denominators": [3, 997], "from": 0, "to": 1}}]})");
  const auto said = lint(rare);
  INFO(said);
  CHECK(has(said, "draws are acceptable, fewer than one in 200; most often"));
  CHECK(has(said, "has too large a denominator"));
}

TEST_CASE("What shipped exercises vary is in order") {
  for (const char* name : {"11-own-de-casteljau", "40-own-rational", "22-own-de-boor", "28-own-knot-insertion",
                           "16-own-degree-elevation"}) {
    const auto document = JsonDocument::load("exercises/" + std::string(name) + ".json");
    REQUIRE(document);
    INFO(name);
    CHECK(varies(*document));
    CHECK(lint(*document) == "");
  }
}
