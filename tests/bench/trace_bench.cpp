// The five algorithms, recorded and not, and traces as JSON. Recorded runs report `per_value` and `per_step` (seconds)
// and `bytes_per_value`: "reused" with a recorder that keeps its memory, "growing" with a new one for each run.

#include <benchmark/benchmark.h>

#include <random>

#include "algorithms/trace_json.hpp"
#include "kernel/de_boor.hpp"
#include "kernel/de_casteljau.hpp"
#include "kernel/skinning.hpp"

namespace {

using namespace blossom;

std::vector<double> clamped_knots(int points, int p, std::mt19937& random) {
  std::uniform_real_distribution<double> step(0.5, 1.5);
  std::vector<double> U(static_cast<std::size_t>(p) + 1, 0.0);
  for (int i = p + 1; i <= points; ++i) U.push_back(U.back() + step(random));
  U.insert(U.end(), static_cast<std::size_t>(p), U.back());
  return U;
}

Curve<double> curve_of(int points, int p, bool rational, int seed = 1) {
  std::mt19937 random(static_cast<unsigned>(seed));
  std::uniform_real_distribution<double> height(-1, 1);
  std::uniform_real_distribution<double> weight(0.5, 2);
  Curve<double> curve;
  curve.degree = p;
  curve.dimension = 3;
  curve.rational = rational;
  curve.knots = points == p + 1 ? bezier_knots<double>(p) : clamped_knots(points, p, random);
  for (int i = 0; i < points; ++i) {
    const double w = rational ? weight(random) : 1;
    curve.points.emplace_back(w * i, w * height(random), w * (height(random) + 10 * seed), w);
  }
  return curve;
}

// Profiles over one knot vector, as the peers take them; or each over its own, which have to be made compatible.
std::vector<Curve<double>> profiles_of(int count, int points, bool compatible) {
  std::vector<Curve<double>> profiles;
  for (int l = 0; l < count; ++l) {
    profiles.push_back(curve_of(points, 3, false, l + 1));
    if (compatible) profiles.back().knots = profiles.front().knots;
  }
  return profiles;
}

// One algorithm on one input, with any recorder.
template <class Run>
void unrecorded(benchmark::State& state, Run&& run) {
  NoRecorder<double> none;
  for (auto _ : state) {
    auto result = run(none);
    benchmark::DoNotOptimize(result);
  }
}

void report(benchmark::State& state, const Trace<double>& trace) {
  using benchmark::Counter;
  const auto time = Counter::kIsIterationInvariantRate | Counter::kInvert;
  state.counters["per_value"] = Counter(trace.value_count(), time);
  state.counters["per_step"] = Counter(trace.step_count(), time);
  state.counters["bytes_per_value"] = static_cast<double>(trace.memory_bytes()) / trace.value_count();
}

template <class Run>
void recorded(benchmark::State& state, bool reused, Run&& run) {
  TraceRecorder<double> kept;
  run(kept);
  for (auto _ : state) {
    if (reused) {
      kept.clear();
      auto result = run(kept);
      benchmark::DoNotOptimize(result);
    } else {
      TraceRecorder<double> growing;
      auto result = run(growing);
      benchmark::DoNotOptimize(result);
    }
    benchmark::ClobberMemory();
  }
  report(state, kept.trace());
}

void json(benchmark::State& state, const char* id, const char* inputs) {
  const Algorithm& algorithm = *find_algorithm(id);
  const auto document = JsonDocument::parse("inputs", inputs);
  Diagnostics diagnostics;
  const auto run = record<double>(algorithm, *read_inputs(algorithm, Cursor(*document, diagnostics)));
  const Narrator<double> narrator(*run);
  std::size_t bytes = 0;
  for (auto _ : state) {
    const std::string text = write_trace(narrator);
    bytes += text.size();
    benchmark::DoNotOptimize(text.data());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes));
  state.counters["traces"] = benchmark::Counter(1, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["values"] = run->trace.value_count();
}

void json_read(benchmark::State& state, const char* id, const char* inputs) {
  const Algorithm& algorithm = *find_algorithm(id);
  const auto document = JsonDocument::parse("inputs", inputs);
  Diagnostics diagnostics;
  const auto run = record<double>(algorithm, *read_inputs(algorithm, Cursor(*document, diagnostics)));
  const std::string text = write_trace(Narrator<double>(*run));
  for (auto _ : state) {
    const auto parsed = JsonDocument::parse("trace", text);
    const auto stored = read_trace(*parsed);
    if (!stored) state.SkipWithError("not read");
    benchmark::DoNotOptimize(stored.value);
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(text.size() * state.iterations()));
}

template <class Run>
void add(const std::string& name, Run run) {
  benchmark::RegisterBenchmark((name + "/unrecorded").c_str(),
                               [run](benchmark::State& state) { unrecorded(state, run); });
  benchmark::RegisterBenchmark((name + "/recorded/reused").c_str(),
                               [run](benchmark::State& state) { recorded(state, true, run); });
  benchmark::RegisterBenchmark((name + "/recorded/growing").c_str(),
                               [run](benchmark::State& state) { recorded(state, false, run); });
}

constexpr const char* cubic = R"({"curve": {"degree": 3, "knots": [0,0,0,0,0.25,0.5,0.75,1,1,1,1],
  "points": [[0,0],[0.5,2],[2,3],[4,2.5],[5,1],[6.5,0.25],[7,-1]]}, "u": 0.4})";
constexpr const char* lofted = R"({"degree_v": 2, "profiles": [
  {"degree": 3, "points": [[0,0,0],[1,2,0],[2,2,0],[3,0,0]]},
  {"degree": 2, "points": [[0,0,1],[1.5,3,1],[3,0,1]]},
  {"degree": 2, "knots": [0,0,0,0.5,1,1,1], "points": [[0,0,2],[1,1,2],[2,1,2.5],[3,0,2]]}]})";

const int registered = [] {
  add("de_boor/10", [curve = curve_of(10, 3, false)](auto& rec) { return de_boor(curve, 3.3, rec); });
  add("de_boor/10/nurbs", [curve = curve_of(10, 3, true)](auto& rec) { return de_boor(curve, 3.3, rec); });
  add("de_casteljau/degree_10", [curve = curve_of(11, 10, false)](auto& rec) { return de_casteljau(curve, 0.3, rec); });
  add("knot_insertion/100",
      [curve = curve_of(100, 3, false)](auto& rec) { return knot_insertion(curve, 43.21, 1, rec); });
  add("degree_elevation/100", [curve = curve_of(100, 3, false)](auto& rec) { return degree_elevation(curve, 1, rec); });
  add("skinning/20x30",
      [profiles = profiles_of(20, 30, true)](auto& rec) { return skinning(profiles, 3, Parametrization::chord, rec); });
  add("skinning/20x30/incompatible", [profiles = profiles_of(20, 30, false)](auto& rec) {
    return skinning(profiles, 3, Parametrization::chord, rec);
  });
  benchmark::RegisterBenchmark("trace_json/write/de_boor", json, "de_boor", cubic);
  benchmark::RegisterBenchmark("trace_json/write/skinning", json, "skinning", lofted);
  benchmark::RegisterBenchmark("trace_json/read/de_boor", json_read, "de_boor", cubic);
  benchmark::RegisterBenchmark("trace_json/read/skinning", json_read, "skinning", lofted);
  return 0;
}();

}  // namespace
