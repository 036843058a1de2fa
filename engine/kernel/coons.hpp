#pragma once
// Coons patches (Coons 1967; The NURBS Book 10.6): the surface between four boundary curves, bilinearly blended. With
// A_0, A_1 the curves along u at the ends of v, and B_0, B_1 those along v at the ends of u,
//
//     S = ruled(A_0, A_1) + ruled(B_0, B_1) - bilinear(the four corners).
//
// All three are written over the same degrees and knots: those that A_0, A_1 have in common along u, and B_0, B_1 along
// v. A straight line over any knots has its control points at the Greville abscissae (the mean of p neighbouring
// knots), so with f_i and g_j these abscissae, from 0 to 1 over the domain,
//
//     L[i][j] = (1 - g_j) A_0[i] + g_j A_1[i]                    ruled along v
//     M[i][j] = (1 - f_i) B_0[j] + f_i B_1[j]                    ruled along u
//     N[i][j] = (1 - g_j) E_0[i] + g_j E_1[i],  E_l[i] = (1 - f_i) A_l[0] + f_i A_l[n]
//     Q = L + M - N.
//
// Sums of points: all weights must be the same.

#include "kernel/construction.hpp"

namespace blossom {

// (1 - a) A + a B of control points over other knots than theirs, so without their polar labels
struct BetweenPoints {
  static constexpr std::string_view name = "between_points";
  static constexpr std::string_view formula = "(1 - {0}) {1} + {0} {2}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const S& a, const HPoint<S>& A, const HPoint<S>& B) {
    return Blend::apply<S>(a, A, B);
  }
};

// A + B - C of control points
struct BooleanSum {
  static constexpr std::string_view name = "boolean_sum";
  static constexpr std::string_view formula = "{0} + {1} - {2}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const HPoint<S>& B, const HPoint<S>& C) {
    return {A.x + B.x - C.x, A.y + B.y - C.y, A.z + B.z - C.z, A.w + B.w - C.w};
  }
};

namespace construct {

// Where the control points of a straight line lie over these knots: the Greville abscissae, from 0 to 1.
template <class R>
Cells<typename R::Number, typename R::Id> line_ratios(R& rec, const MadeCurve<R>& curve, NameMaker abscissa,
                                                      NameMaker ratio) {
  Cells<typename R::Number, typename R::Id> f;
  const auto& U = curve.U;
  for (int i = 0; i < curve.P.size(); ++i) {
    auto step = rec.one_step();
    const auto mean = rec.apply(Mean{}, abscissa(i), slice(U, i + 1, curve.degree));
    f.push_back(rec.apply(Ratio{}, ratio(i), mean, U[0], U[U.size() - 1]));
  }
  return f;
}

}  // namespace construct

// Preconditions: two curves each way, of equal weights, that meet at the corners.
template <class R>
Surface<typename R::Number> coons(const std::vector<Curve<typename R::Number>>& u_curves,
                                  const std::vector<Curve<typename R::Number>>& v_curves, R& rec) {
  std::vector<MadeCurve<R>> A, B;
  for (int l = 0; l < 2; ++l) A.push_back(construct::given(rec, u_curves[static_cast<std::size_t>(l)], l));
  for (int k = 0; k < 2; ++k)
    B.push_back(construct::given(rec, v_curves[static_cast<std::size_t>(k)], k, "V"_v, "R"_v));
  {
    auto phase = rec.phase({"along_u", -1, true});
    make_compatible(rec, A);
  }
  {
    auto phase = rec.phase({"along_v", -1, true});
    make_compatible(rec, B);
  }
  Cells<typename R::Number, typename R::Id> f, g;
  {
    auto phase = rec.phase({"lines"});
    f = construct::line_ratios(rec, A[0], "a"_v, "f"_v);
    g = construct::line_ratios(rec, B[0], "b"_v, "g"_v);
  }

  const int n = A[0].P.size() - 1, m = B[0].P.size() - 1;
  construct::Net<R> L(n + 1, m + 1), M(n + 1, m + 1), N(n + 1, m + 1), Q(n + 1, m + 1);
  const auto each = [&](const auto& make) {
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= m; ++j) make(i, j);
  };
  {
    auto phase = rec.phase({"ruled_v"});
    each([&](int i, int j) { L.set(i, j, rec.apply(BetweenPoints{}, "L"_v(i, j), g[j], A[0].P[i], A[1].P[i])); });
  }
  {
    auto phase = rec.phase({"ruled_u"});
    each([&](int i, int j) { M.set(i, j, rec.apply(BetweenPoints{}, "M"_v(i, j), f[i], B[0].P[j], B[1].P[j])); });
  }
  {
    auto phase = rec.phase({"bilinear"});
    for (int i = 0; i <= n; ++i) {
      const auto E0 = rec.apply(BetweenPoints{}, "E"_v(0, i), f[i], A[0].P[0], A[0].P[n]);
      const auto E1 = rec.apply(BetweenPoints{}, "E"_v(1, i), f[i], A[1].P[0], A[1].P[n]);
      for (int j = 0; j <= m; ++j) N.set(i, j, rec.apply(BetweenPoints{}, "N"_v(i, j), g[j], E0, E1));
    }
  }
  auto phase = rec.phase({"sum"});
  each([&](int i, int j) {
    Q.set(i, j, rec.apply(BooleanSum{}, "Q"_v(i, j), L.at(i, j), M.at(i, j), N.at(i, j)));
    for (const auto* net : {&L, &M, &N}) rec.retire(net->at(i, j).id);
  });
  const bool rational = A[0].rational || A[1].rational || B[0].rational || B[1].rational;
  return construct::surface(rec, std::move(Q), A[0].degree, A[0].U.values(), B[0].degree, B[0].U.values(), rational);
}

}  // namespace blossom
