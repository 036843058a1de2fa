#pragma once
// Skinning (lofting): the surface that has the given profiles as isoparametric curves S(u, v_l) = C_l(u) (Woodward
// 1988; The NURBS Book 10.3; Shene, "Cross-Sectional Design"). Phases:
//
//   compatible   one degree p and one knot vector for all profiles: control points P[l][i], l = 0..K, i = 0..n;
//   parameters   v_0 = 0, v_K = 1; chord length (NB 10.8): v_l = v_{l-1} + mean over i of d[l][i] / sum_l d[l][i], with
//                d[l][i] = |P[l][i] - P[l-1][i]|; centripetal: the square roots of these; uniform: v_l = l/K;
//   knots        by averaging (NB 9.8): v-knots V = 0^{q+1}, mean(v_j..v_{j+q-1}) for j = 1..K-q, 1^{q+1};
//   interpolate  for each i the curve through P[0][i]..P[K][i]: sum_j N_{j,q}(v_l) Q[i][j] = P[l][i]. One elimination
//                of the matrix serves all i; it is totally positive (de Boor 1978), so no pivoting.
//
// In homogeneous coordinates when any profile is rational; distances are measured between the points themselves.

#include <cmath>

#include "kernel/basis.hpp"
#include "kernel/compatible.hpp"
#include "kernel/error.hpp"

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

// N_{j,q}(v) over the knots V
struct BasisValue {
  static constexpr std::string_view name = "basis";
  static constexpr std::string_view formula = "N_({0},{1})({2})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(int j, int q, const S& v, std::span<const S> V) {
    return basis_function(V, q, j, v);
  }
  template <Scalar S>
  static bool defined(int j, int q, const S& v, std::span<const S> V) {
    return q >= 1 && q <= max_degree && j >= 0 && j + q + 1 < static_cast<int>(V.size()) &&
           FindSpan::defined<S>(q, v, V);
  }
};

// a - m b of numbers
struct ReduceNumber {
  static constexpr std::string_view name = "reduce_number";
  static constexpr std::string_view formula = "{0} - {1} · {2}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a, const S& m, const S& b) {
    return a - m * b;
  }
};

// A - m B of right-hand sides
struct Reduce {
  static constexpr std::string_view name = "reduce";
  static constexpr std::string_view formula = "{0} - {1} · {2}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const S& m, const HPoint<S>& B) {
    return {A.x - m * B.x, A.y - m * B.y, A.z - m * B.z, A.w - m * B.w};
  }
};

// A / d
struct Scale {
  static constexpr std::string_view name = "divide";
  static constexpr std::string_view formula = "{0} / {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const S& d) {
    return {A.x / d, A.y / d, A.z / d, A.w / d};
  }
  template <Scalar S>
  static bool defined(const HPoint<S>&, const S& d) {
    return !(d == S(0));
  }
};

enum class Parametrization { chord, centripetal, uniform };

namespace skin {

// The parameters v_0..v_K of the profiles. Error: two neighbouring profiles coincide, or a weight is 0.
template <class R>
Cells<typename R::Number, typename R::Id> parameters(R& rec, const std::vector<MadeCurve<R>>& profiles,
                                                     Parametrization parametrization) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const int K = static_cast<int>(profiles.size()) - 1;
  const int n = profiles[0].P.size() - 1;
  Cells<S, Id> v;
  v.reserve(K + 1);
  if (parametrization == Parametrization::uniform) {
    const auto intervals = rec.input("K"_v, K);
    for (int l = 0; l <= K; ++l) v.push_back(rec.apply(Fraction{}, "v"_v(l), rec.input("l"_v(l), l), intervals));
    return v;
  }

