#pragma once
// Comparing surfaces, and their labels with the blossom of a surface.

#include "algorithms/curves.hpp"
#include "kernel/blossom.hpp"

namespace blossom::test {

// A row of the net as a curve over V, or a column as one over U.
inline Curve<Exact> line_of(const Surface<Exact>& surface, bool column, int line) {
  Curve<Exact> curve;
  curve.degree = surface.degree[column ? 0 : 1];
  curve.knots = surface.knots[column ? 0 : 1];
  curve.dimension = 3;
  curve.rational = surface.rational;
  for (int i = 0; i < (column ? surface.rows : surface.columns); ++i)
    curve.points.push_back(column ? surface.at(i, line) : surface.at(line, i));
  return curve;
}

// The blossom of the piece of a surface on the spans k, l, at the u-arguments s and the v-arguments t.
inline HPoint<Exact> surface_blossom(const Surface<Exact>& surface, int k, int l, const std::vector<Exact>& s,
                                     const std::vector<Exact>& t) {
  Curve<Exact> across = line_of(surface, true, 0);
  for (int i = 0; i < surface.rows; ++i)
    across.points[static_cast<std::size_t>(i)] =
        blossom::blossom<Exact>(line_of(surface, false, i), l, std::span<const Exact>(t));
  return blossom::blossom<Exact>(across, k, std::span<const Exact>(s));
}

// Whether a piece near the arguments has this homogeneous value there (divided: its point).
inline bool is_surface_blossom_value(const Surface<Exact>& surface, const PolarLabel<Exact>& label,
                                     NumbersView<Exact> numbers, bool divided) {
  const auto spans = [&](std::size_t d, const std::vector<Exact>& t) {
    std::vector<int> found;
    const auto& U = surface.knots[d];
    const auto [least, greatest] = std::minmax_element(t.begin(), t.end());
    for (std::size_t k = static_cast<std::size_t>(surface.degree[d]);
         k + static_cast<std::size_t>(surface.degree[d]) + 1 < U.size(); ++k)
      if (U[k] < U[k + 1] && !(U[k + 1] < *least) && !(*greatest < U[k])) found.push_back(static_cast<int>(k));
    return found;
  };
  if (static_cast<int>(label.u.size()) != surface.degree[0] || static_cast<int>(label.v.size()) != surface.degree[1])
    return false;
  for (const int k : spans(0, label.u))
    for (const int l : spans(1, label.v)) {
      auto P = surface_blossom(surface, k, l, label.u, label.v);
      if (divided && P.w == Exact(0)) continue;
      if (divided) P = P / P.w;
      if (P.x == numbers[0] && P.y == numbers[1] && P.z == numbers[2] && P.w == numbers[3]) return true;
    }
  return false;
}

// Parameters in every span of both knot vectors, enough to tell two (rational) surfaces apart in one direction.
inline std::vector<Exact> telling(const Surface<Exact>& a, const Surface<Exact>& b, std::size_t d) {
  const auto line = [&](const Surface<Exact>& s) { return line_of(s, d == 0, 0); };
  return telling_parameters(line(a), line(b));
}

inline bool same_surface(const Surface<Exact>& a, const Surface<Exact>& b) {
  for (std::size_t d = 0; d < 2; ++d) {
    const auto line_a = line_of(a, d == 0, 0), line_b = line_of(b, d == 0, 0);
    if (line_a.domain_begin() != line_b.domain_begin() || line_a.domain_end() != line_b.domain_end()) return false;
  }
  for (const Exact& u : telling(a, b, 0))
    for (const Exact& v : telling(a, b, 1))
      if (homogeneous_point(a, u, v) != homogeneous_point(b, u, v)) return false;
  return true;
}

// Random surfaces: of degrees 1 to 3, clamped or not, rational or not.
inline Surface<Exact> any_surface(std::mt19937& random) {
  return random_surface(random, random_int(random, 1, 3), random_int(random, 1, 3), random_int(random, 1, 2),
                        random_int(random, 0, 2) > 0, random_int(random, 0, 1) == 1);
}

inline Exact any_parameter(std::mt19937& random, const Surface<Exact>& surface, std::size_t d) {
  return any_parameter(random, line_of(surface, d == 0, 0));
}

}  // namespace blossom::test
