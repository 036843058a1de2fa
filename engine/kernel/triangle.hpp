#pragma once
// The triangle of affine combinations that de Boor's algorithm, knot insertion and Bezier decomposition share
// (The NURBS Book A5.1; Boehm 1980):
//
//     alpha[r][i] = (u - u_i) / (u_{i+p-r+1} - u_i)
//     P[r][i]     = (1 - alpha[r][i]) P[r-1][i-1] + alpha[r][i] P[r-1][i],     i = last-(p-s)+r .. last
//
// for r = 1..levels, where s is the multiplicity of u (at most p) and `last` the index of the last point in force. In
// blossom form P[r][i] = f(u^r, u_{i+1}, ..., u_{i+p-r}): level r exchanges one more knot for u.

#include <array>

#include "kernel/rules.hpp"

namespace blossom {

// The points of the newest level, P[i] at [i - (last-(p-s))]. `U` needs the knots u_{last-p+s+1} .. u_{last+p} only.
template <class R>
using TriangleRow = std::array<Traced<HPoint<typename R::Number>, typename R::Id>, max_degree + 1>;

// How a caller of the triangle names and keeps its points.
struct TriangleNames {
  NameMaker point;
  int shift = 0;          // added to i in names, where the knots are a window of a longer vector
  bool replaces = false;  // points a level replaces leave the picture (insertion); evaluation keeps them all
};

// Runs the triangle in place on `row` (p - s + 1 points on entry). After level r, entry j >= r holds
// P[r][last-(p-s)+j]; entry j < r still holds the left edge P[j][last-(p-s)+j]. `level_done(r)` is called after each
// level: insertion keeps the right edge there.
template <class R, class Knots, class Parameter, class LevelDone>
void triangle(R& rec, const Knots& U, const Parameter& u, TriangleRow<R>& row, int p, int s, int last, int levels,
              const TriangleNames& names, LevelDone&& level_done) {
  const int width = p - s;
  const int first = last - width;
  for (int r = 1; r <= levels; ++r) {
    auto before = row[static_cast<std::size_t>(r) - 1];
    for (int j = r; j <= width; ++j) {
      const int i = first + j;
      const auto alpha = rec.apply(Ratio{}, "alpha"_v(r, i + names.shift), u, U[i], U[i + p - r + 1]);
      auto made = rec.apply(Blend{}, names.point(r, i + names.shift), alpha, before, row[static_cast<std::size_t>(j)]);
      if constexpr (R::recording)
        if (names.replaces && j > r) rec.retire(before.id);
      before = std::move(row[static_cast<std::size_t>(j)]);
      row[static_cast<std::size_t>(j)] = std::move(made);
    }
    level_done(r);
  }
}

}  // namespace blossom
