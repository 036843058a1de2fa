#pragma once
// The basis functions at u, step by step, and the point they make (The NURBS Book 2.2, 2.5, A2.2; Shene, "B-spline
// Basis Functions: Computation Examples"). With span k:
//
//     N[k][0] = 1
//     N[i][r] = (u - u_i)/(u_{i+r} - u_i) N[i][r-1] + (u_{i+r+1} - u)/(u_{i+r+1} - u_{i+1}) N[i+1][r-1],
//     r = 1..p, i = k-r..k,
//
// where the first of them has no part that rises (N[k-r][r-1] = 0) and the last none that falls (N[k+1][r-1] = 0). The
// p + 1 functions of degree p sum to 1, and the point is
//
//     C = sum of N[i][p] P_i;   rational:  R[i] = N[i][p] w_i / sum of N[j][p] w_j,  C = sum of R[i] P_i  (eq. 4.2).

#include "kernel/error.hpp"
#include "kernel/rules.hpp"

namespace blossom {

// The function of degree 0 that is not zero at u
struct BasisStart {
  static constexpr std::string_view name = "basis_start";
  static constexpr std::string_view formula = "1 on the span k = {0}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(int) {
    return S(1);
  }
};

// The two halves of the recurrence, and the whole of it
struct CoxRising {
  static constexpr std::string_view name = "cox_rising";
  static constexpr std::string_view formula = "({0} - {1}) / ({2} - {1}) · {3}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& u, const S& a, const S& b, const S& N) {
    return (u - a) / (b - a) * N;
  }
  template <Scalar S>
  static bool defined(const S&, const S& a, const S& b, const S&) {
    return !(a == b);
  }
};
struct CoxFalling {
  static constexpr std::string_view name = "cox_falling";
  static constexpr std::string_view formula = "({2} - {0}) / ({2} - {1}) · {3}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& u, const S& a, const S& b, const S& N) {
    return (b - u) / (b - a) * N;
  }
  template <Scalar S>
  static bool defined(const S&, const S& a, const S& b, const S&) {
    return !(a == b);
  }
};
struct CoxDeBoor {
  static constexpr std::string_view name = "cox_de_boor";
  static constexpr std::string_view formula = "({0} - {1}) / ({2} - {1}) · {3} + ({5} - {0}) / ({5} - {4}) · {6}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& u, const S& a, const S& b, const S& N, const S& c, const S& d, const S& M) {
    return CoxRising::apply<S>(u, a, b, N) + CoxFalling::apply<S>(u, c, d, M);
  }
  template <Scalar S>
  static bool defined(const S&, const S& a, const S& b, const S&, const S& c, const S& d, const S&) {
    return !(a == b) && !(c == d);
  }
};

// The weight of a control point
struct WeightOf {
  static constexpr std::string_view name = "weight_of";
  static constexpr std::string_view formula = "weight of {0}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const HPoint<S>& A) {
    return A.w;
  }
};

// N w
struct BasisTimesWeight {
  static constexpr std::string_view name = "basis_times_weight";
  static constexpr std::string_view formula = "{0} · {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& N, const S& w) {
    return N * w;
  }
};

// a A, the first term of a sum of points that is no point yet
struct Share {
  static constexpr std::string_view name = "share";
  static constexpr std::string_view formula = "{0} · {1}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const S& a, const HPoint<S>& A) {
    return {a * A.x, a * A.y, a * A.z, a * A.w};
  }
};

// T + a A
struct AddShare {
  static constexpr std::string_view name = "add_share";
  static constexpr std::string_view formula = "{0} + {1} · {2}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& T, const S& a, const HPoint<S>& A) {
    return {T.x + a * A.x, T.y + a * A.y, T.z + a * A.z, T.w + a * A.w};
  }
};