  // Columns first: share[l-1] collects d[l][i] / L[i] of every column i whose points do not all coincide.
  std::vector<Cells<S, Id>> share(static_cast<std::size_t>(K));
  for (int i = 0; i <= n; ++i) {
    Cells<S, Id> d;
    d.reserve(K);
    for (int l = 1; l <= K; ++l) {
      const auto A = profiles[static_cast<std::size_t>(l)].P[i];
      const auto B = profiles[static_cast<std::size_t>(l) - 1].P[i];
      if (A.value.w == S(0) || B.value.w == S(0))
        throw KernelError{
            "profiles[" + std::to_string(A.value.w == S(0) ? l : l - 1) + "]",
            "a control point of weight 0 has no distance to the next profile; use \"uniform\" parameters"};
      if (parametrization == Parametrization::chord) {
        d.push_back(rec.apply(Distance{}, "d"_v(l, i), A, B));
      } else {
        const auto chord = rec.apply(Distance{}, "c"_v(l, i), A, B);
        d.push_back(rec.apply(Root{}, "d"_v(l, i), chord));
      }
    }
    const auto total = rec.apply(Total{}, "L"_v(i), slice(d, 0, K));
    if (total.value == S(0)) continue;
    for (int l = 1; l <= K; ++l)
      share[static_cast<std::size_t>(l) - 1].push_back(rec.apply(Quotient{}, "e"_v(l, i), d[l - 1], total));
  }
  if (share[0].size() == 0) throw KernelError{"profiles", "all profiles coincide: there is no surface through them"};
  v.push_back(rec.input("v"_v(0), S(0)));
  for (int l = 1; l < K; ++l) {
    const auto& e = share[static_cast<std::size_t>(l) - 1];
    const auto mean = rec.apply(Mean{}, "e"_v(l), slice(e, 0, e.size()));
    v.push_back(rec.apply(Sum{}, "v"_v(l), v[l - 1], mean));
  }
  v.push_back(rec.input("v"_v(K), S(1)));
  for (int l = 1; l <= K; ++l)
    if (!(v[l - 1].value < v[l].value))
      throw KernelError{"profiles[" + std::to_string(l) + "]",
                        "coincides with the profile before it: neighbouring profiles must differ"};
  return v;
}

// The banded matrix N_{j,q}(v_l), eliminated in place: below the diagonal its multipliers, above it the triangle.
template <class R>
struct Eliminated {
  int size = 0;
  std::vector<int> first, last;  // the columns of each row that can differ from zero
  int stride = 0;
  Cells<typename R::Number, typename R::Id> entries;  // row l, column j at l * stride + j - first[l]

  auto at(int l, int j) const { return entries[l * stride + j - first[static_cast<std::size_t>(l)]]; }
  template <class V>
  void set(int l, int j, const V& value) {
    entries.set(l * stride + j - first[static_cast<std::size_t>(l)], value);
  }
};

template <class R, class Degree, class KnotList>
Eliminated<R> eliminate(R& rec, const Cells<typename R::Number, typename R::Id>& v, const Degree& q,
                        const KnotList& V) {
  using S = typename R::Number;
  const int K = v.size() - 1;
  Eliminated<R> A;
  A.size = K + 1;
  A.stride = q.value + 1;
  A.first.assign(static_cast<std::size_t>(K) + 1, 0);
  A.last.assign(static_cast<std::size_t>(K) + 1, 0);
  A.entries.resize((K + 1) * A.stride);
  for (int l = 0; l <= K; ++l) {
    // The curve ends in its first and last point: these rows are unit rows.
    const int k = find_span(std::span<const S>(V.value), q.value, v[l].value);
    const bool end = l == 0 || l == K;
    const int from = end ? l : k - q.value;
    const int to = end ? l : k;
    A.first[static_cast<std::size_t>(l)] = from;
    A.last[static_cast<std::size_t>(l)] = to;
    for (int j = from; j <= to; ++j)
      A.set(l, j, rec.apply(BasisValue{}, "N"_v(l, j), rec.input("j"_v(l, j), j), q, v[l], V));
  }
  for (int c = 0; c < K; ++c) {
    for (int l = c + 1; l <= K && A.first[static_cast<std::size_t>(l)] <= c; ++l) {
      auto phase = rec.phase({"row", l, true});
      const auto m = rec.apply(Quotient{}, "m"_v(l, c), A.at(l, c), A.at(c, c));
      A.set(l, c, m);
      for (int j = c + 1; j <= A.last[static_cast<std::size_t>(c)]; ++j)
        A.set(l, j, rec.apply(ReduceNumber{}, "A"_v(c, j), A.at(l, j), m, A.at(c, j)));
    }
  }
  return A;
}

}  // namespace skin

