// What a line of a stream costs, by stage: the library's JSON reader alone, our reading on top of it, the grading, the
// writing. stream_bench.py measures the whole, with processes and files.

#include <benchmark/benchmark.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "grader/report/report.hpp"
#include "grading_exercise.hpp"

namespace blossom {
namespace {

// As stream_bench.py writes it.
const std::string line =
    R"({"student": "s0000000", "submitted": "2026-10-01T21:59:00Z", "schema": "blossom.answers/1", )"
    R"("exercise": "de-boor-13", "answers": {"k": 4, "alpha[1][2]": 0.8, "alpha[1][3]": 0.53333, "alpha[1][4]": 0.2, )"
    R"("alpha[2][3]": 0.8, "alpha[2][4]": 0.3, "alpha[3][4]": 0.6, "P[1][2]": [0, 16], "P[1][3]": [16, 20], )"
    R"("P[1][4]": [30, 16], "P[2][3]": [12.8, 19.2], "P[2][4]": [20.2, 18.8], "P[3][4]": [17.24, 18.96]}})";

// Takes every event and keeps nothing.
struct Nothing : nlohmann::json::json_sax_t {
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(string_t&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::json::exception&) override { return false; }
};

void count(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations());
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(line.size()));
}

void line_json_events(benchmark::State& state) {
  Nothing nothing;
  for (auto _ : state)
    benchmark::DoNotOptimize(nlohmann::json::sax_parse(line.data(), line.data() + line.size(), &nothing));
  count(state);
}
BENCHMARK(line_json_events);

void line_json_document(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(JsonDocument::parse({}, line, submission_limits));
  count(state);
}
BENCHMARK(line_json_document);

const Grader& grader() {
  static const Grader made = [] {
    auto exercise = read_exercise(*JsonDocument::parse("exercise", exercise_text));
    if (!exercise) std::abort();
    return Grader(std::move(*exercise));
  }();
  return made;
}

void line_grade(benchmark::State& state) {
  const auto document = JsonDocument::parse({}, line, submission_limits);
  for (auto _ : state) benchmark::DoNotOptimize(grader().grade(document, "s0000000"));
  count(state);
}
BENCHMARK(line_grade);

void line_write(benchmark::State& state) {
  const Grade grade = grader().grade(JsonDocument::parse({}, line, submission_limits), "s0000000");
  std::string out;
  for (auto _ : state) {
    out.clear();
    write_json(grade, out);
    benchmark::DoNotOptimize(out.data());
  }
  count(state);
}
BENCHMARK(line_write);

}  // namespace
}  // namespace blossom
