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

#include "kernel/construction.hpp"
#include "kernel/elimination.hpp"
#include "kernel/parameters.hpp"

namespace blossom {

namespace skin {

// The parameters v_0..v_K of the profiles, called name(l). Error: two neighbouring profiles coincide, or a weight is 0.
template <class R, class ParameterName = NameMaker>
Cells<typename R::Number, typename R::Id> parameters(R& rec, const std::vector<MadeCurve<R>>& profiles,
                                                     Parametrization parametrization,
                                                     const ParameterName& name = "v"_v) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const int K = static_cast<int>(profiles.size()) - 1;
  const int n = profiles[0].P.size() - 1;
  Cells<S, Id> v;
  v.reserve(K + 1);
  if (parametrization == Parametrization::uniform) {
    const auto intervals = rec.input("K"_v, K);
    for (int l = 0; l <= K; ++l) v.push_back(rec.apply(Fraction{}, name(l), rec.input("l"_v(l), l), intervals));
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
  v.push_back(rec.input(name(0), S(0)));
  for (int l = 1; l < K; ++l) {
    const auto& e = share[static_cast<std::size_t>(l) - 1];
    const auto mean = rec.apply(Mean{}, "e"_v(l), slice(e, 0, e.size()));
    v.push_back(rec.apply(Sum{}, name(l), v[l - 1], mean));
  }
  v.push_back(rec.input(name(K), S(1)));
  for (int l = 1; l <= K; ++l)
    if (!(v[l - 1].value < v[l].value))
      throw KernelError{"profiles[" + std::to_string(l) + "]",
                        "coincides with the profile before it: neighbouring profiles must differ"};
  return v;
}

// The matrix N_{j,q}(v_l), eliminated.
template <class R, class Degree, class KnotList>
Band<R> matrix(R& rec, const Cells<typename R::Number, typename R::Id>& v, const Degree& q, const KnotList& V) {
  using S = typename R::Number;
  const int K = v.size() - 1;
  Band<R> A(K + 1, q.value + 1);
  for (int l = 0; l <= K; ++l) {
    // The curve ends in its first and last point: these rows are unit rows.
    const int k = row_span(std::span<const S>(V.value), q.value, v[l].value);
    const bool end = l == 0 || l == K;
    const int from = end ? l : k - q.value;
    const int to = end ? l : k;
    A.set_row(l, from, to);
    for (int j = from; j <= to; ++j)
      A.set(l, j, rec.apply(BasisValue{}, "N"_v(l, j), rec.input("j"_v(l, j), j), q, v[l], V));
  }
  eliminate(rec, A, "profiles");
  return A;
}

// The profiles' control points interpolated across at v, with degree q over the knots V (phase interpolate): the net,
// whose points are called Q[i][l].
template <class R, class Degree, class KnotList>
construct::Net<R> across(R& rec, const std::vector<MadeCurve<R>>& profiles,
                         const Cells<typename R::Number, typename R::Id>& v, const Degree& q, const KnotList& V) {
  auto phase = rec.phase({"interpolate"});
  construct::Net<R> net(profiles[0].P.size(), v.size());
  const auto A = matrix(rec, v, q, V);
  Cells<HPoint<typename R::Number>, typename R::Id> D;
  D.resize(v.size());
  for (int i = 0; i < net.rows; ++i) {
    auto column = rec.phase({"column", i, true});
    for (int l = 0; l < v.size(); ++l) D.set(l, profiles[static_cast<std::size_t>(l)].P[i]);
    const auto name = [i](int l) { return outer("Q"_v(i, l)); };
    solve(rec, A, D, name, [&](int l, const auto& Q) { net.set(i, l, Q); });
  }
  return net;
}

// The same over averaged knots (phase knots).
template <class R>
struct Lofted {
  Cells<typename R::Number, typename R::Id> knots;
  construct::Net<R> net;
};
template <class R, class Degree>
Lofted<R> interpolate(R& rec, const std::vector<MadeCurve<R>>& profiles,
                      const Cells<typename R::Number, typename R::Id>& v, const Degree& q) {
  Cells<typename R::Number, typename R::Id> knots;
  {
    auto phase = rec.phase({"knots"});
    const int K = v.size() - 1;
    knots.reserve(K + q.value + 2);
    for (int i = 0; i <= q.value; ++i) knots.push_back(v[0]);
    for (int j = 1; j <= K - q.value; ++j) knots.push_back(rec.apply(Mean{}, "V"_v(j + q.value), slice(v, j, q.value)));
    for (int i = 0; i <= q.value; ++i) knots.push_back(v[K]);
  }
  const auto V = rec.apply(Gather{}, "V"_v, slice(knots, 0, knots.size()));
  auto net = across(rec, profiles, v, q, V);
  return {std::move(knots), std::move(net)};
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
    rational = rational || curve.rational;
    profiles[static_cast<std::size_t>(l)] = construct::given(rec, curve, l);
  }

  {
    auto phase = rec.phase({"compatible"});
    make_compatible(rec, profiles);
  }

  Cells<S, Id> v;
  {
    auto phase = rec.phase({"parameters"});
    v = skin::parameters(rec, profiles, parametrization);
  }

  auto lofted = skin::interpolate(rec, profiles, v, q);
  return construct::surface(rec, std::move(lofted.net), profiles[0].degree, profiles[0].U.values(), degree_v,
                            lofted.knots.values(), rational);
}

}  // namespace blossom
