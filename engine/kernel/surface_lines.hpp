#pragma once
// A surface as rows and columns of curves: S(u, v) = sum_i N_i(u) (sum_j N_j(v) P[i][j]) (The NURBS Book 3.4). What is
// done to a curve is done to a surface by doing it to every column (in u) or to every row (in v) of its control net:
// each in a scoped phase of its own, in which the curve's algorithm runs as it is.

#include <array>
#include <cassert>

#include "kernel/recorder.hpp"
#include "kernel/rules.hpp"

namespace blossom::tensor {

// The parameter that is worked on. In u the curves are the columns P[.][j] over the knots U, in v the rows P[i][.] over
// the knots V.
enum class Direction { u = 0, v = 1 };

constexpr Direction other(Direction d) { return d == Direction::u ? Direction::v : Direction::u; }
constexpr std::size_t index(Direction d) { return static_cast<std::size_t>(d); }

// The phase of one row or column.
constexpr Phase line_phase(Direction d, int line) {
  return {.id = d == Direction::u ? "column" : "row", .index = line, .scoped = true};
}

// The indices i, j of the net's point that is point `at` of a row or column.
constexpr std::array<int, 2> cell(Direction d, int line, int at) {
  return d == Direction::u ? std::array{at, line} : std::array{line, at};
}

// A surface as given: its knots as the values U, U[i], V, V[j], its net as P[i][j], with their polar labels.
template <class R>
class GivenSurface {
 public:
  using S = typename R::Number;
  using Id = typename R::Id;

  GivenSurface(R& rec, const Surface<S>& given)
      : surface(given),
        lists{rec.list("U"_v, surface.knots[0]), rec.list("V"_v, surface.knots[1])},
        knots{rec.inputs("U"_v, std::span<const S>(surface.knots[0])),
              rec.inputs("V"_v, std::span<const S>(surface.knots[1]))} {
    const auto [p, q] = surface.degree;
    rows_.reserve(static_cast<std::size_t>(surface.rows));
    for (int i = 0; i < surface.rows; ++i) {
      const auto row = rec.inputs("P"_v, i, std::span<const HPoint<S>>(&surface.at(i, 0), columns()));
      rows_.push_back(row);
      if constexpr (R::recording)
        for (int j = 0; j < surface.columns; ++j)
          rec.polar_net(row[j].id, std::span<const S>(surface.knots[0]).subspan(place(i) + 1, place(p)),
                        std::span<const S>(surface.knots[1]).subspan(place(j) + 1, place(q)));
    }
  }

  int degree(Direction d) const { return surface.degree[index(d)]; }
  int lines(Direction d) const { return d == Direction::u ? surface.columns : surface.rows; }
  int length(Direction d) const { return d == Direction::u ? surface.rows : surface.columns; }
  Ref<HPoint<S>, Id> at(int i, int j) const { return rows_[place(i)][j]; }

  // A row or column as a curve.
  MadeCurve<R> line(Direction d, int line) const {
    MadeCurve<R> curve;
    curve.degree = degree(d);
    curve.dimension = 3;
    curve.rational = surface.rational;
    const auto& U = knots[index(d)];
    curve.U.reserve(U.size());
    for (int i = 0; i < U.size(); ++i) curve.U.push_back(U[i]);
    curve.P.reserve(length(d));
    for (int i = 0; i < length(d); ++i) {
      const auto [row, column] = cell(d, line, i);
      curve.P.push_back(at(row, column));
    }
    return curve;
  }

  const Surface<S>& surface;
  std::array<Traced<std::span<const S>, Id>, 2> lists;  // each knot vector as one value
  std::array<Givens<S, Id>, 2> knots;

 private:
  std::vector<Givens<HPoint<S>, Id>> rows_;

  static std::size_t place(int i) { return static_cast<std::size_t>(i); }
  std::size_t columns() const { return place(surface.columns); }
};

// A surface made of rows or columns that were made one by one.
template <class R>
class SurfaceOfLines {
 public:
  using S = typename R::Number;

  SurfaceOfLines(const Surface<S>& like, Direction d) : direction_(d) {
    made_.degree = like.degree;
    made_.knots = like.knots;
    made_.rational = like.rational;
    made_.rows = like.rows;
    made_.columns = like.columns;
  }

  // The degree and knots along the lines, which are those of any of them.
  void along(int degree, std::span<const S> knots) {
    made_.degree[index(direction_)] = degree;
    made_.knots[index(direction_)].assign(knots.begin(), knots.end());
    const int length = static_cast<int>(knots.size()) - degree - 1;
    (direction_ == Direction::u ? made_.rows : made_.columns) = length;
    made_.points.resize(static_cast<std::size_t>(made_.rows) * static_cast<std::size_t>(made_.columns));
  }

  // The points P[first], P[first+1]... become those of a line, and values `name`[i][j] outside of its phase.
  template <class Points>
  void set_line(R& rec, const NameMaker& name, int line, const Points& P, int first) {
    const int length = direction_ == Direction::u ? made_.rows : made_.columns;
    auto step = rec.one_step();
    for (int at = 0; at < length; ++at) {
      const auto [i, j] = cell(direction_, line, at);
      auto& point = made_.at(i, j);
      point = rec.apply(Same{}, outer(name(i, j)), P[first + at]).value;
      if (!made_.rational) point.w = S(1);  // up to rounding it is
    }
  }

  Surface<S> take() { return std::move(made_); }

 private:
  Direction direction_;
  Surface<S> made_;
};

}  // namespace blossom::tensor
