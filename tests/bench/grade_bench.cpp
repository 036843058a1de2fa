// How many submissions one core grades per second: from the bytes of the answers to the bytes of the grade.
//
// The exercise is a cubic B-spline point by de Boor's algorithm, 13 values. Three sizes of submission: some of the
// values (about 200 bytes), all of them (about 417), all of them as long decimals and fractions with spaces (about 2
// KiB). Each right; with one early mistake that is carried through all later values; and with the weights swapped
// throughout.

#include <benchmark/benchmark.h>

#include <cstdlib>

#include "grader/report/report.hpp"

namespace blossom {
namespace {

const char* const exercise_text = R"({
  "schema": "blossom.exercise/1", "id": "de-boor-13", "title": "De Boor", "prompt": "Compute the point at u = 2/5.",
  "algorithm": "de_boor",
  "inputs": {"curve": {"degree": 3, "knots": [0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1],
    "points": [[10, 0], [0, 0], [0, 20], [30, 20], [30, 0], [15, 0], [15, 10]]}, "u": "2/5"},
  "ask": [{"value": "k", "points": 1}, {"value": "alpha[*][*]", "points": 1}, {"value": "P[1..3][*]", "points": 2}],
  "tolerance": {"decimals": 3}, "feedback": "hint"})";

const Grader& grader() {
  static const Grader made = [] {
    auto exercise = read_exercise(*JsonDocument::parse("exercise", exercise_text));
    if (!exercise) std::abort();
    return Grader(std::move(*exercise));
  }();
  return made;
}

enum Kind { right, carried, swapped };

// The values of the triangle with what `kind` makes of them.
std::vector<std::pair<std::string, std::vector<double>>> values(Kind kind) {
  const double U[] = {0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1};
  const double P0[][2] = {{10, 0}, {0, 0}, {0, 20}, {30, 20}, {30, 0}, {15, 0}, {15, 10}};
  std::vector<std::pair<std::string, std::vector<double>>> alphas, points;
  double P[7][2];
  for (int i = 0; i < 7; ++i)
    for (int c = 0; c < 2; ++c) P[i][c] = P0[i][c];
  for (int r = 1; r <= 3; ++r)
    for (int i = 4; i >= 1 + r; --i) {
      double alpha = (0.4 - U[i]) / (U[i + 4 - r] - U[i]);
      if (kind == carried && r == 1 && i == 2) alpha = 0.75;
      const std::string index = "[" + std::to_string(r) + "][" + std::to_string(i) + "]";
      alphas.push_back({"alpha" + index, {alpha}});
      const double a = kind == swapped ? 1 - alpha : alpha;
      for (int c = 0; c < 2; ++c) P[i][c] = (1 - a) * P[i - 1][c] + a * P[i][c];
      points.push_back({"P" + index, {P[i][0], P[i][1]}});
    }
  alphas.insert(alphas.begin(), {"k", {4}});
  alphas.insert(alphas.end(), points.begin(), points.end());
  return alphas;
}

// bytes: 200, 417 or 2048, nearly.
std::string answers(int bytes, Kind kind) {
  const bool long_form = bytes > 1000;
  std::string text = R"({"schema": "blossom.answers/1", "exercise": "de-boor-13", "answers": {)";
  std::size_t count = 0;
  for (const auto& [name, numbers] : values(kind)) {
    if (bytes < 300 && ++count > 6) break;
    if (text.back() != '{') text += long_form ? ",\n      " : ",\n    ";
    text += "\"" + name + "\": ";
    if (numbers.size() > 1) text += "[";
    for (std::size_t c = 0; c < numbers.size(); ++c) {
      char digits[80];
      std::snprintf(digits, sizeof digits, long_form ? "\"%.15f0000000000000000000000000000000000\"" : "%.5g",
                    numbers[c]);
      text += (c > 0 ? ", " : "") + std::string(digits);
    }
    if (numbers.size() > 1) text += "]";
  }
  text += "}}";
  if (long_form)
    text.insert(text.size() - 1, static_cast<std::size_t>(std::max(0, bytes - static_cast<int>(text.size()))), ' ');
  return text;
}

void grade(benchmark::State& state) {
  const std::string text = answers(static_cast<int>(state.range(0)), static_cast<Kind>(state.range(1)));
  const Grader& with = grader();
  std::string out;
  for (auto _ : state) {
    out.clear();
    write_json(with.grade(JsonDocument::parse("answers", text, submission_limits), "student"), out);
    benchmark::DoNotOptimize(out.data());
  }
  const Grade made = with.grade(JsonDocument::parse("answers", text, submission_limits));
  std::string label = std::to_string(text.size()) + " bytes:";
  for (std::size_t v = 0; v < verdict_count; ++v) {
    const auto verdict = static_cast<Verdict>(v);
    const auto n =
        std::count_if(made.parts.begin(), made.parts.end(), [&](const PartGrade& p) { return p.verdict == verdict; });
    if (n > 0) label += " " + std::to_string(n) + " " + std::string(verdict_name(verdict));
  }
  state.SetLabel(label);
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(grade)->ArgNames({"bytes", "kind"})->ArgsProduct({{200, 417, 2048}, {right, carried, swapped}});

void read_only(benchmark::State& state) {
  const std::string text = answers(static_cast<int>(state.range(0)), right);
  for (auto _ : state) {
    const auto document = JsonDocument::parse("answers", text, submission_limits);
    benchmark::DoNotOptimize(document->root().items.data());
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(read_only)->ArgName("bytes")->Arg(200)->Arg(417)->Arg(2048);

}  // namespace
}  // namespace blossom