namespace basis {

// N[k-p][p] .. N[k][p].
template <class R, class Knots, class Parameter, class Span>
Cells<typename R::Number, typename R::Id> triangle(R& rec, const Knots& U, const Parameter& u, int p, const Span& k) {
  Cells<typename R::Number, typename R::Id> N;  // N[i] of the newest degree at i - (k-p)
  N.resize(p + 1);
  N.set(p, rec.apply(BasisStart{}, "N"_v(k.value, 0), k));
  for (int r = 1; r <= p; ++r) {
    for (int i = k.value - r; i <= k.value; ++i) {
      const int at = i - (k.value - p);
      const auto name = "N"_v(i, r);
      if (i == k.value - r)
        N.set(at, rec.apply(CoxFalling{}, name, u, U[i + 1], U[i + r + 1], N[at + 1]));
      else if (i == k.value)
        N.set(at, rec.apply(CoxRising{}, name, u, U[i], U[i + r], N[at]));
      else
        N.set(at, rec.apply(CoxDeBoor{}, name, u, U[i], U[i + r], N[at], U[i + 1], U[i + r + 1], N[at + 1]));
    }
  }
  return N;
}

// What each of the points P_first, ... counts at u, with its weight: R[i]. Error: the weights cancel out.
template <class R, class Points>
Cells<typename R::Number, typename R::Id> with_weights(R& rec, const Cells<typename R::Number, typename R::Id>& N,
                                                       const Points& P, int first) {
  using S = typename R::Number;
  Cells<S, typename R::Id> products, shares;
  for (int j = 0; j < N.size(); ++j) {
    const auto w = rec.apply(WeightOf{}, "w"_v(first + j), P[first + j]);
    products.push_back(rec.apply(BasisTimesWeight{}, "g"_v(first + j), N[j], w));
  }
  const auto all = rec.apply(Total{}, "W"_v, slice(products, 0, products.size()));
  if (all.value == S(0)) throw KernelError{"u", "the weight of the point at this parameter is 0: it lies at infinity"};
  for (int j = 0; j < N.size(); ++j) shares.push_back(rec.apply(Quotient{}, "R"_v(first + j), products[j], all));
  return shares;
}

}  // namespace basis

// Preconditions: a valid curve, u in its domain. Errors: the weight at u is zero; a control point is at infinity.
template <class R>
HPoint<typename R::Number> basis_combination(const Curve<typename R::Number>& curve,
                                             const typename R::Number& parameter, R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const int p = curve.degree;
  const auto degree = rec.input("p"_v, p);
  const auto u = rec.input("u"_v, parameter);
  const auto knots = rec.list("U"_v, curve.knots);
  const auto U = rec.inputs("U"_v, std::span<const S>(curve.knots));
  const auto P = rec.inputs("P"_v, std::span<const HPoint<S>>(curve.points));
  if constexpr (R::recording)
    for (int i = 0; i < P.size(); ++i) rec.polar_knots(P[i].id, U[i + 1].id, p);

  const auto k = rec.apply(FindSpan{}, "k"_v, degree, u, knots);
  const int first = k.value - p;
  const auto N = basis::triangle(rec, U, u, p, k);
  rec.apply(Total{}, "sum"_v, slice(N, 0, p + 1));
  const auto shares = curve.rational ? basis::with_weights(rec, N, P, first) : N;

  Traced<HPoint<S>, Id> sum{};
  bool begun = false;
  for (int i = first; i <= k.value; ++i) {
    const auto share = shares[i - first];
    const auto add = [&](const auto& A) {
      sum = begun ? rec.apply(AddShare{}, "T"_v(i), sum, share, A) : rec.apply(Share{}, "T"_v(i), share, A);
      begun = true;
    };
    if (!curve.rational) {
      add(P[i]);
    } else if (!(P[i].value.w == S(0))) {
      add(rec.apply(Project{}, "A"_v(i), P[i]));
    } else if (!(P[i].value == HPoint<S>(S(0)))) {
      throw KernelError{"curve", "control point " + std::to_string(i) +
                                     " is a direction (its weight is 0), which no basis function can be multiplied "
                                     "with: use de Boor's algorithm"};
    }
  }
  return curve.rational ? rec.apply(Project{}, "C"_v, sum).value : rec.apply(Same{}, "C"_v, sum).value;
}

}  // namespace blossom
