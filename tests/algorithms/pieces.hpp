#pragma once
// Curves that are parts of others, and both scalars of a technique at once.

#include "algorithms/curves.hpp"

namespace blossom::test {

// Whether `part` is `whole` over an interval [a, b] of whole's domain, which part's own domain is mapped to: p + 1
// parameters inside each span decide for a polynomial, twice as many for a rational curve in homogeneous coordinates.
inline bool is_part(const Curve<Exact>& part, const Curve<Exact>& whole, const Exact& a, const Exact& b) {
  const Exact from = part.domain_begin(), length = part.domain_end() - part.domain_begin();
  const auto to_whole = [&](const Exact& t) { return a + (b - a) * (t - from) / length; };
  for (std::size_t i = static_cast<std::size_t>(part.degree); i < part.points.size(); ++i) {
    const Exact &left = part.knots[i], &right = part.knots[i + 1];
    if (left == right) continue;
    for (int j = 1; j <= part.degree + 1; ++j) {
      const Exact t = left + (right - left) * Exact::ratio(j, part.degree + 2);
      if (homogeneous_point(part, t) != homogeneous_point(whole, to_whole(t))) return false;
    }
  }
  return true;
}
inline bool is_part(const Curve<Exact>& part, const Curve<Exact>& whole) {
  return is_part(part, whole, part.domain_begin(), part.domain_end());
}

inline bool is_clamped(const Curve<Exact>& curve) {
  return multiplicity<Exact>(curve.knots, curve.knots.front()) == curve.degree + 1 &&
         multiplicity<Exact>(curve.knots, curve.knots.back()) == curve.degree + 1;
}

// A clamped curve of degree p on simple knots 0, 1, .., spans, with plane points that are easy to tell apart.
inline Curve<Exact> plain_spline(int p, int spans) {
  std::vector<Exact> U(static_cast<std::size_t>(p) + 1, Exact(0));
  for (int i = 1; i < spans; ++i) U.push_back(i);
  U.insert(U.end(), static_cast<std::size_t>(p) + 1, Exact(spans));
  std::vector<PlanePoint> points;
  for (int i = 0; i < p + spans; ++i) points.push_back({i, (i * i * 7 + i) % 11, 1});
  return plane_curve(p, U, points);
}

// `body(curve)` for random curves of every kind: clamped or not, rational or not, with knots of up to p + 1 copies.
template <class Body>
void for_random_curves(unsigned seeds, Body&& body) {
  for (unsigned seed = 1; seed <= seeds; ++seed) {
    std::mt19937 random(seed);
    const auto curve = any_curve(random, random_int(random, 2, 3));
    INFO("seed " << seed << ": " << write_curve(curve));
    body(curve, random);
  }
}

}  // namespace blossom::test
