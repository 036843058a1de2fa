#pragma once
// Local cubic interpolation: through the points D[0..n] a curve of cubic pieces that meet with one derivative, each of
// which depends on few points around it (The NURBS Book 9.3.1 and 9.3.4).
//
//   parameters  t_0..t_n, see parameters.hpp; w[k] = t_k - t_{k-1}; chords' slopes s[k] = (D[k] - D[k-1]) / w[k];
//   tangents    V[k] = (1 - a[k]) s[k] + a[k] s[k+1], the derivative at t_k:
//      bessel   a[k] = w[k] / (w[k] + w[k+1]): that of the parabola through three points (NB 9.30); at the ends
//               V[0] = 2 s[1] - V[1], V[n] = 2 s[n] - V[n-1] (NB 9.32), the same parabola;
//      akima    a[k] = g[k] / (g[k] + g[k+2]), g[k] = |s[k] - s[k-1]| (Akima 1970, for functions; here with the lengths
//               of the differences): three chords of one slope in a row give a straight piece. Slopes beyond the ends
//               continue evenly: s_0 = 2 s_1 - s_2, s_{-1} = 2 s_0 - s_1 and so at the other end (NB 9.33);
//   pieces      Bezier points D[k], D[k] + w[k+1]/3 V[k], D[k+1] - w[k+1]/3 V[k+1], D[k+1] of a piece (Hermite); the
//               inner D[k] are no control points when each inner t_k is a knot twice (NB 9.52).

#include "kernel/parameters.hpp"
#include "kernel/tolerance.hpp"

namespace blossom {

// t - s of two parameters
struct StepWidth {
  static constexpr std::string_view name = "step_width";
  static constexpr std::string_view formula = "{0} - {1}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& t, const S& s) {
    return t - s;
  }
};

// (A - B) / w
struct ChordSlope {
  static constexpr std::string_view name = "chord_slope";
  static constexpr std::string_view formula = "({0} - {1}) / {2}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const HPoint<S>& B, const S& w) {
    return {(A.x - B.x) / w, (A.y - B.y) / w, (A.z - B.z) / w, S(0)};
  }
  template <Scalar S>
  static bool defined(const HPoint<S>&, const HPoint<S>&, const S& w) {
    return !(w == S(0));
  }
};

// 2 A - B: from B on through A, as far again
struct ContinueSlope {
  static constexpr std::string_view name = "continue_slope";
  static constexpr std::string_view formula = "2 {0} - {1}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const HPoint<S>& B) {
    return {S(2) * A.x - B.x, S(2) * A.y - B.y, S(2) * A.z - B.z, S(0)};
  }
};

// |A - B| of two vectors
struct SlopeChange {
  static constexpr std::string_view name = "slope_change";
  static constexpr std::string_view formula = "|{0} - {1}|";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const HPoint<S>& A, const HPoint<S>& B) {
    const S x = A.x - B.x, y = A.y - B.y, z = A.z - B.z;
    using std::sqrt;
    return sqrt(x * x + y * y + z * z);
  }
};

// a / (a + b)
struct ShareOf {
  static constexpr std::string_view name = "share_of";
  static constexpr std::string_view formula = "{0} / ({0} + {1})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a, const S& b) {
    return a / (a + b);
  }
  template <Scalar S>
  static bool defined(const S& a, const S& b) {
    return !(a + b == S(0));
  }
};

// a / (a + b); one half where both are zero, up to rounding
struct AkimaShare {
  static constexpr std::string_view name = "akima_share";
  static constexpr std::string_view formula = "{0} / ({0} + {1}), or 1/2 if both are 0 (rounding: {2})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const S& a, const S& b, const S& rounding) {
    return a + b <= rounding ? S(1) / S(2) : S(a / (a + b));
  }
  template <Scalar S>
  static bool defined(const S& a, const S& b, const S& rounding) {
    return a + b <= rounding || !(a + b == S(0));
  }
};

// (1 - a) A + a B of vectors
struct BlendSlopes {
  static constexpr std::string_view name = "blend_slopes";
  static constexpr std::string_view formula = "(1 - {0}) {1} + {0} {2}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const S& a, const HPoint<S>& A, const HPoint<S>& B) {
    return Blend::apply<S>(a, A, B);
  }
};

// A + w/3 V
struct ThirdAhead {
  static constexpr std::string_view name = "third_ahead";
  static constexpr std::string_view formula = "{0} + {1} {2} / 3";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const S& w, const HPoint<S>& V) {
    const S third = w / S(3);
    return {A.x + third * V.x, A.y + third * V.y, A.z + third * V.z, A.w};
  }
};

// A - w/3 V
struct ThirdBack {
  static constexpr std::string_view name = "third_back";
  static constexpr std::string_view formula = "{0} - {1} {2} / 3";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const S& w, const HPoint<S>& V) {
    const S third = w / S(3);
    return {A.x - third * V.x, A.y - third * V.y, A.z - third * V.z, A.w};
  }
};

enum class LocalTangents { bessel, akima };

