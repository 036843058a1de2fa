#pragma once
// The Bernstein polynomials of degree n at u, by their recurrence, and the point of the Bezier curve that they make
// (The NURBS Book 1.3, eqs. 1.8-1.12, A1.2, A1.3; Shene, "Bezier Curves"):
//
//     B[0][0] = 1,   B[i][r] = (1 - u) B[i][r-1] + u B[i-1][r-1],   r = 1..n, i = 0..r,
//
// where B[-1][r-1] = B[r][r-1] = 0, so that the first has only the first part and the last only the second. They sum to
// 1 on each level. C = sum of B[i][n] P_i.

#include "kernel/basis_functions.hpp"
#include "kernel/blend_numbers.hpp"

namespace blossom {

// (1 - u) A
struct RestOf {
  static constexpr std::string_view name = "rest_of";
  static constexpr std::string_view formula = "(1 - {0}) {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& u, const S& A) {
    return (S(1) - u) * A;
  }
};

// u A
struct PartOf {
  static constexpr std::string_view name = "part_of";
  static constexpr std::string_view formula = "{0} {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& u, const S& A) {
    return u * A;
  }
};

// Preconditions: a polynomial Bezier curve on [0, 1]; u in [0, 1].
template <class R>
HPoint<typename R::Number> bernstein(const Curve<typename R::Number>& curve, const typename R::Number& parameter,
                                     R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const int n = curve.degree;
  const auto u = rec.input("u"_v, parameter);
  rec.input("n"_v, n);
  const auto P = rec.inputs("P"_v, std::span<const HPoint<S>>(curve.points));
  if constexpr (R::recording)
    for (int i = 0; i <= n; ++i) rec.polar_bezier(P[i].id, i, n);

  Cells<S, Id> B;
  B.push_back(rec.input("B"_v(0, 0), S(1)));
  for (int r = 1; r <= n; ++r) {
    auto phase = rec.phase({"degree", r});
    Cells<S, Id> next;
    next.push_back(rec.apply(RestOf{}, "B"_v(0, r), u, B[0]));
    for (int i = 1; i < r; ++i) next.push_back(rec.apply(BlendNumbers{}, "B"_v(i, r), u, B[i], B[i - 1]));
    next.push_back(rec.apply(PartOf{}, "B"_v(r, r), u, B[r - 1]));
    B = std::move(next);
  }
  auto phase = rec.phase({"point"});
  rec.apply(Total{}, "sum"_v, slice(B, 0, n + 1));
  auto sum = rec.apply(Share{}, "T"_v(0), B[0], P[0]);
  for (int i = 1; i <= n; ++i) sum = rec.apply(AddShare{}, "T"_v(i), sum, B[i], P[i]);
  return rec.apply(Same{}, "C"_v, sum).value;
}

}  // namespace blossom
