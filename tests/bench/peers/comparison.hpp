#pragma once
// What is compared: entries, each one program's way of doing the work of one row. What is timed is what is checked: the
// same function is run once for its result and then over and over for its time.

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cases.hpp"

namespace peers {

inline constexpr const char* blossom_plain = "Blossom";  // its results are what the others must agree with
inline constexpr const char* blossom_evaluator = "evaluator";

struct Entry {
  std::string row;
  std::string who;
  int per;  // the time of one run is divided by it (vertices of a grid)
  std::function<std::vector<double>()> results;
  std::function<void(benchmark::State&)> measure;
};

// Every file of a peer adds its own, before main.
inline std::vector<Entry>& entries() {
  static std::vector<Entry> all;
  return all;
}

// run(i, out) writes the N numbers of job i, i = 0..parameter_count-1: one point, say.
template <std::size_t N, class Run>
void add_jobs(const std::string& row, const char* who, Run run) {
  const auto results = [run]() mutable {
    std::vector<double> all;
    std::array<double, N> out;
    for (std::size_t i = 0; i < parameter_count; ++i) {
      run(i, out);
      all.insert(all.end(), out.begin(), out.end());
    }
    return all;
  };
  const auto measure = [run](benchmark::State& state) mutable {
    std::size_t i = 0;
    for (auto _ : state) {
      std::array<double, N> out;
      run(i, out);
      benchmark::DoNotOptimize(out);
      i = (i + 1) & (parameter_count - 1);
    }
  };
  entries().push_back({row, who, 1, results, measure});
}

// run() makes the whole result, a curve, say, which is also destroyed within the time; read(result) gives its numbers.
template <class Run, class Read>
void add_whole(const std::string& row, const char* who, int per, Run run, Read read) {
  const auto results = [run, read]() mutable { return read(run()); };
  const auto measure = [run](benchmark::State& state) mutable {
    for (auto _ : state) {
      auto result = run();
      benchmark::DoNotOptimize(result);
      benchmark::ClobberMemory();
    }
  };
  entries().push_back({row, who, per, results, measure});
}

}  // namespace peers