// Preconditions: at least two valid profiles, 1 <= degree_v <= profiles - 1. Errors: see skin::parameters.
template <class R>
Surface<typename R::Number> skinning(const std::vector<Curve<typename R::Number>>& given, int degree_v,
                                     Parametrization parametrization, R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const int K = static_cast<int>(given.size()) - 1;
  const auto q = rec.input("q"_v, degree_v);

  bool rational = false;
  std::vector<MadeCurve<R>> profiles(given.size());
  for (int l = 0; l <= K; ++l) {
    const auto& curve = given[static_cast<std::size_t>(l)];
    auto& profile = profiles[static_cast<std::size_t>(l)];
    rational = rational || curve.rational;
    const auto U = rec.inputs("U"_v, l, std::span<const S>(curve.knots));
    const auto P = rec.inputs("P"_v, l, std::span<const HPoint<S>>(curve.points));
    profile.degree = curve.degree;
    profile.dimension = curve.dimension;
    profile.rational = curve.rational;
    profile.U.reserve(U.size());
    for (int i = 0; i < U.size(); ++i) profile.U.push_back(U[i]);
    profile.P.reserve(P.size());
    for (int i = 0; i < P.size(); ++i) profile.P.push_back(P[i]);
    if constexpr (R::recording)
      for (int i = 0; i < P.size(); ++i) rec.polar_knots(P[i].id, U[i + 1].id, curve.degree);
  }

  {
    auto phase = rec.phase({"compatible"});
    make_compatible(rec, profiles);
  }
  const int n = profiles[0].P.size() - 1;

  Cells<S, Id> v;
  {
    auto phase = rec.phase({"parameters"});
    v = skin::parameters(rec, profiles, parametrization);
  }

  Cells<S, Id> knots;
  {
    auto phase = rec.phase({"knots"});
    knots.reserve(K + degree_v + 2);
    const auto begin = v[0];
    const auto end = v[K];
    for (int i = 0; i <= degree_v; ++i) knots.push_back(begin);
    for (int j = 1; j <= K - degree_v; ++j)
      knots.push_back(rec.apply(Mean{}, "V"_v(j + degree_v), slice(v, j, degree_v)));
    for (int i = 0; i <= degree_v; ++i) knots.push_back(end);
  }
  const auto V = rec.apply(Gather{}, "V"_v, slice(knots, 0, knots.size()));

  Surface<S> surface;
  surface.degree = {profiles[0].degree, degree_v};
  surface.knots[0].assign(profiles[0].U.values().begin(), profiles[0].U.values().end());
  surface.knots[1] = V.value;
  surface.rows = n + 1;
  surface.columns = K + 1;
  surface.rational = rational;
  surface.points.resize(static_cast<std::size_t>((n + 1) * (K + 1)));

  auto phase = rec.phase({"interpolate"});
  const auto A = skin::eliminate(rec, v, q, V);
  Cells<HPoint<S>, Id> D;
  D.resize(K + 1);
  for (int i = 0; i <= n; ++i) {
    auto column = rec.phase({"column", i, true});
    for (int l = 0; l <= K; ++l) {
      const auto given_point = profiles[static_cast<std::size_t>(l)].P[i];
      Traced<HPoint<S>, Id> right{given_point.value, given_point.id};
      for (int c = A.first[static_cast<std::size_t>(l)]; c < l; ++c)
        right = rec.apply(Reduce{}, "D"_v(l, c), right, A.at(l, c), D[c]);
      D.set(l, right);
    }
    for (int l = K; l >= 0; --l) {
      Traced<HPoint<S>, Id> right{D[l].value, D[l].id};
      for (int j = A.last[static_cast<std::size_t>(l)]; j > l; --j)
        right = rec.apply(Reduce{}, "X"_v(l, j), right, A.at(l, j), D[j]);
      const auto Q = rec.apply(Scale{}, outer("Q"_v(i, l)), right, A.at(l, l));
      D.set(l, Q);
      surface.at(i, l) = Q.value;
      if (!rational) surface.at(i, l).w = S(1);  // up to rounding it is
      rec.polar_net(Q.id,
                    std::span<const S>(surface.knots[0])
                        .subspan(static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(surface.degree[0])),
                    std::span<const S>(surface.knots[1])
                        .subspan(static_cast<std::size_t>(l) + 1, static_cast<std::size_t>(degree_v)));
    }
  }
  return surface;
}

}  // namespace blossom