namespace local {

template <class R>
using Numbers = Cells<typename R::Number, typename R::Id>;
template <class R>
using Vectors = Cells<HPoint<typename R::Number>, typename R::Id>;

// V[0..n]; w[k] and s[k] stand at k - 1.
template <class R>
Vectors<R> bessel_tangents(R& rec, const Numbers<R>& w, const Vectors<R>& s) {
  const int n = s.size();
  Vectors<R> V;
  V.resize(n + 1);
  for (int k = 1; k < n; ++k) {
    const auto a = rec.apply(ShareOf{}, "a"_v(k), w[k - 1], w[k]);
    V.set(k, rec.apply(BlendSlopes{}, "V"_v(k), a, s[k - 1], s[k]));
  }
  const auto next = n > 1 ? V[1] : s[0];
  V.set(0, rec.apply(ContinueSlope{}, "V"_v(0), s[0], next));
  const auto before = n > 1 ? V[n - 1] : s[0];
  V.set(n, rec.apply(ContinueSlope{}, "V"_v(n), s[n - 1], before));
  return V;
}

template <class R>
Vectors<R> akima_tangents(R& rec, const Vectors<R>& s) {
  const int n = s.size();
  Vectors<R> all;  // s_{-1}, s_0, s_1 .. s_n, s_{n+1}, s_{n+2}
  all.resize(n + 4);
  for (int k = 0; k < n; ++k) all.set(k + 2, s[k]);
  all.set(1, rec.apply(ContinueSlope{}, "x"_v(1), s[0], s[n > 1 ? 1 : 0]));
  all.set(0, rec.apply(ContinueSlope{}, "x"_v(0), all[1], s[0]));
  all.set(n + 2, rec.apply(ContinueSlope{}, "x"_v(2), s[n - 1], s[n > 1 ? n - 2 : 0]));
  all.set(n + 3, rec.apply(ContinueSlope{}, "x"_v(3), all[n + 2], s[n - 1]));
  Numbers<R> g;
  for (int k = 0; k <= n + 2; ++k) g.push_back(rec.apply(SlopeChange{}, "g"_v(k), all[k + 1], all[k]));
  const auto rounding = rec.input("eps"_v, rounding_of(all.values()));
  Vectors<R> V;
  for (int k = 0; k <= n; ++k) {
    const auto a = rec.apply(AkimaShare{}, "a"_v(k), g[k], g[k + 2], rounding);
    V.push_back(rec.apply(BlendSlopes{}, "V"_v(k), a, all[k + 1], all[k + 2]));
  }
  return V;
}

}  // namespace local

// Preconditions: at least two points; parametrization is not `universal`. Errors: see point_parameters.
template <class R>
Curve<typename R::Number> local_interpolation(const PointRow<typename R::Number>& points, LocalTangents tangents,
                                              Parametrization parametrization, R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const auto D = rec.inputs("D"_v, std::span<const HPoint<S>>(points.points));
  const int n = D.size() - 1;
  Cells<S, Id> t;
  {
    auto phase = rec.phase({"parameters"});
    t = point_parameters(rec, D, parametrization);
  }

  Cells<S, Id> w;
  Cells<HPoint<S>, Id> s, V;
  {
    auto phase = rec.phase({"slopes"});
    for (int k = 1; k <= n; ++k) {
      w.push_back(rec.apply(StepWidth{}, "w"_v(k), t[k], t[k - 1]));
      s.push_back(rec.apply(ChordSlope{}, "s"_v(k), D[k], D[k - 1], w[k - 1]));
    }
  }
  {
    auto phase = rec.phase({"tangents"});
    V = tangents == LocalTangents::akima ? local::akima_tangents(rec, s) : local::bessel_tangents(rec, w, s);
  }

  auto phase = rec.phase({"pieces"});
  Cells<S, Id> knots;
  for (int i = 0; i < 4; ++i) knots.push_back(t[0]);
  for (int k = 1; k < n; ++k) {
    knots.push_back(t[k]);
    knots.push_back(t[k]);
  }
  for (int i = 0; i < 4; ++i) knots.push_back(t[n]);
  const auto U = rec.apply(Gather{}, "U"_v, slice(knots, 0, knots.size()));
  Curve<S> curve;
  curve.degree = 3;
  curve.dimension = points.dimension;
  curve.knots = U.value;
  const auto add = [&](const Traced<HPoint<S>, Id>& P) {
    rec.polar_net(P.id, std::span<const S>(curve.knots).subspan(curve.points.size() + 1, 3), {});
    curve.points.push_back(P.value);
  };
  add(rec.apply(Relabel{}, "P"_v(0), D[0]));
  for (int k = 0; k < n; ++k) {
    add(rec.apply(ThirdAhead{}, "P"_v(2 * k + 1), D[k], w[k], V[k]));
    add(rec.apply(ThirdBack{}, "P"_v(2 * k + 2), D[k + 1], w[k], V[k + 1]));
  }
  add(rec.apply(Relabel{}, "P"_v(2 * n + 1), D[n]));
  return curve;
}

}  // namespace blossom
