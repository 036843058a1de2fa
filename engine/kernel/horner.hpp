#pragma once
// A polynomial curve in the power basis, C(u) = a_0 + a_1 u + ... + a_n u^n with points or vectors a_k, and its tangent
// vector C'(u), by Horner's scheme (The NURBS Book 1.2, A1.1; Knuth, The Art of Computer Programming 2, 4.6.4):
//
//     b[n] = a[n],      b[k] = a[k] + u b[k+1],      C  = a[0] + u b[1],
//     c[n-1] = b[n],    c[k] = b[k+1] + u c[k+1],    C' = b[1] + u c[1].
//
// a[0] is where the curve is at u = 0; all other a[k], b[k] and c[k] are vectors. b[1] = (C(u) - a[0]) / u is the mean
// velocity on the way from a[0] to C(u).

#include "kernel/curve_derivatives.hpp"

namespace blossom {

// A coefficient as a vector
struct LeadingVector {
  static constexpr std::string_view name = "leading_vector";
  static constexpr std::string_view formula = "{0}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A) {
    return {A.x, A.y, A.z, S(0)};
  }
};

// A + u B, a vector
struct HornerVector {
  static constexpr std::string_view name = "horner_vector";
  static constexpr std::string_view formula = "{0} + {1} {2}";
  static constexpr Polar polar = Polar::none;
  static constexpr bool makes_vector = true;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const S& u, const HPoint<S>& B) {
    return {A.x + u * B.x, A.y + u * B.y, A.z + u * B.z, S(0)};
  }
};

// A + u B, a point: the vector B leads from the point A to it
struct HornerPoint {
  static constexpr std::string_view name = "horner_point";
  static constexpr std::string_view formula = HornerVector::formula;
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const HPoint<S>& A, const S& u, const HPoint<S>& B) {
    return {A.x + u * B.x, A.y + u * B.y, A.z + u * B.z, S(1)};
  }
};

// Preconditions: at least two coefficients. Gives the point C.
template <class R>
HPoint<typename R::Number> horner(const PointRow<typename R::Number>& coefficients, const typename R::Number& parameter,
                                  R& rec) {
  using S = typename R::Number;
  using Vector = Traced<HPoint<S>, typename R::Id>;
  const auto u = rec.input("u"_v, parameter);
  const auto a = rec.inputs("a"_v, std::span<const HPoint<S>>(coefficients.points));
  const int n = a.size() - 1;

  std::vector<Vector> b(static_cast<std::size_t>(n) + 1);
  const auto at = [](std::vector<Vector>& row, int k) -> Vector& { return row[static_cast<std::size_t>(k)]; };
  // What has been used up goes, so that the picture shows the vectors at work: of the b's the mean velocity b[1] stays.
  Vector point;
  {
    auto phase = rec.phase({"point"});
    at(b, n) = rec.apply(LeadingVector{}, "b"_v(n), a[n]);
    rec.retire(a[n].id);
    for (int k = n - 1; k >= 1; --k) {
      at(b, k) = rec.apply(HornerVector{}, "b"_v(k), a[k], u, at(b, k + 1));
      rec.retire(a[k].id);
      rec.retire(at(b, k + 1).id);
    }
    point = rec.apply(HornerPoint{}, "C"_v, a[0], u, at(b, 1));
  }
  auto phase = rec.phase({"tangent"});
  if (n == 1) {
    rec.apply(SameVector{}, "D"_v, at(b, 1));
    return point.value;
  }
  Vector c = rec.apply(SameVector{}, "c"_v(n - 1), at(b, n));
  for (int k = n - 2; k >= 1; --k) {
    const Vector before = c;
    c = rec.apply(HornerVector{}, "c"_v(k), at(b, k + 1), u, before);
    rec.retire(before.id);
  }
  rec.apply(HornerVector{}, "D"_v, at(b, 1), u, c);
  rec.retire(c.id);
  return point.value;
}

// The same curve over [begin, end] as a Bezier curve: its coefficients for u = begin + (end - begin) s, by Horner's
// scheme on polynomials, and then the control points P_i = sum over j <= i of binom(i, j) / binom(n, j) a_j.
template <Scalar S>
Curve<S> bezier_of_power(const PointRow<S>& coefficients, const S& begin, const S& end) {
  const std::size_t count = coefficients.points.size();
  std::vector<HPoint<S>> a(count, HPoint<S>(S(0)));
  for (std::size_t k = count; k-- > 0;) {
    for (std::size_t j = count; j-- > 0;) {
      for (int x = 0; x < 3; ++x) a[j][x] = begin * a[j][x] + (j > 0 ? S((end - begin) * a[j - 1][x]) : S(0));
    }
    for (int x = 0; x < 3; ++x) a[0][x] += coefficients.points[k][x];
  }
  Curve<S> curve;
  curve.degree = static_cast<int>(count) - 1;
  curve.dimension = coefficients.dimension;
  for (const S& end_knot : {begin, end}) curve.knots.insert(curve.knots.end(), count, end_knot);
  for (std::size_t i = 0; i < count; ++i) {
    HPoint<S> P(S(0), S(0), S(0), S(1));
    S share(1);  // binom(i, j) / binom(n, j)
    for (std::size_t j = 0; j <= i; ++j) {
      for (int x = 0; x < 3; ++x) P[x] += share * a[j][x];
      if (j < i) share *= S(static_cast<int>(i - j)) / S(static_cast<int>(count - 1 - j));
    }
    curve.points.push_back(P);
  }
  return curve;
}

}  // namespace blossom
