#pragma once
// Knot removal (Tiller 1992; The NURBS Book 5.4, A5.8): one copy of the inner knot u = u_r of multiplicity s taken out,
// again and again, as long as the curve changes by no more than a tolerance. If the curve with the points Q over the
// shorter knot vector is the same curve, inserting u into it gives P, that is
//
//     P[i] = (1 - alpha[i]) Q[i-1] + alpha[i] Q[i],   alpha[i] = (u - u_i) / (u_{i+p+1} - u_i),   i = r-p..r-s,
//
// one equation more than unknown points. They are solved from both ends towards the middle:
//
//     L[i] = (P[i] - (1 - alpha[i]) L[i-1]) / alpha[i],        L[r-p-1] = P[r-p-1];
//     R[i-1] = (P[i] - alpha[i] R[i]) / (1 - alpha[i]),        R[r-s] = P[r-s+1];
//
// and b says how far the equation left over is from holding: |L[i] - R[i]| where both sides know Q[i], or
// |P[i] - M|, M = (1 - alpha[i]) L[i-1] + alpha[i] R[i], at the point in the middle. Inserting u into the new curve
// gives the old control points but one, which is off by at most b: so no point of the curve moves farther than b. Of a
// rational curve it is the homogeneous points (wx, wy, wz, w) that this holds for.

#include "kernel/knot_insertion.hpp"
#include "kernel/tolerance.hpp"

namespace blossom {

// X with (1 - a) A + a X = C
struct UnblendEnd {
  static constexpr std::string_view name = "unblend_end";
  static constexpr std::string_view formula = "({1} - (1 - {0}) {2}) / {0}";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const S& a, const HPoint<S>& C, const HPoint<S>& A) {
    const S b = S(1) - a;
    return {(C.x - b * A.x) / a, (C.y - b * A.y) / a, (C.z - b * A.z) / a, (C.w - b * A.w) / a};
  }
  template <Scalar S>
  static bool defined(const S& a, const HPoint<S>&, const HPoint<S>&) {
    return !(a == S(0));
  }
};

// X with (1 - a) X + a B = C
struct UnblendBegin {
  static constexpr std::string_view name = "unblend_begin";
  static constexpr std::string_view formula = "({1} - {0} {2}) / (1 - {0})";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const S& a, const HPoint<S>& C, const HPoint<S>& B) {
    const S b = S(1) - a;
    return {(C.x - a * B.x) / b, (C.y - a * B.y) / b, (C.z - a * B.z) / b, (C.w - a * B.w) / b};
  }
  template <Scalar S>
  static bool defined(const S& a, const HPoint<S>&, const HPoint<S>&) {
    return !(a == S(1));
  }
};

// The point that the equation in the middle asks for: Blend, but of points that are not of one curve
struct MiddleOf {
  static constexpr std::string_view name = "middle_of";
  static constexpr std::string_view formula = Blend::formula;
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static HPoint<S> apply(const S& a, const HPoint<S>& A, const HPoint<S>& B) {
    return Blend::apply<S>(a, A, B);
  }
};

namespace removal {

template <Scalar S>
S length(const HPoint<S>& A) {
  using std::sqrt;
  return sqrt(A.x * A.x + A.y * A.y + A.z * A.z + A.w * A.w);
}

}  // namespace removal

// |A - B| of two homogeneous points, weights included
struct Gap {
  static constexpr std::string_view name = "gap";
  static constexpr std::string_view formula = "|{0} - {1}|";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static S apply(const HPoint<S>& A, const HPoint<S>& B) {
    return removal::length<S>(A - B);
  }
};

// The knots without one copy of u
struct RemoveKnot {
  static constexpr std::string_view name = "remove_knot";
  static constexpr std::string_view formula = "{1} with one {0} taken out";
  static constexpr Polar polar = Polar::none;
  template <Scalar S>
  static std::vector<S> apply(const S& u, std::span<const S> U) {
    std::vector<S> knots(U.begin(), U.end());
    const auto behind = std::upper_bound(knots.begin(), knots.end(), u);
    if (behind != knots.begin()) knots.erase(behind - 1);
    return knots;
  }
};

// What became of an attempt: the curve, shorter or as it was, and the bound b.
template <class R>
struct Removal {
  MadeCurve<R> curve;
  Traced<std::vector<typename R::Number>, typename R::Id> knots;
  Traced<typename R::Number, typename R::Id> bound;
  bool removed;
};

