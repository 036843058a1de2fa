// How many submissions one core grades per second: from the bytes of the answers to the bytes of the grade.
//
// The exercise is a cubic B-spline point by de Boor's algorithm, 13 values. Three sizes of submission: some of the
// values (about 200 bytes), all of them (about 417), all of them as long decimals and fractions with spaces (about 2
// KiB). Each right; with one early mistake that is carried through all later values; and with the weights swapped
// throughout.
//
// And what diagnosis costs, of 6, 13 and 59 values that are all answered: one misconception throughout, two at once,
// and nothing but noise.

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <map>

#include "grader/report/report.hpp"
#include "grading_exercise.hpp"

namespace blossom {
namespace {

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

// ---- diagnosis ------------------------------------------------------------------------------------------------------

// All points of the 13 values alone; all of them; and a curve of degree 7 with the result.
const Grader& asks(int values) {
  static std::map<int, std::unique_ptr<Grader>> made;
  auto& grader = made[values];
  if (grader) return *grader;
  const std::string cubic = R"("inputs": {"curve": {"degree": 3, "knots": [0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1],
    "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10]]}, "u": "2/5"})";
  const std::string septic =
      R"("inputs": {"curve": {"degree": 7, "knots": [0, 0, 0, 0, 0, 0, 0, 0, 0.5, 1, 1, 1, 1, 1, 1, 1, 1],
    "points": [[10, 0], [0, 1], [2, 20], [30, 21], [33, 0], [15, -3], [14, 10], [8, 8], [1, 4]]}, "u": "2/5"})";
  const std::string head = R"({"schema": "blossom.exercise/1", "id": "diagnosed", "title": "T", "prompt": "P",
    "algorithm": "de_boor", "tolerance": {"decimals": 3}, "feedback": "hint", )";
  const std::string points = R"({"value": "P[*][*]", "points": 2})";
  const std::string ratios = R"({"value": "k", "points": 1}, {"value": "alpha[*][*]", "points": 1}, )";
  const std::string text =
      values == 6    ? head + cubic + R"(, "ask": [)" + points + "]}"
      : values == 13 ? head + cubic + R"(, "ask": [)" + ratios + points + "]}"
                     : head + septic + R"(, "ask": [{"value": "s", "points": 1}, {"value": "C", "points": 1}, )" +
                           ratios + points + "]}";
  auto exercise = read_exercise(*JsonDocument::parse("exercise", text));
  if (!exercise) std::abort();
  grader = std::make_unique<Grader>(std::move(*exercise));
  if (static_cast<int>(grader->exercise().parts.size()) != values) std::abort();
  return *grader;
}

enum Fault { one_misconception, two_misconceptions, noise };

std::string faulty_answers(const Exercise& exercise, Fault fault) {
  std::vector<const Misconception*> holds;
  for (const Misconception& m : exercise.run.algorithm->misconceptions)
    if (m.id == "swapped-weights" || (fault == two_misconceptions && m.id == "neighbour-knot")) holds.push_back(&m);
  const ReplayPlan plan(exercise);
  Replayed student(exercise, plan);
  replay_with(exercise, holds, student, std::vector<Given>(exercise.parts.size()), {}, [](auto, auto) {});
  std::uint32_t random = 1;
  std::string text = R"({"schema": "blossom.answers/1", "exercise": "diagnosed", "answers": {)";
  for (const Part& part : exercise.parts) {
    if (text.back() != '{') text += ", ";
    text += "\"" + part.name + "\": ";
    if (!part.is_single()) text += "[";
    const auto numbers = part.as_typed(student.own(part.value));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      random = random * 1664525 + 1013904223;
      double typed = numbers[i].to_double();
      if (fault == noise) typed = part.kind == ValueKind::integer ? 9 : static_cast<double>(random >> 12) / 40000;
      char digits[40];
      std::snprintf(digits, sizeof digits, "%.5g", typed);
      text += (i > 0 ? ", " : "") + std::string(digits);
    }
    if (!part.is_single()) text += "]";
  }
  return text + "}}";
}

void diagnose(benchmark::State& state) {
  const Grader& with = asks(static_cast<int>(state.range(0)));
  const std::string text = faulty_answers(with.exercise(), static_cast<Fault>(state.range(1)));
  for (auto _ : state) {
    const Grade made = with.grade(JsonDocument::parse("answers", text, submission_limits));
    benchmark::DoNotOptimize(made.parts.data());
  }
  const Grade made = with.grade(JsonDocument::parse("answers", text, submission_limits));
  std::string label;
  if (made.explanation) {
    for (const Misconception* m : made.explanation->misconceptions) label += std::string(m->id) + ", ";
    label += std::to_string(made.explanation->covered) + " of " + std::to_string(made.explanation->wrong);
  }
  state.SetLabel(label);
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(diagnose)
    ->ArgNames({"values", "fault"})
    ->ArgsProduct({{6, 13, 59}, {one_misconception, two_misconceptions, noise}});

// The first wrong answer to an exercise: with what is worked out once for all others.
void first_diagnosis(benchmark::State& state) {
  const Exercise& exercise = asks(static_cast<int>(state.range(0))).exercise();
  const std::string text = faulty_answers(exercise, noise);
  for (auto _ : state) {
    const Grader fresh{Exercise(exercise)};
    const Grade made = fresh.grade(JsonDocument::parse("answers", text, submission_limits));
    benchmark::DoNotOptimize(made.parts.data());
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(first_diagnosis)->ArgName("values")->Arg(6)->Arg(13)->Arg(59);

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
