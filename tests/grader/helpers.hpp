#pragma once
// What the grader's tests share: an exercise and its submissions from text.

#include <catch2/catch.hpp>

#include "grader/report/report.hpp"

namespace blossom {

inline std::unique_ptr<Grader> grader_of(const std::string& text) {
  auto document = JsonDocument::parse("exercise.json", text);
  INFO(to_string(document.diagnostics));
  REQUIRE(document);
  auto exercise = read_exercise(*document);
  INFO(to_string(exercise.diagnostics));
  REQUIRE(exercise);
  return std::make_unique<Grader>(std::move(*exercise));
}

// An exercise of these parts; `more` are further members, each after a comma.
inline std::string exercise_text(const std::string& algorithm, const std::string& inputs, const std::string& ask,
                                 const std::string& more = "") {
  return R"({"schema": "blossom.exercise/1", "id": "test", "title": "T", "prompt": "P", "algorithm": ")" + algorithm +
         R"(", "inputs": )" + inputs + R"(, "ask": )" + ask + more + "}";
}

inline std::string answers_text(const std::string& answers) {
  return R"({"schema": "blossom.answers/1", "exercise": "test", "answers": )" + answers + "}";
}

inline Grade grade_text(const Grader& grader, const std::string& text) {
  return grader.grade(JsonDocument::parse("answers.json", text, submission_limits));
}
inline Grade grade_answers(const Grader& grader, const std::string& answers) {
  return grade_text(grader, answers_text(answers));
}

// An exercise that is shipped, and answers to it.
inline Grader shipped(const std::string& name) {
  auto exercise = load_exercise("exercises/" + name + ".json");
  INFO(to_string(exercise.diagnostics));
  REQUIRE(exercise);
  return Grader(std::move(*exercise));
}
inline Grade grade_answers_to(const Grader& grader, const std::string& answers) {
  return grade_text(grader, R"({"schema": "blossom.answers/1", "exercise": ")" + grader.exercise().id +
                                R"(", "answers": )" + answers + "}");
}

inline const PartGrade& part(const Grade& grade, const std::string& name) {
  const auto i = grade.exercise->part(name);
  INFO(name);
  REQUIRE(i.has_value());
  return grade.parts[*i];
}
inline std::string verdict(const Grade& grade, const std::string& name) {
  return std::string(verdict_name(part(grade, name).verdict));
}

// Numbers as a part's answer is typed; irrational ones as their double.
inline std::string typed_text(const Part& part, const Numbers<Exact>& numbers) {
  std::string text;
  for (const Exact& x : numbers) text += (text.empty() ? "" : ", ") + json_quote(x.to_string());
  return part.is_single() ? text : "[" + text + "]";
}

// The answers to all parts: the right ones, except where `other` says otherwise.
inline std::string all_answers(const Exercise& exercise, const std::map<std::string, std::string>& other = {}) {
  std::string text = "{";
  for (const Part& part : exercise.parts) {
    if (text.size() > 1) text += ", ";
    const auto found = other.find(part.name);
    text += json_quote(part.name) + ": " + (found == other.end() ? typed_text(part, part.right) : found->second);
  }
  return text + "}";
}

// The standard inputs: small, but every misconception shows in them.
inline const char* const de_casteljau_inputs =
    R"({"curve": {"degree": 3, "points": [[0, 0], [1, 3], [4, 4], [6, 1]]}, "u": "2/5"})";
inline const char* const rational_bezier_inputs =
    R"({"curve": {"degree": 3, "points": [[1, 0], [1, 3], [4, 4], [6, 1]], "weights": [1, 2, 3, 1]}, "u": "2/5"})";
inline const char* const de_boor_inputs =
    R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, "1/4", "1/2", "3/4", 1, 1, 1, 1],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10]]}, "u": "2/5"})";
