#pragma once
// The exercise of the grading benchmarks: de Boor's algorithm on a cubic, 13 values asked.

namespace blossom {

inline const char* const exercise_text = R"({
  "schema": "blossom.exercise/1", "id": "de-boor-13", "title": "De Boor", "prompt": "Compute the point at u = 2/5.",
  "algorithm": "de_boor",
  "inputs": {"curve": {"degree": 3, "knots": [0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1],
    "points": [[10, 0], [0, 0], [0, 20], [30, 20], [30, 0], [15, 0], [15, 10]]}, "u": "2/5"},
  "ask": [{"value": "k", "points": 1}, {"value": "alpha[*][*]", "points": 1}, {"value": "P[1..3][*]", "points": 2}],
  "tolerance": {"decimals": 3}, "feedback": "hint"})";

}  // namespace blossom
