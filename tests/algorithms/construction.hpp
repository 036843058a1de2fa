#pragma once
// What the tests of constructed surfaces share: surfaces from a run, and comparing them with curves, exactly.

#include "algorithms/curves.hpp"

namespace blossom::test {

inline const Surface<Exact>& surface_of(const Run<Exact>& run) { return std::get<Surface<Exact>>(run.outcome); }

// The surface an algorithm makes of these inputs, recorded and unrecorded alike.
inline Surface<Exact> construct(const char* id, const Inputs<Exact>& inputs) {
  const Algorithm& algorithm = *find_algorithm(id);
  const auto recorded = record<Exact>(algorithm, inputs);
  INFO(to_string(recorded.diagnostics));
  REQUIRE(recorded);
  const auto plain = run_plain<Exact>(algorithm, inputs);
  REQUIRE(plain);
  CHECK(recorded->outcome == *plain);
  return surface_of(*recorded);
}

inline Surface<Exact> surface_from(const char* id, const std::string& json) {
  const auto inputs = inputs_of(*find_algorithm(id), json);
  INFO(to_string(inputs.diagnostics));
  REQUIRE(inputs);
  return construct(id, *inputs);
}

// What is said of inputs that are refused, when read or on the way.
inline std::string refusal(const char* id, const std::string& json) {
  const auto inputs = inputs_of(*find_algorithm(id), json);
  if (!inputs) return to_string(inputs.diagnostics);
  return to_string(record<Exact>(*find_algorithm(id), *inputs).diagnostics);
}

inline Exact random_between(std::mt19937& random, const Exact& begin, const Exact& end) {
  return begin + (end - begin) * random_ratio(random, 0, 1, 24);
}
inline Exact random_u(std::mt19937& random, const Surface<Exact>& s) {
  return random_between(random, s.knots[0][static_cast<std::size_t>(s.degree[0])],
                        s.knots[0][static_cast<std::size_t>(s.rows)]);
}
inline Exact random_v(std::mt19937& random, const Surface<Exact>& s) {
  return random_between(random, s.knots[1][static_cast<std::size_t>(s.degree[1])],
                        s.knots[1][static_cast<std::size_t>(s.columns)]);
}

inline Exact dot(const Point<Exact>& a, const Point<Exact>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Point<Exact> cross(const Point<Exact>& a, const Point<Exact>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// A curve's parameter that lies as far in its domain as t in [0, 1].
inline Exact at_share(const Curve<Exact>& curve, const Exact& t) {
  return curve.domain_begin() + (curve.domain_end() - curve.domain_begin()) * t;
}

}  // namespace blossom::test
