#pragma once
// Comparing curves, and running a kernel both ways.

#include <catch2/catch.hpp>

#include "algorithms/inputs.hpp"
#include "kernel/evaluate.hpp"
#include "trace/trace_recorder.hpp"

namespace blossom::test {

template <Scalar S>
bool near(const S& a, const S& b, double scale = 1) {
  if constexpr (std::same_as<S, Exact>)
    return a == b;
  else
    return std::abs(a - b) <= 1e-9 * std::max(1.0, scale);
}

template <Scalar S>
bool near(const Point<S>& A, const Point<S>& B, double scale = 1) {
  return near(A.x, B.x, scale) && near(A.y, B.y, scale) && near(A.z, B.z, scale);
}

// `kernel(recorder)` with and without recording: the results must be the same, and are returned.
template <Scalar S, class Kernel>
auto both_ways(Kernel&& kernel) {
  TraceRecorder<S> recorder;
  NoRecorder<S> none;
  auto recorded = kernel(recorder);
  CHECK(recorded == kernel(none));
  return recorded;
}

// Parameters that tell two piecewise curves of degree at most p apart: p + 1 in each span of both, and the ends.
inline std::vector<Exact> telling_parameters(const Curve<Exact>& a, const Curve<Exact>& b) {
  std::vector<Exact> breaks(a.knots);
  breaks.insert(breaks.end(), b.knots.begin(), b.knots.end());
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  std::vector<Exact> u{a.domain_begin(), a.domain_end()};
  const int p = 2 * std::max(a.degree, b.degree) + 1;  // enough for rational pieces, too
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    if (breaks[i] < a.domain_begin() || a.domain_end() < breaks[i + 1]) continue;
    for (int j = 0; j < p; ++j) u.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * Exact::ratio(j, p));
  }
  return u;
}

inline bool same_curve(const Curve<Exact>& a, const Curve<Exact>& b) {
  if (a.domain_begin() != b.domain_begin() || a.domain_end() != b.domain_end()) return false;
  for (const Exact& u : telling_parameters(a, b))
    if (homogeneous_point(a, u) != homogeneous_point(b, u)) return false;
  return true;
}

inline double largest_coordinate(const Curve<Exact>& curve) {
  double largest = 1;
  for (const auto& P : curve.points)
    for (int c = 0; c < 4; ++c) largest = std::max(largest, std::abs(P[c].to_double()));
  return largest;
}

inline std::vector<Exact> knots(std::initializer_list<const char*> texts) {
  std::vector<Exact> U;
  for (const char* text : texts) U.push_back(q(text));
  return U;
}

// Inputs from JSON text, with what was wrong with it.
inline Checked<Inputs<Exact>> inputs_of(const Algorithm& algorithm, const std::string& text) {
  const auto document = JsonDocument::parse("inputs", text);
  if (!document) return document.diagnostics;
  Diagnostics diagnostics;
  auto inputs = read_inputs(algorithm, Cursor(*document, diagnostics));
  if (!inputs || !diagnostics.empty()) return diagnostics;
  return std::move(*inputs);
}

inline Run<Exact> run_of(const char* id, const std::string& text) {
  const Algorithm& algorithm = *find_algorithm(id);
  const auto inputs = inputs_of(algorithm, text);
  INFO(to_string(inputs.diagnostics));
  REQUIRE(inputs);
  auto run = record<Exact>(algorithm, *inputs);
  INFO(to_string(run.diagnostics));
  REQUIRE(run);
  return std::move(*run);
}

// The value of that name: its numbers, or a point's coordinates.
inline std::vector<Exact> numbers_of(const Run<Exact>& run, const std::string& name) {
  const auto v = run.trace.find(name);
  INFO(name);
  REQUIRE(v);
  const auto numbers = run.trace.numbers(*v);
  return {numbers.begin(), numbers.end()};
}
inline Exact number_of(const Run<Exact>& run, const std::string& name) { return numbers_of(run, name).at(0); }
inline std::vector<Exact> point_of(const Run<Exact>& run, const std::string& name) {
  const auto P = numbers_of(run, name);
  return {P.at(0) / P.at(3), P.at(1) / P.at(3)};
}

}  // namespace blossom::test
