#pragma once
// Least-squares approximation: the B-spline curve of degree p with the control points P[0..n], n <= m, that begins in
// D[0], ends in D[m], and passes the points between as closely as it can: the sum of |D[k] - C(t_k)|^2 over k = 1..m-1
// is least (The NURBS Book 9.4.1; Shene, "Global Curve Approximation").
//
//   parameters  t_0..t_m as for interpolation, see parameters.hpp;
//   knots       d = (m+1)/(n-p+1), i = floor(j d), alpha = j d - i: u_{p+j} = (1-alpha) t_{i-1} + alpha t_i for
//               j = 1..n-p (NB 9.68, 9.69), so that every span holds a parameter;
//   equations   P[0] = D[0], P[n] = D[m], and for i = 1..n-1
//                   sum_j M[i][j] P[j] = sum_k N_{i,p}(t_k) D[k],   M[i][j] = sum_k N_{i,p}(t_k) N_{j,p}(t_k)
//               (the book has taken P[0] and P[n] to the right already, 9.63-9.67);
//   error       E = the largest of the distances gap[k] = |D[k] - C(t_k)|.
//
// With a tolerance in place of n: n = p, p+1, ... until E keeps it. With n = m the curve interpolates.

#include "kernel/blend_numbers.hpp"
#include "kernel/elimination.hpp"
#include "kernel/parameters.hpp"
#include "kernel/tolerance.hpp"

namespace blossom {

// a0 b0 + a1 b1 + ...
struct ProductSum {
  static constexpr std::string_view name = "product_sum";
  static constexpr std::string_view formula = "sum of a · b over the pairs a, b: {*}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(std::span<const S> pairs) {
    S sum(0);
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2) sum += pairs[i] * pairs[i + 1];
    return sum;
  }
  template <Scalar S>
  static bool defined(std::span<const S> pairs) {
    return pairs.size() % 2 == 0;
  }
};

// a B
struct Multiple {
  static constexpr std::string_view name = "multiple";
  static constexpr std::string_view formula = "{0} {1}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const S& a, const HPoint<S>& B) {
    return {a * B.x, a * B.y, a * B.z, a * B.w};
  }
};

// A + a B
struct AddMultiple {
  static constexpr std::string_view name = "add_multiple";
  static constexpr std::string_view formula = "{0} + {1} {2}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const S& a, const HPoint<S>& B) {
    return {A.x + a * B.x, A.y + a * B.y, A.z + a * B.z, A.w + a * B.w};
  }
};

// The length of a vector
struct Length {
  static constexpr std::string_view name = "length";
  static constexpr std::string_view formula = "|{0}|";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const HPoint<S>& A) {
    using std::sqrt;
    return sqrt(A.x * A.x + A.y * A.y + A.z * A.z);
  }
};

template <class R>
struct Approximation {
  Curve<typename R::Number> curve;
  Cells<HPoint<typename R::Number>, typename R::Id> P;
  Traced<typename R::Number, typename R::Id> error;
};

namespace approximating {

template <class R>
using Numbers = Cells<typename R::Number, typename R::Id>;

// The inner knots between the parameters, every (m+1)/(n-p+1)-th.
template <class R, class Degree>
Numbers<R> spread_knots(R& rec, const Numbers<R>& t, const Degree& p, int n) {
  auto phase = rec.phase({"knots"});
  const int m = t.size() - 1;
  const int spans = n - p.value + 1;
  Numbers<R> knots;
  for (int i = 0; i <= p.value; ++i) knots.push_back(t[0]);
  if (spans > 1) {
    const auto below = rec.input("h"_v, spans);
    for (int j = 1; j < spans; ++j) {
      const int i = j * (m + 1) / spans;
      const auto alpha = rec.apply(Fraction{}, "alpha"_v(j), rec.input("i"_v(j), j * (m + 1) % spans), below);
      knots.push_back(rec.apply(BlendNumbers{}, "U"_v(p.value + j), alpha, t[i - 1], t[i]));
    }
  }
  for (int i = 0; i <= p.value; ++i) knots.push_back(t[m]);
  return knots;
}

// N_{j,p}(t_k) of the points between the ends: p + 1 each, from the column first[k] on.
template <class R>
struct Rows {
  std::vector<int> first;
  int width;
  Numbers<R> entries;

