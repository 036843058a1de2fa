#pragma once
// Which parameters points get that a curve is to pass through or near (The NURBS Book 9.2.1, eqs. 9.3-9.6; Shene,
// "Parameter Selection and Knot Vector Generation"), and which knots follow from them:
//
//   chord        t_k = t_{k-1} + d[k] / L,  d[k] = |D[k] - D[k-1]|,  L = sum of all d[k]
//   centripetal  the same with d[k] = sqrt |D[k] - D[k-1]|
//   uniform      t_k = k/n
//   universal    uniform knots first; then t_k is where the k-th basis function is largest (Lim 1999)

#include <cmath>
#include <numeric>

#include "kernel/basis.hpp"
#include "kernel/error.hpp"
#include "kernel/rules.hpp"

namespace blossom {

// |A - B| of the points of two homogeneous points
struct Distance {
  static constexpr std::string_view name = "distance";
  static constexpr std::string_view formula = "|{0} - {1}|";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const HPoint<S>& A, const HPoint<S>& B) {
    const S x = A.x / A.w - B.x / B.w;
    const S y = A.y / A.w - B.y / B.w;
    const S z = A.z / A.w - B.z / B.w;
    using std::sqrt;
    return sqrt(x * x + y * y + z * z);
  }
  template <Scalar S>
  static bool defined(const HPoint<S>& A, const HPoint<S>& B) {
    return !(A.w == S(0)) && !(B.w == S(0));
  }
};

// The square root of a number
struct Root {
  static constexpr std::string_view name = "root";
  static constexpr std::string_view formula = "sqrt({0})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a) {
    using std::sqrt;
    return sqrt(a);
  }
  template <Scalar S>
  static bool defined(const S& a) {
    return !(a < S(0));
  }
};

// Where N_{i,p} is largest. Exact where it is rational without a search: for degree 2, in the middle of knots that lie
// symmetrically, for Bernstein polynomials and at the ends; elsewhere approximate, the zero of the derivative by
// bisection in double precision.
struct Peak {
  static constexpr std::string_view name = "peak";
  static constexpr std::string_view formula = "where N_({0},{1}) is largest";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(int i, int p, std::span<const S> U) {
    const auto u = U.subspan(static_cast<std::size_t>(i), static_cast<std::size_t>(p) + 2);
    const auto at = [&](int j) -> const S& { return u[static_cast<std::size_t>(j)]; };
    const S& a = u.front();
    const S& b = u.back();
    if (at(p) == a) return a;
    if (at(1) == b) return b;
    if (p == 1) return at(1);
    if (p == 2 && at(1) < at(2)) {  // the derivative falls evenly from 2/(u_2 - u_0) to -2/(u_3 - u_1)
      const S rise = at(3) - at(1);
      return at(1) + (at(2) - at(1)) * rise / (rise + at(2) - at(0));
    }
    if (p == 2) return at(1);
    bool two_knots = true, symmetric = true;
    for (int j = 1; j <= p; ++j) {
      two_knots = two_knots && (at(j) == a || at(j) == b);
      symmetric = symmetric && at(j) - a == b - at(p + 1 - j);
    }
    if (symmetric) return (a + b) / S(2);
    if (two_knots) return greville_abscissa<S>(u, p, 0);
    std::vector<double> knots;
    for (const S& knot : u) knots.push_back(to_double(knot));
    const double found = bisect(knots, p);
    if constexpr (std::same_as<S, Exact>)
      return Exact::approximate(found);
    else
      return found;
  }
  template <Scalar S>
  static bool defined(int i, int p, std::span<const S> U) {
    return p >= 1 && p <= max_degree && i >= 0 && static_cast<std::size_t>(i + p) + 1 < U.size() &&
           std::is_sorted(U.begin(), U.end()) &&
           U[static_cast<std::size_t>(i)] < U[static_cast<std::size_t>(i + p) + 1] &&
           std::isfinite(to_double(U[static_cast<std::size_t>(i)])) &&
           std::isfinite(to_double(U[static_cast<std::size_t>(i + p) + 1]));
  }

 private:
  // The one sign change of N' on u_0..u_{p+1}.
  static double bisect(const std::vector<double>& u, int p) {
    const auto slope = [&](double t) {
      const auto share = [&](int j) {
        const double width = u[static_cast<std::size_t>(j + p)] - u[static_cast<std::size_t>(j)];
        return width > 0 ? basis_function<double>(u, p - 1, j, t) / width : 0;
      };
      return share(0) - share(1);
    };
    double low = u.front(), high = u.back();
    for (int round = 0; round < 60; ++round) {
      const double middle = std::midpoint(low, high);  // a sum of what somebody typed may overflow
      (slope(middle) > 0 ? low : high) = middle;
    }
    return std::midpoint(low, high);
  }
};

enum class Parametrization { chord, centripetal, uniform, universal };  // universal: of points, not of profiles

// t_0..t_n of the points D[0..n]; not `universal`. Error: neighbouring points coincide.
template <class R, class Points>
Cells<typename R::Number, typename R::Id> point_parameters(R& rec, const Points& D, Parametrization parametrization) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const int n = D.size() - 1;
  Cells<S, Id> t;
  t.reserve(n + 1);
  if (parametrization == Parametrization::uniform) {
    const auto intervals = rec.input("n"_v, n);
    for (int k = 0; k <= n; ++k) t.push_back(rec.apply(Fraction{}, "t"_v(k), rec.input("k"_v(k), k), intervals));
    return t;
  }

  Cells<S, Id> d;
  d.reserve(n);
  for (int k = 1; k <= n; ++k) {
    if (parametrization == Parametrization::chord) {
      d.push_back(rec.apply(Distance{}, "d"_v(k), D[k], D[k - 1]));
    } else {
      const auto chord = rec.apply(Distance{}, "c"_v(k), D[k], D[k - 1]);
      d.push_back(rec.apply(Root{}, "d"_v(k), chord));
    }
  }
  const auto total = rec.apply(Total{}, "L"_v, slice(d, 0, n));
  const auto coincide = [](int k) {
    return KernelError{"points[" + std::to_string(k) + "]",
                       "coincides with the point before it: neighbouring points must differ, or take \"uniform\" "
                       "parameters"};
  };
  for (int k = 1; k <= n; ++k)
    if (!(S(0) < d[k - 1].value)) throw coincide(k);
  t.push_back(rec.input("t"_v(0), S(0)));
  const auto end = rec.input("t"_v(n), S(1));
  for (int k = 1; k < n; ++k) {
    const auto share = rec.apply(Quotient{}, "e"_v(k), d[k - 1], total);
    t.push_back(rec.apply(Sum{}, "t"_v(k), t[k - 1], share));
  }
  t.push_back(end);
  for (int k = 1; k <= n; ++k)
    if (!(t[k - 1].value < t[k].value)) throw coincide(k);
  return t;
}

// The span whose p + 1 basis functions a row of equations at t has. A knot that is a mean of parameters can equal one
// of them, and rounding must not decide on which side of it t lies: so a knot that is above t by less than 1e-12 of the
// domain counts as equal to it. The basis function left out is then smaller than that.
template <Scalar S>
int row_span(std::span<const S> U, int p, const S& t) {
  const S& begin = U[static_cast<std::size_t>(p)];
  const S& end = U[U.size() - static_cast<std::size_t>(p) - 1];
  const S slack = (end - begin) / S(1000000) / S(1000000);
  const S moved = t + slack;
  return find_span<S>(U, p, moved < end ? moved : end);
}

}  // namespace blossom
