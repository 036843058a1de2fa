#pragma once
// Global interpolation: the B-spline curve of degree p through the points D[0..n], C(t_k) = D[k], with given
// derivatives at the ends where wanted (The NURBS Book 9.2.1, A9.1, and 9.2.2; Shene, "Global Curve Interpolation").
//
//   parameters  t_0 = 0 < ... < t_n = 1, see parameters.hpp;
//   knots       by averaging: U = 0^{p+1}, mean(s_j..s_{j+p-1}) for j = 1..N-p, 1^{p+1}, where s are the parameters of
//               the N + 1 equations: t_k for each point, and t_0 or t_n once more for a derivative there (NB 9.8, 9.9);
//               "universal": uniform knots j/(N-p+1), and t_k the place where the basis function of its row is largest;
//   system      a row sum_j N_{j,p}(t_k) P[j] = D[k] for each point; the row of a derivative stands next to that of its
//               end: sum_j N'_{j,p}(t) P[j] = T (NB 9.11, 9.12 are these rows, with the end point's already taken off);
//   elimination without pivoting: each t lies inside its basis function's support (Schoenberg and Whitney).

#include "kernel/elimination.hpp"
#include "kernel/parameters.hpp"

namespace blossom {

// N'_{j,q}(v) over the knots V, from the right; at the last knot from the left
struct BasisSlope {
  static constexpr std::string_view name = "basis_slope";
  static constexpr std::string_view formula = "slope of N_({0},{1}) at {2}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(int j, int q, const S& v, std::span<const S> V) {
    const auto share = [&](int i) {
      const S width = V[static_cast<std::size_t>(i + q)] - V[static_cast<std::size_t>(i)];
      return width == S(0) ? S(0) : S(basis_function(V, q - 1, i, v) / width);
    };
    return S(q) * (share(j) - share(j + 1));
  }
  template <Scalar S>
  static bool defined(int j, int q, const S& v, std::span<const S> V) {
    return BasisValue::defined<S>(j, q, v, V);
  }
};

// A vector, given by its coordinates like a point
struct Direction {
  static constexpr std::string_view name = "direction";
  static constexpr std::string_view formula = "the vector {0}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A) {
    return {A.x, A.y, A.z, S(0)};
  }
};

namespace interpolating {

// Which point each row of the system is about, and whether it asks for the derivative there.
struct Row {
  int point;
  bool tangent;
};

inline std::vector<Row> rows(int n, bool start_tangent, bool end_tangent) {
  std::vector<Row> rows;
  for (int k = 0; k <= n; ++k) {
    if (k == n && end_tangent) rows.push_back({k, true});
    rows.push_back({k, false});
    if (k == 0 && start_tangent) rows.push_back({k, true});
  }
  return rows;
}

// The inner knots as means of p neighbouring parameters, one parameter for each row.
template <class R>
Cells<typename R::Number, typename R::Id> averaged_knots(R& rec, const Cells<typename R::Number, typename R::Id>& t,
                                                         const std::vector<Row>& rows, int p) {
  auto phase = rec.phase({"knots"});
  const int N = static_cast<int>(rows.size()) - 1;
  Cells<typename R::Number, typename R::Id> s, knots;
  for (const Row& row : rows) s.push_back(t[row.point]);
  for (int i = 0; i <= p; ++i) knots.push_back(s[0]);
  for (int j = 1; j <= N - p; ++j) knots.push_back(rec.apply(Mean{}, "U"_v(j + p), slice(s, j, p)));
  for (int i = 0; i <= p; ++i) knots.push_back(s[N]);
  return knots;
}

// Evenly spaced knots over [0, 1].
template <class R>
Cells<typename R::Number, typename R::Id> uniform_knots(R& rec, int N, int p) {
  using S = typename R::Number;
  auto phase = rec.phase({"knots"});
  Cells<S, typename R::Id> knots;
  const auto begin = rec.input("U"_v(p), S(0));
  const auto end = rec.input("U"_v(N + 1), S(1));
  const auto spans = rec.input("h"_v, N - p + 1);
  for (int i = 0; i <= p; ++i) knots.push_back(begin);
  for (int j = 1; j <= N - p; ++j) knots.push_back(rec.apply(Fraction{}, "U"_v(j + p), rec.input("j"_v(j), j), spans));
  for (int i = 0; i <= p; ++i) knots.push_back(end);
  return knots;
}

}  // namespace interpolating

