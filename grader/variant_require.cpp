// What "require" may demand of the control points of each curve.

#include <algorithm>

#include "grader/variant_spec.hpp"

namespace blossom {
namespace {

using Points = std::span<const PlainPoint>;

PlainPoint cross(const PlainPoint& a, const PlainPoint& b, const PlainPoint& c) {
  const PlainPoint u{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

bool distinct(Points P) {
  for (std::size_t i = 0; i < P.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (P[i] == P[j]) return false;
  return true;
}

bool no_three_collinear(Points P) {
  const PlainPoint zero{};
  for (std::size_t i = 0; i < P.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t k = 0; k < j; ++k)
        if (cross(P[k], P[j], P[i]) == zero) return false;
  return true;
}

// In this order the corners of a convex polygon: all other points lie on the same side of each edge.
bool convex(Points P) {
  int side = 0;
  for (std::size_t i = 0; i < P.size(); ++i) {
    const std::size_t next = (i + 1) % P.size();
    for (std::size_t j = 0; j < P.size(); ++j) {
      if (j == i || j == next) continue;
      const Exact turn = cross(P[i], P[next], P[j])[2];
      const int here = turn < Exact(0) ? -1 : Exact(0) < turn ? 1 : 0;
      if (here == 0 || here == -side) return false;
      side = here;
    }
  }
  return true;
}

bool x_increasing(Points P) {
  return std::ranges::adjacent_find(P, [](const auto& a, const auto& b) { return b[0] <= a[0]; }) == P.end();
}

}  // namespace

const std::vector<Requirement>& requirements() {
  static const std::vector<Requirement> all{{"points distinct", false, distinct},
                                            {"points convex", true, convex},
                                            {"no three points collinear", false, no_three_collinear},
                                            {"x increasing", false, x_increasing}};
  return all;
}

}  // namespace blossom