inline const char* const nurbs_inputs =
    R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, "1/4", "1/2", "3/4", 1, 1, 1, 1],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10]], "weights": [1, 2, 3, 1, 2, 1, 1]},
        "u": "2/5"})";
inline const char* const insertion_inputs =
    R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, "1/4", "1/2", "3/4", 1, 1, 1, 1],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10]], "weights": [1, 2, 3, 1, 2, 1, 1]},
        "u": "2/5", "times": 2})";
inline const char* const elevation_inputs =
    R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, "1/2", 1, 1, 1, 1],
        "points": [[1, 0], [0, 3], [4, 4], [6, 1], [9, 2]], "weights": [1, 2, 3, 1, 2]}, "times": 1})";
inline const char* const skinning_inputs =
    R"({"profiles": [{"degree": 1, "points": [[0, 0, 0], [1, 0, 0]]},
                     {"degree": 2, "points": [[0, 1, 1], [1, 1, 2], [2, 1, 1]]},
                     {"degree": 1, "points": [[0, 4, 0], [3, 4, 0]]},
                     {"degree": 1, "points": [[0, 5, 0], [3, 6, 1]]}],
        "degree_v": 2, "parametrization": "chord"})";

struct Standard {
  const char* algorithm;
  const char* inputs;
  const char* ask;
};
inline const Standard standards[] = {
    {"de_casteljau", de_casteljau_inputs, R"([{"value": "P[1..3][*]", "points": 1}, {"value": "C", "points": 2}])"},
    {"de_casteljau", rational_bezier_inputs, R"([{"value": "P[1..3][*]", "points": 1}, {"value": "C", "points": 2}])"},
    {"de_boor", de_boor_inputs,
     R"([{"value": "k", "points": 1}, {"value": "s", "points": 1}, {"value": "alpha[*][*]", "points": 1},
         {"value": "P[1..3][*]", "points": 1}, {"value": "C", "points": 2}])"},
    {"de_boor", nurbs_inputs,
     R"([{"value": "k", "points": 1}, {"value": "alpha[*][*]", "points": 1}, {"value": "P[1..3][*]", "points": 1},
         {"value": "C", "points": 2}])"},
    {"knot_insertion", insertion_inputs,
     R"([{"value": "k", "points": 1}, {"value": "alpha[*][*]", "points": 1}, {"value": "Q[1..2][*]", "points": 1},
         {"value": "Ubar", "points": 2}, {"value": "Q[*]", "points": 1}])"},
    {"degree_elevation", elevation_inputs,
     R"([{"value": "alpha[*]", "points": 1}, {"value": "E[*][*]", "points": 1}, {"value": "V", "points": 1},
         {"value": "Q[*]", "points": 1}])"},
    {"skinning", skinning_inputs,
     R"([{"value": "d[*][*]", "points": 1}, {"value": "e[*][*]", "points": 1}, {"value": "v[1..3]", "points": 1},
         {"value": "V[3]", "points": 1}, {"value": "V", "points": 1}, {"value": "Q[*][*]", "points": 1}])"},
    {"subdivision",
     R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, "1/4", "1/2", "1/2", 1, 1, 1, 1],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10]]}, "u": "2/5"})",
     R"([{"value": "alpha[*][*]", "points": 1},
         {"value": "Q[*][*]", "points": 1},
         {"value": "UL", "points": 1},
         {"value": "UR", "points": 1},
         {"value": "L[*]", "points": 1},
         {"value": "R[*]", "points": 1}])"},
    {"refinement",
     R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, "1/4", "1/2", "1/2", 1, 1, 1, 1],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10]]}, "new_knots": ["3/8", "3/4", "1/8"]})",
     R"([{"value": "knot[*].alpha[*][*]", "points": 1},
         {"value": "knot[*].Q[*][*]", "points": 1},
         {"value": "Ubar", "points": 2},
         {"value": "Q[*]", "points": 1}])"},
    {"bezier_extraction",
     R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, "1/4", "1/2", "1/2", 1, 1, 1, 1],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10]]}})",
     R"([{"value": "knot[*].alpha[*][*]", "points": 1},
         {"value": "knot[*].Q[*][*]", "points": 1},
         {"value": "knot[*].Ubar", "points": 1},
         {"value": "B[*][*]", "points": 1}])"},
    {"basis_functions",
     R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, "1/4", "1/2", "1/2", 1, 1, 1, 1],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10]],
        "weights": [1, 2, 3, 1, 2, 1, 1]}, "u": "2/5"})",
     R"([{"value": "N[*][*]", "points": 1},
         {"value": "R[*]", "points": 1},
         {"value": "C", "points": 1}])"},
    {"curve_derivatives",
     R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, "1/4", "1/2", "1/2", 1, 1, 1, 1],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10]],
        "weights": [1, 2, 3, 1, 2, 1, 1]}, "u": "2/5"})",
     R"([{"value": "P[1..2][*]", "points": 1},
         {"value": "D[*]", "points": 1}])"},
    {"hodograph",
     R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, "1/4", "1/2", "1/2", 1, 1, 1, 1],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10]]}})",
     R"([{"value": "c[*]", "points": 1},
         {"value": "Q[*]", "points": 1},
         {"value": "V", "points": 2}])"},
    {"reversal",
     R"({"curve": {"degree": 2, "knots": [1, 1, 1, 2, 4, 5, 9, 9, 9],
        "points": [[0, 0], [2, 4], [6, 0], [8, 4], [10, 0], [12, 3]]}})",
     R"([{"value": "V[*]", "points": 1},
         {"value": "V", "points": 1},
         {"value": "Q[*]", "points": 1}])"},
    {"knot_splitting",
     R"({"curve": {"degree": 4, "knots": [0, 0, 0, 0, 0, 1, 1, 1, 1, 3, 3, 3, 3, 3],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10], [16, 11], [19, 9]]},
        "u": 1, "apart": "1/3"})",
     R"([{"value": "h", "points": 1}, {"value": "t[*]", "points": 1}, {"value": "V[*]", "points": 1},
         {"value": "V", "points": 1}, {"value": "C[*]", "points": 1}])"},
    {"polar_form", R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, "1/4", "1/2", "3/4", 1, 1, 1, 1],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10]], "weights": [1, 2, 3, 1, 2, 1, 1]},
        "arguments": ["1/3", "2/5", "5/8"], "span": 4})",
     R"([{"value": "alpha[*][*]", "points": 1}, {"value": "P[1..3][*]", "points": 1}, {"value": "b", "points": 2}])"},
    {"projection", nurbs_inputs,
     R"([{"value": "H[*]", "points": 1}, {"value": "k", "points": 1}, {"value": "alpha[*][*]", "points": 1},
         {"value": "H[*][*]", "points": 1}, {"value": "Cw", "points": 1}, {"value": "C", "points": 2}])"},
    {"circular_arc", R"({"center": [[3, 1]], "radius": 2, "start": 30, "end": 270})",
     R"([{"value": "n", "points": 1}, {"value": "h", "points": 1}, {"value": "w", "points": 1},
         {"value": "t[*]", "points": 1}, {"value": "P[*]", "form": "homogeneous", "points": 1}])"},
    {"clamping",
     R"({"curve": {"degree": 3, "knots": [0, 1, 2, 4, 5, 7, 8, 9, 11],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0]]}})",
     R"([{"value": "end[*].u", "points": 1},
         {"value": "end[*].alpha[*][*]", "points": 1},
         {"value": "end[*].Q[*][*]", "points": 1},
         {"value": "W", "points": 2},
         {"value": "Q[*]", "points": 1}])"},
    {"unclamping",
     R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, "1/4", "1/2", "1/2", 1, 1, 1, 1],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10]]}})",
     R"([{"value": "V[*]", "points": 1},
         {"value": "side[*].beta[*][*]", "points": 1},
         {"value": "side[*].Q[*][*]", "points": 1},
         {"value": "Q[*]", "points": 1}])"},
    {"horner", R"({"coefficients": [[1, 2], [7, 3], [-2, 5], [4, -6]], "u": "2/5"})",
     R"([{"value": "b[1..3]", "points": 1}, {"value": "C", "points": 2}])"},
    {"horner", R"({"coefficients": [[1, 2], [7, 3], [-2, 5]], "u": "2/5"})",
     R"([{"value": "b[1]", "points": 1}, {"value": "D", "points": 2}])"},
    {"bernstein", de_casteljau_inputs, R"([{"value": "B[*][1..3]", "points": 1}, {"value": "C", "points": 2}])"},
    {"variation_diminishing",
     R"({"curve": {"degree": 5, "points": [[0, -3], [1, 4], [2, 5], [4, -1], [5, 0], [7, -2]]}, "line": [[0, 0], [3, 0]],
        "rounds": 1})",
     R"([{"value": "d[0][*]", "points": 1}, {"value": "V[*]", "points": 2}])"},
    {"parameters", R"({"points": [[0, 0], [3, 4], [-1, 4], [-4, 0], [-4, -3], [0, -3]], "degree": 2})",
     R"([{"value": "d[*]", "points": 1}, {"value": "e[*]", "points": 1}, {"value": "t[1..4]", "points": 1},
         {"value": "U[3..5]", "points": 1}, {"value": "U", "points": 1}])"},
    {"parameters",
     R"({"points": [[0, 0], [3, 1], [4, 4], [9, 6], [11, 3], [12, 8]], "degree": 2, "parametrization": "centripetal"})",
     R"([{"value": "d[*]", "points": 1}, {"value": "e[*]", "points": 1}, {"value": "t[1..4]", "points": 1}])"},
    {"parameters",
     R"({"points": [[0, 0], [4, 1], [5, 5], [9, 6], [10, 1], [12, 0], [14, 3], [15, 8]], "degree": 2,
         "parametrization": "uniform"})",
     R"([{"value": "t[1..6]", "points": 1}])"},
    {"interpolation", R"({"points": [[0, 0], [3, 4], [-1, 4], [-4, 0], [-4, -3], [0, -3]], "degree": 2})",
     R"([{"value": "e[*]", "points": 1}, {"value": "t[1..4]", "points": 1}, {"value": "U[3..5]", "points": 1},
         {"value": "U", "points": 1}, {"value": "P[*]", "points": 1}])"},
    {"approximation", R"({"points": [[0, 0], [3, 4], [-1, 4], [-4, 0], [-4, -3], [0, -3]], "degree": 2, "count": 5})",
     R"([{"value": "e[*]", "points": 1}, {"value": "t[1..4]", "points": 1}, {"value": "U[3..4]", "points": 1},
         {"value": "U", "points": 1}, {"value": "P[*]", "points": 1}])"},
    {"local_interpolation", R"({"points": [[0, 0], [3, 4], [-1, 4], [-4, 0], [-4, -3]]})",
     R"([{"value": "e[*]", "points": 1}, {"value": "t[1..3]", "points": 1}, {"value": "V[*]", "points": 1},
         {"value": "P[*]", "points": 1}])"},
    {"knot_removal",
     R"({"curve": {"degree": 3, "knots": [0, 0, 0, 0, "1/4", "1/2", "3/4", 1, 1, 1, 1],
        "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10]]}, "u": "1/2", "tolerance": 99})",
     R"([{"value": "removal[1].alpha[*]", "points": 1}, {"value": "removal[1].L[*]", "points": 1},
         {"value": "removal[1].R[*]", "points": 1}, {"value": "Q[*]", "points": 1}])"},
    {"degree_reduction",
     R"({"curve": {"degree": 5, "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3]]}})",
     R"([{"value": "alpha[*]", "points": 1}, {"value": "L[*]", "points": 1}, {"value": "R[*]", "points": 1},
         {"value": "Q[*]", "points": 1}])"},
    {"surface_evaluation",
     R"({"surface": {"degree": [3, 1], "knots": [[0, 0, 0, 0, 1, 3, 3, 3, 3], [0, 0, 1, 1]],
        "points": [[[0, 0, 0], [1, 5, 2]], [[3, 1, 4], [4, 4, 9]], [[7, 0, 5], [6, 6, 8]], [[9, 2, 1], [11, 5, 3]],
                   [[12, 0, 0], [14, 7, 2]]], "weights": [[1, 2], [3, 1], [2, 3], [1, 1], [2, 1]]},
        "u": "2/3", "v": "1/4", "order": "u then v"})",
     R"([{"value": "column[*].P[1..3][*]", "points": 1},
         {"value": "R[*]", "points": 1},
         {"value": "S", "points": 2}])"},
    {"surface_basis",
     R"({"surface": {"degree": [3, 1], "knots": [[0, 0, 0, 0, 1, 3, 3, 3, 3], [0, 0, 1, 1]],
        "points": [[[0, 0, 0], [1, 5, 2]], [[3, 1, 4], [4, 4, 9]], [[7, 0, 5], [6, 6, 8]], [[9, 2, 1], [11, 5, 3]],
                   [[12, 0, 0], [14, 7, 2]]], "weights": [[1, 2], [3, 1], [2, 3], [1, 1], [2, 1]]},
        "u": "2/3", "v": "1/4"})",
     R"([{"value": "N[*]", "points": 1},
         {"value": "B[*][*]", "points": 1},
         {"value": "R[*][*]", "points": 1},
         {"value": "S", "points": 1}])"},
    {"surface_knot_insertion",
     R"({"surface": {"degree": [3, 1], "knots": [[0, 0, 0, 0, 1, 3, 3, 3, 3], [0, 0, 1, 1]],
        "points": [[[0, 0, 0], [1, 5, 2]], [[3, 1, 4], [4, 4, 9]], [[7, 0, 5], [6, 6, 8]], [[9, 2, 1], [11, 5, 3]],
                   [[12, 0, 0], [14, 7, 2]]], "weights": [[1, 2], [3, 1], [2, 3], [1, 1], [2, 1]]},
        "direction": "u", "t": "2/3"})",
     R"([{"value": "column[*].alpha[*][*]", "points": 1},
         {"value": "column[*].Q[*][*]", "points": 1},
         {"value": "Q[*][*]", "points": 1}])"},
    {"surface_degree_elevation",
     R"({"surface": {"degree": [4, 1],
        "points": [[[0, 0, 0], [1, 5, 2]], [[3, 1, 4], [4, 4, 9]], [[7, 0, 5], [6, 6, 8]], [[9, 2, 1], [11, 5, 3]],
                   [[12, 0, 0], [14, 7, 2]]]}, "direction": "u"})",
     R"([{"value": "column[*].alpha[*]", "points": 1},
         {"value": "column[*].Q[*]", "points": 1},
         {"value": "Q[*][*]", "points": 1}])"},
    {"surface_subdivision",
     R"({"surface": {"degree": [3, 1], "knots": [[0, 0, 0, 0, 1, 3, 3, 3, 3], [0, 0, 1, 1]],
        "points": [[[0, 0, 0], [1, 5, 2]], [[3, 1, 4], [4, 4, 9]], [[7, 0, 5], [6, 6, 8]], [[9, 2, 1], [11, 5, 3]],
                   [[12, 0, 0], [14, 7, 2]]], "weights": [[1, 2], [3, 1], [2, 3], [1, 1], [2, 1]]},
        "direction": "u", "t": "2/3"})",
     R"([{"value": "column[*].alpha[*][*]", "points": 1},
         {"value": "column[*].Q[*][*]", "points": 1},
         {"value": "column[*].UL", "points": 1},
         {"value": "column[*].UR", "points": 1},
         {"value": "L[*][*]", "points": 1},
         {"value": "R[*][*]", "points": 1}])"},
    {"surface_knot_splitting",
     R"({"surface": {"degree": [2, 1], "knots": [[0, 0, 0, "23/17", "23/17", "15/4", "15/4", "15/4"], [0, 0, 1, 1]],
        "points": [[[0, 0, 0], [1, 5, 2]], [[3, 1, 4], [4, 4, 9]], [[7, 0, 5], [6, 6, 8]], [[9, 2, 1], [11, 5, 3]],
                   [[12, 0, 0], [14, 7, 2]]]}, "direction": "u", "t": "23/17", "apart": "3/11"})",
     R"([{"value": "split.g", "points": 1}, {"value": "split.h", "points": 1}, {"value": "split.V[*]", "points": 1},
         {"value": "Ubar", "points": 1}, {"value": "B[*]", "points": 1}])"},
    {"surface_knot_removal",
     R"({"surface": {"degree": [3, 1], "knots": [[0, 0, 0, 0, 1, 3, 3, 3, 3], [0, 0, 1, 1]],
        "points": [[[0, 0, 0], [1, 5, 2]], [[3, 1, 4], [4, 4, 9]], [[7, 0, 5], [6, 6, 8]], [[9, 2, 1], [11, 5, 3]],
                   [[12, 0, 0], [14, 7, 2]]]}, "direction": "u", "t": 1, "tolerance": 99})",
     R"([{"value": "column[*].L[*]", "points": 1}, {"value": "column[*].R[*]", "points": 1},
         {"value": "e[*]", "points": 1}, {"value": "E", "points": 1}, {"value": "Q[*][*]", "points": 1}])"},
    {"surface_interpolation",
     R"({"points": [[[0, 0, 0], [0, 3, 4], [0, 7, 1]], [[4, 0, 3], [4, 3, 7], [5, 6, 3]],
                    [[6, 0, 3], [8, 3, 7], [8, 6, 3]], [[13, 0, 0], [12, 3, 4], [12, 6, 0]]],
        "degree_u": 2, "degree_v": 2})",
     R"([{"value": "along_u.e[*][*]", "points": 1}, {"value": "u[1..2]", "points": 1}, {"value": "v[1]", "points": 1},
         {"value": "along_u.U[3]", "points": 1}, {"value": "R[*][*]", "points": 1}, {"value": "P[*][*]", "points": 1}])"},
    {"surface_approximation",
     R"({"points": [[[0, 0, 0], [0, 3, 4], [0, 7, 1]], [[4, 0, 3], [4, 3, 7], [5, 6, 3]],
                    [[6, 0, 3], [8, 3, 7], [8, 6, 3]], [[13, 0, 0], [12, 3, 4], [12, 6, 0]]],
        "degree_u": 2, "degree_v": 2, "rows": 3, "columns": 3})",
     R"([{"value": "along_u.e[*][*]", "points": 1}, {"value": "u[1..2]", "points": 1}, {"value": "v[1]", "points": 1},
         {"value": "P[*][*]", "points": 1}])"},
    {"ruled",
     R"({"first": {"degree": 1, "points": [[0, 0, 0], [5, 1, 2]]},
         "second": {"degree": 3, "knots": [0, 0, 0, 0, "1/3", 1, 1, 1, 1],
                    "points": [[0, 7, 1], [1, 8, 4], [3, 6, 5], [4, 9, 3], [8, 7, 0]]}})",
     R"([{"value": "W[*]", "points": 1}, {"value": "Q[*][*]", "points": 1}])"},
    {"translational_sweep",
     R"({"profile": {"degree": 2, "points": [[0, 0], [1, 3], [4, 5]], "weights": [1, 3, 2]},
         "trajectory": {"degree": 2, "points": [[0, 0], [3, 4], [7, 1]], "weights": [2, 3, 5]}})",
     R"([{"value": "Q[*][*]", "form": "homogeneous", "points": 1}])"},
    {"swung",
     R"({"profile": {"degree": 2, "points": [[2, 1], [1, 3], [4, 5]], "weights": [1, 3, 2]},
         "trajectory": {"degree": 2, "points": [[1, 2], [3, 4], [7, 1]], "weights": [5, 3, 7]}, "scale": 3})",
     R"([{"value": "Q[*][*]", "form": "homogeneous", "points": 1}])"},
    // About a coordinate axis the wrong sense of rotation is a wrong sign, which might be a slip.
    {"revolution",
     R"({"profile": {"degree": 1, "points": [[7, 1], [3, 5]]}, "axis": [[0, 0, 0], [1, 2, 2]], "angle": 270})",
     R"([{"value": "n", "points": 1}, {"value": "w", "points": 1},
         {"value": "Q[*][*]", "form": "homogeneous", "points": 1}])"},
    {"sweep",
     R"({"profile": {"degree": 1, "points": [[1, 2], [3, -1]]},
         "trajectory": {"degree": 2, "points": [[0, 0, 0], [3, 1, 2], [4, 5, 3]]}, "sections": 3})",
     R"([{"value": "section[*].t", "points": 1}, {"value": "section[*].b", "points": 1},
         {"value": "R[*][*]", "points": 1}])"},
    {"coons",
     R"({"u_curves": [{"degree": 2, "knots": [0, 0, 0, "1/4", 1, 1, 1],
                       "points": [[0, 0, 0], [2, 1, 5], [7, 2, 4], [9, 0, 1]]},
                      {"degree": 2, "knots": [0, 0, 0, "1/4", 1, 1, 1],
                       "points": [[0, 8, 2], [3, 9, 6], [5, 6, 7], [10, 7, 3]]}],
         "v_curves": [{"degree": 2, "knots": [0, 0, 0, "2/5", 1, 1, 1],
                       "points": [[0, 0, 0], [1, 2, 4], [-1, 5, 3], [0, 8, 2]]},
                      {"degree": 2, "knots": [0, 0, 0, "2/5", 1, 1, 1],
                       "points": [[9, 0, 1], [11, 3, 6], [8, 5, 1], [10, 7, 3]]}]})",
     R"([{"value": "f[*]", "points": 1}, {"value": "g[*]", "points": 1}, {"value": "N[*][*]", "points": 1},
         {"value": "Q[*][*]", "points": 1}])"},
    {"gordon",
     R"({"u_curves": [{"degree": 1, "knots": [0, 0, 8, 8], "points": [[0, 0, 0], [8, 0, 4]]},
                      {"degree": 1, "knots": [0, 0, 8, 8], "points": [[0, 3, 1], [8, 4, 1]]}],
         "v_curves": [{"degree": 2, "points": [[0, 0, 0], [0, 1, 3], [0, 3, 1]]},
                      {"degree": 2, "points": [[1, 0, "1/2"], [2, 2, 1], [1, "25/8", 1]]},
                      {"degree": 2, "points": [["13/4", 0, "13/8"], [3, 2, 4], ["13/4", "109/32", 1]]},
                      {"degree": 2, "points": [[4, 0, 2], [5, 1, 2], [4, "7/2", 1]]},
                      {"degree": 2, "points": [[8, 0, 4], [7, 2, 3], [8, 4, 1]]}],
         "u_parameters": [0, 1, "13/4", 4, 8]})",
     R"([{"value": "UT[4]", "points": 1}, {"value": "UT", "points": 1}, {"value": "D[*][*]", "points": 1},
         {"value": "Q[*][*]", "points": 1}])"},
};

}  // namespace blossom