  bool holds(int k, int j) const {
    const int from = first[static_cast<std::size_t>(k)];
    return from <= j && j < from + width;
  }
  auto at(int k, int j) const { return entries[(k - 1) * width + j - first[static_cast<std::size_t>(k)]]; }
};

template <class R, class Degree, class KnotList>
Rows<R> basis_rows(R& rec, const Numbers<R>& t, const Degree& p, const KnotList& U) {
  using S = typename R::Number;
  auto phase = rec.phase({"basis"});
  Rows<R> rows{std::vector<int>(static_cast<std::size_t>(t.size()), 0), p.value + 1, {}};
  for (int k = 1; k + 1 < t.size(); ++k) {
    const int from = row_span(std::span<const S>(U.value), p.value, t[k].value) - p.value;
    rows.first[static_cast<std::size_t>(k)] = from;
    for (int j = from; j <= from + p.value; ++j)
      rows.entries.push_back(rec.apply(BasisValue{}, "N"_v(k, j), rec.input("j"_v(k, j), j), p, t[k], U));
  }
  return rows;
}

// The normal equations, with those of the two ends around them, and their right-hand sides.
template <class R, class Points>
Band<R> normal_equations(R& rec, const Points& D, const Rows<R>& rows, int p, int n,
                         Cells<HPoint<typename R::Number>, typename R::Id>& right) {
  using S = typename R::Number;
  using Id = typename R::Id;
  auto phase = rec.phase({"normal"});
  const int m = D.size() - 1;
  Band<R> M(n + 1, 2 * p + 1);
  right.resize(n + 1);
  for (const int end : {0, n}) {
    M.set_row(end, end, end);
    M.set(end, end, rec.input("M"_v(end, end), S(1)));
    right.set(end, D[end == 0 ? 0 : m]);
  }
  for (int i = 1; i < n; ++i) {
    M.set_row(i, std::max(0, i - p), std::min(n, i + p));
    for (int j = M.begin(i); j <= M.end(i); ++j) {
      Numbers<R> pairs;
      for (int k = 1; k < m; ++k) {
        if (!rows.holds(k, i) || !rows.holds(k, j)) continue;
        pairs.push_back(rows.at(k, i));
        pairs.push_back(rows.at(k, j));
      }
      if (pairs.size() == 0)
        M.set(i, j, rec.input("M"_v(i, j), S(0)));
      else
        M.set(i, j, rec.apply(ProductSum{}, "M"_v(i, j), slice(pairs, 0, pairs.size())));
    }
    Traced<HPoint<S>, Id> sum{};
    bool any = false;
    for (int k = 1; k < m; ++k) {
      if (!rows.holds(k, i)) continue;
      if (any)
        sum = rec.apply(AddMultiple{}, "R"_v(i, k), sum, rows.at(k, i), D[k]);
      else
        sum = rec.apply(Multiple{}, "R"_v(i, k), rows.at(k, i), D[k]);
      any = true;
    }
    if (!any) throw KernelError{"count", "there are too many control points for these points: take fewer"};
    right.set(i, sum);
  }
  return M;
}

}  // namespace approximating

// With n + 1 control points. Preconditions: p <= n <= m; t as point_parameters gives them.
template <class R, class Points, class Degree>
Approximation<R> approximate_with(R& rec, const Points& D, const Cells<typename R::Number, typename R::Id>& t,
                                  const Degree& p, int n) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const int m = D.size() - 1;
  const auto knots = approximating::spread_knots(rec, t, p, n);
  const auto U = rec.apply(Gather{}, "U"_v, slice(knots, 0, knots.size()));

  Approximation<R> made;
  auto& curve = made.curve;
  auto& P = made.P;
  curve.degree = p.value;
  curve.knots = U.value;
  const auto rows = approximating::basis_rows(rec, t, p, U);
  auto M = approximating::normal_equations(rec, D, rows, p.value, n, P);
  {
    auto phase = rec.phase({"eliminate"});
    eliminate(rec, M, "count");
  }
  curve.points.resize(static_cast<std::size_t>(n) + 1);
  {
    auto phase = rec.phase({"solve"});
    solve(
        rec, M, P, [](int l) { return "P"_v(l); },
        [&](int l, const Traced<HPoint<S>, Id>& point) {
          curve.points[static_cast<std::size_t>(l)] = point.value;
          curve.points[static_cast<std::size_t>(l)].w = S(1);  // up to rounding it is
          rec.polar_net(point.id,
                        std::span<const S>(curve.knots)
                            .subspan(static_cast<std::size_t>(l) + 1, static_cast<std::size_t>(p.value)),
                        {});
        });
  }

  auto phase = rec.phase({"error"});
  Cells<S, Id> gaps;
  for (int k = 1; k < m; ++k) {
    Traced<HPoint<S>, Id> rest{D[k].value, D[k].id};
    for (int j = 0; j <= n; ++j)
      if (rows.holds(k, j)) rest = rec.apply(Reduce{}, "r"_v(k, j), rest, rows.at(k, j), P[j]);
    gaps.push_back(rec.apply(Length{}, "gap"_v(k), rest));
  }
  if (m > 1)
    made.error = rec.apply(Largest{}, "E"_v, slice(gaps, 0, gaps.size()));
  else
    made.error = rec.input("E"_v, S(0));
  return made;
}

// With `count` control points; 0: with as few as keep the tolerance. Preconditions: at least two points, none beside an
// equal one unless parameters are uniform; 1 <= degree <= points - 1; count 0 or from degree + 1 to points.
template <class R>
Curve<typename R::Number> approximation(const PointRow<typename R::Number>& points, int degree, int count,
                                        const typename R::Number& tolerance, Parametrization parametrization, R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const auto p = rec.input("p"_v, degree);
  const auto D = rec.inputs("D"_v, std::span<const HPoint<S>>(points.points));
  const auto given = [&](Curve<S> curve) {
    curve.dimension = points.dimension;
    return curve;
  };
  const auto parameters = [&] {
    auto phase = rec.phase({"parameters"});
    return point_parameters(rec, D, parametrization);
  };
  if (count > 0) {
    rec.input("count"_v, count);
    const auto t = parameters();
    return given(approximate_with(rec, D, t, p, count - 1).curve);
  }

  const auto tol = rec.input("tol"_v, tolerance);
  const auto rounding = rec.input("eps"_v, rounding_of(std::span<const HPoint<S>>(points.points)));
  const Cells<S, Id> t = parameters();
  for (int n = degree; n < D.size(); ++n) {
    auto phase = rec.phase({"try", n + 1, true});
    auto made = approximate_with(rec, D, t, p, n);
    if (rec.apply(Within{}, "ok"_v, made.error, tol, rounding).value == 1) return given(std::move(made.curve));
    if constexpr (R::recording)
      for (int i = 0; i <= n; ++i) rec.retire(made.P[i].id);
  }
  throw KernelError{"tolerance",
                    "cannot be kept even with as many control points as points: allow a larger error, or interpolate"};
}

}  // namespace blossom