// One copy of u. Preconditions: u is a knot inside of the domain; `knots` are those of the curve as one value.
template <class R, class Parameter, class Number>
Removal<R> remove_knot(R& rec, MadeCurve<R> curve, Traced<std::vector<typename R::Number>, typename R::Id> knots,
                       const Parameter& u, const Number& tolerance, const Number& rounding) {
  using S = typename R::Number;
  using Id = typename R::Id;
  using Made = Traced<HPoint<S>, Id>;
  const int p = curve.degree;
  const auto& U = curve.U;
  const auto& P = curve.P;
  const auto given = [&](int i) { return Made{P[i].value, P[i].id}; };
  const auto r = rec.apply(LastKnot{}, "r"_v, u, knots);
  const auto s = rec.apply(Multiplicity{}, "s"_v, u, knots);
  const int first = r.value - p, last = r.value - s.value;
  const int half = (last - first + 1) / 2;

  const auto alpha = [&](int i) { return rec.apply(Ratio{}, "alpha"_v(i), u, U[i], U[i + p + 1]); };
  Cells<HPoint<S>, Id> left, right;  // from either end, the given point first
  left.push_back(given(first - 1));
  right.push_back(given(last + 1));
  for (int n = 0; n < half; ++n) {
    const int i = first + n, j = last - n;
    left.push_back(rec.apply(UnblendEnd{}, "L"_v(i), alpha(i), P[i], left[n]));
    right.push_back(rec.apply(UnblendBegin{}, "R"_v(j - 1), alpha(j), P[j], right[n]));
  }
  const bool meet = (last - first + 1) % 2 == 0;  // both sides know the point in the middle
  Traced<S, Id> bound{};
  if (meet) {
    bound = rec.apply(Gap{}, "b"_v, left[half], right[half]);
  } else {
    const int i = first + half;
    const auto middle = rec.apply(MiddleOf{}, "M"_v, alpha(i), left[half], right[half]);
    bound = rec.apply(Gap{}, "b"_v, P[i], middle);
  }
  const bool removed = rec.apply(Within{}, "ok"_v, bound, tolerance, rounding).value == 1;
  if (!removed) return {std::move(curve), std::move(knots), std::move(bound), false};

  MadeCurve<R> made;
  made.degree = p;
  made.dimension = curve.dimension;
  made.rational = curve.rational;
  made.P.append(P, 0, first - 1);
  for (int n = 0; n < (meet ? half : half + 1); ++n) made.P.push_back(left[n]);
  for (int n = half; n >= 0; --n) made.P.push_back(right[n]);
  made.P.append(P, last + 2, P.size() - last - 2);
  if constexpr (R::recording)
    for (int i = first; i <= last; ++i) rec.retire(P[i].id);
  auto shorter = rec.apply(RemoveKnot{}, "Ubar"_v, u, knots);
  made.U.append(U, 0, r.value);
  made.U.append(U, r.value + 1, U.size() - r.value - 1);
  return {std::move(made), std::move(shorter), std::move(bound), true};
}

// The whole algorithm: up to `times` copies, as long as each of them changes the curve by at most the tolerance.
template <class R>
Curve<typename R::Number> knot_removal(const Curve<typename R::Number>& curve, const typename R::Number& parameter,
                                       int times, const typename R::Number& tolerance, R& rec) {
  using S = typename R::Number;
  using Id = typename R::Id;
  const auto u = rec.input("u"_v, parameter);
  const auto tol = rec.input("tol"_v, tolerance);
  const auto rounding = rec.input("eps"_v, rounding_of(std::span<const HPoint<S>>(curve.points)));
  const auto list = rec.list("U"_v, curve.knots);
  const auto given = given_curve(rec, curve);

  Removal<R> now;
  now.curve.degree = curve.degree;
  now.curve.dimension = curve.dimension;
  now.curve.rational = curve.rational;
  now.curve.U.append(given.U, 0, given.U.size());
  now.curve.P.append(given.P, 0, given.P.size());
  now.knots = {curve.knots, list.id};
  Cells<S, Id> bounds;
  for (int t = 1; t <= times; ++t) {
    auto phase = rec.phase({"removal", t, true});
    now = remove_knot(rec, std::move(now.curve), std::move(now.knots), u, tol, rounding);
    if (!now.removed) break;
    bounds.push_back(now.bound);
  }
  {
    auto phase = rec.phase({"collect"});
    rec.input("h"_v, bounds.size());
    if (bounds.size() > 0)
      rec.apply(Total{}, "E"_v, slice(bounds, 0, bounds.size()));
    else
      rec.input("E"_v, S(0));
    if constexpr (R::recording) {
      auto step = rec.one_step();
      for (int i = 0; i < now.curve.P.size(); ++i) {
        const auto Q = rec.apply(Relabel{}, "Q"_v(i), now.curve.P[i]);
        rec.polar_net(
            Q.id, now.curve.U.values().subspan(static_cast<std::size_t>(i) + 1, static_cast<std::size_t>(curve.degree)),
            {});
      }
    }
  }
  const int count = bounds.size() > 0 ? now.curve.P.size() : 0;
  return plain_curve<R>(std::move(now.curve), 0, count);
}

}  // namespace blossom
