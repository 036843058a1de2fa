#pragma once
// What interpolation and approximation of a net of points by a surface share (The NURBS Book 9.2.5, 9.4.3): the points
// Q[k][l], and in each direction parameters (averaged over all columns, or all rows: A9.3), knots and basis functions.

#include "kernel/interpolation.hpp"
#include "kernel/skinning.hpp"
#include "kernel/surface_lines.hpp"

namespace blossom::tensor {

// The points as given. Rows are points of one u, columns of one v.
template <class R>
class GivenNet {
 public:
  using S = typename R::Number;
  using Id = typename R::Id;

  GivenNet(R& rec, const PointNet<S>& net) : columns(net.columns) {
    for (int k = 0; k < net.rows; ++k)
      rows_.push_back(
          rec.inputs("Q"_v, k, std::span<const HPoint<S>>(&net.at(k, 0), static_cast<std::size_t>(net.columns))));
  }
  int rows() const { return static_cast<int>(rows_.size()); }
  int length(Direction d) const { return d == Direction::u ? rows() : columns; }
  Ref<HPoint<S>, Id> at(int k, int l) const { return rows_[static_cast<std::size_t>(k)][l]; }

  int columns;

 private:
  std::vector<Givens<HPoint<S>, Id>> rows_;
};

// In one direction: the degree, the parameter of each row (column), the knots, and these as one value.
template <class R>
struct Course {
  using S = typename R::Number;
  using Id = typename R::Id;
  Traced<int, Id> degree;
  Cells<S, Id> t;
  Traced<std::vector<S>, Id> knots;

  // The arguments of a polar label: of the basis function j, and of a point at t[k].
  std::vector<S> arguments(int j) const {
    const auto from = knots.value.begin() + j + 1;
    return {from, from + degree.value};
  }
  std::vector<S> at(int k) const { return std::vector<S>(static_cast<std::size_t>(degree.value), t[k].value); }
};

// The parameters u[k] of the rows, or v[l] of the columns: the mean over all columns (rows) of what each alone would
// have. One whose points all coincide has no say. Error: neighbours coincide as a whole.
template <class R>
Cells<typename R::Number, typename R::Id> averaged_parameters(R& rec, const GivenNet<R>& Q, Direction d,
                                                              Parametrization parametrization) {
  std::vector<MadeCurve<R>> lines(static_cast<std::size_t>(Q.length(d)));
  for (int line = 0; line < Q.length(d); ++line)
    for (int at = 0; at < Q.length(other(d)); ++at) {
      const auto [i, j] = cell(other(d), line, at);
      lines[static_cast<std::size_t>(line)].P.push_back(Q.at(i, j));
    }
  auto phase = rec.phase({"parameters"});
  try {
    return skin::parameters(rec, lines, parametrization,
                            [d](int k) { return outer(d == Direction::u ? "u"_v(k) : "v"_v(k)); });
  } catch (const KernelError&) {
    throw KernelError{"points", d == Direction::u
                                    ? "neighbouring rows of points coincide: take \"uniform\" parameters, or one row"
                                    : "neighbouring columns of points coincide: take \"uniform\" parameters, or one "
                                      "column"};
  }
}

// All knots, of which the inner ones have just been made, as one value outside of the phase.
template <class R>
Traced<std::vector<typename R::Number>, typename R::Id> knot_vector(
    R& rec, Direction d, const Cells<typename R::Number, typename R::Id>& knots) {
  return rec.apply(Gather{}, outer(d == Direction::u ? "U"_v() : "V"_v()), slice(knots, 0, knots.size()));
}

// The phase of everything that belongs to one direction.
constexpr Phase course_phase(Direction d) {
  return {.id = d == Direction::u ? "along_u" : "along_v", .index = -1, .scoped = true};
}

// The labels of the points Q[k][l]: where the surface passes through them, they are its values.
template <class R>
void label_points(R& rec, const GivenNet<R>& Q, const Course<R>& u, const Course<R>& v) {
  if constexpr (R::recording)
    for (int k = 0; k < Q.rows(); ++k)
      for (int l = 0; l < Q.columns; ++l) rec.polar_net(Q.at(k, l).id, u.at(k), v.at(l));
}

// A surface of the two courses, whose points are still to come.
template <class R>
Surface<typename R::Number> surface_over(const Course<R>& u, const Course<R>& v) {
  Surface<typename R::Number> surface;
  surface.degree = {u.degree.value, v.degree.value};
  surface.knots = {u.knots.value, v.knots.value};
  surface.rows = static_cast<int>(u.knots.value.size()) - u.degree.value - 1;
  surface.columns = static_cast<int>(v.knots.value.size()) - v.degree.value - 1;
  surface.points.resize(static_cast<std::size_t>(surface.rows) * static_cast<std::size_t>(surface.columns));
  return surface;
}

}  // namespace blossom::tensor