// Preconditions: at least two points; degree at least 1, with a tangent at least 2, and at most points + tangents - 1;
// each tangent a row of none or one. Errors: see point_parameters and eliminate.
template <class R>
Curve<typename R::Number> interpolation(const PointRow<typename R::Number>& points, int degree,
                                        Parametrization parametrization,
                                        const PointRow<typename R::Number>& start_tangent,
                                        const PointRow<typename R::Number>& end_tangent, R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const auto p = rec.input("p"_v, degree);
  const auto D = rec.inputs("D"_v, std::span<const HPoint<S>>(points.points));
  const bool at_start = !start_tangent.points.empty(), at_end = !end_tangent.points.empty();
  Traced<HPoint<S>, Id> T[2];
  if (at_start) T[0] = rec.input("T"_v(0), start_tangent.points.front());
  if (at_end) T[1] = rec.input("T"_v(1), end_tangent.points.front());
  const auto rows = interpolating::rows(D.size() - 1, at_start, at_end);
  const int N = static_cast<int>(rows.size()) - 1;

  Cells<S, Id> t, knots;
  if (parametrization != Parametrization::universal) {
    {
      auto phase = rec.phase({"parameters"});
      t = point_parameters(rec, D, parametrization);
    }
    knots = interpolating::averaged_knots(rec, t, rows, degree);
  } else {
    knots = interpolating::uniform_knots(rec, N, degree);
  }
  const auto U = rec.apply(Gather{}, "U"_v, slice(knots, 0, knots.size()));
  if (parametrization == Parametrization::universal) {
    auto phase = rec.phase({"parameters"});
    for (int l = 0; l <= N; ++l)
      if (const auto& row = rows[static_cast<std::size_t>(l)]; !row.tangent)
        t.push_back(rec.apply(Peak{}, "t"_v(row.point), rec.input("i"_v(row.point), l), p, U));
  }

  Band<R> A(N + 1, degree + 1);
  Cells<HPoint<S>, Id> right;
  {
    auto phase = rec.phase({"system"});
    for (int l = 0; l <= N; ++l) {
      const auto& row = rows[static_cast<std::size_t>(l)];
      const auto v = t[row.point];
      const bool begin = row.point == 0, end = row.point == D.size() - 1;
      // At the ends all but the first (last) function vanish, and all but two of the slopes.
      const int k = row_span(std::span<const S>(U.value), degree, v.value);
      const int from = begin ? 0 : end ? N - (row.tangent ? 1 : 0) : k - degree;
      const int to = end ? N : begin ? (row.tangent ? 1 : 0) : k;
      A.set_row(l, from, to);
      for (int j = from; j <= to; ++j) {
        const auto column = rec.input("j"_v(l, j), j);
        if (row.tangent)
          A.set(l, j, rec.apply(BasisSlope{}, "N"_v(l, j), column, p, v, U));
        else
          A.set(l, j, rec.apply(BasisValue{}, "N"_v(l, j), column, p, v, U));
      }
      if (row.tangent)
        right.push_back(rec.apply(Direction{}, "V"_v(begin ? 0 : 1), T[begin ? 0 : 1]));
      else
        right.push_back(D[row.point]);
    }
  }
  {
    auto phase = rec.phase({"eliminate"});
    eliminate(rec, A, "points");
  }

  Curve<S> curve;
  curve.degree = degree;
  curve.dimension = points.dimension;
  for (const auto* tangent : {&start_tangent, &end_tangent})
    if (!tangent->points.empty()) curve.dimension = std::max(curve.dimension, tangent->dimension);
  curve.knots = U.value;
  curve.points.resize(rows.size());
  auto phase = rec.phase({"solve"});
  solve(
      rec, A, right, [](int l) { return "P"_v(l); },
      [&](int l, const Traced<HPoint<S>, Id>& P) {
        auto& point = curve.points[static_cast<std::size_t>(l)];
        point = P.value;
        point.w = S(1);  // up to rounding it is
        rec.polar_net(
            P.id,
            std::span<const S>(curve.knots).subspan(static_cast<std::size_t>(l) + 1, static_cast<std::size_t>(degree)),
            {});
      });
  return curve;
}

}  // namespace blossom
